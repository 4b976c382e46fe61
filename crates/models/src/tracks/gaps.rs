//! Which fish is missing, from when to when.

use super::Tracks;

/// Frames in a row in which a fish has no position.
#[derive(Debug, Clone, PartialEq)]
pub struct Gap {
    /// Number of the fish in [`Tracks::ids`].
    pub fish: usize,
    /// Number of the first missing frame on the grid of times.
    pub first: u64,
    /// Time of the first missing frame.
    pub from: f64,
    /// Time of the last missing frame.
    pub to: f64,
    /// How many are missing.
    pub frames: u64,
    /// Whether the fish was not yet seen: it comes later.
    pub at_start: bool,
    /// Whether the fish is not seen again: it is gone.
    pub at_end: bool,
}

/// All gaps, by fish and time.
pub fn gaps(tracks: &Tracks) -> Vec<Gap> {
    let end = tracks.recorded_frames();
    let mut found = Vec::new();
    for (fish, places) in tracks.positions.iter().enumerate() {
        let mut next = 0;
        let seen = tracks.frames.iter().zip(places).filter(|(_, r)| r.is_some()).map(|(frame, _)| frame.number);
        for number in seen.chain([end]) {
            if number > next {
                found.push(Gap {
                    fish,
                    first: next,
                    from: tracks.time_of(next),
                    to: tracks.time_of(number - 1),
                    frames: number - next,
                    at_start: next == 0,
                    at_end: number == end,
                });
            }
            next = number.saturating_add(1);
        }
    }
    found
}
