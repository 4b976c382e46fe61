//! The phase model (6) and steered particles (1)-(2) of Paley and others.

use super::described::{Built, Described};
use super::error::{ConfigError, Problem};
use super::exact::ExactMotion;
use super::individual::{Individual, Located, MOST_TOGETHER, sensing};
use super::links::Guard;
use super::model::Model;
use super::network::{Abilities, Change, Kind, Network};
use super::observables::{CLUSTERS, Observable, observe, places};
use super::simulation::{Continuous, Frame, Law, Simulation};
use super::source::{Section, Source};
use super::start::{Needs, Start, float, problem};
use super::stepped::{Arrangement, Stepped, read_step};
use super::view::{Law as Measured, Rows, View};
use arithmetic::{ArithmeticError, Complex, Rational};
use models::oscillator::{
    AllToAll, Flight, Neighbours, Orientation, ParticleLaw, Spacing, Steering, circle_centres, write_rate,
};
use motion::{Moving, Sensing, VectorField};
use num_traits::Zero;
use std::cell::RefCell;

/// Moments that are shown at least.
const FEWEST_ORDERS: usize = 4;

/// Reads the orientation control.
fn orientation(law: &Section, network: &Network, frequency: &Rational) -> Result<Orientation<Rational>, ConfigError> {
    let gain = law.exact_or("K1", 0)?;
    if let Some(entry) = law.get("K") {
        for other in ["K1", "reference"] {
            if law.get(other).is_some() {
                return Err(entry.problem(Problem::Both("K", other)));
            }
        }
        let gains = entry.exact_numbers()?;
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
    Ok(match law.get("reference") {
        None => Orientation::Laplacian(gain),
        Some(entry) => Orientation::Reference { gain, start: entry.finite()?, rate: frequency.clone() },
    })
}

/// Moments that are shown.
fn orders(control: &Orientation<f64>, agents: usize) -> u32 {
    let gains = if let Orientation::Pattern(gains) = control { gains.len() } else { 1 };
    gains.max(FEWEST_ORDERS.min(agents)) as u32
}

fn in_words(control: &Orientation<f64>) -> String {
    match control {
        Orientation::Laplacian(gain) => {
            format!("u_k^ori = (K1/N) <i e^(i theta_k), L_k e^(i theta)> (14), K1 = {gain}; K1 < 0 synchronises")
        }
        Orientation::Pattern(gains) => format!("u_k^ori = -dU/dtheta_k with U = sum K_m U_m (25), K = {gains:?}"),
        Orientation::Reference { gain, start, rate } => format!(
            "u_k^ori by (14) with K1 = {gain}, and K1 sin(theta_N - theta_0) more for the last particle N; reference phase theta_0 = {start} + {rate} t"
        ),
    }
}

const CONVENTIONS: &str = "observables: order |p_m| with p_m = (1/(m N)) sum e^(i m theta_k) (23), at most 1/m; phase_potential W_1 = (1/(2N)) <z, L z> (12), on an undirected network each edge once; orientation_potential is what the orientation control is the negative gradient of, on an undirected network: -K1 W_1 for (14), with a reference phase -K1 (W_1 + 1 - cos(theta_0 - theta_N)), sum K_m U_m for K";

/// The phase model (6).
struct Phases {
    network: Network,
    frequency: f64,
    orientation: Orientation<f64>,
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
    weighted: false,
    timed: true,
    default: Some(Kind::AllToAll),
};

/// A run of the phase model as it is described.
pub(super) struct PhaseRun {
    start: Start,
    network: Network,
    frequency: Rational,
    orientation: Orientation<Rational>,
}

impl PhaseRun {
    /// Reads the phase model.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        let start = Start::read(source, Needs { dimension: 0, velocities: false, phases: true })?;
        let network = Network::read(source, start.agents(), PHASES)?;
        let law = source.needed("law")?;
        law.allow(&["omega0", "K1", "K", "reference"], " of the phase model")?;
        let frequency = law.exact_or("omega0", 0)?;
        let orientation = orientation(&law, &network, &frequency)?;
        Ok(PhaseRun { start, network, frequency, orientation })
    }
}

impl Described for PhaseRun {
    fn exact(&self) -> ExactMotion {
        let Orientation::Laplacian(gain) = &self.orientation else {
            return ExactMotion::Other("of the phase model only the control K1 is enclosed");
        };
        match self.network.unchanging() {
            Ok(network) => {
                let (phases, frequency) = (self.start.phases.clone(), self.frequency.clone());
                ExactMotion::Phases { phases, frequency, gain: gain.clone(), network }
            }
            Err(why) => ExactMotion::Other(why),
        }
    }

    fn simulation(self: Box<Self>, _: &Source, tolerance: f64) -> Result<Built, ConfigError> {
        let (frequency, orientation) = (float(&self.frequency), self.orientation.over(&0.0));
        let mean_field = match orientation {
            Orientation::Laplacian(gain) if self.network.is_all_to_all() => {
                Some(RefCell::new(AllToAll::new(frequency, gain)))
            }
            _ => None,
        };
        let phases = self.start.flat_phases();
        let law = Phases { network: self.network, frequency, orientation, mean_field, drawn: self.start.drawn };
        Ok((Box::new(Continuous::new(law, &phases, tolerance)), None))
    }
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
        let phasors = Phases::flight(state).state().phasors;
        let control = self.orientation.control(&self.network, self.orientation.reference(time).as_ref(), &phasors)?;
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
        let orientation = self.orientation.clone();
        let steering = Steering { frequency: self.frequency, orientation, spacing: Spacing::None };
        let view = View {
            phasors: Phases::flight(state).state().phasors,
            phases: state,
            orders: orders(&self.orientation, state.len()),
            sensing: self.network.sensing(),
            law: Measured::Turning(steering, self.orientation.reference(time)),
            ..View::new(Model::Phase, self.network.shown())
        };
        observe(&view, &[])
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = vec![
            format!(
                "phase model (6) of Paley and others: d theta_k/dt = omega0 + u_k^ori, omega0 = {}",
                self.frequency
            ),
            in_words(&self.orientation),
            self.network.declaration().to_string(),
            CONVENTIONS.to_string(),
            CLUSTERS.to_string(),
            "phases in radians, not reduced to one turn".to_string(),
        ];
        lines.extend(self.drawn.clone());
        lines
    }
}

/// Steered particles (1)-(2).
struct Particles {
    network: Network,
    steering: Steering<f64>,
    drift: Complex<f64>,
    drawn: Option<String>,
}

/// Networks of the particle model.
pub(super) const PARTICLES: Abilities = Abilities {
    model: "particle",
    positions: true,
    directed: true,
    edges: false,
    weighted: false,
    timed: true,
    default: Some(Kind::AllToAll),
};

/// A run of steered particles as it is described.
pub(super) struct ParticleRun {
    start: Start,
    network: Network,
    steering: Steering<Rational>,
    drift: Complex<Rational>,
    step: Option<f64>,
}

impl ParticleRun {
    /// Reads the particle model.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        let start = Start::read(source, Needs { dimension: 2, velocities: false, phases: true })?;
        let network = Network::read(source, start.agents(), PARTICLES)?;
        let step = read_step(source, &network)?;
        let law = source.needed("law")?;
        law.allow(&["omega0", "K0", "K1", "K", "drift", "beacon", "reference"], " of the particle model")?;
        let frequency = law.exact_or("omega0", 0)?;
        let orientation = orientation(&law, &network, &frequency)?;
        let gain = law.exact_or("K0", 0)?;
        let vector = |[x, y]: [Rational; 2]| Complex::new(x, y);
        let spacing = match law.get("beacon").map(|entry| entry.vector()).transpose()? {
            Some(_) if gain.is_zero() => {
                return Err(law.problem(Problem::NoGain));
            }
            Some(place) => Spacing::Beacon(gain, vector(place)),
            None if gain.is_zero() => Spacing::None,
            None => Spacing::Circle(gain),
        };
        // Also of numbers that are 0 only as floats.
        if float(&frequency) == 0.0 && spacing != Spacing::None {
            let at_fault = law.get("omega0").or(law.get("K0")).or(law.get("beacon"));
            let problem = Problem::NoCircles;
            return Err(at_fault.map_or_else(|| law.problem(problem.clone()), |entry| entry.problem(problem.clone())));
        }
        let drift = vector(law.get("drift").map_or(Ok(Default::default()), |entry| entry.vector())?);
        Ok(ParticleRun { start, network, steering: Steering { frequency, orientation, spacing }, drift, step })
    }
}

impl Described for ParticleRun {
    fn exact(&self) -> ExactMotion {
        let Orientation::Laplacian(gain) = &self.steering.orientation else {
            return ExactMotion::Other("of the orientation controls of particles only K1 is enclosed");
        };
        let radius = self.network.exact_radius().cloned();
        let network = match &radius {
            Some(radius) => Ok(within(&self.start.positions, radius)),
            None => self.network.unchanging(),
        };
        match network {
            Ok(network) => ExactMotion::Particles {
                positions: self.start.positions.clone(),
                phases: self.start.phases.clone(),
                frequency: self.steering.frequency.clone(),
                gain: gain.clone(),
                spacing: self.steering.spacing.clone(),
                drift: [self.drift.re.clone(), self.drift.im.clone()],
                network,
                radius,
            },
            Err(why) => ExactMotion::Other(why),
        }
    }

    fn simulation(self: Box<Self>, source: &Source, tolerance: f64) -> Result<Built, ConfigError> {
        let ParticleRun { start, network, steering, drift, step } = *self;
        let mut state = start.flat_positions();
        state.extend(start.flat_phases());
        let drift = Complex::new(float(&drift.re), float(&drift.im));
        let mut particles = Particles { network, steering: steering.over(&0.0), drift, drawn: start.drawn };
        particles.settle(&state);
        let simulation: Box<dyn Simulation> = match step {
            Some(step) => {
                // A reference is that of the last particle, and of two at one distance the smaller number is the nearer one.
                let nameless = !matches!(steering.orientation, Orientation::Reference { .. });
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
        };
        Ok((simulation, None))
    }
}

/// Who is nearer to whom than the radius.
fn within(positions: &[Vec<Rational>], radius: &Rational) -> Neighbours {
    let number = |row: &[Rational], k: usize| row.get(k).cloned().unwrap_or_default();
    let points = positions.iter().map(|row| Complex { re: number(row, 0), im: number(row, 1) });
    Neighbours::within(&points.collect::<Vec<_>>(), radius)
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
        let Steering { frequency, orientation: Orientation::Laplacian(gain), spacing } = &self.steering else {
            return None;
        };
        let share = 1.0 / self.network.order() as f64;
        let (spacing, beacon) = match spacing {
            Spacing::None => (0.0, None),
            Spacing::Circle(gain) => (share * gain * frequency, None),
            Spacing::Beacon(gain, place) => (0.0, Some((gain * frequency, place.clone()))),
        };
        let (frequency, orientation, drift) = (*frequency, share * gain, self.drift.clone());
        Some((ParticleLaw { frequency, orientation, spacing, beacon, drift }, sensing(&self.network)?))
    }
}

impl Law for Particles {
    fn rate(&self, time: f64, list: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError> {
        let state = Flight::from_list(list).state();
        let reference = self.steering.orientation.reference(time);
        let turning = self.steering.turning(&self.network, reference.as_ref(), &state)?;
        write_rate(&state, &self.drift, &turning, rate);
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
        let centres = circle_centres(&self.steering.frequency, &state).unwrap_or_default();
        let centres = centres.iter().map(|c| vec![c.re, c.im]).collect();
        Frame { positions: places(&state), phases: flight.phases, centres, ..Frame::default() }
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.network.links()
    }

    fn observe(&self, time: f64, list: &[f64]) -> Result<Vec<Observable>, ArithmeticError> {
        let flight = Flight::from_list(list);
        let state = flight.state();
        let velocity = |z: &Complex<f64>| vec![z.re + self.drift.re, z.im + self.drift.im];
        let count = flight.phases.len();
        let view = View {
            positions: Rows::of(count, || places(&state)),
            velocities: Rows::of(count, || state.phasors.iter().map(velocity).collect()),
            phasors: state.phasors.clone(),
            phases: &flight.phases,
            orders: orders(&self.steering.orientation, count),
            sensing: self.network.sensing(),
            law: Measured::Turning(self.steering.clone(), self.steering.orientation.reference(time)),
            ..View::new(Model::Particles, self.network.shown())
        };
        observe(&view, &[])
    }

    fn declaration(&self) -> Vec<String> {
        let Steering { frequency, orientation, spacing } = &self.steering;
        let spacing = match spacing {
            Spacing::None => "no spacing control".to_string(),
            Spacing::Circle(gain) => {
                format!("spacing control u_k = omega0 (K0/N) <e^(i theta_k), L_k c> (20), K0 = {gain}")
            }
            Spacing::Beacon(gain, Complex { re: x, im: y }) => format!(
                "beacon at ({x}, {y}) in place of the spacing control: u_k = omega0 K0 <e^(i theta_k), c_k - c_0>, K0 = {gain}"
            ),
        };
        let mut lines = vec![
            format!(
                "steered particles (1)-(2) of Paley and others: dr_k/dt = e^(i theta_k) + drift, d theta_k/dt = omega0 + u_k; omega0 = {}, drift ({}, {})",
                frequency, self.drift.re, self.drift.im
            ),
            spacing,
            in_words(orientation),
            self.network.declaration().to_string(),
            CONVENTIONS.to_string(),
            CLUSTERS.to_string(),
            "spacing_potential S = (1/(2N)) <c, L c> (17), on an undirected network each edge once, with centres c_k = r_k + i e^(i theta_k)/omega0 (3); composite_potential K0 S, or (K0/2) sum |c_k - c_0|² with a beacon, plus orientation_potential/omega0²: it does not increase on a fixed undirected network, unless there is a beacon and a drift; centre_spread is the largest distance of a centre from their mean; the centres are listed with the trajectory; momentum is the sum of the velocities; phases in radians, not reduced to one turn".to_string(),
        ];
        lines.extend(self.drawn.clone());
        lines
    }
}
