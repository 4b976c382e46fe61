//! The zones of Figure 7 and the runs of Figure 8.

use super::{Experiment, OMEGA};
use arithmetic::{ArithmeticError, Field};
use models::angles::modulo_turns;
use models::oscillator::{
    CircularGains, Flight, Sensed, State, Zone, Zones, circular_control, relative_position_control,
};
use std::f64::consts::PI;

/// The zones of Figure 7: outer radii 2, 4 and 7 and a blind spot of 60 degrees, chosen here.
pub fn zones_of_figure_7<T: Field>(like: &T) -> Zones<T> {
    let radius = |r: i64| like.integer(r);
    Zones {
        repulsion: radius(2),
        orientation: radius(4),
        attraction: radius(7),
        blind_cosine_squared: like.ratio(3, 4),
    }
}

/// (29) as printed, or with `K_0` on the attraction network as (5), (14) and (20) give it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum ZoneLaw {
    Printed,
    Corrected,
}

impl ZoneLaw {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            ZoneLaw::Printed => "printed",
            ZoneLaw::Corrected => "corrected",
        }
    }
}

/// Figure 8: (29) with an orientation zone of radius `2 sin(pi/M)/omega_0`, an attraction zone that contains all and a blind spot
/// of 60 degrees; `omega_0 = 0.1`.
///
/// The clusters of a pattern on one circle of radius `1/omega_0` lie exactly on the rim of the zone, which belongs to it. A method that
/// steps positions keeps them on a circle that is too large by a share `(omega_0 h)^4/2880`, 3.5e-8 for the step 1, and so decides
/// that they do not sense each other. These runs step the circle centres and the phases instead, with which a circular formation
/// is followed without error at any step ([`Flight::advance_by_centres`]): what is left is rounding, and [`Rim::MARGIN`] covers that.
#[derive(Debug, Clone)]
pub struct ZoneFormation {
    /// Which form of (29).
    pub law: ZoneLaw,
    /// `K_0`.
    pub spacing: f64,
    /// `K_1`.
    pub orientation: f64,
    /// `M`.
    pub clusters: usize,
    /// How the rim of the zone is decided.
    pub rim: Rim,
}

/// What decides who is sensed at the rim of a zone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rim {
    /// Whether the runs step the circle centres, or the positions.
    pub by_centres: bool,
    /// The length of a step.
    pub step: f64,
    /// The share of the radius up to which a particle beyond it counts as on it.
    pub margin: f64,
}

impl Rim {
    /// Centres and phases below 64 and 1024 in size are rounded by at most `2^-44`, and a distance on the circle of radius 10 by less than `2^-40`:
    /// of the smallest radius, 5.2, a share below `2e-13`. The margin is 5000 times that; the runs end alike with margins from 0 to `1e-7`.
    pub const MARGIN: f64 = 1e-9;
    /// As the runs of the claims have it.
    pub const EXACT: Rim = Rim { by_centres: true, step: ZoneFormation::STEP, margin: Rim::MARGIN };
}

impl ZoneFormation {
    /// The numbers `M` of the figure, from the smallest zone to the largest.
    pub const CLUSTERS: [usize; 3] = [12, 8, 2];

    /// With the rim as exact as it can be.
    pub fn new(law: ZoneLaw, (spacing, orientation): (f64, f64), clusters: usize) -> Self {
        ZoneFormation { law, spacing, orientation, clusters, rim: Rim::EXACT }
    }

    /// The radius of the zone of orientation.
    pub fn radius(&self) -> f64 {
        2.0 * (PI / self.clusters as f64).sin() / OMEGA.abs()
    }

    /// The zone of orientation, with the margin of the rim, and no inner radius: the zone of repulsion reaches out to 0.
    pub fn zone(&self) -> Zones<f64> {
        let radius = self.radius() * (1.0 + self.rim.margin);
        Zones { repulsion: 0.0, orientation: radius, attraction: radius, blind_cosine_squared: 0.75 }
    }

    /// Who senses whom at any distance, which is the network of attraction, and in the zone of orientation.
    fn networks(&self, state: &State<f64>) -> (Sensed, Sensed) {
        let zone = self.zone();
        let offset = |k: usize, j: usize| state.positions[j].clone() - &state.positions[k];
        let all = Sensed::from_fn(state.phasors.len(), |k, j| !zone.is_blind(&state.phasors[k], &offset(k, j)));
        let own = all.among(|k, j| zone.reaches(Zone::Orientation, &offset(k, j)));
        (all, own)
    }

    /// The largest angle in radians between particles of which one senses the other in its zone of orientation; 0 where nobody
    /// senses another.
    pub fn sensed_apart(&self, flight: &Flight) -> f64 {
        let (_, own) = self.networks(&flight.state());
        let apart = |(k, j): (usize, usize)| modulo_turns(flight.phases[k] - flight.phases[j]).abs();
        own.arcs().map(apart).fold(0.0, f64::max)
    }
}

impl Experiment for ZoneFormation {
    const STEP: f64 = 1.0;
    const STEPS: usize = 600;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        let (all, own) = self.networks(state);
        let (spacing, orientation) = (self.spacing, self.orientation);
        match self.law {
            ZoneLaw::Printed => {
                relative_position_control(&OMEGA, (&(orientation - spacing), &own), (&spacing, &all), state)
            }
            ZoneLaw::Corrected => {
                circular_control(&CircularGains { omega: OMEGA, spacing, orientation }, &own, &all, state)
            }
        }
    }

    /// Steps of the length 1, whatever the step of the rim is.
    fn advance(&self, flight: &mut Flight, steps: usize) -> Result<(), ArithmeticError> {
        let Rim { by_centres, step, .. } = self.rim;
        let pace = (step, (steps as f64 * Self::STEP / step).round() as usize);
        let steering = |state: &State<f64>| self.steering(state);
        match by_centres {
            true => flight.advance_by_centres(OMEGA, pace, steering),
            false => flight.advance(pace, &self.drift(), steering),
        }
    }
}
