//! Functions of the papers at the numbers of a counterexample: the gain of a platoon, the potential of a link.

use crate::plot::{Axis, Panel, Series};
use ledger::{Number, Point, Witness};
use models::double_integrator::Potential;
use models::platoon::{Gains, amplitude_one_sided};
use num_traits::ToPrimitive;

/// Points of a curve.
const POINTS: u32 = 300;

fn over(last: f64) -> impl Iterator<Item = f64> {
    (1..=POINTS).map(move |k| last * f64::from(k) / f64::from(POINTS))
}

/// `|1/gamma|²` over `w²`, with the values that are named.
pub(super) fn gain(f: f64, g: f64, marks: &[Point]) -> (Panel, String) {
    let marks: Vec<(f64, f64)> = marks.iter().map(|[w, a]| (float(w), float(a))).collect();
    let gains = Gains { f, g };
    let square = |w: f64| amplitude_one_sided(&gains, &w, 1).map_or(f64::NAN, |a| a.norm_squared());
    let last = marks.iter().map(|(w, _)| 1.3 * w).fold(-2.6 * f, f64::max);
    let panel = Panel::new("", Axis::linear("w²"), Axis::linear("|1/γ|²"))
        .series(Series::line("", over(last).map(|w| (w, square(w.sqrt())))))
        .series(Series::dashed("", [(0.0, 1.0), (last, 1.0)]).colour("#6b6b6b"))
        .series(Series::points("the values named", marks).colour("#d1580b").size(5.0));
    (panel, format!("|1/gamma|² over w², for f = {f} and g = {g}; dashed: 1."))
}

/// A potential over the squared distance with a tangent, or over the distance, constant from one on.
pub(super) fn potential(witness: &Witness) -> (Panel, String) {
    let Witness::Potential { slope, value: [place, height], tangent, radius } = witness else {
        return (Panel::new("", Axis::linear(""), Axis::linear("")), String::new());
    };
    let terms = slope.iter().map(|(power, c)| (*power, c.0.clone())).collect();
    let potential = Potential::new(terms, (place.0.clone(), height.0.clone()));
    let value = |s: f64| potential.value(&s).unwrap_or(f64::NAN);
    if let Some(radius) = radius.as_ref().map(float) {
        let bent = value(radius * radius);
        let saturated = over(2.0 * radius).filter(|r| *r > 0.35 * radius);
        let panel = Panel::new("", Axis::linear("r"), Axis::linear("U"))
            .series(Series::line("", saturated.map(|r| (r, if r < radius { value(r * r) } else { bent }))))
            .series(Series::points("", [(radius, bent)]).colour("#d1580b").size(5.0));
        return (panel, format!("U over the distance r; it has a corner at r = {radius}."));
    }
    let [at, slope] = tangent.as_ref().map_or([1.0, f64::NAN], |[at, slope]| [float(at), float(slope)]);
    let (here, last) = (value(at), 6.0 * at);
    let tangent = [0.6, 1.4].map(|part| (part * at, here + slope * (part - 1.0) * at));
    let panel = Panel::new("", Axis::linear("s"), Axis::linear("V"))
        .series(Series::line("V", over(last).filter(|s| *s > 0.4 * at).map(|s| (s, value(s)))))
        .series(Series::line("its tangent", tangent).colour("#d1580b").size(2.4))
        .series(Series::points("", [(at, here)]).colour("#d1580b").size(5.0));
    (panel, format!("V over s, with its tangent of slope {slope} at s = {at}."))
}

pub(super) fn float(Number(q): &Number) -> f64 {
    q.to_f64().unwrap_or(f64::NAN)
}
