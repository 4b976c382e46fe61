//! Motions that are known exactly for all time: agents that keep their velocities.

use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Rational, rational};
use models::double_integrator::{
    Coordinates, Pair, Potential, State, hessian, potential_gradients, velocity_alignment,
};

/// A start from which all agents keep their velocities for ever: the velocities are equal and the forces vanish, or there
/// are no links.
#[derive(Debug, Clone)]
pub struct Motion {
    pub name: &'static str,
    pub graph: Graph,
    pub coordinates: Coordinates,
    pub potential: Potential,
    pub state: State<Rational>,
}

impl Motion {
    /// Whether the velocities indeed stay: no acceleration, and distances of linked agents that do not change.
    pub fn is_steady(&self) -> Result<bool, ArithmeticError> {
        let edges = self.graph.edges();
        let slope = |_: usize, _: usize, s: &Rational| self.potential.slope(s);
        let accelerations = velocity_alignment(&self.state, &edges, self.coordinates, slope)?;
        let zero = rational(0, 1);
        let rest = |pair: &Pair| self.state.relative_velocity(pair.0, pair.1).iter().all(|x| *x == zero);
        Ok(accelerations.iter().flatten().all(|a| *a == zero) && edges.iter().all(rest))
    }

    /// Whether all velocities are equal.
    pub fn agrees(&self) -> bool {
        self.state.velocities.iter().all(|v| *v == self.state.velocities[0])
    }

    /// A pair of agents in the same place at some time (they keep their velocities; only starts in the same place are listed).
    pub fn coincident(&self) -> Option<Pair> {
        let count = self.state.count();
        let pairs = (0..count).flat_map(|j| (0..j).map(move |i| (i, j)));
        pairs.into_iter().find(|&(i, j)| self.state.positions[i] == self.state.positions[j])
    }

    /// An agent whose own potential falls to second order where it alone is moved, or that is pushed.
    pub fn not_minimised(&self) -> Result<Option<usize>, ArithmeticError> {
        let edges = self.graph.edges();
        let slope = |_: usize, _: usize, s: &Rational| self.potential.slope(s);
        let gradients = potential_gradients(&self.state.positions, &edges, self.coordinates, slope)?;
        let matrix = hessian(&self.state.positions, &edges, self.coordinates, &self.potential)?;
        let zero = rational(0, 1);
        Ok((0..self.state.count()).find(|&i| {
            let [a, b, c, d] = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(k, l)| &matrix[2 * i + k][2 * i + l]);
            // A 2 by 2 matrix with real eigenvalues has a negative one where its trace or its determinant is negative.
            let falls = a + d < zero || a * d - b * c < zero;
            falls || gradients[i].iter().any(|x| *x != zero)
        }))
    }

    /// Whether every agent's potential has gradient zero.
    pub fn is_critical(&self) -> Result<bool, ArithmeticError> {
        let slope = |_: usize, _: usize, s: &Rational| self.potential.slope(s);
        let gradients = potential_gradients(&self.state.positions, &self.graph.edges(), self.coordinates, slope)?;
        Ok(gradients.iter().flatten().all(|x| *x == rational(0, 1)))
    }

    /// The squared distances of linked agents.
    pub fn squares(&self) -> Vec<Rational> {
        self.graph.edges().iter().map(|&(i, j)| self.coordinates.square(&self.state.separation(i, j))).collect()
    }
}

/// Position and velocity.
type Agent = ((i64, i64), (i64, i64));

fn motion(
    name: &'static str,
    edges: &[Pair],
    coordinates: Coordinates,
    potential: Potential,
    agents: &[Agent],
) -> Motion {
    let vector = |(x, y): (i64, i64)| [rational(x, 1), rational(y, 1)];
    Motion {
        name,
        graph: Graph::empty(agents.len()).with_edges(edges),
        coordinates,
        potential,
        state: State {
            positions: agents.iter().map(|(r, _)| vector(*r)).collect(),
            velocities: agents.iter().map(|(_, v)| vector(*v)).collect(),
        },
    }
}

/// Three agents at rest in a row on the complete graph, the middle one half way: `V = m/s + log(s/m)` with `m = 4/3`, so that
/// the outward push at distance 1 and the inward pull at distance 2 cancel.
pub fn row_of_three() -> Motion {
    motion(
        "three agents at (-1, 0), (0, 0), (1, 0), all linked, V = m/s + log(s/m) with m = 4/3",
        &[(0, 1), (0, 2), (1, 2)],
        Coordinates::Cartesian,
        Potential::inverse_square_log(&rational(4, 3)),
        &[((-1, 0), (0, 0)), ((0, 0), (0, 0)), ((1, 0), (0, 0))],
    )
}

/// The equilateral triangle at the desired distance.
pub fn triangle() -> Motion {
    motion(
        "an equilateral triangle, all linked, V = 1/s + log s",
        &[(0, 1), (0, 2), (1, 2)],
        Coordinates::Triangular,
        Potential::inverse_square_log(&rational(1, 1)),
        &[((0, 0), (0, 0)), ((1, 0), (0, 0)), ((0, 1), (0, 0))],
    )
}

/// Two agents at the desired distance that move together.
pub fn pair() -> Motion {
    motion(
        "two linked agents at distance 1 with velocities (1, 0), V = s + 1/s - 2",
        &[(0, 1)],
        Coordinates::Cartesian,
        Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)),
        &[((0, 0), (1, 0)), ((1, 0), (1, 0))],
    )
}

/// Two agents at rest at a distance where the slope of a potential of Definition 3 vanishes, though not its minimum.
pub fn inflected_pair() -> Motion {
    motion(
        "two linked agents at rest at |r|² = 4, with V' = (s - 1)(s - 4)²(s + 2/3)/s² and V(1) = 0",
        &[(0, 1)],
        Coordinates::Cartesian,
        Potential::with_inflection(&rational(4, 1)),
        &[((0, 0), (0, 0)), ((2, 0), (0, 0))],
    )
}

/// A path of three agents in a row, at right angles, and folded so that its ends coincide.
pub fn paths() -> [Motion; 3] {
    let path = |name, last| {
        motion(
            name,
            &[(0, 1), (1, 2)],
            Coordinates::Cartesian,
            Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)),
            &[((1, 0), (0, 0)), ((0, 0), (0, 0)), (last, (0, 0))],
        )
    };
    [
        path("the path 1-2-3 at (1, 0), (0, 0), (-1, 0), V = s + 1/s - 2", (-1, 0)),
        path("the path 1-2-3 at (1, 0), (0, 0), (0, 1), V = s + 1/s - 2", (0, 1)),
        path("the path 1-2-3 at (1, 0), (0, 0), (1, 0), V = s + 1/s - 2", (1, 0)),
    ]
}

/// Two agents without a link.
pub fn strangers() -> Motion {
    motion(
        "two agents that are not linked, at (0, 0) and (1, 0) with velocities (0, 0) and (1, 0)",
        &[],
        Coordinates::Cartesian,
        Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)),
        &[((0, 0), (0, 0)), ((1, 0), (1, 0))],
    )
}

/// All of them, natural ones first.
pub fn motions() -> Vec<Motion> {
    let mut all = vec![pair(), row_of_three(), triangle()];
    all.extend(paths());
    all.extend([strangers(), inflected_pair()]);
    all
}
