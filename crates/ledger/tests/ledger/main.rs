//! Mirrors `src/`.

mod clauses;
mod judging;
mod lines;
mod runs;
