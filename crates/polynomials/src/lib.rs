//! Polynomials over any ring, sums of squares with exact certificates, and inequalities that are decided where they are attained.

pub mod decide;
mod function;
mod multivariate;
pub mod sums;
mod symbolic;
pub mod univariate;

pub use function::{Compared, Function, Literal, Side};
pub use multivariate::{Monomial, Multivariate, monomial_product, total_degree};
pub use symbolic::{Extension, Symbolic};
