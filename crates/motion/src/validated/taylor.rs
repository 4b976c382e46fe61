//! Taylor's coefficients of solutions.

use super::SmoothLaw;
use arithmetic::{ArithmeticError, Field, Series};

/// The coefficients `y^(k)/k!`, `k = 0..=order`, of the solution through `start`, coordinate by coordinate: `k c_k` is coefficient `k - 1` of `f`
/// of the series up to there.
///
/// # Errors
/// Whatever the law returns.
pub(super) fn coefficients<T: Field>(
    law: &impl SmoothLaw,
    start: &[T],
    order: usize,
) -> Result<Vec<Vec<T>>, ArithmeticError> {
    let mut known: Vec<Vec<T>> = start.iter().map(|x| vec![x.clone()]).collect();
    for k in 1..=order {
        let series: Vec<Series<T>> = known
            .iter()
            .zip(start)
            .map(|(c, first)| Series::from_coefficients(first.clone(), c[1..].iter().cloned()))
            .collect();
        for (c, rate) in known.iter_mut().zip(law.rate(&series)?) {
            let last = &rate.coefficients()[k - 1];
            c.push(last.clone() * &last.ratio(1, k as i64));
        }
    }
    Ok(known)
}

/// `sum c_k t^k`.
pub(super) fn horner<T: Field>(coefficients: &[T], t: &T) -> T {
    coefficients.iter().rev().fold(t.zero(), |sum, c| sum * t + c)
}
