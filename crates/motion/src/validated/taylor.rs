//! Taylor's coefficients of solutions.

use crate::System;
use arithmetic::{ArithmeticError, Field, Number, Series};

/// The coefficients `y^(k)/k!`, `k = 0..=order`, of the solution through `start` at `time`, coordinate by coordinate: `k c_k` is coefficient `k - 1` of `f`
/// of the series up to there.
///
/// # Errors
/// Whatever the law returns.
pub(super) fn coefficients<T: Number>(
    law: &impl System,
    time: &T,
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
        let ahead = (1..k).map(|power| time.integer(i64::from(power == 1)));
        let now = Series::from_coefficients(time.clone(), ahead);
        for (c, rate) in known.iter_mut().zip(law.rate(&now, &series)?) {
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
