//! Mirrors `src/`.

mod clauses;
mod judging;
mod runs;
