//! The phase model (6) and steered particles (1)-(2) of Paley and others.

use super::error::{ConfigError, Problem};
use super::individual::{Individual, Located, MOST_TOGETHER, sensing};
use super::links::Guard;
use super::network::{Abilities, Change, Kind, Network};
use super::observables::{CLUSTERS, Observable, min_distance, of_phases, places, total};
use super::simulation::{Continuous, Frame, Law, Simulation};
use super::source::{Section, Source};
use super::start::{Needs, Start, problem};
use super::stepped::{Arrangement, Stepped, read_step};
use arithmetic::{ArithmeticError, Complex};
use models::oscillator::{
    AllToAll, Flight, ParticleLaw, State, beacon_control, beacon_potential, centre_spread, circle_centres,
    laplacian_control, pattern_control, pattern_potential, phase_potential, reference_control, spacing_control,
    spacing_potential, write_rate,
};
use motion::{Moving, Sensing, VectorField};
use std::cell::RefCell;

/// Moments that are shown at least.
const FEWEST_ORDERS: usize = 4;

/// The orientation control.
enum Orientation {
    /// (14), with `K_1`.
    Laplacian(f64),
    /// The negative gradient of (25), with `K_1, ..., K_M`.
    Pattern(Vec<f64>),
    /// (14) with `K_1`, the last particle coupled to a reference phase that starts here and turns at the rate `omega_0`.
    Reference { gain: f64, start: f64, rate: f64 },
}

/// The unit vector at an angle.
fn unit(angle: f64) -> Complex<f64> {
    let (sin, cos) = angle.sin_cos();
    Complex::new(cos, sin)
}

impl Orientation {
    fn read(law: &Section, network: &Network, frequency: f64) -> Result<Self, ConfigError> {
        let gain = law.number_or("K1", 0.0)?;
        if let Some(entry) = law.get("K") {
            for other in ["K1", "reference"] {
                if law.get(other).is_some() {
                    return Err(entry.problem(Problem::Both("K", other)));
                }
            }
            let gains = entry.numbers()?;
            let agents = network.order();
            if gains.is_empty() || gains.len() > agents || !agents.is_multiple_of(gains.len()) {
                return Err(entry.problem(Problem::Pattern { clusters: gains.len(), agents }));
            }
            if !network.is_all_to_all() {
                let needs = "the graph all-to-all for pattern control (K)";
                return Err(entry.problem(Problem::Network { model: "oscillator", needs }));
            }
            return Ok(Orientation::Pattern(gains));
        }
        let reference = law.get("reference").map(|entry| entry.number()).transpose()?;
        Ok(match reference {
            None => Orientation::Laplacian(gain),
            Some(start) => Orientation::Reference { gain, start, rate: frequency },
        })
    }

    fn control(&self, network: &Network, time: f64, phasors: &[Complex<f64>]) -> Result<Vec<f64>, ArithmeticError> {
        match self {
            Orientation::Laplacian(gain) => laplacian_control(gain, network, phasors),
            Orientation::Pattern(gains) => pattern_control(gains, phasors),
            Orientation::Reference { gain, start, rate } => {
                reference_control(gain, network, &unit(start + rate * time), phasors)
            }
        }
    }

    /// The potential whose negative gradient the control is, on an undirected network.
    fn potential(&self, network: &Network, time: f64, phasors: &[Complex<f64>]) -> Result<f64, ArithmeticError> {
        match self {
            Orientation::Laplacian(gain) => Ok(-gain * phase_potential(network, phasors, 1)?),
            Orientation::Pattern(gains) => pattern_potential(gains, phasors),
            Orientation::Reference { gain, start, rate } => {
                let apart = phasors.last().map_or(0.0, |z| 1.0 - unit(start + rate * time).dot(z));
                Ok(-gain * (phase_potential(network, phasors, 1)? + apart))
            }
        }
    }

    fn orders(&self, agents: usize) -> u32 {
        let gains = if let Orientation::Pattern(gains) = self { gains.len() } else { 1 };
        gains.max(FEWEST_ORDERS.min(agents)) as u32
    }

    fn declaration(&self) -> String {
        match self {
            Orientation::Laplacian(gain) => {
                format!("u_k^ori = (K1/N) <i e^(i theta_k), L_k e^(i theta)> (14), K1 = {gain}; K1 < 0 synchronises")
            }
            Orientation::Pattern(gains) => format!("u_k^ori = -dU/dtheta_k with U = sum K_m U_m (25), K = {gains:?}"),
            Orientation::Reference { gain, start, rate } => format!(
                "u_k^ori by (14) with K1 = {gain}, and K1 sin(theta_N - theta_0) more for the last particle N; reference phase theta_0 = {start} + {rate} t"
            ),
        }
    }
}

const CONVENTIONS: &str = "observables: order |p_m| with p_m = (1/(m N)) sum e^(i m theta_k) (23), at most 1/m; phase_potential W_1 = (1/(2N)) <z, L z> (12), on an undirected network each edge once; orientation_potential is what the orientation control is the negative gradient of, on an undirected network: -K1 W_1 for (14), with a reference phase -K1 (W_1 + 1 - cos(theta_0 - theta_N)), sum K_m U_m for K";

/// The phase model (6).
struct Phases {
    network: Network,
    frequency: f64,
    orientation: Orientation,
    /// (14) where everyone is coupled to everyone: (10), by the order parameter.
    mean_field: Option<RefCell<AllToAll>>,
    drawn: Option<String>,
}

/// Networks of the phase model.
pub(super) const PHASES: Abilities = Abilities {
    model: "phase",
    positions: false,
    directed: true,
    edges: false,
    timed: true,
    default: Some(Kind::AllToAll),
};

/// Reads the phase model.
pub(super) fn read_phases(source: &Source, tolerance: f64) -> Result<Box<dyn Simulation>, ConfigError> {
    let start = Start::read(source, Needs { dimension: 0, velocities: false, phases: true })?;
    let network = Network::read(source, start.agents(), PHASES)?;
    let law = source.needed("law")?;
    law.allow(&["omega0", "K1", "K", "reference"], " of the phase model")?;
    let frequency = law.number_or("omega0", 0.0)?;
    let orientation = Orientation::read(&law, &network, frequency)?;
    let mean_field = match orientation {
        Orientation::Laplacian(gain) if network.is_all_to_all() => Some(RefCell::new(AllToAll::new(frequency, gain))),
        _ => None,
    };
    let phases = start.flat_phases();
    let law = Phases { network, frequency, orientation, mean_field, drawn: start.drawn };
    Ok(Box::new(Continuous::new(law, &phases, tolerance)))
}

impl Phases {
    fn flight(state: &[f64]) -> Flight {
        Flight { positions: Vec::new(), phases: state.to_vec() }
    }
}

impl Law for Phases {
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError> {
        if let Some(field) = &self.mean_field {
            field.borrow_mut().rate(time, state, rate);
            return Ok(());
        }
        let control = self.orientation.control(&self.network, time, &Phases::flight(state).state().phasors)?;
        rate.iter_mut().zip(control).for_each(|(rate, u)| *rate = self.frequency + u);
        Ok(())
    }

    fn next_time(&self) -> Option<f64> {
        self.network.next_time()
    }

    fn replace(&mut self, _: &[f64]) -> Vec<Change> {
        self.network.replace()
    }

    fn frame(&self, _: f64, state: &[f64]) -> Frame {
        Frame { phases: state.to_vec(), ..Frame::default() }
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.network.links()
    }

    fn observe(&self, time: f64, state: &[f64]) -> Result<Vec<Observable>, ArithmeticError> {
        let flight = Phases::flight(state);
        let phasors = flight.state().phasors;
        let orders = self.orientation.orders(state.len());
        let mut all = of_phases(&flight, &phasors, &self.network, orders)?;
        let potential = self.orientation.potential(&self.network, time, &phasors)?;
        all.push(Observable::number("orientation_potential", potential));
        all.push(Observable::count("components", self.network.components()));
        Ok(all)
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = vec![
            format!(
                "phase model (6) of Paley and others: d theta_k/dt = omega0 + u_k^ori, omega0 = {}",
                self.frequency
            ),
            self.orientation.declaration(),
            self.network.declaration().to_string(),
            CONVENTIONS.to_string(),
            CLUSTERS.to_string(),
            "phases in radians, not reduced to one turn".to_string(),
        ];
        lines.extend(self.drawn.clone());
        lines
    }
}

/// The spacing control.
enum Spacing {
    None,
    /// (20), with `K_0`.
    Circle(f64),
    /// That of the beacon, with `K_0`.
    Beacon(f64, [f64; 2]),
}

/// Steered particles (1)-(2).
struct Particles {
    network: Network,
    frequency: f64,
    orientation: Orientation,
    spacing: Spacing,
    drift: Complex<f64>,
    drawn: Option<String>,
}

/// Networks of the particle model.
pub(super) const PARTICLES: Abilities = Abilities {
    model: "particle",
    positions: true,
    directed: true,
    edges: false,
    timed: true,
    default: Some(Kind::AllToAll),
};

/// Reads the particle model.
pub(super) fn read_particles(source: &Source, tolerance: f64) -> Result<Box<dyn Simulation>, ConfigError> {
    let start = Start::read(source, Needs { dimension: 2, velocities: false, phases: true })?;
    let network = Network::read(source, start.agents(), PARTICLES)?;
    let step = read_step(source, &network)?;
    let law = source.needed("law")?;
    law.allow(&["omega0", "K0", "K1", "K", "drift", "beacon", "reference"], " of the particle model")?;
    let frequency = law.number_or("omega0", 0.0)?;
    let orientation = Orientation::read(&law, &network, frequency)?;
    let gain = law.number_or("K0", 0.0)?;
    let beacon = law.get("beacon").map(|entry| entry.vector()).transpose()?;
    let spacing = match beacon {
        Some(_) if gain == 0.0 => {
            return Err(law.problem(Problem::NoGain));
        }
        Some(place) => Spacing::Beacon(gain, place),
        None if gain != 0.0 => Spacing::Circle(gain),
        None => Spacing::None,
    };
    if frequency == 0.0 && !matches!(spacing, Spacing::None) {
        let at_fault = law.get("omega0").or(law.get("K0")).or(law.get("beacon"));
        return Err(at_fault.map_or_else(|| law.problem(Problem::NoCircles), |entry| entry.problem(Problem::NoCircles)));
    }
    let [re, im] = law.get("drift").map_or(Ok([0.0; 2]), |entry| entry.vector())?;
    let drift = Complex::new(re, im);
    let mut state = start.flat_positions();
    state.extend(start.flat_phases());
    let mut particles = Particles { network, frequency, orientation, spacing, drift, drawn: start.drawn };
    particles.settle(&state);
    Ok(match step {
        Some(step) => {
            // A reference is that of the last particle, and of two at one distance the smaller number is the nearer one.
            let nameless = law.get("reference").is_none();
            let radius = particles.network.radius().filter(|_| nameless);
            let stepped = Stepped::settled(particles, state, step);
            match radius {
                Some(radius) => Box::new(stepped.arranged(Arrangement { widths: &[2, 1], radius })),
                None => Box::new(stepped),
            }
        }
        None => match particles.individual().filter(|_| particles.network.order() > MOST_TOGETHER) {
            Some((law, sensing)) => {
                let flock = Individual::new(particles, law, sensing, state, tolerance);
                Box::new(flock.map_err(|error| problem(source, "positions", error.into()))?)
            }
            None => Box::new(Continuous::new(particles, &state, tolerance)),
        },
    })
}

impl Located<1> for Particles {
    fn network(&mut self) -> &mut Network {
        &mut self.network
    }

    fn list(agents: &[Moving<f64, 1>]) -> Vec<f64> {
        let places = agents.iter().flat_map(|agent| agent.position);
        places.chain(agents.iter().flat_map(|agent| agent.further)).collect()
    }

    fn agents(&self, list: &[f64]) -> Vec<Moving<f64, 1>> {
        let flight = Flight::from_list(list);
        let state = flight.state();
        let one = |((r, z), theta): ((&Complex<f64>, &Complex<f64>), &f64)| Moving {
            position: [r.re, r.im],
            velocity: [z.re + self.drift.re, z.im + self.drift.im],
            further: [*theta],
        };
        state.positions.iter().zip(&state.phasors).zip(&flight.phases).map(one).collect()
    }
}

impl Particles {
    /// The law of one particle among its neighbours and who these are, where they depend on distances and no particle is special.
    fn individual(&self) -> Option<(ParticleLaw, Sensing)> {
        let Orientation::Laplacian(gain) = self.orientation else { return None };
        let share = 1.0 / self.network.order() as f64;
        let (spacing, beacon) = match self.spacing {
            Spacing::None => (0.0, None),
            Spacing::Circle(gain) => (share * gain * self.frequency, None),
            Spacing::Beacon(gain, [x, y]) => (0.0, Some((gain * self.frequency, Complex::new(x, y)))),
        };
        let (frequency, orientation, drift) = (self.frequency, share * gain, self.drift.clone());
        Some((ParticleLaw { frequency, orientation, spacing, beacon, drift }, sensing(&self.network)?))
    }

    fn steering(&self, time: f64, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
        let mut steering = self.orientation.control(&self.network, time, &state.phasors)?;
        let spacing = match &self.spacing {
            Spacing::None => Vec::new(),
            Spacing::Circle(gain) => spacing_control(&self.frequency, gain, &self.network, state)?,
            Spacing::Beacon(gain, [x, y]) => beacon_control(&self.frequency, gain, &Complex::new(*x, *y), state)?,
        };
        steering.iter_mut().for_each(|u| *u += self.frequency);
        steering.iter_mut().zip(spacing).for_each(|(u, spacing)| *u += spacing);
        Ok(steering)
    }

    /// What the spacing control lowers: `K_0 S`, given `S`, or with a beacon `(K_0/2) sum |c_k - c_0|²`.
    fn spacing_part(&self, spacing: f64, state: &State<f64>) -> Result<f64, ArithmeticError> {
        match &self.spacing {
            Spacing::None => Ok(0.0),
            Spacing::Circle(gain) => Ok(gain * spacing),
            Spacing::Beacon(gain, [x, y]) => {
                let share = beacon_potential(&self.frequency, &Complex::new(*x, *y), state)?;
                Ok(gain * state.phasors.len() as f64 * share)
            }
        }
    }
}

impl Law for Particles {
    fn rate(&self, time: f64, list: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError> {
        let state = Flight::from_list(list).state();
        write_rate(&state, &self.drift, &self.steering(time, &state)?, rate);
        Ok(())
    }

    fn switches(&self) -> bool {
        self.network.switches()
    }

    fn guards(&self, state: &[f64], moved: &[f64]) -> Vec<Guard> {
        self.network.guards(state, moved)
    }

    fn switch(&mut self, state: &[f64]) -> Vec<Change> {
        self.network.switch(state)
    }

    fn settle(&mut self, state: &[f64]) {
        if self.network.switches() {
            let mut rate = vec![0.0; state.len()];
            write_rate(&Flight::from_list(state).state(), &self.drift, &[], &mut rate);
            self.network.settle(state, &rate);
        }
    }

    fn next_time(&self) -> Option<f64> {
        self.network.next_time()
    }

    fn replace(&mut self, _: &[f64]) -> Vec<Change> {
        self.network.replace()
    }

    fn frame(&self, _: f64, list: &[f64]) -> Frame {
        let flight = Flight::from_list(list);
        let state = flight.state();
        // There are none where omega0 is 0.
        let centres = circle_centres(&self.frequency, &state).unwrap_or_default();
        let centres = centres.iter().map(|c| vec![c.re, c.im]).collect();
        Frame { positions: places(&state), phases: flight.phases, centres, ..Frame::default() }
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.network.links()
    }

    fn observe(&self, time: f64, list: &[f64]) -> Result<Vec<Observable>, ArithmeticError> {
        let flight = Flight::from_list(list);
        let state = flight.state();
        let orientation = self.orientation.potential(&self.network, time, &state.phasors)?;
        let orders = self.orientation.orders(flight.phases.len());
        let mut all = of_phases(&flight, &state.phasors, &self.network, orders)?;
        all.push(Observable::number("orientation_potential", orientation));
        if self.frequency != 0.0 {
            let spacing = spacing_potential(&self.frequency, &self.network, &state)?;
            let composite = self.spacing_part(spacing, &state)? + orientation / (self.frequency * self.frequency);
            all.push(Observable::number("spacing_potential", spacing));
            all.push(Observable::number("composite_potential", composite));
            all.push(Observable::number("centre_spread", centre_spread(&self.frequency, &state)?));
        }
        all.push(Observable::number("min_distance", min_distance(&places(&state))));
        all.push(Observable::count("components", self.network.components()));
        let velocities = state.phasors.iter().map(|z| [z.re + self.drift.re, z.im + self.drift.im]);
        all.push(Observable::list("momentum", total(velocities)));
        Ok(all)
    }

    fn declaration(&self) -> Vec<String> {
        let spacing = match &self.spacing {
            Spacing::None => "no spacing control".to_string(),
            Spacing::Circle(gain) => {
                format!("spacing control u_k = omega0 (K0/N) <e^(i theta_k), L_k c> (20), K0 = {gain}")
            }
            Spacing::Beacon(gain, [x, y]) => format!(
                "beacon at ({x}, {y}) in place of the spacing control: u_k = omega0 K0 <e^(i theta_k), c_k - c_0>, K0 = {gain}"
            ),
        };
        let mut lines = vec![
            format!(
                "steered particles (1)-(2) of Paley and others: dr_k/dt = e^(i theta_k) + drift, d theta_k/dt = omega0 + u_k; omega0 = {}, drift ({}, {})",
                self.frequency, self.drift.re, self.drift.im
            ),
            spacing,
            self.orientation.declaration(),
            self.network.declaration().to_string(),
            CONVENTIONS.to_string(),
            CLUSTERS.to_string(),
            "spacing_potential S = (1/(2N)) <c, L c> (17), on an undirected network each edge once, with centres c_k = r_k + i e^(i theta_k)/omega0 (3); composite_potential K0 S, or (K0/2) sum |c_k - c_0|² with a beacon, plus orientation_potential/omega0²: it does not increase on a fixed undirected network, unless there is a beacon and a drift; centre_spread is the largest distance of a centre from their mean; the centres are listed with the trajectory; momentum is the sum of the velocities; phases in radians, not reduced to one turn".to_string(),
        ];
        lines.extend(self.drawn.clone());
        lines
    }
}
