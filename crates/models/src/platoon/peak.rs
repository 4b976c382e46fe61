//! The peak of any linear system over all frequencies, with proof that no frequency is worse; of a car of any platoon in particular.
//!
//! The response to a leader `e^{iwt}` is `N(iw)/D(iw)` with integer polynomials ([`StateSpace::transfer`]). With `x = w²` and the parts of even
//! and odd degree, `|N(iw)|² = E(x)² + x O(x)²`, an integer polynomial in `x`, and so for `D`. The system is stable if and only if `D` is
//! Hurwitz; then the squared response is a quotient with a positive denominator, whose largest value for `x >= 0` is enclosed by
//! [`largest_quotient`] (`notes/resonance.md`).

use super::cars::Platoon;
use super::communication_graph::{CommunicationError, CommunicationGraph};
use super::law::Gains;
use super::state_space::{StateSpace, StateSpaceError};
use algebra::matrix::MatrixError;
use algebra::spectrum::{Largest, LargestError, Place, Polynomial, largest_quotient};
use arithmetic::{ArithmeticError, Cancelled, Dyadic, Interval, Number, Progress, Rational};
use num_bigint::BigInt;

/// Most followers of a platoon of which the peak is meant to be proved; the cost grows like the fourth power of their number.
pub const MOST_FOLLOWERS_PROVED: usize = 100;

/// Most states of a linear system of which the peak is meant to be proved.
pub const MOST_STATES_PROVED: usize = 200;

/// The largest response over the frequencies `w >= 0`, which is its supremum over `w > 0`.
#[derive(Debug, Clone)]
pub struct Peak {
    /// Encloses an angular frequency that has it, rad/s. Where several are too close in height to be told apart, all of them; nothing
    /// where it is approached at infinity only.
    pub omega: Option<Interval>,
    /// Its height.
    pub amplitude: Interval,
}

/// Why there is no peak.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PeakError {
    /// Some motion without input does not die out.
    #[error("the system is not stable, so that it has no peak")]
    NotStable,
    /// The response to high frequencies.
    #[error("the response grows without bound at high frequencies")]
    Unbounded,
    /// Of the platoon.
    #[error(transparent)]
    Platoon(#[from] CommunicationError),
    /// Of the system.
    #[error(transparent)]
    System(#[from] StateSpaceError),
    /// Of its matrix.
    #[error(transparent)]
    Matrix(#[from] MatrixError),
    /// Of the search.
    #[error("the peak is not enclosed: {0}")]
    Search(LargestError),
    /// Of the enclosures.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
    /// Stopped by the caller.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// The peak of follower `car >= 1` of a platoon whose follower `k` has the gains `gains[k - 1]`.
///
/// # Errors
/// [`PeakError`].
pub fn peak_on_graph(
    graph: &CommunicationGraph,
    gains: &[Gains<Rational>],
    car: usize,
    digits: u32,
    progress: &dyn Progress,
) -> Result<Peak, PeakError> {
    peak_of_platoon(&Platoon::new(graph.clone(), gains.to_vec())?, car, digits, progress)
}

/// The peak of follower `car >= 1` of a platoon.
///
/// # Errors
/// [`PeakError`].
pub fn peak_of_platoon(
    platoon: &Platoon<Rational>,
    car: usize,
    digits: u32,
    progress: &dyn Progress,
) -> Result<Peak, PeakError> {
    peak_of_system(&StateSpace::of_platoon(platoon, car)?, digits, progress)
}

/// The peak of a linear system, to about so many significant digits. Cost: for `n` states of a platoon some `n³` products of numbers of a few
/// bits for each state.
///
/// # Errors
/// [`PeakError`].
pub fn peak_of_system(system: &StateSpace, digits: u32, progress: &dyn Progress) -> Result<Peak, PeakError> {
    let transfer = system.transfer(progress).map_err(|error| match error {
        MatrixError::Cancelled(cancelled) => cancelled.into(),
        other => PeakError::Matrix(other),
    })?;
    if !Polynomial::new(transfer.denominator.clone()).is_hurwitz_watched(progress)? {
        return Err(PeakError::NotStable);
    }
    let (p, q) = (squared_modulus(&transfer.numerator), squared_modulus(&transfer.denominator));
    let found = largest_quotient(&p, &q, digits, progress).map_err(|error| match error {
        LargestError::Unbounded => PeakError::Unbounded,
        LargestError::Cancelled(cancelled) => cancelled.into(),
        other => PeakError::Search(other),
    })?;
    let Largest { places, value } = found;
    let mut omega: Option<Interval> = None;
    for place in places {
        let Place::At(x) = place else { continue };
        let w = x.sqrt()?;
        omega = Some(omega.map_or_else(|| w.clone(), |other| other.hull(&w)));
    }
    Ok(Peak { omega, amplitude: not_negative(&value).sqrt()? })
}

/// What an enclosure has of the numbers from 0 on.
fn not_negative(x: &Interval) -> Interval {
    Interval::between(x.lo().clone().max(Dyadic::zero()), x.hi().clone(), x.precision())
}

/// `|f(iw)|²` as a polynomial in `x = w²`, both with the constant coefficient first.
fn squared_modulus(f: &[BigInt]) -> Vec<BigInt> {
    let mut square = vec![BigInt::ZERO; f.len()];
    // The product f(s) f(-s) with s² = -x.
    for (i, a) in f.iter().enumerate() {
        for (j, b) in f.iter().enumerate().filter(|(j, _)| (i + j) % 2 == 0) {
            let term = a * b;
            // (-1)^j s^(i + j), s^(i + j) = (-1)^((i + j)/2) x^((i + j)/2).
            if (j + (i + j) / 2) % 2 == 0 { square[(i + j) / 2] += term } else { square[(i + j) / 2] -= term }
        }
    }
    square
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::{Complex, rational};

    #[test]
    fn squared_moduli_are_those_of_complex_numbers() {
        for list in [vec![3i64], vec![2, -5], vec![1, 2, 3], vec![-4, 0, 7, 1], vec![1, 1, -6, 2, 9]] {
            let found = squared_modulus(&list.iter().map(|c| BigInt::from(*c)).collect::<Vec<_>>());
            for w in 0..7i64 {
                let turn = Complex::new(rational(0, 1), rational(w, 1));
                let value = list
                    .iter()
                    .rev()
                    .fold(Complex::real(rational(0, 1)), |sum, c| sum * turn.clone() + Complex::real(rational(*c, 1)));
                let known = found.iter().rev().fold(BigInt::ZERO, |sum, c| sum * (w * w) + c);
                assert_eq!(value.norm_squared(), Rational::from_integer(known), "{list:?} {w}");
            }
        }
    }
}
