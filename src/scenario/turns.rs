//! What `theta_i - theta_j` means in the heading law, with the jumps of the readings held between switches.

use super::network::Pair;
use crate::double_integrator::HeadingDifference;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

/// A reading of heading differences, for headings that are followed continuously.
#[derive(Debug, Clone)]
pub(super) struct Turns {
    reading: HeadingDifference,
    /// For the raw reading the whole turns of each agent.
    agents: Vec<i64>,
    /// For the wrapped one those of the pairs that have some.
    pairs: BTreeMap<Pair, i64>,
}

/// The angle modulo whole turns, in `[-pi, pi]`.
pub(super) fn unwrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

impl Turns {
    /// The reading at the start, where headings are in `(-pi, pi]`.
    pub fn new(reading: HeadingDifference, headings: &[f64]) -> Self {
        let mut turns = Turns { reading, agents: vec![0; headings.len()], pairs: BTreeMap::new() };
        if reading == HeadingDifference::Wrapped {
            for j in 0..headings.len() {
                for i in 0..j {
                    turns.wrap((i, j), headings);
                }
            }
        }
        turns
    }

    /// Sets the turns of a pair to what its headings say.
    fn wrap(&mut self, pair: Pair, headings: &[f64]) {
        let difference = headings[pair.0] - headings[pair.1];
        let turns = ((difference - HeadingDifference::Wrapped.read(unwrapped(difference))) / TAU).round();
        match turns as i64 {
            0 => self.pairs.remove(&pair),
            turns => self.pairs.insert(pair, turns),
        };
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

    /// Positive as long as no heading, or difference of linked agents, has left `(-pi, pi]`, up to rounding.
    pub fn margin(&self, headings: &[f64], links: &[Pair]) -> f64 {
        let gap = match self.reading {
            HeadingDifference::Unwrapped => f64::INFINITY,
            HeadingDifference::Raw => {
                (0..headings.len()).map(|k| PI - self.raw(headings, k).abs()).fold(f64::INFINITY, f64::min)
            }
            HeadingDifference::Wrapped => {
                let gap = |&(i, j): &Pair| PI - self.difference(headings, i, j).abs();
                links.iter().map(gap).fold(f64::INFINITY, f64::min)
            }
        };
        gap + slack(headings)
    }

    fn raw(&self, headings: &[f64], k: usize) -> f64 {
        headings[k] - TAU * self.agents[k] as f64
    }

    /// Counts the turns whose jump has come; pairs that are not linked are kept up to date.
    pub fn update(&mut self, headings: &[f64], links: &[Pair]) {
        let due = PI + slack(headings) / 2.0;
        match self.reading {
            HeadingDifference::Unwrapped => {}
            HeadingDifference::Raw => {
                for k in 0..headings.len() {
                    let raw = self.raw(headings, k);
                    self.agents[k] += i64::from(raw > due) - i64::from(raw < -due);
                }
            }
            HeadingDifference::Wrapped => {
                let late: Vec<Pair> =
                    links.iter().copied().filter(|&(i, j)| self.difference(headings, i, j).abs() > due).collect();
                for (i, j) in late {
                    let sign = self.difference(headings, i, j).signum() as i64;
                    *self.pairs.entry((i, j)).or_insert(0) += sign;
                }
                let linked: BTreeSet<Pair> = links.iter().copied().collect();
                for j in 0..headings.len() {
                    for i in (0..j).filter(|&i| !linked.contains(&(i, j))) {
                        self.wrap((i, j), headings);
                    }
                }
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
    use crate::double_integrator::HeadingDifference::{Raw, Wrapped};

    #[test]
    fn jumps_are_counted_where_the_readings_have_them() {
        let mut raw = Turns::new(Raw, &[3.0, -3.0]);
        assert_eq!(raw.difference(&[3.0, -3.0], 0, 1), 6.0);
        assert!(raw.margin(&[3.2, -3.0], &[]) < 0.0);
        raw.update(&[3.2, -3.0], &[]);
        assert!((raw.difference(&[3.2, -3.0], 0, 1) + 0.083_185_307).abs() < 1e-8);
        let mut wrapped = Turns::new(Wrapped, &[3.0, -3.0]);
        assert!((wrapped.difference(&[3.0, -3.0], 0, 1) + 0.283_185_307).abs() < 1e-8);
        assert!((wrapped.difference(&[3.0, -3.0], 1, 0) - 0.283_185_307).abs() < 1e-8);
        // The difference goes on continuously until it has left (-pi, pi].
        let links = [(0, 1)];
        assert!(wrapped.margin(&[3.0, -0.2], &links) > 0.0 && wrapped.margin(&[3.0, 0.1], &links) < 0.0);
        wrapped.update(&[3.0, 0.1], &links);
        assert!((wrapped.difference(&[3.0, 0.1], 0, 1) - 2.9).abs() < 1e-12);
    }
}
