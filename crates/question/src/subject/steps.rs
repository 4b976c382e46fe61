//! Laws of one's own in discrete time: states one by one, exact where they are rational and enclosed elsewhere, for ever where an exact state comes to rest.

use crate::failure::Failure;
use crate::names::Quantity;
use crate::number::Number;
use crate::subject::measured::measured;
use crate::timeline::{Covered, Measured, Moment, Piece, Steps};
use crate::truth::Doubt;
use arithmetic::{Dyadic, Progress, Rational};
use expressions::Asked;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use scenario::{AffineNumber, Links, Model, OwnFlock, OwnSteps, Rows, RunError, View};
use std::cell::RefCell;

/// Most steps that are taken.
const MOST_STEPS: usize = 1000;

/// States whose exact numbers have more bits together are enclosed from there on.
const MOST_BITS: u64 = 1 << 24;

/// Bits of enclosures at first, and the most.
const BITS: [u32; 2] = [256, 4096];

/// A flock of a case, followed as far as it was needed.
pub(crate) struct StepsSubject<'c> {
    flock: OwnFlock,
    followed: RefCell<Option<Followed>>,
    progress: &'c dyn Progress,
}

/// States that were reached, with enclosures of so many bits.
struct Followed {
    bits: u32,
    flock: OwnSteps,
    states: Vec<State>,
    /// The first time from which on nothing changes.
    rest: Option<usize>,
}

#[derive(Clone)]
struct State {
    positions: Vec<Vec<AffineNumber>>,
    velocities: Vec<Vec<AffineNumber>>,
    links: (usize, Vec<(usize, usize)>),
    numbers: Vec<AffineNumber>,
    /// Those of the observables, or why one has no value.
    observed: Vec<Result<Number, String>>,
}

impl State {
    fn of(flock: &OwnSteps) -> Self {
        let links = match flock.links() {
            Links::These(order, links) => (order, links.into_owned()),
            Links::Everyone(order) | Links::Between(order, _) => {
                (order, (0..order).flat_map(|i| (i + 1..order).map(move |j| (i, j))).collect())
            }
        };
        State {
            positions: flock.positions(),
            velocities: flock.velocities(),
            links,
            numbers: flock.state().to_vec(),
            observed: flock.observed().into_iter().map(|x| x.map_err(|fault| fault.to_string())).collect(),
        }
    }

    fn is_exact(&self) -> bool {
        self.numbers.iter().all(AffineNumber::is_exact)
    }

    /// Whether every number is exact or in an interval narrower than `2^-bits`.
    fn is_within(&self, bits: u32) -> bool {
        let least = Dyadic::new(1.into(), -i64::from(bits));
        let narrow = |x: &Number| matches!(x, Number::Exact(_)) || x.enclosure(bits).width() <= least;
        let observed = |x: &Result<Number, String>| x.as_ref().map_or_else(|_| self.is_exact(), narrow);
        self.observed.iter().all(observed) && self.numbers.iter().all(|x| x.is_exact() || narrow(&x.plain().number))
    }
}

impl Followed {
    fn start(flock: &OwnFlock, bits: u32) -> Result<Self, Failure> {
        let flock = flock.start(bits).map_err(open)?;
        let states = vec![State::of(&flock)];
        Ok(Followed { bits, flock, states, rest: None })
    }

    /// Goes on to a time, or to a rest before.
    fn follow(&mut self, time: usize, progress: &dyn Progress) -> Result<(), Failure> {
        let Followed { flock, states, rest, .. } = self;
        while states.len() <= time && rest.is_none() {
            progress.checkpoint()?;
            flock.enclose_beyond(MOST_BITS);
            let before = flock.state().to_vec();
            // Links that are replaced at the end of the step count from the next one on.
            let is_autonomous = flock.is_autonomous();
            flock.step().map_err(open)?;
            // What is enclosed may change by less than the enclosures tell.
            let stays = |(now, before): (&AffineNumber, &AffineNumber)| now.is_same(before);
            if flock.state().iter().zip(&before).all(stays) && is_autonomous {
                *rest = Some(states.len() - 1);
            } else {
                states.push(State::of(flock));
            }
        }
        Ok(())
    }
}

fn open(error: RunError) -> Failure {
    Failure::open(error.to_string(), None)
}

impl<'c> StepsSubject<'c> {
    pub fn new(flock: OwnFlock, progress: &'c dyn Progress) -> Self {
        StepsSubject { flock, followed: RefCell::new(None), progress }
    }

    /// The state at a time, or where it rests before, enclosed to so many bits where the start allows it. Where enclosures do not decide a step, it
    /// begins anew with twice as many bits.
    fn state(&self, time: usize, precision: u32) -> Result<State, Failure> {
        let mut kept = self.followed.borrow_mut();
        let mut followed = match kept.take() {
            Some(followed) => followed,
            None => Followed::start(&self.flock, BITS[0])?,
        };
        loop {
            let reached = followed.follow(time, self.progress);
            let place = followed.rest.map_or(followed.states.len() - 1, |rest| rest.min(time));
            let last = &followed.states[place.min(time)];
            let is_final = !self.flock.is_exact() || 2 * followed.bits > BITS[1] || last.is_exact();
            if matches!(reached, Err(Failure::Cancelled)) || is_final || reached.is_ok() && last.is_within(precision) {
                let found = reached.map(|()| last.clone());
                *kept = Some(followed);
                return found;
            }
            followed = Followed::start(&self.flock, 2 * followed.bits)?;
        }
    }

    /// Why nothing is known after the last step.
    fn too_far(&self) -> String {
        let followed = self.followed.borrow();
        let last = followed.as_ref().and_then(|followed| followed.states.last());
        let why = match last.is_none_or(State::is_exact) {
            true => "and does not come to rest before",
            false => "and whether it comes to rest before is told of exact states only, which these are not",
        };
        format!("the flock is followed step by step up to t = {MOST_STEPS}, {why}")
    }

    /// The time of rest, where there is one up to a time.
    fn rest(&self, until: usize) -> Result<Option<usize>, Failure> {
        self.state(until, 0)?;
        Ok(self.followed.borrow().as_ref().and_then(|followed| followed.rest))
    }
}

impl Steps for StepsSubject<'_> {
    fn pieces(&self, from: &Rational, to: Option<&Rational>, _: &[&str]) -> Result<Covered, Failure> {
        let integer = |t: usize| Rational::from_integer(t.into());
        let last = to.and_then(|to| to.to_integer().to_usize()).unwrap_or(MOST_STEPS).min(MOST_STEPS);
        let rest = self.rest(last)?;
        let end = rest.unwrap_or(last);
        let first = from.to_integer().to_usize().unwrap_or(usize::MAX);
        let at = |t: usize| Piece { from: integer(t), to: Some(integer(t)) };
        let mut pieces: Vec<Piece> = (first..=end).map(at).collect();
        if rest.is_some() {
            let begin = from.clone().max(integer(end + 1));
            if to.is_none_or(|to| begin <= *to) {
                pieces.push(Piece { from: begin, to: to.cloned() });
            }
            return Ok(Covered { pieces, rest: None });
        }
        let is_cut = to.is_none_or(|to| *to >= integer(MOST_STEPS + 1));
        Ok(Covered { pieces, rest: is_cut.then(|| Doubt { why: self.too_far(), bits: None }) })
    }

    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure> {
        Ok(Box::new(At { flock: self, time: piece.from.to_integer() }))
    }
}

/// A time of a flock, or all times at which it rests.
struct At<'f, 'c> {
    flock: &'f StepsSubject<'c>,
    time: BigInt,
}

impl At<'_, '_> {
    fn state(&self, precision: u32) -> Result<State, Failure> {
        // All times from one beyond the last step on are one stretch: it is known only where nothing changes any more.
        let time = self.time.to_usize().filter(|time| *time <= MOST_STEPS);
        if time.is_none() && self.flock.rest(MOST_STEPS)?.is_none() {
            return Err(Failure::open(self.flock.too_far(), None));
        }
        self.flock.state(time.unwrap_or(MOST_STEPS), precision)
    }
}

impl Moment for At<'_, '_> {
    fn measure(&self, quantity: &Quantity, _: &[Number], precision: u32) -> Result<Measured, Failure> {
        let State { positions, velocities, links: (order, links), .. } = self.state(precision)?;
        let view = View {
            positions: Rows::of(positions.len(), || positions),
            velocities: Rows::of(velocities.len(), || velocities),
            ..View::new(Model::Own, Links::These(order, links.into()))
        };
        let found = scenario::measure(quantity.name, &view).ok().flatten();
        let none = || Failure::open(format!("`{}` has no value in this state", quantity.name), None);
        measured(found.ok_or_else(none)?, 1, precision)
    }

    fn own(&self, name: &str, precision: u32) -> Result<Measured, Failure> {
        let state = self.state(precision)?;
        let law = self.flock.flock.law();
        let rest = self.flock.followed.borrow().as_ref().and_then(|followed| followed.rest);
        let is_past_rest = rest.is_some_and(|rest| self.time > BigInt::from(rest));
        let number = match law.number(name) {
            Some(Asked::Observed(_)) if law.observes_time() && is_past_rest => {
                return Err(Failure::open(format!("`{name}` depends on the time"), None));
            }
            Some(Asked::State(place)) => state.numbers.get(place).map(|x| x.plain().number),
            Some(Asked::Observed(place)) => {
                let number = state.observed.get(place).cloned().transpose();
                number.map_err(|why| Failure::open(why, None))?
            }
            None => None,
        };
        Ok(Measured::Number(number.ok_or_else(|| Failure::open("there is no such number", None))?))
    }
}
