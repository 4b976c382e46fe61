//! Motions that are known exactly for all time: agents that keep their velocities.

use crate::double_integrator::laws::{
    Coordinates, Pair, Potential, State, Vector, potential_gradients, velocity_alignment,
};
use crate::double_integrator::theory::{hessian, loop_modes};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Rational, rational};

/// A vector with integer coordinates.
type Whole = (i64, i64);

/// A start from which all agents may keep their velocities for ever: the velocities of linked agents are equal and the forces vanish.
#[derive(Debug, Clone)]
pub struct SteadyMotion {
    /// The start in words.
    pub name: &'static str,
    /// The links.
    pub graph: Graph,
    /// The basis of the state.
    pub coordinates: Coordinates,
    /// The potential of each link.
    pub potential: Potential,
    /// Positions and velocities.
    pub state: State<Rational>,
}

impl SteadyMotion {
    /// The start with these links, and a position and a velocity for each agent.
    pub fn new(
        name: &'static str,
        edges: &[Pair],
        coordinates: Coordinates,
        potential: Potential,
        agents: &[(Whole, Whole)],
    ) -> Self {
        let vector = |(x, y): (i64, i64)| [rational(x, 1), rational(y, 1)];
        let (positions, velocities) = agents.iter().map(|(r, v)| (vector(*r), vector(*v))).unzip();
        let graph = Graph::empty(agents.len()).with_edges(edges);
        SteadyMotion { name, graph, coordinates, potential, state: State { positions, velocities } }
    }

    fn gradients(&self) -> Result<Vec<Vector<Rational>>, ArithmeticError> {
        let slope = |_: usize, _: usize, s: &Rational| self.potential.slope(s);
        potential_gradients(&self.state.positions, &self.graph.edges(), self.coordinates, slope)
    }

    /// Whether the velocities indeed stay: no acceleration under velocity alignment, and linked agents that move together.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where linked agents coincide; so in what follows.
    pub fn is_steady(&self) -> Result<bool, ArithmeticError> {
        let (edges, zero) = (self.graph.edges(), rational(0, 1));
        let slope = |_: usize, _: usize, s: &Rational| self.potential.slope(s);
        let accelerations = velocity_alignment(&self.state, &edges, self.coordinates, slope)?;
        let rest = |pair: &Pair| self.state.relative_velocity(pair.0, pair.1).iter().all(|x| *x == zero);
        Ok(accelerations.iter().flatten().all(|a| *a == zero) && edges.iter().all(rest))
    }

    /// Whether all velocities are equal.
    pub fn agrees(&self) -> bool {
        self.state.velocities.iter().all(|v| *v == self.state.velocities[0])
    }

    /// A pair of agents that start in the same place.
    pub fn coincident(&self) -> Option<Pair> {
        let mut pairs = (0..self.state.count()).flat_map(|j| (0..j).map(move |i| (i, j)));
        pairs.find(|&(i, j)| self.state.positions[i] == self.state.positions[j])
    }

    /// An agent that is pushed, or whose own potential decreases to second order where it alone is moved.
    ///
    /// # Errors
    /// As [`Self::is_steady`].
    pub fn not_minimised(&self) -> Result<Option<usize>, ArithmeticError> {
        let gradients = self.gradients()?;
        let matrix = hessian(&self.state.positions, &self.graph.edges(), self.coordinates, &self.potential)?;
        let zero = rational(0, 1);
        Ok((0..self.state.count()).find(|&i| {
            let [a, b, c, d] = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(k, l)| &matrix[2 * i + k][2 * i + l]);
            // A 2 by 2 matrix with real eigenvalues has a negative one where its trace or its determinant is negative.
            let saddle = a + d < zero || a * d - b * c < zero;
            saddle || gradients[i].iter().any(|x| *x != zero)
        }))
    }

    /// Whether every agent's potential has gradient zero.
    ///
    /// # Errors
    /// As [`Self::is_steady`].
    pub fn is_critical(&self) -> Result<bool, ArithmeticError> {
        Ok(self.gradients()?.iter().flatten().all(|x| *x == rational(0, 1)))
    }

    /// The squared distances of linked agents.
    pub fn squares(&self) -> Vec<Rational> {
        let square = |&(i, j): &Pair| self.coordinates.square(&self.state.separation(i, j));
        self.graph.edges().iter().map(square).collect()
    }

    /// Whether the linearised loop is stable up to translations, rotations and a common velocity: the eigenvalue 0 five times, the
    /// others with negative real parts. `None` where a matrix cannot be formed.
    pub fn is_stable_up_to_motions(&self) -> Option<bool> {
        let (zero, rest) = loop_modes(&self.state, &self.graph.edges(), self.coordinates, &self.potential).ok()?;
        Some(zero == 5 && rest.is_hurwitz())
    }
}
