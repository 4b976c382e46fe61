//! What the checks of both papers share: potentials, graphs, random states, sums, and the proofs on paper.

use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use models::double_integrator::{
    AnyPotentials, Coordinates, Pair, Potential, State, disagreements, dot, random_vectors, scaled, sum,
};
use rand_chacha::ChaCha8Rng;

pub(crate) const PLANE: Coordinates = Coordinates::Cartesian;

/// How the theorems of the second paper are read.
pub(crate) const SMOOTH: &str = "potentials of Definition 3 with a continuous gradient (\"the control laws are smooth\", Section 4), starts in which no linked agents coincide";

/// `s + 1/s - 2`.
pub(crate) fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

/// `1/s + log s`, the choice that the first paper prints.
pub(crate) fn printed() -> Potential {
    Potential::inverse_square_log(&rational(1, 1))
}

/// The potential with the slope `sum c s^k` and a value at `s = 1`.
pub(crate) fn sloped(slope: &[(i32, i64)], value: i64) -> Potential {
    Potential::new(slope.iter().map(|&(k, c)| (k, rational(c, 1))).collect(), (rational(1, 1), rational(value, 1)))
}

/// `(s - 1)²`, bounded where agents meet.
pub(crate) fn soft() -> Potential {
    sloped(&[(1, 2), (0, -2)], 0)
}

/// Connected graphs of up to `most` vertices, one of each isomorphism class.
pub(crate) fn connected(most: usize) -> Vec<Graph> {
    (1..=most).flat_map(Graph::connected_up_to_isomorphism).collect()
}

/// All pairs of so many agents.
pub(crate) fn pairs(count: usize) -> impl Iterator<Item = Pair> {
    (0..count).flat_map(|j| (0..j).map(move |i| (i, j)))
}

/// A random state in which no two agents are in one place. Such states are drawn again, so that the number of cases does not depend on the seed.
pub(crate) fn apart(count: usize, random: &mut ChaCha8Rng) -> State<Rational> {
    loop {
        let [positions, velocities] = [0, 1].map(|_| random_vectors(count, random));
        if pairs(count).all(|(i, j)| positions[i] != positions[j]) {
            return State { positions, velocities };
        }
    }
}

pub(crate) fn total<T: Ring>(like: &T, list: impl IntoIterator<Item = T>) -> T {
    list.into_iter().fold(like.zero(), |sum, x| sum + x)
}

/// `x^T M x`.
pub(crate) fn quadratic<T: Field>(matrix: &RationalMatrix, x: &[T]) -> T {
    let term = |(i, j): (usize, usize)| x[i].clone() * &x[j] * x[i].rational(&matrix.entry(i, j));
    let entries = (0..x.len()).flat_map(|i| (0..x.len()).map(move |j| (i, j)));
    total(&x[0], entries.filter(|&(i, j)| !num_traits::Zero::is_zero(&matrix.entry(i, j))).map(term))
}

/// Runs an identity on connected graphs of up to `most` agents, one of each class.
pub(crate) fn on_connected<'a>(
    run: &Run,
    most: usize,
    what: &str,
    identity: impl Fn(Graph) -> Identity<'a>,
) -> Result<Outcome, CheckError> {
    Run::all(connected(most).into_iter().map(|graph| {
        let mut names = AnyPotentials::names(&graph);
        let part = format!("{what}, {} agents, edges {:?}, any potentials", graph.order(), graph.edges());
        let seen = Witness::networks(graph.order(), vec![graph.edges()]);
        let identity = identity(graph);
        let more = identity.variables().saturating_sub(names.len());
        names.extend((1..=more).map(|k| format!("theta{k}")));
        run.identity(&identity, &names, &part).map(|outcome| outcome.seen(seen))
    }))
}

/// With the alignment of (4) times a factor, `Wdot` is minus the sum of `|v_i - v_j|²` over the edges.
fn edge_sum(graph: Graph, damping: i64) -> Identity<'static> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        let rest = at[0].integer(1 - damping);
        let aligned = disagreements(&flock.state.velocities, &flock.edges);
        let accelerations: Vec<[Probe; 2]> =
            flock.accelerations()?.iter().zip(&aligned).map(|(a, d)| sum(a, &scaled(&rest, d))).collect();
        let rate = flock.energy(&flock.state.moving(&accelerations), (1, 2))?.derivative;
        let squares = flock.edges.iter().map(|&(i, j)| {
            let relative = flock.state.relative_velocity(i, j);
            -dot(&relative, &relative)
        });
        Ok((vec![rate], vec![total(&at[0], squares)]))
    })
}

/// What [`energy_decreases`] checks of the proof of Theorem 1.
pub(crate) const DESCENT: &str = "Identities, step 3, which step 1 uses";

/// Tests that the energy decreases by the sum of `|v_i - v_j|²` over the edges, where alignment is that of (4) times `damping`.
pub(crate) fn energy_decreases(run: &Run, damping: i64) -> Result<Outcome, CheckError> {
    let what = "dW/dt is minus the sum of |v_i - v_j|² over the edges";
    on_connected(run, run.cases(3, 4), what, |graph| edge_sum(graph, damping))
}
