//! Scenarios with exact numbers, for enclosures of their motion; and scenarios with other numbers put in.

use super::config::Scenario;
use super::error::ConfigError;
use super::network::{Abilities, Network};
use super::oscillator::PHASES;
use super::platoon;
use super::potential::PairPotential;
use super::source::{Section, Source};
use super::start::{Needs, Start};
use arithmetic::{Rational, rational};
use models::double_integrator::{Pair, Potential};
use models::oscillator::Neighbours;
use models::platoon::CommunicationGraph;

/// A motion whose law and start are known exactly.
#[derive(Debug, Clone)]
pub enum ExactMotion {
    /// Velocity alignment (Tanner and others): rows of two coordinates.
    Velocities {
        /// Where the agents start.
        positions: Vec<Vec<Rational>>,
        /// Their velocities.
        velocities: Vec<Vec<Rational>>,
        /// The potential of linked pairs.
        potential: Potential,
        /// The links `i < j`, where they do not depend on the distances.
        pairs: Vec<Pair>,
        /// The distance below which pairs are linked, where they do.
        radius: Option<Rational>,
    },
    /// The phase model (Paley and others), `d theta_k/dt = frequency + u_k` with the control (14).
    Phases {
        /// The phases at the start, in radians.
        phases: Vec<Rational>,
        /// `omega_0`.
        frequency: Rational,
        /// `K_1`.
        gain: Rational,
        /// Who senses whom.
        network: Neighbours,
    },
    /// A platoon (Veerman and others): deviations from the desired places, the leader first.
    Platoon {
        /// `y_0, y_1, ..` without the swing of the leader.
        deviations: Vec<Rational>,
        /// Their rates.
        rates: Vec<Rational>,
        /// Gains of positions and velocities.
        gains: (Rational, Rational),
        /// Desired distance of two successive cars.
        spacing: Rational,
        /// Who tracks whom.
        graph: CommunicationGraph,
        /// Amplitude and angular frequency of the leader's swing.
        swing: (Rational, Rational),
    },
    /// A motion that cannot be enclosed, and why.
    Other(&'static str),
}

impl ExactMotion {
    /// Reads a scenario.
    ///
    /// # Errors
    /// [`ConfigError`] where it is none.
    pub fn read(text: &str) -> Result<Self, ConfigError> {
        Scenario::read(text)?;
        let source = Source::parse(text)?;
        match source.top().need("model", "a model")?.word()? {
            "velocity-alignment" => velocities(&source),
            "phase" => phases(&source),
            "platoon" => exact_platoon(&source),
            "fish" | "vicsek" => Ok(ExactMotion::Other("its time is discrete and its numbers are drawn or rounded")),
            _ => Ok(ExactMotion::Other("its law is not among those that are enclosed")),
        }
    }
}

const TIMED: &str = "links that are replaced at given times are not enclosed";

fn velocities(source: &Source) -> Result<ExactMotion, ConfigError> {
    let start = Start::read(source, Needs { dimension: 2, velocities: true, phases: false })?;
    let can = Abilities {
        model: "velocity-alignment",
        positions: true,
        directed: false,
        edges: true,
        timed: true,
        most_switching: usize::MAX,
        default: None,
    };
    let network = Network::read(source, start.agents(), can)?;
    if network.next_time().is_some() {
        return Ok(ExactMotion::Other(TIMED));
    }
    let radius = match network.radius() {
        None => None,
        Some(_) => Some(source.needed("graph")?.need("radius", "a number")?.exact()?),
    };
    let potential = PairPotential::read(&source.needed("law")?)?.exact().clone();
    let pairs = network.pairs().to_vec();
    Ok(ExactMotion::Velocities { positions: start.positions, velocities: start.velocities, potential, pairs, radius })
}

/// A number of the law with a default.
fn number(law: &Section, key: &str, default: i64) -> Result<Rational, ConfigError> {
    law.get(key).map_or(Ok(rational(default, 1)), |entry| entry.exact())
}

fn phases(source: &Source) -> Result<ExactMotion, ConfigError> {
    let start = Start::read(source, Needs { dimension: 0, velocities: false, phases: true })?;
    let law = source.needed("law")?;
    if law.get("K").is_some() || law.get("reference").is_some() {
        return Ok(ExactMotion::Other("of the phase model only the control K1 is enclosed"));
    }
    let agents = start.agents();
    let network = Network::read(source, agents, PHASES)?;
    if network.next_time().is_some() {
        return Ok(ExactMotion::Other(TIMED));
    }
    let neighbours = if network.is_all_to_all() {
        Neighbours::complete(agents)
    } else {
        let arcs = (0..agents).flat_map(|k| network.neighbours(k).iter().map(move |&j| (k, j)));
        Neighbours::from_arcs(agents, arcs.collect::<Vec<_>>())
    };
    let (frequency, gain) = (number(&law, "omega0", 0)?, number(&law, "K1", 0)?);
    Ok(ExactMotion::Phases { phases: start.phases, frequency, gain, network: neighbours })
}

fn exact_platoon(source: &Source) -> Result<ExactMotion, ConfigError> {
    let start = Start::read(source, Needs { dimension: 1, velocities: true, phases: false })?;
    let law = source.needed("law")?;
    let spacing = number(&law, "spacing", 1)?;
    let swing = match law.get("leader") {
        None => (rational(0, 1), rational(0, 1)),
        Some(entry) => {
            let leader = entry.table("law.leader")?;
            // Without a frequency the leader only drives.
            let usual = i64::from(leader.get("frequency").is_some());
            (number(&leader, "amplitude", usual)?, number(&leader, "frequency", 0)?)
        }
    };
    if platoon::leader_of(source, &law, start.positions.len())? > 0 {
        return Ok(ExactMotion::Other("another leader than the first car is not enclosed"));
    }
    let order: Vec<usize> = (0..start.positions.len()).collect();
    let (graph, _) = platoon::tracked(source, &law, &order)?;
    let places = start.positions.iter().flatten().zip(0..);
    let deviations = places.map(|(x, k)| x + &spacing * rational(k, 1)).collect();
    let rates = start.velocities.iter().flatten().cloned().collect();
    let gains = (number(&law, "f", 0)?, number(&law, "g", 0)?);
    Ok(ExactMotion::Platoon { deviations, rates, gains, spacing, graph, swing })
}

/// The scenario with other numbers in the places `state.velocities[1][2]`, `law.K1`, .. (indices from 1). The values are written as texts,
/// so that fractions stay exact.
///
/// # Errors
/// [`ConfigError`] where the text is no TOML, or a place is not there.
pub fn with_numbers(text: &str, numbers: &[(String, Rational)]) -> Result<String, ConfigError> {
    let source = Source::parse(text)?;
    let mut changes = Vec::new();
    for (place, value) in numbers {
        let missing = || ConfigError::NoPlace(place.clone());
        let span = source.place(place).ok_or_else(missing)?;
        changes.push((span, if value.is_integer() { value.to_string() } else { format!("\"{value}\"") }));
    }
    changes.sort_by_key(|(span, _)| span.start);
    let mut changed = text.to_string();
    for (span, value) in changes.into_iter().rev() {
        changed.replace_range(span, &value);
    }
    Ok(changed)
}

/// Whether the scenario draws its start at random.
///
/// # Errors
/// [`ConfigError`] where the text is no TOML.
pub fn is_drawn(text: &str) -> Result<bool, ConfigError> {
    let source = Source::parse(text)?;
    Ok(source.section("state")?.is_some_and(|state| state.get("random").is_some()))
}
