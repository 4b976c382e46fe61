//! The state that a scenario starts from.

use super::error::{ConfigError, Problem};
use super::source::{Entry, Section, Source};
use arithmetic::Rational;
use arithmetic::random::uniform;
use models::double_integrator::random_flock;
use num_traits::ToPrimitive;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use std::f64::consts::TAU;

/// Most agents.
pub(super) const MOST_AGENTS: usize = 1 << 20;

/// Which lists a model starts from.
#[derive(Clone, Copy)]
pub(super) struct Needs {
    /// Coordinates of a position; 0 for a model without positions.
    pub dimension: usize,
    /// Velocities, from rows of as many coordinates.
    pub velocities: bool,
    /// Phases.
    pub phases: bool,
}

/// Where drawn agents are.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    /// Anywhere in a square.
    Square,
    /// One behind the other, the first at the origin, to the left.
    Line,
    /// On a circle around the origin.
    Ring,
    /// In rows of a square, around the origin.
    Grid,
}

const PLACES: [(&str, Place); 4] =
    [("square", Place::Square), ("line", Place::Line), ("ring", Place::Ring), ("grid", Place::Grid)];

impl Place {
    fn word(self) -> &'static str {
        PLACES.iter().find(|(_, place)| *place == self).map_or("", |(word, _)| word)
    }

    /// The place of agent `k` from 0.
    fn of(self, k: usize, agents: usize, spacing: f64) -> [f64; 2] {
        match self {
            Place::Square => [0.0, 0.0],
            Place::Line => [-spacing * k as f64, 0.0],
            Place::Ring => {
                let (radius, angle) = (spacing * agents as f64 / TAU, TAU * k as f64 / agents as f64);
                [radius * angle.cos(), radius * angle.sin()]
            }
            Place::Grid => {
                let side = (agents as f64).sqrt().ceil() as usize;
                let middle = (side - 1) as f64 / 2.0;
                [spacing * ((k % side) as f64 - middle), spacing * ((k / side) as f64 - middle)]
            }
        }
    }
}

/// Exact initial conditions; lists that the model does not need are empty.
#[derive(Debug, Clone, Default)]
pub(super) struct Start {
    pub positions: Vec<Vec<Rational>>,
    pub velocities: Vec<Vec<Rational>>,
    pub phases: Vec<Rational>,
    /// How it was drawn, where it was.
    pub drawn: Option<String>,
}

/// A number of a description, rounded once.
pub(super) fn float(x: &Rational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

impl Start {
    /// Reads the section `[state]`.
    pub fn read(source: &Source, needs: Needs) -> Result<Self, ConfigError> {
        let section = source.needed("state")?;
        let lists = [("positions", needs.dimension > 0), ("velocities", needs.velocities), ("phases", needs.phases)];
        let mut allowed: Vec<&str> = lists.iter().filter(|(_, needed)| *needed).map(|(name, _)| *name).collect();
        allowed.push("random");
        section.allow(&allowed, " of this model")?;
        if let Some(entry) = section.get("random") {
            for list in ["positions", "velocities", "phases"] {
                if section.get(list).is_some() {
                    return Err(entry.problem(Problem::Both("random", list)));
                }
            }
            return Start::random(&entry.table("state.random")?, needs, source.replica);
        }
        let mut start = Start::default();
        let mut agents = None;
        if needs.dimension > 0 {
            let entry = section.need("positions", "a list with one list of coordinates for each agent")?;
            start.positions = rows(&entry, needs.dimension, &mut agents)?;
        }
        if needs.velocities {
            let entry = section.need("velocities", "a list with one list of coordinates for each agent")?;
            start.velocities = rows(&entry, needs.dimension, &mut agents)?;
        }
        if needs.phases {
            let entry = section.need("phases", "a list with one number in radians for each agent")?;
            start.phases =
                entry.items("a list of numbers in radians")?.iter().map(Entry::finite).collect::<Result<_, _>>()?;
            check_count(&entry, start.phases.len(), &mut agents)?;
        }
        Ok(start)
    }

    fn random(section: &Section, needs: Needs, replica: u64) -> Result<Self, ConfigError> {
        let mut allowed = vec!["agents", "seed"];
        if needs.dimension > 0 {
            allowed.extend(["place", "half", "spacing"]);
        }
        allowed.extend(needs.velocities.then_some("speed"));
        section.allow(&allowed, "")?;
        let agents = section.need("agents", "the number of agents")?.count(1, MOST_AGENTS)?;
        let seed = section.get("seed").map_or(Ok(1), |entry| entry.count(0, usize::MAX))?;
        let usual = if needs.dimension == 1 { Place::Line } else { Place::Square };
        let place = section.get("place").map_or(Ok(usual), |entry| entry.choice(&PLACES))?;
        if let Some(entry) = section.get("place").filter(|_| needs.dimension == 1 && place != Place::Line) {
            return Err(entry.range("\"line\": these agents are on a line"));
        }
        if let Some(entry) = section.get("spacing").filter(|_| place == Place::Square) {
            return Err(entry.range("left out: in the square places are drawn, with `half`"));
        }
        let spacing = section.get("spacing").map_or(Ok(1.0), |entry| entry.positive())?;
        let usual = if place == Place::Square { 10.0 } else { 0.0 };
        let half = section.get("half").map_or(Ok(usual), |entry| entry.not_negative())?;
        if let Some(entry) = section.get("half").filter(|_| place == Place::Square && half == 0.0) {
            return Err(entry.range("a number above 0"));
        }
        let usual = if needs.dimension == 1 { 0.0 } else { 1.0 };
        let speed = section.get("speed").map_or(Ok(usual), |entry| entry.not_negative())?;
        let mut random = ChaCha8Rng::seed_from_u64(seed as u64);
        // Replicas are streams of one generator: they do not overlap.
        random.set_stream(replica);
        let flock = random_flock(agents, half, speed, &mut random);
        let exact = |x: f64| Rational::from_float(x).unwrap_or_default();
        let coordinates = |r: [f64; 2]| r.map(exact)[..needs.dimension.min(2)].to_vec();
        let mut drawn = format!("{agents} agents drawn by ChaCha8 with seed {seed}");
        if replica > 0 {
            drawn += &format!(", replica {}", replica + 1);
        }
        let mut start = Start::default();
        if needs.dimension > 0 {
            let place_of = |k: usize, r: [f64; 2]| {
                let [x, y] = place.of(k, agents, spacing);
                coordinates([x + r[0], y + r[1]])
            };
            start.positions = flock.positions.iter().enumerate().map(|(k, r)| place_of(k, *r)).collect();
            drawn += &match place {
                Place::Square => format!(", positions uniform in |x|, |y| < {half}"),
                _ => format!(
                    ", places on a {} with spacing {spacing}, shifted by uniform numbers in (-{half}, {half})",
                    place.word()
                ),
            };
        }
        if needs.velocities && needs.dimension == 1 {
            // Of either sign; drawn as the first coordinates are.
            start.velocities = (0..agents).map(|_| vec![exact(speed * (2.0 * uniform(&mut random) - 1.0))]).collect();
            drawn += &format!(", velocities uniform in (-{speed}, {speed})");
        } else if needs.velocities {
            start.velocities = flock.velocities.iter().map(|v| coordinates(*v)).collect();
            drawn += &format!(", speeds uniform in (0, {speed}), directions uniform");
        }
        if needs.phases {
            let mut phase = || TAU * uniform(&mut random);
            start.phases = (0..agents).map(|_| exact(phase())).collect();
            drawn += ", phases uniform in [0, 2 pi)";
        }
        start.drawn = Some(drawn);
        Ok(start)
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.positions.len().max(self.phases.len())
    }

    /// `x_1, y_1, ...`, rounded.
    pub fn flat_positions(&self) -> Vec<f64> {
        self.positions.iter().flatten().map(float).collect()
    }

    /// `x_1, y_1, ...` of the velocities, rounded.
    pub fn flat_velocities(&self) -> Vec<f64> {
        self.velocities.iter().flatten().map(float).collect()
    }

    /// The phases, rounded.
    pub fn flat_phases(&self) -> Vec<f64> {
        self.phases.iter().map(float).collect()
    }

    /// Refuses agents at the same place.
    pub fn refuse_coincident(&self, source: &Source) -> Result<(), ConfigError> {
        let mut order: Vec<usize> = (0..self.positions.len()).collect();
        order.sort_by(|&i, &j| self.positions[i].cmp(&self.positions[j]).then(i.cmp(&j)));
        let twice = order.windows(2).find(|pair| self.positions[pair[0]] == self.positions[pair[1]]);
        twice.map_or(Ok(()), |pair| Err(problem(source, "positions", Problem::Coincident(pair[0] + 1, pair[1] + 1))))
    }
}

/// A problem of a key of `[state]`.
pub(super) fn problem(source: &Source, key: &str, problem: Problem) -> ConfigError {
    match source.needed("state") {
        Ok(section) => {
            section.get(key).map_or_else(|| section.problem(problem.clone()), |e| e.problem(problem.clone()))
        }
        Err(error) => error,
    }
}

pub(super) fn rows(
    entry: &Entry,
    dimension: usize,
    agents: &mut Option<usize>,
) -> Result<Vec<Vec<Rational>>, ConfigError> {
    const EXPECTED: &str = "a list with one list of coordinates for each agent";
    let row = |row: &Entry| {
        // On a line a number is a place.
        if dimension == 1 && !row.is_list() {
            return Ok(vec![row.finite()?]);
        }
        let numbers: Vec<Rational> = row.items(EXPECTED)?.iter().map(Entry::finite).collect::<Result<_, _>>()?;
        if numbers.len() != dimension {
            return Err(row.problem(Problem::Coordinates { expected: dimension, found: numbers.len() }));
        }
        Ok(numbers)
    };
    let rows: Vec<Vec<Rational>> = entry.items(EXPECTED)?.iter().map(row).collect::<Result<_, _>>()?;
    check_count(entry, rows.len(), agents)?;
    Ok(rows)
}

pub(super) fn check_count(entry: &Entry, found: usize, agents: &mut Option<usize>) -> Result<(), ConfigError> {
    let expected = *agents.get_or_insert(found);
    match (found, expected) {
        (0, 0) => Err(entry.problem(Problem::NoAgents)),
        _ if found != expected => Err(entry.problem(Problem::Count { agents: expected, found })),
        _ if found > MOST_AGENTS => Err(entry.range(format!("a list of at most {MOST_AGENTS} agents"))),
        _ => Ok(()),
    }
}
