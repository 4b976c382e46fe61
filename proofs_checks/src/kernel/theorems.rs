//! The table of theorems and what they say.

use super::transcript::AxiomSet;
use super::{Development, Source};
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
        Development::own().audited(self)
    }

    /// Whether it counts ([`Development::is_checked`]).
    pub fn is_checked(&self) -> bool {
        Development::own().is_checked(self)
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
