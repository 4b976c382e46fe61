//! What a reader of the audits found that each theorem says of which claim: `audited.tsv`, against which the table of theorems is compared.
//!
//! The table alone could say anything of a theorem. A row here ties its words in the table (claim, what it covers, clauses, scope, description) to the
//! statement that coqc checked, by a digest of both: where either changes, somebody has to read the statement again.

use super::{Theorem, digest_of};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The rows, in the words of [`row`].
pub fn audited_rows() -> &'static BTreeSet<&'static str> {
    static ROWS: OnceLock<BTreeSet<&'static str>> = OnceLock::new();
    ROWS.get_or_init(|| include_str!("../../coq/audited.tsv").lines().skip(1).collect())
}

/// The row that a theorem has in `audited.tsv` where nothing has changed since it was read: claim, theorem, axioms, what it covers, clauses, scope,
/// digest of the statement and digest of the description.
pub fn row(theorem: &Theorem) -> String {
    let statement = theorem.audited().map_or(String::new(), |(_, statement)| spaced(statement));
    let clauses: Vec<String> = theorem.clauses.iter().map(usize::to_string).collect();
    let scope = if theorem.whole { "all" } else { "instances" };
    [
        theorem.claim,
        &theorem.path(),
        theorem.axioms.words(),
        theorem.covers.word(),
        &clauses.join(","),
        scope,
        &short(&statement),
        &short(&theorem.part),
    ]
    .join("\t")
}

/// The text with each run of spaces as one.
fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The first 16 digits of the digest: nobody looks for collisions here.
fn short(text: &str) -> String {
    digest_of(text.as_bytes()).chars().take(16).collect()
}
