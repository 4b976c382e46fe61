//! Every claim as recorded.

extern crate flockproof_claims as claims;

mod attacked;
mod attempted;
mod attempts;
mod motion_attempts;
mod paley_runs;
mod reached;
mod recorded;
mod statements;
