//! The fish model (26)-(28): zones with a blind spot, and the behaviours of repulsion, alignment and attraction.

use super::laplacian::misalignment;
use super::moments::quarter_turn;
use super::network::{Interaction, Neighbours};
use super::state::State;
use arithmetic::{ArithmeticError, Complex, Field, Real, Ring, Signed};

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
    #[inline]
    pub fn senses(&self, zone: Zone, heading: &Complex<T>, offset: &Complex<T>) -> bool {
        self.reaches(zone, offset) && !self.is_blind(heading, offset)
    }

    /// Whether the zone reaches a fish at `offset` from its own, by distance alone.
    #[inline]
    pub fn reaches(&self, zone: Zone, offset: &Complex<T>) -> bool {
        let distance = offset.norm_squared();
        let (inner, outer) = match zone {
            Zone::Repulsion => (None, &self.repulsion),
            Zone::Orientation => (Some(&self.repulsion), &self.orientation),
            Zone::Attraction => (Some(&self.orientation), &self.attraction),
        };
        let beyond = |radius: &T| (distance.clone() - radius.square()).is_certainly_positive();
        let inside = |radius: &T| (distance.clone() - radius.square()).is_certainly_negative();
        !beyond(outer) && !inner.is_some_and(inside)
    }

    /// Whether the offset lies in the open wedge around the direction opposite to the heading.
    #[inline]
    pub fn is_blind(&self, heading: &Complex<T>, offset: &Complex<T>) -> bool {
        // An empty wedge, which rounding must not fill.
        if !(self.blind_cosine_squared.one() - &self.blind_cosine_squared).is_certainly_positive() {
            return false;
        }
        let behind = -heading.dot(offset);
        let edge = offset.norm_squared() * &self.blind_cosine_squared;
        behind.is_certainly_positive() & (behind.square() - edge).is_certainly_positive()
    }

    /// The network of a zone; fish without a place sense nobody and are not sensed.
    pub fn network(&self, zone: Zone, state: &State<T>) -> Neighbours {
        let senses = |k: usize, j: usize| {
            let (Some(own), Some(other)) = (state.positions.get(k), state.positions.get(j)) else { return false };
            self.senses(zone, &state.phasors[k], &(other.clone() - own))
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

/// Gains of the three behaviours.
#[derive(Debug, Clone, PartialEq)]
pub struct BehaviourGains<T> {
    /// `K_rep`.
    pub repulsion: T,
    /// `K_ori`.
    pub orientation: T,
    /// `K_att`.
    pub attraction: T,
}

/// The networks of the three zones.
#[derive(Debug, Clone, PartialEq)]
pub struct ZoneNetworks {
    /// Who is in the zone of repulsion of each fish.
    pub repulsion: Neighbours,
    /// Who is in its zone of orientation.
    pub orientation: Neighbours,
    /// Who is in its zone of attraction.
    pub attraction: Neighbours,
}

impl<T: Field + Signed> Zones<T> {
    /// The network of a zone, where all of its arcs are among these; arcs to fish that are not there are left out.
    pub fn network_among(
        &self,
        zone: Zone,
        state: &State<T>,
        arcs: impl Iterator<Item = (usize, usize)>,
    ) -> Neighbours {
        let senses = |&(k, j): &(usize, usize)| {
            let (Some(own), Some(other)) = (state.positions.get(k), state.positions.get(j)) else { return false };
            state.phasors.get(k).is_some_and(|heading| self.senses(zone, heading, &(other.clone() - own)))
        };
        Neighbours::from_arcs(state.phasors.len(), arcs.filter(senses).collect::<Vec<_>>())
    }

    /// All three networks, where all pairs at a distance up to the radius of attraction are among these.
    pub fn networks_among(&self, state: &State<T>, pairs: &[(usize, usize)]) -> ZoneNetworks {
        let arcs = || pairs.iter().flat_map(|&(i, j)| [(i, j), (j, i)]);
        let network = |zone| self.network_among(zone, state, arcs());
        ZoneNetworks {
            repulsion: network(Zone::Repulsion),
            orientation: network(Zone::Orientation),
            attraction: network(Zone::Attraction),
        }
    }
}

/// (27) with `v^rep` and `v^att` of the right signs: `w + <i e^{i theta_k}, K_rep v^rep + K_ori v^ori + K_att v^att>`, `N` entries.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where a fish is at the place of one that it senses; [`ArithmeticError::Domain`] where a network
/// has more fish than the state.
pub fn behaviour_control<T: Real>(
    turning: &T,
    gains: &BehaviourGains<T>,
    networks: &ZoneNetworks,
    state: &State<T>,
) -> Result<Vec<T>, ArithmeticError> {
    let fish = state.positions.len().min(state.phasors.len());
    if [&networks.repulsion, &networks.orientation, &networks.attraction].iter().any(|n| n.particles() > fish) {
        return Err(ArithmeticError::Domain("networks of the fish of the state"));
    }
    let control = |(k, z): (usize, &Complex<T>)| {
        let away = |network: &Neighbours| -> Result<Vec<Complex<T>>, ArithmeticError> {
            let unit = |&j: &usize| {
                let r = state.positions[k].clone() - &state.positions[j];
                Ok(r.scale(&r.norm_squared().sqrt()?.recip()?))
            };
            network.of_particle(k).iter().map(unit).collect()
        };
        let mates: Vec<_> = networks.orientation.of_particle(k).iter().map(|&j| state.phasors[j].clone()).collect();
        let desired = repulsion(z, &away(&networks.repulsion)?).scale(&gains.repulsion)
            + alignment(z, &mates).scale(&gains.orientation)
            + attraction(z, &away(&networks.attraction)?).scale(&gains.attraction);
        Ok(turning.clone() + steering_towards(z, &desired))
    };
    state.phasors.iter().enumerate().map(control).collect()
}

/// (28) with the right sign of the attraction, for an empty zone of repulsion:
/// `w - K_ori <i e^{i theta_k}, L_k^ori e^{i theta}> - K_att <i e^{i theta_k}, L_k^att r>`, `N` entries.
pub fn laplacian_behaviour_control<T: Field>(
    turning: &T,
    gains: &BehaviourGains<T>,
    networks: &ZoneNetworks,
    state: &State<T>,
) -> Vec<T> {
    let apart = misalignment(&networks.orientation, &state.phasors);
    let from = networks.attraction.laplacian_of(&state.positions);
    let terms = state.phasors.iter().zip(apart).zip(from);
    terms
        .map(|((z, apart), from)| {
            turning.clone() - apart * &gains.orientation - steering_towards(z, &from) * &gains.attraction
        })
        .collect()
}
