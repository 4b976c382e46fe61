//! Products `P(t, s) = P(t) ... P(s)`: the new factor comes on the left.

use super::{MatrixError, StochasticMatrix};

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
