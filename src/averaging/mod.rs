//! Averaging on geometric graphs (Chazelle's model D): the transition matrix, its stationary distribution and how fast
//! its powers converge, the distance rule and the hysteresis rule on the line.

mod affine;
mod contraction;
mod line;
mod modes;
mod motion;
mod stationary;

pub use affine::{Affine, HalfOpenRange};
pub use contraction::{Contraction, contraction};
pub use line::{LineFlock, distance_network};
pub use modes::{Mode, rational_modes};
pub use motion::{State, motion};
pub use stationary::{deviation_matrix, equal_rows, stationary_distribution};

use crate::arithmetic::{Rational, Ring, Signed, rational};
use crate::graph::Graph;
use crate::matrix::{MatrixError, RationalMatrix};

/// The weights `c_i` of the model: bird `i` moves its velocity towards each neighbour's by `c_i` times the difference.
#[derive(Debug, Clone, PartialEq)]
pub enum Weights {
    /// `c_i = 2/(3 d_i)`: a lazy random walk that stays with probability 1/3.
    Lazy,
    /// `c_i = 1/(d_i + 1)`: the mean of a bird and its neighbours.
    Vicsek,
    /// Given numbers.
    Given(Vec<Rational>),
}

impl Weights {
    fn of(&self, graph: &Graph, i: usize) -> Option<Rational> {
        let degree = graph.degree(i) as i64;
        match self {
            // A bird without neighbours has no term to weigh.
            Weights::Lazy => Some(rational(2, 3 * degree.max(1))),
            Weights::Vicsek => Some(rational(1, degree + 1)),
            Weights::Given(c) => c.get(i).cloned(),
        }
    }

    /// The weights `c_1, .., c_n` on a graph.
    ///
    /// # Errors
    /// [`MatrixError::EntryCount`] where fewer are given than there are vertices.
    pub fn all(&self, graph: &Graph) -> Result<Vec<Rational>, MatrixError> {
        let order = graph.order();
        (0..order)
            .map(|i| self.of(graph, i).ok_or(MatrixError::EntryCount { rows: order, cols: 1, found: i }))
            .collect()
    }

    /// Whether `0 < c_i d_i < 1` for every bird with neighbours (the condition of model D).
    pub fn are_admissible(&self, graph: &Graph) -> bool {
        (0..graph.order()).filter(|&i| graph.degree(i) > 0).all(|i| {
            self.of(graph, i).is_some_and(|c| {
                let share = c.integer(graph.degree(i) as i64) * c;
                share.is_certainly_positive() && (share.one() - &share).is_certainly_positive()
            })
        })
    }
}

/// `P = I - C L` with the combinatorial Laplacian `L = D - A` of the graph (Chazelle, section 1, model D).
///
/// # Errors
/// [`MatrixError`] for a graph without vertices or too few given weights.
pub fn transition_matrix(graph: &Graph, weights: &Weights) -> Result<RationalMatrix, MatrixError> {
    let order = graph.order();
    let mut rows = Vec::with_capacity(order);
    for (i, c) in weights.all(graph)?.into_iter().enumerate() {
        let entry = |j: usize| match (i == j, graph.has_edge(i, j)) {
            (true, _) => c.one() - c.integer(graph.degree(i) as i64) * &c,
            (false, true) => c.clone(),
            (false, false) => c.zero(),
        };
        rows.push((0..order).map(entry).collect());
    }
    RationalMatrix::from_rows(&rows)
}
