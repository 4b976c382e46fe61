//! What a file says of a motion, read once: floats and enclosures derive from it.

use super::error::ConfigError;
use super::exact::ExactMotion;
use super::simulation::Simulation;
use super::source::Source;
use arithmetic::Rational;

/// A motion in floats, with the step of discrete time.
pub(super) type Built = (Box<dyn Simulation>, Option<Rational>);

/// A motion as it is described.
pub(super) trait Described {
    /// The motion, for enclosures.
    fn exact(&self) -> ExactMotion;

    /// The motion in floats; where it cannot start, why.
    fn simulation(self: Box<Self>, source: &Source, tolerance: f64) -> Result<Built, ConfigError>;
}
