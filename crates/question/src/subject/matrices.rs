//! Products of stochastic matrices.

use crate::error::Problem;
use crate::failure::Failure;
use crate::subject::graph::second_modulus;
use crate::timeline::Measured;
use algebra::matrix::{SparseMatrix, StochasticMatrix, product_sequential, tau_2_squared};
use arithmetic::RealNumber as Number;

/// A coefficient of ergodicity, or the second largest modulus, of the product of all factors, the first one rightmost.
pub(crate) fn measure(name: &str, factors: &[StochasticMatrix], precision: u32) -> Result<Measured, Failure> {
    let product = product_sequential(factors)
        .map_err(|error| Failure::Refused(0, Problem::Other(format!("the matrices have no product: {error}"))))?;
    let number = match name {
        "tau_1" => Number::Exact(product.tau_1()),
        "second_modulus" => {
            let sparse = SparseMatrix::from_dense(&product.to_rational_matrix());
            let square = |_| Failure::Refused(0, Problem::Other("the product is not a square matrix".to_string()));
            second_modulus(&sparse.map_err(square)?, precision)?
        }
        _ => Number::Exact(tau_2_squared(&product.to_rational_matrix()))
            .sqrt(precision)
            .map_err(|_| Failure::open("tau_2 could not be enclosed", None))?,
    };
    Ok(Measured::Number(number))
}
