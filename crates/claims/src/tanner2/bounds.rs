//! tanner2.bound_r, bound_v, eq7, cor2_sub: what an energy at most c bounds.

use super::arbitrary::{Arbitrary, quadratic};
use super::random_vectors;
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Rational, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Pair, Potential, State, kinetic_energy, potential_energy};

const PLANE: Coordinates = Coordinates::Cartesian;

/// Rational potentials of Definition 3 with their minimum 0 at distance 1, increasing beyond it.
fn potentials() -> [Potential; 2] {
    [Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)), Potential::with_inflection(&rational(2, 1))]
}

/// `W`.
fn energy(state: &State<Rational>, edges: &[Pair], potential: &Potential) -> Result<Rational, ArithmeticError> {
    let value = |_: usize, _: usize, s: &Rational| potential.rational_value(s);
    Ok(potential_energy(&state.positions, edges, PLANE, value)? + kinetic_energy(&state.velocities, PLANE)?)
}

/// Agents in a row at rest, then random states: with graphs, smaller ones first.
fn states(run: &Run) -> Vec<(Graph, State<Rational>)> {
    let mut random = run.random(1);
    let mut found = Vec::new();
    for count in 1..=5 {
        for (p, q) in [(2, 1), (3, 2), (1, 1)] {
            let at = |i: usize| [rational(p * i as i64, q), rational(0, 1)];
            let rest = vec![[rational(0, 1), rational(0, 1)]; count];
            found.push((Graph::path(count), State { positions: (0..count).map(at).collect(), velocities: rest }));
        }
        let moving = (0..count).map(|i| [rational(i64::from(i == 0), 1), rational(0, 1)]).collect();
        let at = |i: usize| [rational(i as i64, 1), rational(0, 1)];
        found.push((Graph::path(count), State { positions: (0..count).map(at).collect(), velocities: moving }));
    }
    for graph in Arbitrary::connected(4) {
        for _ in 0..run.cases(4, 40) {
            let count = graph.order();
            let state =
                State { positions: random_vectors(count, &mut random), velocities: random_vectors(count, &mut random) };
            found.push((graph.clone(), state));
        }
    }
    found
}

// --- |r_ij| <= outside V^{-1}(inside c) ---

/// The factors as functions of `N`.
#[derive(Clone, Copy)]
pub struct DistanceVariant {
    inside: fn(i64) -> Rational,
    outside: fn(i64) -> i64,
}

/// The bound that holds.
const DISTANCE: DistanceVariant = DistanceVariant { inside: |_| rational(1, 1), outside: |n| n - 1 };

fn examine_distance(variant: &DistanceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for (graph, state) in states(run) {
        run.checkpoint()?;
        let count = graph.order() as i64;
        for potential in potentials() {
            let Ok(c) = energy(&state, &graph.edges(), &potential) else { continue };
            for (i, j) in (0..graph.order()).flat_map(|j| (0..j).map(move |i| (i, j))) {
                let s = PLANE.square(&state.separation(i, j));
                let outside = rational((variant.outside)(count), 1);
                let bound = &c * (variant.inside)(count);
                // |r|/outside <= V^{-1}(bound), the largest distance with V <= bound.
                let within = outside > rational(0, 1) && {
                    let scaled = &s / (&outside * &outside);
                    scaled <= rational(1, 1) || potential.rational_value(&scaled)? <= bound
                };
                cases += 1;
                if !within {
                    let what = format!(
                        "{count} agents at {:?}, edges {:?}, c = W = {c}: |r_{}{}|² = {s} is too large",
                        state.positions.iter().map(|r| format!("({}, {})", r[0], r[1])).collect::<Vec<_>>(),
                        graph.edges(),
                        i + 1,
                        j + 1
                    );
                    return Ok(Outcome::fails(
                        what,
                        Evidence::new(
                            Grade::Exact,
                            "the bound of distances",
                            "exact values of s + 1/s - 2 or of the potential with an inflection",
                        ),
                    ));
                }
            }
        }
    }
    let detail = "for all states: proof in notes/tanner2.md; exact values for rows of up to 5 agents and random states on every connected graph of up to 4";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "the bound of distances", detail).cases(cases)]))
}

pub fn bound_r() -> Record<DistanceVariant> {
    Record::new(
        "tanner2.bound_r",
        "W <= c gives V_e <= c for each edge, so |r_e| <= V^{-1}(c) (the largest distance with V <= c), and a path of at most N - 1 edges gives \
         |r_ij| <= (N - 1) V^{-1}(c). In print the factor stands inside. Three agents in a row, 2 apart, with V = s + 1/s - 2 have W = 9/2, \
         and |r_13|² = 16, but V <= 9 only for s < 11. (At the distance 1 they have W = 0 and |r_13| = 2 > 1 = V^{-1}(0).)",
        DistanceVariant { inside: |n| rational(n - 1, 1), outside: |_| 1 },
        examine_distance,
    )
    .repaired(Fault::Slip, "W <= c implies |r_ij| <= (N - 1) V_ij^{-1}(c) for all i, j, with V^{-1}(c) the largest distance at which V <= c.", DISTANCE)
    .control("(N - 2) V^{-1}(c)", DistanceVariant { outside: |n| n - 2, ..DISTANCE })
    .control("(N - 1) V^{-1}(c/2)", DistanceVariant { inside: |_| rational(1, 2), ..DISTANCE })
}

// --- |v_i|² <= factor c ---

fn examine_speed(factor: &(i64, i64), run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for (graph, state) in states(run) {
        for potential in potentials() {
            let Ok(c) = energy(&state, &graph.edges(), &potential) else { continue };
            cases += 1;
            let bound = &c * rational(factor.0, factor.1);
            if let Some(v) = state.velocities.iter().find(|v| PLANE.square(v) > bound) {
                let what = format!(
                    "{} agents, edges {:?}, c = W = {c}: a speed squared is {}",
                    graph.order(),
                    graph.edges(),
                    PLANE.square(v)
                );
                return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the bound of speeds", "exact energies")));
            }
        }
    }
    let detail = "half of |v_i|² is one of the non-negative terms of W; exact values for rows of up to 5 agents and random states";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "the bound of speeds", detail).cases(cases)]))
}

pub fn bound_v() -> Record<(i64, i64)> {
    Record::new(
        "tanner2.bound_v",
        "W contains half of |v_i|²: W <= c gives |v_i|² <= 2c, and equality is reached (the others at rest, distances as desired, V >= 0 with minimum 0). \
         The factor 2 is missing in print; one agent is enough to see it.",
        (1, 1),
        examine_speed,
    )
    .repaired(Fault::Slip, "W <= c implies v_i^T v_i <= 2c, yielding |v_i| <= sqrt(2c).", (2, 1))
    .control("|v_i|² <= 19c/10", (19, 10))
    .control("|v_i|² <= 3c/2", (3, 2))
}

// --- Compactness ---

/// Which sets `W <= c` are said to be compact.
#[derive(Clone)]
pub struct CompactVariant {
    connected: bool,
    /// In the coordinates `r_ij`, not `r_i`.
    relative: bool,
    potential: Potential,
}

fn examine_compact(variant: &CompactVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = |detail: &str| Evidence::new(Grade::Exact, "boundedness", detail.to_string());
    let graphs = if variant.connected { Arbitrary::connected(3) } else { (1..=3).flat_map(Graph::all).collect() };
    // Motions to infinity: one agent away from the others in a row, or all together.
    let together = |count: usize| vec![true; count];
    let alone = |count: usize| (0..count).map(|i| i + 1 == count).collect::<Vec<bool>>();
    let ways: Vec<fn(usize) -> Vec<bool>> = if variant.relative { vec![alone] } else { vec![alone, together] };
    for graph in graphs {
        let count = graph.order();
        for way in &ways {
            let moves = way(count);
            if variant.relative && count == 1 {
                continue;
            }
            let at = |far: i64| -> Result<Rational, ArithmeticError> {
                let place = |i: usize| [rational(i as i64 + if moves[i] { far } else { 0 }, 1), rational(0, 1)];
                let rest = vec![[rational(0, 1), rational(0, 1)]; count];
                energy(
                    &State { positions: (0..count).map(place).collect(), velocities: rest },
                    &graph.edges(),
                    &variant.potential,
                )
            };
            let levels = [0, 10, 1_000, 1_000_000].map(at);
            let [start, .., far] = levels;
            if far? <= start? + rational(1, 1) {
                let what = format!(
                    "{count} agents in a row, edges {:?}: moving some of them by 10^6 leaves W below its first value plus 1",
                    graph.edges()
                );
                return Ok(Outcome::fails(
                    what,
                    evidence("exact energies of a row of agents and of the row with some moved away"),
                ));
            }
        }
    }
    // The bounds that make the set bounded; it is closed because W is continuous and infinite at collisions of linked agents.
    Run::all([examine_distance(&DISTANCE, run), examine_speed(&(2, 1), run)])
}

pub fn eq7() -> Record<CompactVariant> {
    let printed = CompactVariant {
        connected: true,
        relative: true,
        potential: Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)),
    };
    Record::new(
        "tanner2.eq7",
        "Bounded: |v_i|² <= 2c and |r_ij| <= (N - 1) V^{-1}(c) (the printed bounds corrected), finite because V is radially unbounded. Closed: W is continuous \
         where linked agents are apart and tends to infinity where they meet, so limits of points with W <= c are such points.",
        printed.clone(),
        examine_compact,
    )
    .control("any graph", CompactVariant { connected: false, ..printed.clone() })
    .control("in the positions r_i", CompactVariant { relative: false, ..printed.clone() })
    .control("a bounded potential, 1/(2s²) - 1/s", CompactVariant {
        potential: Potential::new(vec![(-2, rational(1, 1)), (-3, rational(-1, 1))], (rational(1, 1), rational(-1, 2))),
        ..printed
    })
}

// --- Corollary 2: the bound by lambda_2 ---

/// `Wdot <= -factor lambda_index |part|²`, with the part along 1 or the one normal to it.
#[derive(Clone, Copy)]
pub struct DissipationVariant {
    along: bool,
    /// The eigenvalue from below, from 1; 0 for the largest.
    index: usize,
    factor: i64,
}

fn examine_dissipation(variant: &DissipationVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(2);
    let mut cases = 0;
    for graph in Arbitrary::connected(5).into_iter().filter(|graph| graph.order() > 1) {
        let laplacian = graph.laplacian()?;
        let spectrum = laplacian.characteristic_polynomial()?.rational_eigenvalues();
        let mut values: Vec<Rational> = spectrum.into_iter().flat_map(|(x, times)| vec![x; times]).collect();
        values.reverse();
        if values.len() < graph.order() {
            continue;
        }
        let index = if variant.index == 0 { values.len() } else { variant.index.min(values.len()) };
        let rate = &values[index - 1] * rational(variant.factor, 1);
        // A common velocity, the eigenvectors of lambda_2, and random velocities.
        let shift = algebra::matrix::RationalMatrix::identity(graph.order())?.scaled(&values[1]);
        let mut velocities = vec![vec![rational(1, 1); graph.order()]];
        velocities.extend(laplacian.minus(&shift)?.kernel());
        velocities
            .extend((0..4).map(|_| random_vectors(graph.order(), &mut random).into_iter().map(|[x, _]| x).collect()));
        for v in velocities {
            let mean = v.iter().sum::<Rational>() / rational(v.len() as i64, 1);
            let square: Rational =
                v.iter().map(|x| if variant.along { &mean * &mean } else { (x - &mean) * (x - &mean) }).sum();
            cases += 1;
            let change = -quadratic(&laplacian, &v);
            if change > -(&rate * &square) {
                let what = format!(
                    "edges {:?}, v_x = {:?}, v_y = 0: dW/dt = {change}, but the bound is {}",
                    graph.edges(),
                    v.iter().map(ToString::to_string).collect::<Vec<_>>(),
                    -(rate * square)
                );
                return Ok(Outcome::fails(
                    what,
                    Evidence::new(Grade::Exact, "dW/dt by lambda_2", "exact quadratic forms"),
                ));
            }
        }
    }
    let detail = "for all connected graphs of at least two agents by Courant and Fischer; exact on those of up to 5 with rational eigenvalues, with equality at the eigenvectors of lambda_2";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "dW/dt by lambda_2", detail).cases(cases)]))
}

pub fn cor2_sub() -> Record<DissipationVariant> {
    let printed = DissipationVariant { along: true, index: 2, factor: 1 };
    let repaired = DissipationVariant { along: false, ..printed };
    Record::new(
        "tanner2.cor2_sub",
        "x^T L x >= lambda_2 |x|² for x normal to 1 (Courant and Fischer): the bound holds with the parts v_n normal to 1. The printed subscripts p name the parts along 1, \
         and with them a flock that moves with a common velocity has dW/dt = 0 but a negative bound.",
        printed,
        examine_dissipation,
    )
    .repaired(Fault::Slip, "Wdot <= -lambda_2 (|v_{x_n}|² + |v_{y_n}|²), with v_{x_n}, v_{y_n} normal to 1.", repaired)
    .control("the largest eigenvalue", DissipationVariant { index: 0, ..repaired })
    .control("lambda_3", DissipationVariant { index: 3, ..repaired })
    .control("2 lambda_2", DissipationVariant { factor: 2, ..repaired })
}
