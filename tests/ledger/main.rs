//! Mirrors `src/ledger` and `src/claims`.

mod judging;
mod recorded;
mod seeds;
