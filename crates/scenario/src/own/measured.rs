//! What is shown and measured of agents with a law of one's own.

use crate::model::Model;
use crate::network::Network;
use crate::observables::{Observable, Value, observe as general};
use crate::simulation::{Frame, Part};
use crate::view::{Rows, View};
use arithmetic::Complex;
use expressions::{Blocks, Fault, Hearing, Kind, Law};

/// Orders that are measured of an angle.
const ORDERS: u32 = 4;

/// A network as the law hears it.
pub(super) struct Heard<'a>(pub &'a Network);

impl Hearing for Heard<'_> {
    fn agents(&self) -> usize {
        self.0.order()
    }

    fn heard(&self, agent: usize) -> Option<&[usize]> {
        if self.0.is_all_to_all() { None } else { Some(self.0.neighbours(agent)) }
    }
}

/// The rows of a part of the state.
fn rows(law: &Law, name: &str, state: &[f64]) -> Vec<Vec<f64>> {
    let variable = law.variables().iter().find(|variable| variable.name == name);
    let row = |agent: usize| {
        variable.map_or_else(Vec::new, |variable| {
            let from = variable.start + agent * variable.width;
            state[from..from + variable.width].to_vec()
        })
    };
    (0..law.agents()).map(row).collect()
}

/// Where the agents are, with every part of the state by its name.
pub(super) fn frame(law: &Law, state: &[f64]) -> Frame {
    let mut frame = Frame::default();
    if let Some(position) = law.position() {
        // Pictures are of the plane.
        frame.positions =
            rows(law, &position.name, state).into_iter().map(|row| row.into_iter().take(2).collect()).collect();
    }
    for variable in law.variables() {
        let list = rows(law, &variable.name, state);
        if variable.name == "v" && variable.width == 2 {
            frame.velocities = list.clone();
        }
        let own = if variable.kind == Kind::Vector {
            Part::Vectors(list)
        } else {
            let numbers = list.concat();
            if variable.kind == Kind::Angle && frame.phases.is_empty() {
                frame.phases = numbers.clone();
            }
            Part::Numbers(numbers)
        };
        frame.own.push((variable.name.clone(), own));
    }
    if frame.positions.is_empty() && frame.phases.is_empty() {
        // Somebody is there, though nowhere.
        frame.phases = law.variables().first().map_or(Vec::new(), |first| rows(law, &first.name, state).concat());
    }
    frame
}

/// The general observables, then those of the law.
pub(super) fn observe(
    law: &Law,
    network: &Network,
    (blocks, time): (&mut Blocks, f64),
    state: &[f64],
) -> Result<Vec<Observable>, Fault> {
    let of = |name: &str| rows(law, name, state);
    let (mut positions, mut velocities, mut phases) = (Vec::new(), Vec::new(), Vec::new());
    if let Some(position) = law.position() {
        positions = of(&position.name);
    }
    if law.variables().iter().any(|variable| variable.name == "v" && variable.kind != Kind::Angle) {
        velocities = of("v");
    }
    if let Some(angle) = law.variables().iter().find(|variable| variable.kind == Kind::Angle) {
        phases = of(&angle.name).concat();
    }
    let view = View {
        positions: Rows::of(positions.len(), || positions),
        velocities: Rows::of(velocities.len(), || velocities),
        phasors: phases.iter().map(|theta| Complex::new(theta.cos(), theta.sin())).collect(),
        orders: ORDERS.min(phases.len() as u32),
        ..View::new(Model::Own, network.shown())
    };
    let mut all = general(&view, &["min_distance", "components", "disagreement", "order"]).unwrap_or_default();
    all.retain(|observable| law.observables().iter().all(|(own, _)| *own != observable.name));
    let mut numbers = blocks.observe(time, state, &Heard(network))?.into_iter();
    for (name, count) in law.observables() {
        let values: Vec<f64> = numbers.by_ref().take(*count).collect();
        all.push(match values[..] {
            [one] => Observable::new(name.clone(), Value::Number(one)),
            _ => Observable::new(name.clone(), Value::List(values)),
        });
    }
    Ok(all)
}

/// A fault in words.
pub(super) fn in_words(law: &Law, fault: &Fault) -> String {
    format!("`{}` {fault}", law.name_of(fault))
}
