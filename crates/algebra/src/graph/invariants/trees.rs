//! Kirchhoff: spanning trees and resistances, from the Laplacian with one vertex grounded.

use crate::graph::Graph;
use crate::matrix::RationalMatrix;
use arithmetic::Rational;
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// Up to this order all numbers of the elimination fit: minors of the Laplacian are at most `n^(n-2)` (Cayley), and two are multiplied.
const LARGEST_IN_A_WORD: usize = 16;

impl Graph {
    /// Number of spanning trees, by the matrix-tree theorem; 1 of a single vertex, 0 where the graph is not connected.
    pub fn spanning_trees(&self) -> BigInt {
        let order = self.order();
        if order <= 1 {
            return BigInt::from(order);
        }
        let entry = |i: usize, j: usize| if i == j { self.degree(i) as i64 } else { -i64::from(self.has_edge(i, j)) };
        let size = order - 1;
        if order <= LARGEST_IN_A_WORD {
            let rows = (0..size).map(|i| (0..size).map(|j| i128::from(entry(i, j))).collect()).collect();
            return BigInt::from(determinant(rows, |a, b, c, d, e| (a * b - c * d) / e));
        }
        let rows = (0..size).map(|i| (0..size).map(|j| BigInt::from(entry(i, j))).collect()).collect();
        determinant(rows, |a: BigInt, b: BigInt, c: BigInt, d: BigInt, e: BigInt| (a * b - c * d) / e)
    }

    /// The effective resistances between all pairs of vertices, every edge being one of resistance 1; `None` where the graph is not connected.
    pub fn resistances(&self) -> Option<Vec<Vec<Rational>>> {
        let order = self.order();
        if !self.is_connected() {
            return None;
        }
        let inverse = self.grounded_inverse()?;
        let potential = |i: usize, j: usize| match &inverse {
            Some(inverse) if i + 1 < order && j + 1 < order => inverse.entry(i, j),
            _ => Rational::zero(),
        };
        let two = Rational::from_integer(2.into());
        let pair = |i: usize, j: usize| potential(i, i) + potential(j, j) - &two * potential(i, j);
        Some((0..order).map(|i| (0..order).map(|j| pair(i, j)).collect()).collect())
    }

    /// The sum of the effective resistances of all pairs: `n` times the sum of the reciprocal eigenvalues of the Laplacian above 0 (Klein and Randić
    /// 1993). `None` where the graph is not connected.
    pub fn kirchhoff_index(&self) -> Option<Rational> {
        let order = self.order();
        if !self.is_connected() {
            return None;
        }
        let Some(inverse) = self.grounded_inverse()? else { return Some(Rational::zero()) };
        // The pairs' sum of M_ii + M_jj - 2 M_ij over all pairs with the grounded vertex, whose row is zero: n tr M minus the sum of all entries.
        let (mut trace, mut sum) = (BigInt::zero(), BigInt::zero());
        for i in 0..order - 1 {
            trace += &inverse.row(i)[i];
            sum += inverse.row(i).iter().sum::<BigInt>();
        }
        Some(Rational::new(trace * BigInt::from(order) - sum, inverse.denominator().clone()))
    }

    /// The inverse of the Laplacian without the last vertex: nothing of a single vertex, `None` where it does not exist.
    fn grounded_inverse(&self) -> Option<Option<RationalMatrix>> {
        let kept: Vec<usize> = (0..self.order().saturating_sub(1)).collect();
        if kept.is_empty() {
            return Some(None);
        }
        let grounded = self.laplacian().and_then(|laplacian| laplacian.block(&kept, &kept)).ok()?;
        grounded.inverse().ok().map(Some)
    }
}

/// The determinant by fraction-free elimination (Bareiss); `step(a, b, c, d, e)` is `(a b - c d) / e`, which is an integer.
fn determinant<T: Clone + Zero + One + std::ops::Neg<Output = T>>(
    mut rows: Vec<Vec<T>>,
    step: impl Fn(T, T, T, T, T) -> T,
) -> T {
    let size = rows.len();
    let (mut before, mut negative) = (T::one(), false);
    for k in 0..size {
        let Some(pivot) = (k..size).find(|&i| !rows[i][k].is_zero()) else { return T::zero() };
        negative ^= pivot != k;
        rows.swap(pivot, k);
        let (above, below) = rows.split_at_mut(k + 1);
        let top = &above[k];
        for row in below {
            for j in k + 1..size {
                row[j] = step(top[k].clone(), row[j].clone(), row[k].clone(), top[j].clone(), before.clone());
            }
        }
        before = top[k].clone();
    }
    if negative { -before } else { before }
}
