//! Every claim as recorded.

mod attempts;
mod motion_attempts;
mod paley_runs;
mod recorded;
