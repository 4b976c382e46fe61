//! Mirrors `src/`.

mod judging;
