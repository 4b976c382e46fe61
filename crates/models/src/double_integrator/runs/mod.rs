//! Flocks that are followed in floats, from what is asked for to what is seen, and enclosed.

mod arrival;
mod closed_loop;
mod enclosed;
mod energy_log;
mod flock;
mod fork;
mod individual;
mod input;
mod motion;
mod observation;
mod random;
mod setup;
mod switching;
mod threshold;

pub use closed_loop::follow;
pub use enclosed::{
    Crossing, EnclosedEvent, EnclosedFlock, EnclosedRun, EnclosureError, FixedNetwork, LinkedAgents, SwitchingMotion,
};
pub use energy_log::{EnergyLog, Excess};
pub use flock::{FlockError, SwitchingFlock};
pub use fork::{Branch, Fork, ForkError, MOST_GRAZING, Way, fork};
pub use individual::{HeadingLaw, VelocityLaw};
pub use input::{Alignment, Flock, InputError, Network};
pub use motion::{Choice, Event, EventKind, Motion, MotionError, Options, Prefer, Sample};
pub use observation::{Observation, Trial};
pub use random::{random_flock, random_vectors};
pub use setup::{HeadingReading, LinkRule, Setup, StartRule};
