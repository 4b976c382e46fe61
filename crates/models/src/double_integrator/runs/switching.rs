//! The motion of a flock in floats: on a fixed network, and with links that switch by distance.
//!
//! The network is a state of its own, not read off the positions: between events it is constant and the law smooth. When a pair arrives at
//! `R` (`arrival.rs`), the integration goes on from the state located, with the network that follows. All pairs that are at `R` then,
//! within rounding, are handled together. Where they may go on in several ways (`fork.rs`) the choice is recorded.

use super::arrival::{Arrival, Watch, place};
use super::closed_loop::ClosedLoop;
use super::energy_log::Energy;
use super::fork::{Branch, Law};
use super::input::{Alignment, Flock, Network};
use super::motion::{Motion, MotionError, Options, Sample};
use crate::double_integrator::laws::{
    Coordinates, Pair, Slope, State, Vector, gyroscopic, heading, potential_gradients, velocity_alignment,
};
use arithmetic::{ArithmeticError, Progress};
use motion::{Integrator, VectorField, root};

const PLANE: Coordinates = Coordinates::Cartesian;

/// Steps between two arrivals after which it is given up.
const MOST_STEPS: usize = 10_000_000;

/// Pairs that stay at `R` are drawn back to it at this rate, against the errors of the integrator.
const DRAWN_BACK: f64 = 4.0;

/// Weights of pairs that stay at `R` may leave `[0, 1]` by this much through rounding.
const WEIGHT_SLACK: f64 = 1e-9;

/// Parts of a step in which weights are looked at.
const PARTS: usize = 8;

impl Flock {
    /// The motion from time 0 to `until`, with samples at some times.
    ///
    /// Switching by distance: every arrival of a pair at `R` is located to rounding on states of full order. Cost: a step takes time proportional
    /// to the links, and to the number of pairs with a small factor.
    ///
    /// # Errors
    /// [`MotionError`].
    pub fn run(
        &self,
        until: f64,
        samples: &[f64],
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<Motion, MotionError> {
        let (motion, end) = self.run_as_far(until, samples, options, progress);
        end.map(|()| motion)
    }

    /// As [`Self::run`], with what was reached where it ends before: the motion that far, and why there is no more of it.
    pub fn run_as_far(
        &self,
        until: f64,
        samples: &[f64],
        options: &Options,
        progress: &dyn Progress,
    ) -> (Motion, Result<(), MotionError>) {
        self.follow(&self.links_at_start(), options, progress, |engine| engine.run(until, samples))
    }

    /// From a time with some links in force, where pairs are at `R`, until none stays there: one step of the integrator at least. The last
    /// sample is where this ends.
    pub fn run_staying(
        &self,
        from: f64,
        links: &[Pair],
        samples: &[f64],
        options: &Options,
        progress: &dyn Progress,
    ) -> (Motion, Result<(), MotionError>) {
        self.follow(links, options, progress, |engine| {
            (engine.time, engine.until_none_stays) = (from, true);
            engine.run_staying(samples)
        })
    }

    /// A motion with some links at its start: what was reached on its way, and why there is no more of it.
    fn follow(
        &self,
        links: &[Pair],
        options: &Options,
        progress: &dyn Progress,
        way: impl FnOnce(&mut Engine) -> Result<(), MotionError>,
    ) -> (Motion, Result<(), MotionError>) {
        match Engine::new(self, links, options, progress) {
            Ok(mut engine) => {
                let end = way(&mut engine);
                (engine.motion, end)
            }
            Err(error) => (Motion::default(), Err(error)),
        }
    }

    fn check(until: f64, samples: &[f64], options: &Options) -> Result<(), MotionError> {
        if !(0.0..f64::INFINITY).contains(&until) {
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
        Ok(())
    }

    /// The accelerations with some links; of the pairs in `staying` with the weights that keep them at distance `R`.
    pub(super) fn accelerations(
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

    pub(super) fn law(&self) -> Law<'_> {
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
}

/// A motion on its way.
pub(super) struct Engine<'a> {
    pub flock: &'a Flock,
    pub options: &'a Options,
    progress: &'a dyn Progress,
    pub slope: Slope<f64>,
    pub energy: Energy,
    pub time: f64,
    pub list: Vec<f64>,
    pub linked: Vec<bool>,
    pub links: Vec<Pair>,
    pub staying: Vec<Pair>,
    pub fresh: Vec<Pair>,
    pub arrivals: usize,
    /// Whether to end where no pair stays at `R`.
    until_none_stays: bool,
    pub motion: Motion,
}

impl<'a> Engine<'a> {
    fn new(
        flock: &'a Flock,
        links: &[Pair],
        options: &'a Options,
        progress: &'a dyn Progress,
    ) -> Result<Self, MotionError> {
        let radius = if let Network::Within(radius) = flock.network { Some(radius) } else { None };
        let count = flock.start.count();
        let mut engine = Engine {
            flock,
            options,
            progress,
            slope: flock.potential.slope_over(&1.0),
            energy: Energy::new(&flock.potential, radius)?,
            time: 0.0,
            list: flock.start.to_list(),
            linked: vec![false; count * (count - 1) / 2],
            links: Vec::new(),
            staying: Vec::new(),
            fresh: Vec::new(),
            arrivals: 0,
            until_none_stays: false,
            motion: Motion::default(),
        };
        engine.link(links);
        Ok(engine)
    }

    /// The whole way.
    fn run(&mut self, until: f64, samples: &[f64]) -> Result<(), MotionError> {
        Flock::check(until, samples, self.options)?;
        self.start()?;
        while self.time < until {
            self.advance(until, samples)?;
        }
        while self.motion.samples.len() < samples.len() {
            self.sample(until, &self.list.clone())?;
        }
        Ok(())
    }

    /// The way until no pair stays at `R`.
    fn run_staying(&mut self, samples: &[f64]) -> Result<(), MotionError> {
        let until = samples.last().copied().unwrap_or(self.time);
        Flock::check(until, samples, self.options)?;
        self.start()?;
        while self.time < until {
            self.advance(until, samples)?;
            if self.is_free() {
                break;
            }
        }
        self.sample(self.time, &self.list.clone())
    }

    /// Whether no pair stays at `R`, or has just left it.
    fn is_free(&self) -> bool {
        self.staying.is_empty() && self.fresh.is_empty()
    }

    pub(super) fn count(&self) -> usize {
        self.flock.start.count()
    }

    pub(super) fn state(&self) -> State<f64> {
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
        let branches = match self.flock.network {
            Network::Within(radius) => self.first_branches(&state, radius)?,
            _ => vec![Branch { ways: Vec::new(), decided: true }],
        };
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
            if self.progress.is_cancelled() {
                return Err(MotionError::Halted(solution.time()));
            }
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
            if self.until_none_stays && self.is_free() {
                break;
            }
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double_integrator::Potential;
    use arithmetic::{Unwatched, rational};
    use motion::Tolerance;

    /// Three agents, with `R = 2`, of which the first two are a little too far apart and on their way.
    fn flock(potential: Potential) -> Flock {
        let positions = vec![[0.0, 0.0], [2.01, 0.1], [1.5, 1.75]];
        let velocities = vec![[0.25, 1.0], [0.5, -0.75], [-1.0, 0.5]];
        Flock::new(Alignment::Velocity, potential, Network::Within(2.0), State { positions, velocities }).expect("fits")
    }

    /// `d²(|r|² - R²)/dt² = -4 (2 d|r|²/dt + 4 (|r|² - R²))`: errors decay like `exp(-4t)`, of one pair and of two that stay.
    #[test]
    fn pairs_that_stay_are_drawn_back_to_the_radius() {
        let flock = flock(Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)));
        let (slope, state) = (flock.potential.slope_over(&1.0), flock.start());
        for (links, staying) in [
            (&[][..], &[(0, 1)][..]),
            (&[(0, 2), (1, 2)], &[(0, 1)]),
            (&[(1, 2)], &[(0, 1), (0, 2)]),
            (&[], &[(0, 1), (0, 2), (1, 2)]),
        ] {
            let a = flock.accelerations(&slope, state, links, staying).expect("weights");
            for &(i, j) in staying {
                let (r, v) = (state.separation(i, j), state.relative_velocity(i, j));
                let bend = [a[i][0] - a[j][0], a[i][1] - a[j][1]];
                let second = 2.0 * (v[0] * v[0] + v[1] * v[1] + r[0] * bend[0] + r[1] * bend[1]);
                let rate = 2.0 * (r[0] * v[0] + r[1] * v[1]);
                let excess = r[0] * r[0] + r[1] * r[1] - 4.0;
                assert!((second + 4.0 * (2.0 * rate + 4.0 * excess)).abs() < 1e-10, "{links:?} {staying:?}");
            }
        }
    }

    /// Without a slope at `R` the distance does not depend on the weight, which is 0 then: no acceleration, though the velocities differ across.
    #[test]
    fn weights_that_do_not_matter_are_zero() {
        let flat = Potential::new(vec![(1, rational(1, 1)), (0, rational(-4, 1))], (rational(1, 1), rational(5, 1)));
        let flock = flock(flat);
        let state = State { positions: vec![[0.0, 0.0], [2.0, 0.0]], velocities: vec![[0.0, 1.0], [0.0, -1.0]] };
        let found = flock.accelerations(&flock.potential.slope_over(&1.0), &state, &[], &[(0, 1)]);
        assert_eq!(found, Ok(vec![[0.0; 2]; 2]));
    }

    /// Where a motion ends that cannot be followed the closest linked agents are told, with their distance.
    #[test]
    fn the_closest_linked_agents_are_told() {
        let flock = flock(Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)));
        let options = Options::default();
        let mut list = flock.start().to_list();
        list[..6].copy_from_slice(&[0.0, 0.0, 3.0, 4.0, 0.3, -0.4]);
        let told = |links: &[Pair]| {
            let engine = Engine::new(&flock, links, &options, &Unwatched).expect("an engine");
            let MotionError::Stuck { time: 1.5, closest } = engine.stuck(1.5, &list) else { panic!("stuck") };
            closest.map(|(pair, distance)| (pair, (distance * 1e9).round() / 1e9))
        };
        assert_eq!(told(&[]), None);
        assert_eq!(told(&[(0, 1)]), Some(((0, 1), 5.0)));
        assert_eq!(told(&[(0, 1), (0, 2)]), Some(((0, 2), 0.5)));
        assert_eq!(told(&[(0, 2), (0, 1)]), Some(((0, 2), 0.5)));
    }

    /// What a step may add to the energy is the margin of its start and the rounding at both ends, here all of one size.
    #[test]
    fn a_step_may_add_the_margin_and_rounding_twice() {
        let flock = flock(Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)));
        let links = [(0, 2), (1, 2)];
        let options = Options { tolerance: Tolerance { relative: 1e-15, absolute: 1e-15 }, ..Options::default() };
        let mut engine = Engine::new(&flock, &links, &options, &Unwatched).expect("an engine");
        let (before, list) = (flock.start(), flock.start().to_list().iter().map(|x| x * 1.25).collect::<Vec<_>>());
        let (from, one) = engine.energy.of(before, &links).expect("apart");
        let (to, other) = engine.energy.of(&engine.state_of(&list), &links).expect("apart");
        let margin = engine.energy.margin(before, &links, options.tolerance).expect("apart");
        engine.log_step(before, 0.75, &list).expect("apart");
        let rise = engine.motion.energy.rise;
        assert_eq!((rise.change, rise.time), (to - from, 0.75));
        assert!((rise.allowed / (margin + one + other) - 1.0).abs() < 1e-12);
        assert!(one > 0.1 * margin && other > 0.1 * margin && one != other, "{margin} {one} {other}");
    }
}
