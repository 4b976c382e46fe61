//! What is measured on the enclosed states of a piece of time.

use super::MotionSubject;
use super::exact::Holds;
use super::laws::phasors_of;
use super::numbers::BITS;
use crate::error::Problem;
use crate::failure::Failure;
use crate::names::Quantity;
use crate::number::Number as Known;
use crate::subject::measured::{Scalar, index_of, measured};
use crate::timeline::{Measured, Moment};
use arithmetic::{Complex, Interval, Number, Rational, Ring, Sign};
use expressions::Variable;
use models::double_integrator::{LinkedAgents, Pair};
use models::oscillator::{Neighbours, Spacing};
use polynomials::Side;
use scenario::{ExactMotion, Law, Links, Measurable, Model, OwnMotion, Rows, Sensing, View, measure};
use std::borrow::Cow;
use std::cmp::Ordering;
use std::rc::Rc;

/// Links that may be there or not, of which all networks are looked at.
const MOST_OPEN: usize = 3;

/// The states at all times of a piece, or at an instant.
pub(super) struct At<'m, 'c, T> {
    pub subject: &'m MotionSubject<'c>,
    pub motion: &'m ExactMotion,
    /// What of the start holds at these times.
    pub holds: Holds,
    pub state: Vec<T>,
    pub pairs: Option<Rc<Vec<Pair>>>,
}

impl<T: Measurable + Number> At<'_, '_, T> {
    /// The square of the distance of two agents, whose places stand in the plane at the beginning of the state, or where a law of one's own has them.
    fn square(&self, i: usize, j: usize) -> T {
        let (width, places) = match self.motion {
            ExactMotion::Own(own) => (own.width(), [i, j].map(|agent| LinkedAgents::place(own.as_ref(), agent))),
            _ => (2, [i, j].map(|agent| 2 * agent)),
        };
        let part = |k: usize| (self.state[places[0] + k].clone() - &self.state[places[1] + k]).square();
        (1..width).fold(part(0), |sum, k| sum + part(k))
    }

    /// The links in force: those that are known, or else those that the distances admit.
    fn links_within(&self, agents: usize, radius: &Rational) -> Links<'_> {
        match &self.pairs {
            Some(pairs) => Links::These(agents, Cow::Borrowed(pairs.as_slice())),
            None => Links::Between(agents, self.possible(agents, radius)),
        }
    }

    /// The pairs that are linked for certain, and those that may be.
    fn possible(&self, agents: usize, radius: &Rational) -> [Vec<Pair>; 2] {
        [
            self.near(agents, radius, |sign| sign == Some(Sign::Negative)),
            self.near(agents, radius, |sign| sign != Some(Sign::Positive)),
        ]
    }

    /// So many numbers of each agent, which begin at `offset`.
    fn rows(&self, agents: usize, width: usize, offset: usize) -> Rows<'_, T> {
        let row = move |agent: usize| self.numbers(offset + width * agent, width);
        Rows::of(agents, move || (0..agents).map(row).collect())
    }

    fn numbers(&self, from: usize, count: usize) -> Vec<T> {
        self.state[from..from + count].to_vec()
    }

    /// The pairs that are or are not linked for certain, by the sign of the squared distance less that of the radius.
    fn near(&self, agents: usize, radius: &Rational, wanted: impl Fn(Option<Sign>) -> bool) -> Vec<Pair> {
        let pairs = (0..agents).flat_map(|j| (0..j).map(move |i| (i, j)));
        let beyond = |i: usize, j: usize| {
            let square = self.square(i, j);
            (square.clone() - square.rational(&radius.square())).sign()
        };
        pairs.filter(|&(i, j)| wanted(beyond(i, j))).collect()
    }

    /// The states as they are measured, with so many moments of phases; nothing of motions that are not enclosed.
    pub fn view(&self, orders: usize) -> Option<View<'_, T>> {
        let (orders, constants) = (orders as u32, self.subject.constants());
        Some(match self.motion {
            ExactMotion::Velocities { positions, potential, pairs, radius, headings, .. } => {
                let agents = positions.len();
                let links = match (&self.pairs, radius) {
                    (Some(pairs), None) => Links::These(agents, Cow::Borrowed(pairs.as_slice())),
                    (None, None) => Links::These(agents, Cow::Borrowed(pairs)),
                    (_, Some(radius)) => self.links_within(agents, radius),
                };
                let model = if headings.is_some() { Model::Headings } else { Model::Velocities };
                View {
                    positions: self.rows(agents, 2, 0),
                    velocities: self.rows(agents, 2, 2 * agents),
                    headings: self.rows(if headings.is_some() { agents } else { 0 }, 1, 4 * agents),
                    law: Law::Agents(potential, radius.as_ref()),
                    ..View::new(model, links)
                }
            }
            ExactMotion::Phases { phases, frequency, gain, network } => View {
                phasors: phasors_of(&self.numbers(0, 2 * phases.len())),
                orders,
                sensing: Sensing::These(Cow::Borrowed(network)),
                law: Law::Turning(constants.steering((frequency, gain, &Spacing::None), &self.state)?, None),
                ..View::new(Model::Phase, arcs(network))
            },
            ExactMotion::Particles { positions, frequency, gain, spacing, drift, network, .. } => {
                let agents = positions.len();
                let phasors = phasors_of(&self.numbers(2 * agents, 2 * agents));
                let velocities = phasors.clone();
                let [x, y] = constants.vector("drift", [&drift[0], &drift[1]], &self.state)?;
                let moved = move |z: &Complex<T>| vec![z.re.clone() + &x, z.im.clone() + &y];
                let steering = constants.steering((frequency, gain, spacing), &self.state)?;
                View {
                    positions: self.rows(agents, 2, 0),
                    velocities: Rows::of(agents, move || velocities.iter().map(moved).collect()),
                    phasors,
                    orders,
                    sensing: Sensing::These(Cow::Borrowed(network)),
                    law: Law::Turning(steering, None),
                    ..View::new(Model::Particles, arcs(network))
                }
            }
            ExactMotion::Platoon { spacing, platoon, swing, .. } => {
                let cars = platoon.followers() + 1;
                let (mut deviations, mut speeds) = (self.numbers(0, cars), self.numbers(cars, cars));
                // The leader with its swing.
                let w = constants.number("leader.frequency", &swing.1, &self.state)?;
                let spacing = constants.number("spacing", spacing, &self.state)?;
                deviations[0] = deviations[0].clone() + &self.state[2 * cars];
                speeds[0] = speeds[0].clone() - self.state[2 * cars + 1].clone() * w;
                let place = |(y, k): (&T, i64)| vec![y.clone() - spacing.clone() * y.integer(k)];
                let places: Vec<Vec<T>> = deviations.iter().zip(0..).map(place).collect();
                View {
                    positions: Rows::of(cars, move || places),
                    velocities: Rows::of(cars, move || speeds.into_iter().map(|u| vec![u]).collect()),
                    law: Law::Cars { deviations, leader: 0, spacing },
                    ..View::new(Model::Platoon, Links::These(cars, platoon.links().into()))
                }
            }
            ExactMotion::Own(own) => {
                let agents = own.agents();
                let rows = |part: Option<&Variable>| {
                    part.map_or_else(Rows::none, |part| self.rows(agents, part.width, part.start))
                };
                let angles = own.angle().map_or_else(Vec::new, |part| self.numbers(part.start, agents));
                let turned = |angle: &T| angle.sin_cos().map(|(sin, cos)| Complex::new(cos, sin));
                View {
                    positions: rows(own.position()),
                    velocities: rows(own.velocity()),
                    phasors: angles.iter().flat_map(turned).collect(),
                    orders,
                    ..View::new(
                        Model::Own,
                        own.radius().map_or_else(|| own.links(), |radius| self.links_within(agents, radius)),
                    )
                }
            }
            ExactMotion::Other(_) => return None,
        })
    }
}

impl<T: Scalar + Measurable + Number> At<'_, '_, T> {
    /// What was measured on polynomials in the start, within what is measured on a box around the states. On a box what cancels
    /// does not cancel, but squares, roots and sums of them are not negative, and of numbers of the start that are given their differences are exact.
    fn within_box(&self, found: Measured, boxed: impl FnOnce(&At<Interval>) -> Option<Measured>) -> Measured {
        let Measured::Number(Known::Enclosed(own, None)) = &found else { return found };
        let boxes = self.state.iter().map(Scalar::boxed).collect::<Option<Vec<Interval>>>();
        let Some(state) = boxes else { return found };
        let state = self.starts().unwrap_or(state);
        let at = At { subject: self.subject, motion: self.motion, holds: self.holds, state, pairs: self.pairs.clone() };
        match boxed(&at) {
            Some(Measured::Number(number)) => {
                let other = number.enclosure(BITS);
                let (lo, hi) = (own.lo().max(other.lo()).clone(), own.hi().min(other.hi()).clone());
                match lo.cmp(&hi) {
                    Ordering::Less => Measured::Number(Known::interval(Interval::between(lo, hi, BITS))),
                    Ordering::Equal => Measured::Number(Known::Exact(lo.to_rational())),
                    _ => found,
                }
            }
            _ => found,
        }
    }

    /// What the numbers of the state range over at time 0, from the rational ends of the start.
    fn starts(&self) -> Option<Vec<Interval>> {
        // With numbers in intervals everything holds at time 0 only.
        if self.holds != Holds::All || self.subject.wide.is_empty() {
            return None;
        }
        let ends = |side: &Side| Some(Interval::hull_of_rationals(side.lo.as_ref()?, side.hi.as_ref()?, BITS));
        let starts: Vec<Interval> = self.subject.starts()?.iter().map(ends).collect::<Option<_>>()?;
        (starts.len() == self.state.len()).then_some(starts)
    }

    /// The networks that may be in force where links depend on the distances; the one there is otherwise.
    fn networks(&self, own: &OwnMotion) -> Result<Vec<Vec<Pair>>, Failure> {
        let Some(radius) = own.radius().filter(|_| self.pairs.is_none()) else {
            return Ok(vec![self.pairs.as_deref().cloned().unwrap_or_default()]);
        };
        let [must, may] = self.possible(own.agents(), radius);
        let open: Vec<Pair> = may.into_iter().filter(|pair| !must.contains(pair)).collect();
        if open.len() > MOST_OPEN {
            return Err(Failure::open(format!("{} links may switch there at once", open.len()), None));
        }
        let with = |choice: usize| {
            let chosen = open.iter().enumerate().filter(|(k, _)| choice >> k & 1 == 1).map(|(_, pair)| *pair);
            must.iter().copied().chain(chosen).collect()
        };
        Ok((0..1usize << open.len()).map(with).collect())
    }

    /// A number of a law of one's own on a network.
    fn own_on(&self, own: &OwnMotion, name: &str) -> Result<Known, Failure> {
        let unmeasured = |error| Failure::open(format!("`{name}` cannot be measured on the enclosure: {error}"), None);
        let found = own.number(name, &self.state).ok_or_else(|| Failure::open("there is no such number", None))?;
        let found = Measured::Number(found.map_err(unmeasured)?.number());
        let found = self.within_box(found, |at| Some(Measured::Number(own.number(name, &at.state)?.ok()?.number())));
        match found {
            Measured::Number(number) => Ok(number),
            Measured::Truth(_) => Err(Failure::open("it is no number", None)),
        }
    }
}

fn arcs(network: &Neighbours) -> Links<'_> {
    Links::These(network.particles(), network.arcs().collect())
}

impl<T: Scalar + Measurable + Number> Moment for At<'_, '_, T> {
    fn measure(&self, quantity: &Quantity, arguments: &[Known], precision: u32) -> Result<Measured, Failure> {
        let index = index_of(quantity, arguments)?;
        if let Some(exact) = self.subject.exact(quantity.name, index, self.holds, precision) {
            return Ok(Measured::Number(exact));
        }
        let not_here = || {
            let why = format!("`{}` is no observable of this model", quantity.name);
            Failure::Refused(0, Problem::Other(why))
        };
        let view = self.view(index).ok_or_else(not_here)?;
        let unmeasured = |error| Failure::open(format!("it cannot be measured on the enclosure: {error}"), None);
        let found = measure(quantity.name, &view).map_err(unmeasured)?;
        let found = measured(found.ok_or_else(not_here)?, index, BITS)?;
        let may_vanish = |own: &Interval| !own.lo().is_positive() && !own.hi().is_negative();
        if !matches!(&found, Measured::Number(Known::Enclosed(own, None)) if may_vanish(own)) {
            return Ok(found);
        }
        Ok(self.within_box(found, |at| {
            let amount = measure(quantity.name, &at.view(index)?).ok()??;
            measured(amount, index, BITS).ok()
        }))
    }

    fn own(&self, name: &str, precision: u32) -> Result<Measured, Failure> {
        let ExactMotion::Own(own) = self.motion else {
            return Err(Failure::open("this motion is not enclosed", None));
        };
        // At time 0 an end that is attained there decides, which enclosures do not.
        if let Some(exact) = self.subject.own_at_start(name, self.holds, precision) {
            return Ok(Measured::Number(exact));
        }
        let mut all: Option<Known> = None;
        for pairs in self.networks(own)? {
            let number = self.own_on(&own.with_links(&pairs), name)?;
            all = Some(match all {
                None => number,
                Some(all) => Known::interval(all.enclosure(BITS).hull(&number.enclosure(BITS))),
            });
        }
        all.map(Measured::Number).ok_or_else(|| Failure::open("there is no network", None))
    }
}
