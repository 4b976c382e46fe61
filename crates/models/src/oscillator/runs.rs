//! The runs behind Figures 1, 3 to 6 and 8: each law with the parameters that the paper gives and those that it leaves open. The
//! claims about these figures and the figures themselves use the same runs.

use super::circles::{
    CircularGains, beacon_control, circular_control, reference_control, relative_position_control, spacing_control,
};
use super::fish::{Zone, Zones};
use super::flight::Flight;
use super::network::Neighbours;
use super::state::State;
use super::steering::{gradient_control, laplacian_control, pattern_control};
use crate::angles::modulo_turns;
use arithmetic::random::uniform;
use arithmetic::{ArithmeticError, Complex, Field};
use rand_chacha::rand_core::Rng;
use std::f64::consts::{FRAC_PI_8, PI, TAU};

/// `N` of the figures.
pub const PARTICLES: usize = 12;
/// `omega_0` of the circular figures.
pub const OMEGA: f64 = 0.1;
/// What all runs have in common and the paper does not state.
pub const DECLARATION: &str =
    "classical Runge-Kutta with fixed step; positions uniform in a square of half-width 10, phases uniform";

impl Flight {
    /// Positions uniform in a square of half-width 10 around the origin, uniform phases.
    pub fn random(random: &mut impl Rng, particles: usize) -> Self {
        let mut uniform = || uniform(random);
        let positions =
            (0..particles).map(|_| Complex::new(20.0 * uniform() - 10.0, 20.0 * uniform() - 10.0)).collect();
        Flight { positions, phases: (0..particles).map(|_| TAU * uniform()).collect() }
    }
}

/// A law with the step and the length of its run.
pub trait Experiment {
    /// The length of a step.
    const STEP: f64;
    /// The steps of a whole run.
    const STEPS: usize;

    /// `u_k`, `N` of them.
    ///
    /// # Errors
    /// [`ArithmeticError`] for no particles.
    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError>;

    /// The drift common to all particles.
    fn drift(&self) -> Complex<f64> {
        Complex::new(0.0, 0.0)
    }

    /// Goes on by some steps.
    ///
    /// # Errors
    /// As [`Experiment::steering`].
    fn advance(&self, flight: &mut Flight, steps: usize) -> Result<(), ArithmeticError> {
        flight.advance((Self::STEP, steps), &self.drift(), |state| self.steering(state))
    }

    /// The state at the end of the whole run.
    ///
    /// # Errors
    /// As [`Experiment::steering`].
    fn end(&self, mut flight: Flight) -> Result<Flight, ArithmeticError> {
        self.advance(&mut flight, Self::STEPS)?;
        Ok(flight)
    }

    /// Goes on until `reached` says what has been reached; it is asked after every `every` steps. `None` after `most` steps.
    ///
    /// # Errors
    /// As [`Experiment::steering`], or what `reached` returns.
    fn until<S>(
        &self,
        mut flight: Flight,
        (every, most): (usize, usize),
        mut reached: impl FnMut(&Flight) -> Result<Option<S>, ArithmeticError>,
    ) -> Result<Option<S>, ArithmeticError> {
        let every = every.max(1);
        for _ in 0..most / every {
            self.advance(&mut flight, every)?;
            let state = reached(&flight)?;
            if state.is_some() {
                return Ok(state);
            }
        }
        Ok(None)
    }

    /// The states of the whole run with their times: the first, and one after every `every` steps.
    ///
    /// # Errors
    /// As [`Experiment::steering`].
    fn course(&self, start: Flight, every: usize) -> Result<Vec<(f64, Flight)>, ArithmeticError> {
        let every = every.max(1);
        let mut states = vec![(0.0, start.clone())];
        let mut flight = start;
        for n in 1..=Self::STEPS / every {
            self.advance(&mut flight, every)?;
            states.push(((n * every) as f64 * Self::STEP, flight.clone()));
        }
        Ok(states)
    }
}

/// `omega_0` and terms that belong to it, added particle by particle.
fn with_frequency(omega: f64, terms: &[Vec<f64>]) -> Vec<f64> {
    let count = terms.first().map_or(0, Vec::len);
    (0..count).map(|k| omega + terms.iter().map(|term| term[k]).sum::<f64>()).collect()
}

/// Figure 1: (5) with (9).
#[derive(Debug, Clone)]
pub struct FourMotions {
    /// `omega_0`.
    pub omega: f64,
    /// `K_1`.
    pub gain: f64,
}

impl Experiment for FourMotions {
    const STEP: f64 = 0.2;
    const STEPS: usize = 500;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        Ok(with_frequency(self.omega, &[gradient_control(&self.gain, &state.phasors)?]))
    }
}

/// The phase model (6) with (14) on `C_12` in the turning frame; the positions take no part. `K_1 = -N` chooses the unit of time.
#[derive(Debug, Clone)]
pub struct RingPhases {
    network: Neighbours,
}

impl Default for RingPhases {
    fn default() -> Self {
        RingPhases { network: Neighbours::circulant(PARTICLES, &[1]) }
    }
}

impl Experiment for RingPhases {
    const STEP: f64 = 0.1;
    const STEPS: usize = 20_000;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        laplacian_control(&-(PARTICLES as f64), &self.network, &state.phasors)
    }
}

/// The phase model (6) with the negative gradient of (25) in the turning frame; the positions take no part.
#[derive(Debug, Clone)]
pub struct PatternPhases {
    /// `K_1, ..., K_M`.
    pub gains: Vec<f64>,
}

impl Experiment for PatternPhases {
    const STEP: f64 = 1.0;
    const STEPS: usize = 4000;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        pattern_control(&self.gains, &state.phasors)
    }
}

/// Figure 3: (22) on `C_12` with `omega_0 = 0.1` and `K_0 = N omega_0`.
#[derive(Debug, Clone)]
pub struct CyclicFormation {
    gains: CircularGains<f64>,
    network: Neighbours,
}

impl CyclicFormation {
    /// The size of `K_1` that is chosen here: far larger ones are slower (`reproduce paley.abscissa`).
    pub const GAIN: f64 = 0.3;

    /// With this `K_1`.
    pub fn new(orientation: f64) -> Self {
        let gains = CircularGains { omega: OMEGA, spacing: PARTICLES as f64 * OMEGA, orientation };
        CyclicFormation { gains, network: Neighbours::circulant(PARTICLES, &[1]) }
    }

    /// The cyclic graph.
    pub fn network(&self) -> &Neighbours {
        &self.network
    }
}

impl Experiment for CyclicFormation {
    const STEP: f64 = 2.0;
    const STEPS: usize = 600;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        circular_control(&self.gains, &self.network, &self.network, state)
    }
}

/// Figure 4: (5) with (20) and the negative gradient of (25), all-to-all, `omega_0 = K_0 = 0.1`.
#[derive(Debug, Clone)]
pub struct PatternFormation {
    gains: Vec<f64>,
    network: Neighbours,
}

impl PatternFormation {
    /// `K_m` below `M` and `-K_M`; the paper gives the signs only.
    pub const GAINS: (f64, f64) = (0.2, 0.04);

    /// With `K_1, ..., K_M`.
    pub fn new(gains: Vec<f64>) -> Self {
        PatternFormation { gains, network: Neighbours::complete(PARTICLES) }
    }

    /// For `M` clusters, with the gains chosen here.
    pub fn of_clusters(clusters: usize) -> Self {
        let (below, last) = PatternFormation::GAINS;
        PatternFormation::new((1..=clusters).map(|m| if m < clusters { below } else { -last }).collect())
    }
}

impl Experiment for PatternFormation {
    const STEP: f64 = 2.0;
    const STEPS: usize = 600;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        let pulled = spacing_control(&OMEGA, &0.1, &self.network, state)?;
        Ok(with_frequency(OMEGA, &[pulled, pattern_control(&self.gains, &state.phasors)?]))
    }
}

/// Figure 5, one leg of it: (14) all-to-all, with the last particle coupled to the reference phase; `omega_0 = 0`.
#[derive(Debug, Clone)]
pub struct ReferenceTracking {
    /// `K_1`.
    pub gain: f64,
    /// `theta_0`.
    pub reference: f64,
    /// Whether the last particle feels the reference.
    pub coupled: bool,
    network: Neighbours,
}

impl ReferenceTracking {
    /// The reference phases of the figure, one for each leg.
    pub const LEGS: [f64; 4] = [FRAC_PI_8, -3.0 * FRAC_PI_8, FRAC_PI_8, -3.0 * FRAC_PI_8];

    /// The legs with this `K_1`.
    pub fn legs(gain: f64, coupled: bool) -> [Self; 4] {
        let network = Neighbours::complete(PARTICLES);
        ReferenceTracking::LEGS.map(|reference| ReferenceTracking {
            gain,
            reference,
            coupled,
            network: network.clone(),
        })
    }

    /// The largest angle between a heading and the reference, in radians.
    pub fn error(&self, flight: &Flight) -> f64 {
        let off = |theta: &f64| modulo_turns(theta - self.reference).abs();
        flight.phases.iter().map(off).fold(0.0, f64::max)
    }
}

impl Experiment for ReferenceTracking {
    const STEP: f64 = 0.5;
    const STEPS: usize = 320;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        if !self.coupled {
            return laplacian_control(&self.gain, &self.network, &state.phasors);
        }
        let direction = Complex::new(self.reference.cos(), self.reference.sin());
        reference_control(&self.gain, &self.network, &direction, &state.phasors)
    }
}

/// Figure 6: (14), (20) and the control of a beacon, all-to-all, in the drift field `f = -0.1`; `omega_0 = 0.1`.
#[derive(Debug, Clone)]
pub struct DriftingOrbit {
    /// `K_1`.
    pub orientation: f64,
    /// `K_0` of the spacing control (20).
    pub spacing: f64,
    /// The gain of the beacon.
    pub beacon: f64,
    network: Neighbours,
}

impl DriftingOrbit {
    /// The beacon `c_0`.
    pub const BEACON: Complex<f64> = Complex { re: 10.0, im: 0.0 };
    /// The field `f`.
    pub const FIELD: Complex<f64> = Complex { re: -0.1, im: 0.0 };

    /// Figure 6(a): the spacing control and no beacon.
    pub fn free(orientation: f64) -> Self {
        DriftingOrbit { orientation, spacing: 0.1, beacon: 0.0, network: Neighbours::complete(PARTICLES) }
    }

    /// Figure 6(b): the control of the beacon in the place of the spacing control.
    pub fn around_beacon(orientation: f64) -> Self {
        DriftingOrbit { spacing: 0.0, beacon: 0.1, ..DriftingOrbit::free(orientation) }
    }

    /// Where an orbit settles: averaged over a turn a centre has the velocity `-(K/2)(c - c_0) + f`.
    pub fn settled_centre(&self) -> Complex<f64> {
        DriftingOrbit::FIELD.scale(&(2.0 / self.beacon)) + &DriftingOrbit::BEACON
    }

    /// Goes on for a turn of the first particle; the mean position of all over it, which a step more or less may change by
    /// a share `STEP/turn` of the radius.
    ///
    /// # Errors
    /// [`ArithmeticError`] for no particles, or where the particle does not turn.
    pub fn turn(&self, flight: &mut Flight) -> Result<Complex<f64>, ArithmeticError> {
        let Some(until) = flight.phases.first().map(|theta| theta + TAU) else {
            return Err(ArithmeticError::Domain("at least one particle"));
        };
        let (mut sum, mut steps) = (Complex::new(0.0, 0.0), 0.0);
        while flight.phases[0] < until {
            if steps > 10.0 * TAU / (OMEGA * Self::STEP) {
                return Err(ArithmeticError::Domain("particles that turn"));
            }
            sum = sum + super::mean(&flight.positions)?;
            steps += 1.0;
            self.advance(flight, 1)?;
        }
        Ok(sum.scale(&(1.0 / steps)))
    }
}

impl Experiment for DriftingOrbit {
    const STEP: f64 = 0.2;
    const STEPS: usize = 2000;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        let turned = laplacian_control(&self.orientation, &self.network, &state.phasors)?;
        let pulled = spacing_control(&OMEGA, &self.spacing, &self.network, state)?;
        let called = beacon_control(&OMEGA, &self.beacon, &DriftingOrbit::BEACON, state)?;
        Ok(with_frequency(OMEGA, &[turned, pulled, called]))
    }

    fn drift(&self) -> Complex<f64> {
        DriftingOrbit::FIELD
    }
}

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

/// Figure 8: (29) with an orientation zone of radius `2 sin(pi/M)/omega_0`, an attraction zone that holds everything and a blind spot
/// of 60 degrees; `omega_0 = 0.1`.
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
}

impl ZoneFormation {
    /// The numbers `M` of the figure, from the smallest zone to the largest.
    pub const CLUSTERS: [usize; 3] = [12, 8, 2];

    /// Zones without an inner radius: that of repulsion reaches out to 0 and that of attraction starts there.
    fn reaching(radius: f64) -> Zones<f64> {
        Zones { repulsion: 0.0, orientation: radius, attraction: radius, blind_cosine_squared: 0.75 }
    }

    /// The radius of the zone of orientation.
    pub fn radius(&self) -> f64 {
        2.0 * (PI / self.clusters as f64).sin() / OMEGA.abs()
    }

    /// The zone of orientation. The clusters of a pattern lie on its boundary: a margin for rounding counts them in.
    pub fn zone(&self) -> Zones<f64> {
        ZoneFormation::reaching(self.radius() * (1.0 + 1e-9))
    }

    /// The network of orientation.
    pub fn orientation_network(&self, state: &State<f64>) -> Neighbours {
        self.zone().network(Zone::Orientation, state)
    }

    /// The largest angle in radians between particles of which one senses the other in its zone of orientation; 0 where nobody
    /// senses another.
    pub fn sensed_apart(&self, flight: &Flight) -> f64 {
        let network = self.orientation_network(&flight.state());
        let pairs = (0..flight.phases.len()).flat_map(|k| network.of_particle(k).iter().map(move |&j| (k, j)));
        let apart = |(k, j): (usize, usize)| modulo_turns(flight.phases[k] - flight.phases[j]).abs();
        pairs.map(apart).fold(0.0, f64::max)
    }
}

impl Experiment for ZoneFormation {
    const STEP: f64 = 1.0;
    const STEPS: usize = 600;

    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        // Who is sensed in the zone is sensed by the attraction too.
        let all = ZoneFormation::reaching(1e9).network(Zone::Orientation, state);
        let own = self.zone().network_among(Zone::Orientation, state, all.arcs());
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
}
