//! Worst cases of a switched linear system: verdicts, the tube of each quantity, the worst motion with its modes and inputs.

use super::picture;
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::{Cancelled, Progress, Rational};
use maud::html;
use num_traits::ToPrimitive;
use reach::{Decided, Part, Range, ReachError, System, Witness, tube};

/// Times at which the tube is drawn.
const SAMPLES: usize = 160;

/// One panel for each quantity that is asked about, or the gaps of a long platoon; one for the modes and one for the inputs of the first witness.
///
/// # Errors
/// [`Cancelled`].
pub fn worst_cases(system: &System, decided: &[Decided], progress: &dyn Progress) -> Result<Picture, Cancelled> {
    let parts: Vec<&Part> = decided.iter().flat_map(|found| &found.parts).collect();
    let mut picture = Picture::new("Worst cases").grid(2, (460.0, 320.0));
    let long = system.platoon.as_ref().is_some_and(|platoon| platoon.graph.followers() > MOST_FOLLOWED);
    let cars = if long { by_car(system, progress)? } else { None };
    let caption = if cars.is_some() { BY_CAR } else { OVER_TIME };
    match cars {
        Some(cars) => picture = picture.panel(cars),
        None => {
            for panel in quantities(system, &parts, progress)? {
                picture = picture.panel(panel);
            }
        }
    }
    if let Some(witness) = parts.iter().find_map(|part| part.witness.as_ref()) {
        if system.modes.len() > 1 {
            picture = picture.panel(modes(system, witness));
        }
        // More jumps than these are one grey area.
        if witness.inputs.iter().all(|values| values.len() <= MOST_JUMPS) {
            picture = picture.panel(inputs(system, witness));
        }
    }
    Ok(picture.caption(caption))
}

fn quantities(system: &System, parts: &[&Part], progress: &dyn Progress) -> Result<Vec<Panel>, Cancelled> {
    let mut drawn: Vec<&[Rational]> = Vec::new();
    let mut panels = Vec::new();
    for part in parts {
        if drawn.contains(&&part.condition.row[..]) || drawn.len() == MOST_PANELS {
            continue;
        }
        drawn.push(&part.condition.row);
        let bounds = parts.iter().copied().filter(|other| other.condition.row == part.condition.row);
        panels.push(quantity(system, part, bounds, progress)?);
    }
    Ok(panels)
}

const MOST_PANELS: usize = 8;

/// Most values of one input that are drawn.
const MOST_JUMPS: usize = 200;

const OVER_TIME: &str = "Areas: all values at these times, proved. Lines: the motion found for the worst case, in floats; modes and inputs are those of the first quantity.";
const BY_CAR: &str = "Bounds of the gap of each car that is drawn to the one in front, proved; inputs, where they are drawn, are those of the first check.";

/// Followers of a platoon whose motions are drawn over time; of longer ones gaps are drawn over the cars.
const MOST_FOLLOWED: usize = 10;

/// Cars of a long platoon that are drawn.
const CARS: usize = 9;

/// The worst gaps of a platoon, car by car; none where they are not known without matrices.
fn by_car(system: &System, progress: &dyn Progress) -> Result<Option<Panel>, Cancelled> {
    let gaps = match reach::gaps(system, CARS, progress) {
        Ok(Some(gaps)) => gaps,
        Err(ReachError::Cancelled(cancelled)) => return Err(cancelled),
        Ok(None) | Err(_) => return Ok(None),
    };
    let curve =
        |end: &dyn Fn(&Range) -> f64| gaps.iter().map(|(car, range)| (*car as f64, end(range))).collect::<Vec<_>>();
    let (most, least) = (curve(&|range| float(&range.hi)), curve(&|range| -float(&range.lo)));
    let mut panel = Panel::new("", Axis::linear("car"), Axis::log("gap to the car in front"));
    for (name, points, colour) in [("greatest", most, "#0b5fa5"), ("minus the least", least, "#d1580b")] {
        panel = panel.series(Series::line(name, points.clone()).colour(colour));
        panel = panel.series(Series::points("", points).colour(colour));
    }
    Ok(Some(panel))
}

fn float(x: &Rational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

fn quantity<'a>(
    system: &System,
    part: &Part,
    bounds: impl Iterator<Item = &'a Part>,
    progress: &dyn Progress,
) -> Result<Panel, Cancelled> {
    let (until, tube) = (part.drawn_until(system), tube(system, part, SAMPLES, progress)?);
    let mut panel = super::tube::panel(&tube, ["all motions, enclosed", "the worst that was found"], Some(0));
    for (k, other) in bounds.enumerate() {
        // On the scale of the first condition, whose constant the tube has.
        let bound = float(&(&other.condition.bound - &other.condition.constant + &part.condition.constant));
        let name = if k == 0 { "bounds asked for" } else { "" };
        panel = panel.series(Series::dashed(name, [(0.0, bound), (float(&until), bound)]).colour("#d1580b"));
    }
    Ok(panel)
}

/// A function that keeps each value until the next.
fn steps(values: &[(Rational, f64)], end: &Rational) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for (i, (from, value)) in values.iter().enumerate() {
        let to = values.get(i + 1).map_or(end, |(to, _)| to);
        points.extend([(float(from), *value), (float(to), *value)]);
    }
    points
}

fn modes(system: &System, witness: &Witness) -> Panel {
    let numbers: Vec<(Rational, f64)> =
        witness.modes.iter().map(|(from, mode)| (from.clone(), *mode as f64 + 1.0)).collect();
    let names: Vec<String> =
        system.modes.iter().enumerate().map(|(i, mode)| format!("{} {}", i + 1, mode.name)).collect();
    let axis = Axis::linear("mode")
        .between(0.5, system.modes.len() as f64 + 0.5)
        .ticks((1..=system.modes.len()).map(|k| k as f64).collect::<Vec<f64>>());
    Panel::new(format!("modes: {}", names.join(", ")), Axis::linear("t"), axis)
        .series(Series::line("", steps(&numbers, &witness.at)))
}

fn inputs(system: &System, witness: &Witness) -> Panel {
    let mut panel = Panel::new("inputs", Axis::linear("t"), Axis::linear("input"));
    for (input, values) in system.inputs.iter().zip(&witness.inputs).take(MOST_PANELS) {
        let values: Vec<(Rational, f64)> = values.iter().map(|(from, value)| (from.clone(), float(value))).collect();
        panel = panel.series(Series::line(input.name.as_str(), steps(&values, &witness.at)));
    }
    panel
}

/// The answers as a piece of a page.
///
/// # Errors
/// [`Cancelled`].
pub fn reach(system: &System, decided: &[Decided], digits: u32, progress: &dyn Progress) -> Result<String, Cancelled> {
    let drawn = worst_cases(system, decided, progress)?;
    let shown = html! {
        @for found in decided {
            (super::decided(found.verdict, &found.check.text))
        }
        pre tabindex="0" { (reach::answer::text(system, decided, digits)) }
        (picture(&drawn, "reach", "What is asked for, all values at each time where the order of modes is fixed, and the motion found for the worst case."))
    };
    Ok(shown.into_string())
}
