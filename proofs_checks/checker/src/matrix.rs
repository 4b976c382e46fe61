//! Matrices of integers over one positive denominator.

use crate::budget::bits;
use num_bigint::{BigInt, Sign};

pub struct Matrix {
    pub rows: usize,
    pub cols: usize,
    /// Row by row.
    pub entries: Vec<BigInt>,
    pub denominator: BigInt,
}

impl Matrix {
    pub fn from_fn(rows: usize, cols: usize, denominator: BigInt, entry: impl Fn(usize, usize) -> BigInt) -> Self {
        let entry = &entry;
        let entries = (0..rows).flat_map(|i| (0..cols).map(move |j| entry(i, j))).collect();
        Matrix { rows, cols, entries, denominator }
    }

    pub fn identity(order: usize) -> Self {
        Matrix::from_fn(order, order, BigInt::from(1), |i, j| BigInt::from(i == j))
    }

    pub fn at(&self, i: usize, j: usize) -> &BigInt {
        &self.entries[i * self.cols + j]
    }

    pub fn row(&self, i: usize) -> &[BigInt] {
        &self.entries[i * self.cols..][..self.cols]
    }

    /// Bits of the longest number in it.
    pub fn bits(&self) -> u64 {
        bits(&self.entries).max(self.denominator.bits())
    }

    pub fn times(&self, right: &Matrix) -> Matrix {
        let denominator = &self.denominator * &right.denominator;
        Matrix::from_fn(self.rows, right.cols, denominator, |i, j| {
            (0..self.cols).map(|k| self.at(i, k) * right.at(k, j)).sum()
        })
    }

    pub fn minus(&self, other: &Matrix) -> Matrix {
        let denominator = &self.denominator * &other.denominator;
        Matrix::from_fn(self.rows, self.cols, denominator, |i, j| {
            self.at(i, j) * &other.denominator - other.at(i, j) * &self.denominator
        })
    }

    pub fn equals(&self, other: &Matrix) -> bool {
        self.minus(other).is_zero()
    }

    pub fn is_zero(&self) -> bool {
        self.entries.iter().all(|x| x.sign() == Sign::NoSign)
    }

    /// The largest `sum_k |a_ik - a_jk|`, over the denominator: twice tau_1.
    pub fn largest_distance(&self) -> BigInt {
        let distance = |i: usize, j: usize| -> BigInt {
            self.row(i).iter().zip(self.row(j)).map(|(a, b)| BigInt::from((a - b).magnitude().clone())).sum()
        };
        let pairs = (0..self.rows).flat_map(|i| (0..i).map(move |j| (i, j)));
        pairs.map(|(i, j)| distance(i, j)).max().unwrap_or_default()
    }
}
