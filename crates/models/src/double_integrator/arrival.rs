//! The first time in a step at which a pair of agents arrives at the distance `R`.
//!
//! Every step is looked at in [`PARTS`] parts of its dense output. Only pairs are examined that can reach `R` in the step: each
//! agent moves by at most the step's length times its largest speed at the ends of the parts, plus the largest change of its
//! velocity in a part. A part holds an arrival where `|r|² - R²` has changed its sign at its end, or where it comes towards
//! zero at the beginning and leaves it at the end, and the least value on the way, which is found as the root of `r.v`,
//! lies beyond zero. Values near zero are taken from states of full order, and so is the time of arrival. A least
//! value that is zero within rounding is an arrival too: the pair touches the threshold.

use super::{Coordinates, Pair, State};
use motion::{Integrator, Tolerance, VectorField, root};

/// Parts of a step.
const PARTS: usize = 8;

/// Arrivals that the dense output puts within this part of a step after the first are compared at full order.
const WINDOW: f64 = 1e-4;

/// The dense output is trusted to this multiple of the tolerance.
const DENSE: f64 = 1e3;

/// What is watched in a step.
pub(super) struct Watch<'a> {
    pub radius: f64,
    pub count: usize,
    /// Whether the pair `i < j` is linked, at [`place`].
    pub linked: &'a [bool],
    /// Pairs that are not watched.
    pub staying: &'a [Pair],
    /// Pairs that have just been at `R` and move away.
    pub fresh: &'a [Pair],
    pub tolerance: Tolerance,
}

/// A pair at `R`.
pub(super) struct Arrival {
    pub time: f64,
    pub list: Vec<f64>,
    pub pair: Pair,
    /// Whether it only touches `R`.
    pub touches: bool,
}

/// Where the pair `i < j` stands in a list of all pairs.
pub(super) fn place((i, j): Pair) -> usize {
    j * (j - 1) / 2 + i
}

/// How far `|r_ij|² - R²` can be from zero by rounding alone, of a pair at distance about `R`.
pub(super) fn rounding(state: &State<f64>, (i, j): Pair, radius: f64) -> f64 {
    let size = |k: usize| state.positions[k].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    16.0 * f64::EPSILON * radius * (size(i) + size(j) + radius)
}

/// A time by which a pair has arrived, and one before it.
struct Bracket {
    pair: Pair,
    from: f64,
    to: f64,
    touches: bool,
}

impl Watch<'_> {
    /// `|r_ij|² - R²` of a pair and half its rate, reversed for linked pairs: positive on the side where the pair is.
    fn side(&self, at: impl Fn(usize) -> f64, (i, j): Pair) -> (f64, f64) {
        let half = 2 * self.count;
        let vector = |from: usize| [0, 1].map(|k| at(from + 2 * i + k) - at(from + 2 * j + k));
        let (r, v) = (vector(0), vector(half));
        let sign = if self.linked[place((i, j))] { -1.0 } else { 1.0 };
        let square = Coordinates::Cartesian.square(&r);
        (sign * (square - self.radius * self.radius), sign * Coordinates::Cartesian.product(&r, &v))
    }

    fn of_list(&self, list: &[f64], pair: Pair) -> (f64, f64) {
        self.side(|k| list[k], pair)
    }

    /// Errors of the dense output in `|r_ij|²`.
    fn gate(&self, list: &[f64], (i, j): Pair) -> f64 {
        let size = [2 * i, 2 * i + 1, 2 * j, 2 * j + 1].iter().fold(self.radius, |m, &k| m.max(list[k].abs()));
        4.0 * self.radius * DENSE * (self.tolerance.absolute + self.tolerance.relative * size)
    }

    /// The first arrival in the last step, if there is one.
    pub fn first(&self, solution: &mut Integrator, field: &mut impl VectorField) -> Option<Arrival> {
        let (from, to) = (solution.previous_time(), solution.time());
        let time = |k: usize| if k == PARTS { to } else { from + (to - from) * k as f64 / PARTS as f64 };
        let nodes: Vec<(f64, Vec<f64>)> =
            (0..=PARTS).map(|k| (time(k), solution.interpolate(field, time(k)))).collect();
        let reach = self.reach(&nodes);
        let mut found = Vec::new();
        for j in 0..self.count {
            for i in 0..j {
                if !self.staying.contains(&(i, j)) && self.can_arrive(&nodes[0].1, (i, j), reach[i] + reach[j]) {
                    found.extend(self.scan(solution, field, &nodes, (i, j)));
                }
            }
        }
        // First by the dense output, then at full order those that are close to the first.
        let dense: Vec<f64> = found
            .iter()
            .map(|b| if b.touches { b.to } else { root(b.from, b.to, false, |t| self.on_dense(solution, t, b.pair).0) })
            .collect();
        let last = dense.iter().copied().fold(f64::INFINITY, f64::min) + WINDOW * (to - from);
        let close = found.iter().zip(dense).filter(|(_, estimate)| *estimate <= last).map(|(bracket, _)| bracket);
        let mut first: Option<(f64, &Bracket)> = None;
        for bracket in close {
            let value = |t: f64| self.of_list(&solution.within(field, t), bracket.pair).0;
            let at = if bracket.touches { bracket.to } else { root(bracket.from, bracket.to, false, value) };
            if first.is_none_or(|(time, _)| at < time) {
                first = Some((at, bracket));
            }
        }
        let (time, &Bracket { pair, touches, .. }) = first?;
        Some(Arrival { time, list: solution.within(field, time), pair, touches })
    }

    fn on_dense(&self, solution: &Integrator, time: f64, pair: Pair) -> (f64, f64) {
        self.side(|k| solution.component(k, time), pair)
    }

    /// How far each agent can move in the step.
    fn reach(&self, nodes: &[(f64, Vec<f64>)]) -> Vec<f64> {
        let length = nodes[PARTS].0 - nodes[0].0;
        let size = |x: f64, y: f64| x.hypot(y);
        (0..self.count)
            .map(|i| {
                let k = 2 * (self.count + i);
                let speed = nodes.iter().map(|(_, list)| size(list[k], list[k + 1])).fold(0.0, f64::max);
                let change = nodes.windows(2).map(|w| size(w[1].1[k] - w[0].1[k], w[1].1[k + 1] - w[0].1[k + 1]));
                length * (speed + change.fold(0.0, f64::max))
            })
            .collect()
    }

    fn can_arrive(&self, start: &[f64], (i, j): Pair, reach: f64) -> bool {
        let (x, y) = (start[2 * i] - start[2 * j], start[2 * i + 1] - start[2 * j + 1]);
        let (square, reach) = (x * x + y * y, reach * (1.0 + 1e-9) + 1e-9 * self.radius);
        if self.linked[place((i, j))] {
            reach >= self.radius || square >= (self.radius - reach) * (self.radius - reach)
        } else {
            square <= (self.radius + reach) * (self.radius + reach)
        }
    }

    fn scan(
        &self,
        solution: &mut Integrator,
        field: &mut impl VectorField,
        nodes: &[(f64, Vec<f64>)],
        pair: Pair,
    ) -> Option<Bracket> {
        let slack = State::from_list(self.count, &nodes[0].1).map_or(0.0, |state| rounding(&state, pair, self.radius));
        let gate = self.gate(&nodes[0].1, pair);
        let mut exact = |solution: &mut Integrator, t: f64, value: f64| {
            if value.abs() < gate { self.of_list(&solution.within(field, t), pair).0 } else { value }
        };
        let (mut value, mut rate) = self.of_list(&nodes[0].1, pair);
        for (k, window) in nodes.windows(2).enumerate() {
            let ((from, _), (to, end)) = (&window[0], &window[1]);
            let (from, to) = (*from, *to);
            let (dense, rate_after) = self.of_list(end, pair);
            let after = if k + 1 == PARTS { dense } else { exact(solution, to, dense) };
            let fresh = k == 0 && self.fresh.contains(&pair);
            if after < -slack {
                // A pair that leaves R first, and is back: from where it is away.
                let halves = (1..40).map(|m| from + (to - from) * 0.5f64.powi(m));
                let away =
                    halves.filter(|_| fresh).find(|&t| exact(solution, t, self.on_dense(solution, t, pair).0) > slack);
                return Some(Bracket { pair, from: away.unwrap_or(from), to, touches: false });
            }
            // Where the tangents at both ends meet there is a lower bound, as long as the distance bends one way.
            let lowest = || value + rate * (after - value - 2.0 * rate_after * (to - from)) / (rate - rate_after);
            if !fresh && rate < 0.0 && rate_after > 0.0 && lowest() <= gate.max(slack) {
                let nearest = root(from, to, true, |t| self.on_dense(solution, t, pair).1);
                let least = exact(solution, nearest, self.on_dense(solution, nearest, pair).0);
                if least <= slack {
                    return Some(Bracket { pair, from, to: nearest, touches: least >= -slack });
                }
            }
            (value, rate) = (after, rate_after);
        }
        None
    }
}
