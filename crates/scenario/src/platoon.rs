//! Platoons on a line behind a leader (Veerman and others), on any fixed communication graph.

use super::described::{Built, Described};
use super::error::{ConfigError, Problem};
use super::exact::ExactMotion;
use super::model::Model;
use super::network::{Abilities, Network};
use super::observables::{Observable, observe};
use super::simulation::{Continuous, Frame, Law};
use super::source::{Section, Source};
use super::start::{Needs, Start, float};
use super::view::{Law as Measured, Links, Rows, View};
use arithmetic::{ArithmeticError, Rational, rational};
use models::platoon::{Communication, CommunicationGraph, Gains, Line, LineError, Parameter, Platoon as Steered};

/// How the leader moves: `x_1(t) = place + speed t + amplitude cos(frequency t)`.
struct Leader {
    place: f64,
    speed: f64,
    amplitude: f64,
    frequency: f64,
}

impl Leader {
    /// Deviation from the desired position, which is 0 at rest, and its rate.
    fn at(&self, time: f64) -> (f64, f64) {
        let (sin, cos) = (self.frequency * time).sin_cos();
        let position = self.place + self.speed * time + self.amplitude * cos;
        (position, self.speed - self.amplitude * self.frequency * sin)
    }
}

/// A platoon; states are deviations and rates of the followers.
struct Platoon {
    leader: Leader,
    /// The agents from 0: the leader, then the followers.
    order: Vec<usize>,
    steered: Steered<f64>,
    tracking: String,
    spacing: f64,
    drawn: Option<String>,
}

const COMMUNICATIONS: [(&str, Communication); 2] =
    [("front", Communication::Front), ("front-and-back", Communication::FrontAndBack)];

/// A run of a platoon as it is described.
pub(super) struct PlatoonRun {
    start: Start,
    spacing: Rational,
    /// Amplitude and angular frequency of the leader's swing.
    swing: (Rational, Rational),
    /// The agents from 0: the leader, then the followers.
    order: Vec<usize>,
    steered: Steered<Rational>,
    tracking: String,
}

impl PlatoonRun {
    /// Reads the model.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        let start = Start::read(source, Needs { dimension: 1, velocities: true, phases: false })?;
        let law = source.needed("law")?;
        let sides = Parameter::NAMES.map(|(name, _)| name);
        law.allow(&[&sides[..], &["spacing", "communication", "leader"]].concat(), " of the platoon model")?;
        let spacing = match law.get("spacing") {
            None => rational(1, 1),
            Some(entry) => {
                entry.positive()?;
                entry.exact()?
            }
        };
        let none = || rational(0, 1);
        let swing = match law.get("leader") {
            None => (none(), none()),
            Some(entry) => {
                let leader = entry.table("law.leader")?;
                leader.allow(&["agent", "amplitude", "frequency"], "")?;
                match (leader.get("amplitude"), leader.get("frequency"), leader.get("agent")) {
                    (None, None, Some(_)) => (none(), none()),
                    (_, None, _) => (none(), leader.need("frequency", "a number in radians a second")?.finite()?),
                    (_, Some(entry), _) => (leader.exact_or("amplitude", 1)?, entry.finite()?),
                }
            }
        };
        let cars = start.positions.len();
        let first = leader_of(source, &law, cars)?;
        let order: Vec<usize> = std::iter::once(first).chain((0..cars).filter(|k| *k != first)).collect();
        let (steered, tracking) = steered(source, &law, &order)?;
        Ok(PlatoonRun { start, spacing, swing, order, steered, tracking })
    }
}

impl Described for PlatoonRun {
    fn exact(&self) -> ExactMotion {
        if self.order.first().is_some_and(|leader| *leader > 0) {
            return ExactMotion::Other("another leader than the first car is not enclosed");
        }
        let places = self.start.positions.iter().flatten().zip(0..);
        ExactMotion::Platoon {
            deviations: places.map(|(x, k)| x + &self.spacing * rational(k, 1)).collect(),
            rates: self.start.velocities.iter().flatten().cloned().collect(),
            platoon: self.steered.clone(),
            spacing: self.spacing.clone(),
            swing: self.swing.clone(),
        }
    }

    fn simulation(self: Box<Self>, _: &Source, tolerance: f64) -> Result<Built, ConfigError> {
        let (positions, velocities) = (self.start.flat_positions(), self.start.flat_velocities());
        let (spacing, order) = (float(&self.spacing), self.order);
        let place = positions[order[0]] + spacing * order[0] as f64;
        let (amplitude, frequency) = (float(&self.swing.0), float(&self.swing.1));
        let leader = Leader { place, speed: velocities[order[0]], amplitude, frequency };
        let deviations = order[1..].iter().map(|&k| positions[k] + spacing * k as f64);
        let state: Vec<f64> = deviations.chain(order[1..].iter().map(|&k| velocities[k])).collect();
        let (steered, tracking, drawn) = (self.steered.map(float), self.tracking, self.start.drawn);
        let platoon = Platoon { leader, order, steered, tracking, spacing, drawn };
        Ok((Box::new(Continuous::new(platoon, &state, tolerance)), None))
    }
}

/// The agent that leads, from 0; the first one unless `law.leader` has another.
fn leader_of(source: &Source, law: &Section, cars: usize) -> Result<usize, ConfigError> {
    let leader = law.get("leader").map(|entry| entry.table("law.leader")).transpose()?;
    let Some(entry) = leader.and_then(|leader| leader.get("agent")) else { return Ok(0) };
    let agent = entry.count(1, cars)?;
    if agent > 1 && source.section("graph")?.is_none() {
        return Err(entry.range("1: without [graph] the car in front leads"));
    }
    Ok(agent - 1)
}

/// Who keeps track of whom with which gains, and that in words; the agents from 0, the leader first.
fn steered(source: &Source, law: &Section, order: &[usize]) -> Result<(Steered<Rational>, String), ConfigError> {
    let (cars, line) = (order.len(), line(law)?);
    let refuse = |error: LineError| match error.parameter().and_then(|parameter| law.get(parameter.name())) {
        Some(entry) => entry.problem(error),
        None => law.problem(error.into()),
    };
    let communication = law.get("communication");
    let Some(section) = source.section("graph")? else {
        let chosen = communication.as_ref().map_or(Ok(Communication::FrontAndBack), |e| e.choice(&COMMUNICATIONS))?;
        let (built, words) = match chosen {
            Communication::Front => {
                let graph = CommunicationGraph::of(chosen, cars - 1).map_err(LineError::from);
                (graph.and_then(|graph| line.on(graph)), "every follower tracks the car in front (1)".to_string())
            }
            Communication::FrontAndBack => (line.platoon(cars - 1), on_both_sides(&line)),
        };
        return built.map(|built| (built, words)).map_err(refuse);
    };
    if let Some(entry) = communication {
        return Err(entry.problem(Problem::Both("communication", "[graph]")));
    }
    let can = Abilities {
        model: "platoon",
        positions: false,
        directed: true,
        edges: true,
        weighted: true,
        timed: false,
        default: None,
    };
    let network = Network::read(source, cars, can)?;
    let mut places = vec![0; cars];
    order.iter().zip(0..).for_each(|(&agent, place)| places[agent] = place);
    let row = |agent: usize| {
        let own: Vec<(usize, Rational)> = network.weighted(agent).map(|(j, weight)| (places[j], weight)).collect();
        let sum: Rational = own.iter().map(|(_, weight)| weight).sum();
        own.into_iter().map(|(place, weight)| (place, weight / &sum)).collect()
    };
    let rows: Vec<Vec<(usize, Rational)>> = order[1..].iter().map(|&agent| row(agent)).collect();
    let graph = CommunicationGraph::new(rows).map_err(|error| section.problem(error.into()))?;
    let mean = if network.is_weighted() { "mean, with their weights," } else { "mean" };
    let words = format!(
        "every follower compares itself with the {mean} of its neighbours in the {}; the leader senses nobody",
        network.declaration()
    );
    Ok((line.on(graph).map_err(refuse)?, words))
}

/// Gains and weights: for each one number, or a list of one for each follower.
fn line(law: &Section) -> Result<Line, ConfigError> {
    let mut line = Line::default();
    for (name, parameter) in Parameter::NAMES {
        let Some(entry) = law.get(name) else { continue };
        line = line.with(parameter, entry.one_or_each()?);
    }
    Ok(line)
}

/// A line of cars in words.
fn on_both_sides(line: &Line) -> String {
    if !line.is_asymmetric() {
        return "every follower tracks the cars in front and behind with weights 1/2, the last one the car in front (2)"
            .to_string();
    }
    let side = |(name, parameter): (&str, Parameter)| {
        let list = line.get(parameter).filter(|_| parameter.is_of_a_side())?;
        Some(format!("{name} = {}", shown(list)))
    };
    let given: Vec<String> = Parameter::NAMES.into_iter().filter_map(side).collect();
    format!(
        "every follower tracks the cars in front and behind with {}; weights are scaled to a sum of one for each car, numbers below 0 are gains of the links; the last car tracks the one in front",
        given.join(", ")
    )
}

/// One number, or a list.
fn shown(list: &[Rational]) -> String {
    match list {
        [one] => one.to_string(),
        several => format!("[{}]", several.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
    }
}

impl Law for Platoon {
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError> {
        let (positions, velocities) = state.split_at(state.len() / 2);
        let (y, u) = self.leader.at(time);
        let accelerations = self.steered.accelerations((&y, &u), positions, velocities);
        let rates = velocities.iter().copied().chain(accelerations);
        rate.iter_mut().zip(rates).for_each(|(rate, value)| *rate = value);
        Ok(())
    }

    fn frame(&self, time: f64, state: &[f64]) -> Frame {
        let (positions, velocities) = state.split_at(state.len() / 2);
        let (y, u) = self.leader.at(time);
        let place = |(y, k): (f64, u32)| vec![y - self.spacing * f64::from(k)];
        Frame {
            positions: self.by_agents(y, positions).into_iter().zip(0..).map(place).collect(),
            velocities: self.by_agents(u, velocities).into_iter().map(|u| vec![u]).collect(),
            ..Frame::default()
        }
    }

    fn links(&self) -> Vec<(usize, usize)> {
        let agent = |place: usize| self.order[place];
        self.steered.links().into_iter().map(|(k, other)| (agent(k), agent(other))).collect()
    }

    fn observe(&self, time: f64, state: &[f64]) -> Result<Vec<Observable>, ArithmeticError> {
        let (positions, _) = state.split_at(state.len() / 2);
        let Frame { positions: places, velocities, .. } = self.frame(time, state);
        let (cars, spacing) = (self.order.len(), self.spacing);
        let deviations = self.by_agents(self.leader.at(time).0, positions);
        let view = View {
            positions: Rows::of(cars, || places),
            velocities: Rows::of(cars, || velocities),
            law: Measured::Cars { deviations, leader: self.order[0], spacing },
            ..View::new(Model::Platoon, Links::These(cars, self.links().into()))
        };
        observe(&view, &[])
    }

    fn declaration(&self) -> Vec<String> {
        let Leader { place, speed, amplitude, frequency } = &self.leader;
        let (agent, shift) = (self.order[0] + 1, self.spacing * self.order[0] as f64);
        let mut lines = vec![
            format!(
                "platoon of Veerman and others: y_k'' = f e_k + g e_k' with {}, e_k the deviation of follower k from the mean of the cars it tracks, y_k = x_k - h_k, h_k = -{} (k - 1)",
                self.gains(), self.spacing
            ),
            self.tracking.clone(),
            format!("agent {agent} is the leader: x_{agent}(t) = {} + {speed} t + {amplitude} cos({frequency} t); at t = 0 it is at {}", place - shift, place - shift + amplitude),
            "observables: gaps x_k - x_(k+1) of successive cars (min_gap, max_gap); deviations of the y_k from that of the leader (largest in size; of the last car, the one with the largest number: 0 if it leads); disagreement sqrt(sum |v_k - mean|²) with the leader; min_distance over all pairs; components of the communication graph".to_string(),
        ];
        lines.extend(self.drawn.clone());
        lines
    }
}

impl Platoon {
    /// The gains in words, those of each follower where they differ.
    fn gains(&self) -> String {
        let gains = self.steered.gains();
        let list = |name: &str, own: fn(&Gains<f64>) -> f64| match gains {
            [first, rest @ ..] if rest.iter().all(|other| own(other) == own(first)) => {
                format!("{name} = {}", own(first))
            }
            _ => format!("{name}_k = {:?}", gains.iter().map(own).collect::<Vec<_>>()),
        };
        format!("{}, {}", list("f", |gains| gains.f), list("g", |gains| gains.g))
    }

    /// A number of the leader and those of the followers, by agents.
    fn by_agents(&self, leader: f64, followers: &[f64]) -> Vec<f64> {
        let mut all = vec![leader; self.order.len()];
        self.order[1..].iter().zip(followers).for_each(|(&agent, x)| all[agent] = *x);
        all
    }
}
