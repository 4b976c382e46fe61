//! The gain margin of a platoon: by which common factors of all gains stability ends, decided exactly for small platoons and by enclosed modes for
//! larger ones with equal gains.
//!
//! With all gains multiplied by `k > 0` the characteristic polynomial is `D_k(s) = det(s² - k (F + s G) P) = sum_j k^j e_j(s) s^(2 (M - j))`, where
//! `e_j(s)` is the coefficient of `mu^(M - j)` in `det(mu - (F + s G) P)`. A stable platoon is stable for all factors between 1 and the nearest one for which `D_k` has a
//! root on the imaginary axis; there the parts of `D_k` of even and odd degree, as polynomials in `y = s²`, have a root in common, so that their resultant `R(k)` is zero.
//! Conversely, at the nearest positive zero of `R` the polynomial has roots `s` and `-s`, both not to the right of the axis: stability ends there. As
//! `k^(M²)` divides `R`, and its degree is at most `M (2 M - 1)`, `M (M - 1) + 1` values determine the rest.

use super::law::Gains;
use algebra::matrix::{MatrixError, RationalMatrix, SparseMatrix, transfer_function};
use algebra::spectrum::{Nearest, Polynomial, matrix_spectrum};
use arithmetic::{ArithmeticError, Field, Interval, Rational, Ring, Sign, Signed, common_denominator, rational};
use num_bigint::BigInt;

/// Most followers for which it is decided exactly.
pub const MOST_EXACT: usize = 12;

/// Most followers whose modes are enclosed.
pub const MOST_MODES: usize = 400;

/// Bits of the factors.
const BITS: u32 = 64;

/// By which factors all gains of a stable platoon may be multiplied.
#[derive(Debug, Clone)]
pub enum GainMargin {
    /// By all positive ones.
    Infinite,
    /// By those between two ends, at which stability ends; nothing where there is no such end between 0 and 1, or beyond 1.
    Ends {
        /// The end below 1.
        below: Option<Interval>,
        /// The end above 1.
        above: Option<Interval>,
    },
    /// It is not decided, for this reason.
    Open(String),
}

/// The gain margin of a **stable** platoon with the reduced Laplacian `P`, whose follower `k` has the negative gains `gains[k - 1]`.
///
/// # Errors
/// [`ArithmeticError::Domain`] where there are not as many gains as rows and columns of `reduced`.
pub fn gain_margin(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Result<GainMargin, ArithmeticError> {
    let followers = gains.len();
    if [reduced.rows(), reduced.cols()] != [followers; 2] {
        return Err(ArithmeticError::Domain("gains for each follower"));
    }
    let equal = gains.iter().all(|other| *other == gains[0]);
    Ok(if followers <= MOST_EXACT {
        exact(reduced, gains).unwrap_or_else(|error| GainMargin::Open(error.to_string()))
    } else if equal && followers <= MOST_MODES {
        by_modes(reduced, &gains[0]).unwrap_or_else(|| GainMargin::Open("whether all modes are real".to_string()))
    } else {
        let most = if equal { MOST_MODES } else { MOST_EXACT };
        GainMargin::Open(format!("more than {most} cars"))
    })
}

fn exact(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Result<GainMargin, MatrixError> {
    let resultant = Polynomial::from_rationals(&resultant(reduced, gains)?);
    let inverse = |x: &Interval| x.recip().ok();
    let (below, above) =
        (resultant.largest_root_below_one(BITS), resultant.with_inverse_roots().largest_root_below_one(BITS));
    let unclear = |x: &Interval| GainMargin::Open(format!("several ends near the factor {:.6}", x.to_f64()));
    Ok(match (below, above) {
        (Nearest::None, Nearest::None) => GainMargin::Infinite,
        (Nearest::Unclear(x), _) => unclear(&x),
        (_, Nearest::Unclear(x)) => inverse(&x).map_or_else(|| unclear(&x), |x| unclear(&x)),
        (below, above) => {
            let root = |nearest| if let Nearest::Root(x) = nearest { Some(x) } else { None };
            GainMargin::Ends { below: root(below), above: root(above).as_ref().and_then(inverse) }
        }
    })
}

/// `R(k)/k^(M²)` up to a factor, the constant coefficient first.
fn resultant(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Result<Vec<Rational>, MatrixError> {
    let size = gains.len();
    let table = minors(reduced, gains)?;
    let value = |k: i64| -> Result<Rational, MatrixError> {
        let power = |n: usize| Rational::from_integer(BigInt::from(k).pow(n as u32));
        let mut d = vec![rational(0, 1); 2 * size + 1];
        for (j, row) in table.iter().enumerate() {
            row.iter().enumerate().take(j + 1).for_each(|(l, c)| d[2 * (size - j) + l] += c * power(j));
        }
        let (even, odd): (Vec<_>, Vec<_>) =
            (d.iter().step_by(2).cloned().collect(), d.iter().skip(1).step_by(2).cloned().collect());
        Ok(sylvester(&even, &odd)?.determinant()? / power(size * size))
    };
    let values = (1..=(size * (size - 1) + 1) as i64).map(value).collect::<Result<Vec<_>, _>>()?;
    Ok(interpolated(&values, 1))
}

/// The coefficients of `e_0 .. e_M`, times a common factor, each from the constant one on.
fn minors(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Result<Vec<Vec<Rational>>, MatrixError> {
    let size = gains.len();
    let at = |s: i64| -> Result<Vec<Rational>, MatrixError> {
        let gain = |k: usize| &gains[k].f + &gains[k].g * rational(s, 1);
        let row = |k: usize| (0..size).map(|j| gain(k) * reduced.entry(k, j)).collect::<Vec<_>>();
        let rows: Vec<Vec<Rational>> = (0..size).map(row).collect();
        let zero = rational(0, 1);
        let found = transfer_function(&rows, &vec![vec![zero.clone()]; size], &vec![zero.clone(); size], &[zero])?;
        let all: Vec<Rational> = found.denominator.into_iter().map(Rational::from_integer).collect();
        // From e_0 = 1 on.
        Ok(all.iter().rev().map(|c| c / &all[size]).collect())
    };
    let values = (0..=size as i64).map(at).collect::<Result<Vec<_>, _>>()?;
    let table: Vec<Vec<Rational>> =
        (0..=size).map(|j| interpolated(&values.iter().map(|row| row[j].clone()).collect::<Vec<_>>(), 0)).collect();
    let scale = Rational::from_integer(common_denominator(table.iter().flatten()));
    Ok(table.iter().map(|row| row.iter().map(|c| c * &scale).collect()).collect())
}

/// The coefficients of the polynomial with these values at `first, first + 1, ..`, the constant one first (Newton).
fn interpolated(values: &[Rational], first: i64) -> Vec<Rational> {
    let mut differences = values.to_vec();
    for stage in 1..values.len() {
        for i in (stage..values.len()).rev() {
            differences[i] = (&differences[i] - &differences[i - 1]) / rational(stage as i64, 1);
        }
    }
    let mut all: Vec<Rational> = Vec::new();
    for (k, difference) in differences.iter().enumerate().rev() {
        // all (x - first - k) + difference.
        let node = rational(first + k as i64, 1);
        let mut next = vec![rational(0, 1); all.len() + 1];
        for (i, c) in all.iter().enumerate() {
            next[i + 1] += c;
            next[i] -= c * &node;
        }
        next[0] += difference;
        all = next;
    }
    all
}

/// Sylvester's matrix of two polynomials, the constant coefficients first, whose determinant is their resultant; the second one is no constant or
/// the first one is not.
fn sylvester(a: &[Rational], b: &[Rational]) -> Result<RationalMatrix, MatrixError> {
    let (m, n) = (a.len() - 1, b.len() - 1);
    let row = |list: &[Rational], shift: usize| {
        let mut row = vec![rational(0, 1); m + n];
        list.iter().enumerate().for_each(|(i, c)| row[shift + i] = c.clone());
        row
    };
    let rows: Vec<Vec<Rational>> = (0..n).map(|k| row(a, k)).chain((0..m).map(|k| row(b, k))).collect();
    RationalMatrix::from_rows(&rows)
}

/// A mode with the eigenvalue `p + iq`, `p > 0`, is stable if and only if `k g² p (p² + q²) > |f| q²`; `None` where the enclosures do not tell.
fn by_modes(reduced: &RationalMatrix, gains: &Gains<Rational>) -> Option<GainMargin> {
    let spectrum = matrix_spectrum(&SparseMatrix::from_dense(reduced).ok()?, None).ok()?;
    let mut end: Option<Interval> = None;
    for part in &spectrum.eigenvalues {
        if !part.re.is_certainly_positive() {
            return None;
        }
        match part.im.sign() {
            Some(Sign::Zero) => continue,
            None => return None,
            Some(_) => {}
        }
        let (p, q) = (part.re.square(), part.im.square());
        let below = part.re.clone() * (p + &q) * part.re.rational(&(&gains.g * &gains.g));
        let factor = (q * part.re.rational(&-gains.f.clone())).over(&below).ok()?;
        end = Some(match end {
            None => factor,
            Some(other) => {
                let ends = (other.lo().max(factor.lo()).clone(), other.hi().max(factor.hi()).clone());
                Interval::between(ends.0, ends.1, other.precision())
            }
        });
    }
    Some(end.map_or(GainMargin::Infinite, |end| GainMargin::Ends { below: Some(end), above: None }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_interpolated_and_resultants_known() {
        let list = |numbers: &[i64]| numbers.iter().map(|n| rational(*n, 1)).collect::<Vec<_>>();
        // 2 - x + 3x² at 1, 2, 3, 4.
        assert_eq!(interpolated(&list(&[4, 12, 26, 46]), 1), list(&[2, -1, 3, 0]));
        // (y - 2)(y - 3) and y - 5: 3 times 2.
        let found = sylvester(&list(&[6, -5, 1]), &list(&[-5, 1])).unwrap().determinant().unwrap();
        assert!(found == rational(6, 1) || found == rational(-6, 1));
        assert_eq!(sylvester(&list(&[6, 1]), &list(&[7])).unwrap().determinant().unwrap(), rational(7, 1));
    }
}
