//! The column of time: numbers, or dates of ISO 8601.

use jiff::Timestamp;
use jiff::civil::DateTime;
use jiff::tz::Offset;

/// How times are written in a table; the first row tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Clock {
    /// Seconds or frames.
    Numbers,
    /// Dates without an offset from UTC.
    Local,
    /// Dates with an offset, or with Z.
    Offset,
}

impl Clock {
    /// The way in which a field is written; what is no date is to be a number.
    pub(super) fn of(field: &str) -> Clock {
        [Clock::Offset, Clock::Local].into_iter().find(|clock| clock.date(field).is_some()).unwrap_or(Clock::Numbers)
    }

    /// An example of such a date.
    pub(super) fn example(self) -> &'static str {
        if self == Clock::Offset { "2024-05-01T12:00:00.04Z" } else { "2024-05-01T12:00:00.04" }
    }

    /// Nanoseconds since 1970 of a date that is written in this way; the local ones as if they were of UTC.
    pub(super) fn date(self, field: &str) -> Option<i128> {
        let stamp: Timestamp = match self {
            Clock::Numbers => return None,
            Clock::Offset => field.parse().ok()?,
            // A date with an offset would be read without it.
            Clock::Local if field.parse::<Timestamp>().is_ok() => return None,
            Clock::Local => Offset::UTC.to_timestamp(field.parse::<DateTime>().ok()?).ok()?,
        };
        Some(stamp.as_nanosecond())
    }

    /// A date in nanoseconds, written in this way.
    pub(super) fn text(self, date: i128) -> String {
        let text = Timestamp::from_nanosecond(date).map(|stamp| stamp.to_string()).unwrap_or_default();
        if self == Clock::Offset { text } else { text.trim_end_matches('Z').to_string() }
    }
}
