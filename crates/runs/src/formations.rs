//! The laws of Figures 1, 3, 4, 5 and 6 with what their runs leave open.

use super::{Experiment, OMEGA, PARTICLES};
use arithmetic::{ArithmeticError, Complex};
use models::angles::modulo_turns;
use models::oscillator::{
    CircularGains, Everyone, Flight, Neighbours, State, beacon_control, circular_control, gradient_control,
    laplacian_control, mean, pattern_control, reference_control, spacing_control,
};
use std::f64::consts::{FRAC_PI_8, TAU};

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
    /// `K` of the beacon.
    pub beacon: f64,
}

impl DriftingOrbit {
    /// `K_0/N`, which the control of the beacon has where it is what (20) becomes, and `K_0`.
    pub const GAINS: [f64; 2] = [0.1 / PARTICLES as f64, 0.1];
    /// The beacon `c_0`.
    pub const BEACON: Complex<f64> = Complex { re: 10.0, im: 0.0 };
    /// The field `f`.
    pub const FIELD: Complex<f64> = Complex { re: -0.1, im: 0.0 };

    /// Figure 6(a): the spacing control and no beacon.
    pub fn free(orientation: f64) -> Self {
        DriftingOrbit { orientation, spacing: 0.1, beacon: 0.0 }
    }

    /// Figure 6(b): the control of the beacon in the place of the spacing control.
    pub fn around_beacon(orientation: f64, beacon: f64) -> Self {
        DriftingOrbit { orientation, spacing: 0.0, beacon }
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
            sum = sum + mean(&flight.positions)?;
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
        let turned = laplacian_control(&self.orientation, &Everyone, &state.phasors)?;
        let pulled = spacing_control(&OMEGA, &self.spacing, &Everyone, state)?;
        let called = beacon_control(&OMEGA, &self.beacon, &DriftingOrbit::BEACON, state)?;
        Ok(with_frequency(OMEGA, &[turned, pulled, called]))
    }

    fn drift(&self) -> Complex<f64> {
        DriftingOrbit::FIELD
    }
}
