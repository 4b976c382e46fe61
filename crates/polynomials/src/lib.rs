//! Polynomials over any ring, sums of squares with exact certificates, and inequalities that are decided where they are attained.

mod multivariate;
pub mod sums;

pub use multivariate::{Monomial, Multivariate, monomial_product, total_degree};
