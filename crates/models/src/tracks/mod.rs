//! Measured trajectories, read from a table and analysed as in the sidebar "Analysis of Fish Data" of Paley, Leonard,
//! Sepulchre, Grünbaum and Parrish: headings, nearest neighbours, zones, scaled phase potentials, and what their values mean
//! under null models without interaction.
//!
//! Nothing is filled in unless bridges over short gaps are asked for ([`Tracks::bridge`]): what needs a fish leaves out the frames in
//! which it is missing, and the gaps are listed.
//! `notes/tracks.md` has the file format, the formulas and the choices.

mod analysis;
mod attributes;
mod bridge;
mod choices;
mod delays;
mod gaps;
mod histogram;
mod measures;
mod motion;
mod named;
mod npy;
mod null;
mod potential;
mod read;
mod smoothing;
mod synthetic;
mod times;
mod trackers;

pub use analysis::{Analysis, FishSummary, LeftOut, Reason, analyse};
pub use attributes::Attributes;
pub use bridge::BridgeShape;
pub use choices::{Choices, ChoicesError, NearestRule, PositionsUsed};
pub use delays::{Delays, DelaysError, PairDelay, delays, largest_lag};
pub use gaps::{Gap, gaps};
pub use histogram::Histogram;
pub use measures::{FrameMeasures, GroupState, ZonePresence, nearest_neighbour};
pub use motion::Motion;
pub use named::{UnknownName, named};
pub use null::{
    Comparison, NullKind, NullModels, Sample, Statistics, UniformShares, null_models, uniform_draw, uniform_draws,
};
pub use potential::{Scale, complete_potential, partner_potential};
pub use read::csv_field;
pub use read::{Format, FormatError, Frame, Tracks, TracksError};
pub use smoothing::{Smoothing, smoothed};
pub use synthetic::{School, Setting, synthetic_school};
pub use trackers::Form;

use arithmetic::Complex;

/// A point or vector of the horizontal plane, in the unit of the file.
pub type Vector = Complex<f64>;
