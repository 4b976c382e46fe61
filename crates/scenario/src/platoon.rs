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
use models::platoon::{Communication, CommunicationGraph, Gains};
use num_traits::Signed;

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
    graph: CommunicationGraph,
    tracking: String,
    gains: Gains<f64>,
    spacing: f64,
    drawn: Option<String>,
}

const COMMUNICATIONS: [(&str, Communication); 2] =
    [("front", Communication::Front), ("front-and-back", Communication::FrontAndBack)];

/// A run of a platoon as it is described.
pub(super) struct PlatoonRun {
    start: Start,
    gains: (Rational, Rational),
    spacing: Rational,
    /// Amplitude and angular frequency of the leader's swing.
    swing: (Rational, Rational),
    /// The agents from 0: the leader, then the followers.
    order: Vec<usize>,
    graph: CommunicationGraph,
    tracking: String,
}

impl PlatoonRun {
    /// Reads the model.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        let start = Start::read(source, Needs { dimension: 1, velocities: true, phases: false })?;
        let law = source.needed("law")?;
        law.allow(&["f", "g", "spacing", "communication", "leader"], " of the platoon model")?;
        let negative = |key: &'static str| {
            let entry = law.need(key, "a number below 0")?;
            let gain = entry.finite()?;
            if gain.is_negative() { Ok(gain) } else { Err(entry.range("a number below 0")) }
        };
        let gains = (negative("f")?, negative("g")?);
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
        let (graph, tracking) = tracked(source, &law, &order)?;
        Ok(PlatoonRun { start, gains, spacing, swing, order, graph, tracking })
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
            gains: self.gains.clone(),
            spacing: self.spacing.clone(),
            graph: self.graph.clone(),
            swing: self.swing.clone(),
        }
    }

    fn simulation(self: Box<Self>, _: &Source, tolerance: f64) -> Result<Built, ConfigError> {
        let (positions, velocities) = (self.start.flat_positions(), self.start.flat_velocities());
        let gains = Gains { f: float(&self.gains.0), g: float(&self.gains.1) };
        let (spacing, order) = (float(&self.spacing), self.order);
        let place = positions[order[0]] + spacing * order[0] as f64;
        let (amplitude, frequency) = (float(&self.swing.0), float(&self.swing.1));
        let leader = Leader { place, speed: velocities[order[0]], amplitude, frequency };
        let deviations = order[1..].iter().map(|&k| positions[k] + spacing * k as f64);
        let state: Vec<f64> = deviations.chain(order[1..].iter().map(|&k| velocities[k])).collect();
        let (graph, tracking, drawn) = (self.graph, self.tracking, self.start.drawn);
        let platoon = Platoon { leader, order, graph, tracking, gains, spacing, drawn };
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

/// Who keeps track of whom; the agents from 0, the leader first.
fn tracked(source: &Source, law: &Section, order: &[usize]) -> Result<(CommunicationGraph, String), ConfigError> {
    let cars = order.len();
    let communication = law.get("communication");
    let Some(section) = source.section("graph")? else {
        let chosen = communication.as_ref().map_or(Ok(Communication::FrontAndBack), |e| e.choice(&COMMUNICATIONS))?;
        let graph = CommunicationGraph::of(chosen, cars - 1).map_err(|error| law.problem(error.into()))?;
        let words = match chosen {
            Communication::Front => "every follower tracks the car in front (1)",
            Communication::FrontAndBack => {
                "every follower tracks the cars in front and behind with weights 1/2, the last one the car in front (2)"
            }
        };
        return Ok((graph, words.to_string()));
    };
    if let Some(entry) = communication {
        return Err(entry.problem(Problem::Both("communication", "[graph]")));
    }
    let can =
        Abilities { model: "platoon", positions: false, directed: true, edges: true, timed: false, default: None };
    let network = Network::read(source, cars, can)?;
    let mut places = vec![0; cars];
    order.iter().zip(0..).for_each(|(&agent, place)| places[agent] = place);
    let rows: Vec<Vec<usize>> =
        order[1..].iter().map(|&k| network.neighbours(k).iter().map(|&j| places[j]).collect()).collect();
    let graph = CommunicationGraph::with_equal_weights(&rows).map_err(|error| section.problem(error.into()))?;
    let words = format!(
        "every follower compares itself with the mean of its neighbours in the {}; the leader senses nobody",
        network.declaration()
    );
    Ok((graph, words))
}

impl Law for Platoon {
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError> {
        let (positions, velocities) = state.split_at(state.len() / 2);
        let (y, u) = self.leader.at(time);
        let accelerations = self.graph.accelerations(&self.gains, (&y, &u), positions, velocities);
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
        let followers = 1..=self.graph.followers();
        let agent = |place: usize| self.order[place];
        followers
            .flat_map(|k| self.graph.tracked_by(k).iter().map(move |(other, _)| (agent(k), agent(*other))))
            .collect()
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
                "platoon of Veerman and others: y_k'' = f e_k + g e_k' with f = {}, g = {}, e_k the deviation of follower k from the mean of the cars it tracks, y_k = x_k - h_k, h_k = -{} (k - 1)",
                self.gains.f, self.gains.g, self.spacing
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
    /// A number of the leader and those of the followers, by agents.
    fn by_agents(&self, leader: f64, followers: &[f64]) -> Vec<f64> {
        let mut all = vec![leader; self.order.len()];
        self.order[1..].iter().zip(followers).for_each(|(&agent, x)| all[agent] = *x);
        all
    }
}
