//! What the scaled potentials look like without any interaction: independent uniform headings, and headings or tracks shifted in
//! time against each other.

use super::measures::{nearest_neighbour, partners, rotation};
use super::potential::{complete_potential, mean, partner_potential};
use super::{Choices, Histogram, Scale, Vector};
use crate::oscillator::{Zone, Zones};
use arithmetic::random::{generator, uniform};
use arithmetic::{Cancelled, Complex, Progress};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicU64, Ordering};

/// A difference counts as positive above this: rounding of numbers that are zero.
const ROUNDING: f64 = 1e-12;
/// At least so many draws of independent uniform headings.
const DRAWS: usize = 20_000;

/// How many numbers [`Statistics`] has.
const STATISTICS: usize = 10;

/// Positions and headings of all fish in the frames that have all of them, `[frame][fish]`.
#[derive(Debug, Clone)]
pub struct Sample {
    positions: Vec<Vec<Vector>>,
    headings: Vec<Vec<Vector>>,
    partners: Vec<Vec<usize>>,
    /// Mean distance to the nearest neighbour in each frame.
    nearest: Vec<f64>,
    zones: Zones<f64>,
    too_near: Option<f64>,
}

/// Numbers that a recording and its shifted copies have.
#[derive(Debug, Clone, PartialEq)]
pub struct Statistics {
    /// Share of frames in which the scaled potential is larger for `n = N - 1` than for `n = 1`, in the order of [`Scale::ALL`].
    pub positive: [f64; 3],
    /// Mean of that difference.
    pub difference: [f64; 3],
    /// Mean of `|p_1|`, the polarisation.
    pub order: f64,
    /// Mean of the modulus of the rotation (milling, to either side).
    pub rotation: f64,
    /// Mean distance to the nearest neighbour, in the unit of the file.
    pub nearest: f64,
    /// Mean of `cos theta_kj` over all arcs to neighbours in the zone of orientation; `None` where there are none.
    pub zone_alignment: Option<f64>,
    /// The difference with the scale of Figure S3.
    pub histogram: Histogram,
}

impl Statistics {
    /// Names, in the order of [`Statistics::values`].
    pub const NAMES: [&'static str; STATISTICS] = [
        "positive_2/(n+1)",
        "positive_2/n+1",
        "positive_1/n",
        "difference_2/(n+1)",
        "difference_2/n+1",
        "difference_1/n",
        "order",
        "zone_alignment",
        "rotation",
        "nearest_distance",
    ];

    /// The numbers.
    pub fn values(&self) -> [Option<f64>; STATISTICS] {
        let ([a, b, c], [d, e, f]) = (self.positive, self.difference);
        let aligned = self.zone_alignment;
        let [order, rotation, nearest] = [self.order, self.rotation, self.nearest].map(Some);
        [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f), order, aligned, rotation, nearest]
    }
}

/// Which series of a fish is shifted in time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NullKind {
    /// Its headings; positions stay, and with them the nearest neighbours.
    Headings,
    /// Its positions and headings together: what fish that swim alone in the same tank would show.
    Tracks,
}

impl NullKind {
    /// In letters.
    pub fn name(self) -> &'static str {
        match self {
            NullKind::Headings => "headings shifted",
            NullKind::Tracks => "tracks shifted",
        }
    }
}

/// One number of the recording beside its values under a null model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    /// Of the recording.
    pub observed: f64,
    /// Mean over the shifts.
    pub mean: f64,
    /// The 2.5% and 97.5% points of the shifts.
    pub range: (f64, f64),
    /// Shifts with at least the observed value, and shifts.
    pub at_least: (usize, usize),
    /// `(1 + number of shifts with at least the observed value)/(1 + number of shifts)`.
    pub share_at_least: f64,
    /// The same with at most the observed value.
    pub share_at_most: f64,
}

/// Independent uniform headings on the networks of the recording.
#[derive(Debug, Clone, PartialEq)]
pub struct UniformShares {
    /// How many draws.
    pub draws: usize,
    /// Draws with a positive difference, in the order of [`Scale::ALL`].
    pub positive: [usize; 3],
    /// Scaled potentials (Figure S3) for `n = N - 1` and `n = 1`, and their difference.
    pub histograms: [Histogram; 3],
}

/// A recording against all null models.
#[derive(Debug, Clone)]
pub struct NullModels {
    /// The numbers of the recording.
    pub observed: Statistics,
    /// Share of frames in which the neighbours for `n = 1` form pairs: there the difference `2/(n+1)` is never negative.
    pub in_pairs: f64,
    /// Independent uniform headings.
    pub uniform: UniformShares,
    /// The two shifts: comparisons in the order of [`Statistics::NAMES`], and the differences of all shifts.
    pub shifted: Vec<(NullKind, [Option<Comparison>; STATISTICS], Histogram)>,
    /// How many shifts of each kind.
    pub shifts: usize,
}

/// The bins of differences.
fn difference_bins() -> Histogram {
    Histogram::new(-1.0, 1.0, 40)
}

impl Sample {
    pub(super) fn new(positions: Vec<Vec<Vector>>, headings: Vec<Vec<Vector>>, choices: &Choices) -> Sample {
        let too_near = choices.too_near();
        let partners = positions.iter().map(|frame| partners(frame, too_near)).collect();
        let nearest = positions.iter().map(|frame| mean_nearest(frame)).collect();
        Sample { positions, headings, partners, nearest, zones: choices.zones(), too_near }
    }

    /// Number of frames.
    pub fn frames(&self) -> usize {
        self.headings.len()
    }

    fn fish(&self) -> usize {
        self.headings.first().map_or(0, Vec::len)
    }

    /// The numbers with the headings of fish `k` shifted by `shift[k]` frames around the end, and with `kind` also its positions; fish
    /// without a shift stay.
    pub fn statistics(&self, kind: NullKind, shift: &[usize]) -> Statistics {
        let (frames, fish) = (self.frames(), self.fish());
        let mut statistics = Statistics {
            positive: [0.0; 3],
            difference: [0.0; 3],
            order: 0.0,
            rotation: 0.0,
            nearest: 0.0,
            zone_alignment: None,
            histogram: difference_bins(),
        };
        let (mut cosines, mut arcs) = (0.0, 0usize);
        for i in 0..frames {
            let moved = |rows: &[Vec<Vector>]| -> Vec<Vector> {
                let place = |k: usize| (i + shift.get(k).map_or(0, |s| s % frames)) % frames;
                (0..fish).map(|k| rows[place(k)][k].clone()).collect()
            };
            let headings = moved(&self.headings);
            let shifted = match kind {
                NullKind::Headings => None,
                NullKind::Tracks => Some(moved(&self.positions)),
            };
            let positions = shifted.as_ref().unwrap_or(&self.positions[i]);
            let single = match &shifted {
                None => partner_potential(&self.partners[i], &headings),
                Some(positions) => partner_potential(&partners(positions, self.too_near), &headings),
            };
            let complete = complete_potential(&headings);
            for (s, scale) in Scale::ALL.iter().enumerate() {
                let difference = scale.difference(fish, complete, single);
                statistics.difference[s] += difference;
                statistics.positive[s] += f64::from(difference > ROUNDING);
            }
            statistics.histogram.add(Scale::Figure.difference(fish, complete, single));
            statistics.order += mean(&headings).norm_squared().sqrt();
            statistics.rotation += rotation(positions, &headings).abs();
            statistics.nearest += match &shifted {
                None => self.nearest[i],
                Some(positions) => mean_nearest(positions),
            };
            for (k, z) in headings.iter().enumerate() {
                for j in (0..fish).filter(|&j| j != k) {
                    if self.zones.senses(Zone::Orientation, z, &(positions[j].clone() - &positions[k])) {
                        cosines += z.dot(&headings[j]);
                        arcs += 1;
                    }
                }
            }
        }
        let Statistics { positive, difference, order, rotation, nearest, .. } = &mut statistics;
        let means = difference.iter_mut().chain(positive).chain([order, rotation, nearest]);
        means.for_each(|sum| *sum /= frames as f64);
        statistics.zone_alignment = (arcs > 0).then(|| cosines / arcs as f64);
        statistics
    }

    /// Share of frames in which every fish is the neighbour of its neighbour.
    fn in_pairs(&self) -> f64 {
        let mutual = |partners: &&Vec<usize>| (0..partners.len()).all(|k| partners[partners[k]] == k);
        self.partners.iter().filter(mutual).count() as f64 / self.frames() as f64
    }

    /// Independent uniform headings, as often in each frame, until there are enough draws.
    fn uniform(&self, seed: &str) -> UniformShares {
        let rounds = DRAWS.div_ceil(self.frames());
        let unit = || Histogram::new(0.0, 1.0, 20);
        let mut shares = UniformShares { draws: 0, positive: [0; 3], histograms: [unit(), unit(), difference_bins()] };
        let mut random = generator(seed, "tracks.uniform", 0);
        let n = self.fish();
        for partners in (0..rounds).flat_map(|_| &self.partners) {
            let (complete, single) = uniform_draw(partners, &mut random);
            shares.draws += 1;
            for (positive, scale) in shares.positive.iter_mut().zip(Scale::ALL) {
                *positive += usize::from(scale.difference(n, complete, single) > ROUNDING);
            }
            let (blue, red) = (Scale::Figure.factor(n - 1) * complete, Scale::Figure.factor(1) * single);
            shares.histograms.iter_mut().zip([blue, red, blue - red]).for_each(|(histogram, x)| histogram.add(x));
        }
        shares
    }
}

/// The mean distance to the nearest neighbour in one frame.
fn mean_nearest(positions: &[Vector]) -> f64 {
    let distance =
        |k: usize| (positions[nearest_neighbour(positions, k, None)].clone() - &positions[k]).norm_squared().sqrt();
    (0..positions.len()).map(distance).sum::<f64>() / positions.len() as f64
}

/// `W_1` for `n = N - 1` and for `n = 1`, for so many fish with positions that are independent and uniform in a square and headings that are
/// independent and uniform on the circle, drawn so many times.
pub fn uniform_draws(fish: usize, draws: usize, random: &mut ChaCha8Rng) -> Vec<(f64, f64)> {
    let draw = |_| {
        let positions: Vec<Vector> = (0..fish).map(|_| Complex::new(uniform(random), uniform(random))).collect();
        uniform_draw(&partners(&positions, None), random)
    };
    (0..draws).map(draw).collect()
}

/// `W_1` for `n = N - 1` and for `n = 1` with the neighbours given, for headings that are independent and uniform on the circle.
pub fn uniform_draw(partners: &[usize], random: &mut ChaCha8Rng) -> (f64, f64) {
    let heading = |_: &usize| {
        let (sin, cos) = (TAU * uniform(random)).sin_cos();
        Complex::new(cos, sin)
    };
    let headings: Vec<Vector> = partners.iter().map(heading).collect();
    (complete_potential(&headings), partner_potential(partners, &headings))
}

/// Compares a recording with independent uniform headings and with `shifts` shifts of each kind; `progress` is told of each shift.
///
/// # Errors
/// [`Cancelled`].
pub fn null_models(
    sample: &Sample,
    shifts: usize,
    seed: &str,
    progress: &dyn Progress,
) -> Result<NullModels, Cancelled> {
    let (frames, fish) = (sample.frames(), sample.fish());
    let observed = sample.statistics(NullKind::Headings, &vec![0; fish]);
    let offsets = |kind: NullKind, replicate: usize| -> Vec<usize> {
        let mut random = generator(seed, kind.name(), replicate as u64);
        (0..fish).map(|_| ((uniform(&mut random) * frames as f64) as usize).min(frames - 1)).collect()
    };
    let done = AtomicU64::new(0);
    let compare = |kind: NullKind| {
        let shifted = |replicate: usize| {
            progress.checkpoint()?;
            let statistics = sample.statistics(kind, &offsets(kind, replicate));
            progress.tell("shifts", done.fetch_add(1, Ordering::Relaxed) + 1, Some(2 * shifts as u64));
            Ok(statistics)
        };
        let all = (0..shifts).into_par_iter().map(shifted).collect::<Result<Vec<Statistics>, Cancelled>>()?;
        let mut histogram = difference_bins();
        all.iter().for_each(|statistics| histogram.merge(&statistics.histogram));
        let table: Vec<[Option<f64>; STATISTICS]> = all.iter().map(Statistics::values).collect();
        let seen = observed.values();
        let comparisons = std::array::from_fn(|c| match (kind, Statistics::NAMES[c]) {
            // Positions stay, and with them all distances.
            (NullKind::Headings, "nearest_distance") => None,
            _ => comparison(seen[c]?, table.iter().filter_map(|row| row[c]).collect()),
        });
        Ok((kind, comparisons, histogram))
    };
    let shifted = if shifts == 0 { vec![] } else { vec![compare(NullKind::Headings)?, compare(NullKind::Tracks)?] };
    Ok(NullModels { in_pairs: sample.in_pairs(), uniform: sample.uniform(seed), shifted, shifts, observed })
}

fn comparison(observed: f64, mut values: Vec<f64>) -> Option<Comparison> {
    values.sort_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    let point = |share: f64| values[(share * last as f64).round() as usize];
    let as_large = values.iter().filter(|&&x| x >= observed - ROUNDING).count();
    let as_small = values.iter().filter(|&&x| x <= observed + ROUNDING).count();
    let share = |shifts: usize| (1 + shifts) as f64 / (1 + values.len()) as f64;
    Some(Comparison {
        observed,
        mean: values.iter().sum::<f64>() / values.len() as f64,
        range: (point(0.025), point(0.975)),
        at_least: (as_large, values.len()),
        share_at_least: share(as_large),
        share_at_most: share(as_small),
    })
}
