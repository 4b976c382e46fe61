//! The models that can be run, a row for each, and what a file says of one.

use super::error::ConfigError;
use super::exact::ExactMotion;
use super::simulation::Simulation;
use super::source::Source;
use super::{alignment, fish, noisy, oscillator, own, platoon, vicsek};
use arithmetic::{Rational, rational};

/// Whose laws move the agents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Model {
    /// The phase model (Paley and others).
    Phase,
    /// Steered particles (Paley and others).
    Particles,
    /// The school of fish (Paley and others).
    Fish,
    /// Heading alignment (Tanner and others).
    Headings,
    /// Velocity alignment (Tanner and others).
    Velocities,
    /// A platoon (Veerman and others).
    Platoon,
    /// Chazelle's models in the plane.
    Vicsek,
    /// The model of Vicsek and others, with noise.
    Noisy,
    /// A law of one's own.
    Own,
    /// An averaging flock in a file of its own (JSON).
    Flock,
}

/// A motion in floats, with the step of discrete time.
pub(super) type Built = (Box<dyn Simulation>, Option<Rational>);

/// What a file says of a motion, read once: floats and enclosures derive from it.
pub(super) trait Described {
    /// The motion, for enclosures.
    fn exact(&self) -> ExactMotion;

    /// The motion in floats; where it cannot start, why.
    fn simulation(self: Box<Self>, source: &Source, tolerance: f64) -> Result<Built, ConfigError>;
}

/// A motion that is not enclosed, and why.
struct Floats(fn(&Source, f64) -> Result<Built, ConfigError>, &'static str);

impl Described for Floats {
    fn exact(&self) -> ExactMotion {
        ExactMotion::Other(self.1)
    }

    fn simulation(self: Box<Self>, source: &Source, tolerance: f64) -> Result<Built, ConfigError> {
        self.0(source, tolerance)
    }
}

/// A model with its name in a file.
pub(super) struct Row {
    pub name: &'static str,
    pub model: Model,
    /// Reads what a file says of it.
    pub read: fn(&Source) -> Result<Box<dyn Described>, ConfigError>,
    /// Keys of `[run]` that other models do not have.
    pub keys: &'static [&'static str],
    enclosed: bool,
}

const DRAWN: &str = "its time is discrete and its numbers are drawn or rounded";
const OTHERS: &str = "its law is not among those that are enclosed";

/// The models of a scenario.
pub(super) const MODELS: [Row; 9] = [
    Row {
        name: "phase",
        model: Model::Phase,
        read: |source| Ok(Box::new(oscillator::PhaseRun::read(source)?)),
        keys: &[],
        enclosed: true,
    },
    Row {
        name: "particles",
        model: Model::Particles,
        read: |source| Ok(Box::new(oscillator::ParticleRun::read(source)?)),
        keys: &["step"],
        enclosed: true,
    },
    Row {
        name: "fish",
        model: Model::Fish,
        read: |_| Ok(Box::new(Floats(|source, _| fish::read(source), DRAWN))),
        keys: &[],
        enclosed: false,
    },
    Row {
        name: "heading-alignment",
        model: Model::Headings,
        read: |source| Ok(Box::new(alignment::Aligned::read(source, true)?)),
        keys: &["step"],
        enclosed: true,
    },
    Row {
        name: "velocity-alignment",
        model: Model::Velocities,
        read: |source| Ok(Box::new(alignment::Aligned::read(source, false)?)),
        keys: &["step"],
        enclosed: true,
    },
    Row {
        name: "platoon",
        model: Model::Platoon,
        read: |source| Ok(Box::new(platoon::PlatoonRun::read(source)?)),
        keys: &[],
        enclosed: true,
    },
    Row {
        name: "vicsek",
        model: Model::Vicsek,
        read: |_| Ok(Box::new(Floats(|source, _| Ok((vicsek::read(source)?, Some(rational(1, 1)))), DRAWN))),
        keys: &[],
        enclosed: false,
    },
    Row {
        name: "vicsek-noise",
        model: Model::Noisy,
        read: |_| Ok(Box::new(Floats(|source, _| Ok((noisy::read(source)?, Some(rational(1, 1)))), OTHERS))),
        keys: &[],
        enclosed: false,
    },
    Row {
        name: "own",
        model: Model::Own,
        read: |source| Ok(Box::new(own::describe(source)?)),
        keys: &["step", "exact"],
        enclosed: true,
    },
];

impl Model {
    fn row(self) -> Option<&'static Row> {
        const { &MODELS }.iter().find(|row| row.model == self)
    }

    /// The name in a file, or what it is.
    pub fn name(self) -> &'static str {
        self.row().map_or("averaging flock", |row| row.name)
    }

    /// Whether its motions can be enclosed.
    pub fn is_enclosed(self) -> bool {
        self.row().is_some_and(|row| row.enclosed)
    }
}
