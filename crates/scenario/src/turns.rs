//! What `theta_i - theta_j` means in the heading law, with the jumps of the readings held between switches.

use super::links::Guard;
use super::network::Pair;
use models::double_integrator::HeadingDifference;
use motion::whole_turns;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// A reading of heading differences, for headings that are followed continuously.
#[derive(Debug, Clone)]
pub(super) struct Turns {
    reading: HeadingDifference,
    /// For the raw reading the whole turns of each agent.
    agents: Vec<i64>,
    /// For the wrapped one those of the linked pairs.
    pairs: BTreeMap<Pair, i64>,
}

impl Turns {
    /// The reading at the start, where headings are in `(-pi, pi]`.
    pub fn new(reading: HeadingDifference, headings: &[f64], links: &[Pair]) -> Self {
        let mut turns = Turns { reading, agents: vec![0; headings.len()], pairs: BTreeMap::new() };
        turns.update(headings, links);
        turns
    }

    /// Whether the reading jumps anywhere.
    pub fn switch(&self) -> bool {
        self.reading != HeadingDifference::Unwrapped
    }

    /// `theta_i - theta_j` as read.
    pub fn difference(&self, headings: &[f64], i: usize, j: usize) -> f64 {
        let turns = match self.reading {
            HeadingDifference::Unwrapped => 0,
            HeadingDifference::Raw => self.agents[i] - self.agents[j],
            HeadingDifference::Wrapped => match self.pairs.get(&(i.min(j), i.max(j))) {
                None => 0,
                Some(turns) if i < j => *turns,
                Some(turns) => -turns,
            },
        };
        headings[i] - headings[j] - TAU * turns as f64
    }

    /// What may fail, so that the reading jumps, while no heading moves by more than `moved`: no heading, or difference of linked agents,
    /// leaves `(-pi, pi]`, up to rounding. The headings are the last part of the state.
    pub fn guards(&self, state: &[f64], moved: &[f64], links: &[Pair]) -> Vec<Guard> {
        let first = state.len() - self.agents.len();
        let (headings, moved) = (&state[first..], &moved[first..]);
        let slack = slack(headings) + slack(moved);
        let guard = |component: usize, less: Option<usize>, turns: i64| {
            let angle = headings[component] - less.map_or(0.0, |j| headings[j]) - TAU * turns as f64;
            let reach = moved[component] + less.map_or(0.0, |j| moved[j]);
            let (component, less, offset) = (first + component, less.map(|j| first + j), TAU * turns as f64);
            (PI - angle.abs() <= reach + slack).then_some(Guard::HalfTurn { component, less, offset, slack })
        };
        match self.reading {
            HeadingDifference::Unwrapped => Vec::new(),
            HeadingDifference::Raw => (0..headings.len()).filter_map(|k| guard(k, None, self.agents[k])).collect(),
            HeadingDifference::Wrapped => {
                let turns = |pair| self.pairs.get(pair).copied().unwrap_or(0);
                links.iter().filter_map(|pair| guard(pair.0, Some(pair.1), turns(pair))).collect()
            }
        }
    }

    /// Counts the turns whose jump has come; the difference of a new pair is reduced to `(-pi, pi]`.
    pub fn update(&mut self, headings: &[f64], links: &[Pair]) {
        let due = PI + slack(headings) / 2.0;
        let jump = |angle: f64| i64::from(angle > due) - i64::from(angle < -due);
        match self.reading {
            HeadingDifference::Unwrapped => {}
            HeadingDifference::Raw => {
                for (turns, heading) in self.agents.iter_mut().zip(headings) {
                    *turns += jump(heading - TAU * *turns as f64);
                }
            }
            HeadingDifference::Wrapped => {
                let before = std::mem::take(&mut self.pairs);
                let turns = |pair: &Pair| {
                    let difference = headings[pair.0] - headings[pair.1];
                    match before.get(pair) {
                        Some(turns) => turns + jump(difference - TAU * *turns as f64),
                        None => whole_turns(difference) as i64,
                    }
                };
                self.pairs = links.iter().map(|pair| (*pair, turns(pair))).collect();
            }
        }
    }

    /// The reading in words.
    pub fn declaration(&self) -> &'static str {
        match self.reading {
            HeadingDifference::Raw => {
                "theta_i - theta_j is raw: the difference of two headings in (-pi, pi]; it jumps by 2 pi where a heading passes pi (located)"
            }
            HeadingDifference::Wrapped => {
                "theta_i - theta_j is wrapped: reduced to (-pi, pi]; it jumps by 2 pi where linked agents move in opposite directions (located)"
            }
            HeadingDifference::Unwrapped => {
                "theta_i - theta_j is unwrapped: headings are followed continuously from the start"
            }
        }
    }
}

/// What rounding may do to an angle, many times over.
fn slack(headings: &[f64]) -> f64 {
    64.0 * f64::EPSILON * headings.iter().fold(PI, |most: f64, theta| most.max(theta.abs()))
}

#[cfg(test)]
mod tests {
    use super::Turns;
    use models::double_integrator::HeadingDifference::{Raw, Wrapped};
    use motion::Margin;

    /// The least of all that holds, where the headings may move anywhere.
    fn margin(turns: &Turns, headings: &[f64], links: &[(usize, usize)]) -> f64 {
        let guards = turns.guards(headings, &[10.0; 2], links);
        guards.iter().map(|guard| guard.value(&|c| headings[c])).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn jumps_are_counted_where_the_readings_have_them() {
        let links = [(0, 1)];
        let mut raw = Turns::new(Raw, &[3.0, -3.0], &links);
        assert_eq!(raw.difference(&[3.0, -3.0], 0, 1), 6.0);
        assert!(margin(&raw, &[3.2, -3.0], &[]) < 0.0);
        raw.update(&[3.2, -3.0], &links);
        assert!((raw.difference(&[3.2, -3.0], 0, 1) + 0.083_185_307).abs() < 1e-8);
        let mut wrapped = Turns::new(Wrapped, &[3.0, -3.0], &links);
        assert!((wrapped.difference(&[3.0, -3.0], 0, 1) + 0.283_185_307).abs() < 1e-8);
        assert!((wrapped.difference(&[3.0, -3.0], 1, 0) - 0.283_185_307).abs() < 1e-8);
        // The difference goes on continuously until it has left (-pi, pi].
        assert!(margin(&wrapped, &[3.0, -0.2], &links) > 0.0 && margin(&wrapped, &[3.0, 0.1], &links) < 0.0);
        wrapped.update(&[3.0, 0.1], &links);
        assert!((wrapped.difference(&[3.0, 0.1], 0, 1) - 2.9).abs() < 1e-12);
        // Far from a jump nothing is watched, and a pair that parts and meets again is read anew.
        assert!(wrapped.guards(&[3.0, 0.1], &[0.1; 2], &links).is_empty());
        wrapped.update(&[3.0, 0.1], &[]);
        wrapped.update(&[9.5, 0.1], &links);
        assert!((wrapped.difference(&[9.5, 0.1], 0, 1) - 9.4 + std::f64::consts::TAU).abs() < 1e-12);
    }
}
