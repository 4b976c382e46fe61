//! Heading and velocity alignment of Tanner and others, on fixed and distance-switched networks, as a configuration asks for it.

use super::agents::{Agents, Alignment, PLANE, state_of};
use super::described::{Built, Described};
use super::error::{ConfigError, Problem, RunError};
use super::exact::ExactMotion;
use super::individual::{Individual, MOST_TOGETHER, sensing};
use super::network::{Abilities, Network, TIMED};
use super::potential::PairPotential;
use super::simulation::{Continuous, Simulation};
use super::source::Source;
use super::start::{Needs, Start, problem};
use super::stepped::{Arrangement, Stepped, read_step};
use super::switching::Switching;
use super::turns::Turns;
use models::double_integrator::{
    self, Flock, HeadingDifference, HeadingLaw, InputError, State, SwitchingFlock, VelocityLaw, heading,
};
use motion::{Sensing, VectorField};

/// What a heading difference may mean.
pub(super) const READINGS: [(&str, HeadingDifference); 3] = [
    ("raw", HeadingDifference::Raw),
    ("wrapped", HeadingDifference::Wrapped),
    ("unwrapped", HeadingDifference::Unwrapped),
];

/// A run of either model as it is described.
pub(super) struct Aligned {
    start: Start,
    network: Network,
    potential: PairPotential,
    /// Of heading alignment, what a heading difference means.
    headings: Option<HeadingDifference>,
    step: Option<f64>,
}

impl Aligned {
    /// Reads either model.
    pub fn read(source: &Source, headings: bool) -> Result<Self, ConfigError> {
        let start = Start::read(source, Needs { dimension: 2, velocities: true, phases: false })?;
        let model = if headings { "heading-alignment" } else { "velocity-alignment" };
        let can = Abilities {
            model,
            positions: true,
            directed: false,
            edges: true,
            weighted: false,
            timed: true,
            default: None,
        };
        let network = Network::read(source, start.agents(), can)?;
        let step = read_step(source, &network)?;
        let law = source.needed("law")?;
        let mut keys = PairPotential::KEYS.to_vec();
        keys.extend(headings.then_some("heading_difference"));
        law.allow(&keys, &format!(" of the {model} model"))?;
        let potential = PairPotential::read(&law)?;
        start.refuse_coincident(source)?;
        let reading = || law.get("heading_difference").map_or(Ok(HeadingDifference::Raw), |e| e.choice(&READINGS));
        Ok(Aligned { headings: headings.then(reading).transpose()?, start, network, potential, step })
    }
}

impl Described for Aligned {
    fn exact(&self) -> ExactMotion {
        if self.network.next_time().is_some() {
            return ExactMotion::Other(TIMED);
        }
        let radius = self.network.exact_radius().cloned();
        if self.headings.is_some() && radius.is_some() {
            return ExactMotion::Other("heading alignment is enclosed on networks that do not switch");
        }
        ExactMotion::Velocities {
            positions: self.start.positions.clone(),
            velocities: self.start.velocities.clone(),
            potential: self.potential.exact().clone(),
            pairs: self.network.pairs().to_vec(),
            radius,
            headings: self.headings,
        }
    }

    fn simulation(self: Box<Self>, source: &Source, tolerance: f64) -> Result<Built, ConfigError> {
        let Aligned { start, mut network, potential, headings, step } = *self;
        let (positions, velocities) = (start.flat_positions(), start.flat_velocities());
        network.settle(&positions, &velocities);
        let mut list = [positions, velocities].concat();
        let state = state_of(start.agents(), &list);
        let alignment = match headings {
            None => Alignment::Velocities,
            Some(reading) => {
                for (v, agent) in state.velocities.iter().zip(1..) {
                    list.push(heading(v).map_err(|_| problem(source, "velocities", Problem::NoHeading(agent)))?);
                }
                Alignment::Headings(Turns::new(reading, &list[4 * start.agents()..], network.pairs()))
            }
        };
        for &(i, j) in network.pairs() {
            let s = PLANE.square(&state.separation(i, j));
            let value = potential.value(&s).ok().filter(|value| value.is_finite());
            let slope = potential.slope(&s).ok().filter(|slope| slope.is_finite());
            if value.and(slope).is_none() {
                return Err(problem(source, "positions", Problem::Potential(i + 1, j + 1)));
            }
        }
        let agents = Agents { network, potential, alignment, count: start.agents(), drawn: start.drawn };
        if let (Alignment::Velocities, Some(radius)) = (&agents.alignment, agents.network.radius()) {
            return Ok((within(source, agents, (radius, &state), step, tolerance)?, None));
        }
        if let (Some(sensing), None, true) = (sensing(&agents.network), step, agents.count > MOST_TOGETHER) {
            let law = HeadingLaw::new(agents.potential.exact(), headings.unwrap_or(HeadingDifference::Raw));
            let flock = Individual::<_, _, 1, 3>::new(agents, law, sensing, list, tolerance);
            return Ok((Box::new(flock.map_err(|error| problem(source, "positions", error.into()))?), None));
        }
        let simulation: Box<dyn Simulation> = match step {
            Some(step) => Box::new(Stepped::settled(agents, list, step)),
            None => Box::new(Continuous::new(agents, &list, tolerance)),
        };
        Ok((simulation, None))
    }
}

/// Velocity alignment within a radius: in fixed steps, in individual steps, or all together as a Filippov solution.
fn within(
    source: &Source,
    agents: Agents,
    (radius, state): (f64, &State<f64>),
    step: Option<f64>,
    tolerance: f64,
) -> Result<Box<dyn Simulation>, ConfigError> {
    let law = source.needed("law")?;
    let refuse = |what: Problem| problem(source, "positions", what);
    let potential = agents.potential.exact().clone();
    if step.is_none() && agents.count <= MOST_TOGETHER {
        let network = double_integrator::Network::Within(radius);
        let flock = Flock::new(double_integrator::Alignment::Velocity, potential, network, state.clone());
        return Ok(Box::new(Switching::new(agents, flock.map_err(|error| refuse(error.into()))?, tolerance)));
    }
    let mut field = SwitchingFlock::new(&potential, radius).map_err(|error| law.problem(error.into()))?;
    let list = field.start(state).map_err(|error| refuse(error.into()))?;
    let Some(step) = step else {
        if !agents.potential.value(&(radius * radius)).is_ok_and(f64::is_finite) {
            return Err(refuse(InputError::PotentialAtRadius(radius).into()));
        }
        let flock = Individual::<_, _, 0, 2>::new(
            agents,
            VelocityLaw::new(&potential),
            Sensing::Within(radius),
            list,
            tolerance,
        );
        return Ok(Box::new(flock.map_err(|error| refuse(error.into()))?));
    };
    let rate = move |_: &mut Agents, time: f64, list: &[f64], rate: &mut [f64]| {
        field.rate(time, list, rate);
        field.take_failure().map_or(Ok(()), |error| Err(RunError::Large { time, error }))
    };
    let arrangement = Arrangement { widths: &[2, 2], radius };
    Ok(Box::new(Stepped::new(agents, list, step, Box::new(rate)).arranged(arrangement)))
}
