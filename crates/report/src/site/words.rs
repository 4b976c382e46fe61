//! Verdicts, faults, grades and reach in sentences.

use ledger::{Entry, Fault, Scope, Verdict};

/// The mark of a verdict, so that it is told without its colour.
pub(super) fn mark(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "✓",
        Verdict::NeedsHypothesis => "+",
        Verdict::Misprint => "≠",
        Verdict::False => "✗",
        Verdict::Undecided => "?",
        Verdict::NotCheckable => "–",
    }
}

/// The word of a verdict as it is read.
pub(super) fn spoken(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "holds",
        Verdict::NeedsHypothesis => "needs a hypothesis",
        Verdict::Misprint => "misprint",
        Verdict::False => "false",
        Verdict::Undecided => "undecided",
        Verdict::NotCheckable => "not checkable",
    }
}

/// The verdict in one sentence.
pub(super) fn sentence(entry: &Entry) -> String {
    let own = entry.paper == "beyond";
    let (whole, clauses) = entry.reach();
    match (entry.verdict, entry.fault) {
        (Verdict::Holds, _) => {
            let what = if own { "True as stated" } else { "True as printed" };
            let how = match (whole, clauses) {
                (0, 1) => "checked on instances".to_string(),
                (1, 1) => "for all parameters".to_string(),
                (w, c) if w == c => format!("all {c} clauses for all parameters"),
                (0, c) => format!("all {c} clauses checked on instances"),
                (w, c) => format!("{w} of {c} clauses for all parameters, the others on instances"),
            };
            format!("{what}: {how}.")
        }
        (Verdict::NeedsHypothesis, _) => {
            "Fails as printed, at the counterexample below: a hypothesis is missing. True with it.".to_string()
        }
        (Verdict::Misprint, Some(Fault::Typo)) => {
            "Fails as printed, at the counterexample below; the intended text is evident.".to_string()
        }
        (Verdict::Misprint, _) => {
            "Fails as printed, at the counterexample below; a step is wrong, and the use that is made of it survives."
                .to_string()
        }
        (Verdict::False, _) => "False: it fails within its own hypotheses, at the counterexample below.".to_string(),
        (Verdict::Undecided, _) => "Neither could be established.".to_string(),
        (Verdict::NotCheckable, _) => match entry.clauses_that_hold().as_slice() {
            [] => "There is nothing to check.".to_string(),
            [k] => format!("Clause {k} holds; of the others nothing can be checked."),
            several => format!("{} clauses hold; of the others nothing can be checked.", several.len()),
        },
    }
}

/// What a fault is.
pub(super) fn fault(fault: Fault) -> &'static str {
    match fault {
        Fault::Hypothesis => "a hypothesis that is not stated",
        Fault::Typo => "a misprint",
        Fault::Slip => "a slip in a step",
        Fault::False => "the mathematics",
    }
}

/// How far a piece of evidence reaches.
pub(super) fn reach(scope: Option<Scope>) -> &'static str {
    match scope {
        Some(Scope::All) => "all parameters",
        Some(Scope::Instances) => "instances",
        None => "",
    }
}

/// The key by which the list is filtered by how far the evidence reaches.
pub(super) fn scope_key(entry: &Entry) -> &'static str {
    let (all, some) = (entry.covered(true).len(), entry.covered(false).len());
    match () {
        () if some == 0 => "none",
        () if all == entry.clauses.len() => "all",
        () if all > 0 => "part",
        () => "instances",
    }
}
