//! Headings in a law of one's own: where one passes pi it jumps, and the jump is located like a switch of links.

use crate::links::Guard;
use arithmetic::Number;
use expressions::{Blocks, Heading};
use std::f64::consts::{PI, TAU};

/// What rounding may do to a heading, many times over.
const SLACK: f64 = 256.0 * f64::EPSILON * PI;

/// The headings in a law with the directions of the agents, in radians, from which they go on smoothly.
#[derive(Debug, Default)]
pub(super) struct Headings {
    list: Vec<Heading>,
    directions: Vec<Vec<f64>>,
}

/// A heading that goes on from a direction: within half a turn of it.
fn from(direction: f64, [x, y]: [f64; 2]) -> f64 {
    let (sine, cosine) = direction.sin_cos();
    direction + (cosine * y - sine * x).atan2(cosine * x + sine * y)
}

impl Headings {
    /// Those of a law whose rates hold them.
    pub fn of(rates: &Blocks, agents: usize) -> Self {
        let list = rates.headings().to_vec();
        Headings { directions: vec![vec![0.0; agents]; list.len()], list }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Holds the headings of a state, in `(-pi, pi]`.
    pub fn settle(&mut self, state: &[f64], rates: &mut Blocks) {
        self.change(state, rates, |_, [x, y]| f64::angle(&y, &x).unwrap_or(0.0));
    }

    /// Holds the headings that have come to be, those that have passed pi a turn farther.
    pub fn go_on(&mut self, state: &[f64], rates: &mut Blocks) {
        let due = PI + SLACK / 2.0;
        self.change(state, rates, |direction, vector| match from(direction, vector) {
            heading if heading > due => heading - TAU,
            heading if heading < -due => heading + TAU,
            heading => heading,
        });
    }

    fn change(&mut self, state: &[f64], rates: &mut Blocks, new: impl Fn(f64, [f64; 2]) -> f64) {
        for (heading, directions) in self.list.iter().zip(&mut self.directions) {
            for (agent, direction) in directions.iter_mut().enumerate() {
                *direction = new(*direction, heading.places(agent).map(|place| state[place]));
            }
        }
        rates.hold(&self.directions);
    }

    /// What may fail while no component moves by more than `moved`: no heading passes pi, none is far from what is held.
    pub fn guards(&self, state: &[f64], moved: &[f64]) -> Vec<Guard> {
        let guard = |(agent, direction): (usize, &f64), heading: &Heading| {
            let places = heading.places(agent);
            let [length, way] = [state, moved].map(|list| list[places[0]].hypot(list[places[1]]));
            let guard = Guard::Heading { places, direction: *direction, slack: SLACK };
            // A vector turns by at most asin(way/length), and that is below pi/2 way/length.
            let turn = if way < length { PI / 2.0 * way / length } else { PI };
            (motion::Margin::value(&guard, &|place| state[place]) <= turn + 2.0 * SLACK).then_some(guard)
        };
        let all = self.list.iter().zip(&self.directions);
        all.flat_map(|(heading, directions)| directions.iter().enumerate().filter_map(move |own| guard(own, heading)))
            .collect()
    }
}

/// How far a heading is from pi, and from where its direction has to be held anew.
pub(crate) fn margin(direction: f64, vector: [f64; 2]) -> f64 {
    let heading = from(direction, vector);
    (PI - heading.abs()).min(0.75 * PI - (heading - direction).abs())
}
