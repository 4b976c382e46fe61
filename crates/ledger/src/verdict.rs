//! What a verdict can be, and what the fault of a statement that fails.

use serde::{Deserialize, Serialize};

/// The verdict on a claim as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The printed claim holds.
    Holds,
    /// It fails only where a hypothesis is missing that the paper does not state; true with it.
    NeedsHypothesis,
    /// It fails as printed; the intended text is evident, or a wrong step does not touch the use made of it.
    Misprint,
    /// The mathematics is wrong: a counterexample within the paper's own hypotheses and standing conventions.
    False,
    /// Neither could be established.
    Undecided,
    /// There is nothing that could be checked.
    NotCheckable,
}

impl Verdict {
    /// All verdicts, in the order of a summary.
    pub const ALL: [Verdict; 6] = [
        Verdict::Holds,
        Verdict::NeedsHypothesis,
        Verdict::Misprint,
        Verdict::False,
        Verdict::Undecided,
        Verdict::NotCheckable,
    ];

    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::NeedsHypothesis => "needs_hypothesis",
            Verdict::Misprint => "misprint",
            Verdict::False => "false",
            Verdict::Undecided => "undecided",
            Verdict::NotCheckable => "not_checkable",
        }
    }
}

/// What is wrong with a printed claim that fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// A hypothesis is missing that the paper does not state (a degenerate size, connectedness); true with it.
    Hypothesis,
    /// The intended text is evident.
    Typo,
    /// A step of algebra or an estimate is wrong, and the use made of it survives.
    Slip,
    /// The mathematics is wrong.
    False,
}

impl Fault {
    /// The verdict on a statement with this fault.
    pub fn verdict(self) -> Verdict {
        match self {
            Fault::Hypothesis => Verdict::NeedsHypothesis,
            Fault::Typo | Fault::Slip => Verdict::Misprint,
            Fault::False => Verdict::False,
        }
    }

    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Fault::Hypothesis => "hypothesis",
            Fault::Typo => "typo",
            Fault::Slip => "slip",
            Fault::False => "false",
        }
    }
}
