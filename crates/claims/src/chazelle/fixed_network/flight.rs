//! Two flocks that fly side by side while their network does not change, stepped exactly.

use super::limits::limit_of_lemma_3_3;
use super::{Family, Kind, Network};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use models::averaging::{Mode, State, motion, rational_modes};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// A point or a velocity.
pub(super) type Vector = Vec<Rational>;

/// `x + factor y`.
pub(super) fn add(x: &Vector, factor: &Rational, y: &Vector) -> Vector {
    x.iter().zip(y).map(|(x, y)| x + factor * y).collect()
}

/// The sum of `weight_j vector_j`, over at least one.
pub(super) fn combine(weights: &[Rational], vectors: &[Vector]) -> Vector {
    let zero = vec![rational(0, 1); vectors.first().map_or(0, Vec::len)];
    weights.iter().zip(vectors).fold(zero, |sum, (weight, vector)| add(&sum, weight, vector))
}

/// A connected flock with rational eigenvalues.
pub(super) struct Flock {
    pub(super) network: Network,
    pub(super) modes: Vec<Mode>,
    pub(super) pi: Vec<Rational>,
    gamma: RationalMatrix,
}

impl Flock {
    pub(super) fn order(&self) -> usize {
        self.network.order()
    }

    /// `chi(i)^T Gamma`.
    pub(super) fn gamma_row(&self, i: usize) -> Vec<Rational> {
        (0..self.order()).map(|j| self.gamma.entry(i, j)).collect()
    }
}

/// The flocks of up to 4 birds whose eigenvalues all are rational.
fn flocks() -> Result<Vec<std::rc::Rc<Flock>>, CheckError> {
    let mut found = Vec::new();
    for network in Family::PRINTED.networks(4)? {
        // A single bird is the same with all weights.
        if network.order() == 1 && network.kind != Kind::Lazy {
            continue;
        }
        let modes = rational_modes(&network.p, &network.c)?;
        if let (Some(modes), Some(gamma)) = (modes, limit_of_lemma_3_3(&network)?) {
            let pi = network.pi();
            found.push(std::rc::Rc::new(Flock { network, modes, pi, gamma }));
        }
    }
    Ok(found)
}

/// All pairs of these flocks with at most so many birds in all.
pub(super) fn flights(birds: usize) -> Result<Vec<[std::rc::Rc<Flock>; 2]>, CheckError> {
    let flocks = flocks()?;
    let pairs = flocks.iter().flat_map(|f| flocks.iter().map(move |g| [f.clone(), g.clone()]));
    Ok(pairs.filter(|[f, g]| f.order() + g.order() <= birds).collect())
}

/// Steps that are followed after `t_1`.
const STEPS: usize = 5;

/// The motion of two flocks.
pub(super) struct Flight<'a> {
    pub(super) flocks: &'a [std::rc::Rc<Flock>; 2],
    pub(super) dimension: usize,
    first: usize,
    /// The motion up to `t_1`.
    before: Vec<State>,
    /// The state at `t` for `t = t_1, .., t_1 + STEPS`; the network is fixed during `[t_1, t - 1]`.
    after: Vec<State>,
}

impl<'a> Flight<'a> {
    /// A flight with random small input. Up to time `t_1 - 1`, and again at the last `broken` times before `t`, all
    /// birds form one path.
    pub(super) fn new(
        flocks: &'a [std::rc::Rc<Flock>; 2],
        dimension: usize,
        first: usize,
        broken: usize,
        random: &mut ChaCha8Rng,
    ) -> Result<Self, CheckError> {
        let order = flocks[0].order() + flocks[1].order();
        let mut number = || rational(i64::from(random.next_u32() % 31) - 15, 1 + i64::from(random.next_u32() % 6));
        let mut numbers = || (0..dimension * order).map(|_| number()).collect();
        let start = State { positions: numbers(), velocities: numbers() };
        let (other, fixed) =
            (Network::new(Graph::path(order), Kind::Lazy)?.p, flocks[0].network.p.direct_sum(&flocks[1].network.p)?);
        let run = |t: usize| {
            let matrix = |s: usize| if s < first || (s < t && s + broken >= t) { &other } else { &fixed };
            let matrices: Vec<RationalMatrix> = (1..=t).map(|s| matrix(s).clone()).collect();
            motion(start.clone(), dimension, &matrices)
        };
        let last = |t: usize| -> Result<State, CheckError> { Ok(run(t)?.swap_remove(t)) };
        let after = (first..=first + STEPS).map(last).collect::<Result<_, _>>()?;
        Ok(Flight { flocks, dimension, first, before: run(first)?, after })
    }

    fn of_bird(&self, coordinates: &[Rational], f: usize, bird: usize) -> Vector {
        let index = if f == 0 { bird } else { self.flocks[0].order() + bird };
        coordinates[index * self.dimension..(index + 1) * self.dimension].to_vec()
    }

    /// `x_i(t_1)`.
    pub(super) fn start(&self, f: usize, bird: usize) -> Vector {
        self.of_bird(&self.before[self.first].positions, f, bird)
    }

    /// `x_i(t)` for `t = t_1, t_1 + 1, ..`.
    pub(super) fn positions(&self, f: usize, bird: usize) -> impl Iterator<Item = Vector> + '_ {
        self.after.iter().map(move |state| self.of_bird(&state.positions, f, bird))
    }

    /// `v(t_1 + 1 - earlier)` of the birds of a flock.
    pub(super) fn velocities(&self, f: usize, earlier: usize) -> Vec<Vector> {
        let state = &self.before[self.first - earlier];
        (0..self.flocks[f].order()).map(|bird| self.of_bird(&state.velocities, f, bird)).collect()
    }

    pub(super) fn show(&self) -> String {
        let [f, g] = self.flocks;
        format!(
            "flocks ({}) and ({}), d = {}, t_1 = {}",
            f.network.show(),
            g.network.show(),
            self.dimension,
            self.first
        )
    }
}
