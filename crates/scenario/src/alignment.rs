//! Heading and velocity alignment of Tanner and others, on fixed and distance-switched networks.

use super::course::{Continuous, Course, Frame, Law};
use super::error::{ConfigError, Problem, RunError};
use super::links::Hold;
use super::network::{Abilities, Change, Network};
use super::observables::{Observable, min_distance, total};
use super::potential::PairPotential;
use super::source::Source;
use super::start::{Needs, Start, problem};
use super::stepped::{Stepped, read_step};
use super::switching::Switching;
use super::turns::Turns;
use arithmetic::ArithmeticError;
use models::double_integrator::{
    self, Coordinates, Flock, HeadingDifference, Pair, State, SwitchingFlock, Vector, disagreement, gyroscopic,
    heading, heading_rate, heading_spread, kinetic_energy, potential_energy, potential_gradients, saturated_potential,
    velocity_alignment,
};
use motion::VectorField;

/// Most agents whose velocity alignment within a radius is followed as a Filippov solution: each pair is looked at.
const MOST_LOCATED: usize = 4096;

const PLANE: Coordinates = Coordinates::Cartesian;

/// What aligns the agents.
enum Alignment {
    /// Equation (4) of the second paper.
    Velocities,
    /// Equations (4) and (5) of the first paper; the headings are states too.
    Headings(Turns),
}

/// Agents with accelerations.
pub(super) struct Agents {
    network: Network,
    potential: PairPotential,
    alignment: Alignment,
    count: usize,
    drawn: Option<String>,
}

const READINGS: [(&str, HeadingDifference); 3] = [
    ("raw", HeadingDifference::Raw),
    ("wrapped", HeadingDifference::Wrapped),
    ("unwrapped", HeadingDifference::Unwrapped),
];

/// Reads either model.
pub(super) fn read(source: &Source, headings: bool, tolerance: f64) -> Result<Box<dyn Course>, ConfigError> {
    let start = Start::read(source, Needs { dimension: 2, velocities: true, phases: false })?;
    let model = if headings { "heading-alignment" } else { "velocity-alignment" };
    let located = !headings && source.needed("run")?.get("step").is_none();
    let most_switching = if located { MOST_LOCATED } else { usize::MAX };
    let can =
        Abilities { model, positions: true, directed: false, edges: true, timed: true, most_switching, default: None };
    let mut network = Network::read(source, start.agents(), can)?;
    let step = read_step(source, &network)?;
    let law = source.needed("law")?;
    let mut keys = PairPotential::KEYS.to_vec();
    keys.extend(headings.then_some("heading_difference"));
    law.allow(&keys, &format!(" of the {model} model"))?;
    let potential = PairPotential::read(&law)?;
    start.refuse_coincident(source)?;
    let (positions, velocities) = (start.flat_positions(), start.flat_velocities());
    network.settle(&positions, &velocities);
    let mut list = [positions, velocities].concat();
    let state = state_of(start.agents(), &list);
    let alignment = if headings {
        let reading = law.get("heading_difference").map_or(Ok(HeadingDifference::Raw), |e| e.choice(&READINGS))?;
        for (v, agent) in state.velocities.iter().zip(1..) {
            list.push(heading(v).map_err(|_| problem(source, "velocities", Problem::NoHeading(agent)))?);
        }
        Alignment::Headings(Turns::new(reading, &list[4 * start.agents()..], network.pairs()))
    } else {
        Alignment::Velocities
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
        if let Some(step) = step {
            let mut field =
                SwitchingFlock::new(agents.potential.exact(), radius).map_err(|error| law.problem(error.into()))?;
            field.start(&state).map_err(|error| problem(source, "positions", error.into()))?;
            let rate = move |_: &mut Agents, time: f64, list: &[f64], rate: &mut [f64]| {
                field.rate(time, list, rate);
                field.take_failure().map_or(Ok(()), |error| Err(RunError::Large { time, error }))
            };
            return Ok(Box::new(Stepped::new(agents, list, step, Box::new(rate))));
        }
        let network = double_integrator::Network::Within(radius);
        let potential = agents.potential.exact().clone();
        let flock = Flock::new(double_integrator::Alignment::Velocity, potential, network, state);
        let flock = flock.map_err(|error| problem(source, "positions", error.into()))?;
        return Ok(Box::new(Switching::new(agents, flock, tolerance)));
    }
    Ok(match step {
        Some(step) => Box::new(Stepped::settled(agents, list, step)),
        None => Box::new(Continuous::new(agents, &list, tolerance)),
    })
}

/// The state of so many agents, from a list that may hold headings too.
fn state_of(count: usize, list: &[f64]) -> State<f64> {
    let empty = State { positions: Vec::new(), velocities: Vec::new() };
    State::from_list(count, &list[..4 * count]).unwrap_or(empty)
}

impl Agents {
    /// Sets the links.
    pub fn relink(&mut self, pairs: &[Pair]) {
        self.network.set_pairs(pairs.iter().map(|&(i, j)| (i.min(j), i.max(j))).collect());
    }

    /// The jumps of the heading differences.
    fn count_turns(&mut self, list: &[f64]) {
        if let Alignment::Headings(turns) = &mut self.alignment {
            turns.update(&list[4 * self.count..], self.network.pairs());
        }
    }

    fn state(&self, list: &[f64]) -> State<f64> {
        state_of(self.count, list)
    }

    fn headings<'a>(&self, list: &'a [f64]) -> &'a [f64] {
        &list[4 * self.count..]
    }

    fn accelerations(&self, state: &State<f64>, headings: &[f64]) -> Result<Vec<Vector<f64>>, ArithmeticError> {
        let (edges, slope) = (self.network.pairs(), |_: usize, _: usize, s: &f64| self.potential.slope(s));
        match &self.alignment {
            Alignment::Velocities => velocity_alignment(state, edges, PLANE, slope),
            Alignment::Headings(turns) => {
                let gradients = potential_gradients(&state.positions, edges, PLANE, slope)?;
                gyroscopic(state, &gradients, edges, |i, j| turns.difference(headings, i, j))
            }
        }
    }
}

impl Law for Agents {
    fn rate(&self, _: f64, list: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError> {
        let state = self.state(list);
        let accelerations = self.accelerations(&state, self.headings(list))?;
        let (velocities, rest) = rate.split_at_mut(2 * self.count);
        velocities.copy_from_slice(&list[2 * self.count..4 * self.count]);
        let (forces, turning) = rest.split_at_mut(2 * self.count);
        forces.iter_mut().zip(accelerations.iter().flatten()).for_each(|(rate, a)| *rate = *a);
        for ((rate, v), a) in turning.iter_mut().zip(&state.velocities).zip(&accelerations) {
            *rate = heading_rate(v, a)?;
        }
        Ok(())
    }

    fn switches(&self) -> bool {
        let turns = match &self.alignment {
            Alignment::Velocities => false,
            Alignment::Headings(turns) => turns.switch(),
        };
        turns || self.network.switches()
    }

    fn holds(&self, list: &[f64], moved: &[f64]) -> Vec<Hold> {
        let mut holds = self.network.holds(list, moved);
        if let Alignment::Headings(turns) = &self.alignment {
            holds.extend(turns.holds(list, moved, self.network.pairs()));
        }
        holds
    }

    fn switch(&mut self, list: &[f64]) -> Vec<Change> {
        let changes = self.network.switch(list);
        self.count_turns(list);
        changes
    }

    fn next_time(&self) -> Option<f64> {
        self.network.next_time()
    }

    fn replace(&mut self, list: &[f64]) -> Vec<Change> {
        let changes = self.network.replace();
        self.count_turns(list);
        changes
    }

    fn settle(&mut self, list: &[f64]) {
        let (positions, velocities) = list.split_at(2 * self.count);
        self.network.settle(positions, velocities);
        self.count_turns(list);
    }

    fn frame(&self, _: f64, list: &[f64]) -> Frame {
        let state = self.state(list);
        let lists = |vectors: &[Vector<f64>]| vectors.iter().map(|v| v.to_vec()).collect();
        Frame { positions: lists(&state.positions), velocities: lists(&state.velocities), ..Frame::default() }
    }

    fn observe(&self, _: f64, list: &[f64]) -> Result<Vec<Observable>, ArithmeticError> {
        let state = self.state(list);
        let places: Vec<Vec<f64>> = state.positions.iter().map(|r| r.to_vec()).collect();
        let value = |_: usize, _: usize, s: &f64| self.potential.value(s);
        let potential = potential_energy(&state.positions, self.network.pairs(), PLANE, value)?;
        let kinetic = kinetic_energy(&state.velocities, PLANE)?;
        let mut all = vec![
            Observable::number("potential", potential),
            Observable::number("kinetic", kinetic),
            Observable::number("energy", potential + kinetic),
        ];
        match &self.alignment {
            Alignment::Velocities => {
                let saturated = match self.network.radius() {
                    None => potential,
                    // All other pairs are beyond the radius.
                    Some(radius) => {
                        let beyond = self.potential.value(&(radius * radius))?;
                        saturated_potential(&state.positions, self.network.pairs(), PLANE, value, &beyond)?
                    }
                };
                all.push(Observable::number("saturated_energy", saturated + kinetic));
            }
            Alignment::Headings(_) => {
                all.push(Observable::number("heading_spread", heading_spread(self.headings(list))));
            }
        }
        all.extend([
            Observable::number("disagreement", disagreement(&state)),
            Observable::number("min_distance", min_distance(&places)),
            Observable::count("components", self.network.components()),
            Observable::list("momentum", total(state.velocities.iter().copied())),
        ]);
        Ok(all)
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = match &self.alignment {
            Alignment::Velocities => vec![
                "velocity alignment, equation (4) of Tanner and others (fixed and switching networks): dv_i/dt = -sum over j ~ i of (v_i - v_j) - grad_i V_i, unit masses".to_string(),
                "observables: potential is the sum of V_ij over the links, each once; kinetic (1/2) sum |v_i|²; energy their sum, W of (6)".to_string(),
                match self.network.radius() {
                    None => "saturated_energy Q is the energy: no pair saturates on a fixed graph".to_string(),
                    Some(radius) => format!(
                        "saturated_energy Q is kinetic plus the sum over all pairs, each once, of V at the distance, or at {radius} beyond it"
                    ),
                },
            ],
            Alignment::Headings(turns) => vec![
                "heading alignment, equations (4) and (5) of Tanner and others (part I): dv_i/dt = -grad_i V_i - sum over j ~ i of (theta_i - theta_j)/|r_ij|² (z x v_i), unit masses".to_string(),
                turns.declaration().to_string(),
                "observables: potential is the sum of V_ij over the links, each once; kinetic (1/2) sum |v_i|²; energy their sum; heading_spread the largest angle between two headings".to_string(),
            ],
        };
        lines.push(self.potential.declaration());
        lines.push(self.network.declaration().to_string());
        lines.push("disagreement sqrt(sum |v_i - mean|²); momentum the sum of the velocities".to_string());
        lines.extend(self.drawn.clone());
        lines
    }
}
