//! What a campaign is.

use arithmetic::{Cancelled, Progress};
use serde_json::Value;
use sha2::{Digest, Sha256};

/// Independent cases, counted from 0. What a case gives depends on the version of this program, the canonical text and the number of the
/// case, and on nothing else: not on the other cases, threads, machines or the clock.
pub trait Campaign: Sync {
    /// All that the results depend on, as a text: two campaigns with the same text are the same campaign.
    fn canonical(&self) -> String;

    /// Number of cases.
    fn cases(&self) -> u64;

    /// The result of one case.
    ///
    /// # Errors
    /// [`JobError`].
    fn run(&self, case: u64, progress: &dyn Progress) -> Result<Value, JobError>;
}

/// Why a case has no result.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum JobError {
    /// Told to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// What was asked makes no sense there; the campaign ends.
    #[error("{0}")]
    Refused(String),
}

/// A short name of a canonical text, for messages: the first 12 digits of its SHA-256.
pub fn digest(canonical: &str) -> String {
    Sha256::digest(canonical.as_bytes()).iter().take(6).map(|byte| format!("{byte:02x}")).collect()
}
