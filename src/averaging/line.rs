//! Model D on the line, stepped exactly.

use super::{Weights, transition_matrix};
use crate::arithmetic::{Rational, Ring};
use crate::graph::Graph;
use crate::matrix::MatrixError;
use num_traits::Signed;

/// The network that joins birds within distance 1 of each other, decided exactly.
pub fn distance_network(positions: &[Rational]) -> Graph {
    Graph::from_fn(positions.len(), |i, j| {
        let distance = (positions[i].clone() - &positions[j]).abs();
        distance <= distance.one()
    })
}

/// A flock on the line: positions `x(t)`, velocities `v(t + 1)` and the network `G_t`.
#[derive(Debug, Clone)]
pub struct LineFlock {
    positions: Vec<Rational>,
    velocities: Vec<Rational>,
    network: Graph,
    weights: Weights,
    hysteresis: Option<Rational>,
}

impl LineFlock {
    /// The flock with positions `x(0)` and velocities `v(1)`; without hysteresis, or with the threshold below which a
    /// change of distance does not break an edge.
    ///
    /// # Errors
    /// [`MatrixError`] where the lists are empty or of different lengths.
    pub fn new(
        positions: Vec<Rational>,
        velocities: Vec<Rational>,
        weights: Weights,
        hysteresis: Option<Rational>,
    ) -> Result<Self, MatrixError> {
        if positions.is_empty() {
            return Err(MatrixError::Empty);
        }
        if positions.len() != velocities.len() {
            return Err(MatrixError::Shapes { left_cols: positions.len(), right_rows: velocities.len() });
        }
        let network = distance_network(&positions);
        Ok(LineFlock { positions, velocities, network, weights, hysteresis })
    }

    /// `x(t)`.
    pub fn positions(&self) -> &[Rational] {
        &self.positions
    }

    /// `v(t + 1)`.
    pub fn velocities(&self) -> &[Rational] {
        &self.velocities
    }

    /// `G_t`.
    pub fn network(&self) -> &Graph {
        &self.network
    }

    /// One step: `x(t+1) = x(t) + v(t+1)`, then `G_{t+1}` from the distance rule and the hysteresis rule, then
    /// `v(t+2) = P(t+1) v(t+1)`.
    ///
    /// # Errors
    /// [`MatrixError`] where given weights are too few.
    pub fn step(&mut self) -> Result<(), MatrixError> {
        let moved: Vec<Rational> = self.positions.iter().zip(&self.velocities).map(|(x, v)| x + v).collect();
        let near = distance_network(&moved);
        let distance = |x: &[Rational], i: usize, j: usize| (x[i].clone() - &x[j]).abs();
        let keeps = |i: usize, j: usize| {
            self.hysteresis.as_ref().is_some_and(|threshold| {
                self.network.has_edge(i, j)
                    && (distance(&moved, i, j) - distance(&self.positions, i, j)).abs() < *threshold
            })
        };
        self.network = Graph::from_fn(moved.len(), |i, j| near.has_edge(i, j) || keeps(i, j));
        self.velocities = transition_matrix(&self.network, &self.weights)?.apply(&self.velocities)?;
        self.positions = moved;
        Ok(())
    }
}
