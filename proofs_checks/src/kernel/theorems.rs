//! The table of theorems and what they say.

use super::transcript::{AxiomSet, Transcript, recorded};
use super::{Source, audited_row, audited_rows, files};
use std::sync::OnceLock;

/// How much of a claim a theorem proves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Covers {
    /// The whole printed statement.
    Claim,
    /// A part of the printed statement that is true.
    Part,
    /// The corrected statement, or a part of it.
    Corrected,
    /// The negation of the printed statement.
    Negation,
    /// One instance of the statement: evidence of an exact computation, not of a proof for all parameters.
    Instance,
}

impl Covers {
    /// The word in the table.
    pub fn word(self) -> &'static str {
        match self {
            Covers::Claim => "claim",
            Covers::Part => "part",
            Covers::Corrected => "corrected",
            Covers::Negation => "negation",
            Covers::Instance => "instance",
        }
    }

    /// From the word in the table.
    pub fn parse(word: &str) -> Option<Self> {
        let all = [Covers::Claim, Covers::Part, Covers::Corrected, Covers::Negation, Covers::Instance];
        all.into_iter().find(|covers| covers.word() == word)
    }
}

/// A row of `theorems.tsv`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Theorem {
    /// The id of the claim.
    pub claim: &'static str,
    /// The file that proves it, without `.v`.
    pub file: &'static str,
    /// Its name.
    pub name: &'static str,
    /// The axioms it may rest on.
    pub axioms: AxiomSet,
    /// How much of the claim it proves.
    pub covers: Covers,
    /// The clauses that it states, counted from 1, of the printed statement or, for [`Covers::Corrected`], of the corrected one.
    pub clauses: Vec<usize>,
    /// Whether it states them for all their parameters with the hypotheses of the claim.
    pub whole: bool,
    /// What it proves, in words.
    pub part: String,
}

impl Theorem {
    /// `file.name`.
    pub fn path(&self) -> String {
        format!("{}.{}", self.file, self.name)
    }

    /// The statement as the audit writes it out again, and the audit it stands in.
    pub fn audited(&self) -> Option<(&'static Source, &'static str)> {
        files().iter().filter(|file| file.name.starts_with("audit")).find_map(|audit| {
            let statement = stated(audit.text, &self.path()).or_else(|| stated(audit.text, self.name))?;
            audit.needs.contains(&self.file).then_some((audit, statement))
        })
    }

    /// Whether the transcript holds it: for these sources, with these axioms; and whether its row in the table is the one that was audited.
    pub fn is_checked(&self) -> bool {
        self.is_checked_by(recorded())
    }

    /// The same for another transcript.
    pub fn is_checked_by(&self, transcript: &Transcript) -> bool {
        let Some((audit, _)) = self.audited() else { return false };
        let Some(file) = files().iter().find(|file| file.name == self.file) else { return false };
        let known =
            |source: &Source| transcript.digests.get(source.name).is_some_and(|digest| *digest == source.digest);
        known(file)
            && known(audit)
            && transcript.theorems.get(&self.path()) == Some(&self.axioms)
            && audited_rows().contains(audited_row(self).as_str())
    }
}

/// Every theorem that closes a claim or a part of one.
pub fn theorems() -> &'static [Theorem] {
    static THEOREMS: OnceLock<Vec<Theorem>> = OnceLock::new();
    THEOREMS.get_or_init(|| {
        let table = include_str!("../../coq/theorems.tsv");
        table.lines().skip(1).filter_map(parse_row).collect()
    })
}

fn parse_row(line: &'static str) -> Option<Theorem> {
    let [claim, file, name, axioms, covers, clauses, scope, part] =
        line.split('\t').collect::<Vec<_>>().try_into().ok()?;
    let (axioms, covers) = (AxiomSet::parse(axioms)?, Covers::parse(covers)?);
    let clauses = clauses.split(',').map(|k| k.parse().ok()).collect::<Option<_>>()?;
    let whole = match scope {
        "all" => true,
        "instances" => false,
        _ => return None,
    };
    Some(Theorem { claim, file, name, axioms, covers, clauses, whole, part: part.to_string() })
}

/// The statement in `Check (name : statement).`
fn stated(text: &'static str, name: &str) -> Option<&'static str> {
    text.match_indices("Check").find_map(|(at, word)| {
        let rest = text[at + word.len()..].trim_start().strip_prefix('(')?.trim_start().trim_start_matches('@');
        let statement = rest.strip_prefix(name)?.trim_start().strip_prefix(':')?;
        Some(statement[..closing(statement)?].trim())
    })
}

/// Where the parenthesis closes that was opened before `text`.
fn closing(text: &str) -> Option<usize> {
    let mut open = 1usize;
    for (at, c) in text.char_indices() {
        match c {
            '(' => open += 1,
            ')' => open -= 1,
            _ => {}
        }
        if open == 0 {
            return Some(at);
        }
    }
    None
}
