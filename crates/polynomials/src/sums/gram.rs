//! Gram matrices: the linear equations that say "these products times these sums of squares are that polynomial", solved near a proposal in floats
//! and checked exactly.

use super::semidefinite::{Equation, Proposal};
use crate::multivariate::{Monomial, Multivariate};
use arithmetic::{Rational, rational};
use nalgebra::DMatrix;
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::collections::{BTreeMap, BTreeSet};

type Polynomial = Multivariate<Rational>;

/// A product of constraints with the polynomials whose squares and products it is multiplied with.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub factors: Vec<usize>,
    pub product: Polynomial,
    pub basis: Vec<Polynomial>,
}

/// An entry of a Gram matrix on or above the diagonal.
type Column = (usize, usize, usize);

/// A row: coefficients of columns, and the right side.
#[derive(Debug, Clone)]
struct Row {
    entries: BTreeMap<usize, Rational>,
    right: Rational,
}

/// Independent equations in an order in which they can be solved from the last to the first, each for its own column.
pub(super) struct System {
    columns: Vec<Column>,
    sizes: Vec<usize>,
    rows: Vec<(Row, usize)>,
}

/// All coefficients of the Gram matrices in the target, by monomial.
fn rows(
    blocks: &[Block],
    target: &Polynomial,
    reduce: impl Fn(&Polynomial) -> Polynomial,
) -> (Vec<Column>, BTreeMap<Monomial, Row>) {
    let mut columns = Vec::new();
    let mut rows: BTreeMap<Monomial, Row> = BTreeMap::new();
    let empty = || Row { entries: BTreeMap::new(), right: rational(0, 1) };
    for (k, block) in blocks.iter().enumerate() {
        for q in 0..block.basis.len() {
            let side = reduce(&(block.product.clone() * &block.basis[q]));
            for p in 0..=q {
                let own = reduce(&(side.clone() * &block.basis[p]));
                for (monomial, c) in own.terms() {
                    let row = rows.entry(monomial.clone()).or_insert_with(empty);
                    row.entries.insert(columns.len(), if p == q { c.clone() } else { c * rational(2, 1) });
                }
                columns.push((k, p, q));
            }
        }
    }
    for (monomial, c) in target.terms() {
        rows.entry(monomial.clone()).or_insert_with(empty).right = c.clone();
    }
    (columns, rows)
}

/// Basis polynomials whose squares must not occur: an equation with the right side 0 has only squares, all with one sign. `None` where an equation
/// cannot hold at all.
fn idle(columns: &[Column], rows: &BTreeMap<Monomial, Row>) -> Option<BTreeSet<(usize, usize)>> {
    let mut found = BTreeSet::new();
    for row in rows.values() {
        let squares = row.entries.keys().all(|&c| columns[c].1 == columns[c].2);
        let signs: BTreeSet<bool> = row.entries.values().map(Signed::is_positive).collect();
        if !squares || signs.len() > 1 {
            continue;
        }
        if row.right.is_zero() {
            found.extend(row.entries.keys().map(|&c| (columns[c].0, columns[c].1)));
        } else if signs.first() != Some(&row.right.is_positive()) {
            return None;
        }
    }
    Some(found)
}

/// Blocks without what must not occur (Loefberg 2009: that leaves no more than half the Newton polytope), and their equations; `None` where there is no
/// solution.
pub(super) fn pruned(
    mut blocks: Vec<Block>,
    target: &Polynomial,
    reduce: impl Fn(&Polynomial) -> Polynomial + Copy,
) -> Option<(Vec<Block>, System)> {
    loop {
        let (columns, found) = rows(&blocks, target, reduce);
        let idle = idle(&columns, &found)?;
        if idle.is_empty() {
            let sizes = blocks.iter().map(|block| block.basis.len()).collect();
            return System::independent(columns, sizes, found.into_values().collect()).map(|system| (blocks, system));
        }
        for (k, block) in blocks.iter_mut().enumerate() {
            let mut place = 0;
            block.basis.retain(|_| {
                place += 1;
                !idle.contains(&(k, place - 1))
            });
        }
        blocks.retain(|block| !block.basis.is_empty());
        if blocks.is_empty() {
            return None;
        }
    }
}

impl System {
    /// Orders and eliminates; `None` where the equations contradict each other.
    fn independent(columns: Vec<Column>, sizes: Vec<usize>, mut left: Vec<Row>) -> Option<Self> {
        let mut done: Vec<(Row, usize)> = Vec::new();
        // Columns that stand in one row only need no elimination.
        loop {
            let mut count = vec![0u32; columns.len()];
            left.iter().flat_map(|row| row.entries.keys()).for_each(|&c| count[c] += 1);
            let mut taken = false;
            let mut rest = Vec::new();
            for row in left {
                match row.entries.keys().rev().find(|&&c| count[c] == 1).copied() {
                    Some(column) => {
                        row.entries.keys().for_each(|&c| count[c] -= 1);
                        done.push((row, column));
                        taken = true;
                    }
                    None => rest.push(row),
                }
            }
            left = rest;
            if !taken {
                break;
            }
        }
        while let Some(place) = (0..left.len()).min_by_key(|&k| left[k].entries.len()) {
            let row = left.swap_remove(place);
            let Some((&column, lead)) = row.entries.iter().next_back() else {
                if row.right.is_zero() { continue } else { return None }
            };
            for other in &mut left {
                let Some(factor) = other.entries.get(&column).map(|c| c / lead) else { continue };
                for (c, value) in &row.entries {
                    let entry = other.entries.entry(*c).or_insert_with(|| rational(0, 1));
                    *entry -= &factor * value;
                    if entry.is_zero() {
                        other.entries.remove(c);
                    }
                }
                other.right -= &factor * &row.right;
            }
            done.push((row, column));
        }
        Some(System { columns, sizes, rows: done })
    }

    pub fn sizes(&self) -> &[usize] {
        &self.sizes
    }

    /// The number of equations.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// The equations in floats, each scaled to size 1.
    pub fn equations(&self) -> Vec<Equation> {
        let float = |q: &Rational| q.to_f64().unwrap_or(0.0);
        let one = |(row, _): &(Row, usize)| {
            let size = row.entries.values().map(|c| float(c).abs()).fold(0.0, f64::max).max(1e-300);
            let entry = |(&c, value): (&usize, &Rational)| {
                let (k, p, q) = self.columns[c];
                // An entry off the diagonal stands for both.
                (k, p, q, float(value) / size / if p == q { 1.0 } else { 2.0 })
            };
            Equation { entries: row.entries.iter().map(entry).collect(), right: float(&row.right) / size }
        };
        self.rows.iter().map(one).collect()
    }

    /// Symmetric rational matrices that obey all equations, with free entries rounded to multiples of `2^-bits`.
    pub fn rounded(&self, proposal: &Proposal, bits: u32) -> Option<Vec<Vec<Vec<Rational>>>> {
        let scale = 2f64.powi(bits as i32);
        let denominator = BigInt::one() << bits;
        let near = |&(k, p, q): &Column| {
            let scaled = (proposal.blocks[k][(p, q)] * scale).round();
            let integer = num_traits::FromPrimitive::from_f64(scaled);
            integer.map(|n: BigInt| Rational::new(n, denominator.clone()))
        };
        let mut values = self.columns.iter().map(near).collect::<Option<Vec<Rational>>>()?;
        for (row, column) in self.rows.iter().rev() {
            let others = row.entries.iter().filter(|(c, _)| *c != column);
            let sum = others.fold(row.right.clone(), |sum, (c, a)| sum - a * &values[*c]);
            values[*column] = sum / &row.entries[column];
        }
        let mut blocks: Vec<Vec<Vec<Rational>>> =
            self.sizes.iter().map(|&n| vec![vec![rational(0, 1); n]; n]).collect();
        for (&(k, p, q), value) in self.columns.iter().zip(values) {
            blocks[k][p][q] = value.clone();
            blocks[k][q][p] = value;
        }
        Some(blocks)
    }
}

/// `G = sum d l l^T` with `d >= 0`, by Gauss; `None` where the matrix is not positive semidefinite.
pub(super) fn squares(mut g: Vec<Vec<Rational>>) -> Option<Vec<(Rational, Vec<Rational>)>> {
    let n = g.len();
    let mut list = Vec::new();
    for k in 0..n {
        let pivot = g[k][k].clone();
        if pivot.is_negative() {
            return None;
        }
        if pivot.is_zero() {
            if g[k][k..].iter().any(|x| !x.is_zero()) {
                return None;
            }
            continue;
        }
        let row: Vec<Rational> = (0..n).map(|j| if j < k { rational(0, 1) } else { &g[k][j] / &pivot }).collect();
        for i in k + 1..n {
            if row[i].is_zero() {
                continue;
            }
            let factor = &row[i] * &pivot;
            for j in i..n {
                let less = &factor * &row[j];
                g[i][j] -= &less;
                if i != j {
                    g[j][i] -= less;
                }
            }
        }
        list.push((pivot, row));
    }
    Some(list)
}

/// Whether floats have no doubt that a matrix is not positive semidefinite, so that nobody need look exactly.
pub(super) fn is_hopeless(g: &[Vec<Rational>]) -> bool {
    let n = g.len();
    let floats = DMatrix::from_fn(n, n, |i, j| g[i][j].to_f64().unwrap_or(0.0));
    let size = floats.amax();
    n > 0 && floats.symmetric_eigenvalues().min() < -1e-7 * size
}

/// A rational basis of the vectors that are orthogonal to all given ones (of length `n`).
pub(super) fn complement(vectors: &[Vec<Rational>], n: usize) -> Vec<Vec<Rational>> {
    let mut rows: Vec<Vec<Rational>> = vectors.to_vec();
    let mut pivots = Vec::new();
    let mut rank = 0;
    for column in 0..n {
        let Some(place) = (rank..rows.len()).find(|&k| !rows[k][column].is_zero()) else { continue };
        rows.swap(rank, place);
        let lead = rows[rank][column].clone();
        rows[rank].iter_mut().for_each(|x| *x = &*x / &lead);
        for k in 0..rows.len() {
            if k == rank || rows[k][column].is_zero() {
                continue;
            }
            let factor = rows[k][column].clone();
            let pivot = rows[rank].clone();
            rows[k].iter_mut().zip(&pivot).for_each(|(x, p)| *x -= &factor * p);
        }
        pivots.push(column);
        rank += 1;
    }
    let free = (0..n).filter(|column| !pivots.contains(column));
    let vector = |column: usize| {
        let mut vector = vec![rational(0, 1); n];
        vector[column] = rational(1, 1);
        pivots.iter().enumerate().for_each(|(k, &pivot)| vector[pivot] = -&rows[k][column]);
        vector
    };
    free.map(vector).collect()
}

/// The combinations of the basis.
pub(super) fn combined(basis: &[Polynomial], vectors: &[Vec<Rational>]) -> Vec<Polynomial> {
    let zero = Multivariate::of(rational(0, 1));
    let one = |vector: &Vec<Rational>| {
        vector.iter().zip(basis).fold(zero.clone(), |sum, (c, p)| if c.is_zero() { sum } else { sum + p.scaled(c) })
    };
    vectors.iter().map(one).collect()
}

/// Vectors near the kernel of a matrix, rounded to simple rationals after elimination; none where there is no kernel or no gap before it.
pub(super) fn near_kernel(x: &DMatrix<f64>) -> Vec<Vec<Rational>> {
    let n = x.nrows();
    let eigen = x.clone().symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
    let value = |k: usize| eigen.eigenvalues[order[k]].max(1e-300);
    let largest = value(n - 1).max(1e-12);
    // The widest gap below which all are small.
    let gap = (1..n)
        .filter(|&k| value(k - 1) < 1e-3 * largest)
        .max_by(|&a, &b| (value(a) / value(a - 1)).total_cmp(&(value(b) / value(b - 1))));
    let Some(count) = gap.filter(|&k| value(k) > 30.0 * value(k - 1)) else { return Vec::new() };
    let mut rows: Vec<Vec<f64>> =
        order[..count].iter().map(|&k| eigen.eigenvectors.column(k).iter().copied().collect()).collect();
    // Row echelon form with full pivoting.
    let mut used = Vec::new();
    for rank in 0..count {
        let places = (rank..count).flat_map(|k| (0..n).map(move |j| (k, j)));
        let largest = places.max_by(|a, b| rows[a.0][a.1].abs().total_cmp(&rows[b.0][b.1].abs()));
        let Some((k, column)) = largest.filter(|&(k, j)| rows[k][j].abs() > 1e-6) else { return Vec::new() };
        rows.swap(rank, k);
        let lead = rows[rank][column];
        rows[rank].iter_mut().for_each(|x| *x /= lead);
        let pivot = rows[rank].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != rank) {
            let factor = row[column];
            row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= factor * p);
        }
        used.push(column);
    }
    let simple = |x: &f64| {
        const NEAR: f64 = 2e-3;
        let fits = |d: &i64| ((x * *d as f64).round() - x * *d as f64).abs() < NEAR;
        [1, 2, 3, 4, 5, 6, 8, 9, 10, 12].iter().find(|d| fits(d)).map(|d| rational((x * *d as f64).round() as i64, *d))
    };
    let rounded = |row: &Vec<f64>| row.iter().map(simple).collect::<Option<Vec<Rational>>>();
    rows.iter().map(rounded).collect::<Option<Vec<_>>>().unwrap_or_default()
}
