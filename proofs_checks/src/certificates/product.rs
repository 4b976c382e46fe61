//! `product`: tau_1 of a product of row-stochastic matrices.

use super::{CertificateError, LARGEST_ORDER, at_most, text};
use algebra::matrix::{MatrixError, RationalMatrix, StochasticMatrix, product_tree};
use arithmetic::Rational;

/// The ergodicity coefficient `tau_1(P(k) ... P(1))` (Chazelle, section 2, Ergodicity).
#[derive(Debug, Clone)]
pub struct Product {
    pub(super) factors: Vec<RationalMatrix>,
    pub(super) tau: Rational,
}

impl Product {
    /// Of factors that can be multiplied, P(1) first.
    ///
    /// # Errors
    /// [`CertificateError`]: no factors, shapes that do not fit, too many of them.
    pub fn new(factors: &[StochasticMatrix]) -> Result<Self, CertificateError> {
        at_most("factors", 10_000, factors.len())?;
        let largest = factors.iter().map(|p| p.rows().max(p.cols())).max().ok_or(MatrixError::NoFactors)?;
        at_most("rows or columns", LARGEST_ORDER, largest)?;
        let tau = product_tree(factors)?.tau_1();
        Ok(Product { factors: factors.iter().map(|p| p.to_rational_matrix().reduced()).collect(), tau })
    }

    pub(super) fn claim(&self) -> String {
        format!(
            "tau_1 of the product of the {} row-stochastic matrices below, the first factor on the right, is {}",
            self.factors.len(),
            self.tau
        )
    }

    pub(super) fn body(&self) -> String {
        let factor = |p: &RationalMatrix| format!("shape {} {}\n{}", p.rows(), p.cols(), text::matrix("P", p));
        let factors: String = self.factors.iter().map(factor).collect();
        format!("factors {}\n{factors}tau_1 {}\n", self.factors.len(), self.tau)
    }
}
