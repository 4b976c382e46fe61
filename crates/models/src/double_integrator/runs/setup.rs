//! The starts and links that the papers' simulations are drawn from.

use super::input::{Alignment, Flock, InputError, Network};
use super::motion::{Options, Prefer};
use super::random::random_flock;
use crate::double_integrator::laws::{Coordinates, HeadingDifference, Potential, State, Vector, linked_within};
use algebra::graph::Graph;
use arithmetic::random::uniform;
use arithmetic::rational;
use motion::Tolerance;
use rand_chacha::ChaCha8Rng;

/// How links are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LinkRule {
    /// All pairs.
    Complete,
    /// Each pair with this probability, drawn again until the graph is connected.
    Random(f64),
    /// All pairs closer than a radius; with `connected`, starts are drawn until their graph is connected.
    Within {
        /// The radius, in the unit of positions.
        radius: f64,
        /// Whether the graph has to be connected at the start.
        connected: bool,
    },
}

/// How starts are drawn, evenly in each case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StartRule {
    /// Positions in a disc of the first radius, velocities in a disc of the second.
    Discs(f64, f64),
    /// Positions in a square of this half side, speeds between 0 and the second number, directions all around.
    Square(f64, f64),
}

/// What an experiment is drawn from.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    /// How many agents.
    pub agents: usize,
    /// Their links.
    pub links: LinkRule,
    /// Positions and velocities.
    pub start: StartRule,
    /// How agents align.
    pub alignment: Alignment,
    /// The potential of each linked pair.
    pub potential: Potential,
}

/// How Section V of the first paper, which leaves the potential open, can be read. Positions are in a disc of radius 20 m in all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HeadingReading {
    /// Velocities in the same ball, so speeds up to 20 m/s; the potential that Section IV prints, `1/s + log s`.
    Printed,
    /// The same with `s + 1/s - 2`: "any potential function can be used".
    Spring,
    /// The printed potential with speeds up to 1 m/s, as in the second paper: the first gives the radius 20 in metres for both, and no
    /// unit for speeds.
    Slow,
}

impl HeadingReading {
    /// All of them.
    pub const ALL: [HeadingReading; 3] = [HeadingReading::Printed, HeadingReading::Spring, HeadingReading::Slow];

    /// A few words.
    pub fn describe(self) -> &'static str {
        match self {
            HeadingReading::Printed => "speeds up to 20 m/s, V = 1/s + log s",
            HeadingReading::Spring => "speeds up to 20 m/s, V = s + 1/s - 2",
            HeadingReading::Slow => "speeds up to 1 m/s, V = 1/s + log s",
        }
    }

    /// Fewer words, for legends.
    pub fn name(self) -> &'static str {
        match self {
            HeadingReading::Printed => "20 m/s, logarithm",
            HeadingReading::Spring => "20 m/s, spring",
            HeadingReading::Slow => "1 m/s, logarithm",
        }
    }

    fn start(self) -> StartRule {
        StartRule::Discs(20.0, if self == HeadingReading::Slow { 1.0 } else { 20.0 })
    }

    fn potential(self) -> Potential {
        let one = rational(1, 1);
        match self {
            HeadingReading::Spring => Potential::inverse_square_spring(&one, &one),
            HeadingReading::Printed | HeadingReading::Slow => Potential::inverse_square_log(&one),
        }
    }
}

impl Setup {
    /// How the runs are computed; the claims need no tighter tolerance than this.
    pub const OPTIONS: Options = Options {
        tolerance: Tolerance { relative: 1e-7, absolute: 1e-7 },
        prefer: Prefer::Keep,
        first_branch: None,
        most_events: 100_000,
    };

    /// Section V of the first paper: ten agents, complete or random connected graphs. Chosen: everything is drawn evenly; each edge of an
    /// incomplete graph with probability 1/2; differences of headings as in (2), not wrapped.
    pub fn heading_alignment(complete: bool, reading: HeadingReading) -> Self {
        Setup {
            agents: 10,
            links: if complete { LinkRule::Complete } else { LinkRule::Random(0.5) },
            start: reading.start(),
            alignment: Alignment::Heading(HeadingDifference::Raw),
            potential: reading.potential(),
        }
    }

    /// Section 6 of the second paper: ten agents, positions in a square of side 5 m, speeds up to 1 m/s. Chosen: evenly; the potential `1/s + log s`
    /// of the first paper.
    pub fn velocity_alignment(links: LinkRule) -> Self {
        Setup {
            agents: 10,
            links,
            start: StartRule::Square(2.5, 1.0),
            alignment: Alignment::Velocity,
            potential: Potential::inverse_square_log(&rational(1, 1)),
        }
    }

    /// How often a graph is drawn until it is connected, at most. Those of the papers need some ten draws.
    pub const DRAWS: usize = 100_000;

    /// The radius of the second paper, 2 m.
    pub const RADIUS: f64 = 2.0;

    /// A flock.
    ///
    /// # Errors
    /// [`InputError`]: linked agents are in one place or so, which does not happen but by a very small chance, or no graph is connected
    /// after [`Setup::DRAWS`] draws, as for a probability of 0.
    pub fn draw(&self, random: &mut ChaCha8Rng) -> Result<Flock, InputError> {
        let network = match self.links {
            LinkRule::Complete => Network::Fixed(Graph::complete(self.agents)),
            LinkRule::Random(probability) => Network::Fixed(random_connected(self.agents, probability, random)?),
            LinkRule::Within { radius, .. } => Network::Within(radius),
        };
        let mut start = self.start.draw(self.agents, random);
        if let LinkRule::Within { radius, connected: true } = self.links {
            let mut draws = 1;
            while !linked_within(&start.positions, &(radius * radius), Coordinates::Cartesian).is_connected() {
                if draws == Setup::DRAWS {
                    return Err(InputError::NeverConnected(draws));
                }
                start = self.start.draw(self.agents, random);
                draws += 1;
            }
        }
        Flock::new(self.alignment, self.potential.clone(), network, start)
    }
}

impl StartRule {
    fn draw(self, count: usize, random: &mut ChaCha8Rng) -> State<f64> {
        match self {
            StartRule::Discs(radius, speed) => {
                State { positions: disc(count, radius, random), velocities: disc(count, speed, random) }
            }
            StartRule::Square(half, speed) => random_flock(count, half, speed, random),
        }
    }
}

fn disc(count: usize, radius: f64, random: &mut ChaCha8Rng) -> Vec<Vector<f64>> {
    let mut point = || {
        let (size, angle) = (radius * uniform(random).sqrt(), std::f64::consts::TAU * uniform(random));
        [size * angle.cos(), size * angle.sin()]
    };
    (0..count).map(|_| point()).collect()
}

/// Each edge with a probability; drawn until connected.
fn random_connected(count: usize, probability: f64, random: &mut ChaCha8Rng) -> Result<Graph, InputError> {
    for _ in 0..Setup::DRAWS {
        let numbers: Vec<f64> = (0..count * count).map(|_| uniform(random)).collect();
        let graph = Graph::from_fn(count, |i, j| numbers[i * count + j] < probability);
        if graph.is_connected() {
            return Ok(graph);
        }
    }
    Err(InputError::NeverConnected(Setup::DRAWS))
}
