//! Polynomials over any ring, sums of squares with exact certificates, and inequalities that are decided where they are attained.
//!
//! Decided for all reals: `x^2 + y^2 >= 2 x y`, where equality is attained, and `x^2 + y^2 > 2 x y`, with a point where it fails:
//!
//! ```
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_arithmetic::{ArithmeticError, Number, Unwatched};
//! use flockproof_polynomials::decide::{Decision, Effort, decide};
//! use flockproof_polynomials::{Compared, Function, Literal, Side};
//!
//! struct Difference;
//!
//! impl Function for Difference {
//!     fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
//!         let [x, y] = [at[0].clone(), at[1].clone()];
//!         Ok(x.clone() * x.clone() + y.clone() * y.clone() - x.integer(2) * x * y)
//!     }
//! }
//!
//! let everywhere = [Side::line(), Side::line()];
//! let asked = |compared| {
//!     let literal = Literal { function: Difference, compared, guarded: false };
//!     decide(&[literal], &everywhere, Effort::default(), &Unwatched).unwrap()
//! };
//! assert!(matches!(asked(Compared::NotNegative), Decision::Holds(_)));
//! let Decision::Fails(point) = asked(Compared::Positive) else { panic!("x = y is a counterexample") };
//! assert_eq!(point[0], point[1]);
//! ```

pub mod decide;
mod function;
mod multivariate;
pub mod sums;
mod symbolic;
pub mod univariate;

pub use function::{Compared, Function, Literal, Side};
pub use multivariate::{Monomial, Multivariate, monomial_product, total_degree};
pub use symbolic::{Extension, Settled, Symbolic};
