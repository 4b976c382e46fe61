//! `peak`: the main resonance of a two-sided platoon.

use super::{CertificateError, at_most};
use crate::arithmetic::{Rational, decimal, parse_rational, rational};
use crate::platoon::{Gains, ResonanceError, resonance};

/// Rationals around the frequency of the main resonance and around its amplitude (Veerman and others, section 4).
#[derive(Debug, Clone)]
pub struct Peak {
    followers: u64,
    gains: Gains<Rational>,
    /// Between these the amplitude is largest.
    frequency: (Rational, Rational),
    /// Where the lower amplitude is reached.
    at: Rational,
    amplitude: (Rational, Rational),
}

/// Digits of the enclosure that everything is rounded from.
const DIGITS: u32 = 34;
/// Digits of the ends of the range of frequencies, and by which share they lie off the peak.
const FREQUENCY_DIGITS: u32 = 13;
/// A frequency `10^-11` off costs about `10^-22` of the amplitude: more than what is lost by rounding it to these digits, which
/// is what tells the frequencies outside the range from the peak.
const AMPLITUDE_DIGITS: u32 = 28;

impl Peak {
    /// Of a platoon of this many followers with negative gains.
    ///
    /// # Errors
    /// [`CertificateError`]: too many followers, gains without resonance.
    pub fn new(gains: &Gains<Rational>, followers: u64) -> Result<Self, CertificateError> {
        at_most("followers", 96, followers as usize)?;
        let found = resonance(gains, followers, DIGITS)?;
        let (omega, amplitude) = (found.omega.to_rationals(), found.amplitude.to_rationals());
        let share = |digits: i32| rational(10, 1).pow(-digits);
        let off = |x: &Rational, up: bool, digits: i32| match up {
            true => x + x * share(digits),
            false => x - x * share(digits),
        };
        let rounded = |x: &Rational, digits: u32, up: bool| {
            parse_rational(&decimal(x, digits, up)).map_err(|_| ResonanceError::Extreme)
        };
        Ok(Peak {
            followers,
            gains: gains.clone(),
            frequency: (
                rounded(&off(&omega.0, false, 11), FREQUENCY_DIGITS, false)?,
                rounded(&off(&omega.1, true, 11), FREQUENCY_DIGITS, true)?,
            ),
            at: rounded(&omega.0, AMPLITUDE_DIGITS, false)?,
            amplitude: (
                rounded(&off(&amplitude.0, false, 27), AMPLITUDE_DIGITS, false)?,
                rounded(&amplitude.1, AMPLITUDE_DIGITS, true)?,
            ),
        })
    }

    pub(super) fn claim(&self) -> String {
        format!(
            "of all frequencies w > 0 the last of the {} followers of the two-sided platoon with f = {} and g = {} has its \
             largest amplitude only between w = {} and w = {}, and that amplitude lies between {} and {}",
            self.followers,
            self.gains.f,
            self.gains.g,
            self.frequency.0,
            self.frequency.1,
            self.amplitude.0,
            self.amplitude.1
        )
    }

    pub(super) fn body(&self) -> String {
        format!(
            "followers {}\nf {}\ng {}\nfrequency {} {}\nat {}\namplitude {} {}\n",
            self.followers,
            self.gains.f,
            self.gains.g,
            self.frequency.0,
            self.frequency.1,
            self.at,
            self.amplitude.0,
            self.amplitude.1
        )
    }
}
