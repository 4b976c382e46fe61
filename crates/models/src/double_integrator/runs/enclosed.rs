//! Enclosed motion of a few agents whose network switches with their distances: every solution, in the sense of Filippov where the
//! force jumps, with events whose order and times are proved.
//!
//! Between events the network is certain on the whole step. At an event the pair is carried over the threshold within a short time, in
//! which the force may be any mean of those with and without the link; the squared distance is proved to be monotone meanwhile, so that
//! there is one crossing.

use crate::double_integrator::laws::{Coordinates, Pair, Potential, State, velocity_alignment};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, FloatInterval, Number, Rational, Ring, Sign, Signed};
use motion::System;
use motion::enclose::{Flow, IntervalVector, Set, Step, ValidationError, box_of_step};

/// Agents with velocity alignment and one potential, linked below a distance `R`.
#[derive(Debug, Clone)]
pub struct EnclosedFlock {
    /// The potential of every linked pair.
    pub potential: Potential,
    /// `R²`; `None` for a network that does not switch.
    pub threshold: Option<Rational>,
}

/// A link that appears or ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnclosedEvent {
    /// The agents, counted from 0.
    pub pair: Pair,
    /// Whether they are linked from then on.
    pub linked: bool,
    /// Not before this time.
    pub from: f64,
    /// Not after this time.
    pub to: f64,
}

/// A short time in which links may change.
#[derive(Debug, Clone)]
pub struct Crossing {
    /// Its beginning.
    pub from: f64,
    /// Its end.
    pub to: f64,
    /// A box that contains the states in all of it; of a flock positions, then velocities.
    pub states: IntervalVector,
}

/// What was proved of a motion, with its end as a flock or as the numbers of a state.
#[derive(Debug, Clone)]
pub struct EnclosedRun<E = State<FloatInterval>> {
    /// All changes of the network, in order; those with the same times may come in any order.
    pub events: Vec<EnclosedEvent>,
    /// The short times in which links may change, in order; between them are the steps that are observed.
    pub crossings: Vec<Crossing>,
    /// The links at the end.
    pub edges: Vec<Pair>,
    /// The states at the end.
    pub end: E,
}

/// Why a motion could not be enclosed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EnclosureError {
    /// The solution could not be followed.
    #[error(transparent)]
    Validation(#[from] ValidationError),
    /// A pair is at the threshold and it could not be proved what becomes of it: it may touch it, stay at it, or cross it together with
    /// too many others.
    #[error("agents {} and {} are at the threshold at t = {time}, and it is not certain what follows", pair.0 + 1, pair.1 + 1)]
    Threshold {
        /// When.
        time: f64,
        /// Who, counted from 0.
        pair: Pair,
    },
}

/// Pairs that may cross the threshold in the same short time.
const MOST_AT_ONCE: usize = 3;

/// Depth of the search for the time up to which the network is certain, as bits of a step.
const DEPTH: u32 = 30;

/// Length of the first step tried.
const FIRST_STEP: f64 = 0.01;

/// The law of a flock on a fixed network, of states as [`State::to_list`] writes them.
#[derive(Debug, Clone, Copy)]
pub struct FixedNetwork<'a> {
    /// The potential of every link.
    pub potential: &'a Potential,
    /// The links.
    pub edges: &'a [Pair],
}

/// The network with the links of some pairs `i < j` switched.
fn switched(graph: &Graph, switches: impl Fn(Pair) -> bool) -> Graph {
    Graph::from_fn(graph.order(), |i, j| graph.has_edge(i, j) != switches((i.min(j), i.max(j))))
}

/// A set plus a box, with its shape kept or as a box, whichever is narrower.
fn moved(set: &Set, hull: &[FloatInterval], shift: &[FloatInterval]) -> Option<Set> {
    let as_box = Set::of_box(&hull.iter().zip(shift).map(|(x, d)| *x + d).collect::<Vec<_>>());
    let shaped = set.plus(shift)?;
    Some(if shaped.width() < as_box.width() { shaped } else { as_box })
}

impl System for FixedNetwork<'_> {
    fn rate<T: Number>(&self, _: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let Some(like) = state.first() else { return Ok(Vec::new()) };
        let slope = self.potential.slope_over(like);
        let moving = State::from_halves(state);
        let forces = velocity_alignment(&moving, self.edges, Coordinates::Cartesian, |_, _, s| slope.at(s))?;
        Ok(moving.velocities.into_iter().chain(forces).flatten().collect())
    }
}

/// Agents whose links are those below a distance: where they are in the state, and how it moves on each network.
pub trait LinkedAgents: Sync {
    /// The number of agents.
    fn agents(&self) -> usize;

    /// The number of coordinates of a place; those of an agent stand one after the other.
    fn width(&self) -> usize;

    /// Where the coordinates of an agent begin in the state.
    fn place(&self, agent: usize) -> usize;

    /// The law on the network of these links `i < j`.
    fn on<'a>(&'a self, edges: &'a [Pair]) -> impl System + 'a;
}

/// A flock of so many agents.
struct Aligned<'a> {
    potential: &'a Potential,
    agents: usize,
}

impl LinkedAgents for Aligned<'_> {
    fn agents(&self) -> usize {
        self.agents
    }

    fn width(&self) -> usize {
        2
    }

    fn place(&self, agent: usize) -> usize {
        2 * agent
    }

    fn on<'a>(&'a self, edges: &'a [Pair]) -> impl System + 'a {
        FixedNetwork { potential: self.potential, edges }
    }
}

impl EnclosedFlock {
    /// Follows the flock from any state in a box until a time; `observe(time, step)` is called after every step between events with
    /// the time at its beginning. Without a threshold the links are `edges`; with one they are those of the distances.
    ///
    /// # Errors
    /// [`EnclosureError`].
    pub fn run(
        &self,
        start: &State<FloatInterval>,
        edges: &[Pair],
        until: f64,
        mut observe: impl FnMut(f64, &Step),
    ) -> Result<EnclosedRun, EnclosureError> {
        start.check().map_err(|reason| ValidationError::Law { time: 0.0, reason })?;
        let law = Aligned { potential: &self.potential, agents: start.count() };
        let start = start.to_list();
        let motion = SwitchingMotion::new(&law, self.threshold.as_ref());
        let graph = match &self.threshold {
            None => Graph::from_fn(law.agents, |i, j| edges.contains(&(i, j)) || edges.contains(&(j, i))),
            Some(_) => motion.links(&start),
        };
        let run = motion.follow(&Set::of_box(&start), graph, until, &mut observe)?;
        let end = State::from_halves(&run.end);
        Ok(EnclosedRun { events: run.events, crossings: run.crossings, edges: run.edges, end })
    }
}

/// The motions of agents whose links switch at a distance.
#[derive(Debug, Clone)]
pub struct SwitchingMotion<'l, L> {
    law: &'l L,
    /// The square of the distance; `None` for a network that does not switch.
    square: Option<FloatInterval>,
}

impl<'l, L: LinkedAgents> SwitchingMotion<'l, L> {
    /// Of agents that are linked where the square of their distance is below this.
    pub fn new(law: &'l L, square: Option<&Rational>) -> Self {
        SwitchingMotion { law, square: square.map(FloatInterval::from_rational) }
    }

    /// The links that are certain at a state.
    pub fn links(&self, state: &[FloatInterval]) -> Graph {
        let is_linked = |i: usize, j: usize| {
            self.square.is_some_and(|square| (self.apart(state, i, j) - square).sign() == Some(Sign::Negative))
        };
        Graph::from_fn(self.law.agents(), is_linked)
    }

    /// Follows the agents from any state in a set until a time; `observe(time, step)` is called after every step between events with the time at its beginning.
    ///
    /// # Errors
    /// [`EnclosureError`], also where a pair may be at the threshold at the start.
    pub fn run(
        &self,
        start: &Set,
        until: f64,
        mut observe: impl FnMut(f64, &Step),
    ) -> Result<EnclosedRun<IntervalVector>, EnclosureError> {
        self.follow(start, self.links(&start.hull()), until, &mut observe)
    }

    /// From given links.
    fn follow(
        &self,
        start: &Set,
        mut graph: Graph,
        until: f64,
        observe: &mut dyn FnMut(f64, &Step),
    ) -> Result<EnclosedRun<IntervalVector>, EnclosureError> {
        if let Some(&pair) = self.doubtful(&start.hull(), &graph).first() {
            return Err(EnclosureError::Threshold { time: 0.0, pair });
        }
        let (mut set, mut time, mut events) = (start.clone(), 0.0, Vec::new());
        let mut crossings: Vec<Crossing> = Vec::new();
        while time < until {
            let links = graph.edges();
            let mut flow = Flow::new(self.law.on(&links), FIRST_STEP);
            while time < until {
                let mut step = flow.step(&set, time, until)?;
                let mut certain = self.certain_until(&step, &graph);
                // Just after a crossing a pair is hardly beyond the threshold: the bounds of a short step show that it is.
                let mut length =
                    if crossings.last().is_some_and(|last| last.to == time) { step.span.hi() } else { 0.0 };
                while certain == 0.0 && time + length / 64.0 > time {
                    length /= 64.0;
                    step = flow.step(&set, time, time + length)?;
                    certain = self.certain_until(&step, &graph);
                }
                if certain < step.span.hi() {
                    // Not longer than what is certain; the next float below makes up for the rounding of the sum.
                    let stop = (time + certain).next_down();
                    if stop <= time {
                        break;
                    }
                    step = flow.step(&set, time, stop)?;
                }
                observe(time, &step);
                (set, time) = (step.end, step.until);
            }
            if time < until {
                let (end, crossing, changes) = self.cross(&set, &mut graph, time)?;
                (set, time) = (end, crossing.to);
                events.extend(changes);
                crossings.push(crossing);
            }
        }
        Ok(EnclosedRun { events, crossings, edges: graph.edges(), end: set.hull() })
    }

    /// The square of a distance of two agents.
    fn apart(&self, state: &[FloatInterval], i: usize, j: usize) -> FloatInterval {
        self.squared(i, j, |a, b| state[a] - state[b])
    }

    /// The same, given the differences of two numbers of the state.
    fn squared(&self, i: usize, j: usize, difference: impl Fn(usize, usize) -> FloatInterval) -> FloatInterval {
        let [i, j] = [i, j].map(|agent| self.law.place(agent));
        (0..self.law.width()).fold(FloatInterval::point(0.0), |sum, k| sum + difference(i + k, j + k).square())
    }

    /// The pairs that are not certainly on the side of the threshold on which the network has them.
    fn doubtful(&self, states: &[FloatInterval], graph: &Graph) -> Vec<Pair> {
        self.on_no_side(graph, |i, j| self.apart(states, i, j))
    }

    /// As [`Self::doubtful`], given `|r_i - r_j|²`.
    fn on_no_side(&self, graph: &Graph, apart: impl Fn(usize, usize) -> FloatInterval) -> Vec<Pair> {
        let Some(square) = self.square else { return Vec::new() };
        let doubtful = |&(i, j): &Pair| {
            let side = if graph.has_edge(i, j) { Sign::Negative } else { Sign::Positive };
            (apart(i, j) - square).sign() != Some(side)
        };
        pairs_of(graph).filter(doubtful).collect()
    }

    /// The pair whose distance is nearest to the threshold, for states in the middle.
    fn nearest(&self, states: &[FloatInterval], graph: &Graph) -> Pair {
        let square = self.square.unwrap_or(FloatInterval::point(0.0));
        let off = |&(i, j): &Pair| (self.apart(states, i, j) - square).midpoint().abs();
        pairs_of(graph).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or_default()
    }

    /// The part of a step, from its beginning, on which the network is certain.
    fn certain_until(&self, step: &Step, graph: &Graph) -> f64 {
        let mut certain = 0.0;
        // Parts of the step still to be looked at, the earliest last.
        let mut parts = vec![(0.0, step.span.hi(), DEPTH)];
        while let Some((from, to, depth)) = parts.pop() {
            let part = FloatInterval::between(from, to);
            let apart = |i: usize, j: usize| self.squared(i, j, |a, b| step.difference(a, b, part));
            if self.on_no_side(graph, apart).is_empty() {
                certain = to;
            } else if depth == 0 {
                break;
            } else {
                let middle = f64::midpoint(from, to);
                parts.extend([(middle, to, depth - 1), (from, middle, depth - 1)]);
            }
        }
        certain
    }

    /// Whether the square of a distance only grows, or with `up` false only falls, in states with these rates.
    fn is_monotone(&self, (i, j): Pair, states: &[FloatInterval], rates: &[FloatInterval], up: bool) -> bool {
        let [i, j] = [i, j].map(|agent| self.law.place(agent));
        let products = (0..self.law.width()).map(|k| (states[i + k] - states[j + k]) * (rates[i + k] - rates[j + k]));
        let rate = products.fold(FloatInterval::point(0.0), |sum, product| sum + product);
        rate.sign() == Some(if up { Sign::Positive } else { Sign::Negative })
    }

    /// Carries the set over the threshold: the set after it, the time that takes and the events.
    fn cross(
        &self,
        set: &Set,
        graph: &mut Graph,
        time: f64,
    ) -> Result<(Set, Crossing, Vec<EnclosedEvent>), EnclosureError> {
        let start = set.hull();
        let mut pair = None;
        for power in -40..-3 {
            let to = time + 2f64.powi(power) * time.max(1.0);
            let span = FloatInterval::point(to) - FloatInterval::point(time);
            let times = FloatInterval::between(time, to);
            let rates = |b: &[FloatInterval]| self.mixed(times, b, graph);
            let Ok(Some(around)) = box_of_step(&start, span, rates) else { continue };
            let crossing = self.doubtful(&around, graph);
            let Ok(rate) = self.mixed(times, &around, graph) else { continue };
            // Forces jump where links do, and so may velocities: all rates of the networks that are possible count.
            let monotone = |&(i, j): &Pair| self.is_monotone((i, j), &around, &rate, graph.has_edge(i, j));
            let shift: IntervalVector = rate.iter().map(|f| span * *f).collect();
            let Some(end) = moved(set, &start, &shift) else { continue };
            // The next step would take a set around it, which has to be beyond the threshold, too.
            let end = end.renewed().unwrap_or(end);
            pair = crossing.first().copied().or(pair);
            let next = switched(graph, |pair| crossing.contains(&pair));
            // A time in which nothing may cross would only be followed by another one.
            let crosses = !crossing.is_empty() && crossing.iter().all(monotone);
            if crosses && self.doubtful(&end.hull(), &next).is_empty() {
                let event =
                    |&(i, j): &Pair| EnclosedEvent { pair: (i, j), linked: next.has_edge(i, j), from: time, to };
                let events = crossing.iter().map(event).collect();
                *graph = next;
                return Ok((end, Crossing { from: time, to, states: around }, events));
            }
        }
        Err(EnclosureError::Threshold { time, pair: pair.unwrap_or_else(|| self.nearest(&start, graph)) })
    }

    /// Encloses the right-hand side over a box in which the network is not certain: all forces between those of the networks that are possible.
    fn mixed(
        &self,
        times: FloatInterval,
        over: &[FloatInterval],
        graph: &Graph,
    ) -> Result<IntervalVector, ArithmeticError> {
        let doubtful = self.doubtful(over, graph);
        if doubtful.len() > MOST_AT_ONCE {
            return Err(ArithmeticError::Domain("fewer uncertain links"));
        }
        let mut hull: Option<IntervalVector> = None;
        for choice in 0..1usize << doubtful.len() {
            let chosen = |pair| doubtful.iter().position(|&p| p == pair).is_some_and(|k| choice >> k & 1 == 1);
            let edges = switched(graph, chosen).edges();
            let rate = self.law.on(&edges).rate(&times, over)?;
            hull = Some(match hull {
                None => rate,
                Some(hull) => hull.iter().zip(&rate).map(|(a, b)| a.hull(b)).collect(),
            });
        }
        Ok(hull.unwrap_or_default())
    }
}

/// All pairs `i < j`.
fn pairs_of(graph: &Graph) -> impl Iterator<Item = Pair> {
    (0..graph.order()).flat_map(|j| (0..j).map(move |i| (i, j)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::rational;

    fn alignment_alone() -> Potential {
        Potential::new(Vec::new(), (rational(1, 1), rational(0, 1)))
    }

    /// Agents on a line at distances around 2: every choice of the two links counts, the middle one is pulled by neither, one or both.
    #[test]
    fn forces_of_all_networks_that_are_possible_are_enclosed() {
        let [near, far] = [-0.25, 0.25];
        let wide = |x: f64| FloatInterval::between(x + near, x + far);
        let point = FloatInterval::point;
        let positions = [wide(-2.0), point(0.0), wide(2.0)];
        let speeds = [1.0, 0.0, -3.0];
        let flat: Vec<FloatInterval> =
            positions.into_iter().chain(speeds.map(point)).flat_map(|x| [x, point(0.0)]).collect();
        for links in [&[][..], &[(0, 1)], &[(1, 2)], &[(0, 1), (1, 2)]] {
            let graph = Graph::from_edges(3, links).expect("a graph");
            let flock = Aligned { potential: &alignment_alone(), agents: 3 };
            let motion = SwitchingMotion::new(&flock, Some(&rational(4, 1)));
            assert_eq!(motion.doubtful(&flat, &graph), [(0, 1), (1, 2)]);
            let rate = motion.mixed(FloatInterval::LINE, &flat, &graph).expect("a rate");
            let along = [6, 8, 10].map(|k| (rate[k].lo(), rate[k].hi()));
            assert_eq!(along, [(-1.0, 0.0), (-3.0, 1.0), (0.0, 3.0)], "{links:?}");
            assert_eq!([0, 2, 4].map(|k| rate[k]), speeds.map(point));
        }
    }

    /// Distances 1, 5/2 and 7/2 with `R = 2`, and one of 2 in another row.
    #[test]
    fn the_pair_nearest_to_the_threshold_is_found() {
        let potential = alignment_alone();
        let nearest = |agents, flat: &[FloatInterval]| {
            let flock = Aligned { potential: &potential, agents };
            SwitchingMotion::new(&flock, Some(&rational(4, 1))).nearest(flat, &Graph::empty(agents))
        };
        let flat = |places: &[[f64; 2]]| -> Vec<FloatInterval> {
            let still = vec![[0.0; 2]; places.len()];
            places.iter().chain(&still).flatten().map(|&x| FloatInterval::point(x)).collect()
        };
        let line = [[0.0, 0.0], [1.0, 0.0], [3.5, 0.0]];
        assert_eq!(nearest(3, &flat(&line)), (1, 2));
        let four = [line[0], line[1], line[2], [3.5, 2.0]];
        assert_eq!(nearest(4, &flat(&four)), (2, 3));
        let first = [[0.0, 0.0], [0.0, 2.0], [9.0, 0.0]];
        assert_eq!(nearest(3, &flat(&first)), (0, 1));
    }
}
