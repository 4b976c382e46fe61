//! The peak of the last car over all frequencies for any communication graph, certified by the critical points of a rational function.
//!
//! With `s = w²/|f|`, `b = g²/|f|` and `beta = sqrt(b s)` the amplitude of the last car is `N(lambda)/chi(lambda)` at
//! `lambda = s/(1 + i beta)`, where `chi` is the characteristic polynomial of the reduced Laplacian `P` and `N` has the entry of
//! `-adj(lambda - P) b` for the column `b` of the leader (Faddeev and LeVerrier). Multiplied by `(1 + i beta)^M` both are
//! `A(s) + i beta B(s)` with rational polynomials, so that the squared amplitude is a quotient `p/q` of polynomials in `s`. Its
//! largest value for `s >= 0` is taken at 0 or at a root of `p' q - p q'`, since it tends to 0 at infinity.

use super::{CommunicationGraph, Gains};
use algebra::matrix::MatrixError;
use algebra::spectrum::Polynomial;
use arithmetic::{ArithmeticError, Field, Interval, Rational, Real, Ring, Signed, rational};

/// A polynomial, the constant coefficient first.
type Coefficients = Vec<Rational>;

/// The highest response of the last car.
#[derive(Debug, Clone)]
pub struct GraphPeak {
    /// The angular frequencies that may have it, rad/s.
    pub omega: Interval,
    /// Its height.
    pub amplitude: Interval,
}

/// Why there is no peak.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GraphPeakError {
    /// A gain is not negative.
    #[error("both gains must be negative")]
    Gains,
    /// Of the graph.
    #[error(transparent)]
    Matrix(#[from] MatrixError),
    /// Of the enclosures.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
}

/// Encloses the peak of the last car of a stable platoon to about so many bits; the stability is not checked.
///
/// # Errors
/// [`GraphPeakError`].
pub fn peak_on_graph(
    graph: &CommunicationGraph,
    gains: &Gains<Rational>,
    precision: u32,
) -> Result<GraphPeak, GraphPeakError> {
    if !(gains.f.is_certainly_negative() && gains.g.is_certainly_negative()) {
        return Err(GraphPeakError::Gains);
    }
    let damping = &gains.g * &gains.g / -gains.f.clone();
    let (p, q) = squared_amplitude(graph, &damping)?;
    let slope = difference(&product(&derivative(&p), &q), &product(&p, &derivative(&q)));
    // A quotient of large polynomials loses digits.
    let bits = 2 * (precision + 32);
    let number = |x: &Rational| Interval::from_rational(x, bits);
    let at = |s: &Interval| -> Result<Interval, ArithmeticError> {
        let value = |list: &Coefficients| list.iter().rev().fold(s.zero(), |sum, c| sum * s + number(c));
        // The quotient is not negative.
        value(&p).over(&value(&q))?.absolute_root()
    };
    let mut candidates = vec![(number(&rational(0, 1)), at(&number(&rational(0, 1)))?)];
    for (factor, _) in Polynomial::from_rationals(&slope).square_free_factors() {
        for mut root in factor.roots_in(&rational(0, 1), &bound(&factor)) {
            factor.refine(&mut root, bits);
            let place = root.enclosure(bits);
            candidates.push((place.clone(), at(&place)?));
        }
    }
    highest(candidates, &-gains.f.clone(), bits)
}

/// The hull of all places that may have the largest value, and the largest value.
fn highest(
    candidates: Vec<(Interval, Interval)>,
    stiffness: &Rational,
    bits: u32,
) -> Result<GraphPeak, GraphPeakError> {
    let mut best: Option<(Interval, Interval)> = None;
    let least = candidates.iter().map(|(_, value)| value.lo()).max().cloned();
    for (place, value) in candidates {
        if least.as_ref().is_some_and(|least| value.hi() < least) {
            continue;
        }
        best = Some(match best {
            None => (place, value),
            Some((places, most)) => {
                let lo = most.lo().max(value.lo()).clone();
                let hi = most.hi().max(value.hi()).clone();
                (places.hull(&place), Interval::between(lo, hi, bits))
            }
        });
    }
    let (place, amplitude) = best.ok_or(ArithmeticError::Domain("at least one follower"))?;
    let omega = (place * Interval::from_rational(stiffness, bits)).absolute_root()?;
    Ok(GraphPeak { omega, amplitude })
}

/// `p` and `q`.
fn squared_amplitude(
    graph: &CommunicationGraph,
    damping: &Rational,
) -> Result<(Coefficients, Coefficients), MatrixError> {
    let reduced = graph.reduced_laplacian()?;
    let rows = reduced.to_rows();
    let characteristic = reduced.characteristic_polynomial()?.coefficients();
    let size = rows.len();
    // v_(M-1) = b, v_(i-1) = P v_i + c_i b, of which the last entries count.
    let column = graph.leader_column()?;
    let mut numerator = vec![rational(0, 1); size];
    let mut v = column.clone();
    for i in (0..size).rev() {
        numerator[i] = v[size - 1].clone();
        let apply = |row: &Vec<Rational>| row.iter().zip(&v).map(|(a, x)| a * x).sum::<Rational>();
        v = rows.iter().zip(&column).map(|(row, b)| apply(row) + &characteristic[i] * b).collect();
    }
    Ok((squared_norm(&numerator, size, damping), squared_norm(&characteristic, size, damping)))
}

/// `|sum_i c_i s^i (1 + i beta)^(M - i)|²` as a polynomial in `s`, with `beta² = b s`.
fn squared_norm(coefficients: &[Rational], size: usize, damping: &Rational) -> Coefficients {
    let (mut even, mut odd) = (vec![rational(0, 1); size + 1], vec![rational(0, 1); size + 1]);
    for (i, c) in coefficients.iter().enumerate() {
        // (1 + i beta)^n: its real part has (-b s)^(k/2) for even k, its imaginary part beta (-b s)^((k-1)/2) for odd k.
        let (n, mut binomial) = (size - i, rational(1, 1));
        for k in 0..=n {
            let term = c * &binomial * (-damping).pow((k / 2) as i32);
            let list = if k % 2 == 0 { &mut even } else { &mut odd };
            list[i + k / 2] += term;
            binomial *= rational((n - k) as i64, (k + 1) as i64);
        }
    }
    let mut sum = product(&even, &even);
    let odd: Coefficients = product(&odd, &odd).into_iter().map(|c| c * damping).collect();
    sum.resize(sum.len().max(odd.len() + 1), rational(0, 1));
    odd.into_iter().enumerate().for_each(|(k, c)| sum[k + 1] += c);
    sum
}

fn product(a: &[Rational], b: &[Rational]) -> Coefficients {
    let mut all = vec![rational(0, 1); (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            all[i + j] += x * y;
        }
    }
    all
}

fn derivative(a: &[Rational]) -> Coefficients {
    a.iter().enumerate().skip(1).map(|(k, c)| c * rational(k as i64, 1)).collect()
}

fn difference(a: &[Rational], b: &[Rational]) -> Coefficients {
    let entry = |list: &[Rational], k: usize| list.get(k).cloned().unwrap_or_else(|| rational(0, 1));
    (0..a.len().max(b.len())).map(|k| entry(a, k) - entry(b, k)).collect()
}

/// A bound of the roots (Cauchy).
fn bound(polynomial: &Polynomial) -> Rational {
    let coefficients = polynomial.coefficients();
    let Some(lead) = coefficients.last() else { return rational(1, 1) };
    let size = |c: &num_bigint::BigInt| Rational::from_integer(c.magnitude().clone().into());
    let most = coefficients.iter().map(size).max().unwrap_or_else(|| rational(1, 1));
    most / size(lead) + rational(1, 1)
}

/// Roots of numbers that are not negative, though their enclosures may be.
trait AbsoluteRoot: Sized {
    fn absolute_root(&self) -> Result<Self, ArithmeticError>;
}

impl AbsoluteRoot for Interval {
    fn absolute_root(&self) -> Result<Interval, ArithmeticError> {
        let zero = self.zero();
        let lo = if self.lo() < zero.lo() { zero.lo() } else { self.lo() };
        Interval::between(lo.clone(), self.hi().clone(), self.precision()).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(numbers: &[i64]) -> Coefficients {
        numbers.iter().map(|&n| rational(n, 1)).collect()
    }

    #[test]
    fn polynomials_are_multiplied_derived_and_subtracted() {
        // (1 + 2s + 3s²)(4 - s) = 4 + 7s + 10s² - 3s³.
        assert_eq!(product(&list(&[1, 2, 3]), &list(&[4, -1])), list(&[4, 7, 10, -3]));
        assert_eq!(derivative(&list(&[4, 7, 10, -3])), list(&[7, 20, -9]));
        assert!(derivative(&list(&[4])).is_empty() && product(&[], &[]).is_empty());
        assert_eq!(difference(&list(&[1, 2, 3]), &list(&[5])), list(&[-4, 2, 3]));
        assert_eq!(difference(&list(&[5]), &list(&[1, 2, 3])), list(&[4, -2, -3]));
    }

    /// `|sum c_i s^i (1 + i beta)^(M - i)|²` with `beta² = b s`, by complex numbers at several `s` for which `beta` is rational.
    #[test]
    fn the_squared_norm_is_that_of_complex_numbers() {
        use arithmetic::Complex;
        for (coefficients, size) in [(vec![2, -3, 1], 2usize), (vec![5, 1], 3), (vec![1, 0, -4, 7], 3)] {
            let found = squared_norm(&list(&coefficients), size, &rational(9, 4));
            for n in 0..12i64 {
                // beta = 3n/2 at s = n².
                let (s, beta) = (rational(n * n, 1), rational(3 * n, 2));
                let z = Complex::new(rational(1, 1), beta);
                let term =
                    |(i, c): (usize, &i64)| z.power((size - i) as u64).scale(&(rational(*c, 1) * s.pow(i as i32)));
                let total = coefficients.iter().enumerate().map(term).fold(Complex::real(rational(0, 1)), |a, b| a + b);
                let value = found.iter().rev().fold(rational(0, 1), |sum, c| sum * &s + c);
                assert_eq!(value, total.norm_squared());
            }
        }
    }

    /// `1 + max |c|/|lead|`, the bound of Cauchy.
    #[test]
    fn roots_are_looked_for_up_to_the_bound_of_cauchy() {
        for (coefficients, known) in
            [(vec![-6, 1], rational(7, 1)), (vec![1, -8, 2], rational(5, 1)), (vec![3, 2, -4], rational(2, 1))]
        {
            let polynomial = Polynomial::from_rationals(&list(&coefficients));
            assert_eq!(bound(&polynomial), known, "{coefficients:?}");
        }
    }

    #[test]
    fn the_highest_candidates_are_kept_together() {
        let number = |lo: i64, hi: i64| Interval::hull_of_rationals(&rational(lo, 1), &rational(hi, 1), 60);
        type Rationals = ((i64, i64), (i64, i64));
        let found = |list: &[Rationals]| {
            let candidates = list.iter().map(|(p, v)| (number(p.0, p.1), number(v.0, v.1))).collect();
            let peak = highest(candidates, &rational(4, 1), 60).expect("a candidate");
            (peak.omega.to_rationals(), peak.amplitude.to_rationals())
        };
        let pair = |lo: i64, hi: i64| (rational(lo, 1), rational(hi, 1));
        // Frequencies are the roots of four times the places.
        assert_eq!(found(&[((1, 1), (3, 4)), ((4, 9), (6, 7)), ((16, 16), (1, 5))]), (pair(4, 6), pair(6, 7)));
        // Two that may be the highest, and one whose upper end is just the lower end of the best.
        assert_eq!(found(&[((1, 4), (3, 8)), ((9, 16), (5, 6))]), (pair(2, 8), pair(5, 8)));
        assert_eq!(found(&[((9, 16), (5, 6)), ((1, 4), (3, 8))]), (pair(2, 8), pair(5, 8)));
        assert_eq!(found(&[((9, 16), (5, 6)), ((1, 1), (2, 5))]), (pair(2, 8), pair(5, 6)));
        assert!(highest(vec![], &rational(1, 1), 60).is_err());
    }

    /// What is below zero by its enclosure only counts as zero there.
    #[test]
    fn roots_of_enclosures_that_reach_below_zero() {
        let root = |lo: i64, hi: i64| {
            let x = Interval::hull_of_rationals(&rational(lo, 1), &rational(hi, 1), 60);
            x.absolute_root().expect("a root").to_rationals()
        };
        assert_eq!(root(4, 9), (rational(2, 1), rational(3, 1)));
        assert_eq!(root(-5, 9), (rational(0, 1), rational(3, 1)));
        assert_eq!(root(0, 16), (rational(0, 1), rational(4, 1)));
    }
}
