//! Arrangements of phases: exact ones at parts of a turn, all of a size, those on a line.

use algebra::graph::WeightedGraph;
use arithmetic::{ArithmeticError, Complex, CosineField, Field, Rational, RealCyclotomic, rational, words};

use super::state::phasor;

/// Phasors of an arrangement, exact at multiples of parts of a turn.
pub type ExactPhasors = Vec<Complex<RealCyclotomic>>;

/// The phasors of the phases `2 arctan t_k`.
///
/// # Errors
/// As for [`phasor`].
pub fn phasors<T: Field>(t: &[T]) -> Result<Vec<Complex<T>>, ArithmeticError> {
    t.iter().map(phasor).collect()
}

/// The phasors of the phases `2 pi k/parts`, in the field of those parts.
pub fn exact_phasors(field: &CosineField, exponents: &[usize]) -> ExactPhasors {
    exponents.iter().map(|&k| field.phasor(k as i64)).collect()
}

/// The column `m` of the Fourier matrix of so many nodes, counted from 0, without its factor: the phases `2 pi m k/nodes`, in the field of
/// as many parts of a turn.
pub fn fourier_column(field: &CosineField, nodes: usize, m: usize) -> ExactPhasors {
    exact_phasors(field, &(0..nodes).map(|k| m * k % nodes).collect::<Vec<_>>())
}

/// All choices of `length` numbers below `base`, the first of which is 0: arrangements of phases at multiples of parts of a turn, up to
/// rotation.
pub fn up_to_rotation(length: usize, base: usize) -> impl Iterator<Item = Vec<usize>> {
    words(base, length.saturating_sub(1)).map(move |rest| std::iter::once(0).chain(rest).take(length).collect())
}

/// Phases on a line: the last `minority` of the phasors are -1, the others 1.
pub fn on_the_line(particles: usize, minority: usize) -> Vec<Complex<Rational>> {
    let sign = |k: usize| if k + minority < particles { 1 } else { -1 };
    (0..particles).map(|k| Complex::real(rational(sign(k), 1))).collect()
}

/// An arrangement in words, in parts of a turn.
pub fn in_turns(exponents: &[usize], parts: usize) -> String {
    let phases: Vec<String> = exponents.iter().map(|k| format!("{k}/{parts}")).collect();
    format!("phases ({}) turns", phases.join(", "))
}

/// `sum over arcs of a_kj |x_k - x_j|^2`, over the arcs between entries of `x`.
pub fn squared_lengths<T: Field>(graph: &WeightedGraph, x: &[Complex<T>], like: &T) -> T {
    let there = graph.adjacency().entries().filter_map(|(k, j, weight)| Some((x.get(k)?, x.get(j)?, weight)));
    there.fold(like.zero(), |sum, (a, b, weight)| sum + (a.clone() - b).norm_squared() * like.rational(weight))
}
