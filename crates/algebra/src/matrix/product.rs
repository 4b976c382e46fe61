//! Products `P(t, s) = P(t) ... P(s)`: the new factor comes on the left.

use super::{MatrixError, StochasticMatrix};
use arithmetic::Ring;

/// The product of matrices over any ring, given by their rows: as many columns on the left as rows on the right, at least one; what has no
/// partner is left out.
pub fn product_of_rows<T: Ring>(left: &[Vec<T>], right: &[Vec<T>]) -> Vec<Vec<T>> {
    let cols = right.iter().map(Vec::len).min().unwrap_or(0);
    let entry = |row: &Vec<T>, j: usize| {
        row.iter().zip(right).map(|(x, column)| x.clone() * &column[j]).reduce(|sum, term| sum + term)
    };
    left.iter().map(|row| (0..cols).filter_map(|j| entry(row, j)).collect()).collect()
}

/// Every prefix `P(1,1), P(2,1), ...` of a sequence of factors, in order; ends with the first product that is refused.
pub fn prefix_products<'a>(
    factors: impl IntoIterator<Item = &'a StochasticMatrix>,
) -> impl Iterator<Item = Result<StochasticMatrix, MatrixError>> {
    let mut factors = factors.into_iter();
    let mut last: Option<StochasticMatrix> = None;
    std::iter::from_fn(move || {
        let factor = factors.next()?;
        let product = match last.take() {
            None => Ok(factor.clone()),
            Some(before) => factor.times(&before),
        };
        last = product.as_ref().ok().cloned();
        if last.is_none() {
            // Nothing can follow a refused product.
            factors.by_ref().for_each(drop);
        }
        Some(product)
    })
}

/// The product of all factors, one after the other.
///
/// # Errors
/// [`MatrixError::NoFactors`] or [`MatrixError::Shapes`].
pub fn product_sequential(factors: &[StochasticMatrix]) -> Result<StochasticMatrix, MatrixError> {
    let (first, rest) = factors.split_first().ok_or(MatrixError::NoFactors)?;
    rest.iter().try_fold(first.clone(), |product, factor| factor.times(&product))
}

/// The product of all factors by a balanced tree: the long multiplications are few and of equal length.
///
/// # Errors
/// [`MatrixError::NoFactors`] or [`MatrixError::Shapes`].
pub fn product_tree(factors: &[StochasticMatrix]) -> Result<StochasticMatrix, MatrixError> {
    match factors {
        [] => Err(MatrixError::NoFactors),
        [one] => Ok(one.clone()),
        many => {
            let (early, late) = many.split_at(many.len() / 2);
            product_tree(late)?.times(&product_tree(early)?)
        }
    }
}
