//! Mirrors `src/`.

extern crate flockproof_ledger as ledger;

mod clauses;
mod judging;
mod lines;
mod runs;
