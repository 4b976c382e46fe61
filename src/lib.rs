//! Exact, certified and simulated checks of what five papers claim about flocking, and the machinery behind them.
//!
//! The modules point one way, top to bottom: [`arithmetic`], [`matrix`], [`graph`], [`spectrum`], [`simulate`], [`validated`], [`averaging`] (Chazelle),
//! [`platoon`] (Veerman, Stosic and Olvera), [`oscillator`] (Paley, Leonard and others), [`tracks`] (measured trajectories), [`double_integrator`] (Tanner,
//! Jadbabaie and Pappas), [`scenario`] (runs of all of them from a file), [`certificates`], [`kernel`] (the Coq development), [`ledger`],
//! [`claims`], [`report`].
#![warn(missing_docs)]
#![forbid(unsafe_code)]

pub mod arithmetic;
pub mod averaging;
pub mod certificates;
pub mod claims;
pub mod double_integrator;
pub mod graph;
pub mod kernel;
pub mod ledger;
pub mod matrix;
pub mod oscillator;
pub mod platoon;
pub mod report;
pub mod scenario;
pub mod simulate;
pub mod spectrum;
pub mod tracks;
pub mod validated;

/// The example of the page on claims of one's own, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../notes/own_claims.md")]
struct OwnClaims;
