//! The hysteresis rule: whether an edge stays although its ends are more than distance 1 apart.

use super::weights::FlockError;
use arithmetic::{Interval, Rational, Ring, Sign, sign_of_square_root_difference};
use num_bigint::BigInt;
use num_traits::{Pow, Signed, Zero};
use std::sync::OnceLock;

/// Below which change of distance an existing edge stays.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Hysteresis {
    /// No hysteresis: the distance rule alone.
    None,
    /// A threshold, not negative.
    Constant(Rational),
    /// The threshold `n^(-n^4)` of the paper (Chazelle, section 1), `n` the number of birds.
    Paper,
}

impl Hysteresis {
    /// The threshold for a number of birds; `None` without hysteresis.
    ///
    /// # Errors
    /// [`FlockError::ThresholdTooLong`] for the threshold of the paper where it has more bits than this.
    pub fn exact(&self, birds: usize, most_bits: u64) -> Result<Option<Rational>, FlockError> {
        Ok(match self {
            Hysteresis::None => None,
            Hysteresis::Constant(threshold) => Some(threshold.clone()),
            Hysteresis::Paper => {
                let bits = paper_bits(birds);
                if bits > most_bits as f64 {
                    return Err(FlockError::ThresholdTooLong { bits });
                }
                let exponent = (birds as u64).pow(4);
                Some(Rational::new(BigInt::from(1), BigInt::from(birds).pow(exponent)))
            }
        })
    }

    /// An integer that is at most the binary logarithm of the threshold for a number of birds; `None` where that is zero or there is none, and
    /// for so many birds that no integer of 64 bits is so small.
    pub fn log2_below(&self, birds: usize) -> Option<i64> {
        let log2 = self.log2(birds);
        (log2 >= -MOST_BITS).then(|| (log2 * (1.0 + 1e-12)) as i64 - 3)
    }

    /// About the binary logarithm of the threshold: within a part in 10^15 and 1.
    fn log2(&self, birds: usize) -> f64 {
        match self {
            Hysteresis::Constant(threshold) if !threshold.is_zero() => {
                let bits = |x: &BigInt| x.bits() as f64;
                bits(&threshold.numer()) - bits(&threshold.denom())
            }
            Hysteresis::Paper => -paper_bits(birds),
            Hysteresis::None | Hysteresis::Constant(_) => f64::NEG_INFINITY,
        }
    }
}

/// `n^4 log2 n`.
fn paper_bits(birds: usize) -> f64 {
    (birds as f64).powi(4) * (birds as f64).log2()
}

/// Thresholds below `2^-MOST_BITS` are left to no comparison: their exponents do not fit.
const MOST_BITS: f64 = (1u64 << 61) as f64;

/// Exact thresholds of more bits than this are not written out.
const LONGEST: u64 = 4_000_000_000;

/// The threshold for a number of birds, written out only when a comparison needs it.
#[derive(Debug, Clone)]
pub(super) struct Threshold {
    kind: Hysteresis,
    birds: usize,
    log2: f64,
    exact: OnceLock<Rational>,
}

impl Threshold {
    pub fn new(kind: Hysteresis, birds: usize) -> Result<Self, FlockError> {
        match &kind {
            Hysteresis::Constant(threshold) if threshold.is_negative() => {
                Err(FlockError::NegativeHysteresis(threshold.to_string()))
            }
            Hysteresis::Paper if paper_bits(birds) > MOST_BITS => Err(FlockError::ThresholdTooSmall { birds }),
            _ => Ok(Threshold { log2: kind.log2(birds), kind, birds, exact: OnceLock::new() }),
        }
    }

    pub fn kind(&self) -> &Hysteresis {
        &self.kind
    }

    /// Whether no edge is ever held: without hysteresis, and below the threshold 0.
    pub fn holds_nothing(&self) -> bool {
        self.log2 == f64::NEG_INFINITY
    }

    /// As [`Hysteresis::log2_below`].
    pub fn log2_below(&self) -> Option<i64> {
        self.kind.log2_below(self.birds)
    }

    /// The threshold itself.
    pub fn exact(&self) -> Result<&Rational, FlockError> {
        if let Some(known) = self.exact.get() {
            return Ok(known);
        }
        let exact = self.kind.exact(self.birds, LONGEST)?;
        Ok(self.exact.get_or_init(|| exact.unwrap_or_else(|| Rational::from_integer(BigInt::ZERO))))
    }

    /// Encloses the threshold; zero where there is no hysteresis.
    pub fn enclosure(&self, precision: u32) -> Interval {
        let constant = |c: &Rational| Interval::from_rational(c, precision);
        match &self.kind {
            Hysteresis::None => constant(&Rational::from_integer(BigInt::ZERO)),
            Hysteresis::Constant(threshold) => constant(threshold),
            Hysteresis::Paper => {
                let share = Rational::new(BigInt::from(1), BigInt::from(self.birds));
                constant(&share).power((self.birds as u64).pow(4))
            }
        }
    }

    /// Whether `| |now| - |before| | < threshold * unit` for two difference vectors over the same unit, where
    /// `now = before + moved`.
    pub fn holds(&self, now: &[BigInt], moved: &[BigInt], unit: &BigInt) -> Result<bool, FlockError> {
        if self.holds_nothing() {
            return Ok(false);
        }
        // Two bits of slack cover the rounding of the logarithms.
        let slack = 2.0 + 1e-12 * self.log2.abs();
        let limit = self.log2 + unit.bits() as f64;
        let squared = |x: &[BigInt]| -> BigInt { x.iter().map(Ring::square).sum() };
        // The change is at most |moved| (Lemma 2.1).
        if (squared(moved).bits() as f64) / 2.0 < limit - slack {
            return Ok(true);
        }
        let before: Vec<BigInt> = now.iter().zip(moved).map(|(x, v)| x - v).collect();
        let (a, b) = (squared(now), squared(&before));
        if a == b {
            return Ok(true);
        }
        // The change is |a - b|/(sqrt a + sqrt b).
        let longest = a.bits().max(b.bits()) as f64;
        if (&a - &b).bits() as f64 - 2.0 - longest / 2.0 > limit + slack {
            return Ok(false);
        }
        let threshold = self.exact()?;
        // sqrt(a q²) - sqrt(b q²) against p unit, for the threshold p/q.
        let (a, b) = (a * threshold.denom().square(), b * threshold.denom().square());
        let (larger, smaller) = if a >= b { (a, b) } else { (b, a) };
        let limit = threshold.numer() * unit;
        Ok(sign_of_square_root_difference(&larger, &smaller, &limit) == Some(Sign::Negative))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The fourth power of 70 000 does not fit 64 bits; its logarithm would be that of another threshold.
    #[test]
    fn thresholds_that_no_number_holds_are_refused() {
        for birds in [21_000, 70_000, usize::MAX] {
            let refused = Threshold::new(Hysteresis::Paper, birds).err();
            assert_eq!(refused, Some(FlockError::ThresholdTooSmall { birds }));
        }
        let threshold = Threshold::new(Hysteresis::Paper, 18_000).expect("a threshold");
        assert!(threshold.log2_below().is_some_and(|log2| threshold.enclosure(64).lo().top() > log2));
        assert!(Threshold::new(Hysteresis::None, usize::MAX).is_ok());
    }
}
