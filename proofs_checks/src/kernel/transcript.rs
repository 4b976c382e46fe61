//! What coqc said: digests of what it compiled and the axioms under each theorem.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::OnceLock;

/// The axioms a theorem rests on. Everything is from Coq's standard library.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum AxiomSet {
    /// No axiom.
    None,
    /// Those of the real numbers: two decision principles for sequences of propositions, and functional extensionality.
    Reals,
    /// Those of the real numbers and the excluded middle.
    RealsAndClassic,
}

/// Axioms of [`AxiomSet::Reals`].
const REALS: [&str; 3] = [
    "Coq.Reals.ClassicalDedekindReals.sig_not_dec",
    "Coq.Reals.ClassicalDedekindReals.sig_forall_dec",
    "Coq.Logic.FunctionalExtensionality.functional_extensionality_dep",
];

/// The axiom of [`AxiomSet::RealsAndClassic`] beside them.
const CLASSIC: &str = "Coq.Logic.Classical_Prop.classic";

impl AxiomSet {
    /// The word in the tables.
    pub fn words(self) -> &'static str {
        match self {
            AxiomSet::None => "none",
            AxiomSet::Reals => "reals",
            AxiomSet::RealsAndClassic => "reals+classic",
        }
    }

    /// From the word in the tables.
    pub fn parse(word: &str) -> Option<Self> {
        [AxiomSet::None, AxiomSet::Reals, AxiomSet::RealsAndClassic].into_iter().find(|set| set.words() == word)
    }

    /// The smallest set that holds all of these axioms, given by their full names: that of the library, of its file and their own.
    ///
    /// # Errors
    /// The name of an axiom that no set allows.
    pub fn of<'a>(axioms: impl IntoIterator<Item = &'a str>) -> Result<Self, String> {
        let mut sets = axioms.into_iter().map(|axiom| match axiom {
            CLASSIC => Ok(AxiomSet::RealsAndClassic),
            _ if REALS.contains(&axiom) => Ok(AxiomSet::Reals),
            _ => Err(axiom.to_string()),
        });
        sets.try_fold(AxiomSet::None, |all, set| Ok(all.max(set?)))
    }
}

/// What coqc said of a development.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Transcript {
    /// The version of Coq.
    pub coq: String,
    /// Digest of each file that compiled, by name.
    pub digests: BTreeMap<String, String>,
    /// Axioms of each theorem, by `file.name`.
    pub theorems: BTreeMap<String, AxiomSet>,
}

impl Transcript {
    /// Reads what [`Transcript::text`] writes; lines of any other form are passed over.
    pub fn parse(text: &str) -> Self {
        let mut transcript = Transcript::default();
        for line in text.lines() {
            match line.split_whitespace().collect::<Vec<_>>()[..] {
                ["coq", version] => transcript.coq = version.to_string(),
                ["file", name, digest] => {
                    transcript.digests.insert(name.to_string(), digest.to_string());
                }
                ["theorem", path, axioms] => {
                    if let Some(axioms) = AxiomSet::parse(axioms) {
                        transcript.theorems.insert(path.to_string(), axioms);
                    }
                }
                _ => {}
            }
        }
        transcript
    }

    /// Whether it has everything that the other one says of files and theorems.
    pub fn contains(&self, other: &Transcript) -> bool {
        other.digests.iter().all(|(name, digest)| self.digests.get(name) == Some(digest))
            && other.theorems.iter().all(|(path, axioms)| self.theorems.get(path) == Some(axioms))
    }

    /// As a file.
    pub fn text(&self) -> String {
        let mut text = String::from("# What coqc said; written by `flockproof prove --transcript FILE`.\n");
        // Writing to a string cannot fail.
        let _ = writeln!(text, "coq {}", self.coq);
        for (name, digest) in &self.digests {
            let _ = writeln!(text, "file {name} {digest}");
        }
        for (path, axioms) in &self.theorems {
            let _ = writeln!(text, "theorem {path} {}", axioms.words());
        }
        text
    }
}

/// The transcript that comes with the program.
pub fn recorded() -> &'static Transcript {
    static RECORDED: OnceLock<Transcript> = OnceLock::new();
    RECORDED.get_or_init(|| Transcript::parse(include_str!("../../coq/transcript.txt")))
}
