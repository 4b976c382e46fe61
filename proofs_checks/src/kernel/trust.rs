//! What is taken on trust of a development: sources, the table of theorems, what was audited and the transcript, and which theorems count by them.

use super::audited::row_with;
use super::statements::{Meanings, Stated, stated_in};
use super::{Source, Theorem, Transcript, audited_rows, files, recorded, theorems, with_digests};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// A development.
#[derive(Debug, Clone)]
pub struct Development {
    files: Vec<Source>,
    /// What the audits state, by their places among the files; read where it is first asked for, as are the meanings.
    stated: OnceLock<BTreeMap<usize, Vec<Stated>>>,
    meanings: OnceLock<Meanings>,
    /// The rows of `theorems.tsv`.
    pub theorems: Vec<Theorem>,
    /// The rows of `audited.tsv`.
    pub audited: BTreeSet<&'static str>,
    /// What coqc said.
    pub transcript: Transcript,
}

impl Development {
    /// The one that comes with the program.
    pub fn own() -> &'static Development {
        static OWN: OnceLock<Development> = OnceLock::new();
        OWN.get_or_init(|| {
            Development::new(files().to_vec(), theorems().to_vec(), audited_rows().clone(), recorded().clone())
        })
    }

    /// The same with other sources, names and texts in an order in which they compile.
    pub fn with_sources(&self, sources: &[(&'static str, &'static str)]) -> Self {
        let Development { theorems, audited, transcript, .. } = self.clone();
        Development::new(with_digests(sources), theorems, audited, transcript)
    }

    fn new(
        files: Vec<Source>,
        theorems: Vec<Theorem>,
        audited: BTreeSet<&'static str>,
        transcript: Transcript,
    ) -> Self {
        Development { meanings: OnceLock::new(), stated: OnceLock::new(), files, theorems, audited, transcript }
    }

    /// The sources, what a file needs before it.
    pub fn files(&self) -> &[Source] {
        &self.files
    }

    fn stated(&self) -> &BTreeMap<usize, Vec<Stated>> {
        self.stated.get_or_init(|| {
            let audits = self.files.iter().enumerate().filter(|(_, file)| file.name.starts_with("audit"));
            audits.map(|(place, audit)| (place, stated_in(audit.text))).collect()
        })
    }

    /// The statement of a theorem as the audit writes it out again, and the audit it stands in.
    pub fn audited(&self, theorem: &Theorem) -> Option<(&Source, &'static str)> {
        self.stated().iter().find_map(|(&place, stated)| {
            let audit = self.files.get(place).filter(|audit| audit.needs.contains(&theorem.file))?;
            let by = |name: &str| stated.iter().find(|stated| stated.name == name);
            Some((audit, by(&theorem.path()).or_else(|| by(theorem.name))?.statement))
        })
    }

    /// The row that a theorem has in `audited.tsv` where nothing has changed since it was read: claim, theorem, axioms, what it covers, clauses, scope, and the digests of the
    /// statement, of the definitions behind it, and of the description.
    pub fn row(&self, theorem: &Theorem) -> String {
        match self.audited(theorem) {
            None => row_with(theorem, "", ""),
            Some((audit, statement)) => {
                let meanings = self.meanings.get_or_init(|| Meanings::of(&self.files));
                row_with(theorem, statement, &meanings.behind(statement, &self.behind(audit)))
            }
        }
    }

    /// A file and all that it needs.
    fn behind(&self, file: &Source) -> BTreeSet<&'static str> {
        let mut wanted = BTreeSet::from([file.name]);
        for file in self.files.iter().rev() {
            if wanted.contains(file.name) {
                wanted.extend(&file.needs);
            }
        }
        wanted
    }

    /// Whether the transcript holds a theorem: for these sources, with these axioms; and whether its row in the table is one that was audited.
    pub fn is_checked(&self, theorem: &Theorem) -> bool {
        let Some((audit, _)) = self.audited(theorem) else { return false };
        let Some(file) = self.files.iter().find(|file| file.name == theorem.file) else { return false };
        let known = |source: &Source| self.transcript.digests.get(source.name) == Some(&source.digest);
        known(file)
            && known(audit)
            && self.transcript.theorems.get(&theorem.path()) == Some(&theorem.axioms)
            && self.audited.contains(self.row(theorem).as_str())
    }
}
