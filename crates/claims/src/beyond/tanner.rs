//! beyond.tanner1.two_agents, beyond.tanner1.turning_triangle, beyond.tanner2.alternating_trees, beyond.tanner2.endless_switching.

use crate::tanner1::triangle::turns_for_ever;
use crate::tanner2::switching::{dimension_of_regular_simplex, symmetric_motions_cross_for_ever};
use algebra::graph::Graph;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Field, Rational, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Potential, State, gyroscopic, potential_gradients, scaled, sum};

// --- Two agents align ---

/// `d/dt ½|v_1 + v_2|² = factor d (v_2 x v_1)/s`, where `d` is the heading difference of the law.
#[derive(Clone, Copy)]
pub struct TotalVariant {
    factor: i64,
    power: u64,
}

/// Positions, speeds, half-angle tangents of the headings, the heading difference and the slope of the potential.
struct Total(TotalVariant);

impl RationalIdentity for Total {
    fn variables(&self) -> usize {
        10
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let velocity = |speed: &T, tangent: &T| -> Result<[T; 2], ArithmeticError> {
            let phasor = models::oscillator::phasor(tangent)?;
            Ok(scaled(speed, &[phasor.re, phasor.im]))
        };
        let state = State {
            positions: vec![[at[0].clone(), at[1].clone()], [at[2].clone(), at[3].clone()]],
            velocities: vec![velocity(&at[4], &at[6])?, velocity(&at[5], &at[7])?],
        };
        let plane = Coordinates::Cartesian;
        let gradients = potential_gradients(&state.positions, &[(0, 1)], plane, |_, _, _| Ok(at[9].clone()))?;
        let signed = |i: usize| if i == 0 { at[8].clone() } else { -at[8].clone() };
        let moving = state.moving(&gyroscopic(&state, &gradients, &[(0, 1)], |i, _| signed(i))?);
        let total = sum(&moving.velocities[0], &moving.velocities[1]);
        let square = plane.square(&total);
        let left = (square.clone() * square.ratio(1, 2)).derivative;
        let [v, w] = [&state.velocities[0], &state.velocities[1]];
        // |v_1||v_2| sin(theta_1 - theta_2).
        let cross = w[0].clone() * &v[1] - w[1].clone() * &v[0];
        let s = plane.square(&state.separation(0, 1));
        let right = at[8].clone() * cross * at[0].integer(self.0.factor);
        Ok((vec![left], vec![right.over(&s.power(self.0.power))?]))
    }
}

pub fn two_agents() -> Record<TotalVariant> {
    let printed = TotalVariant { factor: 2, power: 1 };
    Record::new(
        "beyond.tanner1.two_agents",
        "Potential forces cancel in v_1 + v_2, and the alignment forces give d/dt ½|v_1 + v_2|² = 2 d |v_1||v_2| sin(theta_1 - theta_2)/s, for any number d in place of theta_1 - theta_2. With d in [-pi, pi] and equal to it modulo 2 pi, d sin d >= 0. The raw difference may lie \
         beyond pi, and then the sum of the velocities loses length.",
        printed,
        check_two_agents,
    )
    .stated(
        "replaces tanner1, eq (9), for two agents",
        "Two agents under (4), (5) with heading differences wrapped to (-pi, pi]: |v_1 + v_2| never decreases, d/dt ½|v_1 + v_2|² = 2 |v_1||v_2| d sin d/|r_12|² with d = theta_1 - theta_2, while the mechanical energy is constant.",
    )
    .control("half of it", TotalVariant { factor: 1, ..printed })
    .control("the other sign", TotalVariant { factor: -2, ..printed })
    .control("over the fourth power of the distance", TotalVariant { power: 2, ..printed })
}

fn check_two_agents(variant: &TotalVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let names = ["x1", "y1", "x2", "y2", "speed 1", "speed 2", "tan(theta_1/2)", "tan(theta_2/2)", "d", "V'"];
    run.identity(&Total(*variant), &names, "the rate of ½|v_1 + v_2|², any potential")
}

// --- Three agents need not align ---

pub fn turning_triangle() -> Record<(i64, i64)> {
    Record::new(
        "beyond.tanner1.turning_triangle",
        "The potential forces on an equilateral triangle with its centre at the origin are -6 V'(s) r_i, as the positions sum to zero: they keep it turning with omega² = 6 V'(s). Each agent has the two others' headings a third of a turn to its left and to its right, at equal distances: wrapped differences cancel. \
         The law is the same in turned coordinates, so this holds at all times. The motion fulfils the hypotheses of Proposition IV.3 (connected graph, finite V_t). The variant is omega over sqrt(3/2).",
        (1, 1),
        |rate, _| {
            let evidence = Evidence::new(
                Grade::Exact,
                "accelerations, headings, sides",
                "in the field of the cosines of multiples of pi/12, which has sqrt 2 and sqrt 3",
            );
            Ok(match turns_for_ever(&rational(rate.0, rate.1))? {
                true => Outcome::Holds(vec![evidence]),
                false => Outcome::fails(
                    format!("omega = {}/{} sqrt(3/2): the accelerations are not -omega² r_i", rate.0, rate.1),
                    evidence,
                ),
            })
        },
    )
    .stated(
        "beside tanner1, Proposition IV.3",
        "Three linked agents on an equilateral triangle of squared side 2 that turns about its centre with omega² = 6 V'(2) = 3/2, V = 1/s + log s, move so for ever under (4), (5) with heading differences wrapped to (-pi, pi]: the headings stay a third of a turn apart.",
    )
    .control("omega² = 6", (2, 1))
    .control("omega² = 3/2 (99/100)²", (99, 100))
}

// --- Alternating trees ---

/// Agents, two spanning trees in turn, and the dimension of space.
#[derive(Clone)]
pub struct TreesVariant {
    agents: usize,
    trees: [Vec<(usize, usize)>; 2],
    dimension: usize,
}

fn examine_trees(variant: &TreesVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let empty = Graph::empty(variant.agents);
    let graphs = variant.trees.each_ref().map(|edges| empty.with_edges(edges));
    let union = empty.with_edges(&variant.trees.concat());
    let trees = graphs.iter().all(|graph| graph.is_connected() && graph.edges().len() + 1 == variant.agents);
    let complete = union.edges().len() == variant.agents * (variant.agents - 1) / 2;
    let needed = dimension_of_regular_simplex(variant.agents)?;
    let evidence = Evidence::new(
        Grade::Exact,
        "common critical configurations",
        "the Gram matrix of the regular simplex; the limit argument is in notes/tanner2.md",
    );
    if trees && complete && needed > variant.dimension {
        return Ok(Outcome::Holds(vec![evidence]));
    }
    let what = if union == graphs[0] {
        "the links do not change: velocities agree in the limit (tanner2.thm1a)".to_string()
    } else {
        format!(
            "{} agents can have all distances 1 in dimension {}: at rest there they stay, with equal velocities",
            variant.agents, variant.dimension
        )
    };
    Ok(Outcome::fails(what, evidence))
}

pub fn alternating_trees() -> Record<TreesVariant> {
    let printed =
        TreesVariant { agents: 4, trees: [vec![(0, 1), (1, 2), (2, 3)], vec![(1, 3), (0, 3), (0, 2)]], dimension: 2 };
    Record::new(
        "beyond.tanner2.alternating_trees",
        "If the velocities agreed in the limit, the force on each edge of the tree in use would vanish in the limit, so that all six distances would tend to the desired one: impossible in the plane. So switching between connected graphs can keep a flock from ever agreeing, from any start.",
        printed.clone(),
        examine_trees,
    )
    .stated(
        "sharpens tanner2, Abstract (arbitrary switching)",
        "Four agents in the plane under (4) with V = s + 1/s - 2 and the links 1-2-3-4 and 2-4-1-3 in turn, for a fixed time each: from no start without collision do the velocities agree in the limit.",
    )
    .control("three agents", TreesVariant { agents: 3, trees: [vec![(0, 1), (1, 2)], vec![(0, 1), (0, 2)]], ..printed.clone() })
    .control("in space", TreesVariant { dimension: 3, ..printed.clone() })
    .control("one tree only", TreesVariant { trees: [printed.trees[0].clone(), printed.trees[0].clone()], ..printed })
}

// --- Endless switching ---

fn examine_endless(setting: &(Potential, Rational), _run: &mut Run) -> Result<Outcome, CheckError> {
    let (potential, square) = setting;
    let evidence = Evidence::new(
        Grade::Exact,
        "motions near two equilateral triangles side by side",
        "characteristic polynomials of the symmetric modes with and without the link: stable, no real root (Sturm, Routh)",
    );
    let fulfilled = potential.check_definition3().is_ok();
    if fulfilled && symmetric_motions_cross_for_ever(potential, square)? {
        return Ok(Outcome::Holds(vec![evidence]));
    }
    let slope = potential.slope(square)?;
    Ok(Outcome::fails(
        format!("R² = {square}, V'(R²) = {slope}: the long diagonal is not at R, or the pull jumps there"),
        evidence,
    ))
}

pub fn endless_switching() -> Record<(Potential, Rational)> {
    let q = |n: i64| rational(n, 1);
    Record::new(
        "beyond.tanner2.endless_switching",
        "The rhombus is an equilibrium with |r_13| = R exactly. On motions that keep its diagonals the loop is stable on both sides of R and has no real rate there, so every other symmetric motion nearby tends to it in oscillations and passes R for ever, with a graph that is connected at all times.",
        (Potential::with_inflection(&q(3)), q(3)),
        examine_endless,
    )
    .stated(
        "limits tanner2, end of the proof of Theorem 2",
        "With V' = (s-1)(s-3)²(s+3/5)/s² (a potential of Definition 3, increasing beyond s = 1) and R² = 3, switching by distance goes on for ever for open sets of symmetric starts of four agents near two equilateral triangles side by side.",
    )
    .control("V = s + 1/s - 2, whose slope at R is positive", (Potential::inverse_square_spring(&q(1), &q(1)), q(3)))
    .control("R² = 4", (Potential::with_inflection(&q(4)), q(4)))
}
