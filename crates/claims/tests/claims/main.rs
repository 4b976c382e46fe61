//! Every claim as recorded.

mod attempted;
mod attempts;
mod motion_attempts;
mod paley_runs;
mod reached;
mod recorded;
