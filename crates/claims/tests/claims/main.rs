//! Every claim as recorded.

mod motion_attempts;
mod paley_runs;
mod recorded;
mod seeds;
