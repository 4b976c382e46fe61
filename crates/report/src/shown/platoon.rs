//! The resonance of a platoon: numbers, the curve, and which gains are better.

use super::{enclosed, picture, table};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::{ArithmeticError, Interval, Rational, decimal, rational};
use maud::html;
use models::platoon::{
    Gains, Resonance, ResonanceError, inverse_square_two_sided, next_order, resonance as enclose, theorem1,
};
use num_traits::ToPrimitive;

/// Digits of what is shown, and of the peaks of other gains.
const DIGITS: u32 = 18;
const OTHER: u32 = 6;
/// Points of a curve.
const POINTS: u32 = 1200;

/// Why there is nothing to show.
#[derive(Debug, thiserror::Error)]
pub enum PlatoonError {
    /// A number without a value.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
    /// The peak of other gains.
    #[error(transparent)]
    Resonance(#[from] ResonanceError),
}

/// The main resonance beside Theorem 1 and its next order, the curve, and the region of gains with a smaller peak.
///
/// # Errors
/// [`PlatoonError`].
pub fn resonance(gains: &Gains<Rational>, followers: u64, found: &Resonance) -> Result<String, PlatoonError> {
    let exact = gains.map(|q| Interval::from_rational(q, 256));
    let first = [theorem1::frequency(&exact, followers)?, theorem1::amplitude(&exact, followers)?];
    let next = [next_order::frequency(&exact, followers)?, next_order::amplitude(&exact, followers)?];
    let number = |x: &Interval| decimal(&x.to_rationals().0, 15, false);
    let rows: Vec<Vec<String>> = [("frequency, rad/s", &found.omega), ("amplitude", &found.amplitude)]
        .into_iter()
        .zip(first.iter().zip(&next))
        .map(|((name, x), (first, next))| vec![name.to_string(), enclosed(x, DIGITS), number(first), number(next)])
        .collect();
    let shown = html! {
        (table("Resonance", &["quantity", "certified", "Theorem 1", "its next order"], &rows))
        p { "The last of " (followers) " followers swings most at this frequency, so many times as far as the leader: no other frequency above 0 gives more." }
        (picture(&curve(gains, followers, found), "curve", "Amplitude of the last car over the frequency of the leader; the mark is the certified peak."))
        (picture(&region(gains, followers, found)?, "region",
            "The peak depends on the gains through g²/|f| alone and decreases in it. In the shaded region it is smaller than for the asked gains, the disc."))
    };
    Ok(shown.into_string())
}

fn curve(gains: &Gains<Rational>, followers: u64, found: &Resonance) -> Picture {
    let gains = gains.map(|q| q.to_f64().unwrap_or(f64::NAN));
    let (peak, height) = (found.omega.to_f64(), found.amplitude.to_f64());
    // What has no value is left out of the line.
    let amplitude =
        |w: f64| inverse_square_two_sided(&gains, &w, followers).map_or(f64::NAN, |square| square.sqrt().recip());
    let frequencies = (1..=POINTS).map(|k| 8.0 * peak * f64::from(k) / f64::from(POINTS));
    let line = frequencies.map(|w| (w, amplitude(w)));
    Picture::new("").grid(1, (720.0, 380.0)).panel(
        Panel::new("", Axis::linear("frequency (rad/s)"), Axis::log("amplitude of the last car"))
            .series(Series::line("", line))
            .series(Series::points("peak, certified", [(peak, height)]).colour("#d1580b").size(4.5)),
    )
}

/// Lines of equal peak `|g| = b sqrt|f|`, and the region above the one of the asked gains.
fn region(gains: &Gains<Rational>, followers: u64, found: &Resonance) -> Result<Picture, PlatoonError> {
    let (f, g) = (gains.f.to_f64().unwrap_or(-1.0).abs(), gains.g.to_f64().unwrap_or(-1.0).abs());
    let (right, top) = (3.0 * f, 2.5 * g);
    let line = |times: f64| {
        (0..=200u32).map(move |k| f64::from(k) / 200.0 * right).map(move |x| (x, times * g * (x / f).sqrt()))
    };
    let above = line(1.0).filter(|(_, y)| *y <= top).chain([(right, top), (0.0, top)]);
    let mut panel = Panel::new("", Axis::linear("|f|").between(0.0, right), Axis::linear("|g|").between(0.0, top))
        .series(Series::area("smaller peak", above).colour("#138a5e"));
    for (p, q) in [(1, 2), (1, 1), (2, 1)] {
        let peak = match p == q {
            true => found.amplitude.clone(),
            false => enclose(&Gains { f: gains.f.clone(), g: &gains.g * rational(p, q) }, followers, OTHER)?.amplitude,
        };
        let name = format!("peak {}", decimal(&peak.to_rationals().0, 5, false));
        panel = panel.series(Series::line(name, line(p as f64 / q as f64)));
    }
    let asked = Series::points("asked gains", [(f, g)]).colour("#222222").size(4.5);
    Ok(Picture::new("").grid(1, (720.0, 420.0)).panel(panel.series(asked)))
}
