//! Averaging flocks (Chazelle's model D): exact, with the whole future of the network decided where that is possible.

use crate::error::Problem;
use crate::failure::Failure;
use crate::names::Quantity;
use crate::number::Number;
use crate::subject::measured::measured;
use crate::timeline::{Covered, Measured, Moment, Piece, Repeats, Steps};
use crate::truth::Doubt;
use algebra::graph::Graph;
use arithmetic::{Progress, Rational, rational};
use models::averaging::settle::{Ending, Limits, Settlement, settle};
use models::averaging::{Flock, Start};
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use scenario::{Links, Model, Rows, View};
use std::cell::{OnceCell, RefCell};

/// A flock of a case.
pub(crate) struct FlockSubject<'c> {
    start: Start,
    progress: &'c dyn Progress,
    future: OnceCell<Result<Future, Failure>>,
    rests: OnceCell<Result<Option<usize>, Failure>>,
    stepped: RefCell<Option<Stepped>>,
}

/// The networks with the times from which they are in force, and what becomes of the last.
struct Future {
    networks: Vec<(BigInt, Graph)>,
    settlement: Settlement,
}

impl Future {
    /// From when on the networks repeat, if they do for ever: those of the last period before the last switch are known.
    fn repeats(&self) -> Option<Repeats> {
        let Ending::Alternating { period } = self.settlement.ending else { return None };
        let period = BigInt::from(period);
        Some(Repeats { from: &self.settlement.last_switch + 1 - &period, period })
    }

    /// The network at a time, where it is known.
    fn network(&self, time: &BigInt) -> Option<&Graph> {
        let last = &self.settlement.last_switch;
        let time = match self.repeats() {
            Some(repeats) => time - repeats.whole_periods(time, &repeats.from),
            None => time.clone(),
        };
        let is_known = time <= *last || matches!(self.settlement.ending, Ending::Steady);
        self.networks.iter().rev().find(|(begin, _)| *begin <= time).map(|(_, network)| network).filter(|_| is_known)
    }
}

/// States at the times 0, 1, .., as far as they were needed.
struct Stepped {
    flock: Flock,
    states: Vec<State>,
}

#[derive(Clone)]
struct State {
    positions: Vec<Vec<Rational>>,
    velocities: Vec<Vec<Rational>>,
    network: Graph,
}

/// Most steps that are taken one by one.
const MOST_STEPS: i64 = 1000;

/// Times before this are stepped to without a look at the whole future.
const EARLY: i64 = 64;

fn too_far() -> String {
    format!("the state is followed step by step up to t = {MOST_STEPS}; only the network is known beyond")
}

/// Quantities of the network alone.
const OF_NETWORK: [&str; 2] = ["components", "links"];

impl<'c> FlockSubject<'c> {
    pub fn new(start: Start, progress: &'c dyn Progress) -> Self {
        FlockSubject { start, progress, future: OnceCell::new(), rests: OnceCell::new(), stepped: RefCell::new(None) }
    }

    fn flock(&self) -> Result<Flock, Failure> {
        Flock::new(&self.start).map_err(|error| Failure::Refused(0, Problem::Other(error.to_string())))
    }

    fn future(&self) -> Result<&Future, Failure> {
        let found = self.future.get_or_init(|| {
            let flock = self.flock()?;
            let mut networks = vec![(BigInt::ZERO, flock.network().clone())];
            let mut seen = |switch: &models::averaging::Switch| {
                if let Some((_, last)) = networks.last() {
                    let next = switch.applied_to(last);
                    networks.push((switch.time.clone(), next));
                }
            };
            let settled = settle(flock, &Limits::default(), &mut seen, self.progress);
            let settlement = settled.map_err(|error| Failure::open(error.to_string(), None))?;
            if matches!(settlement.ending, Ending::Interrupted) {
                return Err(Failure::Cancelled);
            }
            Ok(Future { networks, settlement })
        });
        found.as_ref().map_err(Clone::clone)
    }

    /// A quantity of the whole future.
    pub fn measure(&self, name: &str) -> Result<Measured, Failure> {
        let future = self.future()?;
        let number = |n: BigInt| Ok(Measured::Number(Number::Exact(Rational::from_integer(n))));
        match (&future.settlement.ending, name) {
            (Ending::Steady, "steady") => Ok(Measured::Truth(true)),
            (Ending::Alternating { .. }, "steady") => Ok(Measured::Truth(false)),
            (Ending::Steady, "last_switch") => number(future.settlement.last_switch.clone()),
            (Ending::Steady, "switches") => number(BigInt::from(future.networks.len() - 1)),
            (Ending::Steady, _) => number(BigInt::from(future.settlement.network.components().len())),
            (Ending::Alternating { .. }, _) => {
                let why = format!("`{name}` does not exist: the network changes for ever");
                Err(Failure::Refused(0, Problem::Other(why)))
            }
            _ => Err(Failure::open(future.settlement.why.clone(), None)),
        }
    }

    /// What lies beyond the last known network.
    fn beyond(&self, future: &Future) -> Option<Doubt> {
        match future.settlement.ending {
            Ending::Steady => None,
            _ => Some(Doubt {
                why: format!("after t = {}: {}", future.settlement.last_switch, future.settlement.why),
                bits: None,
            }),
        }
    }

    fn state(&self, time: usize) -> Result<State, Failure> {
        let mut stepped = self.stepped.borrow_mut();
        if stepped.is_none() {
            *stepped = Some(Stepped { flock: self.flock()?, states: Vec::new() });
        }
        let Some(Stepped { flock, states }) = stepped.as_mut() else {
            return Err(Failure::open("the flock could not be stepped", None));
        };
        while states.len() <= time {
            self.progress.checkpoint()?;
            if !states.is_empty() {
                flock.step().map_err(|error| Failure::open(error.to_string(), None))?;
            }
            let (positions, velocities) = (flock.positions(), flock.velocities());
            states.push(State { positions, velocities, network: flock.network().clone() });
        }
        Ok(states[time].clone())
    }
}

impl FlockSubject<'_> {
    /// The first early time at which all velocities are equal: averages of equal velocities are these velocities, so that neither they nor the
    /// differences of positions change any more.
    fn rest(&self) -> Result<Option<usize>, Failure> {
        let found = self.rests.get_or_init(|| {
            for time in 0..EARLY as usize {
                let velocities = self.state(time)?.velocities;
                if velocities.windows(2).all(|pair| pair[0] == pair[1]) {
                    return Ok(Some(time));
                }
            }
            Ok(None)
        });
        found.clone()
    }
}

impl Steps for FlockSubject<'_> {
    /// Pieces on which a quantity is constant, as far as it is known.
    fn pieces(&self, from: &Rational, to: Option<&Rational>, moving: &[&str]) -> Result<Covered, Failure> {
        let integer = |q: &BigInt| Rational::from_integer(q.clone());
        if moving.iter().all(|name| OF_NETWORK.contains(name)) && to.is_none_or(|to| *to >= integer(&EARLY.into())) {
            let future = self.future()?;
            let mut pieces = Vec::new();
            for (k, (time, _)) in future.networks.iter().enumerate() {
                let next = future.networks.get(k + 1).map(|(next, _)| integer(next) - rational(1, 1));
                let last = next.is_none();
                let begin = integer(time).max(from.clone());
                let end = match (next, to) {
                    (Some(next), Some(to)) => Some(next.min(to.clone())),
                    (None, Some(to)) => Some(to.clone()),
                    (next, None) => next,
                };
                // Of a network that is not known to stay only its first moment is known.
                let open = last && self.beyond(future).is_some();
                let end = if open { Some(end.map_or(integer(time), |end| end.min(integer(time)))) } else { end };
                if end.as_ref().is_none_or(|end| begin <= *end) {
                    pieces.push(Piece { from: begin, to: end });
                }
            }
            if let Some(to) = to.filter(|_| future.repeats().is_some()) {
                // One by one: their networks are told apart where they are asked for.
                let first = from.to_integer().max(&future.settlement.last_switch + 1);
                let count: BigInt = to.to_integer() - &first + 1;
                let count = count.to_i64().unwrap_or(MOST_STEPS).clamp(0, MOST_STEPS);
                let single = |t: BigInt| Piece { from: integer(&t), to: Some(integer(&t)) };
                pieces.extend((0..count).map(|k| single(&first + k)));
            }
            let known = pieces.last().and_then(|piece| piece.to.clone());
            let reaches = to.is_some_and(|to| known.is_some_and(|known| known >= *to));
            return Ok(Covered { pieces, rest: if reaches { None } else { self.beyond(future) } });
        }
        let first = from.to_integer();
        // Once all velocities are equal nothing changes any more, which is looked for as long as steps are short.
        let is_long = to.is_none_or(|to| *to >= integer(&EARLY.into()));
        let rest = if is_long { self.rest()? } else { None };
        let most = BigInt::from(rest.unwrap_or(MOST_STEPS as usize));
        let last = to.map_or(most.clone(), |to| to.to_integer().min(most.clone()));
        let at = |t: BigInt| Piece { from: integer(&t), to: Some(integer(&t)) };
        let count = (&last - &first).to_i64().map_or(0, |count| count + 1).max(0);
        let mut pieces: Vec<Piece> = (0..count).map(|k| at(&first + k)).collect();
        if rest.is_some() {
            let begin = from.clone().max(integer(&most) + rational(1, 1));
            if to.is_none_or(|to| begin <= *to) {
                pieces.push(Piece { from: begin, to: to.cloned() });
            }
            return Ok(Covered { pieces, rest: None });
        }
        let is_cut = to.is_none_or(|to| to.to_integer() > most);
        let rest = is_cut.then(|| Doubt { why: too_far(), bits: None });
        Ok(Covered { pieces, rest })
    }

    fn repeats(&self, to: Option<&Rational>, moving: &[&str]) -> Result<Option<Repeats>, Failure> {
        let is_early = to.is_some_and(|to| *to < Rational::from_integer(EARLY.into()));
        if is_early || moving.iter().any(|name| !OF_NETWORK.contains(name)) {
            return Ok(None);
        }
        Ok(self.future()?.repeats())
    }

    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure> {
        let time = piece.from.to_integer();
        let is_single = piece.to.as_ref().is_some_and(|to| *to == piece.from);
        Ok(Box::new(At { flock: self, time, is_single }))
    }
}

/// A time of a flock, or all times with the same network.
struct At<'f, 'c> {
    flock: &'f FlockSubject<'c>,
    time: BigInt,
    is_single: bool,
}

impl At<'_, '_> {
    fn network(&self) -> Result<Graph, Failure> {
        let future = self.flock.future()?;
        // Of networks that go on changing only one at a time is known after the last switch that was found.
        let is_asked_singly = self.is_single || self.time <= future.settlement.last_switch;
        match (
            future.network(&self.time).filter(|_| is_asked_singly || future.repeats().is_none()),
            self.flock.beyond(future),
        ) {
            (Some(network), _) => Ok(network.clone()),
            (None, Some(doubt)) => Err(Failure::Open(doubt)),
            (None, None) => Ok(future.settlement.network.clone()),
        }
    }

    fn state(&self) -> Result<State, Failure> {
        if self.time >= BigInt::from(EARLY)
            && let Some(rest) = self.flock.rest()?
        {
            return self.flock.state(rest);
        }
        let time = self.time.to_usize().filter(|t| *t <= MOST_STEPS as usize);
        self.flock.state(time.ok_or_else(|| Failure::open(too_far(), None))?)
    }
}

impl Moment for At<'_, '_> {
    fn measure(&self, quantity: &Quantity, _: &[Number], precision: u32) -> Result<Measured, Failure> {
        // Early networks need no look at the whole future.
        let early = self.time < BigInt::from(EARLY);
        let of_network = OF_NETWORK.contains(&quantity.name) && !early;
        let (positions, velocities, network) = if of_network {
            (Vec::new(), Vec::new(), self.network()?)
        } else {
            let State { positions, velocities, network } = self.state()?;
            (positions, velocities, network)
        };
        let view = View {
            positions: Rows::of(positions.len(), || positions),
            velocities: Rows::of(velocities.len(), || velocities),
            ..View::new(Model::Flock, Links::These(network.order(), network.edges().into()))
        };
        let found = scenario::measure(quantity.name, &view).ok().flatten();
        let none = || Failure::open(format!("`{}` has no value in this state", quantity.name), None);
        measured(found.ok_or_else(none)?, 1, precision)
    }
}
