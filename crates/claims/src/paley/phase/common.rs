//! What several claims about phases share: named graphs and their Laplacians, identities in phases, how sizes are read.

use crate::prelude::*;
use algebra::graph::{LaplacianKind, NamedGraph, WeightedGraph};
use algebra::matrix::SparseMatrix;

/// The graph of that name.
pub fn named(text: &str) -> Result<WeightedGraph, CheckError> {
    Ok(text.parse::<NamedGraph>()?.build()?)
}

/// `D - A` with the numbers of neighbours in `D`.
pub fn laplacian(graph: &WeightedGraph) -> Result<SparseMatrix, CheckError> {
    Ok(graph.matrix(LaplacianKind::OutDegree)?)
}

/// The arcs `k -> j` as text, nodes counted from 1.
pub fn arcs_of(graph: &WeightedGraph) -> Witness {
    let arcs = graph.adjacency().entries().map(|(k, j, _)| (k, j)).collect();
    Witness::Networks { order: graph.order(), networks: vec![arcs], directed: true }
}

/// Phases in parts of a turn.
pub fn turns(exponents: &[usize], parts: usize) -> Witness {
    let turns = exponents.iter().map(|k| ledger::Number(rational(*k as i64, parts as i64))).collect();
    Witness::Phases { turns }
}

/// Its arcs in words.
pub fn arcs(graph: &WeightedGraph) -> String {
    let arcs: Vec<String> = graph.adjacency().entries().map(|(k, j, _)| format!("{}->{}", k + 1, j + 1)).collect();
    if arcs.is_empty() { "no arcs".to_string() } else { arcs.join(" ") }
}

/// Tests identities in the half-angle tangents `t1, t2, ...` of the phases and `more` variables after them, each with the part that it
/// shows; evidence on these clauses.
pub fn identities<'a>(
    run: &Run,
    clauses: &[usize],
    more: &[&str],
    each: impl IntoIterator<Item = Result<(Identity<'a>, String), CheckError>>,
) -> Result<Outcome, CheckError> {
    let test = |item: Result<(Identity, String), CheckError>| {
        let (identity, part) = item?;
        let phases = identity.variables().saturating_sub(more.len());
        let names: Vec<String> = (1..=phases).map(|k| format!("t{k}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).chain(more.iter().copied()).collect();
        run.identity(&identity, &names, &part)
    };
    Run::all(each.into_iter().map(test)).on(clauses)
}

/// How sizes are read: the one rule for all claims of this paper.
pub const N_AT_LEAST_2: &str = "N >= 2, the sizes for which the paper states its goals";

/// The outcome with evidence on these clauses where it holds; a counterexample is one to the only clause of the printed statement.
pub fn supports(outcome: Outcome, clauses: &[usize]) -> Outcome {
    if matches!(outcome, Outcome::Holds(_)) { outcome.on(clauses) } else { outcome }
}

/// Whether the numbers are all zero.
pub fn all_zero<T: Ring + PartialEq>(numbers: &[T]) -> bool {
    numbers.iter().all(|x| *x == x.zero())
}

/// Whether the entries are all equal.
pub fn all_equal<T: PartialEq>(entries: &[T]) -> bool {
    entries.iter().all(|x| *x == entries[0])
}
