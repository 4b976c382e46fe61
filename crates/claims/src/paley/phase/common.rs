//! Phases and graphs that several claims are tried on.

use crate::prelude::*;
use algebra::graph::{LaplacianKind, NameError, NamedGraph, WeightedGraph};
use algebra::matrix::SparseMatrix;
use arithmetic::{CosineField, RealCyclotomic};
use models::oscillator::phasor;

/// Phasors of an arrangement, exact at multiples of parts of a turn.
pub type Exact = Vec<Complex<RealCyclotomic>>;

/// The phasors of the phases `2 arctan t_k`.
pub fn phasors<T: Field>(t: &[T]) -> Result<Vec<Complex<T>>, ArithmeticError> {
    t.iter().map(phasor).collect()
}

/// The phasors of the phases `2 pi k/parts`.
pub fn at(field: &CosineField, exponents: &[usize]) -> Exact {
    exponents.iter().map(|&k| field.phasor(k as i64)).collect()
}

/// All choices of `length` numbers below `base`, the first of which is 0: arrangements up to rotation.
pub fn up_to_rotation(length: usize, base: usize) -> impl Iterator<Item = Vec<usize>> {
    let count = base.pow(length.saturating_sub(1) as u32);
    (0..count).map(move |number| (0..length).map(|k| if k == 0 { 0 } else { digit(number, base, k - 1) }).collect())
}

fn digit(number: usize, base: usize, place: usize) -> usize {
    number / base.pow(place as u32) % base
}

/// Arrangements on the line: the last `minority` of the phasors are -1, the others 1.
pub fn on_the_line(particles: usize, minority: usize) -> Vec<Complex<Rational>> {
    let sign = |k: usize| if k + minority < particles { 1 } else { -1 };
    (0..particles).map(|k| Complex::real(rational(sign(k), 1))).collect()
}

/// The graph of that name.
pub fn named(text: &str) -> Result<WeightedGraph, CheckError> {
    let other = |error: NameError| CheckError::Other(error.to_string());
    text.parse::<NamedGraph>().and_then(|graph| graph.build()).map_err(other)
}

/// The complete graph on so many nodes.
pub fn complete(particles: usize) -> WeightedGraph {
    digraph(particles, |_, _| true)
}

/// The digraph in which `j` is a neighbour of `k` where `neighbour(k, j)`.
pub fn digraph(order: usize, neighbour: impl Fn(usize, usize) -> bool) -> WeightedGraph {
    let pairs = (0..order * order).map(|k| (k / order, k % order));
    let arcs = pairs.filter(|&(k, j)| k != j && neighbour(k, j));
    WeightedGraph::from_arcs(order, arcs.map(|(k, j)| (k, j, rational(1, 1))))
}

/// All digraphs without loops on so many nodes.
pub fn digraphs(order: usize) -> impl Iterator<Item = WeightedGraph> {
    let pairs = order * order.saturating_sub(1);
    let place = move |k: usize, j: usize| k * (order - 1) + if j > k { j - 1 } else { j };
    (0u64..1 << pairs).map(move |bits| digraph(order, |k, j| bits >> place(k, j) & 1 == 1))
}

/// The circulant digraphs on `order` nodes, each with its offsets `s`: `k + s` is a neighbour of `k`. With `undirected` those whose
/// offsets are symmetric.
pub fn circulants(order: usize, undirected: bool) -> Vec<(Vec<usize>, WeightedGraph)> {
    let offsets = |bits: usize| (1..order).filter(|s| bits >> (s - 1) & 1 == 1).collect::<Vec<usize>>();
    let symmetric = |offsets: &[usize]| offsets.iter().all(|s| offsets.contains(&(order - s)));
    let all = (0..1usize << (order - 1)).map(offsets).filter(|offsets| !undirected || symmetric(offsets));
    all.map(|offsets| {
        let graph = digraph(order, |k, j| offsets.contains(&((j + order - k) % order)));
        (offsets, graph)
    })
    .collect()
}

/// `D - A` with the numbers of neighbours in `D`.
pub fn laplacian(graph: &WeightedGraph) -> Result<SparseMatrix, CheckError> {
    graph.matrix(LaplacianKind::OutDegree).map_err(|error| CheckError::Other(error.to_string()))
}

/// The arcs `k -> j` as text, nodes counted from 1.
pub fn arcs(graph: &WeightedGraph) -> String {
    let arcs: Vec<String> = graph.adjacency().entries().map(|(k, j, _)| format!("{}->{}", k + 1, j + 1)).collect();
    if arcs.is_empty() { "no arcs".to_string() } else { arcs.join(" ") }
}

/// A phase arrangement as text, in parts of a turn.
pub fn turns(exponents: &[usize], parts: usize) -> String {
    let phases: Vec<String> = exponents.iter().map(|k| format!("{k}/{parts}")).collect();
    format!("phases ({}) turns", phases.join(", "))
}

/// `sum over arcs of a_kj |x_k - x_j|^2`.
pub fn squared_lengths<T: Field>(graph: &WeightedGraph, x: &[Complex<T>], zero: &T) -> T {
    graph
        .adjacency()
        .entries()
        .fold(zero.zero(), |sum, (k, j, weight)| sum + (x[k].clone() - &x[j]).norm_squared() * zero.rational(weight))
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
