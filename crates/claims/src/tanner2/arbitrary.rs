//! A closed loop on a fixed graph at an arbitrary state with arbitrary potentials: the variables of the identities.
//!
//! The potential of the pair `(i, j)` is `g_ij s` with a variable `g_ij`. First derivatives at one state see a potential
//! through its slope only, so an identity between them that holds for these holds for all differentiable potentials.

use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::{ArithmeticError, Dual, Field, Ring, gradient};
use models::double_integrator::{
    Coordinates, Pair, State, Vector, agent_potential, kinetic_energy, potential_energy, potential_gradients,
    velocity_alignment,
};

/// `grad_{r_i} V_ij` and `grad_{r_j} V_ij`.
pub type PairGradient<T> = (Vector<T>, Vector<T>);

/// The closed loop of equation (4) at one state.
pub struct Arbitrary<T> {
    pub state: State<T>,
    pub edges: Vec<Pair>,
    pub slopes: Vec<T>,
}

impl Arbitrary<()> {
    /// The number of variables: positions, velocities, a slope for each edge.
    pub fn variables(graph: &Graph) -> usize {
        4 * graph.order() + graph.edges().len()
    }

    /// Connected graphs of up to `most` vertices, one of each isomorphism class.
    pub fn connected(most: usize) -> Vec<Graph> {
        (1..=most).flat_map(Graph::connected_up_to_isomorphism).collect()
    }
}

impl<T: Field> Arbitrary<T> {
    /// From the list of the variables.
    pub fn read(graph: &Graph, at: &[T]) -> Result<Self, ArithmeticError> {
        let states = 4 * graph.order();
        let state = at.get(..states).and_then(|list| State::from_list(graph.order(), list));
        let state = state.ok_or(ArithmeticError::Domain("a state with one agent for each vertex"))?;
        Ok(Arbitrary { state, edges: graph.edges(), slopes: at[states..].to_vec() })
    }

    fn constant(&self, i: usize, j: usize) -> T {
        let edge = self.edges.iter().position(|&pair| pair == (i, j));
        edge.map_or_else(|| self.slopes[0].zero(), |edge| self.slopes[edge].clone())
    }

    /// `V_ij` of a point that moves.
    fn value(&self, i: usize, j: usize, s: &Dual<T>) -> Result<Dual<T>, ArithmeticError> {
        Ok(Dual::constant(self.constant(i, j)) * s)
    }

    pub fn accelerations(&self) -> Result<Vec<Vector<T>>, ArithmeticError> {
        velocity_alignment(&self.state, &self.edges, Coordinates::Cartesian, |i, j, _| Ok(self.constant(i, j)))
    }

    /// `grad_{r_i} V_i`, as the law has it.
    pub fn gradients(&self) -> Result<Vec<Vector<T>>, ArithmeticError> {
        potential_gradients(&self.state.positions, &self.edges, Coordinates::Cartesian, |i, j, _| {
            Ok(self.constant(i, j))
        })
    }

    /// `d/dt V_i` along the closed loop.
    pub fn agent_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        let moving = self.state.moving(&self.accelerations()?);
        let rate = |agent| {
            let value = |i: usize, j: usize, s: &Dual<T>| self.value(i, j, s);
            Ok(agent_potential(agent, &moving.positions, &self.edges, Coordinates::Cartesian, value)?.derivative)
        };
        (0..self.state.count()).map(rate).collect()
    }

    /// `factor` times the sum of the `V_i`, plus half the sum of the squared speeds; `W` where the factor is 1/2.
    pub fn energy(&self, state: &State<Dual<T>>, factor: (i64, i64)) -> Result<Dual<T>, ArithmeticError> {
        let value = |i: usize, j: usize, s: &Dual<T>| self.value(i, j, s);
        let edges = potential_energy(&state.positions, &self.edges, Coordinates::Cartesian, value)?;
        let kinetic = kinetic_energy(&state.velocities, Coordinates::Cartesian)?;
        Ok(edges.clone() * edges.ratio(2 * factor.0, factor.1) + kinetic)
    }

    /// `d/dt W` along the closed loop.
    pub fn energy_rate(&self) -> Result<T, ArithmeticError> {
        Ok(self.energy(&self.state.moving(&self.accelerations()?), (1, 2))?.derivative)
    }

    /// `(grad_{r_i} V_ij, grad_{r_j} V_ij)` for each edge, by differentiation.
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

/// The inner product of two vectors of the plane.
pub fn dot<T: Field>(a: &Vector<T>, b: &Vector<T>) -> T {
    Coordinates::Cartesian.product(a, b)
}

/// `x^T M x`.
pub fn quadratic<T: Field>(matrix: &RationalMatrix, x: &[T]) -> T {
    let like = &x[0];
    let mut total = like.zero();
    for (i, a) in x.iter().enumerate() {
        for (j, b) in x.iter().enumerate() {
            let entry = matrix.entry(i, j);
            if !num_traits::Zero::is_zero(&entry) {
                total = total + a.clone() * b * like.rational(&entry);
            }
        }
    }
    total
}

/// The list summed.
pub fn total<T: Ring>(like: &T, list: impl IntoIterator<Item = T>) -> T {
    list.into_iter().fold(like.zero(), |sum, x| sum + x)
}
