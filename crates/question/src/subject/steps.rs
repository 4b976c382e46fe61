//! Laws of one's own in discrete time on rational numbers: states one by one, for ever where a state comes to rest.

use crate::failure::Failure;
use crate::names::Quantity;
use crate::number::Number;
use crate::subject::measured::measured;
use crate::timeline::{Covered, Measured, Moment, Piece, Steps};
use crate::truth::Doubt;
use arithmetic::{Progress, Rational};
use expressions::Asked;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use scenario::{Links, Model, OwnSteps, Rows, View};
use std::cell::RefCell;

/// Most steps that are taken.
const MOST_STEPS: usize = 1000;

/// States whose numbers have more bits together are not followed further.
const MOST_BITS: u64 = 1 << 24;

/// A flock of a case, followed as far as it was needed.
pub(crate) struct StepsSubject<'c> {
    followed: RefCell<Followed>,
    /// Whether the law has observables.
    observes: bool,
    progress: &'c dyn Progress,
}

struct Followed {
    flock: OwnSteps,
    states: Vec<State>,
    /// The first time from which on nothing changes.
    rest: Option<usize>,
}

#[derive(Clone)]
struct State {
    positions: Vec<Vec<Rational>>,
    velocities: Vec<Vec<Rational>>,
    links: (usize, Vec<(usize, usize)>),
    numbers: Vec<Rational>,
    /// Those of the observables, where there are some.
    observed: Option<Result<Vec<Number>, String>>,
}

impl State {
    fn of(flock: &OwnSteps, observes: bool) -> Self {
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
            observed: observes.then(|| flock.observed().map_err(|fault| fault.to_string())),
        }
    }
}

fn too_far() -> String {
    format!("the flock is followed step by step up to t = {MOST_STEPS}, and does not come to rest before")
}

impl<'c> StepsSubject<'c> {
    pub fn new(flock: OwnSteps, progress: &'c dyn Progress) -> Self {
        let observes = !flock.law().observables().is_empty();
        let states = vec![State::of(&flock, observes)];
        StepsSubject { followed: RefCell::new(Followed { flock, states, rest: None }), observes, progress }
    }

    /// The state at a time, or where it rests before.
    fn state(&self, time: usize) -> Result<State, Failure> {
        let mut followed = self.followed.borrow_mut();
        let Followed { flock, states, rest } = &mut *followed;
        while states.len() <= time && rest.is_none() {
            self.progress.checkpoint()?;
            let before = flock.state().to_vec();
            if before.iter().map(|q| q.numer().bits() + q.denom().bits()).sum::<u64>() > MOST_BITS {
                let why = format!("the numbers grow beyond all use after t = {}", states.len() - 1);
                return Err(Failure::open(why, None));
            }
            flock.step().map_err(|error| Failure::open(error.to_string(), None))?;
            if flock.state() == before && flock.is_autonomous() {
                *rest = Some(states.len() - 1);
            } else {
                states.push(State::of(flock, self.observes));
            }
        }
        let place = rest.map_or(time, |rest| rest.min(time));
        states.get(place).cloned().ok_or_else(|| Failure::open(too_far(), None))
    }

    /// The time of rest, where there is one up to a time.
    fn rest(&self, until: usize) -> Result<Option<usize>, Failure> {
        self.state(until)?;
        Ok(self.followed.borrow().rest)
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
        Ok(Covered { pieces, rest: is_cut.then(|| Doubt { why: too_far(), bits: None }) })
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
    fn state(&self) -> Result<State, Failure> {
        // All times from one beyond the last step on are one stretch: it is known only where nothing changes any more.
        let time = self.time.to_usize().filter(|time| *time <= MOST_STEPS);
        if time.is_none() && self.flock.rest(MOST_STEPS)?.is_none() {
            return Err(Failure::open(too_far(), None));
        }
        self.flock.state(time.unwrap_or(MOST_STEPS))
    }
}

impl Moment for At<'_, '_> {
    fn measure(&self, quantity: &Quantity, _: &[Number], precision: u32) -> Result<Measured, Failure> {
        let State { positions, velocities, links: (order, links), .. } = self.state()?;
        let view = View {
            positions: Rows::of(positions.len(), || positions),
            velocities: Rows::of(velocities.len(), || velocities),
            ..View::new(Model::Own, Links::These(order, links.into()))
        };
        let found = scenario::measure(quantity.name, &view).ok().flatten();
        let none = || Failure::open(format!("`{}` has no value in this state", quantity.name), None);
        measured(found.ok_or_else(none)?, 1, precision)
    }

    fn own(&self, name: &str, _: u32) -> Result<Measured, Failure> {
        let state = self.state()?;
        let followed = self.flock.followed.borrow();
        let law = followed.flock.law();
        let is_past_rest = followed.rest.is_some_and(|rest| self.time > BigInt::from(rest));
        let number = match law.number(name) {
            Some(Asked::Observed(_)) if law.observes_time() && is_past_rest => {
                return Err(Failure::open(format!("`{name}` depends on the time"), None));
            }
            Some(Asked::State(place)) => state.numbers.get(place).cloned().map(Number::Exact),
            Some(Asked::Observed(place)) => match state.observed {
                Some(Ok(all)) => all.get(place).cloned(),
                Some(Err(why)) => return Err(Failure::open(why, None)),
                None => None,
            },
            None => None,
        };
        Ok(Measured::Number(number.ok_or_else(|| Failure::open("there is no such number", None))?))
    }
}
