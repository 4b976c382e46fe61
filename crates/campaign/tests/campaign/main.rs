//! Campaigns: the table of invariants with few cases, the planted faults, shards, merging, shrinking.

mod draws;
mod fuzz;
mod invariants;
mod questions;
mod readers;
mod store;
mod strategies;
