//! The smallest nonzero entries of all products of matrices from a finite set (Chazelle, Lemma 2.2).

use super::{MatrixError, RationalMatrix};
use arithmetic::{Rational, lcm};
use num_bigint::BigInt;
use num_traits::{One, ToPrimitive};

/// The smallest nonzero entry in the first columns of all products of a length.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SmallestEntry {
    /// The entry; `None` where all these columns are zero.
    pub entry: Option<Rational>,
    /// A product with this entry: the numbers of its factors, the one that acts first in front.
    pub factors: Vec<usize>,
}

/// For the lengths `1, ..., length` the smallest nonzero entry of a first column, and the number of products that were
/// looked at: all of them, depth first. Where the set is closed under renaming, the first column stands for every column.
///
/// # Errors
/// Matrices that are not square of one order, with negative entries, or whose products do not fit 128 bits over the power of
/// their common denominator.
pub fn smallest_entries(
    matrices: &[RationalMatrix],
    length: usize,
) -> Result<(Vec<SmallestEntry>, usize), MatrixError> {
    let set = Factors::new(matrices, length)?;
    let mut found = vec![(u128::MAX, Vec::new()); length];
    let mut count = 0;
    let start: Vec<u128> = (0..set.order).map(|i| u128::from(i == 0)).collect();
    let mut open = vec![(Vec::new(), start)];
    while let Some((names, column)) = open.pop() {
        if names.len() == length {
            continue;
        }
        for (k, rows) in set.rows.iter().enumerate() {
            let dot = |row: &Vec<u128>| row.iter().zip(&column).map(|(a, x)| a * x).sum::<u128>();
            let next: Vec<u128> = rows.iter().map(dot).collect();
            count += 1;
            let longer: Vec<usize> = names.iter().copied().chain([k]).collect();
            let least = next.iter().copied().filter(|&x| x > 0).min().unwrap_or(u128::MAX);
            if least < found[names.len()].0 {
                found[names.len()] = (least, longer.clone());
            }
            open.push((longer, next));
        }
    }
    let mut scale = BigInt::one();
    let entries = found.into_iter().map(|(numerator, factors)| {
        scale *= &set.denominator;
        let entry = (!factors.is_empty()).then(|| Rational::new(numerator.into(), scale.clone()));
        SmallestEntry { entry, factors }
    });
    Ok((entries.collect(), count))
}

/// Square matrices as integers over one denominator.
struct Factors {
    order: usize,
    rows: Vec<Vec<Vec<u128>>>,
    denominator: BigInt,
}

impl Factors {
    fn new(matrices: &[RationalMatrix], length: usize) -> Result<Self, MatrixError> {
        let order = matrices.first().map_or(0, RationalMatrix::rows);
        let denominator = matrices.iter().fold(BigInt::one(), |d, m| lcm(&d, m.denominator()));
        let mut rows = Vec::with_capacity(matrices.len());
        let mut largest = 1u128;
        for matrix in matrices {
            if (matrix.rows(), matrix.cols()) != (order, order) {
                return Err(MatrixError::DifferentShapes {
                    left: (order, order),
                    right: (matrix.rows(), matrix.cols()),
                });
            }
            let scale = &denominator / matrix.denominator();
            let entry = |x: &BigInt| (x * &scale).to_u128().ok_or(MatrixError::TooLong);
            let row = |i: usize| matrix.row(i).iter().map(entry).collect::<Result<Vec<u128>, _>>();
            let integers = (0..order).map(row).collect::<Result<Vec<_>, _>>()?;
            for row in &integers {
                let sum = row.iter().try_fold(0u128, |sum, &x| sum.checked_add(x)).ok_or(MatrixError::TooLong)?;
                largest = largest.max(sum);
            }
            rows.push(integers);
        }
        // No entry of a product is above the power of the largest sum of a row.
        let power = u32::try_from(length).ok().and_then(|length| largest.checked_pow(length));
        power.ok_or(MatrixError::TooLong)?;
        Ok(Factors { order, rows, denominator })
    }
}
