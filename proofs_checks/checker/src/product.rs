//! `product`: the ergodicity coefficient of a product of row-stochastic matrices.

use crate::Refusal;
use crate::matrix::Matrix;
use crate::read::{Fraction, Reader};

const MOST_FACTORS: usize = 10_000;
pub const LARGEST_ORDER: usize = 128;

/// `tau_1(matrix)` is the largest `sum_k |a_ik - a_jk| / 2`.
pub fn require_tau_1(reader: &mut Reader, matrix: &Matrix, tau: &Fraction) -> Result<(), Refusal> {
    let products = matrix.rows.saturating_mul(matrix.rows).saturating_mul(matrix.cols);
    reader.pay(products + 2, matrix.bits(), tau.numerator.bits().max(tau.denominator.bits()) / 64)?;
    let twice = matrix.largest_distance();
    reader.require(
        twice * &tau.denominator == &tau.numerator * &matrix.denominator * 2,
        "tau_1 of the product is another number",
    )
}

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let count = reader.count("factors", 1, MOST_FACTORS)?;
    let mut product: Option<Matrix> = None;
    for _ in 0..count {
        let shape = reader.value("shape")?;
        let (rows, cols) = shape.split_once(' ').ok_or_else(|| reader.refusal("two numbers are expected"))?;
        let rows = reader.count_of(rows, 1, LARGEST_ORDER)?;
        let cols = reader.count_of(cols, 1, LARGEST_ORDER)?;
        let fits = product.as_ref().is_none_or(|before| cols == before.rows);
        reader.require(fits, "the matrix cannot multiply the one before it")?;
        let factor = reader.stochastic("P", rows, cols)?;
        product = Some(match product {
            None => factor,
            Some(before) => reader.times(&factor, &before)?,
        });
    }
    let tau = reader.fraction("tau_1")?;
    let Some(product) = product else { return Err(reader.refusal("there is no matrix")) };
    require_tau_1(reader, &product, &tau)?;
    Ok(format!(
        "tau_1 of the product of the {count} row-stochastic matrices below, the first factor on the right, is {}",
        tau.text
    ))
}
