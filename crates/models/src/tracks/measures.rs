//! What is measured in one frame: distances, zones, order, momentum, potentials.

use super::potential::{complete_potential, mean, partner_potential};
use super::{Choices, Scale, Vector};
use crate::oscillator::{Neighbours, State, Zone, moment, phase_potential, quarter_turn};
use arithmetic::{ArithmeticError, Complex};

/// Whether a fish senses another one in the zones of repulsion, orientation and attraction.
pub type ZonePresence = [bool; 3];

/// What needs the headings of a group: all fish, or as many as are asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupState {
    /// The fish with a heading, by number.
    pub members: Vec<usize>,
    /// `|p_1|` and `|p_2|` of (23); the latter is at most 1/2.
    pub order: [f64; 2],
    /// Modulus of the mean velocity.
    pub momentum: f64,
    /// Mean of `<i e_k, z_k>` with `e_k` the unit vector from the centre of mass to fish `k`: 1 where all circle to the left.
    pub rotation: f64,
    /// The neighbour of each member for `n = 1`, as a place among the members.
    pub partners: Vec<usize>,
    /// `W_1` for `n = 1`.
    pub single: f64,
    /// `W_1` for `n = N - 1`, where `N` is the number of members.
    pub complete: f64,
    /// `W_1` for each of the other `n` that are asked for.
    pub others: Vec<f64>,
    /// `W_1` on the network of the zones of orientation.
    pub orientation: f64,
    /// Arcs of that network.
    pub orientation_arcs: usize,
}

impl GroupState {
    /// `W_1` for `n = 1`, scaled.
    pub fn single(&self, scale: Scale) -> f64 {
        scale.factor(1) * self.single
    }

    /// `W_1` for `n = N - 1`, scaled.
    pub fn complete(&self, scale: Scale) -> f64 {
        scale.factor(self.members.len().saturating_sub(1)) * self.complete
    }

    /// The second less the first.
    pub fn difference(&self, scale: Scale) -> f64 {
        scale.difference(self.members.len(), self.complete, self.single)
    }
}

/// What is measured in one frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameMeasures {
    /// Time in seconds.
    pub time: f64,
    /// Fish with a position.
    pub seen: usize,
    /// Fish with a velocity.
    pub moving: usize,
    /// Fish with a heading.
    pub headed: usize,
    /// Distance to the nearest neighbour, of each fish; `None` where it is missing, or too many others are.
    pub distances: Vec<Option<f64>>,
    /// Zones of each fish; `None` where it has no heading, or too many fish are missing.
    pub zones: Vec<Option<ZonePresence>>,
    /// What needs the headings of a group.
    pub group: Option<GroupState>,
}

/// The neighbour of `k` for `n = 1`: the nearest, or the second nearest where the nearest is within `too_near`. Of two at the same
/// distance the one with the smaller number; `k` itself where there is no other.
pub fn nearest_neighbour(positions: &[Vector], k: usize, too_near: Option<f64>) -> usize {
    let Some(own) = positions.get(k) else { return k };
    let mut best = [(f64::INFINITY, k); 2];
    for (j, r) in positions.iter().enumerate().filter(|&(j, _)| j != k) {
        let distance = (r.clone() - own).norm_squared();
        if distance < best[0].0 {
            best = [(distance, j), best[0]];
        } else if distance < best[1].0 {
            best[1] = (distance, j);
        }
    }
    let passed_over = too_near.is_some_and(|radius| best[0].0 <= radius * radius) && best[1].0.is_finite();
    best[usize::from(passed_over)].1
}

/// The neighbours of all fish for `n = 1`.
pub(super) fn partners(positions: &[Vector], too_near: Option<f64>) -> Vec<usize> {
    (0..positions.len()).map(|k| nearest_neighbour(positions, k, too_near)).collect()
}

/// Positions, velocities and headings of one frame, one entry for each fish.
pub(super) struct Moment<'a> {
    pub time: f64,
    pub positions: Vec<Option<&'a Vector>>,
    pub velocities: Vec<Option<&'a Vector>>,
    pub headings: Vec<Option<&'a Vector>>,
}

impl FrameMeasures {
    /// The mean distance to the nearest neighbour, over the fish that have one.
    pub fn mean_distance(&self) -> Option<f64> {
        let distances: Vec<f64> = self.distances.iter().flatten().copied().collect();
        (!distances.is_empty()).then(|| distances.iter().sum::<f64>() / distances.len() as f64)
    }

    pub(super) fn new(frame: &Moment, choices: &Choices) -> Result<FrameMeasures, ArithmeticError> {
        let count = |of: &[Option<&Vector>]| of.iter().flatten().count();
        let mut measures = FrameMeasures {
            time: frame.time,
            seen: count(&frame.positions),
            moving: count(&frame.velocities),
            headed: count(&frame.headings),
            distances: vec![None; frame.positions.len()],
            zones: vec![None; frame.positions.len()],
            group: None,
        };
        let least = choices.least_fish(frame.positions.len());
        if measures.seen < least {
            return Ok(measures);
        }
        let there = frame.positions.iter().enumerate();
        let (numbers, positions): (Vec<usize>, Vec<Vector>) =
            there.filter_map(|(k, r)| Some((k, (*r)?.clone()))).unzip();
        let zones = choices.zones();
        for (place, &k) in numbers.iter().enumerate() {
            let j = nearest_neighbour(&positions, place, None);
            measures.distances[k] =
                (j != place).then(|| (positions[j].clone() - &positions[place]).norm_squared().sqrt());
            let Some(heading) = frame.headings[k] else { continue };
            let senses = |zone: Zone| {
                let others = positions.iter().enumerate().filter(|&(j, _)| j != place);
                others.into_iter().any(|(_, r)| zones.senses(zone, heading, &(r.clone() - &positions[place])))
            };
            measures.zones[k] = Some([Zone::Repulsion, Zone::Orientation, Zone::Attraction].map(senses));
        }
        let members: Vec<usize> = numbers.into_iter().filter(|&k| frame.headings[k].is_some()).collect();
        if members.len() >= least {
            let of = |x: &[Option<&Vector>]| members.iter().filter_map(|&k| x[k].cloned()).collect::<Vec<Vector>>();
            let (positions, headings) = (of(&frame.positions), of(&frame.headings));
            let velocities = of(&frame.velocities);
            measures.group = Some(group(members, positions, headings, &velocities, choices)?);
        }
        Ok(measures)
    }
}

fn group(
    members: Vec<usize>,
    positions: Vec<Vector>,
    headings: Vec<Vector>,
    velocities: &[Vector],
    choices: &Choices,
) -> Result<GroupState, ArithmeticError> {
    let modulus = |x: &Vector| x.norm_squared().sqrt();
    let partners = partners(&positions, choices.too_near());
    let state = State { positions, phasors: headings };
    let network = choices.zones().network(Zone::Orientation, &state);
    let (positions, headings) = (&state.positions, &state.phasors);
    let others = choices.nearest.iter().map(|&n| phase_potential(&Neighbours::nearest(positions, n), headings, 1));
    Ok(GroupState {
        members,
        order: [modulus(&moment(headings, 1)?), modulus(&moment(headings, 2)?)],
        momentum: modulus(&mean(velocities)),
        rotation: rotation(positions, headings),
        single: partner_potential(&partners, headings),
        partners,
        complete: complete_potential(headings),
        others: others.collect::<Result<_, _>>()?,
        orientation: phase_potential(&network, headings, 1)?,
        orientation_arcs: (0..network.particles()).map(|k| network.of_particle(k).len()).sum(),
    })
}

/// The mean of `<i e_k, z_k>`; a fish at the centre of mass counts as 0.
pub(super) fn rotation(positions: &[Vector], headings: &[Vector]) -> f64 {
    let centre = mean(positions);
    let turn = |(r, z): (&Vector, &Vector)| {
        let arm: Complex<f64> = r.clone() - &centre;
        let length = arm.norm_squared().sqrt();
        if length > 0.0 { quarter_turn(&arm).dot(z) / length } else { 0.0 }
    };
    positions.iter().zip(headings).map(turn).sum::<f64>() / positions.len() as f64
}
