//! Bode's diagram: magnitude and phase over the frequency.

use super::plot::{Axis, Panel, Picture, Series, literal};
use models::platoon::bode::Sample;

/// What is drawn of a response.
pub struct Curves<'a> {
    /// Above the panels.
    pub title: &'a str,
    /// Below them.
    pub caption: &'a str,
    /// What the curves are called, in the order of the samples' numbers.
    pub names: &'a [String],
    /// Points of all curves.
    pub samples: &'a [Sample],
    /// Frequency and amplitude of peaks.
    pub peaks: &'a [(f64, f64)],
    /// What the marks of peaks are.
    pub mark: &'a str,
}

/// Amplitudes that are this far below the largest, in decibels, are not shown.
const DEPTH: f64 = 80.0;

/// Magnitude in decibels and phase in degrees, one above the other, over a logarithmic axis of frequencies.
pub fn bode(curves: &Curves) -> Picture {
    let decibels = |amplitude: f64| 20.0 * amplitude.log10();
    let turn = 180.0 / std::f64::consts::PI;
    let amplitudes = curves.samples.iter().flat_map(|sample| &sample.amplitudes).copied();
    let top = amplitudes.clone().chain(curves.peaks.iter().map(|peak| peak.1)).map(decibels).fold(0.0, f64::max);
    let bottom = amplitudes.map(decibels).filter(|x| x.is_finite()).fold(0.0, f64::min).max(top - DEPTH);
    let frequency = || Axis::log("angular frequency (rad/s)");
    let range = (bottom - 0.03 * (top - bottom), top + 0.06 * (top - bottom).max(1.0));
    let magnitude = Axis::linear("magnitude (dB)").between(range.0, range.1);
    let mut above = Panel::new("", frequency(), magnitude);
    let phases = curves.samples.iter().flat_map(|sample| &sample.phases).map(|phase| turn * phase);
    let mut below = Panel::new("", frequency(), Axis::linear("phase (degrees)").ticks(angles(phases)));
    for (k, name) in curves.names.iter().enumerate() {
        let line = |value: &dyn Fn(&Sample) -> f64| curves.samples.iter().map(|s| (s.w, value(s))).collect::<Vec<_>>();
        above = above.series(Series::line(literal(name), line(&|s| decibels(s.amplitudes[k]))));
        below = below.series(Series::line(literal(name), line(&|s| turn * s.phases[k])));
    }
    if !curves.peaks.is_empty() {
        let marks = curves.peaks.iter().map(|(w, amplitude)| (*w, decibels(*amplitude)));
        above = above.series(Series::points(curves.mark, marks).colour("#222222").size(4.0));
    }
    Picture::new(literal(curves.title)).grid(1, (700.0, 300.0)).panel(above).panel(below).caption(curves.caption)
}

/// Ticks at multiples of an eighth of a circle, or of more, so that there are not too many.
fn angles(phases: impl Iterator<Item = f64>) -> Vec<f64> {
    let (low, high) = phases.fold((0f64, 0f64), |(low, high), x| (low.min(x), high.max(x)));
    let mut step = 45.0;
    while (high - low) / step > 8.0 && step < 1e9 {
        step *= 2.0;
    }
    ((low / step).floor() as i64..=(high / step).ceil() as i64).map(|k| k as f64 * step).collect()
}
