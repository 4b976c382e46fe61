//! Scenarios with exact numbers, for enclosures of their motion; and scenarios with other numbers put in.

use super::alignment::READINGS;
use super::config::Scenario;
use super::error::ConfigError;
use super::network::{Abilities, Network};
use super::oscillator::{PARTICLES, PHASES};
use super::own::OwnMotion;
use super::platoon;
use super::potential::PairPotential;
use super::source::{Entry, Section, Source};
use super::start::{Needs, Start};
use arithmetic::{Complex, Rational, rational};
use models::double_integrator::{HeadingDifference, Pair, Potential};
use models::oscillator::Neighbours;
use models::platoon::CommunicationGraph;

/// A motion whose law and start are known exactly.
#[derive(Debug, Clone)]
pub enum ExactMotion {
    /// Velocity alignment or heading alignment (Tanner and others): rows of two coordinates.
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
        /// Of heading alignment, on a fixed network, what a heading difference means.
        headings: Option<HeadingDifference>,
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
    /// Steered particles (Paley and others): `dr_k/dt = e^(i theta_k) + drift`, `d theta_k/dt = frequency + u_k` with the
    /// orientation control (14) and a spacing control.
    Particles {
        /// Where the particles start: rows of two coordinates.
        positions: Vec<Vec<Rational>>,
        /// Their phases, in radians.
        phases: Vec<Rational>,
        /// `omega_0`; not zero where there is a spacing control.
        frequency: Rational,
        /// `K_1`.
        gain: Rational,
        /// The spacing control.
        spacing: ExactSpacing,
        /// The drift, the same for all.
        drift: [Rational; 2],
        /// Who senses whom; at the start, where that depends on the distances.
        network: Neighbours,
        /// The distance below which particles sense each other, where it does.
        radius: Option<Rational>,
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
    /// A law of one's own.
    Own(Box<OwnMotion>),
    /// A motion that cannot be enclosed, and why.
    Other(&'static str),
}

/// What keeps steered particles on circles.
#[derive(Debug, Clone, PartialEq)]
pub enum ExactSpacing {
    /// Nothing.
    None,
    /// (20), with `K_0`.
    Circle(Rational),
    /// `K_0` and the place of the beacon.
    Beacon(Rational, [Rational; 2]),
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
            "velocity-alignment" => alignment(&source, false),
            "heading-alignment" => alignment(&source, true),
            "phase" => phases(&source),
            "particles" => particles(&source),
            "platoon" => exact_platoon(&source),
            "own" => Ok(match OwnMotion::read(&source)? {
                Ok(own) => ExactMotion::Own(Box::new(own)),
                Err(why) => ExactMotion::Other(why),
            }),
            "fish" | "vicsek" => Ok(ExactMotion::Other("its time is discrete and its numbers are drawn or rounded")),
            _ => Ok(ExactMotion::Other("its law is not among those that are enclosed")),
        }
    }
}

const TIMED: &str = "links that are replaced at given times are not enclosed";

fn alignment(source: &Source, headings: bool) -> Result<ExactMotion, ConfigError> {
    let start = Start::read(source, Needs { dimension: 2, velocities: true, phases: false })?;
    let can = Abilities {
        model: if headings { "heading-alignment" } else { "velocity-alignment" },
        positions: true,
        directed: false,
        edges: true,
        timed: true,
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
    if headings && radius.is_some() {
        return Ok(ExactMotion::Other("heading alignment is enclosed on networks that do not switch"));
    }
    let law = source.needed("law")?;
    let potential = PairPotential::read(&law)?.exact().clone();
    let reading = || law.get("heading_difference").map_or(Ok(HeadingDifference::Raw), |entry| entry.choice(&READINGS));
    let headings = headings.then(reading).transpose()?;
    let (positions, velocities, pairs) = (start.positions, start.velocities, network.pairs().to_vec());
    Ok(ExactMotion::Velocities { positions, velocities, potential, pairs, radius, headings })
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
    let network = Network::read(source, start.agents(), PHASES)?;
    let (frequency, gain) = (number(&law, "omega0", 0)?, number(&law, "K1", 0)?);
    Ok(match fixed(&network) {
        Ok(network) => ExactMotion::Phases { phases: start.phases, frequency, gain, network },
        Err(why) => ExactMotion::Other(why),
    })
}

/// The neighbours in a network that stays as it is.
fn fixed(network: &Network) -> Result<Neighbours, &'static str> {
    if network.next_time().is_some() {
        return Err(TIMED);
    }
    if network.switches() {
        return Err("links to the nearest are not enclosed");
    }
    let agents = network.order();
    if network.is_all_to_all() {
        return Ok(Neighbours::complete(agents));
    }
    let arcs = (0..agents).flat_map(|k| network.neighbours(k).iter().map(move |&j| (k, j)));
    Ok(Neighbours::from_arcs(agents, arcs.collect::<Vec<_>>()))
}

/// Two numbers of the law.
fn vector(law: &Section, key: &'static str) -> Result<Option<[Rational; 2]>, ConfigError> {
    let Some(entry) = law.get(key) else { return Ok(None) };
    let items = entry.items("two numbers")?.iter().map(Entry::exact).collect::<Result<Vec<_>, _>>()?;
    Ok(<[Rational; 2]>::try_from(items).ok())
}

fn particles(source: &Source) -> Result<ExactMotion, ConfigError> {
    let start = Start::read(source, Needs { dimension: 2, velocities: false, phases: true })?;
    let law = source.needed("law")?;
    if law.get("K").is_some() || law.get("reference").is_some() {
        return Ok(ExactMotion::Other("of the orientation controls of particles only K1 is enclosed"));
    }
    let network = Network::read(source, start.agents(), PARTICLES)?;
    let radius = match network.radius() {
        None => None,
        Some(_) => Some(source.needed("graph")?.need("radius", "a number")?.exact()?),
    };
    let network = match &radius {
        Some(radius) => within(&start.positions, radius),
        None => match fixed(&network) {
            Ok(network) => network,
            Err(why) => return Ok(ExactMotion::Other(why)),
        },
    };
    let (frequency, gain) = (number(&law, "omega0", 0)?, number(&law, "K1", 0)?);
    let strength = number(&law, "K0", 0)?;
    let spacing = match vector(&law, "beacon")? {
        Some(place) => ExactSpacing::Beacon(strength, place),
        None if strength == rational(0, 1) => ExactSpacing::None,
        None => ExactSpacing::Circle(strength),
    };
    let drift = vector(&law, "drift")?.unwrap_or_else(|| [0, 0].map(|x| rational(x, 1)));
    let (positions, phases) = (start.positions, start.phases);
    Ok(ExactMotion::Particles { positions, phases, frequency, gain, spacing, drift, network, radius })
}

/// Who is nearer to whom than the radius.
fn within(positions: &[Vec<Rational>], radius: &Rational) -> Neighbours {
    let number = |row: &[Rational], k: usize| row.get(k).cloned().unwrap_or_default();
    let points = positions.iter().map(|row| Complex { re: number(row, 0), im: number(row, 1) });
    Neighbours::within(&points.collect::<Vec<_>>(), radius)
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
