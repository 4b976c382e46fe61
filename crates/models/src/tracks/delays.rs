//! Who turns first: delays between the headings of two fish, as Nagy, Ákos, Biro and Vicsek (Nature 464, 2010) measure them in pigeons.

use super::{Motion, Tracks, Vector};
use arithmetic::{Cancelled, Progress};
use rustfft::num_complex::Complex64;
use rustfft::{Fft, FftPlanner};
use std::sync::Arc;

/// Most positions of a grid of frames.
const MOST_FRAMES: u64 = 1 << 24;
/// A delay without so many frames in which both have a heading is not looked at.
const LEAST_FRAMES: usize = 10;
/// Fewer windows of other lags say nothing.
const LEAST_WINDOWS: usize = 19;

/// The delay of a pair of fish.
#[derive(Debug, Clone, PartialEq)]
pub struct PairDelay {
    /// Numbers of the fish, the smaller first.
    pub pair: [usize; 2],
    /// The lag in frames at which `C(τ)`, the mean of `<z_i(t), z_j(t + τ)>` over the frames in which both have a heading, is largest; positive
    /// where the second fish follows the first. Of equal ones the smallest, a positive one first.
    pub frames: i64,
    /// `C` at that lag.
    pub correlation: f64,
    /// Frames in which both have a heading, so far apart.
    pub both: usize,
    /// `C(0)`; `None` where they never have a heading at once.
    pub at_once: Option<f64>,
    /// Windows of lags beyond the largest delay, of the same length and over at least half of the recording, with at least that correlation
    /// somewhere, and windows.
    pub beyond: (usize, usize),
    /// `C(τ)` for all lags up to the largest, from the most negative one.
    pub curve: Vec<Option<f64>>,
}

impl PairDelay {
    /// `(1 + windows with at least the correlation)/(1 + windows)`; `None` where there are fewer than nineteen.
    pub fn share_at_least(&self) -> Option<f64> {
        let (at_least, windows) = self.beyond;
        (windows >= LEAST_WINDOWS).then(|| (1 + at_least) as f64 / (1 + windows) as f64)
    }
}

/// The delays of all pairs.
#[derive(Debug, Clone, PartialEq)]
pub struct Delays {
    /// The largest lag that is looked at, in frames.
    pub largest: usize,
    /// Pairs that have one, in order.
    pub pairs: Vec<PairDelay>,
    /// For each fish the mean number of frames by which the others follow it; `None` without a pair.
    pub lead: Vec<Option<f64>>,
}

impl Delays {
    /// The pairs, those of the fish that leads most first, and then by the correlation.
    pub fn leading(&self) -> Vec<&PairDelay> {
        let known = self.lead.iter().enumerate().filter_map(|(k, lead)| Some((k, (*lead)?)));
        let leader = known.reduce(|best, next| if next.1 > best.1 { next } else { best }).map(|(k, _)| k);
        let mut pairs: Vec<&PairDelay> = self.pairs.iter().collect();
        let of_leader = |pair: &PairDelay| leader.is_some_and(|k| pair.pair.contains(&k));
        pairs.sort_by(|a, b| of_leader(b).cmp(&of_leader(a)).then(b.correlation.total_cmp(&a.correlation)));
        pairs
    }
}

/// Why there are no delays.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DelaysError {
    /// Not a number of seconds that is shorter than a quarter of the recording and at least a frame.
    #[error(
        "the largest delay of {seconds} s is not between a frame, {step} s, and a quarter of the recording, {longest} s"
    )]
    Longest {
        /// What was asked for.
        seconds: f64,
        /// A frame.
        step: f64,
        /// A quarter of the recording.
        longest: f64,
    },
    /// More frames than are kept.
    #[error("a recording of {0} frames is longer than {MOST_FRAMES}, the most for delays")]
    TooLong(u64),
    /// Stopped.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Headings of one fish on the grid of frames, and where it has one, both transformed.
struct Spectrum {
    headings: Vec<Complex64>,
    present: Vec<Complex64>,
}

/// Delays between the headings of all pairs, up to so many seconds.
///
/// Both series are padded by as many zeros, so that a lag pairs only frames that were recorded; the sums over all lags come from one product of
/// transforms.
///
/// # Errors
/// [`DelaysError`].
pub fn delays(tracks: &Tracks, motion: &Motion, seconds: f64, progress: &dyn Progress) -> Result<Delays, DelaysError> {
    let largest = largest_lag(tracks, seconds)?;
    let frames = tracks.recorded_frames() as usize;
    // A length of small factors, with room for a padding as long as the series.
    let length = (2 * frames).next_power_of_two();
    let mut planner = FftPlanner::new();
    let (there, back) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
    let spectra: Vec<Spectrum> = motion.headings.iter().map(|row| spectrum(tracks, row, length, &there)).collect();
    let fish = spectra.len();
    let all = (fish * fish.saturating_sub(1) / 2) as u64;
    let mut pairs = Vec::new();
    for i in 0..fish {
        for j in i + 1..fish {
            progress.checkpoint()?;
            progress.tell("pairs", pairs.len() as u64, Some(all));
            let correlations = Correlations::new(&spectra[i], &spectra[j], &back);
            pairs.extend(correlations.pair([i, j], frames, largest));
        }
    }
    let lead = (0..fish).map(|k| lead(&pairs, k)).collect();
    Ok(Delays { largest, pairs, lead })
}

/// The largest lag in frames.
///
/// # Errors
/// [`DelaysError`], where it makes no sense for the recording.
pub fn largest_lag(tracks: &Tracks, seconds: f64) -> Result<usize, DelaysError> {
    let (recorded, step) = (tracks.recorded_frames(), tracks.step);
    if recorded > MOST_FRAMES {
        return Err(DelaysError::TooLong(recorded));
    }
    // Of whole frames, and not one too few because the step is rounded.
    let (lag, longest) = ((seconds / step + 1e-6).floor(), recorded / 4);
    if !(lag >= 1.0 && lag <= longest as f64) {
        return Err(DelaysError::Longest { seconds, step, longest: longest as f64 * step });
    }
    Ok(lag as usize)
}

/// The mean number of frames by which the others follow a fish.
fn lead(pairs: &[PairDelay], fish: usize) -> Option<f64> {
    let of = |pair: &PairDelay| match pair.pair {
        [first, _] if first == fish => Some(pair.frames as f64),
        [_, second] if second == fish => Some(-pair.frames as f64),
        _ => None,
    };
    let own: Vec<f64> = pairs.iter().filter_map(of).collect();
    (!own.is_empty()).then(|| own.iter().sum::<f64>() / own.len() as f64)
}

fn spectrum(tracks: &Tracks, row: &[Option<Vector>], length: usize, there: &Arc<dyn Fft<f64>>) -> Spectrum {
    let zeros = || vec![Complex64::new(0.0, 0.0); length];
    let (mut headings, mut present) = (zeros(), zeros());
    for (frame, z) in tracks.frames.iter().zip(row) {
        if let Some(z) = z {
            headings[frame.number as usize] = Complex64::new(z.re, z.im);
            present[frame.number as usize] = Complex64::new(1.0, 0.0);
        }
    }
    there.process(&mut headings);
    there.process(&mut present);
    Spectrum { headings, present }
}

/// Sums of `<z_i(t), z_j(t + τ)>` and numbers of frames for all lags, negative ones from the end.
struct Correlations {
    sums: Vec<f64>,
    counts: Vec<usize>,
}

impl Correlations {
    fn new(first: &Spectrum, second: &Spectrum, back: &Arc<dyn Fft<f64>>) -> Correlations {
        let lagged = |a: &[Complex64], b: &[Complex64]| -> Vec<f64> {
            let mut product: Vec<Complex64> = a.iter().zip(b).map(|(a, b)| a.conj() * b).collect();
            back.process(&mut product);
            product.iter().map(|x| x.re / a.len() as f64).collect()
        };
        let counts = lagged(&first.present, &second.present);
        // Whole numbers, but for the rounding of the transforms.
        let counts = counts.into_iter().map(|count| count.round().max(0.0) as usize).collect();
        Correlations { sums: lagged(&first.headings, &second.headings), counts }
    }

    fn place(&self, lag: i64) -> usize {
        lag.rem_euclid(self.sums.len() as i64) as usize
    }

    fn at(&self, lag: i64) -> Option<f64> {
        let place = self.place(lag);
        (self.counts[place] >= LEAST_FRAMES).then(|| self.sums[place] / self.counts[place] as f64)
    }

    fn largest(&self, lags: impl Iterator<Item = i64>) -> Option<(i64, f64)> {
        let known = lags.filter_map(|lag| Some((lag, self.at(lag)?)));
        known.reduce(|best, next| if next.1 > best.1 + TIE { next } else { best })
    }

    fn pair(&self, pair: [usize; 2], frames: usize, largest: usize) -> Option<PairDelay> {
        let longest = largest as i64;
        // From lag 0 outwards, so that of equal values the smallest lag is kept.
        let outwards = (0..=longest).flat_map(|lag| if lag == 0 { vec![0] } else { vec![lag, -lag] });
        let (lag, correlation) = self.largest(outwards)?;
        let width = 2 * longest + 1;
        let farthest = (frames / 2) as i64;
        let starts = (0..).map(|k| longest + 1 + k * width).take_while(|start| start + width <= farthest + 1);
        let windows = starts.flat_map(|start| [start..start + width, 1 - start - width..1 - start]);
        let highest: Vec<f64> = windows.filter_map(|window| Some(self.largest(window)?.1)).collect();
        let at_least = highest.iter().filter(|&&c| c >= correlation - TIE).count();
        Some(PairDelay {
            pair,
            frames: lag,
            correlation,
            both: self.counts[self.place(lag)],
            at_once: self.at(0),
            beyond: (at_least, highest.len()),
            curve: (-longest..=longest).map(|lag| self.at(lag)).collect(),
        })
    }
}

/// Correlations that differ by less are equal: the transforms round.
const TIE: f64 = 1e-9;
