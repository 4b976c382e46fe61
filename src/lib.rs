//! Exact, certified and simulated checks of what five papers claim about flocking, and the machinery behind them.
//!
//! The crates of the workspace under one name; each can be used without those above it. From the lowest: [`arithmetic`]; [`matrix`], [`graph`] and [`spectrum`];
//! [`motion`]; the models [`averaging`] (Chazelle), [`platoon`] (Veerman, Stosic and Olvera), [`oscillator`] (Paley, Leonard and others), [`tracks`] (measured
//! trajectories) and [`double_integrator`] (Tanner, Jadbabaie and Pappas); [`scenario`] (runs of all of them from a file); [`ledger`]; [`certificates`] and
//! [`kernel`] (the Coq development); [`claims`]; [`report`]; [`campaign`] (invariants under random cases).

pub use algebra::{graph, matrix, spectrum};
pub use arithmetic;
pub use campaign;
pub use claims;
pub use ledger;
pub use models::{averaging, double_integrator, oscillator, platoon, tracks};
pub use motion;
pub use proofs::{certificates, kernel};
pub use question;
pub use report;
pub use scenario;

/// The example of the page on claims of one's own, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../notes/own_claims.md")]
struct OwnClaims;
