//! Shards: cases spread over processes and machines, as files of JSON lines that are put together again.
//!
//! A shard `i/n` has the cases `i - 1, i - 1 + n, ..`. While it runs, every finished case is one line appended to
//! `shard-i-of-n.jsonl.part`, in the order in which they finish: a process killed at any moment loses at most what it had not finished, and
//! goes on from there. At the end the lines are sorted, written aside and renamed to `shard-i-of-n.jsonl`. The first line says what
//! the shard belongs to.

mod files;
mod merge;
mod run;

pub use files::{Header, Row, Shard, StoreError, aside};
pub use merge::{MERGED, Merged, merge};
pub use run::{Run, run_in_memory, run_shard};
