//! The simulated experiments of both papers in floats: a start, links, a law, and what is observed. Nothing here proves anything.

use super::{
    Coordinates, HeadingDifference, Pair, Potential, RunError, State, Stepper, Vector, difference, disagreement,
    gyroscopic, heading, kinetic_energy, linked_within, pairs_within, potential_energy, potential_gradients,
    velocity_alignment,
};
use crate::arithmetic::ArithmeticError;
use crate::graph::Graph;

const PLANE: Coordinates = Coordinates::Cartesian;

/// Which agents are linked.
#[derive(Debug, Clone, PartialEq)]
pub enum Links {
    /// Those that a graph joins.
    Fixed(Graph),
    /// Those at a distance below the square root of this.
    Within(f64),
}

/// The law besides the gradients of the potentials.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Alignment {
    /// By headings, equation (5) of the first paper. Headings that are followed would need states of their own: not here.
    Headings(HeadingDifference),
    /// By velocities, equation (4) of the second paper.
    Velocities,
}

/// A closed loop and a start.
#[derive(Debug, Clone)]
pub struct Experiment {
    /// Positions and velocities at time 0.
    pub start: State<f64>,
    /// Who is linked.
    pub links: Links,
    /// How agents align.
    pub alignment: Alignment,
    /// The potential of each linked pair.
    pub potential: Potential,
    /// Largest error estimate of a step in any coordinate.
    pub tolerance: f64,
}

/// What can be seen of a state. Distances are in the unit of positions, speeds per unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    /// When.
    pub time: f64,
    /// `sqrt(sum |v_i - mean|²)`.
    pub disagreement: f64,
    /// The largest disagreement within a component of the graph of links.
    pub component_disagreement: f64,
    /// The largest wrapped difference of two headings, in radians.
    pub heading_spread: f64,
    /// The least distance of two agents, linked or not.
    pub least_distance: f64,
    /// The least distance of two agents that are not linked; infinite if all are.
    pub least_unlinked: f64,
    /// The largest distance from the mean position.
    pub radius: f64,
    /// The largest `|grad V_i|`.
    pub gradient: f64,
    /// The sum of `V_ij` over the links.
    pub potential: f64,
    /// The potential and half the sum of the squared speeds.
    pub energy: f64,
    /// Equation (11) of the second paper, `Q`, where links depend on the distance: [`Self::energy`] plus `V(R)` for each pair that is not
    /// linked. With fixed links the energy itself, `W` of equation (6).
    pub lyapunov: f64,
    /// Connected components of the graph of links.
    pub components: usize,
    /// Links.
    pub links: usize,
    /// Pairs of agents.
    pub pairs: usize,
}

/// Start and end of a run, and how near any two agents came to each other on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// At time 0.
    pub start: Observation,
    /// At the end.
    pub end: Observation,
    /// The least distance of any two agents at any time; between two steps by cubic interpolation.
    pub closest: f64,
    /// The most components at the ends of steps.
    pub most_components: usize,
}

impl Observation {
    /// What the figures of the first paper show at their end: a common heading, a tight formation and a potential minimum, told from the
    /// heading spread, the radius and the largest gradient.
    pub fn is_formation(&self, headings: f64, gradient: f64, radius: f64) -> bool {
        self.heading_spread < headings && self.gradient < gradient && self.radius < radius
    }

    /// Links over pairs.
    pub fn density(&self) -> f64 {
        self.links as f64 / self.pairs.max(1) as f64
    }
}

impl Trial {
    /// Whether the disagreement at the end is below this part of that at the start.
    pub fn agrees(&self, part: f64) -> bool {
        self.end.disagreement < part * self.start.disagreement
    }

    /// Whether that holds within each component of the final graph.
    pub fn components_agree(&self, part: f64) -> bool {
        self.end.component_disagreement < part * self.start.disagreement
    }
}

impl Links {
    /// The graph of links at these positions.
    pub fn graph(&self, positions: &[Vector<f64>]) -> Graph {
        match self {
            Links::Fixed(graph) => graph.clone(),
            Links::Within(square) => linked_within(positions, square, PLANE),
        }
    }
}

impl Experiment {
    /// The states at some times, which must not decrease; `seen` is called after every step.
    ///
    /// # Errors
    /// [`RunError`].
    pub fn states_at(
        &self,
        times: &[f64],
        mut seen: impl FnMut(f64, &State<f64>),
    ) -> Result<Vec<State<f64>>, RunError> {
        let slope = self.potential.slope_over(&1.0);
        let fixed = self.links.graph(&self.start.positions).edges();
        let edges = |state: &State<f64>| match &self.links {
            Links::Fixed(_) => fixed.clone(),
            Links::Within(square) => pairs_within(&state.positions, square, PLANE),
        };
        let law = |state: &State<f64>| {
            let edges = edges(state);
            match self.alignment {
                Alignment::Velocities => velocity_alignment(state, &edges, PLANE, |_, _, s| slope.at(s)),
                Alignment::Headings(HeadingDifference::Unwrapped) => {
                    Err(ArithmeticError::Domain("headings that are followed"))
                }
                Alignment::Headings(reading) => {
                    let gradients = potential_gradients(&state.positions, &edges, PLANE, |_, _, s| slope.at(s))?;
                    let angles = headings(state)?;
                    gyroscopic(state, &gradients, &edges, |i, j| reading.read(angles[i] - angles[j]))
                }
            }
        };
        let stepper = Stepper { tolerance: self.tolerance, ..Stepper::default() };
        let (mut now, mut state) = (0.0, self.start.clone());
        let mut states = Vec::with_capacity(times.len());
        for &time in times {
            if time > now {
                state = stepper.run(&state, time - now, law, |later, state| seen(now + later, state))?;
                now = time;
            }
            states.push(state.clone());
        }
        Ok(states)
    }

    /// A run to the end.
    ///
    /// # Errors
    /// [`RunError`].
    pub fn trial(&self, until: f64) -> Result<Trial, RunError> {
        let start = self.observe(0.0, &self.start)?;
        let mut approach = Approach::new(&self.start);
        let mut most_components = start.components;
        let states = self.states_at(&[until], |time, state| {
            approach.step(time, state);
            if matches!(self.links, Links::Within(_)) {
                most_components = most_components.max(self.links.graph(&state.positions).components().len());
            }
        })?;
        let end = states.iter().try_fold(start, |_, state| self.observe(until, state))?;
        Ok(Trial { start, end, closest: approach.least(), most_components })
    }

    /// What is seen of a state, which need not be one of the motion.
    ///
    /// # Errors
    /// [`ArithmeticError`] where linked agents coincide or an agent rests (it has no heading).
    pub fn observe(&self, time: f64, state: &State<f64>) -> Result<Observation, ArithmeticError> {
        let graph = self.links.graph(&state.positions);
        let edges = graph.edges();
        let count = state.count();
        let (mut least_distance, mut least_unlinked) = (f64::INFINITY, f64::INFINITY);
        for (i, j) in pairs(count) {
            let distance = length(&state.separation(i, j));
            least_distance = least_distance.min(distance);
            if !graph.has_edge(i, j) {
                least_unlinked = least_unlinked.min(distance);
            }
        }
        let components = graph.components();
        let within = components.iter().map(|members| {
            disagreement(&State {
                positions: members.iter().map(|&i| state.positions[i]).collect(),
                velocities: members.iter().map(|&i| state.velocities[i]).collect(),
            })
        });
        let gradients = potential_gradients(&state.positions, &edges, PLANE, |_, _, s| self.potential.slope(s))?;
        let potential = potential_energy(&state.positions, &edges, PLANE, |_, _, s| self.potential.value(s))?;
        let energy = potential + kinetic_energy(&state.velocities, PLANE)?;
        let unlinked = count * (count - 1) / 2 - edges.len();
        let saturated = match self.links {
            Links::Within(square) => unlinked as f64 * self.potential.value(&square)?,
            Links::Fixed(_) => 0.0,
        };
        Ok(Observation {
            time,
            disagreement: disagreement(state),
            component_disagreement: within.fold(0.0, f64::max),
            heading_spread: heading_spread(state)?,
            least_distance,
            least_unlinked,
            radius: radius(&state.positions),
            gradient: gradients.iter().map(length).fold(0.0, f64::max),
            potential,
            energy,
            lyapunov: energy + saturated,
            components: components.len(),
            links: edges.len(),
            pairs: count * (count - 1) / 2,
        })
    }

    /// Observations from 0 to the last of the times, at them and about every `every` between them, and the states at the times.
    ///
    /// # Errors
    /// [`RunError`].
    pub fn course(&self, times: &[f64], every: f64) -> Result<(Vec<Observation>, Vec<State<f64>>), RunError> {
        let mut seen = vec![self.observe(0.0, &self.start)];
        let mut last = 0.0;
        let states = self.states_at(times, |time, state| {
            if time >= last + every || times.contains(&time) {
                last = time;
                seen.push(self.observe(time, state));
            }
        })?;
        Ok((seen.into_iter().collect::<Result<_, _>>()?, states))
    }
}

fn pairs(count: usize) -> impl Iterator<Item = Pair> {
    (0..count).flat_map(|j| (0..j).map(move |i| (i, j)))
}

fn length(vector: &Vector<f64>) -> f64 {
    PLANE.square(vector).sqrt()
}

fn headings(state: &State<f64>) -> Result<Vec<f64>, ArithmeticError> {
    state.velocities.iter().map(heading).collect()
}

fn heading_spread(state: &State<f64>) -> Result<f64, ArithmeticError> {
    let angles = headings(state)?;
    let apart = pairs(angles.len()).map(|(i, j)| HeadingDifference::Wrapped.read(angles[i] - angles[j]).abs());
    Ok(apart.fold(0.0, f64::max))
}

fn radius(positions: &[Vector<f64>]) -> f64 {
    let count = positions.len().max(1) as f64;
    let mean = [0, 1].map(|k| positions.iter().map(|r| r[k]).sum::<f64>() / count);
    positions.iter().map(|r| length(&difference(r, &mean))).fold(0.0, f64::max)
}

/// The least distance of any two agents so far.
struct Approach {
    least: f64,
    time: f64,
    state: State<f64>,
}

impl Approach {
    fn new(start: &State<f64>) -> Self {
        let squares = pairs(start.count()).map(|(i, j)| PLANE.square(&start.separation(i, j)));
        Approach { least: squares.fold(f64::INFINITY, f64::min), time: 0.0, state: start.clone() }
    }

    fn least(&self) -> f64 {
        self.least.sqrt()
    }

    /// The state at the end of the next step.
    fn step(&mut self, time: f64, state: &State<f64>) {
        let length = time - self.time;
        for (i, j) in pairs(state.count()) {
            let ends = [&self.state, state].map(|s| (s.separation(i, j), s.relative_velocity(i, j)));
            let [opening, closing] = ends.each_ref().map(|(r, v)| PLANE.product(r, v));
            self.least = self.least.min(PLANE.square(&ends[1].0));
            if opening < 0.0 && closing > 0.0 {
                self.least = self.least.min(turning_point(&ends, length));
            }
        }
        (self.time, self.state) = (time, state.clone());
    }
}

/// The squared length where a vector that comes nearer at the beginning of a step and leaves at its end turns, by bisection on the
/// cubic through positions and velocities at both ends.
fn turning_point(ends: &[(Vector<f64>, Vector<f64>); 2], length: f64) -> f64 {
    let [(r0, v0), (r1, v1)] = ends;
    let at = |x: f64| {
        let (y, rest) = (x * x, 1.0 - x);
        let place = |k: usize| {
            (1.0 + 2.0 * x) * rest * rest * r0[k] + x * rest * rest * length * v0[k] + y * (3.0 - 2.0 * x) * r1[k]
                - y * rest * length * v1[k]
        };
        let slope = |k: usize| {
            6.0 * x * rest * (r1[k] - r0[k]) + rest * (1.0 - 3.0 * x) * length * v0[k]
                - x * (2.0 - 3.0 * x) * length * v1[k]
        };
        ([place(0), place(1)], [slope(0), slope(1)])
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        let (r, v) = at(middle);
        if PLANE.product(&r, &v) < 0.0 { low = middle } else { high = middle }
    }
    PLANE.square(&at(low).0)
}
