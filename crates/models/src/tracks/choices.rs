//! What the analysis has to choose, with the values of the sidebar where it gives them.

use super::Smoothing;
use crate::oscillator::Zones;
use arithmetic::Cancelled;

/// Which single neighbour stands for `n = 1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NearestRule {
    /// The sidebar: the nearest, but the second nearest where the nearest is in the zone of repulsion.
    SecondInRepulsion,
    /// The nearest.
    Nearest,
}

/// Which positions networks and distances are made from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PositionsUsed {
    /// As in the file.
    File,
    /// Smoothed as for the headings.
    Smoothed,
}

/// The choices of an analysis. Lengths are in the unit of the file, times in seconds.
#[derive(Debug, Clone, PartialEq)]
pub struct Choices {
    /// How positions are smoothed before velocities are taken.
    pub smoothing: Smoothing,
    /// Frames that are smoothed over, odd.
    pub window: usize,
    /// Positions for networks and distances.
    pub positions: PositionsUsed,
    /// Body length `b`.
    pub body_length: f64,
    /// Outer radii of the zones of repulsion, orientation and attraction in body lengths.
    pub zones: [f64; 3],
    /// Angular width of the blind spot in degrees.
    pub blind: f64,
    /// A fish that is no faster has no heading.
    pub still: f64,
    /// The single neighbour of `n = 1`.
    pub rule: NearestRule,
    /// Other numbers of neighbours for which `W_1` is reported.
    pub nearest: Vec<usize>,
    /// Frames count in which at least so many fish have a heading; all fish without it.
    pub min_fish: Option<usize>,
}

/// Choices that make no sense.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ChoicesError {
    /// A window without a middle.
    #[error("the window of {0} frames has no middle frame; it must be odd")]
    EvenWindow(usize),
    /// A window of too few frames for the smoothing.
    #[error("the smoothing {name} needs a window of at least {least} frames, not {window}")]
    ShortWindow {
        /// The smoothing.
        name: &'static str,
        /// What it needs.
        least: usize,
        /// The window.
        window: usize,
    },
    /// Not a positive length.
    #[error("the body length {0} is not a positive number")]
    BodyLength(f64),
    /// Zones out of order.
    #[error("the zones {0}, {1}, {2} must have growing radii, the first of them positive")]
    Zones(f64, f64, f64),
    /// Not two or three zones.
    #[error("there are two or three radii of zones, such as 1.4,2.4, not {0}")]
    ZoneCount(usize),
    /// A blind spot wider than a half turn.
    #[error("the blind spot of {0} degrees is not between 0 and 180")]
    Blind(f64),
    /// A speed below zero.
    #[error("the speed {0} of a fish at rest is not zero or a positive number")]
    Still(f64),
    /// More neighbours than there are.
    #[error("{fish} fish have between 1 and {} neighbours, not {n}", fish.saturating_sub(1))]
    Neighbours {
        /// The number that was asked for.
        n: usize,
        /// How many fish there are.
        fish: usize,
    },
    /// A number of fish that no frame has, or with which nothing can be compared.
    #[error("frames with at least {least} fish are asked for; of {fish} fish it can be between 2 and {fish}")]
    LeastFish {
        /// The number that was asked for.
        least: usize,
        /// How many fish there are.
        fish: usize,
    },
    /// A recording put together by hand whose parts do not fit.
    #[error("a recording of {fish} fish in {frames} frames needs as many positions of each fish")]
    Recording {
        /// How many fish there are.
        fish: usize,
        /// How many frames there are.
        frames: usize,
    },
    /// The window is longer than any run of frames.
    #[error("{0}")]
    NothingLeft(String),
    /// Stopped before there was a frame with a heading of every fish.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl ChoicesError {
    /// The choice that is wrong, as in Python; with hyphens it is the option of the command line. `None` where it is the recording.
    pub fn choice(&self) -> Option<&'static str> {
        match self {
            ChoicesError::EvenWindow(_) | ChoicesError::ShortWindow { .. } => Some("window"),
            ChoicesError::BodyLength(_) => Some("body_length"),
            ChoicesError::Zones(..) | ChoicesError::ZoneCount(_) => Some("zones"),
            ChoicesError::Blind(_) => Some("blind"),
            ChoicesError::Still(_) => Some("still"),
            ChoicesError::Neighbours { .. } => Some("nearest"),
            ChoicesError::LeastFish { .. } => Some("min_fish"),
            ChoicesError::Recording { .. } | ChoicesError::NothingLeft(_) | ChoicesError::Cancelled(_) => None,
        }
    }
}

impl Choices {
    /// The body length of the sidebar's fish in centimetres.
    pub const BODY_LENGTH_OF_SIDEBAR: f64 = 5.3;

    /// The choices of the sidebar for frames of `step` seconds: velocities averaged over the odd number of frames that is closest to
    /// five seconds, `b = 5.3` (cm), zones to `1.4 b` and `2.4 b`, a blind spot of 60 degrees, and the second nearest neighbour where
    /// the nearest is in the zone of repulsion. The sidebar gives no outer radius of attraction: none here.
    pub fn of_sidebar(step: f64) -> Choices {
        const SECONDS: f64 = 5.0;
        // A cast saturates, so that any step gives a window.
        let half = ((SECONDS / step - 1.0) / 2.0).round().clamp(0.0, 1e9) as usize;
        Choices {
            smoothing: Smoothing::Mean,
            window: 2 * half + 1,
            positions: PositionsUsed::File,
            body_length: Self::BODY_LENGTH_OF_SIDEBAR,
            zones: [1.4, 2.4, f64::INFINITY],
            blind: 60.0,
            still: 0.0,
            rule: NearestRule::SecondInRepulsion,
            nearest: Vec::new(),
            min_fish: None,
        }
    }

    /// The outer radii of the zones from a list of two, without an end of attraction, or three.
    ///
    /// # Errors
    /// [`ChoicesError::ZoneCount`].
    pub fn radii_of_zones(radii: &[f64]) -> Result<[f64; 3], ChoicesError> {
        match *radii {
            [repulsion, orientation] => Ok([repulsion, orientation, f64::INFINITY]),
            [repulsion, orientation, attraction] => Ok([repulsion, orientation, attraction]),
            _ => Err(ChoicesError::ZoneCount(radii.len())),
        }
    }

    /// Checks the choices for so many fish.
    ///
    /// # Errors
    /// [`ChoicesError`].
    pub fn check(&self, fish: usize) -> Result<(), ChoicesError> {
        let [repulsion, orientation, attraction] = self.zones;
        if self.window.is_multiple_of(2) {
            return Err(ChoicesError::EvenWindow(self.window));
        }
        if self.window < self.smoothing.least_window() {
            let (name, least) = (self.smoothing.name(), self.smoothing.least_window());
            return Err(ChoicesError::ShortWindow { name, least, window: self.window });
        }
        if !(self.body_length > 0.0 && self.body_length.is_finite()) {
            return Err(ChoicesError::BodyLength(self.body_length));
        }
        if !(repulsion > 0.0 && repulsion < orientation && orientation < attraction) {
            return Err(ChoicesError::Zones(repulsion, orientation, attraction));
        }
        if !(0.0..=180.0).contains(&self.blind) {
            return Err(ChoicesError::Blind(self.blind));
        }
        if !(self.still >= 0.0 && self.still.is_finite()) {
            return Err(ChoicesError::Still(self.still));
        }
        let least = self.least_fish(fish);
        if self.min_fish.is_some() && !(2..=fish).contains(&least) {
            return Err(ChoicesError::LeastFish { least, fish });
        }
        match self.nearest.iter().find(|&&n| n == 0 || n >= least) {
            Some(&n) => Err(ChoicesError::Neighbours { n, fish: least }),
            None => Ok(()),
        }
    }

    /// How many fish a frame needs, of so many.
    pub fn least_fish(&self, fish: usize) -> usize {
        self.min_fish.unwrap_or(fish)
    }

    /// The zones in the unit of the file.
    pub fn zones(&self) -> Zones<f64> {
        let [repulsion, orientation, attraction] = self.zones.map(|radius| radius * self.body_length);
        let half = (self.blind / 2.0).to_radians().cos();
        Zones { repulsion, orientation, attraction, blind_cosine_squared: half * half }
    }

    /// The radius within which the nearest neighbour is passed over.
    pub fn too_near(&self) -> Option<f64> {
        (self.rule == NearestRule::SecondInRepulsion).then_some(self.zones[0] * self.body_length)
    }
}
