//! What is known of a motion exactly: its start; all of it where nothing moves relative to anything else; what its law conserves.

use super::MotionSubject;
use super::numbers::Start;
use crate::subject::distances::{disagreement, least_distance};
use arithmetic::RealNumber as Number;
use arithmetic::{Complex, Interval, Rational, rational};
use models::double_integrator::{Coordinates, Pair, Potential, kinetic_energy, linked_within, potential_gradients};
use models::oscillator::phase_potential;
use models::platoon::Gains;
use num_traits::{Signed, Zero};
use scenario::ExactMotion;

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
            ExactMotion::Platoon { rates, gains, graph, swing, .. } => {
                let deviations = self.deviations();
                let still = (swing.0.is_zero() || swing.1.is_zero()) && are_equal(rates);
                let gains = Gains { f: gains.0.clone(), g: gains.1.clone() };
                still
                    && deviations.split_first().zip(rates.split_first()).is_some_and(|((y0, y), (u0, u))| {
                        graph.accelerations(&gains, (y0, u0), y, u).iter().all(Zero::is_zero)
                    })
            }
            _ => false,
        }
    }

    /// A quantity that is known exactly.
    pub(super) fn exact(&self, name: &str, arguments: &[Number], holds: Holds, precision: u32) -> Option<Number> {
        if name == "momentum" {
            return self.momentum(arguments, holds);
        }
        if holds != Holds::All || !self.wide.is_empty() {
            return None;
        }
        match (&self.motion, name) {
            (ExactMotion::Velocities { positions, .. } | ExactMotion::Particles { positions, .. }, "min_distance") => {
                least_distance(positions, precision)?.ok()
            }
            (ExactMotion::Velocities { velocities, .. }, "disagreement") => disagreement(velocities, precision).ok(),
            (ExactMotion::Velocities { velocities, .. }, "kinetic") => {
                let velocities: Vec<[Rational; 2]> = velocities.iter().map(|row| vector(row)).collect();
                kinetic_energy(&velocities, Coordinates::Cartesian).ok().map(Number::Exact)
            }
            (ExactMotion::Platoon { rates, .. }, "disagreement") => disagreement(&rows(rates.clone()), precision).ok(),
            (ExactMotion::Platoon { spacing, .. }, _) => self.of_platoon(name, spacing, precision),
            (ExactMotion::Phases { phases, gain, network, .. }, _)
            | (ExactMotion::Particles { phases, gain, network, .. }, _)
                if are_equal(phases) =>
            {
                let alike = vec![Complex { re: rational(1, 1), im: rational(0, 1) }; phases.len()];
                match name {
                    "order" => {
                        let order = arguments.first().map_or(Some(1.into()), Number::as_integer)?;
                        (order.is_positive() && order <= 64.into())
                            .then(|| Number::Exact(Rational::new(1.into(), order)))
                    }
                    "phase_potential" => phase_potential(network, &alike, 1).ok().map(Number::Exact),
                    "orientation_potential" => {
                        phase_potential(network, &alike, 1).ok().map(|own| Number::Exact(-(own * gain)))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Velocity alignment conserves the sum of the velocities, link by link: what one agent of a link gains the other one loses, whether links switch or not.
    fn momentum(&self, arguments: &[Number], holds: Holds) -> Option<Number> {
        let axis = match arguments.first()?.as_integer()?.try_into() {
            Ok(1) => 0,
            Ok(2) => 1,
            _ => return None,
        };
        let ExactMotion::Velocities { velocities, headings, .. } = &self.motion else { return None };
        if headings.is_some() && holds != Holds::All {
            return None;
        }
        let (mut lo, mut hi) = (rational(0, 1), rational(0, 1));
        for (agent, row) in velocities.iter().enumerate() {
            let own = self.wide.iter().find(|(list, a, c, ..)| (*list, *a, *c) == (Start::Velocities, agent, axis));
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

    fn of_platoon(&self, name: &str, spacing: &Rational, precision: u32) -> Option<Number> {
        let deviations = self.deviations();
        let (leader, followers) = deviations.split_first()?;
        let gaps = || deviations.windows(2).map(|pair| &pair[0] - &pair[1] + spacing);
        match name {
            "min_gap" => gaps().min().map(Number::Exact),
            "max_gap" => gaps().max().map(Number::Exact),
            "last_deviation" => followers.last().map(|y| Number::Exact(y - leader)),
            "largest_deviation" => followers.iter().map(|y| (y - leader).abs()).max().map(Number::Exact),
            "min_distance" => {
                let places = deviations.iter().zip(0..).map(|(y, k)| y - spacing * rational(k, 1));
                least_distance(&rows(places.collect()), precision)?.ok()
            }
            _ => None,
        }
    }
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
