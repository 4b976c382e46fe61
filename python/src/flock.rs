//! Exact flocks of model D and certified flocks of model K, described by the JSON of the command line.

use super::convert::{Ends, Ratio, count, ends, pair};
use super::refuse;
use super::watch::watched;
use flockproof::arithmetic::{Progress, Rational};
use flockproof::averaging::read::{FlockFile, Model, read_flock};
use flockproof::averaging::settle::{Ending, Limits, settle};
use flockproof::averaging::{Flock, KinematicFlock, Observer, Switch, Weights, declaration, kinematic_declaration};
use flockproof::graph::Graph;
use flockproof::matrix::RationalMatrix;
use num_bigint::BigInt;
use pyo3::prelude::*;
use pyo3::types::PyDict;

type Change = (BigInt, Vec<[usize; 2]>, Vec<[usize; 2]>);

fn change(switch: &Switch) -> Change {
    (switch.time.clone(), from_one(&switch.gained), from_one(&switch.lost))
}

fn from_one(pairs: &[(usize, usize)]) -> Vec<[usize; 2]> {
    pairs.iter().map(|&(i, j)| [i + 1, j + 1]).collect()
}

fn members(list: &[usize]) -> Vec<usize> {
    list.iter().map(|i| i + 1).collect()
}

fn flocks(network: &Graph) -> Vec<Vec<usize>> {
    network.components().iter().map(|flock| members(flock)).collect()
}

fn read(text: &str) -> PyResult<FlockFile> {
    read_flock(text).map_err(refuse)
}

/// Refuses what is no flock; the declaration and the number of birds.
#[pyfunction]
pub fn flock_check(text: &str) -> PyResult<(String, usize)> {
    let trajectory = Trajectory::new(read(text)?.model).map_err(refuse)?;
    Ok((trajectory.declaration(), trajectory.network().order()))
}

/// A flock of either model with its constant control.
enum Trajectory {
    D(Box<Flock>, Option<RationalMatrix>),
    K(Box<KinematicFlock>, Option<Vec<Rational>>),
}

impl Trajectory {
    fn new(model: Model) -> Result<Self, String> {
        let told = |error: flockproof::averaging::FlockError| error.to_string();
        Ok(match model {
            Model::D { start, control } => Trajectory::D(Box::new(Flock::new(&start).map_err(told)?), control),
            Model::K { start, control } => Trajectory::K(Box::new(KinematicFlock::new(&start).map_err(told)?), control),
        })
    }

    fn declaration(&self) -> String {
        match self {
            Trajectory::D(flock, control) => declaration(flock, control.as_ref()),
            Trajectory::K(flock, kappa) => kinematic_declaration(flock, kappa.as_deref()),
        }
    }

    fn step(&mut self) -> Result<Option<Switch>, String> {
        match self {
            Trajectory::D(flock, control) => flock.step_controlled(|_| control.clone()),
            Trajectory::K(flock, kappa) => flock.step_controlled(|_| kappa.clone()),
        }
        .map_err(|error| error.to_string())
    }

    fn network(&self) -> &Graph {
        match self {
            Trajectory::D(flock, _) => flock.network(),
            Trajectory::K(flock, _) => flock.network(),
        }
    }

    fn weights(&self) -> &Weights {
        match self {
            Trajectory::D(flock, _) => flock.weights(),
            Trajectory::K(..) => &Weights::Vicsek,
        }
    }

    fn denominator_bits(&self) -> u64 {
        match self {
            Trajectory::D(flock, _) => flock.denominator_bits(),
            Trajectory::K(flock, _) => flock.denominator_bits(),
        }
    }

    /// Positions and velocities, where they are rational.
    fn state(&self) -> Option<(Vec<Vec<Ratio>>, Vec<Vec<Ratio>>)> {
        let pairs = |rows: Vec<Vec<Rational>>| rows.into_iter().map(|r| r.into_iter().map(pair).collect()).collect();
        match self {
            Trajectory::D(flock, _) => Some((pairs(flock.positions()), pairs(flock.velocities()))),
            Trajectory::K(..) => None,
        }
    }

    fn why(&self, t: u64) -> String {
        match self {
            Trajectory::D(_, None) => {
                format!("stepped to t = {t}; `settle` decides whether the network can ever change again")
            }
            _ => format!("stepped to t = {t}; nothing is said about later times"),
        }
    }
}

/// What `flock run` found out.
struct Stepped {
    trajectory: Trajectory,
    until: u64,
    observer: Observer,
    switches: Vec<Change>,
}

fn steps(
    mut trajectory: Trajectory,
    until: u64,
    from: u64,
    products: bool,
    progress: &dyn Progress,
) -> Result<Stepped, String> {
    let mut observer = Observer::new(trajectory.network().order(), from, products);
    let mut switches = Vec::new();
    for t in 1..=until {
        progress.checkpoint().map_err(|stopped| stopped.to_string())?;
        switches.extend(trajectory.step()?.as_ref().map(change));
        observer.push(t, trajectory.network(), trajectory.weights(), progress).map_err(|error| error.to_string())?;
        if t % 1024 == 0 {
            progress.tell("steps", t, Some(until));
        }
    }
    Ok(Stepped { trajectory, until, observer, switches })
}

/// Steps a flock and returns what `flock run --json` tells, as a dictionary.
#[pyfunction]
pub fn flock_run<'py>(
    py: Python<'py>,
    text: &str,
    until: &Bound<'py, PyAny>,
    from: &Bound<'py, PyAny>,
    products: bool,
    state: bool,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (until, from) = (count("until", until)?, count("from_", from)?);
    let model = read(text)?.model;
    let run = watched(py, progress, move |watch| steps(Trajectory::new(model)?, until, from, products, &**watch))?;
    let Stepped { trajectory, until, observer, switches } = run.map_err(refuse)?;
    let found = PyDict::new(py);
    found.set_item("declaration", trajectory.declaration())?;
    found.set_item("switches", switches)?;
    found.set_item("flocks", flocks(trajectory.network()))?;
    found.set_item("edges", from_one(&trajectory.network().edges()))?;
    found.set_item("until", until)?;
    found.set_item("denominator_bits", trajectory.denominator_bits())?;
    found.set_item("why", trajectory.why(until))?;
    found.set_item("state", if state { trajectory.state() } else { None })?;
    found.set_item("footprint", observer.footprint().map(ToString::to_string))?;
    let stabilisers: Vec<_> = observer.stabilisers().iter().map(|s| (s.time, members(&s.members))).collect();
    found.set_item("stabilisers", stabilisers)?;
    let decay: Vec<_> =
        observer.decay().iter().map(|d| (d.time, pair(d.tau_1.clone()), pair(d.tau_2_squared.clone()))).collect();
    found.set_item("decay", decay)?;
    Ok(found)
}

/// What `flock settle` found out.
struct Settled {
    declaration: String,
    switches: Vec<Change>,
    flocks: Vec<Vec<usize>>,
    edges: Vec<[usize; 2]>,
    steady_from: Option<BigInt>,
    ending: &'static str,
    period: Option<usize>,
    next: Option<(Vec<[usize; 2]>, Ends)>,
    why: String,
}

fn settled(flock: Flock, limits: &Limits, progress: &dyn Progress) -> Result<Settled, String> {
    let declaration = declaration(&flock, None);
    let mut switches = Vec::new();
    let mut found = |switch: &Switch| {
        switches.push(change(switch));
        progress.tell("switches", switches.len() as u64, None);
    };
    let settled = settle(flock, limits, &mut found, progress).map_err(|error| error.to_string())?;
    let (ending, period, next) = match &settled.ending {
        Ending::Steady => ("steady", None, None),
        Ending::Alternating { period } => ("alternating", Some(*period), None),
        Ending::Beyond { pairs, log2_steps } => ("beyond", None, Some((from_one(pairs), ends(log2_steps, 20)))),
        Ending::Undecided(_) => ("undecided", None, None),
        Ending::Interrupted => ("interrupted", None, None),
    };
    Ok(Settled {
        declaration,
        switches,
        flocks: flocks(&settled.network),
        edges: from_one(&settled.network.edges()),
        steady_from: (ending == "steady").then_some(settled.last_switch),
        ending,
        period,
        next,
        why: settled.why,
    })
}

/// Settles a flock and returns what `flock settle --json` tells, as a dictionary.
#[pyfunction]
pub fn flock_settle<'py>(
    py: Python<'py>,
    text: &str,
    steps: Option<&Bound<'py, PyAny>>,
    switches: Option<&Bound<'py, PyAny>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let start = match read(text)?.model {
        Model::D { start, control: None } => start,
        Model::D { control: Some(_), .. } => {
            return Err(refuse("`settle` follows flocks without `control`; `run` steps this one"));
        }
        Model::K { .. } => {
            let why = "`settle` follows model D only, as the positions of model K are not rational; `run` steps it";
            return Err(refuse(why));
        }
    };
    let flock = Flock::new(&start).map_err(refuse)?;
    let mut limits = Limits::default();
    if let Some(steps) = steps {
        limits.steps = count("steps", steps)?;
    }
    if let Some(switches) = switches {
        limits.switches = usize::try_from(count("switches", switches)?).unwrap_or(usize::MAX);
    }
    let settled = watched(py, progress, move |watch| settled(flock, &limits, &**watch))?.map_err(refuse)?;
    let found = PyDict::new(py);
    found.set_item("declaration", settled.declaration)?;
    found.set_item("switches", settled.switches)?;
    found.set_item("flocks", settled.flocks)?;
    found.set_item("edges", settled.edges)?;
    found.set_item("steady_from", settled.steady_from)?;
    found.set_item("ending", settled.ending)?;
    found.set_item("period", settled.period)?;
    found.set_item("next", settled.next)?;
    found.set_item("why", settled.why)?;
    Ok(found)
}
