//! Exploration: exponential or linear growth, and for which communication graphs? (The question Section 6 leaves open.)

use super::veerman::{UNIT, unit};
use super::{Reproduced, csv};
use crate::plot::{Axis, Colour, Panel, Picture, Series};
use arithmetic::threads::side_by_side;
use arithmetic::{Rational, Signed, rational};
use ledger::CheckError;
use models::platoon::growth::{Growth, LARGEST_PEAK, peak};
use models::platoon::observe::Extreme;
use models::platoon::vector_form::{self, motion_matrix};
use models::platoon::{CommunicationGraph, Neighbourhood};
use num_traits::{ToPrimitive, Zero};
use std::collections::BTreeMap;
use std::fmt::Write;

const OFFSETS: [i64; 6] = [-3, -2, -1, 1, 2, 3];
const SIZES: [usize; 17] = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024];
/// Followers of the exact test of stability.
const STABILITY: usize = 12;
/// Weights are multiples of this, beside the equal weights of every subset.
const DENOMINATOR: i64 = 4;

/// What was found for one graph.
struct Found {
    weights: [Rational; 6],
    moments: [Rational; 3],
    margin: f64,
    reached: bool,
    stable: bool,
    /// Peaks with their sizes.
    peaks: Vec<(f64, Extreme)>,
    growth: Option<Growth>,
}

/// All weight vectors of the family: equal weights on every non-empty set of offsets, and all multiples of a quarter.
fn family() -> Vec<[Rational; 6]> {
    let mut all = BTreeMap::new();
    let mut add = |numbers: [i64; 6], sum: i64| {
        let weights = numbers.map(|x| rational(x, sum));
        // The key orders the family; equal vectors meet in it.
        all.entry(numbers.map(|x| x * 60 / sum)).or_insert(weights);
    };
    for subset in 1u32..64 {
        let numbers = [0, 1, 2, 3, 4, 5].map(|k| i64::from(subset >> k & 1));
        add(numbers, numbers.iter().sum());
    }
    let base = DENOMINATOR + 1;
    for code in 0..base.pow(6) {
        let numbers = [0, 1, 2, 3, 4, 5].map(|k| code / base.pow(k) % base);
        if numbers.iter().sum::<i64>() == DENOMINATOR {
            add(numbers, DENOMINATOR);
        }
    }
    all.into_values().collect()
}

fn is_stable(graph: &CommunicationGraph) -> Result<bool, CheckError> {
    Ok(vector_form::is_stable(&motion_matrix(&graph.reduced_laplacian()?, &unit())?)?)
}

fn explore(weights: [Rational; 6]) -> Result<Found, CheckError> {
    let rule = Neighbourhood::new(OFFSETS.into_iter().zip(weights.clone()))?;
    let small = rule.graph(STABILITY)?;
    let reached = small.reached_by_leader().into_iter().all(|reached| reached);
    let mut peaks = Vec::new();
    if reached {
        for size in SIZES {
            let Some(found) = peak(&rule.graph(size)?, &UNIT)? else { break };
            peaks.push((size as f64, found));
            if found.value > LARGEST_PEAK {
                break;
            }
        }
    }
    let values: Vec<(f64, f64)> = peaks.iter().map(|(size, peak)| (*size, peak.value)).collect();
    Ok(Found {
        moments: [1, 2, 3].map(|n| rule.moment(n)),
        margin: rule.wave_margin(&UNIT),
        stable: reached && is_stable(&small)?,
        growth: reached.then(|| Growth::of(&values)),
        weights,
        reached,
        peaks,
    })
}

impl Found {
    /// The rule that the numbers suggest: linear where the mean offset is zero and every travelling-wave mode is damped.
    fn expected(&self) -> Option<Growth> {
        let linear = self.moments[0].is_zero() && self.margin > 0.0;
        self.reached.then_some(if linear { Growth::Linear } else { Growth::Exponential })
    }

    /// The largest peak found, over its size and times the root of the second moment.
    fn scaled_peak(&self) -> Option<f64> {
        let (size, peak) = self.peaks.last()?;
        Some(peak.value / size * self.moments[1].to_f64()?.sqrt())
    }

    /// By how much the logarithm of the peak grows per car, between the last two sizes.
    fn rate(&self) -> Option<f64> {
        let [.., (smaller, before), (larger, last)] = &self.peaks[..] else { return None };
        Some((last.value / before.value).ln() / (larger - smaller))
    }

    fn word(&self) -> &'static str {
        self.growth.map_or("not reached", Growth::word)
    }

    fn fields(&self) -> Vec<String> {
        let mut fields: Vec<String> = self.weights.iter().chain(&self.moments).map(ToString::to_string).collect();
        fields.extend([format!("{:.5}", self.margin), self.reached.to_string(), self.stable.to_string()]);
        let cell = |k: usize| self.peaks.get(k).map_or(String::new(), |(_, peak)| format!("{:.6e}", peak.value));
        fields.extend((0..SIZES.len()).map(cell));
        fields.push(self.peaks.last().map_or(String::new(), |(_, peak)| format!("{:.6e}", peak.at)));
        fields.push(self.rate().map_or(String::new(), |rate| format!("{rate:.6}")));
        fields.extend([self.word(), self.expected().map_or("not reached", Growth::word)].map(str::to_string));
        fields
    }
}

fn colour(word: &str) -> Colour {
    match word {
        "linear" => "#0b5fa5",
        "exponential" => "#d1580b",
        "polynomial" => "#138a5e",
        _ => "#a3247a",
    }
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let found = side_by_side(&family(), |graph| explore(graph.clone())).into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut counts: BTreeMap<(&str, &str, bool), usize> = BTreeMap::new();
    for graph in &found {
        let mean = &graph.moments[0];
        let side = if mean.is_zero() {
            "0"
        } else if mean.is_certainly_negative() {
            "in front"
        } else {
            "behind"
        };
        *counts.entry((graph.word(), side, graph.stable)).or_default() += 1;
    }
    let agreeing = found.iter().filter(|graph| graph.reached && graph.growth == graph.expected()).count();
    let reached = found.iter().filter(|graph| graph.reached).count();
    let mut text = format!(
        "EXPLORATION in floating point, not a proof. {} communication graphs on the line:\n\
         all inner cars track the cars at the offsets -3..3 with the same weights (equal\n\
         on a subset, or multiples of 1/{DENOMINATOR}); cars that are not there are left out and the\n\
         other weights scaled to the sum 1. f = g = -1. Largest |a_k(w)| over all cars and\n\
         frequencies for 4, 6, 8, 12, ..., 768, 1024 followers, until it passes 1e6 or the\n\
         slowest mode is too slow for floating point (eigenvalue below 1e-9). Linear: the\n\
         last two local exponents are within 0.05 of 1; exponential: the exponent grows\n\
         by half or more while the size doubles. Stable: exactly, for {STABILITY} followers.\n\n\
         growth       mean offset  stable  graphs\n",
        found.len()
    );
    for ((word, side, stable), count) in &counts {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{word:12} {side:11}  {:6}  {count:6}", if *stable { "yes" } else { "no" });
    }
    let scaled: Vec<f64> =
        found.iter().filter(|graph| graph.growth == Some(Growth::Linear)).filter_map(Found::scaled_peak).collect();
    let (low, high) = scaled.iter().fold((f64::INFINITY, 0f64), |(low, high), x| (low.min(*x), high.max(*x)));
    let _ = writeln!(
        text,
        "\nRule: linear exactly where the mean offset sum w_d d is 0 and g² Re l |l|² >\n\
         |f| (Im l)² for the symbol l(q) = 1 - sum w_d e^(iqd), 0 < q <= pi; otherwise\n\
         exponential. It agrees with the sweep for {agreeing} of the {reached} graphs in which the\n\
         leader is heard by all. In the linear ones the peak is {low:.4} to {high:.4} times\n\
         M/sqrt(sum w_d d²) at M = 1024 (Theorem 1: 8 sqrt2/pi² = 1.1463).\n\
         More: notes/communication_sweep.md"
    );
    let mut growth = Panel::new(
        "a) peak over all cars and frequencies",
        Axis::log("followers").ticks([4.0, 16.0, 64.0, 256.0, 1024.0]),
        Axis::log("largest |a_k|"),
    );
    let mut offset = Panel::new(
        "b) growth per car between the last two sizes",
        Axis::linear("mean offset of the tracked cars (negative: in front)"),
        Axis::log("growth of ln |a_k| per car"),
    );
    let mut named: Vec<&str> = Vec::new();
    for graph in found.iter().filter(|graph| graph.reached) {
        let word = graph.word();
        let name = if named.contains(&word) { "" } else { word };
        named.push(word);
        let line = graph.peaks.iter().map(|(size, peak)| (*size, peak.value));
        growth = growth.series(Series::line(name, line).colour(colour(word)).size(if word == "exponential" {
            0.5
        } else {
            1.3
        }));
        if let Some(rate) = graph.rate() {
            let mean = graph.moments[0].to_f64().unwrap_or(f64::NAN);
            offset = offset.series(Series::points(name, [(mean, rate)]).colour(colour(word)));
        }
    }
    let picture = Picture::new("Exploration: growth of the response for communication graphs on the line (f = g = −1)")
        .grid(2, (560.0, 460.0))
        .panel(growth)
        .panel(offset);
    let sizes = SIZES.map(|size| format!("peak_{size}")).join(",");
    let header = format!(
        "w_-3,w_-2,w_-1,w_1,w_2,w_3,mean_offset,second_moment,third_moment,wave_margin,reached,stable_{STABILITY},\
         {sizes},frequency_of_last,growth_per_car,growth,rule"
    );
    Ok(Reproduced::new(text).table("", csv(&header, found.iter().map(Found::fields))).picture("", picture))
}
