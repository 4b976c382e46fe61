//! Averaging with the weights `1/(d_i + 1)` (Chazelle): model D from velocities, exact; model K from phases, certified.

use super::described::{Built, Described};
use super::error::{ConfigError, Problem, RunError};
use super::exact::{DRAWN, ExactMotion};
use super::model::Model;
use super::network::Change;
use super::observables::{CLUSTERS, Observable, observe};
use super::simulation::{Event, Frame, Simulation};
use super::source::Source;
use super::start::{Needs, Start, float};
use super::view::{Links, Rows, Sensing, View};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Complex, Progress, Rational, rational};
use models::averaging::{
    Flock, Hysteresis, KinematicFlock, KinematicStart, Start as FlockStart, Switch, Weights, declaration,
    kinematic_declaration,
};
use models::oscillator::{Flight, Neighbours};
use num_traits::Signed;
use std::borrow::Cow;

/// A flock whose lengths are in units of the radius.
enum Birds {
    D(Box<Flock>),
    K(Box<KinematicFlock>),
}

/// A flock with its unit of length.
pub(super) struct Vicsek {
    birds: Birds,
    radius: Rational,
    time: u64,
    drawn: Option<String>,
}

/// The radius of `[graph]`, 1 where it is left out.
fn radius(source: &Source) -> Result<Rational, ConfigError> {
    let Some(section) = source.section("graph")? else { return Ok(rational(1, 1)) };
    let kind = section.need("kind", "within")?;
    if kind.word()? != "within" {
        let needs = "a graph of kind \"within\": its network is that of the distances";
        return Err(kind.problem(Problem::Network { model: "vicsek", needs }));
    }
    section.allow(&["kind", "radius"], " of the vicsek model")?;
    match section.get("radius") {
        None => Ok(rational(1, 1)),
        Some(entry) => {
            entry.positive()?;
            entry.exact()
        }
    }
}

impl Described for Vicsek {
    fn exact(&self) -> ExactMotion {
        ExactMotion::Other(DRAWN)
    }

    fn simulation(self: Box<Self>, _: &Source, _: f64) -> Result<Built, ConfigError> {
        Ok((self, Some(rational(1, 1))))
    }
}

impl Vicsek {
    /// Reads the model.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        // Of a drawn start the speed tells that headings are meant.
        let has_speed = source.section("law")?.is_some_and(|law| law.get("speed").is_some());
        let state = source.needed("state")?;
        let headings = state.get("phases").is_some() || state.get("random").is_some() && has_speed;
        let start = Start::read(source, Needs { dimension: 2, velocities: !headings, phases: headings })?;
        let radius = radius(source)?;
        let law = source.section("law")?;
        if let Some(law) = &law {
            let keys: &[&str] = if headings { &["speed", "hysteresis"] } else { &["hysteresis"] };
            law.allow(keys, " of the vicsek model")?;
        }
        let hysteresis = match law.and_then(|law| law.get("hysteresis")) {
            None => Hysteresis::None,
            Some(entry) if entry.word() == Ok("none") => Hysteresis::None,
            Some(entry) if entry.word() == Ok("paper") => Hysteresis::Paper,
            Some(entry) => {
                let threshold = entry.exact()?;
                if threshold.is_negative() {
                    return Err(entry.range("\"none\", \"paper\" or a number that is not negative"));
                }
                Hysteresis::Constant(threshold / &radius)
            }
        };
        let scaled = |rows: &[Vec<Rational>]| -> Vec<Vec<Rational>> {
            rows.iter().map(|row| row.iter().map(|x| x / &radius).collect()).collect()
        };
        let refuse = |error: models::averaging::FlockError| super::start::problem(source, "positions", error.into());
        let birds = if headings {
            let Some(law) = law else { return Err(ConfigError::MissingSection("law")) };
            let entry = law.need("speed", "a number above 0")?;
            entry.positive()?;
            let points = scaled(&start.positions).into_iter().map(|row| Complex::new(row[0].clone(), row[1].clone()));
            let start = KinematicStart {
                speed: entry.exact()? / &radius,
                positions: points.collect(),
                headings: start.phases.clone(),
                hysteresis,
            };
            Birds::K(Box::new(KinematicFlock::new(&start).map_err(refuse)?))
        } else {
            let start = FlockStart {
                positions: scaled(&start.positions),
                velocities: scaled(&start.velocities),
                weights: Weights::Vicsek,
                hysteresis,
            };
            Birds::D(Box::new(Flock::new(&start).map_err(refuse)?))
        };
        Ok(Vicsek { birds, radius, time: 0, drawn: start.drawn })
    }

    fn network(&self) -> &Graph {
        match &self.birds {
            Birds::D(flock) => flock.network(),
            Birds::K(flock) => flock.network(),
        }
    }

    fn step(&mut self) -> Result<Option<Switch>, RunError> {
        Ok(match &mut self.birds {
            Birds::D(flock) => flock.step()?,
            Birds::K(flock) => flock.step()?,
        })
    }
}

impl Simulation for Vicsek {
    fn advance(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        while (self.time as f64) < until.round() {
            if progress.is_cancelled() {
                return Ok(false);
            }
            let switch = self.step()?;
            self.time += 1;
            if let Some(Switch { gained, lost, .. }) = switch {
                let change = |gained: bool| move |&pair: &(usize, usize)| Change { gained, pair };
                let changes = gained.iter().map(change(true)).chain(lost.iter().map(change(false)));
                events.extend(changes.map(|change| Event::new(self.time as f64, &change)));
            }
        }
        Ok(true)
    }

    fn frame(&self) -> Frame {
        let unit = float(&self.radius);
        let rows = |rows: Vec<Vec<Rational>>| -> Vec<Vec<f64>> {
            rows.into_iter().map(|row| row.into_iter().map(|x| float(&(x * &self.radius))).collect()).collect()
        };
        match &self.birds {
            Birds::D(flock) => {
                Frame { positions: rows(flock.positions()), velocities: rows(flock.velocities()), ..Frame::default() }
            }
            Birds::K(flock) => {
                let place = |x: &arithmetic::Interval| unit * x.to_f64();
                let positions = flock.positions().iter().map(|r| vec![place(&r.re), place(&r.im)]).collect();
                let phases = flock.headings().iter().map(float).collect();
                Frame { positions, phases, ..Frame::default() }
            }
        }
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.network().edges()
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        let Frame { positions, velocities, phases, .. } = self.frame();
        let graph = self.network();
        let view = View {
            phasors: Flight { positions: Vec::new(), phases: phases.clone() }.state().phasors,
            orders: 4.min(phases.len() as u32),
            phases: &phases,
            velocities: Rows::of(velocities.len(), || velocities),
            positions: Rows::of(positions.len(), || positions),
            sensing: Sensing::These(Cow::Owned(Neighbours::of(graph))),
            ..View::new(Model::Vicsek, Links::These(graph.order(), graph.edges().into()))
        };
        observe(&view, &["disagreement", "momentum"])
    }

    fn declaration(&self) -> Vec<String> {
        let text = match &self.birds {
            Birds::D(flock) => declaration(flock, None),
            Birds::K(flock) => kinematic_declaration(flock, None),
        };
        let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
        if self.radius != rational(1, 1) {
            lines.push(format!("all lengths above are in units of the radius {}", self.radius));
        }
        if matches!(self.birds, Birds::K(_)) {
            lines.push(CLUSTERS.to_string());
        }
        lines.push("exact steps, rounded once where they are written; velocities and phases at t are those of the step to t + 1".to_string());
        lines.extend(self.drawn.clone());
        lines
    }
}
