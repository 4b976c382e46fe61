//! The fish model (26)-(28): zones with a blind spot, and the behaviours of repulsion, alignment and attraction.

use super::moments::quarter_turn;
use super::network::Neighbours;
use super::state::State;
use crate::arithmetic::{Complex, Field, Ring, Signed};

/// Outer radii of the concentric zones and the blind spot, the same for all fish.
#[derive(Debug, Clone, PartialEq)]
pub struct Zones<T> {
    /// Outer radius of the zone of repulsion.
    pub repulsion: T,
    /// Outer radius of the zone of orientation.
    pub orientation: T,
    /// Outer radius of the zone of attraction.
    pub attraction: T,
    /// `cos^2` of half the angular width of the blind spot, which is at most a half turn; 1 for no blind spot.
    pub blind_cosine_squared: T,
}

/// One of the three zones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Zone {
    /// `|r - r_k| <= rho_rep`.
    Repulsion,
    /// `rho_rep <= |r - r_k| <= rho_ori`.
    Orientation,
    /// `rho_ori <= |r - r_k| <= rho_att`.
    Attraction,
}

impl<T: Field + Signed> Zones<T> {
    /// Whether a fish at the origin with this heading senses one at `offset` in the zone. Zones contain both their
    /// boundaries, as printed, and the edge of the blind spot is seen.
    pub fn senses(&self, zone: Zone, heading: &Complex<T>, offset: &Complex<T>) -> bool {
        let distance = offset.norm_squared();
        let (inner, outer) = match zone {
            Zone::Repulsion => (None, &self.repulsion),
            Zone::Orientation => (Some(&self.repulsion), &self.orientation),
            Zone::Attraction => (Some(&self.orientation), &self.attraction),
        };
        let beyond = |radius: &T| (distance.clone() - radius.square()).is_certainly_positive();
        let inside = |radius: &T| (distance.clone() - radius.square()).is_certainly_negative();
        !beyond(outer) && !inner.is_some_and(inside) && !self.is_blind(heading, offset)
    }

    /// Whether the offset lies in the open wedge around the direction opposite to the heading.
    pub fn is_blind(&self, heading: &Complex<T>, offset: &Complex<T>) -> bool {
        let behind = -heading.dot(offset);
        let edge = offset.norm_squared() * &self.blind_cosine_squared;
        behind.is_certainly_positive() && (behind.square() - edge).is_certainly_positive()
    }

    /// The network of a zone.
    pub fn network(&self, zone: Zone, state: &State<T>) -> Neighbours {
        let senses = |k: usize, j: usize| {
            let offset = state.positions[j].clone() - &state.positions[k];
            self.senses(zone, &state.phasors[k], &offset)
        };
        Neighbours::from_fn(state.phasors.len(), senses)
    }
}

/// The direction away from the neighbours: the sum of `(r_k - r_j)/|r_k - r_j|`, given these unit vectors. The printed `v^rep`
/// has the opposite sign.
pub fn repulsion<T: Ring>(heading: &Complex<T>, away: &[Complex<T>]) -> Complex<T> {
    away.iter().fold(Complex::real(heading.re.zero()), |sum, unit| sum + unit)
}

/// The direction towards the neighbours, given the unit vectors `(r_k - r_j)/|r_k - r_j|`. The printed `v^att` has the opposite
/// sign.
pub fn attraction<T: Ring>(heading: &Complex<T>, away: &[Complex<T>]) -> Complex<T> {
    -repulsion(heading, away)
}

/// `v^ori = e^{i theta_k} + sum_j e^{i theta_j}`: the direction of the fish and its neighbours.
pub fn alignment<T: Ring>(heading: &Complex<T>, neighbours: &[Complex<T>]) -> Complex<T> {
    neighbours.iter().fold(heading.clone(), |sum, z| sum + z)
}

/// `<i e^{i theta_k}, v>`: what a desired direction adds to the steering (27).
pub fn steering_towards<T: Ring>(heading: &Complex<T>, desired: &Complex<T>) -> T {
    quarter_turn(heading).dot(desired)
}
