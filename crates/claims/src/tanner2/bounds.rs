//! tanner2.bound_r, bound_v, eq7, cor2_sub: what an energy at most c bounds.

use super::fixtures::{PLANE, apart, connected, pairs, quadratic, sloped, spring};
use super::graphs::{rational_spectrum, seen, shown};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use models::double_integrator::{Potential, State, kinetic_energy, potential_energy, random_vectors};

/// For each pair a potential of Definition 3 with the least value 0, increasing beyond its minimum, and the squared distance of that.
type Potentials = fn(usize, usize) -> (Potential, Rational);

/// The same for all pairs, twice; then such as want neighbours in a row at distance 10 and all others at distance 1.
const POTENTIALS: [(&str, Potentials); 3] = [
    ("V = s + 1/s - 2", |_, _| (spring(), rational(1, 1))),
    ("a potential with an inflection", |_, _| (Potential::with_inflection(&rational(2, 1)), rational(1, 1))),
    ("V = s/m + m/s - 2, m = 100 for neighbours in a row, else 1", |i, j| {
        let m = rational(if i.abs_diff(j) == 1 { 100 } else { 1 }, 1);
        (Potential::inverse_square_spring(&m, &rational(1, 1)), m)
    }),
];

/// `W`.
fn energy(state: &State<Rational>, graph: &Graph, potentials: Potentials) -> Result<Rational, ArithmeticError> {
    let value = |i: usize, j: usize, s: &Rational| potentials(i, j).0.rational_value(s);
    Ok(potential_energy(&state.positions, &graph.edges(), PLANE, value)? + kinetic_energy(&state.velocities, PLANE)?)
}

fn in_a_row(count: usize, spacing: (i64, i64), speed: i64) -> (Graph, State<Rational>) {
    let at = |i: usize| [rational(spacing.0 * i as i64, spacing.1), rational(0, 1)];
    let moving = |i: usize| [rational(if i == 0 { speed } else { 0 }, 1), rational(0, 1)];
    let state = State { positions: (0..count).map(at).collect(), velocities: (0..count).map(moving).collect() };
    (Graph::path(count), state)
}

/// Agents in a row, a pair that parts, then random states: with graphs, smaller ones first.
fn states(run: &Run) -> Vec<(Graph, State<Rational>)> {
    let mut random = run.random(1);
    let mut found = Vec::new();
    for count in 1..=5 {
        found.extend([(2, 1), (3, 2), (1, 1), (10, 1)].map(|spacing| in_a_row(count, spacing, 0)));
        found.push(in_a_row(count, (1, 1), 1));
    }
    let (graph, mut parting) = in_a_row(2, (1, 1), 1);
    parting.velocities[1][0] = rational(-1, 1);
    found.push((graph, parting));
    // Agent 1 at the distance 10 from agent 2 and 1 from agent 3.
    let places = [(0, 0), (10, 0), (0, 1)].map(|(x, y)| [rational(x, 1), rational(y, 1)]);
    let still = places.iter().map(|_| [rational(0, 1), rational(0, 1)]).collect();
    let corner = connected(3).into_iter().find(|graph| graph.order() == 3 && graph.edges() == [(0, 1), (0, 2)]);
    found.extend(corner.map(|graph| (graph, State { positions: places.to_vec(), velocities: still })));
    for graph in connected(4) {
        for _ in 0..run.cases(4, 40) {
            found.push((graph.clone(), apart(graph.order(), &mut random)));
        }
    }
    found
}

/// The states with potentials and the energy, where that is finite.
fn with_energy(run: &Run) -> impl Iterator<Item = (Graph, State<Rational>, &'static str, Potentials, Rational)> {
    states(run).into_iter().flat_map(|(graph, state)| {
        POTENTIALS.into_iter().filter_map(move |(name, potentials)| {
            let c = energy(&state, &graph, potentials).ok()?;
            Some((graph.clone(), state.clone(), name, potentials, c))
        })
    })
}

/// Whose `V^{-1}` it is: of the pair itself, the largest or the least of those of the edges.
#[derive(Clone, Copy)]
enum Whose {
    Own,
    Largest,
    Least,
}

/// The factors as functions of `N`, and whose `V^{-1}`.
#[derive(Clone, Copy)]
pub struct DistanceVariant {
    inside: fn(i64) -> Rational,
    outside: fn(i64) -> i64,
    whose: Whose,
}

const DISTANCE: DistanceVariant =
    DistanceVariant { inside: |_| rational(1, 1), outside: |n| n - 1, whose: Whose::Largest };

fn distances(variant: &DistanceVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = "exact values for rows of up to 5 agents and random states on every connected graph of up to 4, potentials that are the same for all pairs and that are not";
    let evidence = exact("the bound of distances", detail);
    run.every(evidence, with_energy(run), |(graph, state, name, potentials, c)| {
        let count = graph.order() as i64;
        let (bound, outside) = (&c * (variant.inside)(count), rational((variant.outside)(count), 1));
        // |r|/outside <= V^{-1}(bound), the largest distance with V <= bound.
        let within = |s: &Rational, (i, j)| {
            let scaled = s / (&outside * &outside);
            let (potential, least) = potentials(i, j);
            Ok::<_, ArithmeticError>(scaled <= least || potential.rational_value(&scaled)? <= bound)
        };
        for (i, j) in pairs(graph.order()) {
            let s = PLANE.square(&state.separation(i, j));
            let pairs = if matches!(variant.whose, Whose::Own) { vec![(i, j)] } else { graph.edges() };
            let near = pairs.into_iter().map(|pair| within(&s, pair)).collect::<Result<Vec<_>, _>>()?;
            let all = matches!(variant.whose, Whose::Least);
            let holds = if all { near.iter().all(|near| *near) } else { near.contains(&true) };
            if !holds {
                let places: Vec<String> = state.positions.iter().map(|r| format!("({}, {})", r[0], r[1])).collect();
                let text = format!(
                    "{} at {}, {name}, c = W = {c}: |r_{}{}|² = {s} is too large",
                    shown(&graph),
                    places.join(", "),
                    i + 1,
                    j + 1
                );
                return Ok(Some(Counterexample::new(text, [Witness::agents(&state.positions, &[], &graph.edges())])));
            }
        }
        Ok(None)
    })
}

pub fn bound_r() -> Record<DistanceVariant> {
    Record::new(
        "tanner2.bound_r",
        "W <= c gives V_e <= c for each edge, so |r_e| <= V_e^{-1}(c), and a path of at most N - 1 edges gives (N - 1) times the largest of these. In print the factor stands inside, \
         and V^{-1} is that of the pair. Three agents in a row, 2 apart, with V = s + 1/s - 2 have W = 9/2, \
         and |r_13|² = 16, but V <= 9 only for s < 11. (At the distance 1 they have W = 0 and |r_13| = 2 > 1 = V^{-1}(0).) If V_12 and V_23 want the distance 10 and V_13 wants 1, then even (N - 1) V_13^{-1}(c) is too small.",
        DistanceVariant { inside: |n| rational(n - 1, 1), outside: |_| 1, whose: Whose::Own },
        |variant, run| {
            let steps = "notes/tanner2.md, Bounds, steps 1 to 3";
            Run::all([distances(variant, run).checks("step 3"), argued(&[1], "the bound of distances", steps)])
        },
    )
    .reading("V^{-1}(c) is the largest distance at which V <= c; N >= 2, as one agent has no edge")
    .repaired(
        Fault::Slip,
        "For a connected graph of N >= 2 agents with potentials of Definition 3, W <= c implies |r_ij| <= (N - 1) max_e V_e^{-1}(c) for all \
         i, j, with the largest value over the edges e and V_e^{-1}(c) the largest distance at which V_e <= c.",
        DISTANCE,
    )
    .altered("(N - 1) min_e V_e^{-1}(c)", |v| v.whose = Whose::Least)
    .altered("(N - 1) max_e V_e^{-1}(c/2)", |v| v.inside = |_| rational(1, 2))
    .altered("(N - 1) V_ij^{-1}(c), of the pair itself", |v| v.whose = Whose::Own)
}

/// `|v_i|² <= factor c`, or `|v_i - v_j|² <= factor c`.
#[derive(Clone, Copy)]
pub struct SpeedVariant {
    factor: i64,
    relative: bool,
}

const SPEED: SpeedVariant = SpeedVariant { factor: 2, relative: false };

fn speeds(variant: &SpeedVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = "exact values for rows of up to 5 agents and random states";
    run.instances("the bound of speeds", detail, with_energy(run), |(graph, state, _, _, c)| {
        let bound = &c * rational(variant.factor, 1);
        let fast = if variant.relative {
            let squares = pairs(graph.order()).map(|(i, j)| PLANE.square(&state.relative_velocity(i, j)));
            squares.max().map(|square| (square, "a relative speed squared"))
        } else {
            state.velocities.iter().map(|v| PLANE.square(v)).max().map(|square| (square, "a speed squared"))
        };
        let fast = fast.filter(|(square, _)| *square > bound);
        let text = |square, what| format!("{}, c = W = {c}: {what} is {square}", shown(&graph));
        Ok(fast.map(|(square, what)| Counterexample::new(text(square, what), [seen(&graph)])))
    })
}

pub fn bound_v() -> Record<SpeedVariant> {
    Record::new(
        "tanner2.bound_v",
        "W contains half of |v_i|²: W <= c gives |v_i|² <= 2c, and equality is reached (the others at rest, distances as desired, V >= 0 with minimum 0). \
         The factor 2 is missing in print; one agent is enough to see it.",
        SpeedVariant { factor: 1, ..SPEED },
        |variant, run| {
            Run::all([speeds(variant, run).checks("step 4"), argued(&[1], "the bound of speeds", "notes/tanner2.md, Bounds, step 4")])
        },
    )
    .repaired(Fault::Slip, "With potentials that are not negative W <= c implies v_i^T v_i <= 2c, yielding |v_i| <= sqrt(2c).", SPEED)
    .altered("|v_i - v_j|² <= 2c", |v| v.relative = true)
}

/// Which sets `W <= c` are said to be compact.
#[derive(Clone)]
pub struct CompactVariant {
    connected: bool,
    /// In the coordinates `r_ij`, not `r_i`.
    relative: bool,
    potential: Potential,
}

/// Whether `W` grows when some of the agents in a row are moved away.
fn grows(variant: &CompactVariant, graph: &Graph, moves: fn(usize, usize) -> bool) -> Result<bool, ArithmeticError> {
    let count = graph.order();
    let at = |far: i64| {
        let (_, mut state) = in_a_row(count, (1, 1), 0);
        for (i, place) in state.positions.iter_mut().enumerate().filter(|(i, _)| moves(*i, count)) {
            place[0] = rational(i as i64 + far, 1);
        }
        let value = |_: usize, _: usize, s: &Rational| variant.potential.rational_value(s);
        potential_energy(&state.positions, &graph.edges(), PLANE, value)
    };
    Ok(at(1_000_000)? > at(0)? + rational(1, 1))
}

fn examine_compact(variant: &CompactVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let graphs = if variant.connected { connected(3) } else { (1..=3).flat_map(Graph::all).collect() };
    // Motions to infinity: one agent away from the others in a row, or all together.
    let ways: &[fn(usize, usize) -> bool] =
        if variant.relative { &[|i, n| n > 1 && i + 1 == n] } else { &[|i, n| i + 1 == n, |_, _| true] };
    let cases = graphs.iter().flat_map(|graph| ways.iter().map(move |way| (graph, *way)));
    let detail = "exact energies of a row of agents and of the row with some moved away";
    let far = run.instances("boundedness", detail, cases, |(graph, way)| {
        let moved = (0..graph.order()).any(|i| way(i, graph.order()));
        Ok((moved && !grows(variant, graph, way)?).then(|| {
            format!("{} in a row: moving some of them by 10^6 leaves W below its first value plus 1", shown(graph))
        }))
    })?;
    Run::all([
        Ok(far.on([1])).checks("the conclusion"),
        distances(&DISTANCE, run).checks("step 3").on([1]),
        speeds(&SPEED, run).checks("step 4").on([2]),
        argued(&[1, 2, 3], "Omega is bounded and closed", "notes/tanner2.md, Bounds, steps 1 to 5"),
    ])
}

pub fn eq7() -> Record<CompactVariant> {
    Record::new(
        "tanner2.eq7",
        "Bounded: |v_i|² <= 2c and |r_ij| <= (N - 1) max_e V_e^{-1}(c) (the printed bounds corrected), finite because V is radially unbounded. Closed: W is continuous \
         where linked agents are apart and tends to infinity where they meet, so limits of points with W <= c are such points.",
        CompactVariant { connected: true, relative: true, potential: spring() },
        examine_compact,
    )
    .clauses(&[
        "For a connected graph all r_ij are bounded on Omega.",
        "All v_i are bounded on Omega.",
        "Omega is closed.",
    ])
    .reading("in the relative positions r_ij and the velocities, as (7) is printed")
    .altered("any graph", |v| v.connected = false)
    .altered("in the positions r_i", |v| v.relative = false)
    .altered("a bounded potential, 1/(2s²) - 1/s + 1/2", |v| v.potential = sloped(&[(-2, 1), (-3, -1)], 0))
}

/// `Wdot <= -factor lambda_index |part|²`, with the part along 1 or the one normal to it.
#[derive(Clone, Copy)]
pub struct DissipationVariant {
    along: bool,
    /// The eigenvalue from below, from 1; 0 for the largest.
    index: usize,
    factor: i64,
}

/// A graph, its Laplacian, a rate and the velocities along one axis.
type Dissipation = (Graph, RationalMatrix, Rational, Vec<Rational>);

/// Connected graphs of 2 to 5 agents with rational spectra, the rate of a variant, and velocities along one axis: a common one, the
/// eigenvectors of `lambda_2`, and random ones.
fn dissipations(variant: &DissipationVariant, run: &Run) -> Result<Vec<Dissipation>, CheckError> {
    let mut random = run.random(2);
    let mut found = Vec::new();
    for graph in connected(5).into_iter().filter(|graph| graph.order() > 1) {
        let Some(values) = rational_spectrum(&graph)? else { continue };
        let index = if variant.index == 0 { values.len() } else { variant.index.min(values.len()) };
        let rate = &values[index - 1] * rational(variant.factor, 1);
        let laplacian = graph.laplacian()?;
        let shift = RationalMatrix::identity(graph.order())?.scaled(&values[1]);
        let mut velocities = vec![vec![rational(1, 1); graph.order()]];
        velocities.extend(laplacian.minus(&shift)?.kernel());
        let mut drawn = || random_vectors(graph.order(), &mut random).into_iter().map(|[x, _]| x).collect();
        velocities.extend((0..4).map(|_| drawn()));
        found.extend(velocities.into_iter().map(|v| (graph.clone(), laplacian.clone(), rate.clone(), v)));
    }
    Ok(found)
}

fn examine_dissipation(variant: &DissipationVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let cases = dissipations(variant, run)?;
    let detail = "exact on connected graphs of up to 5 agents with rational eigenvalues, with equality at the eigenvectors of lambda_2";
    let instances = run.instances("dW/dt by lambda_2", detail, cases, |(graph, laplacian, rate, v)| {
        let mean = v.iter().sum::<Rational>() / rational(v.len() as i64, 1);
        let part = |x: &Rational| if variant.along { mean.clone() } else { x - &mean };
        let square: Rational = v.iter().map(|x| part(x) * part(x)).sum();
        let (change, bound) = (-quadratic(&laplacian, &v), -(rate * square));
        let shown_velocities: Vec<String> = v.iter().map(ToString::to_string).collect();
        Ok((change > bound).then(|| {
            let text = format!(
                "{}, v_x = {shown_velocities:?}, v_y = 0: dW/dt = {change}, but the bound is {bound}",
                shown(&graph)
            );
            Counterexample::new(text, [seen(&graph), Witness::compared("dW/dt", &change, "the bound", &bound)])
        }))
    });
    Run::all([instances.checks("step 1"), argued(&[1], "dW/dt by lambda_2", "notes/tanner2.md, Corollary 2, step 1")])
}

pub fn cor2_sub() -> Record<DissipationVariant> {
    Record::new(
        "tanner2.cor2_sub",
        "x^T L x >= lambda_2 |x|² for x normal to 1 (Courant and Fischer): the bound holds with the parts v_n normal to 1. The printed subscripts p name the parts along 1, \
         and with them a flock that moves with a common velocity has dW/dt = 0 but a negative bound.",
        DissipationVariant { along: true, index: 2, factor: 1 },
        examine_dissipation,
    )
    .reading("N >= 2: one agent has no lambda_2")
    .repaired_by(
        Fault::Typo,
        "Under (4) on a connected graph of N >= 2 agents Wdot <= -lambda_2 (|v_{x_n}|² + |v_{y_n}|²), with v_{x_n}, v_{y_n} the parts of \
         v_x and v_y normal to 1, in Euclidean norms.",
        |v| v.along = false,
    )
    .altered("lambda_3 in place of lambda_2", |v| v.index = 3)
    .altered("2 lambda_2", |v| v.factor = 2)
}
