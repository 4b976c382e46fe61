//! What a flock of model K starts from, and what is refused as a start.

use super::hysteresis::Hysteresis;
use super::weights::FlockError;
use arithmetic::{Complex, Interval, Rational, Real, Sign, Signed};

/// What a flock of model K starts from.
#[derive(Debug, Clone, PartialEq)]
pub struct KinematicStart {
    /// `sigma`, the common speed.
    pub speed: Rational,
    /// `x(0)`.
    pub positions: Vec<Complex<Rational>>,
    /// `theta(1)` in radians, in `[0, 2 pi)`.
    pub headings: Vec<Rational>,
    /// The hysteresis rule.
    pub hysteresis: Hysteresis,
}

/// Bits with which a heading is compared with `2 pi` at first.
const FIRST_BITS: u32 = 128;

impl KinematicStart {
    /// Whether a flock of model K can start here.
    ///
    /// # Errors
    /// [`FlockError`] with what is at fault.
    pub(super) fn check(&self) -> Result<(), FlockError> {
        let birds = self.positions.len();
        if birds == 0 {
            return Err(FlockError::NoBirds);
        }
        if !self.speed.is_certainly_positive() {
            return Err(FlockError::Speed(self.speed.to_string()));
        }
        if self.headings.len() != birds {
            return Err(FlockError::Headings { birds, found: self.headings.len() });
        }
        match self.headings.iter().position(|heading| !is_heading(heading)) {
            Some(i) => Err(FlockError::Heading { bird: i + 1, heading: self.headings[i].to_string() }),
            None => Ok(()),
        }
    }
}

/// Whether `0 <= heading < 2 pi`; that is irrational, so some precision decides.
fn is_heading(heading: &Rational) -> bool {
    let mut precision = FIRST_BITS;
    while !heading.is_certainly_negative() {
        let heading = Interval::from_rational(heading, precision);
        match (heading.pi().scaled(1) - heading).sign() {
            Some(sign) => return sign == Sign::Positive,
            None => precision *= 2,
        }
    }
    false
}
