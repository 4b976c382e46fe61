//! The weights of the model, its transition matrix, and why a flock cannot be stepped.

use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{Cancelled, Rational, Ring, Signed, rational};

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
    /// Those with `c_i d_i` equal to this share for every bird with neighbours.
    pub fn of_share(graph: &Graph, share: &Rational) -> Self {
        let degree = |i: usize| rational(graph.degree(i).max(1) as i64, 1);
        Weights::Given((0..graph.order()).map(|i| share / degree(i)).collect())
    }

    /// Those with another share for every bird, `c_i d_i = i/(i+1)` with birds counted from 1.
    pub fn uneven(graph: &Graph) -> Self {
        let degree = |i: usize| graph.degree(i).max(1) as i64;
        Weights::Given((0..graph.order()).map(|i| rational(i as i64 + 1, (i as i64 + 2) * degree(i))).collect())
    }

    /// `c_i` for bird `i` (from 0) with this many neighbours; `None` where no weight was given, and for more neighbours than any graph has.
    pub fn of(&self, degree: usize, i: usize) -> Option<Rational> {
        let degree = i64::try_from(degree).ok()?;
        match self {
            // A bird without neighbours has no term to weigh.
            Weights::Lazy => Some(rational(2, degree.max(1).checked_mul(3)?)),
            Weights::Vicsek => Some(rational(1, degree.checked_add(1)?)),
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
    /// A network of another number of vertices.
    #[error("there are {birds} birds, but the network has {vertices} vertices")]
    Network {
        /// Number of birds.
        birds: usize,
        /// Number of vertices.
        vertices: usize,
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
    /// A threshold of the paper for so many birds that its exponent does not fit.
    #[error("the hysteresis threshold of the paper is too small to be enclosed for {birds} birds")]
    ThresholdTooSmall {
        /// Number of birds.
        birds: usize,
    },
    /// A control matrix of another shape.
    #[error("the control of model D is a matrix of {expected} x {expected}, not {rows} x {cols}")]
    Control {
        /// Birds times dimensions.
        expected: usize,
        /// Rows found.
        rows: usize,
        /// Columns found.
        cols: usize,
    },
    /// A speed that is not positive.
    #[error("the speed must be positive, but it is {0}")]
    Speed(String),
    /// Not as many headings as positions.
    #[error("there are {birds} positions but {found} headings")]
    Headings {
        /// Number of positions.
        birds: usize,
        /// Number of headings.
        found: usize,
    },
    /// A heading out of range.
    #[error("the heading {heading} of bird {bird} is not in [0, 2 pi)")]
    Heading {
        /// The bird.
        bird: usize,
        /// The heading.
        heading: String,
    },
    /// Not as many controls as birds.
    #[error("there are {birds} birds but {found} numbers in kappa")]
    Kappa {
        /// Number of birds.
        birds: usize,
        /// Number of controls.
        found: usize,
    },
    /// Stopped by the caller.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Too near to call.
    #[error("birds {} and {} at t = {time} are too near {against} to be decided with {bits} bits", pair.0, pair.1)]
    Undecided {
        /// The birds.
        pair: (usize, usize),
        /// The time.
        time: u64,
        /// What the distance, or its change, is compared with.
        against: &'static str,
        /// Precision reached.
        bits: u32,
    },
}
