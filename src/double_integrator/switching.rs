//! The motion of a flock in floats: on a fixed network, with links that switch by distance, or by a given signal.
//!
//! The network is a state of its own, not read off the positions: between events it is constant and the law smooth. When a pair arrives at
//! `R` (`arrival.rs`), the integration goes on from the state located, with the network that follows. All pairs that are at `R` then,
//! within rounding, are handled together. Where they may go on in several ways (`fork.rs`) the choice is recorded.

use super::arrival::{Arrival, Watch, place, rounding};
use super::closed_loop::ClosedLoop;
use super::energy_log::Energy;
use super::fork::Law;
use super::input::{Flock, Network};
use super::motion::{Choice, Event, EventKind, Motion, MotionError, Options, Prefer, Sample};
use super::{Alignment, Branch, Coordinates, Fork, ForkError, Pair, Slope, State, Vector, Way};
use super::{gyroscopic, heading, potential_gradients, tied, velocity_alignment};
use crate::arithmetic::{ArithmeticError, Field, Interval, Rational};
use crate::simulate::{Integrator, VectorField, root};

const PLANE: Coordinates = Coordinates::Cartesian;

/// Steps between two arrivals after which it is given up.
const MOST_STEPS: usize = 10_000_000;

/// Pairs that stay at `R` are drawn back to it at this rate, against the errors of the integrator.
const DRAWN_BACK: f64 = 4.0;

/// Weights of pairs that stay at `R` may leave `[0, 1]` by this much through rounding.
const WEIGHT_SLACK: f64 = 1e-9;

/// Parts of a step in which weights are looked at.
const PARTS: usize = 8;

/// Bits of intervals at forks.
const PRECISION: u32 = 120;

impl Flock {
    /// The motion from time 0 to `until`, with samples at some times.
    ///
    /// Switching by distance: every arrival of a pair at `R` is located to rounding on states of full order. Cost: a step takes time proportional
    /// to the links, and to the number of pairs with a small factor.
    ///
    /// # Errors
    /// [`MotionError`].
    pub fn run(&self, until: f64, samples: &[f64], options: &Options) -> Result<Motion, MotionError> {
        if !(until >= 0.0 && until < f64::INFINITY) {
            return Err(MotionError::Until(until));
        }
        let is_part = |x: f64| x > 0.0 && x < 1.0;
        if !(is_part(options.tolerance.relative) && is_part(options.tolerance.absolute)) {
            return Err(MotionError::Tolerance(options.tolerance));
        }
        let before = std::iter::once(&0.0).chain(samples);
        if let Some((_, &sample)) = before.zip(samples).find(|(a, b)| !(a <= b && **b <= until)) {
            return Err(MotionError::Samples { until, sample });
        }
        let mut engine = Engine::new(self, options)?;
        engine.start()?;
        for (from, until) in self.stretches(until) {
            if let Some(graph) = self.graph_from(from) {
                engine.impose(graph.edges())?;
            }
            while engine.time < until {
                engine.advance(until, samples)?;
            }
        }
        while engine.motion.samples.len() < samples.len() {
            engine.sample(until, &engine.list.clone())?;
        }
        Ok(engine.motion)
    }

    /// The accelerations with some links; of the pairs in `staying` with the weights that keep them at distance `R`.
    fn accelerations(
        &self,
        slope: &Slope<f64>,
        state: &State<f64>,
        links: &[Pair],
        staying: &[Pair],
    ) -> Result<Vec<Vector<f64>>, ArithmeticError> {
        match self.alignment {
            Alignment::Velocity if staying.is_empty() => velocity_alignment(state, links, PLANE, |_, _, s| slope.at(s)),
            Alignment::Velocity => {
                let weights = self.weights(state, links, staying)?;
                let weighted: Vec<(Pair, f64)> = staying.iter().copied().zip(weights).collect();
                self.law().weighted(state, links, &weighted)
            }
            Alignment::Heading(difference) => {
                let gradients = potential_gradients(&state.positions, links, PLANE, |_, _, s| slope.at(s))?;
                let angles: Result<Vec<f64>, ArithmeticError> = state.velocities.iter().map(heading).collect();
                let angles = angles?;
                gyroscopic(state, &gradients, links, |i, j| difference.read(angles[i] - angles[j]))
            }
        }
    }

    fn law(&self) -> Law<'_> {
        Law { coordinates: PLANE, potential: &self.potential }
    }

    /// The weights that keep pairs at distance `R`, and draw them back to it; 0 where the law does not depend on them.
    fn weights(&self, state: &State<f64>, links: &[Pair], staying: &[Pair]) -> Result<Vec<f64>, ArithmeticError> {
        let Network::Within(radius) = self.network else { return Ok(Vec::new()) };
        let wanted = |(i, j): Pair| {
            let r = state.separation(i, j);
            let rate = 2.0 * PLANE.product(&r, &state.relative_velocity(i, j));
            -DRAWN_BACK * (2.0 * rate + DRAWN_BACK * (PLANE.square(&r) - radius * radius))
        };
        match self.law().weights(state, links, staying, wanted) {
            Err(ArithmeticError::DivisionByZero) => Ok(vec![0.0; staying.len()]),
            other => other,
        }
    }

    /// The times between which no signal switches.
    fn stretches(&self, until: f64) -> Vec<(f64, f64)> {
        let mut ends = vec![0.0];
        if let Network::Signal(graphs) = &self.network {
            ends.extend(graphs.iter().map(|(from, _)| *from).filter(|from| *from > 0.0 && *from <= until));
        }
        ends.push(until);
        ends.windows(2).map(|w| (w[0], w[1])).collect()
    }

    /// The graph that a signal brings at a time after the start.
    fn graph_from(&self, time: f64) -> Option<&crate::graph::Graph> {
        let Network::Signal(graphs) = &self.network else { return None };
        graphs.iter().find(|(from, _)| *from == time && time > 0.0).map(|(_, graph)| graph)
    }
}

/// A motion on its way.
struct Engine<'a> {
    flock: &'a Flock,
    options: &'a Options,
    slope: Slope<f64>,
    energy: Energy,
    time: f64,
    list: Vec<f64>,
    linked: Vec<bool>,
    links: Vec<Pair>,
    staying: Vec<Pair>,
    fresh: Vec<Pair>,
    arrivals: usize,
    motion: Motion,
}

impl<'a> Engine<'a> {
    fn new(flock: &'a Flock, options: &'a Options) -> Result<Self, MotionError> {
        let radius = if let Network::Within(radius) = flock.network { Some(radius) } else { None };
        let count = flock.start.count();
        let mut engine = Engine {
            flock,
            options,
            slope: flock.potential.slope_over(&1.0),
            energy: Energy::new(&flock.potential, radius)?,
            time: 0.0,
            list: flock.start.to_list(),
            linked: vec![false; count * (count - 1) / 2],
            links: Vec::new(),
            staying: Vec::new(),
            fresh: Vec::new(),
            arrivals: 0,
            motion: Motion::default(),
        };
        engine.link(&flock.links_at_start());
        Ok(engine)
    }

    fn count(&self) -> usize {
        self.flock.start.count()
    }

    fn state(&self) -> State<f64> {
        self.state_of(&self.list)
    }

    fn state_of(&self, list: &[f64]) -> State<f64> {
        State::from_list(self.count(), list).unwrap_or_else(|| self.flock.start.clone())
    }

    /// These links and no others.
    fn link(&mut self, links: &[Pair]) {
        self.linked.fill(false);
        links.iter().for_each(|&pair| self.linked[place(pair)] = true);
        self.links = links.to_vec();
    }

    fn sample(&mut self, time: f64, list: &[f64]) -> Result<(), MotionError> {
        let state = self.state_of(list);
        let energy = self.energy.of(&state, &self.links)?.0;
        self.motion.samples.push(Sample { time, state, links: self.links.clone(), energy });
        Ok(())
    }

    /// Pairs at `R` at the start, exactly or within rounding.
    fn start(&mut self) -> Result<(), MotionError> {
        let state = self.state();
        let first = self.energy.of(&state, &self.links)?.0;
        (self.motion.energy.first, self.motion.energy.last) = (first, first);
        let Network::Within(radius) = self.flock.network else { return Ok(()) };
        let ties = self.ties(&state, radius);
        if ties.is_empty() {
            return Ok(());
        }
        // Exactly, if the numbers given are exactly at R.
        let exact = state.map(|x| Rational::from_float(*x).unwrap_or_default());
        let square = Rational::from_float(radius).unwrap_or_default();
        let fork = if tied(&exact.positions, &(&square * &square), PLANE) == ties {
            let links: Vec<Pair> = self.links.iter().copied().filter(|pair| !ties.contains(pair)).collect();
            let fork = self.flock.law().fork(&exact, &links, &ties, &[]);
            fork.map(|f| f.branches.iter().map(|b| b.map(|w| 1.0.rational(w))).collect())
        } else {
            let still = self.grazing(&state, &ties, radius);
            self.fork(&state, &ties, &still).map(|f| f.branches)
        };
        let branches: Vec<Branch<f64>> = fork.map_err(|error| MotionError::Fork { time: 0.0, error })?;
        if let Some(index) = self.options.first_branch
            && index >= branches.len()
        {
            return Err(MotionError::NoSuchBranch { index, count: branches.len() });
        }
        self.follow(&state, branches, self.options.first_branch, &[])
    }

    /// One step or the part of it before the next arrival.
    fn advance(&mut self, until: f64, samples: &[f64]) -> Result<(), MotionError> {
        let (flock, slope, links, staying) = (self.flock, self.slope.clone(), self.links.clone(), self.staying.clone());
        let law = |state: &State<f64>| flock.accelerations(&slope, state, &links, &staying);
        let mut field = ClosedLoop::new(self.count(), law);
        let mut solution = Integrator::new(self.time, &self.list, self.options.tolerance);
        while solution.time() < until {
            let before = self.state_of(solution.state());
            let stepped = solution.step(&mut field, until);
            if stepped.is_err() || solution.counts().0 > MOST_STEPS {
                return Err(self.stuck(solution.time(), solution.state()));
            }
            let arrival = self.arrival(&mut solution, &mut field)?;
            let (end, list) = match &arrival {
                Some(arrival) => (arrival.time, arrival.list.clone()),
                None => (solution.time(), solution.state().to_vec()),
            };
            while let Some(&time) = samples.get(self.motion.samples.len()).filter(|time| **time < end) {
                let there = solution.within(&mut field, time);
                self.sample(time, &there)?;
            }
            self.log_step(&before, end, &list)?;
            (self.time, self.list) = (end, list);
            if let Some(arrival) = arrival {
                self.motion.steps += solution.counts().0;
                return self.switch(&arrival);
            }
            self.fresh.clear();
        }
        self.motion.steps += solution.counts().0;
        Ok(())
    }

    fn stuck(&self, time: f64, list: &[f64]) -> MotionError {
        let state = self.state_of(list);
        let distance = |&(i, j): &Pair| ((i, j), PLANE.square(&state.separation(i, j)).sqrt());
        MotionError::Stuck { time, closest: self.links.iter().map(distance).min_by(|a, b| a.1.total_cmp(&b.1)) }
    }

    fn log_step(&mut self, before: &State<f64>, time: f64, list: &[f64]) -> Result<(), MotionError> {
        let after = self.state_of(list);
        let (from, rounding) = self.energy.of(before, &self.links)?;
        let (to, more) = self.energy.of(&after, &self.links)?;
        let margin = self.energy.margin(before, &self.links, self.options.tolerance)?;
        self.motion.energy.step(time, from, to, margin + rounding + more);
        Ok(())
    }

    /// The first arrival in the last step, or the first time at which a pair cannot stay at `R` any more.
    fn arrival(
        &self,
        solution: &mut Integrator,
        field: &mut impl VectorField,
    ) -> Result<Option<Arrival>, ArithmeticError> {
        let Network::Within(radius) = self.flock.network else { return Ok(None) };
        let watch = Watch {
            radius,
            count: self.count(),
            linked: &self.linked,
            staying: &self.staying,
            fresh: &self.fresh,
            tolerance: self.options.tolerance,
        };
        let arrival = watch.first(solution, field);
        let Some(&pair) = self.staying.first() else { return Ok(arrival) };
        // How far the weights are within [0, 1].
        let room = |list: &[f64]| {
            let weights = self.flock.weights(&self.state_of(list), &self.links, &self.staying).unwrap_or_default();
            weights.iter().fold(1.0, |room: f64, w| room.min(*w).min(1.0 - w))
        };
        let (from, to) = (solution.previous_time(), arrival.as_ref().map_or(solution.time(), |a| a.time));
        let time = |k: usize| from + (to - from) * k as f64 / PARTS as f64;
        let outside = (1..=PARTS).find(|&k| room(&solution.interpolate(field, time(k))) < -WEIGHT_SLACK);
        let Some(k) = outside else { return Ok(arrival) };
        let time = root(time(k - 1), time(k), false, |t| room(&solution.within(field, t)));
        Ok(Some(Arrival { time, list: solution.within(field, time), pair, touches: true }))
    }

    /// The pairs at distance `R` within rounding, without those that stay there.
    fn ties(&self, state: &State<f64>, radius: f64) -> Vec<Pair> {
        let pairs = (0..self.count()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let off = |&(i, j): &Pair| (PLANE.square(&state.separation(i, j)) - radius * radius).abs();
        pairs.filter(|pair| off(pair) <= self.slack(state, *pair, radius) && !self.staying.contains(pair)).collect()
    }

    /// By how much `|r_ij|² - R²` can be off at an event: rounding of the state and of the time.
    fn slack(&self, state: &State<f64>, pair: Pair, radius: f64) -> f64 {
        let rate = 2.0 * PLANE.product(&state.separation(pair.0, pair.1), &state.relative_velocity(pair.0, pair.1));
        4.0 * (rounding(state, pair, radius) + rate.abs() * f64::EPSILON * self.time)
    }

    /// The ties whose distance has rate 0: if it turned, it would within rounding of `R`.
    fn grazing(&self, state: &State<f64>, ties: &[Pair], radius: f64) -> Vec<Pair> {
        let accelerations = self.flock.accelerations(&self.slope, state, &self.links, &[]).unwrap_or_default();
        let jump = 8.0 * radius * radius * self.slope.at(&(radius * radius)).unwrap_or(0.0).abs();
        let grazes = |&&(i, j): &&Pair| {
            let (r, v) = (state.separation(i, j), state.relative_velocity(i, j));
            let size = |k: usize| accelerations.get(k).map_or(0.0, |a| PLANE.square(a).sqrt());
            let bend = 2.0 * (PLANE.square(&v) + radius * (size(i) + size(j))) + jump;
            let rate = 2.0 * PLANE.product(&r, &v);
            rate * rate <= 2.0 * bend * 4.0 * rounding(state, (i, j), radius)
        };
        ties.iter().filter(grazes).copied().collect()
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
    fn switch(&mut self, arrival: &Arrival) -> Result<(), MotionError> {
        let Network::Within(radius) = self.flock.network else { return Ok(()) };
        self.arrivals += 1;
        if self.arrivals > self.options.most_events {
            let (count, time, pair) = (self.options.most_events, self.time, arrival.pair);
            return Err(MotionError::TooManyEvents { count, time, pair });
        }
        let state = self.state();
        let mut ties = self.ties(&state, radius);
        let mut still = self.grazing(&state, &ties, radius);
        still.extend(self.staying.iter().copied());
        ties.extend(self.staying.iter().copied());
        if !ties.contains(&arrival.pair) {
            ties.push(arrival.pair);
        }
        if arrival.touches && !still.contains(&arrival.pair) {
            still.push(arrival.pair);
        }
        ties.sort_by_key(|&pair| place(pair));
        let branches = if still.is_empty() {
            let rate = |(i, j): Pair| PLANE.product(&state.separation(i, j), &state.relative_velocity(i, j));
            let way = |pair: Pair| if rate(pair) > 0.0 { Way::Leaves } else { Way::Enters };
            vec![Branch { ways: ties.iter().map(|&pair| (pair, way(pair))).collect(), decided: true }]
        } else {
            let fork = self.fork(&state, &ties, &still);
            fork.map_err(|error| MotionError::Fork { time: self.time, error })?.branches
        };
        self.follow(&state, branches, None, &still)
    }

    /// Goes on by one of some branches: a given one, or the one preferred.
    fn follow(
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
            let (i, j) = *pair;
            let rate = 2.0 * PLANE.product(&state.separation(i, j), &state.relative_velocity(i, j));
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

    /// A signal brings new links.
    fn impose(&mut self, links: Vec<Pair>) -> Result<(), MotionError> {
        let state = self.state();
        let time = self.time;
        self.flock.check_links(&links, &state).map_err(|error| MotionError::Signal { time, error })?;
        let old = self.energy.of(&state, &self.links)?.0;
        let before = self.linked.clone();
        self.link(&links);
        let pairs = (0..self.count()).flat_map(|j| (0..j).map(move |i| (i, j)));
        for (i, j) in pairs.filter(|&pair| before[place(pair)] != self.linked[place(pair)]) {
            let kind = if self.linked[place((i, j))] { EventKind::Link } else { EventKind::Unlink };
            let rate = 2.0 * PLANE.product(&state.separation(i, j), &state.relative_velocity(i, j));
            self.motion.events.push(Event { time, pair: (i, j), kind, rate });
        }
        let new = self.energy.of(&state, &self.links)?.0;
        self.motion.energy.imposed += new - old;
        self.motion.energy.last = new;
        Ok(())
    }
}
