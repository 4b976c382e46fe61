//! Campaigns: the table of invariants with few cases, the planted faults, shards, merging, shrinking.

extern crate flockproof_campaign as campaign;

mod draws;
mod fuzz;
mod invariants;
mod questions;
mod readers;
mod store;
#[cfg(feature = "proptest")]
mod strategies;
