//! What a reader of the audits found that each theorem says of which claim: `audited.tsv`, against which the table of theorems is compared.
//!
//! The table alone could say anything of a theorem. A row here ties its words in the table (claim, what it covers, clauses, scope, description) to the
//! statement that coqc checked and to the definitions that give its words their meaning, by digests: where one of them changes, somebody has to read the statement again.

use super::statements::spaced;
use super::{Theorem, digest_of};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The rows, in the words of [`Development::row`](super::Development::row).
pub fn audited_rows() -> &'static BTreeSet<&'static str> {
    static ROWS: OnceLock<BTreeSet<&'static str>> = OnceLock::new();
    ROWS.get_or_init(|| include_str!("../../coq/audited.tsv").lines().skip(1).collect())
}

/// The row of a theorem: claim, theorem, axioms, what it covers, clauses, scope, and the digests of the statement, of the definitions behind it and of the description.
pub(super) fn row_with(theorem: &Theorem, statement: &str, meaning: &str) -> String {
    let clauses: Vec<String> = theorem.clauses.iter().map(usize::to_string).collect();
    let scope = if theorem.whole { "all" } else { "instances" };
    [
        theorem.claim,
        &theorem.path(),
        theorem.axioms.words(),
        theorem.covers.word(),
        &clauses.join(","),
        scope,
        &short(&spaced(statement)),
        &short(meaning),
        &short(&theorem.part),
    ]
    .join("\t")
}

/// The first 16 digits of the digest: nobody looks for collisions here.
fn short(text: &str) -> String {
    digest_of(text.as_bytes()).chars().take(16).collect()
}
