//! Model D in any dimension, stepped exactly: integers over one common denominator.

use super::boxes;
use super::hysteresis::{Hysteresis, Threshold};
use super::rule::Rule;
use super::weights::{FlockError, Weights};
use algebra::graph::Graph;
use algebra::matrix::{IntegerRows, RationalMatrix};
use arithmetic::{Cancelled, Progress, Rational, Ring, common_denominator, content};
use num_bigint::BigInt;
use num_traits::Signed;
use std::cmp::Ordering;

/// A flock at a time `t`: positions `x(t)`, velocities `v(t+1)` and the network `G_t`.
///
/// The state is `n d` numerators each over one common denominator; a step multiplies the denominator by the least common
/// denominator of the weights and allocates nothing while the network stays.
#[derive(Debug, Clone)]
pub struct Flock {
    birds: usize,
    dimension: usize,
    weights: Weights,
    threshold: Threshold,
    network: Graph,
    rule: Rule,
    /// Numerators of x(t), bird by bird, and in the last row the common denominator.
    positions: IntegerRows,
    /// Numerators of v(t+1) over the common denominator times `pending`.
    velocities: IntegerRows,
    pending: BigInt,
    time: BigInt,
    scratch: Scratch,
}

/// Room that every step uses again.
#[derive(Debug, Clone)]
struct Scratch {
    velocities: IntegerRows,
    windows: Vec<i128>,
    /// Pair `i < j` at `j (j - 1)/2 + i`.
    joined: Vec<bool>,
    ties: Vec<(usize, usize)>,
}

/// A change of the network.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Switch {
    /// The first time with the new network.
    pub time: BigInt,
    /// New edges, vertices from 0.
    pub gained: Vec<(usize, usize)>,
    /// Edges that are gone.
    pub lost: Vec<(usize, usize)>,
}

impl Switch {
    /// What changes from one network to another of the same order.
    pub fn between(old: &Graph, new: &Graph, time: BigInt) -> Self {
        let only = |a: &Graph, b: &Graph| a.edges().into_iter().filter(|&(i, j)| !b.has_edge(i, j)).collect();
        Switch { time, gained: only(new, old), lost: only(old, new) }
    }

    /// The network after it, from the one before.
    pub fn applied_to(&self, before: &Graph) -> Graph {
        let mut network = before.clone();
        self.apply_to(&mut network);
        network
    }

    /// Makes the network before it the one after it.
    pub fn apply_to(&self, network: &mut Graph) {
        for (list, joined) in [(&self.gained, true), (&self.lost, false)] {
            for &(i, j) in list {
                if network.has_edge(i, j) != joined {
                    network.toggle(i, j);
                }
            }
        }
    }
}

/// What a flock starts from: one row per bird, as many columns as dimensions.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// `x(0)`.
    pub positions: Vec<Vec<Rational>>,
    /// `v(1)`.
    pub velocities: Vec<Vec<Rational>>,
    /// The weights `c_i`.
    pub weights: Weights,
    /// The hysteresis rule.
    pub hysteresis: Hysteresis,
}

impl Start {
    /// A start on the line.
    pub fn on_the_line(
        positions: Vec<Rational>,
        velocities: Vec<Rational>,
        weights: Weights,
        hysteresis: Hysteresis,
    ) -> Self {
        let columns = |list: Vec<Rational>| list.into_iter().map(|x| vec![x]).collect();
        Start { positions: columns(positions), velocities: columns(velocities), weights, hysteresis }
    }
}

/// A state `x(t)`, `v(t+1)` as numerators over one unit, one row per bird.
#[derive(Debug, Clone)]
pub(super) struct IntegerState {
    /// Of the positions, by bird and dimension.
    pub positions: Vec<Vec<BigInt>>,
    /// Of the velocities.
    pub velocities: Vec<Vec<BigInt>>,
    /// The common denominator.
    pub unit: BigInt,
}

impl IntegerState {
    /// Divides everything by the common factors.
    pub fn reduce(&mut self, progress: &dyn Progress) -> Result<(), Cancelled> {
        let mut common = self.unit.clone();
        for x in self.positions.iter().chain(&self.velocities).flatten() {
            progress.checkpoint()?;
            common = content([&common, x]);
        }
        for row in self.positions.iter_mut().chain(&mut self.velocities) {
            row.iter_mut().for_each(|x| *x /= &common);
        }
        self.unit /= common;
        Ok(())
    }
}

/// Bits of the common denominator that are looked at before distances are compared exactly.
const WINDOW_BITS: u64 = 100;

impl Flock {
    /// The flock at `t = 0`; `G_0` is the network of the distance rule.
    ///
    /// # Errors
    /// [`FlockError`] where the start is not a flock.
    pub fn new(start: &Start) -> Result<Self, FlockError> {
        let mut flock = Flock::resume(start, Graph::empty(start.positions.len()), BigInt::ZERO)?;
        let network = flock.distance_network();
        flock.replace_network(network)?;
        Ok(flock)
    }

    /// A flock in the middle of its way: `start` holds `x(t)` and `v(t+1)`.
    ///
    /// # Errors
    /// [`FlockError`] where the start is not a flock.
    pub fn resume(start: &Start, network: Graph, time: BigInt) -> Result<Self, FlockError> {
        let birds = start.positions.len();
        let dimension = start.positions.first().map_or(0, Vec::len);
        if birds == 0 || dimension == 0 {
            return Err(FlockError::NoBirds);
        }
        if start.velocities.len() != birds {
            return Err(FlockError::Velocities { birds, found: start.velocities.len() });
        }
        for (what, list) in [("position", &start.positions), ("velocity", &start.velocities)] {
            if let Some(bird) = list.iter().position(|x| x.len() != dimension) {
                return Err(FlockError::Coordinates { what, bird: bird + 1, dimension, found: list[bird].len() });
            }
        }
        let all = || start.positions.iter().chain(&start.velocities).flatten();
        let unit = common_denominator(all());
        let numerators = |list: &[Vec<Rational>]| -> Vec<Vec<BigInt>> {
            list.iter().map(|row| row.iter().map(|x| x.numer() * (&unit / x.denom())).collect()).collect()
        };
        let state = IntegerState {
            positions: numerators(&start.positions),
            velocities: numerators(&start.velocities),
            unit: unit.clone(),
        };
        if let Weights::Given(c) = &start.weights
            && birds > 1
            && let Some((bird, c)) = c.iter().enumerate().find(|(_, c)| !c.is_positive() || **c >= c.one())
        {
            let (c, time) = (c.to_string(), time.to_string());
            return Err(FlockError::Inadmissible { bird: bird + 1, degree: 1, c, time });
        }
        let threshold = Threshold::new(start.hysteresis.clone(), birds)?;
        Flock::assemble(&state, start.weights.clone(), threshold, network, time)
    }

    fn assemble(
        state: &IntegerState,
        weights: Weights,
        threshold: Threshold,
        network: Graph,
        time: BigInt,
    ) -> Result<Self, FlockError> {
        let (birds, dimension) = (state.positions.len(), state.positions[0].len());
        check_order(&network, birds)?;
        let rule = Rule::new(&network, &weights, dimension, &time)?;
        let mut positions: Vec<BigInt> = state.positions.concat();
        positions.push(state.unit.clone());
        let velocities = IntegerRows::new(&state.velocities.concat());
        Ok(Flock {
            birds,
            dimension,
            weights,
            threshold,
            network,
            rule,
            positions: IntegerRows::new(&positions),
            scratch: Scratch {
                velocities: velocities.clone(),
                windows: Vec::new(),
                joined: Vec::new(),
                ties: Vec::new(),
            },
            velocities,
            pending: BigInt::from(1),
            time,
        })
    }

    /// The same flock in another state, at another time and with another network.
    ///
    /// # Errors
    /// [`FlockError`] where the weights do not suit the network.
    pub(super) fn moved_to(&self, state: &IntegerState, network: Graph, time: BigInt) -> Result<Self, FlockError> {
        Flock::assemble(state, self.weights.clone(), self.threshold.clone(), network, time)
    }

    /// Positions and velocities over one common unit.
    pub(super) fn integers(&self) -> IntegerState {
        let rows = |rows: &IntegerRows, factor: &BigInt| -> Vec<Vec<BigInt>> {
            let entry = |k: usize| rows.value(k) * factor;
            (0..self.birds).map(|i| (0..self.dimension).map(|k| entry(i * self.dimension + k)).collect()).collect()
        };
        IntegerState {
            positions: rows(&self.positions, &self.pending),
            velocities: rows(&self.velocities, &BigInt::from(1)),
            unit: self.denominator() * &self.pending,
        }
    }

    /// The pairs that were at distance exactly 1 when the network was last decided.
    pub fn ties(&self) -> &[(usize, usize)] {
        &self.scratch.ties
    }

    /// Number of birds.
    pub fn birds(&self) -> usize {
        self.birds
    }

    /// Dimension of the space.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The time `t`.
    pub fn time(&self) -> &BigInt {
        &self.time
    }

    /// `G_t`.
    pub fn network(&self) -> &Graph {
        &self.network
    }

    /// The weights.
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// The hysteresis rule.
    pub fn hysteresis(&self) -> &Hysteresis {
        self.threshold.kind()
    }

    pub(super) fn threshold(&self) -> &Threshold {
        &self.threshold
    }

    /// Bits of the common denominator of positions and velocities, not reduced.
    pub fn denominator_bits(&self) -> u64 {
        (self.denominator() * &self.pending).bits()
    }

    /// The common denominator of the positions, not reduced.
    pub fn denominator(&self) -> BigInt {
        self.positions.value(self.birds * self.dimension)
    }

    fn rows(&self, rows: &IntegerRows, denominator: &BigInt) -> Vec<Vec<Rational>> {
        let entry = |k: usize| Rational::new(rows.value(k), denominator.clone());
        (0..self.birds).map(|i| (0..self.dimension).map(|k| entry(i * self.dimension + k)).collect()).collect()
    }

    /// `x(t)`, one row per bird.
    pub fn positions(&self) -> Vec<Vec<Rational>> {
        self.rows(&self.positions, &self.denominator())
    }

    /// `v(t+1)`, one row per bird.
    pub fn velocities(&self) -> Vec<Vec<Rational>> {
        self.rows(&self.velocities, &(self.denominator() * &self.pending))
    }

    /// The virtual origins `x_i(t) - t v_i(t)`, one row per bird, from the positions one step before (`notes/settling.md`).
    pub fn virtual_origins(&self, before: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
        let t = Rational::from_integer(self.time.clone());
        let origin = |(x, old): (&Vec<Rational>, &Vec<Rational>)| {
            x.iter().zip(old).map(|(now, old)| now - (now - old) * &t).collect()
        };
        self.positions().iter().zip(before).map(origin).collect()
    }

    /// `x_i(t) - x_j(t)` over [`Flock::denominator`].
    pub(super) fn position_difference(&self, i: usize, j: usize) -> Vec<BigInt> {
        self.differences(&self.positions, i, j)
    }

    fn differences(&self, rows: &IntegerRows, i: usize, j: usize) -> Vec<BigInt> {
        (0..self.dimension).map(|k| rows.difference(i * self.dimension + k, j * self.dimension + k)).collect()
    }

    /// One step: `x(t+1) = x(t) + v(t+1)`, then `G_{t+1}`, then `v(t+2) = P(t+1) v(t+1)`. The change of the network, if
    /// there is one.
    ///
    /// # Errors
    /// [`FlockError`] where the weights do not suit the new network or the threshold is too long to write out.
    pub fn step(&mut self) -> Result<Option<Switch>, FlockError> {
        self.step_controlled(|_| None)
    }

    /// One step with control, `v(t+1) = K (P(t) (x) I_d) v(t)` (Chazelle, equation (1.2)). The control sees the flock when
    /// `x(t)` and `G_t` are known and [`Flock::velocities`] is still `v(t)`; it gives `K`, of order `n d` with the coordinates
    /// of a bird next to each other, or `None` for the identity.
    ///
    /// # Errors
    /// As [`Flock::step`], and [`FlockError::Control`] where `K` has another shape. The flock cannot go on then.
    pub fn step_controlled(
        &mut self,
        control: impl FnOnce(&Self) -> Option<RationalMatrix>,
    ) -> Result<Option<Switch>, FlockError> {
        self.advance();
        let switch = if self.decide_pairs()? {
            let joined = &self.scratch.joined;
            let network = Graph::from_fn(self.birds, |i, j| joined[j * (j - 1) / 2 + i]);
            Some(self.replace_network(network)?)
        } else {
            None
        };
        let control = control(self);
        self.average();
        if let Some(matrix) = control {
            self.apply(&matrix)?;
        }
        Ok(switch)
    }

    /// Multiplies the velocities by a matrix of order `n d`.
    fn apply(&mut self, matrix: &RationalMatrix) -> Result<(), FlockError> {
        check_control(matrix, self.birds, self.dimension)?;
        let velocities: Vec<BigInt> = (0..matrix.cols()).map(|k| self.velocities.value(k)).collect();
        let row = |i: usize| -> BigInt { matrix.row(i).iter().zip(&velocities).map(|(a, v)| a * v).sum() };
        self.velocities = IntegerRows::new(&(0..matrix.rows()).map(row).collect::<Vec<_>>());
        self.pending *= matrix.denominator();
        Ok(())
    }

    /// One step with a network that is given instead of being decided: to follow what a network would do.
    ///
    /// # Errors
    /// [`FlockError`] where the weights do not suit the network, or it has another number of vertices.
    pub fn step_on(&mut self, network: &Graph) -> Result<(), FlockError> {
        check_order(network, self.birds)?;
        self.advance();
        if *network != self.network {
            self.replace_network(network.clone())?;
        }
        self.average();
        Ok(())
    }

    /// Averages the velocities without moving.
    pub(super) fn average_again(&mut self) {
        self.average();
    }

    fn advance(&mut self) {
        self.positions.scale_and_add(&self.pending, &self.velocities);
        self.pending = BigInt::from(1);
        self.time += 1;
    }

    fn replace_network(&mut self, network: Graph) -> Result<Switch, FlockError> {
        let switch = Switch::between(&self.network, &network, self.time.clone());
        self.rule = Rule::new(&network, &self.weights, self.dimension, &self.time)?;
        self.network = network;
        Ok(switch)
    }

    fn average(&mut self) {
        self.scratch.velocities.average(&mut self.velocities, &self.rule.rows);
        std::mem::swap(&mut self.scratch.velocities, &mut self.velocities);
        self.pending.clone_from(&self.rule.multiplier);
    }

    /// Decides every pair into the scratch list; whether any differs from the network. Called between moving and averaging,
    /// when positions and velocities share one denominator.
    fn decide_pairs(&mut self) -> Result<bool, FlockError> {
        let mut scratch = std::mem::take(&mut self.scratch.joined);
        scratch.clear();
        self.scratch.ties.clear();
        self.look_through_windows();
        let mut changed = false;
        for j in 0..self.birds {
            for i in 0..j {
                let before = self.network.has_edge(i, j);
                let near = self.compare_with_one(i, j);
                if near == Ordering::Equal {
                    self.scratch.ties.push((i, j));
                }
                let mut joined = near != Ordering::Greater;
                if !joined && before && !self.threshold.holds_nothing() {
                    let moved = self.differences(&self.velocities, i, j);
                    joined = self.threshold.holds(&self.position_difference(i, j), &moved, &self.denominator())?;
                }
                changed |= joined != before;
                scratch.push(joined);
            }
        }
        self.scratch.joined = scratch;
        Ok(changed)
    }

    /// The distance of two birds after the next move against 1, and their difference of velocities in that move, over any unit.
    pub(super) fn next_comparison(&self, i: usize, j: usize) -> (Ordering, Vec<BigInt>) {
        let (now, moved, unit) = self.next_difference(i, j);
        let squared: BigInt = now.iter().map(Ring::square).sum();
        (squared.cmp(&unit.square()), moved)
    }

    /// Whether hysteresis would hold an edge after the next move.
    pub(super) fn next_is_held(&self, i: usize, j: usize) -> Result<bool, FlockError> {
        let (now, moved, unit) = self.next_difference(i, j);
        self.threshold.holds(&now, &moved, &unit)
    }

    /// `x_i - x_j` after the next move, `v_i - v_j` in that move, and the unit of both.
    fn next_difference(&self, i: usize, j: usize) -> (Vec<BigInt>, Vec<BigInt>, BigInt) {
        let moved = self.differences(&self.velocities, i, j);
        let before = self.position_difference(i, j);
        let now = before.into_iter().zip(&moved).map(|(x, v)| x * &self.pending + v).collect();
        (now, moved, self.denominator() * &self.pending)
    }

    /// The network that the distance rule alone gives now.
    pub fn distance_network(&mut self) -> Graph {
        self.look_through_windows();
        let mut edges = Vec::new();
        let mut look = |i: usize, j: usize| {
            if self.compare_with_one(i, j) != Ordering::Greater {
                edges.push((i, j));
            }
        };
        match self.floats() {
            Some(positions) => {
                let largest = positions.iter().fold(1.0f64, |most, x| most.max(x.abs()));
                // Floats and windows err by less than 1e-14 relative, in as many coordinates as there are.
                let reach = 1.0 + 1e-12 * largest * self.dimension as f64;
                let boxes = boxes::of_points(self.dimension, &positions, (0..self.birds as u32).collect());
                boxes.near_pairs(reach, |i, j| look(i as usize, j as usize));
            }
            None => (0..self.birds).for_each(|j| (0..j).for_each(|i| look(i, j))),
        }
        Graph::empty(self.birds).with_edges(&edges)
    }

    /// The positions in double precision, from the leading bits where these are noted.
    fn floats(&self) -> Option<Vec<f64>> {
        let (one, positions) = self.scratch.windows.split_last()?;
        Some(positions.iter().map(|&x| x as f64 / *one as f64).collect())
    }

    /// Notes the leading bits of all positions and of the denominator, on one scale; none where one does not fit.
    fn look_through_windows(&mut self) {
        let rows = self.birds * self.dimension;
        let shift = self.positions.bits(rows).saturating_sub(WINDOW_BITS);
        let windows = &mut self.scratch.windows;
        windows.clear();
        windows.extend((0..=rows).map_while(|k| self.positions.window(k, shift)));
        if windows.len() <= rows {
            windows.clear();
        }
    }

    /// `|x_i - x_j|` against 1: by the leading bits where these decide, otherwise exactly.
    fn compare_with_one(&self, i: usize, j: usize) -> Ordering {
        self.compare_by_windows(i, j).unwrap_or_else(|| {
            let squared: BigInt = self.position_difference(i, j).iter().map(Ring::square).sum();
            squared.cmp(&self.denominator().square())
        })
    }

    fn compare_by_windows(&self, i: usize, j: usize) -> Option<Ordering> {
        let windows = &self.scratch.windows;
        let one = *windows.get(self.birds * self.dimension)?;
        let difference = |k: usize| windows[i * self.dimension + k].checked_sub(windows[j * self.dimension + k]);
        if self.dimension == 1 {
            // The true difference is within 1 of this one, the true unit between `one` and `one + 1`.
            let size = difference(0)?.checked_abs()?;
            return if size < one {
                Some(Ordering::Less)
            } else if size > one + 2 {
                Some(Ordering::Greater)
            } else {
                None
            };
        }
        let mut squared = 0.0;
        for k in 0..self.dimension {
            let size = difference(k)? as f64;
            squared += size * size;
        }
        // Floats err by less than 1e-14 relative; the windows by less than 2^-90 of the unit each, if it has that many bits.
        let unit = one as f64;
        let slack = 1e-9 + 8.0 * self.dimension as f64 / unit;
        let ratio = squared / (unit * unit);
        let decided = (ratio - 1.0).abs() > slack * (1.0 + ratio);
        decided.then_some(if ratio < 1.0 { Ordering::Less } else { Ordering::Greater })
    }
}

/// Whether a network is one of so many birds.
fn check_order(network: &Graph, birds: usize) -> Result<(), FlockError> {
    let vertices = network.order();
    if vertices == birds { Ok(()) } else { Err(FlockError::Network { birds, vertices }) }
}

/// Whether a matrix can be the control of so many birds in so many dimensions.
///
/// # Errors
/// [`FlockError::Control`] where it is not of order `n d`.
pub fn check_control(matrix: &RationalMatrix, birds: usize, dimension: usize) -> Result<(), FlockError> {
    let (expected, rows, cols) = (birds.saturating_mul(dimension), matrix.rows(), matrix.cols());
    if (rows, cols) == (expected, expected) { Ok(()) } else { Err(FlockError::Control { expected, rows, cols }) }
}
