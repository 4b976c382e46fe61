//! Functions of the papers that a sentence names with their numbers: the gain of a platoon, the potential of a link.

use super::numbers::{assignments, number};
use crate::plot::{Axis, Panel, Series};
use arithmetic::{Rational, rational};
use models::double_integrator::Potential;
use models::platoon::{Gains, amplitude_one_sided};
use num_traits::ToPrimitive;

/// A function with what is said of it.
#[derive(Debug)]
pub(super) enum Curve {
    /// `|1/gamma|²` over `w²`, for gains `f`, `g`, with the values that are named.
    Gain { f: f64, g: f64, marks: Vec<(f64, f64)> },
    /// A potential over the squared distance, with the place and slope of a tangent.
    Tangent { potential: Potential, at: f64, slope: f64 },
    /// A potential over the distance, constant from a distance on.
    Saturated { potential: Potential, radius: f64 },
}

/// Points of a curve.
const POINTS: u32 = 300;

pub(super) fn read(part: &str) -> Option<Curve> {
    gain(part).or_else(|| potential(part))
}

fn gain(part: &str) -> Option<Curve> {
    let (_, said) = part.split_once("|1/gamma|² is ")?;
    let known = assignments(part);
    let (f, g) = (known.get("f")?.to_f64()?, known.get("g")?.to_f64()?);
    let (first, _) = said.split_once([' ', ','])?;
    let leader = part.split_once("leader's frequency ").and_then(|(_, rest)| rest.split(':').next().and_then(number));
    let marks = match leader {
        Some(w) => vec![((&w * &w).to_f64()?, number(first)?.to_f64()?)],
        // `A at w² = |f| = B and C at w² = D`.
        None => said.split(" and ").map(mark).collect::<Option<_>>()?,
    };
    (f < 0.0 && g < 0.0).then_some(Curve::Gain { f, g, marks })
}

fn mark(text: &str) -> Option<(f64, f64)> {
    let (value, at) = text.split_once(" at w² = ")?;
    let at = at.rsplit(" = ").next().and_then(number)?;
    Some((at.to_f64()?, number(value)?.to_f64()?))
}

fn potential(part: &str) -> Option<Curve> {
    let one = rational(1, 1);
    let potential = if part.starts_with("V = 1/s + log s") {
        Potential::inverse_square_log(&one)
    } else if part.starts_with("V = s + 1/s - 2") {
        Potential::inverse_square_spring(&one, &one)
    } else {
        return None;
    };
    let known = assignments(part);
    let float = |name: &str| known.get(name).and_then(Rational::to_f64).filter(|x| *x > 0.0);
    if part.contains("U'(R; w)") {
        return Some(Curve::Saturated { potential, radius: float("R")? });
    }
    let slope = known.get("dV/ds").and_then(Rational::to_f64)?;
    Some(Curve::Tangent { potential, at: float("s")?, slope })
}

/// The panel, and what is to be seen.
pub(super) fn draw(curve: &Curve) -> (Panel, String) {
    let over = |last: f64| (1..=POINTS).map(move |k| last * f64::from(k) / f64::from(POINTS));
    match curve {
        Curve::Gain { f, g, marks } => {
            let gains = Gains { f: *f, g: *g };
            let square = |w: f64| amplitude_one_sided(&gains, &w, 1).map_or(f64::NAN, |a| a.norm_squared());
            let last = marks.iter().map(|(w, _)| 1.3 * w).fold(-2.6 * f, f64::max);
            let panel = Panel::new("", Axis::linear("w²"), Axis::linear("|1/γ|²"))
                .series(Series::line("", over(last).map(|w| (w, square(w.sqrt())))))
                .series(Series::dashed("", [(0.0, 1.0), (last, 1.0)]).colour("#6b6b6b"))
                .series(Series::points("the values named", marks.iter().copied()).colour("#d1580b").size(5.0));
            (panel, format!("|1/gamma|² over w², for f = {f} and g = {g}; dashed: 1."))
        }
        Curve::Tangent { potential, at, slope } => {
            let value = |s: f64| potential.value(&s).unwrap_or(f64::NAN);
            let (here, last) = (value(*at), 6.0 * at);
            let tangent = [0.6, 1.4].map(|part| (part * at, here + slope * (part - 1.0) * at));
            let panel = Panel::new("", Axis::linear("s"), Axis::linear("V"))
                .series(Series::line("V", over(last).filter(|s| *s > 0.4 * at).map(|s| (s, value(s)))))
                .series(Series::line("its tangent", tangent).colour("#d1580b").size(2.4))
                .series(Series::points("", [(*at, here)]).colour("#d1580b").size(5.0));
            (panel, format!("V over s, with its tangent of slope {slope} at s = {at}."))
        }
        Curve::Saturated { potential, radius } => {
            let value = |r: f64| potential.value(&(r * r)).unwrap_or(f64::NAN);
            let bent = value(*radius);
            let saturated = over(2.0 * radius).filter(|r| *r > 0.35 * radius);
            let panel = Panel::new("", Axis::linear("r"), Axis::linear("U"))
                .series(Series::line("", saturated.map(|r| (r, if r < *radius { value(r) } else { bent }))))
                .series(Series::points("", [(*radius, bent)]).colour("#d1580b").size(5.0));
            (panel, format!("U over the distance r; it has a corner at r = {radius}."))
        }
    }
}
