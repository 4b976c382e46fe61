//! A second way to the motions of `simulate`, as naive as it can be: laws that are summed arc by arc from plain lists, integrated in fixed steps of the
//! classical method of Runge and Kutta. It shares no code with the models.

use super::super::Stop;

/// `(k, j)`: agent k senses agent j, from 0.
pub(super) type Arc = (usize, usize);

/// Who senses whom.
#[derive(Debug, Clone)]
pub(super) enum Links {
    /// Arcs from each time on, the first from 0.
    Timed(Vec<(f64, Vec<Arc>)>),
    /// Those nearer than this.
    Within(f64),
    /// So many nearest.
    Nearest(usize),
}

/// `f(t, y)` with the arcs in force.
pub(super) type Rate<'a> = dyn Fn(f64, &[f64], &[Arc]) -> Vec<f64> + 'a;

/// Why a motion is left alone at a state.
pub(super) type Doubt<'a> = dyn Fn(&[f64]) -> Option<&'static str> + 'a;

/// Two runs whose steps differ by the factor 2 agree up to this, so that the finer one is wrong by a fifteenth of it.
const AGREED: f64 = 1e-8;

/// Steps of a unit of time, of the coarser run.
const STEPS: f64 = 128.0;

/// A start with what moves it; positions in the plane come first, two numbers an agent, where there are any.
pub(super) struct Naive<'a> {
    pub agents: usize,
    pub start: Vec<f64>,
    pub links: Links,
    pub rate: &'a Rate<'a>,
    pub doubt: &'a Doubt<'a>,
}

fn undecided(why: &str) -> Stop {
    Stop::Undecided(why.to_string())
}

impl Naive<'_> {
    /// The state at a time, from two runs.
    pub fn at(&self, until: f64) -> Result<Vec<f64>, Stop> {
        let (coarse, fine) = (self.run(until, 1.0 / STEPS)?, self.run(until, 0.5 / STEPS)?);
        let agree = coarse.iter().zip(&fine).all(|(a, b)| (a - b).abs() <= AGREED * b.abs().max(1.0));
        if agree { Ok(fine) } else { Err(undecided("the naive runs do not agree")) }
    }

    fn run(&self, until: f64, longest: f64) -> Result<Vec<f64>, Stop> {
        let (mut time, mut state) = (0.0, self.start.clone());
        let mut arcs = self.arcs(time, &state);
        while time < until {
            if let Some(why) = (self.doubt)(&state).or_else(|| self.touching(&state)) {
                return Err(undecided(why));
            }
            let due = match &self.links {
                Links::Timed(list) => list.iter().map(|(at, _)| *at).find(|at| *at > time).unwrap_or(until).min(until),
                _ => until,
            };
            let (mut step, whole) = (longest.min(due - time), longest >= due - time);
            let mut next = self.step(time, step, &state, &arcs);
            // A switch is halved down to almost nothing, and then gone across.
            while !matches!(self.links, Links::Timed(_)) && step > 1e-12 && self.arcs(time, &next) != arcs {
                step /= 2.0;
                next = self.step(time, step, &state, &arcs);
            }
            time = if whole && step == due - time { due } else { time + step };
            state = next;
            arcs = self.arcs(time, &state);
        }
        Ok(state)
    }

    /// One step of Runge and Kutta.
    fn step(&self, time: f64, step: f64, state: &[f64], arcs: &[Arc]) -> Vec<f64> {
        let moved = |by: f64, slope: &[f64]| state.iter().zip(slope).map(|(x, k)| x + by * k).collect::<Vec<f64>>();
        let first = (self.rate)(time, state, arcs);
        let second = (self.rate)(time + step / 2.0, &moved(step / 2.0, &first), arcs);
        let third = (self.rate)(time + step / 2.0, &moved(step / 2.0, &second), arcs);
        let fourth = (self.rate)(time + step, &moved(step, &third), arcs);
        let slope = |i: usize| (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]) / 6.0;
        (0..state.len()).map(|i| state[i] + step * slope(i)).collect()
    }

    /// The arcs in force.
    pub fn arcs(&self, time: f64, state: &[f64]) -> Vec<Arc> {
        let all = (0..self.agents).flat_map(|k| (0..self.agents).filter(move |j| *j != k).map(move |j| (k, j)));
        match &self.links {
            Links::Timed(list) => {
                list.iter().rev().find(|(at, _)| *at <= time).map_or(Vec::new(), |(_, arcs)| arcs.clone())
            }
            Links::Within(radius) => all.filter(|&(k, j)| square(state, k, j) < radius * radius).collect(),
            Links::Nearest(count) => {
                let nearer = |k: usize, j: usize| {
                    let own = square(state, k, j);
                    let before = |i: &usize| *i != k && (square(state, k, *i), *i) < (own, j);
                    (0..self.agents).filter(before).count()
                };
                all.filter(|&(k, j)| nearer(k, j) < *count).collect()
            }
        }
    }

    /// Whether a pair may come to the radius, or to the distance of another neighbour, without going across: the two runs could differ on that.
    fn touching(&self, state: &[f64]) -> Option<&'static str> {
        const NEAR: f64 = 1e-3;
        let rate = (self.rate)(0.0, state, &[]);
        let along = |k: usize, j: usize| {
            let part = |c: usize| (state[2 * k + c] - state[2 * j + c]) * (rate[2 * k + c] - rate[2 * j + c]);
            2.0 * (part(0) + part(1))
        };
        let graze = |gap: f64, slope: f64| gap.abs() < NEAR && slope.abs() < 0.1;
        let pairs = || (0..self.agents).flat_map(|k| (0..self.agents).map(move |j| (k, j))).filter(|(k, j)| k != j);
        let found = match &self.links {
            Links::Timed(_) => false,
            Links::Within(radius) => pairs().any(|(k, j)| graze(square(state, k, j) - radius * radius, along(k, j))),
            Links::Nearest(_) => pairs().any(|(k, j)| {
                (0..j)
                    .filter(|i| *i != k)
                    .any(|i| graze(square(state, k, j) - square(state, k, i), along(k, j) - along(k, i)))
            }),
        };
        found.then_some("a switch is touched and not crossed")
    }
}

/// `|r_k - r_j|²`.
pub(super) fn square(state: &[f64], k: usize, j: usize) -> f64 {
    let (x, y) = (state[2 * k] - state[2 * j], state[2 * k + 1] - state[2 * j + 1]);
    x * x + y * y
}
