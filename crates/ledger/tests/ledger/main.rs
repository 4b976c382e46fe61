//! Mirrors `src/`.

mod clauses;
mod judging;
