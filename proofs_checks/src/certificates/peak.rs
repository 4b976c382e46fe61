//! `peak`: the main resonance of a two-sided platoon.

use super::{CertificateError, at_most};
use arithmetic::{Rational, decimal, parse_rational, rational};
use models::platoon::{Gains, ResonanceError, resonance};

/// Rationals around the frequency of the main resonance and around its amplitude (Veerman and others, section 4).
#[derive(Debug, Clone)]
pub struct Peak {
    pub(super) followers: u64,
    pub(super) gains: Gains<Rational>,
    /// Between these the amplitude is largest.
    pub(super) frequency: (Rational, Rational),
    /// Where the lower amplitude is reached.
    pub(super) at: Rational,
    pub(super) amplitude: (Rational, Rational),
}

/// Digits of the enclosure that everything is rounded from.
const DIGITS: u32 = 34;

/// How coarsely the numbers are written. A frequency that is off by a share costs about its square of the amplitude, which must be
/// more than what rounding costs it: that tells the frequencies outside the range from the peak.
struct Coarseness {
    /// By the share `10^-n` the ends of the range of frequencies lie off the peak.
    frequency_share: i32,
    frequency_digits: u32,
    /// By the share `10^-n` the lower amplitude lies below the peak.
    amplitude_share: i32,
    amplitude_digits: u32,
}

const FOR_THE_CHECKER: Coarseness =
    Coarseness { frequency_share: 11, frequency_digits: 13, amplitude_share: 27, amplitude_digits: 28 };
/// The kernel multiplies bit by bit.
const FOR_COQ: Coarseness =
    Coarseness { frequency_share: 6, frequency_digits: 8, amplitude_share: 13, amplitude_digits: 14 };

impl Peak {
    /// Of a platoon of this many followers with negative gains.
    ///
    /// # Errors
    /// [`CertificateError`]: too many followers, gains without resonance.
    pub fn new(gains: &Gains<Rational>, followers: u64) -> Result<Self, CertificateError> {
        at_most("followers", 96, followers as usize)?;
        let found = resonance(gains, followers, DIGITS)?;
        let (frequency, amplitude) = (found.omega.to_rationals(), found.amplitude.to_rationals());
        let exact = Peak { followers, gains: gains.clone(), at: frequency.0.clone(), frequency, amplitude };
        exact.rounded(&FOR_THE_CHECKER)
    }

    /// The same peak in fewer digits, for Coq.
    pub(super) fn for_coq(&self) -> Result<Self, CertificateError> {
        self.rounded(&FOR_COQ)
    }

    /// A wider range of frequencies and of amplitudes around the same peak.
    fn rounded(&self, to: &Coarseness) -> Result<Self, CertificateError> {
        let share = |digits: i32| rational(10, 1).pow(-digits);
        let rounded = |x: &Rational, digits: u32, up: bool| {
            parse_rational(&decimal(x, digits, up)).map_err(|_| ResonanceError::Extreme)
        };
        let (low, high) = &self.frequency;
        let (least, most) = &self.amplitude;
        Ok(Peak {
            followers: self.followers,
            gains: self.gains.clone(),
            frequency: (
                rounded(&(low - low * share(to.frequency_share)), to.frequency_digits, false)?,
                rounded(&(high + high * share(to.frequency_share)), to.frequency_digits, true)?,
            ),
            at: rounded(&self.at, to.amplitude_digits, false)?,
            amplitude: (
                rounded(&(least - least * share(to.amplitude_share)), to.amplitude_digits, false)?,
                rounded(most, to.amplitude_digits, true)?,
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
