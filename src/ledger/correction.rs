//! The corrected statement of a claim as a claim of its own.

use super::{AnyClaim, Entry, Run, Source};
use std::sync::Arc;

/// The id of the correction of a claim: `beyond.paley.eq21` for `paley.eq21`.
pub fn correction_id(of: &str) -> String {
    format!("beyond.{of}")
}

/// A claim whose printed form fails, in its corrected form.
pub(super) struct Correction {
    of: Arc<dyn AnyClaim>,
    id: String,
    source: Source,
}

impl Correction {
    /// The correction of a claim that stands at this source; `None` where it has none.
    pub fn of(claim: &Arc<dyn AnyClaim>, printed: &Source) -> Option<Self> {
        let paper = claim.id().split('.').next().unwrap_or_default();
        let source = Source { place: format!("corrects {paper}, {}", printed.place), statement: claim.corrected()? };
        Some(Correction { of: claim.clone(), id: correction_id(claim.id()), source })
    }
}

impl AnyClaim for Correction {
    fn id(&self) -> &str {
        &self.id
    }
    fn source(&self) -> Option<Source> {
        Some(self.source.clone())
    }
    fn corrected(&self) -> Option<String> {
        None
    }
    fn judge(&self, source: &Source, run: &mut Run) -> Entry {
        self.of.judge_correction(source, run)
    }
    fn judge_correction(&self, source: &Source, run: &mut Run) -> Entry {
        self.judge(source, run)
    }
}
