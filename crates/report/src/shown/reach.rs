//! Worst cases of a switched linear system: verdicts, the tube of each quantity, the worst motion with its modes and inputs.

use super::{picture, verdict};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::{Cancelled, Progress, Rational};
use maud::html;
use num_traits::ToPrimitive;
use reach::{Decided, Part, System, Verdict, Witness, along, tube};

/// Times at which the tube is drawn.
const SAMPLES: usize = 160;

/// One panel for each quantity that is asked about, one for the modes and one for the inputs of the first witness.
///
/// # Errors
/// [`Cancelled`].
pub fn worst_cases(system: &System, decided: &[Decided], progress: &dyn Progress) -> Result<Picture, Cancelled> {
    let mut picture = Picture::new("Worst cases").grid(2, (460.0, 320.0));
    let mut drawn: Vec<&[Rational]> = Vec::new();
    let mut signals = None;
    for part in decided.iter().flat_map(|found| &found.parts) {
        if drawn.contains(&&part.condition.row[..]) || drawn.len() == MOST_PANELS {
            continue;
        }
        drawn.push(&part.condition.row);
        let bounds =
            decided.iter().flat_map(|found| &found.parts).filter(|other| other.condition.row == part.condition.row);
        picture = picture.panel(quantity(system, part, bounds, progress)?);
        signals = signals.or(part.witness.as_ref());
    }
    if let Some(witness) = signals {
        picture = picture.panel(modes(system, witness));
        picture = picture.panel(inputs(system, witness));
    }
    Ok(picture.caption("Areas: all values at each time, proved. Lines: the motion found for the worst case; modes and inputs are those of the first panel."))
}

const MOST_PANELS: usize = 8;

fn float(x: &Rational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

fn quantity<'a>(
    system: &System,
    part: &Part,
    bounds: impl Iterator<Item = &'a Part>,
    progress: &dyn Progress,
) -> Result<Panel, Cancelled> {
    let name = reach::answer::left_side(system, &part.condition);
    let end = part.witness.as_ref().map(|witness| witness.at.clone());
    let until = system.until.clone().or(end).unwrap_or(Rational::ONE);
    let mut panel = Panel::new(name.clone(), Axis::linear("t"), Axis::linear(name));
    let tube = tube(system, &part.condition, &until, SAMPLES, progress)?;
    if !tube.is_empty() {
        let outline =
            tube.iter().map(|(t, low, _)| (*t, *low)).chain(tube.iter().rev().map(|(t, _, high)| (*t, *high)));
        panel = panel.below(Series::area("all motions", outline).colour("#9ecae1"));
    }
    for (k, other) in bounds.enumerate() {
        let bound = float(&other.condition.bound);
        let name = if k == 0 { "bounds asked for" } else { "" };
        panel = panel.series(Series::dashed(name, [(0.0, bound), (float(&until), bound)]).colour("#d1580b"));
    }
    if let Some(witness) = &part.witness {
        panel = panel
            .series(Series::line("worst motion", along(system, &part.condition, witness, SAMPLES)).colour("#1f4e79"));
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
    let word = |found: &Decided| match found.verdict {
        Verdict::Holds => ("holds", "✓"),
        Verdict::False => ("false", "✗"),
        Verdict::Undecided => ("undecided", "?"),
    };
    let shown = html! {
        @for found in decided {
            (verdict(word(found).0, word(found).1, found.verdict.word(), &found.check.text))
        }
        pre tabindex="0" { (reach::answer::text(system, decided, digits)) }
        (picture(&drawn, "reach", "What is asked for, all values at each time where the order of modes is fixed, and the motion found for the worst case."))
    };
    Ok(shown.into_string())
}
