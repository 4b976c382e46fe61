//! Exact, certified and simulated checks of what five papers claim about flocking, and the machinery behind them.
//!
//! The crates of the workspace under one name; each can be used without those above it. From the lowest: [`arithmetic`]; [`matrix`], [`graph`] and [`spectrum`];
//! [`motion`]; the models [`averaging`] (Chazelle), [`platoon`] (Veerman, Stosic and Olvera), [`oscillator`] (Paley, Leonard and others), [`tracks`] (measured
//! trajectories) and [`double_integrator`] (Tanner, Jadbabaie and Pappas); [`scenario`] (runs of all of them from a file); [`reach`] (worst cases of switched linear systems); [`ledger`]; [`certificates`] and
//! [`kernel`] (the Coq development); [`claims`]; [`report`]; [`campaign`] (invariants under random cases).
//!
//! The largest amplitude that the last of 128 cars can have behind an oscillating leader, with its frequency, enclosed to ten digits:
//!
//! ```
//! use flockproof::arithmetic::rational;
//! use flockproof::platoon::{Gains, resonance};
//!
//! let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
//! let found = resonance(&gains, 128, 10).unwrap();
//! let (lo, hi) = found.amplitude.to_rationals();
//! assert!(rational(146_730, 1000) < lo && hi < rational(146_731, 1000));
//! ```

// The command line uses the library by the name that users know.
extern crate self as flockproof;

mod cli;

/// Runs the command line with these arguments, the first of which is the name of the program, and returns its exit status. It takes
/// over the signals of the process and prints: for programs that are nothing else, such as the script of the Python package.
pub fn command_line(arguments: impl IntoIterator<Item = std::ffi::OsString>) -> u8 {
    cli::main(arguments)
}

pub use algebra::{graph, json, matrix, spectrum};
pub use arithmetic;
pub use campaign;
pub use claims;
pub use ledger;
pub use models::{averaging, double_integrator, oscillator, platoon, tracks};
pub use motion;
pub use proofs::{certificates, kernel};
pub use question;
pub use reach;
pub use report;
pub use scenario;

/// The examples of the pages on claims of one's own and on the way from a sentence to a verdict, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../notes/own_claims.md")]
#[doc = include_str!("../notes/tutorial.md")]
struct Pages;
