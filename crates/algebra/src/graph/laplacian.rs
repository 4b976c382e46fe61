//! The matrices of a graph, each by its name.

use super::{Graph, WeightedGraph};
use crate::matrix::{MatrixError, RationalMatrix, SparseMatrix};
use arithmetic::{Rational, rational};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// Which matrix of a graph: `A` has the weights `a_ij` of the arcs from `i` to `j`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum LaplacianKind {
    /// `D - A` with the row sums of `A` in `D`; rows sum to zero. On directed graphs the same as [`Self::OutDegree`].
    Combinatorial,
    /// `D - A` with the row sums of `A` in `D`.
    OutDegree,
    /// `D - A` with the column sums of `A` in `D`; columns sum to zero.
    InDegree,
    /// `I - D^-1/2 A D^-1/2` of an undirected graph without negative weights. Given as the similar [`Self::Walk`],
    /// because square roots are not rational: it is `D^1/2 (I - D^-1 A) D^-1/2`, with the same eigenvalues.
    Normalised,
    /// `I - D^-1 A` with the row sums of `A` in `D`; the row of a vertex without arcs is zero.
    Walk,
    /// `D - A` with the row sums of `A` in `D`, without the row and the column of the first vertex (the leader, the
    /// ground).
    Reduced,
    /// `A` itself.
    Adjacency,
}

/// Why a graph has no such matrix. Vertices are counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum LaplacianError {
    /// The normalised Laplacian of a directed graph.
    #[error("the normalised Laplacian is for undirected graphs; `walk` is its form for directed ones")]
    Directed,
    /// A negative weight where degrees must not be negative.
    #[error("vertex {0} has an edge of negative weight, which the normalised Laplacian does not allow")]
    Negative(usize),
    /// Weights that sum to zero without being zero.
    #[error("the weights of vertex {0} sum to zero, so its row of I - D^-1 A does not exist")]
    ZeroDegree(usize),
    /// The reduced Laplacian of one vertex.
    #[error("the reduced Laplacian needs a vertex beside the first one")]
    NothingLeft,
}

impl LaplacianKind {
    /// All kinds with their names.
    pub const NAMES: [(&'static str, LaplacianKind); 7] = [
        ("laplacian", LaplacianKind::Combinatorial),
        ("out-degree", LaplacianKind::OutDegree),
        ("in-degree", LaplacianKind::InDegree),
        ("normalised", LaplacianKind::Normalised),
        ("walk", LaplacianKind::Walk),
        ("reduced", LaplacianKind::Reduced),
        ("adjacency", LaplacianKind::Adjacency),
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, kind)| *kind == self).map_or("laplacian", |(name, _)| name)
    }

    /// The kind of that name, in either spelling: `normalised` or `normalized`, `out-degree` or `out_degree`.
    pub fn from_name(name: &str) -> Option<Self> {
        let name = name.replace("normalized", "normalised").replace('_', "-");
        Self::NAMES.iter().find(|(known, _)| *known == name).map(|(_, kind)| *kind)
    }

    /// What the name means, in a few signs.
    pub fn meaning(self) -> &'static str {
        match self {
            LaplacianKind::Combinatorial | LaplacianKind::OutDegree => "D - A, row sums of A in D",
            LaplacianKind::InDegree => "D - A, column sums of A in D",
            LaplacianKind::Normalised => "I - D^-1/2 A D^-1/2",
            LaplacianKind::Walk => "I - D^-1 A, row sums of A in D",
            LaplacianKind::Reduced => "D - A without the row and column of the first vertex",
            LaplacianKind::Adjacency => "the weights A",
        }
    }
}

impl WeightedGraph {
    /// The matrix of that kind; exact. For [`LaplacianKind::Normalised`] see there.
    ///
    /// # Errors
    /// [`LaplacianError`].
    pub fn matrix(&self, kind: LaplacianKind) -> Result<SparseMatrix, LaplacianError> {
        match kind {
            LaplacianKind::Combinatorial | LaplacianKind::OutDegree => Ok(self.minus_from(self.out_degrees())),
            LaplacianKind::InDegree => Ok(self.minus_from(self.in_degrees())),
            LaplacianKind::Adjacency => Ok(self.adjacency().clone()),
            LaplacianKind::Reduced => self.grounded(0),
            LaplacianKind::Walk => self.walk(),
            LaplacianKind::Normalised => {
                if !self.is_undirected() {
                    return Err(LaplacianError::Directed);
                }
                match self.adjacency().entries().find(|(_, _, weight)| weight.is_negative()) {
                    Some((i, _, _)) => Err(LaplacianError::Negative(i + 1)),
                    None => self.walk(),
                }
            }
        }
    }

    fn minus_from(&self, diagonal: Vec<Rational>) -> SparseMatrix {
        let diagonal = diagonal.into_iter().enumerate().map(|(i, degree)| (i, i, degree));
        let weights = self.adjacency().entries().map(|(i, j, weight)| (i, j, -weight));
        SparseMatrix::from_entries(self.order(), diagonal.chain(weights))
    }

    /// `D - A` with the row sums of `A` in `D`, without the row and column of one vertex.
    ///
    /// # Errors
    /// [`LaplacianError::NothingLeft`].
    pub fn grounded(&self, vertex: usize) -> Result<SparseMatrix, LaplacianError> {
        if self.order() < 2 {
            return Err(LaplacianError::NothingLeft);
        }
        let kept: Vec<usize> = (0..self.order()).filter(|&i| i != vertex).collect();
        Ok(self.minus_from(self.out_degrees()).principal(&kept))
    }

    fn walk(&self) -> Result<SparseMatrix, LaplacianError> {
        let degrees = self.out_degrees();
        let without = |i: usize| degrees[i].is_zero();
        if let Some(i) = (0..self.order()).find(|&i| without(i) && !self.adjacency().row(i).is_empty()) {
            return Err(LaplacianError::ZeroDegree(i + 1));
        }
        let ones = (0..self.order()).filter(|&i| !without(i)).map(|i| (i, i, rational(1, 1)));
        let shares = self.adjacency().entries().map(|(i, j, weight)| (i, j, -weight / &degrees[i]));
        Ok(SparseMatrix::from_entries(self.order(), ones.chain(shares)))
    }
}

impl Graph {
    /// The incidence matrix `B`: a column for each edge `(i, j)`, `i < j`, with `+1` in row `i` and `-1` in row `j`, so that
    /// `B B^T` is the combinatorial Laplacian.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] for a graph without edges.
    pub fn incidence(&self) -> Result<RationalMatrix, MatrixError> {
        let edges = self.edges();
        let entry = |vertex: usize, edge: usize| match edges[edge] {
            (i, _) if i == vertex => BigInt::from(1),
            (_, j) if j == vertex => BigInt::from(-1),
            _ => BigInt::ZERO,
        };
        let places = (0..self.order()).flat_map(|vertex| (0..edges.len()).map(move |edge| (vertex, edge)));
        let numerators = places.map(|(vertex, edge)| entry(vertex, edge)).collect();
        RationalMatrix::new(self.order(), edges.len(), numerators, BigInt::from(1))
    }
}
