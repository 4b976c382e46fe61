//! Every claim as recorded.

mod paley_runs;
mod recorded;
mod seeds;
