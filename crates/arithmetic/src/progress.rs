//! Cancellation and progress of long work: one argument, the same everywhere.

/// What long work is given: it asks often whether to stop, and tells how far it is. [`Unwatched`] neither stops nor listens.
pub trait Progress: Sync {
    /// Whether the work should stop. Asked at least every few milliseconds.
    fn is_cancelled(&self) -> bool;

    /// `done` of `total` steps of the named stage are finished; `total` is `None` where it is not known.
    fn tell(&self, _stage: &str, _done: u64, _total: Option<u64>) {}

    /// [`Progress::is_cancelled`] as a result, for `?` inside loops.
    ///
    /// # Errors
    /// [`Cancelled`].
    fn checkpoint(&self) -> Result<(), Cancelled> {
        if self.is_cancelled() { Err(Cancelled) } else { Ok(()) }
    }
}

/// Work that nobody watches: it runs to its end.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Progress for Unwatched {
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// The work was asked to stop before its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("interrupted")]
pub struct Cancelled;
