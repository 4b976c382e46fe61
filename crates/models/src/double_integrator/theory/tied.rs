//! The rate of `Q`, equation (11) of the second paper, away from the threshold and where pairs are at distance `R` exactly.

use crate::double_integrator::laws::{
    Coordinates, Pair, Potential, Span, State, dot, kinetic_energy, linked_within, saturated_potential, scaled, sum,
    tied, velocity_alignment,
};
use crate::double_integrator::runs::Way;
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Dual, Rational, Sign, Signed, rational};

const PLANE: Coordinates = Coordinates::Cartesian;

fn squared_speeds(state: &State<Rational>, pairs: &[Pair]) -> Rational {
    pairs.iter().map(|&(i, j)| PLANE.square(&state.relative_velocity(i, j))).sum()
}

/// `d|r_ij|²/dt`.
fn opening(state: &State<Rational>, (i, j): Pair) -> Rational {
    dot(&state.separation(i, j), &state.relative_velocity(i, j)) * rational(2, 1)
}

/// The forward rate of `Q` under the law with links below `R`, whose square this is, and `-v^T (L kron I_2) v` of those links, for a
/// potential without logarithm.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where linked agents coincide, [`ArithmeticError::Domain`] where there is not a velocity for each
/// position.
pub fn saturated_rate(
    state: &State<Rational>,
    square: &Rational,
    potential: &Potential,
) -> Result<(Rational, Rational), ArithmeticError> {
    state.check()?;
    let edges = linked_within(&state.positions, square, PLANE).edges();
    let accelerations = velocity_alignment(state, &edges, PLANE, |_, _, s| potential.slope(s))?;
    let moving = state.moving(&accelerations);
    // Forward in time a tied pair that approaches is on the inner side.
    let mut inside = edges.clone();
    let ties = tied(&state.positions, square, PLANE);
    inside.extend(ties.into_iter().filter(|&pair| opening(state, pair).sign() == Some(Sign::Negative)));
    let value = |_: usize, _: usize, s: &Dual<Rational>| potential.rational_value(s);
    let beyond = Dual::constant(potential.rational_value(square)?);
    let energy = saturated_potential(&moving.positions, &inside, PLANE, value, &beyond)?
        + kinetic_energy(&moving.velocities, PLANE)?;
    Ok((energy.derivative, -squared_speeds(state, &edges)))
}

/// The rate of `Q` along one way on from a state with ties at `R`, whose square this is, and `-v^T (L kron I_2) v` with the links and
/// weights in force there, for a potential without logarithm. Without `cut` the potentials are not cut off at `R`.
///
/// # Errors
/// As for [`saturated_rate`], and [`ArithmeticError::Domain`] for a pair of agents that are not there.
pub fn rate_along(
    state: &State<Rational>,
    square: &Rational,
    potential: &Potential,
    ways: &[(Pair, Way<Rational>)],
    cut: bool,
) -> Result<(Rational, Rational), ArithmeticError> {
    state.check()?;
    if ways.iter().any(|((i, j), _)| i == j || *i.max(j) >= state.count()) {
        return Err(ArithmeticError::Domain("two agents that are there"));
    }
    let slope = |_: usize, _: usize, s: &Rational| potential.slope(s);
    let mut links = linked_within(&state.positions, square, PLANE).edges();
    links.extend(ways.iter().filter(|(_, way)| *way == Way::Enters).map(|(pair, _)| *pair));
    let mut accelerations = velocity_alignment(state, &links, PLANE, slope)?;
    let mut form = squared_speeds(state, &links);
    for (pair, way) in ways {
        if let Way::Stays(weight) = way {
            let more = velocity_alignment(state, &[*pair], PLANE, slope)?;
            accelerations = accelerations.iter().zip(&more).map(|(a, b)| sum(a, &scaled(weight, b))).collect();
            form += weight * squared_speeds(state, &[*pair]);
        }
    }
    let moving = state.moving(&accelerations);
    let value = |_: usize, _: usize, s: &Dual<Rational>| potential.rational_value(s);
    let beyond = Dual::constant(potential.rational_value(square)?);
    let inside = if cut { links } else { Graph::complete(state.count()).edges() };
    let energy = saturated_potential(&moving.positions, &inside, PLANE, value, &beyond)?
        + kinetic_energy(&moving.velocities, PLANE)?;
    Ok((energy.derivative, -form))
}

/// What equation (13) needs of a state with tied pairs.
#[derive(Debug, Clone, PartialEq)]
pub struct TiedRate {
    /// `-v^T (L kron I_2) v` of the links that are not tied.
    pub base: Rational,
    /// For each tied pair `V'(R²) d|r_ij|²/dt` and `|v_i - v_j|²`.
    pub ties: Vec<(Rational, Rational)>,
}

impl TiedRate {
    /// At a state with links below `R`, whose square this is.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] for `R = 0`, [`ArithmeticError::Domain`] where there is not a velocity for each position.
    pub fn of(state: &State<Rational>, square: &Rational, potential: &Potential) -> Result<Self, ArithmeticError> {
        state.check()?;
        let slope = potential.slope(square)?;
        let ties = tied(&state.positions, square, PLANE);
        let tie = |&pair: &Pair| (&slope * opening(state, pair), squared_speeds(state, &[pair]));
        let base = -squared_speeds(state, &linked_within(&state.positions, square, PLANE).edges());
        Ok(TiedRate { base, ties: ties.iter().map(tie).collect() })
    }

    fn summed(&self, of_tie: impl Fn(&Rational, &Rational) -> Span<Rational>) -> Span<Rational> {
        let start = Span { lo: self.base.clone(), hi: self.base.clone() };
        self.ties.iter().fold(start, |sum, (p, q)| sum.plus(&of_tie(p, q)))
    }

    /// The generalised time derivative (A.2): the intersection over all generalised gradients of their products with `K[f]`.
    ///
    /// A tied pair contributes `z p - m (p + q)`, `z` in [0, 1] from the gradient of `Q` and `m` in [0, 1] from the law. Both ends are
    /// sums over the pairs and linear in each `z`, so `z = 0` and `z = 1` give the intersection.
    pub fn derivative(&self) -> Span<Rational> {
        self.summed(|p, q| {
            let zero = rational(0, 1);
            let law = Span { lo: (-(p + q)).min(zero.clone()), hi: (-(p + q)).max(zero) };
            law.intersection(&Span { lo: &law.lo + p, hi: &law.hi + p })
        })
    }

    /// The right side of (13): `-co{v_x^T L v_x + v_y^T L v_y}` over the graphs that meet at the state.
    pub fn hull(&self) -> Span<Rational> {
        self.summed(|_, q| Span { lo: -q.clone(), hi: rational(0, 1) })
    }

    /// The value of the graph with every tied pair linked.
    pub fn all_linked(&self) -> Rational {
        self.ties.iter().fold(self.base.clone(), |sum, (_, q)| sum - q)
    }
}
