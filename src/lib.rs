//! Exact, certified and simulated checks of what five papers claim about flocking, and the machinery behind them.
//!
//! The modules point one way, top to bottom: [`arithmetic`], [`matrix`], [`graph`], [`spectrum`], [`simulate`], [`averaging`] (Chazelle),
//! [`platoon`] (Veerman, Stosic and Olvera), [`oscillator`] (Paley, Leonard and others), [`tracks`] (measured
//! trajectories), [`double_integrator`] (Tanner,
//! Jadbabaie and Pappas), [`certificates`], [`kernel`] (the Coq development), [`ledger`],
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
pub mod simulate;
pub mod spectrum;
pub mod tracks;

/// The example of the page on claims of one's own, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../notes/own_claims.md")]
struct OwnClaims;
