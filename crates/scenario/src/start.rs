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

/// Exact initial conditions; lists that the model does not need are empty.
#[derive(Debug, Clone, Default)]
pub(super) struct Start {
    pub positions: Vec<Vec<Rational>>,
    pub velocities: Vec<Vec<Rational>>,
    pub phases: Vec<Rational>,
    /// How it was drawn, where it was.
    pub drawn: Option<String>,
}

fn float(x: &Rational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

impl Start {
    /// Reads the section `[state]`.
    pub fn read(source: &Source, needs: Needs) -> Result<Self, ConfigError> {
        let section = source.needed("state")?;
        let lists = [("positions", needs.dimension > 0), ("velocities", needs.velocities), ("phases", needs.phases)];
        let mut allowed: Vec<&str> = lists.iter().filter(|(_, needed)| *needed).map(|(name, _)| *name).collect();
        if needs.dimension != 1 {
            allowed.push("random");
        }
        section.allow(&allowed, " of this model")?;
        if let Some(entry) = section.get("random") {
            for list in ["positions", "velocities", "phases"] {
                if section.get(list).is_some() {
                    return Err(entry.problem(Problem::Both("random", list)));
                }
            }
            return Start::random(&entry.table("state.random")?, needs);
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
            start.phases = entry.items("a list of numbers in radians")?.iter().map(finite).collect::<Result<_, _>>()?;
            check_count(&entry, start.phases.len(), &mut agents)?;
        }
        Ok(start)
    }

    fn random(section: &Section, needs: Needs) -> Result<Self, ConfigError> {
        let mut allowed = vec!["agents", "seed"];
        allowed.extend((needs.dimension > 0).then_some("half"));
        allowed.extend(needs.velocities.then_some("speed"));
        section.allow(&allowed, "")?;
        let agents = section.need("agents", "the number of agents")?.count(1, MOST_AGENTS)?;
        let seed = section.get("seed").map_or(Ok(1), |entry| entry.count(0, usize::MAX))?;
        let half = section.get("half").map_or(Ok(10.0), |entry| entry.positive())?;
        let speed = section.get("speed").map_or(Ok(1.0), |entry| entry.positive())?;
        let mut random = ChaCha8Rng::seed_from_u64(seed as u64);
        let flock = random_flock(agents, half, speed, &mut random);
        let exact = |x: f64| Rational::from_float(x).unwrap_or_default();
        let list = |list: &[[f64; 2]]| list.iter().map(|r| r.map(exact).to_vec()).collect();
        let mut drawn = format!("{agents} agents drawn by ChaCha8 with seed {seed}");
        let mut start = Start::default();
        if needs.dimension > 0 {
            start.positions = list(&flock.positions);
            drawn += &format!(", positions uniform in |x|, |y| < {half}");
        }
        if needs.velocities {
            start.velocities = list(&flock.velocities);
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

fn finite(entry: &Entry) -> Result<Rational, ConfigError> {
    entry.number()?;
    entry.exact()
}

fn rows(entry: &Entry, dimension: usize, agents: &mut Option<usize>) -> Result<Vec<Vec<Rational>>, ConfigError> {
    const EXPECTED: &str = "a list with one list of coordinates for each agent";
    let row = |row: &Entry| {
        let numbers: Vec<Rational> = row.items(EXPECTED)?.iter().map(finite).collect::<Result<_, _>>()?;
        if numbers.len() != dimension {
            return Err(row.problem(Problem::Coordinates { expected: dimension, found: numbers.len() }));
        }
        Ok(numbers)
    };
    let rows: Vec<Vec<Rational>> = entry.items(EXPECTED)?.iter().map(row).collect::<Result<_, _>>()?;
    check_count(entry, rows.len(), agents)?;
    Ok(rows)
}

fn check_count(entry: &Entry, found: usize, agents: &mut Option<usize>) -> Result<(), ConfigError> {
    let expected = *agents.get_or_insert(found);
    match (found, expected) {
        (0, 0) => Err(entry.problem(Problem::NoAgents)),
        _ if found != expected => Err(entry.problem(Problem::Count { agents: expected, found })),
        _ if found > MOST_AGENTS => Err(entry.range(format!("a list of at most {MOST_AGENTS} agents"))),
        _ => Ok(()),
    }
}
