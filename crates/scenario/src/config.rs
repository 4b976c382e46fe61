//! A scenario as its TOML describes it: which model, from which state, until when.

use super::described::Described;
use super::error::{ConfigError, Problem};
use super::exact::ExactMotion;
use super::model::Model;
use super::run::{End, Outcome, Schedule, run};
use super::simulation::Simulation;
use super::source::{Entry, Section, Source};
use super::{alignment, fish, noisy, oscillator, own, platoon, vicsek};
use arithmetic::num_bigint::BigInt;
use arithmetic::{Progress, Rational};
use num_traits::{ToPrimitive, Zero};
use std::sync::{Mutex, PoisonError};

/// Rows of a trajectory, unless the configuration says how many.
const ROWS: usize = 500;

/// Most entries of all rows: rows times agents.
const MOST_ENTRIES: usize = 1 << 22;

/// Reads the section `[run]` for a model with this time step, if it has one.
fn read_schedule(
    source: &Source,
    keys: &[&str],
    step: Option<&Rational>,
    agents: usize,
    with_rows: bool,
) -> Result<Schedule, ConfigError> {
    let section = source.needed("run")?;
    section.allow(&[&["until", "samples", "tolerance", "rows", "observables"], keys].concat(), " of this model")?;
    let entry = section.need("until", "the last time, a number above 0")?;
    let last = entry.positive()?;
    let until = entry.exact()?;
    bounded(&section, &entry, last, step)?;
    on_grid(&entry, &until, step)?;
    let mut sampled: Vec<Rational> = Vec::new();
    let mut before: Option<f64> = None;
    let samples = section.get("samples");
    for item in samples.as_ref().map_or(Ok(Vec::new()), |list| list.items("a list of times"))? {
        let (sample, exact) = (item.number()?, item.exact()?);
        match before {
            _ if sample < 0.0 => return Err(item.range("a time that is not negative")),
            Some(before) if sample <= before => return Err(item.problem(Problem::Order { before, after: sample })),
            _ if exact > until => return Err(item.problem(Problem::Beyond { sample, until: last })),
            _ => before = Some(sample),
        }
        on_grid(&item, &exact, step)?;
        sampled.push(exact);
    }
    if samples.is_none() {
        sampled.push(until.clone());
    }
    let most = MOST_ENTRIES / agents.max(1);
    let mut rows = match section.get("rows") {
        Some(entry) => entry.count(1, most)?,
        None => ROWS.min(most),
    };
    let steps = step.and_then(|step| steps_to(&until, step));
    if let Some(steps) = steps {
        rows = rows.min(steps.to_usize().unwrap_or(usize::MAX));
    }
    let (unit, units) = match (steps, step) {
        (Some(steps), Some(step)) => (step.clone(), steps),
        _ => (&until / Rational::from_integer(rows.into()), rows as u64),
    };
    let ignored = step.is_some() && section.get("tolerance").is_some();
    let (rows, times) = if with_rows {
        (rows, times_of(&unit, units, rows, &sampled))
    } else {
        (0, sampled.iter().map(|time| (time.to_f64().unwrap_or(f64::NAN), true)).collect())
    };
    Ok(Schedule { times, rows, ignored, observables: None })
}

/// The times 0 to `units * unit` in `rows` intervals as equal as multiples of the unit can be, and the sampled ones (ascending) among them:
/// compared exactly, then rounded.
fn times_of(unit: &Rational, units: u64, rows: usize, sampled: &[Rational]) -> Vec<(f64, bool)> {
    let rounded = |time: &Rational| time.to_f64().unwrap_or(f64::NAN);
    // Two integers that are floats have a quotient that is rounded once.
    let small = |n: &BigInt| n.to_u64().filter(|n| *n < 1 << 53);
    let parts = small(&unit.numer()).zip(small(&unit.denom()));
    let time_of = |j: u64| match parts.and_then(|(n, d)| n.checked_mul(j).filter(|n| *n < 1 << 53).map(|n| (n, d))) {
        Some((n, d)) => n as f64 / d as f64,
        None => rounded(&(unit * Rational::from_integer(j.into()))),
    };
    let place = |time: &Rational| (time / unit).floor().to_u64().unwrap_or(u64::MAX);
    let mut sampled = sampled.iter().map(|time| (place(time), (time / unit).is_integer(), time)).peekable();
    let mut times = Vec::with_capacity(rows + 1);
    for k in 0..=rows as u128 {
        let j = (u128::from(units) * k / rows as u128) as u64;
        while let Some((_, _, time)) = sampled.next_if(|(at, ..)| *at < j) {
            times.push((rounded(time), true));
        }
        times.push((time_of(j), sampled.next_if(|(at, whole, _)| *whole && *at == j).is_some()));
    }
    times
}

/// The observables that are asked for by name; nothing where all are.
fn wanted(source: &Source, simulation: &dyn Simulation) -> Result<Option<Vec<String>>, ConfigError> {
    let section = source.needed("run")?;
    let Some(entry) = section.get("observables") else { return Ok(None) };
    // A law that has no value at the start is refused when it is run.
    let observed = simulation.observe().unwrap_or_default();
    let known: Vec<(&str, ())> = observed.iter().map(|observable| (observable.name.as_ref(), ())).collect();
    let names = entry.items("a list of names of observables")?;
    let name = |entry: &Entry| entry.choice(&known).and(entry.word()).map(str::to_string);
    names.iter().map(name).collect::<Result<_, _>>().map(Some)
}

/// Most steps of a run: hours for a few agents.
const MOST_STEPS: f64 = 1e10;
/// The latest time; a float tells it from the time 1e-7 later.
const LATEST: f64 = 1e9;

/// Refuses work that does not end.
fn bounded(section: &Section, until: &Entry, last: f64, step: Option<&Rational>) -> Result<(), ConfigError> {
    let own = section.get("step").map(|entry| entry.positive()).transpose()?;
    match step.and_then(Rational::to_f64).or(own) {
        Some(step) if last / step > MOST_STEPS => {
            let steps = last / step;
            let place = section.get("step").unwrap_or_else(|| until.clone());
            Err(place.problem(Problem::Endless { time: last, step, steps, most: MOST_STEPS }))
        }
        None if last > LATEST => Err(until.problem(Problem::TooLate(last, LATEST))),
        _ => Ok(()),
    }
}

/// The number of steps to a time, where it is one.
fn steps_to(time: &Rational, step: &Rational) -> Option<u64> {
    let steps = time / step;
    if steps.is_integer() { steps.to_integer().to_u64() } else { None }
}

fn on_grid(entry: &Entry, time: &Rational, step: Option<&Rational>) -> Result<(), ConfigError> {
    match step {
        Some(step) if !time.is_zero() && steps_to(time, step).is_none() => {
            Err(entry.problem(Problem::OffGrid { time: time.to_string(), step: step.to_string() }))
        }
        _ => Ok(()),
    }
}

/// The seeds that a configuration has, of its start and of its law.
fn seed(source: &Source) -> Result<Option<String>, ConfigError> {
    let drawn = source.needed("state")?.get("random").map(|entry| entry.table("state.random")).transpose()?;
    let noisy = source.section("law")?.filter(|law| law.get("noise").is_some() || law.get("seed").is_some());
    let seeds: Result<Vec<String>, ConfigError> = drawn
        .into_iter()
        .chain(noisy)
        .map(|section| Ok(section.get("seed").map_or(Ok(1), |entry| entry.count(0, usize::MAX))?.to_string()))
        .collect();
    let seeds = seeds?;
    Ok(if seeds.is_empty() { None } else { Some(seeds.join(", ")) })
}

fn tolerance(source: &Source) -> Result<f64, ConfigError> {
    const DEFAULT: f64 = 1e-10;
    match source.needed("run")?.get("tolerance") {
        None => Ok(DEFAULT),
        Some(entry) => {
            let tolerance = entry.number()?;
            if !(1e-14..=0.1).contains(&tolerance) {
                return Err(entry.range("a number from 1e-14 to 0.1"));
            }
            Ok(tolerance)
        }
    }
}

/// What a file says of a model.
fn described(model: Model, source: &Source) -> Result<Box<dyn Described>, ConfigError> {
    Ok(match model {
        Model::Phase => Box::new(oscillator::PhaseRun::read(source)?),
        Model::Particles => Box::new(oscillator::ParticleRun::read(source)?),
        Model::Fish => Box::new(fish::Fish::read(source)?),
        Model::Headings => Box::new(alignment::Aligned::read(source, true)?),
        Model::Velocities => Box::new(alignment::Aligned::read(source, false)?),
        Model::Platoon => Box::new(platoon::PlatoonRun::read(source)?),
        Model::Vicsek => Box::new(vicsek::Vicsek::read(source)?),
        Model::Noisy => Box::new(noisy::Noisy::read(source)?),
        // Averaging flocks have files of their own and no name here.
        Model::Own | Model::Flock => Box::new(own::describe(source)?),
    })
}

/// Keys of `[run]` that other models do not have.
fn keys(model: Model) -> &'static [&'static str] {
    match model {
        Model::Particles | Model::Headings | Model::Velocities => &["step"],
        Model::Own => &["step", "exact"],
        _ => &[],
    }
}

/// A model, and what the file says of the motion.
struct Description {
    model: Model,
    motion: Box<dyn Described>,
}

impl Description {
    /// Reads everything but the times.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        let several = source.section("ensemble")?.or(source.section("sweep")?);
        several.map_or(Ok(()), |section| Err(ConfigError::Several(section.line())))?;
        Description::of_member(source)
    }

    /// The same of one member of several.
    fn of_member(source: &Source) -> Result<Self, ConfigError> {
        let top = source.top();
        top.allow(&["model", "graph", "state", "law", "run", "ensemble", "sweep"], "")?;
        let names = Model::named();
        let model = top.need("model", &names.map(|(name, _)| name).join(", "))?.choice(&names)?;
        // Of two mistakes the one in [run] comes first.
        tolerance(source)?;
        Ok(Description { model, motion: described(model, source)? })
    }
}

impl ExactMotion {
    /// Reads a scenario.
    ///
    /// # Errors
    /// [`ConfigError`] where it is none.
    pub fn read(text: &str) -> Result<Self, ConfigError> {
        ExactMotion::of(&Source::parse(text)?)
    }

    /// The motion of a scenario that was parsed.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn of(source: &Source) -> Result<Self, ConfigError> {
        let description = Description::read(source)?;
        let exact = description.motion.exact();
        Scenario::of_description(source, description, true)?;
        Ok(exact)
    }

    /// The same, where the numbers of some parameters of a law of one's own stand behind its state ([`expressions::LawText::compile_open`]).
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn of_open(source: &Source, open: &[&str]) -> Result<Self, ConfigError> {
        let motion = ExactMotion::of(source)?;
        Ok(match motion {
            ExactMotion::Own(_) if !open.is_empty() => own::describe_open(source, open)?.exact(),
            _ => motion,
        })
    }
}

/// A model with its start and the times that are asked for, checked and ready to run.
pub struct Scenario {
    model: &'static str,
    schedule: Schedule,
    simulation: Box<dyn Simulation>,
    seed: Option<String>,
}

impl std::fmt::Debug for Scenario {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Scenario").field("model", &self.model).finish_non_exhaustive()
    }
}

impl Scenario {
    /// Reads a configuration.
    ///
    /// # Errors
    /// [`ConfigError`] with the line and key at fault.
    pub fn read(text: &str) -> Result<Self, ConfigError> {
        Scenario::of(&Source::parse(text)?)
    }

    /// The scenario of a configuration that was parsed.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn of(source: &Source) -> Result<Self, ConfigError> {
        Scenario::of_description(source, Description::read(source)?, true)
    }

    /// One run of several: with all rows, or samples only.
    pub(super) fn of_member(source: &Source, with_rows: bool) -> Result<Self, ConfigError> {
        Scenario::of_description(source, Description::of_member(source)?, with_rows)
    }

    fn of_description(source: &Source, description: Description, with_rows: bool) -> Result<Self, ConfigError> {
        let Description { model, motion } = description;
        let (simulation, step) = motion.simulation(source, tolerance(source)?)?;
        let agents = simulation.frame().agents();
        let mut schedule = read_schedule(source, keys(model), step.as_ref(), agents, with_rows)?;
        schedule.observables = wanted(source, simulation.as_ref())?;
        Ok(Scenario { model: model.name(), schedule, simulation, seed: seed(source)? })
    }

    /// The seeds of what is drawn, where anything is.
    pub fn seed(&self) -> Option<&str> {
        self.seed.as_deref()
    }

    /// Whether the agents have places, and not only phases.
    pub fn has_positions(&self) -> bool {
        !self.simulation.frame().positions.is_empty()
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.simulation.frame().agents()
    }

    /// The last time.
    pub fn until(&self) -> f64 {
        self.schedule.times.last().map_or(0.0, |(time, _)| *time)
    }

    /// Equations and choices, one sentence or more a line.
    pub fn declaration(&self) -> Vec<String> {
        [self.simulation.declaration(), self.schedule.declaration()].concat()
    }

    /// Runs it; `progress` may stop it and is told of each row. The result does not depend on the number of threads.
    pub fn run(self, progress: &dyn Progress) -> Outcome {
        let outcome = Mutex::new(self.outset());
        self.run_into(progress, &outcome);
        outcome.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// The outcome of a run that was stopped before its first row.
    pub fn outset(&self) -> Outcome {
        let declaration = self.declaration();
        let (rows, events, remarks) = (Vec::new(), Vec::new(), Vec::new());
        Outcome { model: self.model, declaration, rows, events, remarks, end: End::Interrupted }
    }

    /// [`Scenario::run`], where others can see what is finished while it goes on: rows and events are added to this [`Scenario::outset`] one by
    /// one, remarks and end at last.
    pub fn run_into(mut self, progress: &dyn Progress, outcome: &Mutex<Outcome>) {
        run(&self.schedule, self.simulation.as_mut(), progress, outcome);
    }
}
