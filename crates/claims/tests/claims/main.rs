//! Every claim as recorded.

mod recorded;
mod seeds;
