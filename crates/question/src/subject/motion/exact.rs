//! What is known of a motion exactly: its start; all of it where nothing moves relative to anything else; what its law conserves.

use super::MotionSubject;
use super::numbers::Start;
use crate::number::Number;
use crate::subject::measured::measured;
use crate::timeline::Measured;
use arithmetic::{Complex, Interval, PreciseNumber, Rational, rational};
use expressions::Variable;
use models::double_integrator::{Coordinates, Pair, Potential, linked_within, potential_gradients};
use models::oscillator::{Neighbours, Orientation, Spacing, Steering};
use num_traits::Zero;
use scenario::{Amount, ExactMotion, Law, Links, Model, Rows, Sensing, View, measure};
use std::borrow::Cow;

/// How much of the start still holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Holds {
    /// It is time 0, or the motion is at rest but for one common motion.
    All,
    /// What is conserved.
    Conserved,
}

impl MotionSubject<'_> {
    /// Whether all agents move alike for ever: equal velocities and no forces at the start, so that neither velocities nor differences of
    /// positions ever change.
    pub(super) fn is_at_rest(&self) -> bool {
        if !self.wide.is_empty() {
            return false;
        }
        match &self.motion {
            ExactMotion::Velocities { positions, velocities, potential, pairs, radius, headings: None } => {
                let places: Vec<[Rational; 2]> = positions.iter().map(|row| vector(row)).collect();
                let linked = radius
                    .as_ref()
                    .map(|radius| linked_within(&places, &(radius * radius), Coordinates::Cartesian).edges());
                are_equal(velocities) && is_without_force(&places, potential, linked.as_ref().unwrap_or(pairs))
            }
            ExactMotion::Phases { phases, .. } => are_equal(phases),
            ExactMotion::Platoon { rates, platoon, swing, .. } => {
                let deviations = self.deviations();
                let still = (swing.0.is_zero() || swing.1.is_zero()) && are_equal(rates);
                still
                    && deviations.split_first().zip(rates.split_first()).is_some_and(|((y0, y), (u0, u))| {
                        platoon.accelerations((y0, u0), y, u).iter().all(Zero::is_zero)
                    })
            }
            _ => false,
        }
    }

    /// A quantity that is known exactly; of a list the entry with that index.
    pub(super) fn exact(&self, name: &str, index: usize, holds: Holds, precision: u32) -> Option<Number> {
        if name == "momentum" {
            return self.momentum(index, holds);
        }
        if holds != Holds::All || !self.wide.is_empty() {
            return None;
        }
        self.views(index).iter().find_map(|view| match measure(name, view).ok()?? {
            // Counts are as good between enclosures.
            Amount::Count(_) => None,
            amount => match measured(amount, index, precision).ok()? {
                Measured::Number(number) => Some(number),
                Measured::Truth(_) => None,
            },
        })
    }

    /// A number of a law of one's own at a single start, from the rational numbers of the start.
    pub(super) fn own_at_start(&self, name: &str, holds: Holds, precision: u32) -> Option<Number> {
        let ExactMotion::Own(own) = &self.motion else { return None };
        if holds != Holds::All || !self.wide.is_empty() {
            return None;
        }
        let start: Vec<PreciseNumber> = own.start.iter().map(|x| PreciseNumber::exact(x.clone(), precision)).collect();
        Some(own.at_start()?.number(name, &start)?.ok()?.number)
    }

    /// What of the start is rational.
    fn views(&self, orders: usize) -> Vec<View<'_, Rational>> {
        let none = || Links::Everyone(0);
        let places = |model: Model, list: &'_ [Vec<Rational>]| {
            let list = list.to_vec();
            View { positions: Rows::of(list.len(), move || list), ..View::new(model, none()) }
        };
        match &self.motion {
            ExactMotion::Velocities { positions, velocities, headings, .. } => {
                let model = if headings.is_some() { Model::Headings } else { Model::Velocities };
                let velocities = Rows::of(velocities.len(), || velocities.clone());
                vec![View { velocities, ..places(model, positions) }]
            }
            ExactMotion::Phases { phases, gain, network, .. } => alike(phases, gain, network, orders),
            ExactMotion::Particles { positions, phases, gain, network, .. } => {
                let mut all = vec![places(Model::Particles, positions)];
                all.extend(alike(phases, gain, network, orders));
                all
            }
            ExactMotion::Platoon { rates, spacing, .. } => {
                let deviations = self.deviations();
                let place = |(y, k): (&Rational, i64)| y - spacing * rational(k, 1);
                let places = places(Model::Platoon, &rows(deviations.iter().zip(0..).map(place).collect()));
                let velocities = Rows::of(rates.len(), || rows(rates.clone()));
                let law = Law::Cars { deviations, leader: 0, spacing: spacing.clone() };
                vec![View { velocities, law, ..places }]
            }
            ExactMotion::Own(own) => {
                let rows = |part: Option<&Variable>| {
                    let rows = part.map_or_else(Vec::new, |part| own.rows(part));
                    Rows::of(rows.len(), || rows)
                };
                let (positions, velocities) = (rows(own.position()), rows(own.velocity()));
                vec![View { positions, velocities, ..View::new(Model::Own, own.links()) }]
            }
            ExactMotion::Other(_) => Vec::new(),
        }
    }

    /// Velocity alignment conserves the sum of the velocities, link by link: what one agent of a link gains the other one loses, whether links switch or not.
    fn momentum(&self, index: usize, holds: Holds) -> Option<Number> {
        let axis = index.checked_sub(1)?;
        let ExactMotion::Velocities { velocities, headings, .. } = &self.motion else { return None };
        if headings.is_some() && holds != Holds::All {
            return None;
        }
        let (mut lo, mut hi) = (rational(0, 1), rational(0, 1));
        for (agent, row) in velocities.iter().enumerate() {
            let own = self.wide.iter().find(|(list, a, c, ..)| (list, *a, *c) == (&Start::Velocities, agent, axis));
            let (least, most) = own.map_or((&row[axis], &row[axis]), |(.., lo, hi)| (lo, hi));
            lo += least;
            hi += most;
        }
        Some(match lo == hi {
            true => Number::Exact(lo),
            false => Number::interval(Interval::hull_of_rationals(&lo, &hi, super::numbers::BITS)),
        })
    }

    /// Deviations of the cars of a platoon at time 0, that of the leader with its swing.
    fn deviations(&self) -> Vec<Rational> {
        let ExactMotion::Platoon { deviations, swing, .. } = &self.motion else { return Vec::new() };
        let mut all = deviations.clone();
        if let Some(first) = all.first_mut() {
            *first += &swing.0;
        }
        all
    }
}

/// Phases that are all equal, turned to 0: what is measured on phases alone does not change with that.
fn alike<'a>(phases: &[Rational], gain: &Rational, network: &'a Neighbours, orders: usize) -> Vec<View<'a, Rational>> {
    if !are_equal(phases) {
        return Vec::new();
    }
    let zero = rational(0, 1);
    let phasors = vec![Complex { re: rational(1, 1), im: zero.clone() }; phases.len()];
    let steering =
        Steering { frequency: zero, orientation: Orientation::Laplacian(gain.clone()), spacing: Spacing::None };
    vec![View {
        phasors,
        orders: orders as u32,
        sensing: Sensing::These(Cow::Borrowed(network)),
        law: Law::Turning(steering, None),
        ..View::new(Model::Phase, Links::Everyone(0))
    }]
}

fn is_without_force(places: &[[Rational; 2]], potential: &Potential, pairs: &[Pair]) -> bool {
    let slope = potential.slope_over(&rational(0, 1));
    let forces = potential_gradients(places, pairs, Coordinates::Cartesian, |_, _, s| slope.at(s));
    forces.is_ok_and(|forces| forces.iter().flatten().all(Zero::is_zero))
}

fn are_equal<T: PartialEq>(list: &[T]) -> bool {
    list.windows(2).all(|pair| pair[0] == pair[1])
}

fn vector(row: &[Rational]) -> [Rational; 2] {
    [0, 1].map(|k| row.get(k).cloned().unwrap_or_default())
}

fn rows(list: Vec<Rational>) -> Vec<Vec<Rational>> {
    list.into_iter().map(|x| vec![x]).collect()
}
