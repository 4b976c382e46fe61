//! Flocks to be simulated, checked: agents, law, potential and network that fit each other. Messages count agents from 1.

use crate::double_integrator::laws::{Coordinates, HeadingDifference, Pair, Potential, State, linked_within};
use algebra::graph::Graph;

/// Which agents are linked.
#[derive(Debug, Clone, PartialEq)]
pub enum Network {
    /// The same ones at all times.
    Fixed(Graph),
    /// Those with `|r_ij| < R`, for this `R`: Section 5 of the second paper.
    Within(f64),
}

/// The forces beside those of the potential.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Alignment {
    /// `-sum (v_i - v_j)`: the second paper, (4).
    Velocity,
    /// The first paper's force normal to the velocity, (4) and (5), for networks that do not depend on distances.
    Heading(HeadingDifference),
}

/// A flock that can be simulated.
#[derive(Debug, Clone)]
pub struct Flock {
    pub(super) alignment: Alignment,
    pub(super) potential: Potential,
    pub(super) network: Network,
    pub(super) start: State<f64>,
}

/// Why a flock cannot be simulated. Agents are stored counted from 0 and shown counted from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InputError {
    /// No agent.
    #[error("there are no agents")]
    NoAgents,
    /// Lists of different lengths.
    #[error("there are {positions} positions but {velocities} velocities")]
    Counts {
        /// Positions given.
        positions: usize,
        /// Velocities given.
        velocities: usize,
    },
    /// Not a number, or too large to be squared.
    #[error("the {what} of agent {} is not a number below 1e150 in size", .agent + 1)]
    NotFinite {
        /// Position or velocity.
        what: &'static str,
        /// Whose.
        agent: usize,
    },
    /// A radius that is none.
    #[error("the radius R must be a positive number below 1e150, but it is {0}")]
    Radius(f64),
    /// A graph on another number of vertices.
    #[error("the graph has {vertices} vertices, but there are {agents} agents")]
    GraphOrder {
        /// Of the graph.
        vertices: usize,
        /// Of the flock.
        agents: usize,
    },
    /// A graph that was to be drawn until it is connected.
    #[error("none of {0} graphs drawn at random is connected")]
    NeverConnected(usize),
    /// Two linked agents in one place.
    #[error("agents {} and {} are linked and in the same place, where the potential is infinite", .0.0 + 1, .0.1 + 1)]
    Coincident(Pair),
    /// The potential has no finite value or slope between two linked agents.
    #[error("agents {} and {} are linked at distance {distance:e}, where the potential or its slope is not finite", .pair.0 + 1, .pair.1 + 1)]
    Potential {
        /// Who.
        pair: Pair,
        /// Their distance.
        distance: f64,
    },
    /// The potential has no finite value or slope at `R`.
    #[error("the potential or its slope is not finite at the radius R = {0:e}")]
    PotentialAtRadius(f64),
    /// No heading.
    #[error("agent {} is at rest and has no heading, which heading alignment needs", .0 + 1)]
    NoHeading(usize),
    /// Heading alignment on a network that depends on distances.
    #[error("heading alignment is defined on given graphs, not on links within a radius")]
    HeadingWithin,
    /// A reading of heading differences that needs more than positions and velocities.
    #[error("heading differences can be raw or wrapped; headings that are followed are not simulated")]
    Unwrapped,
}

/// Larger numbers are not squared.
const LARGEST: f64 = 1e150;

impl Flock {
    /// Checks that all parts fit.
    ///
    /// # Errors
    /// [`InputError`].
    pub fn new(
        alignment: Alignment,
        potential: Potential,
        network: Network,
        start: State<f64>,
    ) -> Result<Self, InputError> {
        check_state(&start)?;
        check_network(&network, start.count())?;
        let flock = Flock { alignment, potential, network, start };
        flock.check_links(&flock.links_at_start(), &flock.start)?;
        if let Network::Within(radius) = flock.network
            && !flock.is_finite_at(radius * radius)
        {
            return Err(InputError::PotentialAtRadius(radius));
        }
        if let Alignment::Heading(difference) = alignment {
            if matches!(flock.network, Network::Within(_)) {
                return Err(InputError::HeadingWithin);
            }
            if difference == HeadingDifference::Unwrapped {
                return Err(InputError::Unwrapped);
            }
            if let Some(agent) = flock.start.velocities.iter().position(|v| *v == [0.0, 0.0]) {
                return Err(InputError::NoHeading(agent));
            }
        }
        Ok(flock)
    }

    /// The state at the start.
    pub fn start(&self) -> &State<f64> {
        &self.start
    }

    /// The links at the start: strictly within `R`, or those of the graph.
    pub fn links_at_start(&self) -> Vec<Pair> {
        match &self.network {
            Network::Fixed(graph) => graph.edges(),
            Network::Within(radius) => {
                linked_within(&self.start.positions, &(radius * radius), Coordinates::Cartesian).edges()
            }
        }
    }

    fn is_finite_at(&self, s: f64) -> bool {
        let value = self.potential.value_over(&s).and_then(|value| value.at(&s));
        let slope = self.potential.slope_over(&s).at(&s);
        value.is_ok_and(f64::is_finite) && slope.is_ok_and(f64::is_finite)
    }

    /// Whether linked agents are apart, at distances where the potential is finite.
    pub(super) fn check_links(&self, links: &[Pair], state: &State<f64>) -> Result<(), InputError> {
        for &pair in links {
            let s = Coordinates::Cartesian.square(&state.separation(pair.0, pair.1));
            if s == 0.0 {
                return Err(InputError::Coincident(pair));
            }
            if !self.is_finite_at(s) {
                return Err(InputError::Potential { pair, distance: s.sqrt() });
            }
        }
        Ok(())
    }
}

fn check_state(state: &State<f64>) -> Result<(), InputError> {
    let (positions, velocities) = (state.positions.len(), state.velocities.len());
    if positions != velocities {
        return Err(InputError::Counts { positions, velocities });
    }
    if positions == 0 {
        return Err(InputError::NoAgents);
    }
    for (what, vectors) in [("position", &state.positions), ("velocity", &state.velocities)] {
        // NaN is not below anything.
        if let Some(agent) = vectors.iter().position(|v| !v.iter().all(|x| x.abs() < LARGEST)) {
            return Err(InputError::NotFinite { what, agent });
        }
    }
    Ok(())
}

fn check_network(network: &Network, agents: usize) -> Result<(), InputError> {
    match network {
        Network::Fixed(graph) if graph.order() == agents => Ok(()),
        Network::Fixed(graph) => Err(InputError::GraphOrder { vertices: graph.order(), agents }),
        // The square must be a number too, neither 0 nor infinite.
        Network::Within(radius) if *radius > 1.0 / LARGEST && *radius < LARGEST => Ok(()),
        Network::Within(radius) => Err(InputError::Radius(*radius)),
    }
}
