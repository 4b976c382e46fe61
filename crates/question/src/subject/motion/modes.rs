//! Platoons on a line as the exact sum over their modes: no steps, so that no time is out of reach.

use super::numbers::{BITS, Start, narrowed, point, widened};
use crate::failure::Failure;
use arithmetic::{ArithmeticError, FloatInterval, Interval, Number, Rational, rational};
use models::platoon::front_in_time::{FrontMotion, FrontStart};
use models::platoon::time_domain::{Followers, Modes, SwingingStart};
use models::platoon::{Communication, CommunicationGraph, Gains, Platoon};
use motion::enclose::IntervalVector;

/// Most followers.
const MOST_FOLLOWERS: usize = 128;

/// The motion of a line of cars.
enum Motion {
    FrontAndBack(SwingingStart<Interval>),
    Front(FrontStart<Interval>),
}

impl Motion {
    /// Behind a leader with this swing, for gains for which it is known.
    fn of(
        graph: &CommunicationGraph,
        gains: &Gains<Interval>,
        first: &Followers<Interval>,
        (amplitude, w): (&Interval, &Interval),
    ) -> Option<Self> {
        let followers = graph.followers();
        let is = |line| CommunicationGraph::of(line, followers).is_ok_and(|line| line == *graph);
        if is(Communication::FrontAndBack) {
            let modes = Modes::new(gains, followers as u64).ok()?;
            return modes.behind_swinging_leader(first, amplitude, w).ok().map(Motion::FrontAndBack);
        }
        let front = is(Communication::Front).then(|| FrontMotion::new(gains, followers))?.ok()?;
        front.behind_swinging_leader(first, amplitude, w).ok().map(Motion::Front)
    }

    fn deviations(&self, t: &Interval) -> Result<Followers<Interval>, ArithmeticError> {
        match self {
            Motion::FrontAndBack(start) => start.deviations(t),
            Motion::Front(start) => start.deviations(t),
        }
    }
}

/// A platoon in the frame of its leader.
pub(super) struct ModalPlatoon {
    start: Motion,
    graph: CommunicationGraph,
    gains: Gains<FloatInterval>,
    /// `A w²` and `w` of the leader's swing.
    swing: (Interval, Interval),
}

impl ModalPlatoon {
    /// The platoon, if it is one on a line with gains for which its motion is known. `start` gives the deviations and rates
    /// of all cars without the swing.
    pub fn new(
        start: impl Fn(&Start, usize) -> FloatInterval,
        platoon: &Platoon<Rational>,
        swing: &(Rational, Rational),
    ) -> Option<Self> {
        let (graph, gains) = platoon.with_equal_gains()?;
        let followers = graph.followers();
        let zero = rational(0, 1);
        if followers > MOST_FOLLOWERS || gains.f >= zero || gains.g >= zero {
            return None;
        }
        let number = |q: &Rational| Interval::from_rational(q, BITS);
        let exact = gains.map(number);
        let (amplitude, w) = (number(&swing.0), number(&swing.1));
        // The swing begins at its largest deviation, at rest.
        let relative = |list: &Start, own: &Interval| -> Vec<Interval> {
            let leader = widened(&start(list, 0)) + own;
            (1..=followers).map(|k| widened(&start(list, k)) - &leader).collect()
        };
        let first = Followers {
            positions: relative(&Start::Positions, &amplitude),
            velocities: relative(&Start::Velocities, &number(&zero)),
        };
        let start = Motion::of(graph, &exact, &first, (&amplitude, &w))?;
        let gains = gains.map(point);
        let swing = (amplitude * number(&(&swing.1 * &swing.1)), w);
        Some(ModalPlatoon { start, graph: graph.clone(), gains, swing })
    }

    /// Deviations from the leader and their rates at all times of a piece, the leader first, and a swing of zero: by the mean value theorem from those at
    /// its middle.
    pub fn states(&self, from: &Rational, to: &Rational) -> Result<IntervalVector, Failure> {
        self.enclosed(from, to).map_err(|error| Failure::open(format!("the modes cannot be summed: {error}"), None))
    }

    fn enclosed(&self, from: &Rational, to: &Rational) -> Result<IntervalVector, ArithmeticError> {
        let number = |q: &Rational| Interval::from_rational(q, BITS);
        let at = |t: &Interval| -> Result<[IntervalVector; 2], ArithmeticError> {
            let found = self.start.deviations(t)?;
            Ok([found.positions, found.velocities].map(|list| list.iter().map(narrowed).collect()))
        };
        let middle = (from + to) * rational(1, 2);
        let [places, speeds] = at(&number(&middle))?;
        let still = FloatInterval::point(0.0);
        let listed = |places: IntervalVector, speeds: IntervalVector| {
            let cars = std::iter::once(still).chain(places);
            cars.chain(std::iter::once(still)).chain(speeds).chain([still, still]).collect()
        };
        if from == to {
            return Ok(listed(places, speeds));
        }
        let time = Interval::hull_of_rationals(from, to, BITS);
        let [wide_places, wide_speeds] = at(&time)?;
        let forces = self.graph.accelerations(&self.gains, (&still, &still), &wide_places, &wide_speeds);
        // In the frame of the leader, whose own acceleration is -A w² cos wt.
        let shift = narrowed(&((self.swing.1.clone() * &time).cos()? * &self.swing.0));
        let after = narrowed(&(time - number(&middle)));
        let moved = |own: &FloatInterval, rate: FloatInterval, wide: &FloatInterval| {
            let near = *own + rate * after;
            near.intersection(wide).unwrap_or(near)
        };
        let rates: IntervalVector =
            speeds.iter().zip(forces).zip(&wide_speeds).map(|((v, a), wide)| moved(v, a + shift, wide)).collect();
        let found = places.iter().zip(&rates).zip(&wide_places).map(|((x, v), wide)| moved(x, *v, wide)).collect();
        Ok(listed(found, rates))
    }
}
