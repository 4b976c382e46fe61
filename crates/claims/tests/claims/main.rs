//! Every claim as recorded.

mod attempts;
mod paley_runs;
mod recorded;
mod seeds;
