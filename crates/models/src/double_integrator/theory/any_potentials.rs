//! The closed loop of velocity alignment on a fixed graph at an arbitrary state with arbitrary potentials: what identities between first
//! derivatives are tested on.
//!
//! The potential of the pair `(i, j)` is `g_ij s` with a variable `g_ij`. First derivatives at one state see a potential through its
//! slope only, so that an identity between them that holds for these holds for all differentiable potentials.

use crate::double_integrator::laws::{
    Coordinates, Pair, State, Vector, agent_potential, kinetic_energy, potential_energy, potential_gradients,
    velocity_alignment,
};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Dual, Field, Ring, gradient};

const PLANE: Coordinates = Coordinates::Cartesian;

/// `grad_{r_i} V_ij` and `grad_{r_j} V_ij`.
pub type PairGradient<T> = (Vector<T>, Vector<T>);

/// The closed loop of equation (4) of the second paper at one state.
pub struct AnyPotentials<T> {
    /// Positions and velocities.
    pub state: State<T>,
    /// The edges of the graph.
    pub edges: Vec<Pair>,
    /// The slope `g_ij` of the potential of each edge.
    pub slopes: Vec<T>,
}

impl AnyPotentials<()> {
    /// The number of variables: `2N` of positions, `2N` of velocities, a slope for each edge.
    pub fn variables(graph: &Graph) -> usize {
        4 * graph.order() + graph.edges().len()
    }

    /// The names of the variables, in order.
    pub fn names(graph: &Graph) -> Vec<String> {
        let vectors = |x: &'static str, y: &'static str| {
            (1..=graph.order()).flat_map(move |i| [format!("{x}{i}"), format!("{y}{i}")])
        };
        let slopes = graph.edges().into_iter().map(|(i, j)| format!("V'_{}{}", i + 1, j + 1));
        vectors("x", "y").chain(vectors("vx", "vy")).chain(slopes).collect()
    }
}

impl<T: Field> AnyPotentials<T> {
    /// From the list of the variables.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where the list is too short.
    pub fn read(graph: &Graph, at: &[T]) -> Result<Self, ArithmeticError> {
        let states = 4 * graph.order();
        let state = at.get(..states).and_then(|list| State::from_list(graph.order(), list));
        let state = state.ok_or(ArithmeticError::Domain("a state with one agent for each vertex"))?;
        Ok(AnyPotentials { state, edges: graph.edges(), slopes: at[states..].to_vec() })
    }

    fn slope(&self, i: usize, j: usize) -> Result<T, ArithmeticError> {
        let edge = self.edges.iter().position(|&pair| pair == (i, j));
        edge.and_then(|edge| self.slopes.get(edge).cloned()).ok_or(ArithmeticError::Domain("a slope for each edge"))
    }

    /// `V_ij` of a point that moves.
    fn value(&self, i: usize, j: usize, s: &Dual<T>) -> Result<Dual<T>, ArithmeticError> {
        Ok(Dual::constant(self.slope(i, j)?) * s)
    }

    /// The accelerations of equation (4).
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where slopes are missing; so in what follows.
    pub fn accelerations(&self) -> Result<Vec<Vector<T>>, ArithmeticError> {
        velocity_alignment(&self.state, &self.edges, PLANE, |i, j, _| self.slope(i, j))
    }

    /// `grad_{r_i} V_i`, as the law has it.
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    pub fn gradients(&self) -> Result<Vec<Vector<T>>, ArithmeticError> {
        potential_gradients(&self.state.positions, &self.edges, PLANE, |i, j, _| self.slope(i, j))
    }

    /// `d/dt V_i` along the closed loop.
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    pub fn agent_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        let moving = self.state.moving(&self.accelerations()?);
        let rate = |agent| {
            let value = |i: usize, j: usize, s: &Dual<T>| self.value(i, j, s);
            Ok(agent_potential(agent, &moving.positions, &self.edges, PLANE, value)?.derivative)
        };
        (0..self.state.count()).map(rate).collect()
    }

    /// `factor` times the sum of the `V_i`, plus half the sum of the squared speeds; `W` where the factor is 1/2.
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    pub fn energy(&self, state: &State<Dual<T>>, factor: (i64, i64)) -> Result<Dual<T>, ArithmeticError> {
        let value = |i: usize, j: usize, s: &Dual<T>| self.value(i, j, s);
        let edges = potential_energy(&state.positions, &self.edges, PLANE, value)?;
        Ok(edges.clone() * edges.ratio(2 * factor.0, factor.1) + kinetic_energy(&state.velocities, PLANE)?)
    }

    /// `d/dt W` along the closed loop.
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    pub fn energy_rate(&self) -> Result<T, ArithmeticError> {
        Ok(self.energy(&self.state.moving(&self.accelerations()?), (1, 2))?.derivative)
    }

    /// `(grad_{r_i} V_ij, grad_{r_j} V_ij)` for each edge, by differentiation.
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    pub fn pair_gradients(&self) -> Result<Vec<PairGradient<T>>, ArithmeticError> {
        let of_pair = |&(i, j): &Pair| {
            let [a, b] = [&self.state.positions[i], &self.state.positions[j]];
            let at = [a[0].clone(), a[1].clone(), b[0].clone(), b[1].clone()];
            let slopes = gradient(&at, |x| {
                let s = (x[0].clone() - &x[2]).square() + (x[1].clone() - &x[3]).square();
                self.value(i, j, &s)
            })?;
            Ok(([slopes[0].clone(), slopes[1].clone()], [slopes[2].clone(), slopes[3].clone()]))
        };
        self.edges.iter().map(of_pair).collect()
    }

    /// The components of the velocities along one axis.
    pub fn axis(&self, k: usize) -> Vec<T> {
        self.state.velocities.iter().map(|v| v[k].clone()).collect()
    }
}
