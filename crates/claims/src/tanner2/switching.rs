//! tanner2.arbswitch, thm2_stop: switching by any signal, and switching by distance that ends or does not.

use super::nonsmooth::{HullVariant, examine_hull};
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use algebra::spectrum::Polynomial;
use arithmetic::{Rational, Ring, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{
    Coordinates, Pair, Potential, State, linearisation, linked_within, potential_gradients, tied,
};

// --- Arbitrary switching ---

/// How the links switch.
#[derive(Clone)]
pub enum SignalVariant {
    /// From one connected graph on four agents to the next after equal times.
    Periodic(Vec<Vec<Pair>>),
    /// By distance, with a graph that stays connected.
    ByDistance,
}

/// Two paths through four agents that together have all six edges.
fn two_paths() -> Vec<Vec<Pair>> {
    vec![vec![(0, 1), (1, 2), (2, 3)], vec![(1, 3), (0, 3), (0, 2)]]
}

/// The edges whose potential has to be least in a configuration that is critical for every graph in turn. Trees only: on a tree every
/// single force vanishes.
fn forced(graphs: &[Vec<Pair>]) -> Option<Graph> {
    let empty = Graph::empty(4);
    graphs.iter().try_fold(empty.clone(), |union, edges| {
        let graph = empty.with_edges(edges);
        (graph.is_connected() && graph.edges().len() == 3).then(|| union.with_edges(edges))
    })
}

/// The dimension of a regular simplex with so many corners: the rank of the Gram matrix of its edges at one corner.
pub(crate) fn dimension_of_regular_simplex(corners: usize) -> Result<usize, CheckError> {
    let edges = corners - 1;
    let rows: Vec<Vec<i64>> = (0..edges).map(|i| (0..edges).map(|j| 1 + i64::from(i == j)).collect()).collect();
    Ok(edges - RationalMatrix::from_integers(&rows, 2)?.kernel().len())
}

fn examine_signal(variant: &SignalVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let SignalVariant::Periodic(graphs) = variant else {
        return examine_hull(&HullVariant::Subset, run);
    };
    let union = forced(graphs).ok_or_else(|| CheckError::Other("spanning trees of four agents".to_string()))?;
    if union.edges().len() == 6 && dimension_of_regular_simplex(4)? > 2 {
        let what = format!(
            "four agents, V = s + 1/s - 2, links {:?} in turn for equal times, from any start without collision: if the velocities agreed in the limit, all six distances would tend to 1, which no four points of the plane have",
            graphs
        );
        let detail = "a critical configuration of a tree has every linked distance 1; Gram matrix of the regular simplex, exact; the limit argument is in notes/tanner2.md";
        return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "velocities under periodic switching", detail)));
    }
    Ok(Outcome::Undecided("the graphs have a common critical configuration".to_string()))
}

pub fn arbitrary() -> Record<SignalVariant> {
    let [first, second] = [two_paths()[0].clone(), two_paths()[1].clone()];
    Record::new(
        "tanner2.arbswitch",
        "Q is no Lyapunov function for a switch that does not happen at |r_ij| = R: there energy may jump up. Let four agents use the paths 1-2-3-4 and 2-4-1-3 in turn for a fixed time each, both connected. If the velocities agreed in the limit, the \
         forces on every edge of the path in use would tend to zero in the mean, so all three distances to 1; the positions hardly move in one period, so all six distances to 1: impossible in the plane. So the velocities never agree, from any start. \
         What Section 5 analyses is switching by distance.",
        SignalVariant::Periodic(two_paths()),
        examine_signal,
    )
    .repaired(
        Fault::False,
        "Velocities agree in the limit if links switch by distance, as in (10), and the graph stays connected (tanner2.thm2_vel); not for arbitrary switching signals.",
        SignalVariant::ByDistance,
    )
    .control("the paths in the other order", SignalVariant::Periodic(vec![second.clone(), first.clone()]))
    .control("the paths and a star in turn", SignalVariant::Periodic(vec![first, second, vec![(0, 1), (0, 2), (0, 3)]]))
}

// --- Switching by distance eventually stops ---

/// Potentials with a threshold `R²`.
type StopVariant = Vec<(Potential, Rational)>;

/// Two equilateral triangles side by side: agents 1 and 3 at squared distance 3, the other five distances 1.
fn rhombus() -> State<Rational> {
    let q = |n: i64| rational(n, 1);
    State {
        positions: [(0, 1), (0, 0), (1, -1), (1, 0)].iter().map(|&(x, y)| [q(x), q(y)]).collect(),
        velocities: vec![[q(0), q(0)]; 4],
    }
}

/// The linearised loop on the motions that keep both diagonals of the rhombus: the displacements of agent 4 along the short diagonal and of
/// agent 1 along the long one, and their rates.
fn symmetric_modes(edges: &[Pair], potential: &Potential) -> Result<Polynomial, CheckError> {
    let matrix = RationalMatrix::from_rows(&linearisation(&rhombus(), edges, Coordinates::Triangular, potential)?)?;
    let q = |n: i64, d: i64| rational(n, d);
    // Agents 1, 2, 3, 4 in triangular coordinates: 2 and 4 part along (1, 0); 1 and 3 part along (-1/2, 1).
    let short = [(0, 1), (0, 1), (-1, 1), (0, 1), (0, 1), (0, 1), (1, 1), (0, 1)];
    let long = [(-1, 2), (1, 1), (0, 1), (0, 1), (1, 2), (-1, 1), (0, 1), (0, 1)];
    let mut rows = vec![vec![q(0, 1); 4]; 4];
    for column in 0..4 {
        let mode = if column % 2 == 0 { short } else { long };
        let mut vector = vec![q(0, 1); 16];
        for (k, (n, d)) in mode.into_iter().enumerate() {
            vector[8 * (column / 2) + k] = q(n, d);
        }
        let image = matrix.apply(&vector)?;
        // Read off at agent 4 (first coordinate) and at agent 1 (second coordinate), positions and then velocities.
        for (row, place) in [6, 1, 14, 9].into_iter().enumerate() {
            rows[row][column] = image[place].clone();
        }
    }
    let polynomial = RationalMatrix::from_rows(&rows)?.characteristic_polynomial()?;
    Ok(Polynomial::from_rationals(&polynomial.coefficients()))
}

/// Whether all modes decay and turn: no real roots.
fn only_decaying_oscillations(modes: &Polynomial) -> bool {
    let bound = modes
        .coefficients()
        .iter()
        .fold(rational(1, 1), |sum, c| sum + Rational::from_integer(num_traits::Signed::abs(c)));
    modes.is_hurwitz() && modes.is_square_free() && modes.roots_in(&-bound.clone(), &bound).is_empty()
}

/// Whether the rhombus with its long diagonal at R is an equilibrium with and without that link, which symmetric motions nearby approach
/// in decaying oscillations on both sides.
pub(crate) fn symmetric_motions_cross_for_ever(potential: &Potential, square: &Rational) -> Result<bool, CheckError> {
    let state = rhombus();
    let linked = linked_within(&state.positions, square, Coordinates::Triangular);
    if tied(&state.positions, square, Coordinates::Triangular) != [(0, 2)] || !linked.is_connected() {
        return Ok(false);
    }
    for edges in [linked.edges(), linked.with_edges(&[(0, 2)]).edges()] {
        let slope = |_: usize, _: usize, s: &Rational| potential.slope(s);
        let forces = potential_gradients(&state.positions, &edges, Coordinates::Triangular, slope)?;
        let rests = forces.iter().flatten().all(|x| *x == x.zero());
        if !rests || !only_decaying_oscillations(&symmetric_modes(&edges, potential)?) {
            return Ok(false);
        }
    }
    Ok(true)
}

fn examine_stop(variant: &StopVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    for (potential, square) in variant {
        let jump = potential.slope(square)? * square * rational(8, 1);
        if jump > jump.zero() {
            continue;
        }
        if symmetric_motions_cross_for_ever(potential, square)? {
            let what = format!(
                "four agents near two equilateral triangles side by side, R² = {square}, V'(R²) = 0: symmetric motions tend to this rhombus in decaying oscillations on both sides, so agents 1 and 3 pass |r_13| = R for ever"
            );
            let detail = "characteristic polynomials of the symmetric modes with and without the link: stable, no real root (Sturm, Routh)";
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "switching near the rhombus", detail)));
        }
        return Ok(Outcome::Undecided("the slope at R is zero".to_string()));
    }
    let detail = "argument in notes/tanner2.md for V'(R²) > 0 and one pair at R: the second derivative of |r_ij|² falls by 8 V'(R²) R² where a link closes, so that a crossing at a late time would leave a speed that does not tend to zero; the jump, exact";
    let own =
        Outcome::Holds(vec![Evidence::new(Grade::Exact, "crossings of R at late times", detail).cases(variant.len())]);
    Run::all([Ok(own), examine_hull(&HullVariant::Subset, run)])
}

/// The potential with slope `(s - 1)(s - 3)²/s²` and minimum 0 at `s = 1`.
fn logarithmic_inflection() -> Potential {
    let slope = [(1, 1), (0, -7), (-1, 15), (-2, -9)].map(|(k, c)| (k, rational(c, 1)));
    Potential::new(slope.to_vec(), (rational(1, 1), rational(0, 1)))
}

pub fn stops() -> Record<StopVariant> {
    let one = rational(1, 1);
    Record::new(
        "tanner2.thm2_stop",
        "Definition 3 and Lemma 1 ask for a potential that increases at R, not for a positive slope there. With slope zero at R four agents near two equilateral triangles side by side \
         switch for ever on a graph that is connected at all times, although their velocities agree in the limit. With a positive slope and one pair at distance R in the limit \
         configuration switching ends: the link pulls with a force that jumps, so after or before a late crossing the relative speed would change at a rate bounded away from 0 for a fixed time. With \
         several pairs at R at once this is open (notes/tanner2.md).",
        vec![
            (Potential::inverse_square_spring(&one, &one), rational(4, 1)),
            (Potential::with_inflection(&rational(3, 1)), rational(3, 1)),
        ],
        examine_stop,
    )
    .repaired(
        Fault::False,
        "If V'(R) > 0 and no limit configuration has more than one pair at distance R, then from some time on no pair passes from one side of R to the other without \
         staying at R in between.",
        vec![
            (Potential::inverse_square_spring(&one, &one), rational(4, 1)),
            (Potential::inverse_square_log(&one), rational(4, 1)),
        ],
    )
    .control("slope zero at R² = 3", vec![(Potential::with_inflection(&rational(3, 1)), rational(3, 1))])
    .control("V' = (s - 1)(s - 3)²/s², slope zero at R² = 3", vec![(logarithmic_inflection(), rational(3, 1))])
    .control("with another potential of positive slope", vec![
        (Potential::inverse_square_log(&one), rational(4, 1)),
        (Potential::with_inflection(&rational(3, 1)), rational(3, 1)),
    ])
}
