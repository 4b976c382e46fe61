//! tanner2.cor2_rate: how fast velocities agree, by exact linearisations.

use super::arbitrary::Arbitrary;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use algebra::spectrum::Polynomial;
use arithmetic::{Rational, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Potential, State, linearisation};

/// What is said of the rate at which the flock converges.
#[derive(Clone, Copy)]
pub enum RateVariant {
    /// With potentials, `lambda_2` determines it, and more edges make it larger.
    WithPotentials,
    /// With potentials, more edges make it larger.
    MoreEdges,
    /// Without potentials it is this multiple of the eigenvalue of this index from below (0: the largest).
    Alignment((i64, i64), usize),
}

/// The modes of the linearised loop without those of rate zero.
fn modes(
    state: &State<Rational>,
    graph: &Graph,
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<Polynomial, CheckError> {
    let rows = linearisation(state, &graph.edges(), coordinates, potential)?;
    let polynomial = RationalMatrix::from_rows(&rows)?.characteristic_polynomial()?;
    Ok(Polynomial::from_rationals(&polynomial.coefficients()).without_root(0).1)
}

/// Whether every mode decays faster than `exp(-rate t)`.
fn faster_than(modes: &Polynomial, rate: &Rational) -> bool {
    modes.with_roots_moved(rate).is_hurwitz()
}

fn at_rest(places: &[(i64, i64)]) -> State<Rational> {
    let q = |n: i64| rational(n, 1);
    State {
        positions: places.iter().map(|&(x, y)| [q(x), q(y)]).collect(),
        velocities: places.iter().map(|_| [q(0), q(0)]).collect(),
    }
}

fn spring(stiffness: (i64, i64)) -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(stiffness.0, stiffness.1))
}

/// Two linked agents with two stiffnesses: the same `lambda_2 = 2`, different rates.
fn same_connectivity() -> Result<Option<String>, CheckError> {
    let (state, graph, q) = (at_rest(&[(0, 0), (1, 0)]), Graph::path(2), rational(1, 2));
    let faster = |stiffness| {
        Ok::<bool, CheckError>(faster_than(&modes(&state, &graph, Coordinates::Cartesian, &spring(stiffness))?, &q))
    };
    Ok((faster((1, 1))? != faster((1, 32))?).then(|| {
        "two agents, lambda_2 = 2, V = k(s + 1/s - 2): with k = 1 every mode decays faster than exp(-t/2), with k = 1/32 not".to_string()
    }))
}

/// The path of three in a row and the triangle, at the desired distances, V = (s + 1/s - 2)/32: `lambda_2` is 1 and 3.
fn more_edges() -> Result<Option<String>, CheckError> {
    let (soft, q) = (spring((1, 32)), rational(1, 5));
    let path = modes(&at_rest(&[(-1, 0), (0, 0), (1, 0)]), &Graph::path(3), Coordinates::Cartesian, &soft)?;
    let complete = Graph::from_fn(3, |_, _| true);
    let triangle = modes(&at_rest(&[(0, 0), (1, 0), (0, 1)]), &complete, Coordinates::Triangular, &soft)?;
    Ok((faster_than(&path, &q) && !faster_than(&triangle, &q)).then(|| {
        "V = (s + 1/s - 2)/32 at the desired distances: every mode of the path of three in a row (lambda_2 = 1) decays faster than exp(-t/5), but not every mode of the triangle (lambda_2 = 3)".to_string()
    }))
}

fn examine(variant: &RateVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let fails = |what: String| {
        Ok(Outcome::fails(
            what,
            Evidence::new(
                Grade::Exact,
                "rates of the linearised loop",
                "exact characteristic polynomials, Routh's criterion",
            ),
        ))
    };
    if matches!(variant, RateVariant::WithPotentials)
        && let Some(what) = same_connectivity()?
    {
        return fails(what);
    }
    if matches!(variant, RateVariant::WithPotentials | RateVariant::MoreEdges)
        && let Some(what) = more_edges()?
    {
        return fails(what);
    }
    let RateVariant::Alignment(factor, index) = *variant else {
        return Ok(Outcome::Undecided("no counterexample among two and three agents".to_string()));
    };
    let (none, mut cases) = (Potential::new(Vec::new(), (rational(1, 1), rational(0, 1))), 0);
    for graph in Arbitrary::connected(4).into_iter().filter(|graph| graph.order() > 1) {
        run.checkpoint()?;
        let spectrum = graph.laplacian()?.characteristic_polynomial()?.rational_eigenvalues();
        let mut values: Vec<Rational> = spectrum.into_iter().flat_map(|(x, times)| vec![x; times]).collect();
        values.reverse();
        if values.len() < graph.order() {
            continue;
        }
        let index = if index == 0 { values.len() } else { index };
        let rate = &values[index - 1] * rational(factor.0, factor.1);
        let places: Vec<(i64, i64)> = (0..graph.order() as i64).map(|k| (k, k * k)).collect();
        let modes = modes(&at_rest(&places), &graph, Coordinates::Cartesian, &none)?;
        let small = rational(1, 1000);
        cases += 1;
        if !faster_than(&modes, &(&rate - &small)) || faster_than(&modes, &(&rate + &small)) {
            return fails(format!(
                "{} agents, edges {:?}, no potentials: the slowest rate is not {rate}",
                graph.order(),
                graph.edges()
            ));
        }
    }
    let detail = "v = -Lv is linear: the slowest part normal to 1 decays like exp(-lambda_2 t), and a new edge never lowers lambda_2 (tanner2.cor2_merris); connected graphs of up to 4 agents with rational spectra, within 1/1000";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "rates of the linearised loop", detail).cases(cases)]))
}

pub fn rate() -> Record<RateVariant> {
    Record::new(
        "tanner2.cor2_rate",
        "dW/dt <= -lambda_2 |v_n|² bounds how fast energy is lost at a given disagreement, not how fast W or the velocities tend to their limits: that depends on the potentials too. Near an equilibrium a mode obeys \
         x'' + l x' + h x = 0, with l from the Laplacian and h from the potentials; for h small its rate is about h/l, which falls as l grows. Two agents have rates below and above 1/2 for different potentials at the same lambda_2 = 2, and closing the path of three to a \
         triangle raises lambda_2 from 1 to 3 and lowers the rate. (Linearised modes of rate 0, which keep the shape or move it along equilibria, are left out.)",
        RateVariant::WithPotentials,
        examine,
    )
    .repaired(
        Fault::False,
        "Without potentials the disagreement decays exactly like exp(-lambda_2 t), and new edges never slow it; with them lambda_2 bounds the loss of energy, dW/dt <= -lambda_2 |v_n|², not the rate.",
        RateVariant::Alignment((1, 1), 2),
    )
    .control("with potentials, more edges make it faster", RateVariant::MoreEdges)
    .control("without potentials, the largest eigenvalue", RateVariant::Alignment((1, 1), 0))
    .control("without potentials, 2 lambda_2", RateVariant::Alignment((2, 1), 2))
}
