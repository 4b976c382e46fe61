//! Worst cases of switched linear systems `x' = A x + B u + c` with bounded inputs.
//!
//! `x' = -x + u` from rest, whatever `u` does between -1 and 1: `x` stays below 1, and comes within a hundredth of it.
//!
//! ```
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_arithmetic::{Unwatched, rational};
//! use flockproof_reach::{System, Verdict, decide};
//!
//! let text = r#"
//!     [system]
//!     states = ["x"]
//!     inputs = { u = [-1, 1] }
//!     start = { x = 0 }
//!     [[mode]]
//!     name = "only"
//!     A = [[-1]]
//!     B = [[1]]
//!     [run]
//!     until = 5
//!     [[check]]
//!     holds = "x <= 1"
//!     [[check]]
//!     holds = "x <= 99/100"
//! "#;
//! let found = decide(&System::read(text).unwrap(), 10, &Unwatched).unwrap();
//! assert_eq!([found[0].verdict, found[1].verdict], [Verdict::Holds, Verdict::False]);
//! // The worst case is 1 - e^-5, between these bounds; the input that reaches it is a witness.
//! let worst = found[0].decisive();
//! assert!(worst.lo.as_ref() > Some(&rational(99, 100)) && worst.hi.as_ref() < Some(&rational(1, 1)));
//! assert!(found[1].decisive().witness.is_some());
//! ```

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
mod relaxed;
mod scalar;
mod search;
mod signs;
mod support;
mod system;
mod tube;
mod walk;
mod witness;
mod worst;

pub use certificate::{Unbounded, Unshown, bounded, certificate};
pub use decide::{Decided, Part, ReachError, Verdict, decide};
pub use motion::sets::Tube;
pub use platoon::{Platoon, gaps};
pub use system::{Check, Condition, Input, Mode, Range, Side, Stay, Switching, System};
pub use tube::tube;
pub use witness::Witness;
