//! The first time in a step at which a pair of agents arrives at the distance `R`.
//!
//! Every step is looked at in [`PARTS`] parts of its dense output. Only pairs are examined that can reach `R` in the step: each
//! agent moves by at most the step's length times its largest speed at the ends of the parts, plus the largest change of its
//! velocity in a part. A part holds an arrival where `|r|² - R²` has changed its sign at its end, or where it comes towards
//! zero at the beginning and leaves it at the end, and the least value on the way, which is found as the root of `r.v`,
//! lies beyond zero. Values near zero are taken from states of full order, and so is the time of arrival. A least
//! value that is zero within rounding is an arrival too: the pair touches the threshold.

use crate::double_integrator::laws::{Coordinates, Pair, State};
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

/// A pair that is watched through a step.
struct Watched {
    pair: Pair,
    /// What rounding alone can change in `|r|² - R²`, and what the dense output may be off by.
    slack: f64,
    gate: f64,
    /// [`Watch::side`] at the beginning of the part that is looked at.
    side: (f64, f64),
}

/// One of the parts of a step.
struct Part<'a> {
    number: usize,
    from: f64,
    to: f64,
    /// The state at its end by the dense output.
    dense: &'a [f64],
    /// The same of full order, which all pairs share, once one of them has asked for it.
    full: Option<Vec<f64>>,
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
        let pairs = (0..self.count).flat_map(|j| (0..j).map(move |i| (i, j)));
        let watched = pairs.filter(|&(i, j)| {
            !self.staying.contains(&(i, j)) && self.can_arrive(&nodes[0].1, (i, j), reach[i] + reach[j])
        });
        let state = State::from_list(self.count, &nodes[0].1);
        let mut watched: Vec<Watched> = watched
            .map(|pair| Watched {
                pair,
                slack: state.as_ref().map_or(0.0, |state| rounding(state, pair, self.radius)),
                gate: self.gate(&nodes[0].1, pair),
                side: self.of_list(&nodes[0].1, pair),
            })
            .collect();
        // The first part in which a pair arrives has the first arrival.
        let mut found = Vec::new();
        for (number, ends) in nodes.windows(2).enumerate() {
            let mut part = Part { number, from: ends[0].0, to: ends[1].0, dense: &ends[1].1, full: None };
            found.extend(watched.iter_mut().filter_map(|pair| self.scan(solution, field, &mut part, pair)));
            if !found.is_empty() {
                break;
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

    /// Whether a pair arrives in a part of the step; if not, its side is that at the end afterwards.
    fn scan(
        &self,
        solution: &mut Integrator,
        field: &mut impl VectorField,
        part: &mut Part,
        watched: &mut Watched,
    ) -> Option<Bracket> {
        let Watched { pair, slack, gate, side: (value, rate) } = *watched;
        let (from, to) = (part.from, part.to);
        let (dense, rate_after) = self.of_list(part.dense, pair);
        let after = match dense.abs() < gate && part.number + 1 < PARTS {
            true => self.of_list(part.full.get_or_insert_with(|| solution.within(field, to)), pair).0,
            false => dense,
        };
        let mut exact = |solution: &mut Integrator, t: f64, value: f64| {
            if value.abs() < gate { self.of_list(&solution.within(field, t), pair).0 } else { value }
        };
        let fresh = part.number == 0 && self.fresh.contains(&pair);
        if after < -slack {
            // A pair that leaves R first, and is back: from where it is away.
            let halves = (1..40).map(|m| from + (to - from) * 0.5f64.powi(m));
            let away =
                halves.filter(|_| fresh).find(|&t| exact(solution, t, self.on_dense(solution, t, pair).0) > slack);
            return Some(Bracket { pair, from: away.unwrap_or(from), to, touches: false });
        }
        // Where the tangents at both ends meet there is a lower bound, as long as the distance bends one way.
        let lowest = || value + rate * (after - value - 2.0 * rate_after * (to - from)) / (rate - rate_after);
        if !fresh && rate < 0.0 && rate_after >= 0.0 && lowest() <= gate.max(slack) {
            let nearest = root(from, to, true, |t| self.on_dense(solution, t, pair).1);
            let least = exact(solution, nearest, self.on_dense(solution, nearest, pair).0);
            if least <= slack {
                return Some(Bracket { pair, from, to: nearest, touches: least >= -slack });
            }
        }
        watched.side = (after, rate_after);
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EPS: f64 = f64::EPSILON;

    /// Three agents: positions, then velocities.
    const LIST: [f64; 12] = [1.0, 2.0, -3.0, 0.5, 40.0, -50.0, 0.25, -1.0, 2.0, 3.0, -0.5, 0.75];

    fn watch<'a>(linked: &'a [bool], fresh: &'a [Pair]) -> Watch<'a> {
        let tolerance = Tolerance { relative: 1e-9, absolute: 1e-12 };
        Watch { radius: 2.0, count: 3, linked, staying: &[], fresh, tolerance }
    }

    #[test]
    fn pairs_have_places_of_their_own() {
        let pairs = (0..7).flat_map(|j| (0..j).map(move |i| (i, j)));
        assert_eq!(pairs.map(place).collect::<Vec<_>>(), (0..21).collect::<Vec<_>>());
    }

    /// `|r|² - R²` and `r.v`, with the opposite sign for those that are linked, from the numbers above.
    #[test]
    fn sides_are_excesses_and_half_their_rates() {
        // r = (4, 3/2), v = (-7/4, -4); r = (-39, 52), v = (3/4, -7/4); r = (-43, 101/2), v = (5/2, 9/4).
        let known = [((0, 1), 14.25, -13.0), ((0, 2), 4221.0, -120.25), ((1, 2), 4395.25, 6.125)];
        for (pair, excess, rate) in known {
            assert_eq!(watch(&[false; 3], &[]).of_list(&LIST, pair), (excess, rate));
            let mut linked = [false; 3];
            linked[place(pair)] = true;
            assert_eq!(watch(&linked, &[]).of_list(&LIST, pair), (-excess, -rate));
        }
    }

    /// `16 eps R (|x_i| + |x_j| + R)` with the largest coordinates; `4 R 1000 (absolute + relative size)` with the largest of them and `R`.
    #[test]
    fn bounds_of_rounding_and_of_the_dense_output_are_their_formulas() {
        let state = State::from_list(3, &LIST).expect("three agents");
        for ((i, j), sizes) in [((0, 1), 5.0), ((0, 2), 52.0), ((1, 2), 53.0)] {
            assert_eq!(rounding(&state, (i, j), 2.0), 16.0 * EPS * 2.0 * (sizes + 2.0));
            assert_eq!(rounding(&state, (j, i), 0.5), 16.0 * EPS * 0.5 * (sizes + 0.5));
        }
        for (pair, size) in [((0, 1), 3.0), ((0, 2), 50.0), ((1, 2), 50.0)] {
            let (found, known) = (watch(&[false; 3], &[]).gate(&LIST, pair), 8e3 * (1e-12 + 1e-9 * size));
            assert!((found / known - 1.0).abs() < 1e-12, "{pair:?} {found}");
        }
        for (at, (i, j)) in (0..6).flat_map(|at| [(0, 1), (0, 2), (1, 2)].map(|pair| (at, pair))) {
            let mut list = [1.0; 12];
            list[at] = -64.0;
            let size = if at / 2 == i || at / 2 == j { 64.0 } else { 2.0 };
            let (found, known) = (watch(&[false; 3], &[]).gate(&list, (i, j)), 8e3 * (1e-12 + 1e-9 * size));
            assert!((found / known - 1.0).abs() < 1e-12, "{at} {i} {j}");
        }
        let near = LIST.map(|x| x / 100.0);
        let (found, known) = (watch(&[false; 3], &[]).gate(&near, (0, 1)), 8e3 * (1e-12 + 1e-9 * 2.0));
        assert!((found / known - 1.0).abs() < 1e-12);
    }

    /// The length of the step times the largest speed and the largest change of the velocity in a part.
    #[test]
    fn agents_move_no_farther_than_their_speeds_allow() {
        let velocity = |i: usize, k: usize| {
            let (i, k) = (i as f64, k as f64);
            [3.0 * (1.0 + i) - (k - 3.0) * (k - 3.0), 0.5 * k * (i - 1.0)]
        };
        let nodes: Vec<(f64, Vec<f64>)> = (0..=PARTS)
            .map(|k| {
                let velocities = (0..3).flat_map(|i| velocity(i, k));
                (7.0 + 0.25 * k as f64, [0.0; 6].into_iter().chain(velocities).collect())
            })
            .collect();
        let found = watch(&[false; 3], &[]).reach(&nodes);
        for (i, found) in found.iter().enumerate() {
            let size = |v: [f64; 2]| (v[0] * v[0] + v[1] * v[1]).sqrt();
            let speeds = (0..=8).map(|k| size(velocity(i, k)));
            let changes = (0..8).map(|k| {
                let (a, b) = (velocity(i, k), velocity(i, k + 1));
                size([b[0] - a[0], b[1] - a[1]])
            });
            let known = 2.0 * (speeds.fold(0.0, f64::max) + changes.fold(0.0, f64::max));
            assert!((found / known - 1.0).abs() < 1e-14, "{i}: {found} {known}");
        }
        assert_eq!(found.len(), 3);
    }

    /// With `R = 2`: a pair that is not linked comes to the distance 2 from `2 + reach` at most, a linked one from `2 - reach` on, and from
    /// anywhere where it can go that far; the reach is widened by `1e-9` of both.
    #[test]
    fn pairs_that_can_reach_the_threshold_are_looked_at() {
        let can = |linked: bool, pair: Pair, distance: f64, reach: f64| {
            let mut start = [0.0; 12];
            // Along both axes, so that each counts.
            (start[2 * pair.0], start[2 * pair.0 + 1]) = (11.0 + 0.6 * distance, -7.0 - 0.8 * distance);
            (start[2 * pair.1], start[2 * pair.1 + 1]) = (11.0, -7.0);
            let mut links = [!linked; 3];
            links[place(pair)] = linked;
            watch(&links, &[]).can_arrive(&start, pair, reach)
        };
        for pair in [(0, 1), (0, 2), (1, 2)] {
            for reach in [0.125, 1.0, 1.5] {
                let wide = reach * 1e-9 + 2e-9;
                assert!(can(false, pair, 2.0 + reach + 0.97 * wide, reach));
                assert!(!can(false, pair, 2.0 + reach + 1.03 * wide, reach));
                assert!(can(true, pair, 2.0 - reach - 0.97 * wide, reach));
                assert!(!can(true, pair, 2.0 - reach - 1.03 * wide, reach));
            }
            assert!(can(false, pair, 0.5, 0.01) && can(true, pair, 2.5, 0.01));
            assert!(can(true, pair, 0.01, 2.5) && can(true, pair, 0.01, 2.0) && !can(true, pair, 0.01, 1.9));
        }
    }

    /// The first arrival of agents with constant accelerations until a time: when, who, and whether they only touch.
    fn followed(watch: &Watch, list: &[f64], accelerations: &[f64], until: f64) -> Option<(f64, Pair, bool)> {
        let half = list.len() / 2;
        let mut field = |_: f64, state: &[f64], rate: &mut [f64]| {
            rate[..half].copy_from_slice(&state[half..]);
            rate[half..].copy_from_slice(accelerations);
        };
        let mut solution = Integrator::new(0.0, list, watch.tolerance);
        while solution.time() < until {
            solution.step(&mut field, until).expect("a step");
            if let Some(arrival) = watch.first(&mut solution, &mut field) {
                assert_eq!(arrival.list, solution.within(&mut field, arrival.time));
                return Some((arrival.time, arrival.pair, arrival.touches));
            }
        }
        None
    }

    /// The first root of `|r + v t|² - R²` of a pair at which it changes its side, for `R = 2`.
    fn crossing(list: &[f64], (i, j): Pair, linked: bool) -> f64 {
        let half = list.len() / 2;
        let of = |from: usize| [0, 1].map(|k| list[from + 2 * i + k] - list[from + 2 * j + k]);
        let ([x, y], [u, v]) = (of(0), of(half));
        let (a, b, c) = (u * u + v * v, x * u + y * v, x * x + y * y - 4.0);
        let root = (b * b - a * c).sqrt();
        let time = if linked { (-b + root) / a } else { (-b - root) / a };
        if time > 0.0 { time } else { f64::INFINITY }
    }

    /// Straight ways of four agents, with short visits in long steps: the first of all pairs that are watched.
    #[test]
    fn the_first_arrival_is_that_of_straight_lines() {
        let (mut arrivals, mut none) = (0, 0);
        for case in 0..300 {
            let mut random = arithmetic::random::generator("test", "arrivals", case);
            let mut even = |size: f64| size * (2.0 * arithmetic::random::uniform(&mut random) - 1.0);
            let list: Vec<f64> = (0..8).map(|_| even(5.0)).collect();
            let list: Vec<f64> = list.into_iter().chain((0..8).map(|_| even(3.0))).collect();
            let pairs: Vec<Pair> = (0..4).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
            let near = |&(i, j): &Pair| {
                let r = [0, 1].map(|k| list[2 * i + k] - list[2 * j + k]);
                r[0] * r[0] + r[1] * r[1] < 4.0
            };
            let linked: Vec<bool> = pairs.iter().map(near).collect();
            let staying = &pairs[..(case % 3) as usize];
            let watch = Watch { count: 4, staying, ..watch(&linked, &[]) };
            let times = pairs.iter().map(|&pair| (crossing(&list, pair, linked[place(pair)]), pair));
            let times = times.filter(|(time, pair)| *time < 4.0 && !staying.contains(pair));
            let known = times.min_by(|a, b| a.0.total_cmp(&b.0));
            match (followed(&watch, &list, &[0.0; 8], 4.0), known) {
                (Some((time, pair, touches)), Some((first, of))) => {
                    assert!((time - first).abs() < 1e-11 && pair == of && !touches, "{case}: {time} {first}");
                    arrivals += 1;
                }
                (None, None) => none += 1,
                other => panic!("{case}: {other:?}"),
            }
        }
        assert!(arrivals > 200 && none > 5, "{arrivals} {none}");
    }

    /// Two that come from both sides at times that differ by little; of equal times the first pair is told.
    #[test]
    fn arrivals_at_nearly_one_time_are_told_apart() {
        for late in [0.0, 1e-13, 1e-9, 1e-6, 1e-3] {
            for (left, right) in [(late, 0.0), (0.0, late)] {
                let list = [0.0, 0.0, 3.0 + right, 0.0, -3.0 - left, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0];
                let (time, pair, touches) = followed(&watch(&[false; 3], &[]), &list, &[0.0; 6], 1.8).expect("arrives");
                let first = if right > 0.0 { (0, 2) } else { (0, 1) };
                assert!((time - 1.0).abs() < 1e-14 && pair == first && !touches, "{late}: {time} {pair:?}");
            }
        }
    }

    /// A pair passes at the distance 2 but for little: it touches, or is near for a short time, or nothing happens.
    #[test]
    fn passages_near_the_radius_touch_within_rounding() {
        let pass = |offset: f64| {
            let list = [-3.0, 2.0 + offset, 0.0, 0.0, 90.0, 90.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            followed(&watch(&[false; 3], &[]), &list, &[0.0; 6], 7.0)
        };
        let Some((time, (0, 1), true)) = pass(0.0) else { panic!("{:?}", pass(0.0)) };
        assert!((time - 3.0).abs() < 1e-7);
        // The rounding allowed is 16 eps R (3 + 0 + 2), of a square that changes by 4 times the offset.
        let slack = 16.0 * EPS * 2.0 * 5.0 / 4.0;
        assert!(matches!(pass(0.8 * slack), Some((_, (0, 1), true))) && pass(1.2 * slack).is_none());
        assert!(matches!(pass(-0.8 * slack), Some((time, (0, 1), true)) if (time - 3.0).abs() < 1e-8));
        for depth in [1e-12, 1e-8, 1e-4, 0.1] {
            let Some((time, (0, 1), false)) = pass(-depth) else { panic!("{depth}") };
            let half = (4.0 * depth - depth * depth).sqrt();
            assert!((time - 3.0 + half).abs() < 1e-14 / half + 1e-11, "{depth} {time}");
            assert_eq!(pass(depth), None);
        }
    }

    /// One that has just left `R` and is drawn back: `2 + t/2 - 2 b t²` is 2 again at `t = 1/(4 b)`, soon or late in a step.
    #[test]
    fn fresh_pairs_arrive_where_they_are_back() {
        for back in [0.01, 0.1, 0.5, 1.5] {
            let b = 0.25 / back;
            let list = [0.0, 0.0, 2.0, 0.0, 90.0, 90.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0];
            let accelerations = [0.0, 0.0, -4.0 * b, 0.0, 0.0, 0.0];
            let found = followed(&watch(&[false; 3], &[(0, 1)]), &list, &accelerations, 2.0);
            let Some((time, (0, 1), false)) = found else { panic!("{back}: {found:?}") };
            assert!((time - back).abs() < 1e-12, "{back} {time}");
            // The same inwards, of a linked pair.
            let list = [0.0, 0.0, 2.0, 0.0, 90.0, 90.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.0];
            let accelerations = [0.0, 0.0, 4.0 * b, 0.0, 0.0, 0.0];
            let found = followed(&watch(&[true, false, false], &[(0, 1)]), &list, &accelerations, 2.0);
            let Some((time, (0, 1), false)) = found else { panic!("{back}: {found:?}") };
            assert!((time - back).abs() < 1e-12, "{back} {time}");
        }
    }

    /// Straight passages whose nearest place is anywhere in a part of a step, also of a pair that has been at `R` when the step began.
    #[test]
    fn short_visits_are_found_in_every_part_of_a_step() {
        for (k, depth) in (0..40).flat_map(|k| [(k, 1e-10), (k, 1e-5), (k, 1e-3)]) {
            let from = 3.0 + 0.07 * f64::from(k);
            let list = [-from, 2.0 - depth, 0.0, 0.0, 90.0, 90.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            let half = (4.0 * depth - depth * depth).sqrt();
            let found = followed(&watch(&[false; 3], &[]), &list, &[0.0; 6], 9.0);
            let Some((time, (0, 1), false)) = found else { panic!("{k} {depth}: {found:?}") };
            assert!((time - from + half).abs() < 1e-14 / half + 1e-11, "{k} {depth}: {time}");
        }
        let list = [-3.0, 1.9999, 0.0, 0.0, 90.0, 90.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        assert!(followed(&watch(&[false; 3], &[(0, 1)]), &list, &[0.0; 6], 7.0).is_some());
    }

    /// One step of `1/64` with a node at `1/128`, in numbers that floats hold: an arrival just there is no touch, and a touch just there is one.
    #[test]
    fn what_happens_at_a_node_is_told() {
        let at = 1.0 / 128.0;
        let arrives = [3.0, 0.0, 0.0, 0.0, 90.0, 90.0, -128.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let found = followed(&watch(&[false; 3], &[]), &arrives, &[0.0; 6], 2.0 * at);
        assert!(matches!(found, Some((time, (0, 1), false)) if (time - at).abs() < 1e-15), "{found:?}");
        let touches = [-1.0, 2.0, 0.0, 0.0, 90.0, 90.0, 128.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for until in [at, 2.0 * at] {
            let found = followed(&watch(&[false; 3], &[]), &touches, &[0.0; 6], until);
            assert!(matches!(found, Some((time, (0, 1), true)) if (time - at).abs() < 1e-15), "{until} {found:?}");
        }
    }

    /// A short step: the third agent comes to `R` before the first one, which only touches, is nearest to the second.
    #[test]
    fn an_arrival_before_a_touch_comes_first() {
        let slack = 16.0 * EPS * 2.0 * 4.0 / 4.0;
        let list = [-1e-5, 2.0 - 0.8 * slack, 0.0, 0.0, -2.0 - 0.99e-5, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let found = followed(&watch(&[false; 3], &[]), &list, &[0.0; 6], 2e-5);
        assert!(matches!(found, Some((time, (1, 2), false)) if (time - 0.99e-5).abs() < 1e-12), "{found:?}");
    }

    /// On the unit circle around the origin, past an agent at the distance `3 + offset` from its centre.
    fn circling(_: f64, state: &[f64], rate: &mut [f64]) {
        rate[..6].copy_from_slice(&state[6..]);
        rate[6..].fill(0.0);
        (rate[6], rate[7]) = (-state[0], -state[1]);
    }

    fn on_circle(angle: f64, offset: f64) -> [f64; 12] {
        let (sin, cos) = angle.sin_cos();
        [cos, sin, 3.0 + offset, 0.0, 90.0, 90.0, -sin, cos, 0.0, 0.0, 0.0, 0.0]
    }

    /// With a loose tolerance the dense output errs by far more than rounding; a visit is one of the solution at full order, and its time is
    /// where that is at `R`.
    #[test]
    fn visits_are_those_of_the_solution_at_full_order() {
        let tolerance = Tolerance { relative: 1e-4, absolute: 1e-4 };
        let watch = Watch { tolerance, ..watch(&[false; 3], &[]) };
        // Every step with its least value at full order, and the first arrival.
        let steps = |offset: f64| {
            let mut solution = Integrator::new(0.0, &on_circle(-1.1, offset), tolerance);
            let (mut least, mut found) = (f64::INFINITY, None);
            while solution.time() < 2.2 && found.is_none() {
                solution.step(&mut circling, 2.2).expect("a step");
                let mut copy = solution.clone();
                let mut value = |t: f64| watch.of_list(&copy.within(&mut circling, t), (0, 1)).0;
                let (mut a, mut b) = (solution.previous_time(), solution.time());
                while b - a > 1e-9 {
                    let (left, right) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
                    (a, b) = if value(left) < value(right) { (a, right) } else { (left, b) };
                }
                least = f64::min(least, value(a));
                found = watch.first(&mut solution, &mut circling);
            }
            (least, found)
        };
        let (mut low, mut high) = (-1e-2, 1e-2);
        assert!(steps(low).0 < 0.0 && steps(high).0 > 0.0);
        while high - low > 1e-13 {
            let middle = f64::midpoint(low, high);
            (low, high) = if steps(middle).0 < 0.0 { (middle, high) } else { (low, middle) };
        }
        // Where it is least is taken from the dense output, whose error counts by its square.
        for power in 3..8 {
            for side in [-1.0, 1.0] {
                let (least, found) = steps(low + side * 10f64.powi(-power));
                assert_eq!(found.is_some(), least < 0.0, "{power} {side} {least}");
                let Some(Arrival { list, touches: false, .. }) = found else { continue };
                assert!(watch.of_list(&list, (0, 1)).0.abs() < 1e-13, "{power} {side}");
            }
        }
    }

    /// The same where the pair crosses `R` just before or after a node: the arrival is at `R`.
    #[test]
    fn arrivals_beside_nodes_are_at_the_radius() {
        let tolerance = Tolerance { relative: 1e-4, absolute: 1e-4 };
        let watch = Watch { tolerance, ..watch(&[false; 3], &[]) };
        let list = on_circle(-1.1, -0.5);
        let arrival = |from: f64, until: f64| {
            let mut solution = Integrator::new(0.0, &list, tolerance);
            while solution.time() < from {
                solution.step(&mut circling, from).expect("a step");
            }
            solution.step(&mut circling, until).expect("a step");
            (solution.time() == until).then(|| watch.first(&mut solution, &mut circling))
        };
        // |r|² = 1 + 25/4 - 5 cos(angle) = 4 at cos(angle) = 13/20.
        let time = 1.1 - 0.65f64.acos();
        let mut found = 0;
        for k in 4..=8 {
            for late in (0..60).flat_map(|m| [1.0, -1.0].map(|side| side * 1e-12 * 1.5f64.powi(m))) {
                let (from, part) = (time - 0.1, 0.1 / f64::from(k));
                let Some(Some(arrival)) = arrival(from, from + 8.0 * part * (1.0 + late)) else { continue };
                let (side, rate) = watch.of_list(&arrival.list, (0, 1));
                assert!(side.abs() < 1e-13 && rate < 0.0 && !arrival.touches, "{k} {late} {side}");
                found += 1;
            }
        }
        assert!(found > 300, "{found}");
    }
}
