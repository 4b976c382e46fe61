//! Averaging on geometric graphs (Chazelle's model D): the transition matrix, its stationary distribution and how fast
//! its powers converge, the distance rule, the hysteresis rule and flocks stepped exactly.

mod affine;
mod contraction;
mod flock;
mod hysteresis;
mod modes;
mod motion;
mod observe;
pub mod read;
pub mod settle;
mod stationary;

pub use affine::{Affine, HalfOpenRange};
pub use contraction::{Contraction, contraction};
pub use flock::{Flock, Start, Switch};
pub use hysteresis::Hysteresis;
pub use modes::{Mode, rational_modes};
pub use motion::{State, motion};
pub use observe::{Decay, Observer};
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
    /// `c_i` for bird `i` (from 0) with this many neighbours; `None` where no weight was given.
    pub fn of(&self, degree: usize, i: usize) -> Option<Rational> {
        let degree = degree as i64;
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
            .map(|i| self.of(graph.degree(i), i).ok_or(MatrixError::EntryCount { rows: order, cols: 1, found: i }))
            .collect()
    }

    /// The weights of these birds, which become `0, 1, ...` in the order given.
    pub fn restricted(&self, birds: &[usize]) -> Self {
        match self {
            Weights::Given(c) => Weights::Given(birds.iter().filter_map(|&i| c.get(i)).cloned().collect()),
            other => other.clone(),
        }
    }

    /// Whether `0 < c_i d_i < 1` for every bird with neighbours (the condition of model D).
    pub fn are_admissible(&self, graph: &Graph) -> bool {
        (0..graph.order()).filter(|&i| graph.degree(i) > 0).all(|i| {
            self.of(graph.degree(i), i).is_some_and(|c| {
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

/// What is run: equations, order of updates, and how each ambiguous word of the rule is read.
pub fn declaration(flock: &Flock) -> String {
    let weights = match flock.weights() {
        Weights::Lazy => "c_i = 2/(3 d_i)".to_string(),
        Weights::Vicsek => "c_i = 1/(d_i + 1)".to_string(),
        Weights::Given(c) => format!("c = ({})", c.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
    };
    let hysteresis = match flock.hysteresis() {
        Hysteresis::None => "no hysteresis".to_string(),
        Hysteresis::Constant(threshold) => held(&threshold.to_string()),
        Hysteresis::Paper => held(&format!("{0}^(-{0}^4)", flock.birds())),
    };
    format!(
        "model D, {} birds in dimension {}: for t = 1, 2, ..\n\
         x(t) = x(t-1) + v(t); then G_t: edge i-j if |x_i(t) - x_j(t)| <= 1;\n\
         then v_i(t+1) = v_i(t) + c_i sum over neighbours in G_t of (v_j(t) - v_i(t)), {weights};\n\
         {hysteresis};\n\
         G_0 by distance alone; a bird without neighbours keeps its velocity.",
        flock.birds(),
        flock.dimension()
    )
}

fn held(threshold: &str) -> String {
    format!(
        "hysteresis: an edge of G_(t-1), however it came about, stays in G_t where\n\
         | |x_i(t) - x_j(t)| - |x_i(t-1) - x_j(t-1)| | < {threshold}, strictly"
    )
}

/// Why a flock is refused or cannot go on. Birds are counted from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FlockError {
    /// No birds, or birds in no dimension.
    #[error("a flock needs at least one bird with at least one coordinate")]
    NoBirds,
    /// Not as many velocities as positions.
    #[error("there are {birds} positions but {found} velocities")]
    Velocities {
        /// Number of positions.
        birds: usize,
        /// Number of velocities.
        found: usize,
    },
    /// A position or velocity of another dimension.
    #[error("the {what} of bird {bird} has {found} coordinates instead of {dimension}")]
    Coordinates {
        /// `position` or `velocity`.
        what: &'static str,
        /// The bird.
        bird: usize,
        /// Dimension of the first position.
        dimension: usize,
        /// Coordinates found.
        found: usize,
    },
    /// Fewer given weights than birds.
    #[error("there are {birds} birds but no weight c_{bird}")]
    Weights {
        /// Number of birds.
        birds: usize,
        /// The first bird without one.
        bird: usize,
    },
    /// `0 < c_i d_i < 1` fails.
    #[error("bird {bird} with {degree} neighbours has c = {c} (at t = {time}), but model D needs 0 < c d < 1")]
    Inadmissible {
        /// The bird.
        bird: usize,
        /// Its number of neighbours.
        degree: usize,
        /// Its weight.
        c: String,
        /// The time.
        time: String,
    },
    /// A threshold below zero.
    #[error("the hysteresis threshold {0} is negative")]
    NegativeHysteresis(String),
    /// A threshold that would fill the memory.
    #[error("a comparison needs the hysteresis threshold exactly, but it has {bits:.3e} bits")]
    ThresholdTooLong {
        /// Its length.
        bits: f64,
    },
}
