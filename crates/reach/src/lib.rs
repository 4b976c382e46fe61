//! Worst cases of switched linear systems `x' = A x + B u + c` with bounded inputs.

pub mod answer;
mod cascade;
mod certificate;
mod comparison;
mod condition;
mod decide;
mod ellipsoid;
mod family;
mod flow;
mod guess;
mod modal;
mod orders;
mod platoon;
mod prepared;
mod read;
mod scalar;
mod search;
mod signs;
mod support;
mod system;
mod tube;
mod walk;
mod witness;
mod worst;

pub use certificate::{Unbounded, bounded, certificate};
pub use decide::{Decided, Part, ReachError, Verdict, decide};
pub use motion::sets::Tube;
pub use platoon::{Platoon, gaps};
pub use system::{Check, Condition, Input, Mode, Range, Side, Stay, Switching, System};
pub use tube::tube;
pub use witness::Witness;
