//! A flock whose pairs are at the distance `R`: which they are, the ways on, and the one that is followed.

use super::arrival::{Arrival, place, rounding};
use super::fork::{Branch, Fork, ForkError, Way};
use super::input::Network;
use super::motion::{Choice, Event, EventKind, MotionError, Prefer};
use super::switching::Engine;
use crate::double_integrator::laws::{Coordinates, Pair, State, Vector};
use arithmetic::{Field, Interval, Rational};

const PLANE: Coordinates = Coordinates::Cartesian;

/// Bits of intervals at forks.
const PRECISION: u32 = 120;

impl Engine<'_> {
    /// The ways on from the start: exact where the numbers given are exactly at `R`.
    pub(super) fn first_branches(&self, state: &State<f64>, radius: f64) -> Result<Vec<Branch<f64>>, MotionError> {
        let ties = self.ties(state, radius);
        let exact = state.map(|x| Rational::from_float(*x).unwrap_or_default());
        let radius_itself = Rational::from_float(radius).unwrap_or_default();
        let square = &radius_itself * &radius_itself;
        let is_exact = |&(i, j): &Pair| PLANE.square(&exact.separation(i, j)) == square;
        let branches = if ties.iter().all(is_exact) {
            let links: Vec<Pair> = self.links.iter().copied().filter(|pair| !ties.contains(pair)).collect();
            let fork = self.flock.law().fork(&exact, &links, &ties, &[]);
            fork.map(|f| f.branches.iter().map(|b| b.map(|w| 1.0.rational(w))).collect())
        } else {
            self.ways_on(state, &ties, &[], radius).map(|(branches, _)| branches)
        };
        branches.map_err(|error| MotionError::Fork { time: 0.0, error })
    }

    /// The pairs at distance `R` within rounding, without those that stay there.
    fn ties(&self, state: &State<f64>, radius: f64) -> Vec<Pair> {
        let pairs = (0..self.count()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let off = |&(i, j): &Pair| (PLANE.square(&state.separation(i, j)) - radius * radius).abs();
        pairs.filter(|pair| off(pair) <= self.slack(state, *pair, radius) && !self.staying.contains(pair)).collect()
    }

    /// By how much `|r_ij|² - R²` can be off at an event: rounding of the state and of the time.
    fn slack(&self, state: &State<f64>, pair: Pair, radius: f64) -> f64 {
        let rate = self.rate(state, pair);
        4.0 * (rounding(state, pair, radius) + rate.abs() * f64::EPSILON * self.time)
    }

    /// The branches, and the ties that count as grazing in them. Where links push apart (`V'(R²) < 0`) pairs can switch ever faster; then as
    /// much as the integrator's tolerance allows counts as rate 0, so that they stay at `R`. But a pair whose rate is not 0 within rounding
    /// stays or passes: it does not turn back.
    fn ways_on(
        &self,
        state: &State<f64>,
        ties: &[Pair],
        given: &[Pair],
        radius: f64,
    ) -> Result<(Vec<Branch<f64>>, Vec<Pair>), ForkError> {
        let accelerations = self.flock.accelerations(&self.slope, state, &self.links, &[]).unwrap_or_default();
        let slope = self.slope.at(&(radius * radius)).unwrap_or(0.0);
        let least = if slope < 0.0 { 100.0 * self.options.tolerance.relative * radius * radius } else { 0.0 };
        let [exactly, nearly] = [0.0, least].map(|least| {
            let grazes = |pair: &Pair| self.grazes(state, &accelerations, (radius, slope), *pair, least);
            let grazing = ties.iter().filter(|pair| !given.contains(pair) && grazes(pair));
            given.iter().chain(grazing).copied().collect::<Vec<_>>()
        });
        let passing = |pair: Pair| if self.rate(state, pair) > 0.0 { Way::Leaves } else { Way::Enters };
        let turns = |(pair, way): &(Pair, Way<f64>)| {
            !exactly.contains(pair) && !matches!(way, Way::Stays(_)) && *way != passing(*pair)
        };
        if nearly != exactly {
            let mut branches = self.fork(state, ties, &nearly)?.branches;
            branches.retain(|branch| !branch.ways.iter().any(turns));
            if !branches.is_empty() {
                return Ok((branches, nearly));
            }
        }
        if exactly.is_empty() {
            let ways = ties.iter().map(|&pair| (pair, passing(pair))).collect();
            return Ok((vec![Branch { ways, decided: true }], exactly));
        }
        Ok((self.fork(state, ties, &exactly)?.branches, exactly))
    }

    /// The rate of `|r_ij|²`.
    fn rate(&self, state: &State<f64>, (i, j): Pair) -> f64 {
        2.0 * PLANE.product(&state.separation(i, j), &state.relative_velocity(i, j))
    }

    /// Whether the distance of a tie has rate 0: if it turned, it would within rounding of `R`, or within `least` of `|r_ij|²`.
    fn grazes(
        &self,
        state: &State<f64>,
        accelerations: &[Vector<f64>],
        (radius, slope): (f64, f64),
        (i, j): Pair,
        least: f64,
    ) -> bool {
        let v = state.relative_velocity(i, j);
        let size = |k: usize| accelerations.get(k).map_or(0.0, |a| PLANE.square(a).sqrt());
        let bend = 2.0 * (PLANE.square(&v) + radius * (size(i) + size(j))) + 8.0 * radius * radius * slope.abs();
        let rate = self.rate(state, (i, j));
        rate * rate <= 2.0 * bend * least.max(4.0 * rounding(state, (i, j), radius))
    }

    /// The ways on, over intervals as wide as rounding.
    fn fork(&self, state: &State<f64>, ties: &[Pair], still: &[Pair]) -> Result<Fork<f64>, ForkError> {
        let largest = |vectors: &[Vector<f64>]| vectors.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        let wide = |vectors: &[Vector<f64>]| -> Vec<Vector<Interval>> {
            let radius = 16.0 * f64::EPSILON * largest(vectors);
            let end = |x: f64| Rational::from_float(x).unwrap_or_default();
            let interval = |x: f64| Interval::hull_of_rationals(&end(x - radius), &end(x + radius), PRECISION);
            vectors.iter().map(|v| v.map(interval)).collect()
        };
        let state = State { positions: wide(&state.positions), velocities: wide(&state.velocities) };
        let links: Vec<Pair> = self.links.iter().copied().filter(|pair| !ties.contains(pair)).collect();
        let fork = self.flock.law().fork(&state, &links, ties, still)?;
        let branches = fork.branches.iter().map(|branch| branch.map(Interval::to_f64)).collect();
        Ok(Fork { branches, grazing: fork.grazing })
    }

    /// A pair has arrived at `R`.
    pub(super) fn switch(&mut self, arrival: &Arrival) -> Result<(), MotionError> {
        let Network::Within(radius) = self.flock.network else { return Ok(()) };
        self.arrivals += 1;
        if self.arrivals > self.options.most_events {
            let (count, time, pair) = (self.options.most_events, self.time, arrival.pair);
            return Err(MotionError::TooManyEvents { count, time, pair });
        }
        let state = self.state();
        let mut ties = self.ties(&state, radius);
        let mut given = self.staying.clone();
        ties.extend(self.staying.iter().copied());
        if !ties.contains(&arrival.pair) {
            ties.push(arrival.pair);
        }
        given.extend((arrival.touches && !given.contains(&arrival.pair)).then_some(arrival.pair));
        ties.sort_by_key(|&pair| place(pair));
        let ways_on = self.ways_on(&state, &ties, &given, radius);
        let (branches, still) = ways_on.map_err(|error| MotionError::Fork { time: self.time, error })?;
        self.follow(&state, branches, None, &still)
    }

    /// Goes on by one of some branches: a given one, or the one preferred.
    pub(super) fn follow(
        &mut self,
        state: &State<f64>,
        branches: Vec<Branch<f64>>,
        given: Option<usize>,
        still: &[Pair],
    ) -> Result<(), MotionError> {
        let taken = given.or_else(|| (0..branches.len()).min_by_key(|&k| self.rank(&branches[k])));
        // Where rounding leaves nothing, nothing changes.
        let Some(taken) = taken else { return Ok(()) };
        let (old, rounding_before) = self.energy.of(state, &self.links)?;
        let ways = branches[taken].ways.clone();
        if branches.len() > 1 {
            self.motion.choices.push(Choice { time: self.time, branches, taken });
        }
        let (mut events, mut allowed) = (Vec::new(), 0.0);
        self.fresh.clear();
        for (pair, way) in &ways {
            let (linked, stayed) = (self.linked[place(*pair)], self.staying.contains(pair));
            let kind = match way {
                Way::Leaves if linked || stayed => Some(EventKind::Unlink),
                Way::Enters if !linked => Some(EventKind::Link),
                Way::Stays(_) if !stayed => Some(EventKind::Stay),
                Way::Stays(_) => None,
                _ => still.contains(pair).then_some(EventKind::Touch),
            };
            let rate = self.rate(state, *pair);
            events.extend(kind.map(|kind| Event { time: self.time, pair: *pair, kind, rate }));
            self.linked[place(*pair)] = *way == Way::Enters;
            self.staying.retain(|other| other != pair);
            match way {
                Way::Stays(_) => self.staying.push(*pair),
                _ => self.fresh.push(*pair),
            }
            allowed += self.jump_allowed(state, *pair, stayed);
        }
        let count = self.count();
        let pairs = (0..count).flat_map(|j| (0..j).map(move |i| (i, j)));
        self.links = pairs.filter(|&pair| self.linked[place(pair)]).collect();
        self.motion.events.extend(events);
        let (new, rounding_after) = self.energy.of(state, &self.links)?;
        self.motion.energy.switch(self.time, old, new, rounding_before + rounding_after + allowed);
        Ok(())
    }

    /// `|V'(R²)|` times what `|r_ij|² - R²` can be.
    fn jump_allowed(&self, state: &State<f64>, pair: Pair, stayed: bool) -> f64 {
        let Network::Within(radius) = self.flock.network else { return 0.0 };
        let slope = self.slope.at(&(radius * radius)).unwrap_or(0.0).abs();
        let drift = if stayed {
            1e3 * radius * (self.options.tolerance.absolute + self.options.tolerance.relative * radius)
        } else {
            0.0
        };
        slope * (2.0 * self.slack(state, pair, radius) + drift)
    }

    /// Branches of lower rank are preferred.
    fn rank(&self, branch: &Branch<f64>) -> (usize, bool) {
        let of = |(pair, way): &(Pair, Way<f64>)| {
            let linked = self.linked[place(*pair)];
            let kept = matches!((way, linked), (Way::Leaves, false) | (Way::Enters, true));
            let wanted = match self.options.prefer {
                Prefer::Keep => kept,
                Prefer::Leave => *way == Way::Leaves,
                Prefer::Enter => *way == Way::Enters,
                Prefer::Stay => matches!(way, Way::Stays(_)),
            };
            match way {
                _ if wanted => 0,
                _ if kept => 1,
                Way::Stays(_) => 2,
                _ => 3,
            }
        };
        (branch.ways.iter().map(of).sum(), !branch.decided)
    }
}
