//! Polynomials in Bernstein's basis over the integers: their values on `[0, 1]` lie between the least and the largest coefficient.

use arithmetic::lcm;
use num_bigint::BigInt;

/// The binomial coefficients `C(n, k)` for `k` from 0 to `n`.
pub(super) fn binomials(n: usize) -> Vec<BigInt> {
    let mut list = vec![BigInt::from(1)];
    for k in 0..n {
        list.push(&list[k] * (n - k) / (k + 1));
    }
    list
}

/// The coefficients on `[0, 1]`, times the least common multiple of the binomial coefficients, of a polynomial given with the constant
/// coefficient first.
pub(super) fn bernstein(coefficients: &[BigInt]) -> Vec<BigInt> {
    let binomials = binomials(coefficients.len().saturating_sub(1));
    let all = binomials.iter().fold(BigInt::from(1), |sum, b| lcm(&sum, b));
    let weighted: Vec<BigInt> = coefficients.iter().zip(&binomials).map(|(c, b)| c * (&all / b)).collect();
    // b_i = sum_k C(i, k) w_k.
    let mut row = vec![BigInt::from(1)];
    let value = |_| {
        let value = row.iter().zip(&weighted).map(|(c, w)| c * w).sum();
        let next = row.windows(2).map(|pair| &pair[0] + &pair[1]);
        row = std::iter::once(BigInt::from(1)).chain(next).chain([BigInt::from(1)]).collect();
        value
    };
    (0..weighted.len()).map(value).collect()
}

/// The coefficients on both halves, both times `2^degree`.
pub(super) fn halves(mut b: Vec<BigInt>) -> (Vec<BigInt>, Vec<BigInt>) {
    let degree = b.len() - 1;
    let mut left = Vec::with_capacity(b.len());
    for stage in 0..=degree {
        left.push(&b[0] << (degree - stage));
        for i in 0..degree - stage {
            let (head, tail) = b.split_at_mut(i + 1);
            head[i] += &tail[0];
        }
    }
    b.iter_mut().enumerate().for_each(|(i, c)| *c <<= i);
    (left, b)
}

/// Divides lists by the largest power of two that divides all their numbers.
pub(super) fn without_twos(lists: &mut [&mut Vec<BigInt>]) {
    let twos = lists.iter().flat_map(|list| list.iter()).filter_map(BigInt::trailing_zeros).min().unwrap_or(0);
    lists.iter_mut().flat_map(|list| list.iter_mut()).for_each(|c| *c >>= twos);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `1 + 2t + 12 t²` has the coefficients 1, 2, 15; halves have them for `t/2` and `(1 + t)/2`.
    #[test]
    fn coefficients_by_hand() {
        let list = |numbers: &[i64]| numbers.iter().map(|n| BigInt::from(*n)).collect::<Vec<_>>();
        assert_eq!(binomials(4), list(&[1, 4, 6, 4, 1]));
        let mut b = bernstein(&list(&[1, 2, 12]));
        assert_eq!(b, list(&[2, 4, 30]));
        // 1 + t + 3t²: 1, 3/2, 5; 5 + 7t + 3t²: 5, 17/2, 15. Times 8.
        let (left, right) = halves(b.clone());
        assert_eq!((left, right), (list(&[8, 12, 40]), list(&[40, 68, 120])));
        without_twos(&mut [&mut b]);
        assert_eq!(b, list(&[1, 2, 15]));
        assert!(bernstein(&[]).is_empty());
    }
}
