//! Which claims, theorems and figures belong together: found in what the program holds, not typed.

use super::texts::Names;
use ledger::{Entry, correction_id};
use proofs::kernel::theorems;
use std::collections::{BTreeMap, BTreeSet};

/// Why two claims are neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Tie {
    /// The other is the corrected statement of the first.
    CorrectedBy,
    /// The first is the corrected statement of the other.
    Corrects,
    /// The place of the first names the place of the other.
    Sharpens,
    /// The place of the other names the place of the first.
    SharpenedBy,
    /// The first names the other.
    Names,
    /// The other names the first.
    NamedBy,
    /// One Coq theorem is about both.
    SharesTheorem,
}

impl Tie {
    pub fn words(self) -> &'static str {
        match self {
            Tie::CorrectedBy => "corrected by",
            Tie::Corrects => "corrects",
            Tie::Sharpens => "goes beyond",
            Tie::SharpenedBy => "carried further by",
            Tie::Names => "refers to",
            Tie::NamedBy => "referred to by",
            Tie::SharesTheorem => "shares a Coq theorem with",
        }
    }
}

/// The ties of every claim.
pub(super) type Ties = BTreeMap<String, BTreeSet<(Tie, String)>>;

/// All ties among the entries; `derivation` gives the argument behind one.
pub(super) fn ties<'a>(entries: &'a [Entry], names: &Names, derivation: impl Fn(&str) -> Option<&'a str>) -> Ties {
    let mut ties = Ties::new();
    let mut tie = |from: &str, there: Tie, back: Tie, to: &str| {
        if from != to {
            ties.entry(from.to_string()).or_default().insert((there, to.to_string()));
            ties.entry(to.to_string()).or_default().insert((back, from.to_string()));
        }
    };
    for entry in entries {
        let id = entry.id.as_str();
        let correction = correction_id(id);
        if names.claims.contains(&correction) {
            tie(id, Tie::CorrectedBy, Tie::Corrects, &correction);
        }
        for other in beyond(entry, entries).filter(|other| correction_id(&other.id) != id) {
            tie(id, Tie::Sharpens, Tie::SharpenedBy, &other.id);
        }
        let texts = texts(entry).chain(derivation(id));
        let named: BTreeSet<&str> = texts.flat_map(|text| names.claims_in(text)).collect();
        for other in named {
            let is_pair = correction_id(other) == id || correction == other;
            if !is_pair {
                tie(id, Tie::Names, Tie::NamedBy, other);
            }
        }
    }
    let mut by_theorem: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    for theorem in theorems().iter().filter(|theorem| names.claims.contains(theorem.claim)) {
        by_theorem.entry(theorem.path()).or_default().insert(theorem.claim);
    }
    for claims in by_theorem.values() {
        for (k, one) in claims.iter().enumerate() {
            for other in claims.iter().skip(k + 1) {
                tie(one, Tie::SharesTheorem, Tie::SharesTheorem, other);
            }
        }
    }
    ties
}

/// Everything an entry says.
fn texts(entry: &Entry) -> impl Iterator<Item = &str> {
    let some = [&entry.reading, &entry.corrected, &entry.counterexample, &entry.why];
    let evidence = entry.evidence.iter().flat_map(|e| [e.part.as_str(), e.detail.as_str()]);
    let controls = entry.controls.what.iter().chain(&entry.controls.failed).map(String::as_str);
    some.into_iter()
        .flatten()
        .map(String::as_str)
        .chain(entry.clauses.iter().map(String::as_str))
        .chain(evidence)
        .chain(controls)
}

/// The printed claims at the place that a result of our own names: `sharpens chazelle, Lemma 3.7`.
fn beyond<'a>(entry: &Entry, entries: &'a [Entry]) -> impl Iterator<Item = &'a Entry> {
    let named = (entry.paper == "beyond").then(|| entry.place.split_once(", ")).flatten();
    let named = named.and_then(|(verb, place)| Some((verb.split(' ').next_back()?.to_string(), place.to_string())));
    entries.iter().filter(move |other| {
        named.as_ref().is_some_and(|(paper, place)| {
            let rest = other.place.strip_prefix(place.as_str());
            other.paper == *paper
                && rest.is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '.'))
        })
    })
}
