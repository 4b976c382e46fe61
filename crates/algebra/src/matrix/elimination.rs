//! Sparse symmetric matrices as `L D L^T`, over any field: rows with few entries first, so that few places fill up.

use arithmetic::Field;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// `A = L D L^T` for a symmetric matrix `A` with its rows and columns in another order, without a look at the sizes of the pivots.
#[derive(Debug, Clone)]
pub struct SparseLdl<T> {
    /// The rows in the order in which they were eliminated.
    order: Vec<u32>,
    /// `D`, in this order.
    pivots: Vec<T>,
    /// Below the diagonal of `L`, column by column in this order: row and entry.
    columns: Vec<Vec<(u32, T)>>,
}

impl<T: Field> SparseLdl<T> {
    /// Factors the matrix with this diagonal and these entries beside it, row by row in the order of the columns; each is given twice, and
    /// places outside the matrix are left out.
    /// `None` where a pivot is or may be zero, or where more than `most` products would be needed.
    pub fn new(diagonal: Vec<T>, mut rows: Vec<Vec<(u32, T)>>, most: usize) -> Option<Self> {
        let count = diagonal.len();
        rows.resize(count, Vec::new());
        let mut diagonal = diagonal;
        for (i, row) in rows.iter_mut().enumerate() {
            row.retain(|&(j, _)| j as usize != i && (j as usize) < count);
        }
        let mut queue: BinaryHeap<Reverse<(usize, u32)>> =
            rows.iter().enumerate().map(|(i, row)| Reverse((row.len(), i as u32))).collect();
        let mut done = vec![false; count];
        let mut factored = SparseLdl { order: Vec::new(), pivots: Vec::new(), columns: Vec::new() };
        let mut products = 0;
        while let Some(Reverse((entries, next))) = queue.pop() {
            let place = next as usize;
            if done[place] || rows[place].len() != entries {
                continue;
            }
            done[place] = true;
            products += entries * entries;
            if products > most {
                return None;
            }
            let row = std::mem::take(&mut rows[place]);
            let inverse = diagonal[place].recip().ok()?;
            let column: Vec<(u32, T)> = row.iter().map(|(i, a)| (*i, a.clone() * &inverse)).collect();
            for ((i, factor), (_, own)) in column.iter().zip(&row) {
                let i = *i as usize;
                diagonal[i] = diagonal[i].clone() - own.clone() * factor;
                rows[i] = less(std::mem::take(&mut rows[i]), factor, &row, (i as u32, next));
                queue.push(Reverse((rows[i].len(), i as u32)));
            }
            factored.order.push(next);
            factored.pivots.push(diagonal[place].clone());
            factored.columns.push(column);
        }
        Some(factored)
    }

    /// `D`: as many of these are negative as the matrix has negative eigenvalues (Sylvester), over an ordered field.
    pub fn pivots(&self) -> &[T] {
        &self.pivots
    }

    /// Solves `A x = b`; `b` has as many entries as there are rows, and becomes `x`. `None` where a division fails.
    pub fn solve(&self, b: &mut [T]) -> Option<()> {
        for (&k, column) in self.order.iter().zip(&self.columns) {
            let own = b.get(k as usize)?.clone();
            for (i, factor) in column {
                b[*i as usize] = b[*i as usize].clone() - own.clone() * factor;
            }
        }
        for ((&k, column), pivot) in self.order.iter().zip(&self.columns).zip(&self.pivots).rev() {
            let own = b[k as usize].over(pivot).ok()?;
            b[k as usize] = column.iter().fold(own, |x, (i, factor)| x - b[*i as usize].clone() * factor);
        }
        Some(())
    }
}

/// A row less a multiple of the eliminated one, without its own place and that of the eliminated one.
fn less<T: Field>(row: Vec<(u32, T)>, factor: &T, other: &[(u32, T)], (own, gone): (u32, u32)) -> Vec<(u32, T)> {
    let mut merged = Vec::with_capacity(row.len() + other.len());
    let mut rest = other.iter().filter(|(j, _)| *j != own).peekable();
    for (j, value) in row.into_iter().filter(|(j, _)| *j != gone) {
        while let Some((k, a)) = rest.next_if(|(k, _)| *k < j) {
            merged.push((*k, -(a.clone() * factor)));
        }
        let value = match rest.next_if(|(k, _)| *k == j) {
            Some((_, a)) => value - a.clone() * factor,
            None => value,
        };
        merged.push((j, value));
    }
    merged.extend(rest.map(|(k, a)| (*k, -(a.clone() * factor))));
    merged
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrix::{RationalMatrix, inertia};
    use arithmetic::random::generator;
    use arithmetic::{Rational, Signed, rational};
    use rand_chacha::rand_core::Rng;

    /// Random symmetric matrices of integers: the solution solves exactly, and the signs of the pivots are those of the dense twin.
    #[test]
    fn solutions_are_exact_and_pivots_have_the_inertia() {
        let (mut solved, mut failed) = (0, 0);
        for case in 0..200 {
            let mut random = generator("test", "elimination", case);
            let n = 1 + (random.next_u32() % 9) as usize;
            let mut dense = vec![vec![rational(0, 1); n]; n];
            let mut set = |i: usize, j: usize, value: Rational| {
                dense[i][j] = value.clone();
                dense[j][i] = value;
            };
            for i in 0..n {
                set(i, i, rational(i64::from(random.next_u32() % 9) - 3, 1));
                for j in 0..i {
                    if random.next_u32().is_multiple_of(3) {
                        set(i, j, rational(i64::from(random.next_u32() % 7) - 3, 1));
                    }
                }
            }
            let zero = rational(0, 1);
            let (dense, zero) = (&dense, &zero);
            let row = |i: usize| {
                (0..n).filter(move |&j| j != i && dense[i][j] != *zero).map(move |j| (j as u32, dense[i][j].clone()))
            };
            let diagonal: Vec<Rational> = (0..n).map(|i| dense[i][i].clone()).collect();
            let Some(factored) = SparseLdl::new(diagonal, (0..n).map(|i| row(i).collect()).collect(), usize::MAX)
            else {
                failed += 1;
                continue;
            };
            let b: Vec<Rational> = (0..n).map(|i| rational(i as i64 + 1, 3)).collect();
            let mut x = b.clone();
            factored.solve(&mut x).expect("a solution");
            let matrix = RationalMatrix::from_rows(dense).expect("a matrix");
            assert_eq!(matrix.apply(&x).expect("fits"), b, "{case}");
            let negative = factored.pivots().iter().filter(|p| p.is_certainly_negative()).count();
            assert_eq!(negative, inertia(dense).expect("symmetric").negative, "{case}");
            solved += 1;
        }
        assert!(solved > 60 && failed > 10, "{solved} {failed}");
    }

    /// A tree fills nothing, whatever the numbers of its vertices; with too few products allowed there is none.
    #[test]
    fn trees_do_not_fill() {
        let n = 300u32;
        let parent = |i: u32| (i * 7 + 3) % i;
        let mut rows = vec![Vec::new(); n as usize];
        for i in 1..n {
            rows[i as usize].push((parent(i), -1.0));
            rows[parent(i) as usize].push((i, -1.0));
        }
        rows.iter_mut().for_each(|row| row.sort_by_key(|&(j, _)| j));
        let diagonal: Vec<f64> =
            rows.iter().enumerate().map(|(i, row)| row.len() as f64 + f64::from(u8::from(i == 9))).collect();
        let factored = SparseLdl::new(diagonal.clone(), rows.clone(), 1000).expect("few products");
        assert!(factored.columns.iter().map(Vec::len).sum::<usize>() == n as usize - 1);
        assert!(SparseLdl::new(diagonal, rows, 200).is_none());
        let mut b = vec![0.0; n as usize];
        b[9] = 1.0;
        factored.solve(&mut b).expect("a solution");
        assert!(b.iter().all(|x| (x - 1.0).abs() < 1e-9));
    }
}
