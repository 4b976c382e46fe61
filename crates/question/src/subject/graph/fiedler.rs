//! The signs of the eigenvector of the second smallest Laplacian eigenvalue, exactly.
//!
//! For a simple eigenvalue `λ` of a symmetric matrix `L` of order `n` with the eigenvector `v`, `adj(λI - L) = p'(λ) v vᵀ/|v|²`, `p` being the
//! characteristic polynomial; for an eigenvalue that is not simple it is zero. Above the second smallest there are `n - 2` eigenvalues, so that `p'(λ)`
//! has the sign `(-1)^n`. The entries of `adj(xI - L)` are integer polynomials (Faddeev, LeVerrier), whose values at `λ` are algebraic integers of its
//! field: their signs can be decided.

use arithmetic::{Algebraic, Interval, RealNumber as Number, Sign};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::failure::Failure;
use algebra::graph::Graph;

/// The signs of all entries, the first one that is not 0 taken as positive; `None` where the eigenvalue is not simple.
pub(super) fn signs(graph: &Graph, second: &Interval, precision: u32) -> Result<Option<Vec<i64>>, Failure> {
    let order = graph.order();
    let adjugate = adjugate(graph);
    // All eigenvalues lie between 0 and twice the largest degree.
    let largest = BigInt::from(2 * (0..order).map(|i| graph.degree(i)).max().unwrap_or(0));
    let sign = |i: usize, j: usize| {
        let mut value = Number::integer(0);
        let mut size = BigInt::zero();
        let point = Number::interval(second.clone());
        for coefficients in &adjugate {
            let coefficient = &coefficients[i * order + j];
            value = value.times(&point, precision).plus(&Number::Exact(coefficient.clone().into()), precision);
            size = size * &largest + coefficient.abs();
        }
        if size.is_zero() {
            return Ok(0);
        }
        let bounds = Algebraic { degree: order as u64, upper: size.bits(), lower: 0 };
        let value = Number::Enclosed(value.enclosure(precision), Some(bounds));
        match value.sign() {
            Some(Sign::Zero) => Ok(0),
            Some(Sign::Positive) => Ok(1),
            Some(Sign::Negative) => Ok(-1),
            None => Err(Failure::open("the sign of an entry of the eigenvector is not known", value.needed_bits())),
        }
    };
    for first in 0..order {
        if sign(first, first)? != 0 {
            let turned = if order.is_multiple_of(2) { 1 } else { -1 };
            return (0..order).map(|i| Ok(turned * sign(i, first)?)).collect::<Result<Vec<i64>, Failure>>().map(Some);
        }
    }
    Ok(None)
}

/// The matrices of coefficients of `adj(xI - L)`, by rows, the highest power first.
fn adjugate(graph: &Graph) -> Vec<Vec<BigInt>> {
    let order = graph.order();
    let times = |m: &[BigInt]| -> Vec<BigInt> {
        let entry = |i: usize, j: usize| {
            let around = graph.neighbours(i).iter().map(|&k| &m[k as usize * order + j]).sum::<BigInt>();
            BigInt::from(graph.degree(i)) * &m[i * order + j] - around
        };
        (0..order * order).map(|place| entry(place / order, place % order)).collect()
    };
    let mut all: Vec<Vec<BigInt>> = Vec::with_capacity(order);
    let mut next: Vec<BigInt> =
        (0..order * order).map(|place| BigInt::from(u8::from(place % (order + 1) == 0))).collect();
    for k in 1..=order {
        let mut product = times(&next);
        let trace: BigInt = (0..order).map(|i| product[i * (order + 1)].clone()).sum();
        let coefficient = -trace / BigInt::from(k);
        (0..order).for_each(|i| product[i * (order + 1)] += &coefficient);
        all.push(std::mem::replace(&mut next, product));
    }
    all
}
