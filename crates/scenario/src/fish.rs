//! The fish of Paley and others (26)-(28): discrete time, zones with a blind spot.

use super::described::{Built, Described};
use super::error::{ConfigError, RunError};
use super::exact::{DRAWN, ExactMotion};
use super::model::Model;
use super::observables::{CLUSTERS, Observable, observe, places};
use super::simulation::{Event, Frame, Simulation};
use super::source::Source;
use super::start::{Needs, Start, float};
use super::view::{Links, Rows, Sensing, View};
use arithmetic::random::{generator, normal};
use arithmetic::{ArithmeticError, Complex, Progress, Rational};
use models::oscillator::{
    BehaviourGains, Flight, Neighbours, State, ZoneNetworks, Zones, behaviour_control, laplacian_behaviour_control,
    write_rate,
};
use motion::CellList;
use rand_chacha::ChaCha8Rng;
use std::borrow::Cow;

/// Which of the steering laws.
#[derive(Clone, Copy, PartialEq)]
enum Steering {
    /// (27), by unit vectors.
    Behaviours,
    /// (28), by Laplacians.
    Laplacians,
}

/// A school.
pub(super) struct Fish {
    flight: Flight,
    zones: Zones<f64>,
    blind_angle: f64,
    gains: BehaviourGains<f64>,
    turning: f64,
    /// The standard deviation of the turning rates, with the seed and generator that they are drawn by.
    noise: Option<(f64, usize, ChaCha8Rng)>,
    steering: Steering,
    step: Rational,
    steps: u64,
    drawn: Option<String>,
}

const KEYS: [&str; 12] = [
    "T",
    "omega0",
    "Krep",
    "Kori",
    "Katt",
    "repulsion",
    "orientation",
    "attraction",
    "blind_angle",
    "steering",
    "noise",
    "seed",
];

impl Described for Fish {
    fn exact(&self) -> ExactMotion {
        ExactMotion::Other(DRAWN)
    }

    fn simulation(self: Box<Self>, _: &Source, _: f64) -> Result<Built, ConfigError> {
        let step = self.step.clone();
        Ok((self, Some(step)))
    }
}

impl Fish {
    /// Reads the fish model.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        let start = Start::read(source, Needs { dimension: 2, velocities: false, phases: true })?;
        if let Some(section) = source.section("graph")? {
            section.allow(&[], " of the fish model, whose zones make the network")?;
        }
        let law = source.needed("law")?;
        law.allow(&KEYS, " of the fish model")?;
        let entry = law.need("T", "the time step, a number above 0")?;
        entry.positive()?;
        let step = entry.exact()?;
        let radius = |key: &'static str, least: f64| {
            let entry = law.need(key, "the outer radius of the zone")?;
            let radius = entry.number()?;
            if radius < least {
                Err(entry.range(format!("at least {least}, the radius of the zone inside")))
            } else {
                Ok(radius)
            }
        };
        let repulsion = radius("repulsion", 0.0)?;
        let orientation = radius("orientation", repulsion)?;
        let attraction = radius("attraction", orientation)?;
        let blind_angle = match law.get("blind_angle") {
            None => 0.0,
            Some(entry) => {
                let angle = entry.number()?;
                if !(0.0..=180.0).contains(&angle) {
                    return Err(entry.range("an angle from 0 to 180 degrees"));
                }
                angle
            }
        };
        let steering = [("behaviours", Steering::Behaviours), ("laplacians", Steering::Laplacians)];
        let steering = law.get("steering").map_or(Ok(Steering::Behaviours), |entry| entry.choice(&steering))?;
        if steering == Steering::Behaviours {
            // Only they divide by distances.
            start.refuse_coincident(source)?;
        }
        let seed = law.get("seed").map(|entry| entry.count(0, usize::MAX)).transpose()?;
        if let Some(entry) = law.get("seed").filter(|_| law.get("noise").is_none()) {
            return Err(entry.range("left out: nothing is drawn without `noise`"));
        }
        let noise = match law.get("noise") {
            None => None,
            Some(entry) => {
                let deviation = entry.positive()?;
                let seed = seed.unwrap_or(1);
                Some((deviation, seed, generator(&seed.to_string(), "fish.turning", source.replica)))
            }
        };
        let half = (blind_angle / 2.0).to_radians().cos();
        let positions = start.flat_positions().chunks_exact(2).map(|r| Complex::new(r[0], r[1])).collect();
        Ok(Fish {
            flight: Flight { positions, phases: start.flat_phases() },
            zones: Zones { repulsion, orientation, attraction, blind_cosine_squared: half * half },
            blind_angle,
            gains: BehaviourGains {
                repulsion: law.number_or("Krep", 0.0)?,
                orientation: law.number_or("Kori", 0.0)?,
                attraction: law.number_or("Katt", 0.0)?,
            },
            turning: law.number_or("omega0", 0.0)?,
            noise,
            steering,
            step,
            steps: 0,
            drawn: start.drawn,
        })
    }

    /// Who senses whom, by cells a little wider than the zones; fish at one place sense each other in a zone of radius 0.
    fn networks(&self, state: &State<f64>) -> ZoneNetworks {
        let points: Vec<[f64; 2]> = state.positions.iter().map(|r| [r.re, r.im]).collect();
        let radius = (self.zones.attraction * (1.0 + 1e-9)).max(1e-150);
        // Positions are finite after every step.
        let pairs = CellList::new(&points, radius).map(|cells| cells.pairs()).unwrap_or_default();
        self.zones.networks_among(state, &pairs)
    }

    fn control(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        let networks = self.networks(state);
        match self.steering {
            Steering::Behaviours => behaviour_control(&self.turning, &self.gains, &networks, state),
            Steering::Laplacians => Ok(laplacian_behaviour_control(&self.turning, &self.gains, &networks, state)),
        }
    }
}

/// Who senses whom in any zone.
fn sensed(networks: &ZoneNetworks, fish: usize) -> Vec<(usize, usize)> {
    let arcs = |network: &Neighbours, k: usize| network.of_particle(k).iter().map(|&j| (k, j)).collect::<Vec<_>>();
    let all = [&networks.repulsion, &networks.orientation, &networks.attraction];
    (0..fish).flat_map(|k| all.into_iter().flat_map(move |network| arcs(network, k))).collect()
}

impl Simulation for Fish {
    fn advance(&mut self, until: f64, _: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        let step = float(&self.step);
        let last = (until / step).round() as u64;
        while self.steps < last {
            if progress.is_cancelled() {
                return Ok(false);
            }
            let time = self.steps as f64 * step;
            let state = self.flight.state();
            let mut control = self.control(&state).map_err(|error| RunError::law(time, error))?;
            if let Some((deviation, _, random)) = &mut self.noise {
                control.iter_mut().for_each(|u| *u += *deviation * normal(random));
            }
            let mut list = self.flight.to_list();
            let mut rate = vec![0.0; list.len()];
            write_rate(&state, &Complex::new(0.0, 0.0), &control, &mut rate);
            list.iter_mut().zip(rate).for_each(|(x, rate)| *x += step * rate);
            if list.iter().any(|x| !x.is_finite()) {
                return Err(RunError::law(time, ArithmeticError::Domain("steps that stay finite")));
            }
            self.flight = Flight::from_list(&list);
            self.steps += 1;
        }
        Ok(true)
    }

    fn frame(&self) -> Frame {
        let positions = places(&self.flight.state());
        Frame { positions, phases: self.flight.phases.clone(), ..Frame::default() }
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        let state = self.flight.state();
        let networks = self.networks(&state);
        let fish = self.flight.phases.len();
        let view = View {
            positions: Rows::of(fish, || places(&state)),
            velocities: Rows::of(fish, || state.phasors.iter().map(|z| vec![z.re, z.im]).collect()),
            phasors: state.phasors.clone(),
            phases: &self.flight.phases,
            orders: 4.min(fish as u32),
            sensing: Sensing::These(Cow::Borrowed(&networks.orientation)),
            ..View::new(Model::Fish, Links::These(fish, sensed(&networks, fish).into()))
        };
        observe(&view, &[])
    }

    fn declaration(&self) -> Vec<String> {
        let steering = match self.steering {
            Steering::Behaviours => {
                "u_k = omega0 + <i e^(i theta_k), Krep v_rep + Kori v_ori + Katt v_att> (27), with v_rep away from the sensed fish and v_att towards them (printed with both signs exchanged)"
            }
            Steering::Laplacians => {
                "u_k = omega0 - Kori <i e^(i theta_k), L_ori e^(i theta)> - Katt <i e^(i theta_k), L_att r> (28), printed with +Katt; the zone of repulsion has no effect"
            }
        };
        let Zones { repulsion, orientation, attraction, .. } = &self.zones;
        let BehaviourGains { repulsion: rep, orientation: ori, attraction: att } = &self.gains;
        let mut lines = vec![
            format!(
                "fish (26) of Paley and others: r_k += T e^(i theta_k), theta_k += T u_k, both with the time step T = {} (r_k is printed without it)",
                float(&self.step)
            ),
            steering.to_string(),
            format!("omega0 = {}, Krep = {rep}, Kori = {ori}, Katt = {att}", self.turning),
            format!(
                "zones, boundaries included: repulsion up to {repulsion}, orientation up to {orientation}, attraction up to {attraction}; blind spot of {} degrees behind, its edge is seen; networks are those of the state before the step",
                self.blind_angle
            ),
            "observables: order |p_m| with p_m = (1/(m N)) sum e^(i m theta_k) (23), at most 1/m; phase_potential W_1 = (1/(2N)) <z, L z> on the arcs of the zone of orientation; components of all arcs taken as edges; momentum is the sum of the velocities".to_string(),
            CLUSTERS.to_string(),
            self.noise.as_ref().map_or("omega_k is omega0 for every fish".to_string(), |(deviation, seed, _)| {
                format!("omega_k(q) is omega0 plus {deviation} times a standard normal number (ChaCha8, seed {seed}), anew for every fish and step")
            }),
        ];
        lines.extend(self.drawn.clone());
        lines
    }
}
