//! Laws of one's own: `model = "own"`. What is written in `[law]` is compiled by `expressions` and run like every other law.

mod affine;
mod continuous;
mod discrete;
mod enclosed;
mod exact;
mod headings;
mod measured;
mod noisy;
mod read;
mod run;
mod start;

pub use affine::{AffineFunction, AffineNumber};
pub use enclosed::OwnMotion;
pub use exact::{OwnFlock, OwnSteps};
pub(super) use headings::margin;
pub(super) use read::{describe, describe_open};
pub use read::{law_problem, own_law, read_law};
