//! Certificates for the separate checker: the worst motion that was found, of kind `motion`, which it follows itself; and of kind `bound`, that no motion comes beyond what
//! the checks allow, which it shows by sums over steps of its own. How many steps that takes is found by asking it.

use crate::comparison::Comparison;
use crate::decide::{Decided, Part, Verdict};
use crate::prepared::Prepared;
use crate::system::{Condition, Range, Side, Switching, System};
use arithmetic::{Cancelled, Progress, Rational, common_denominator, decimal, parse_rational, rational};
use num_traits::{Signed, ToPrimitive, Zero};

/// Digits of the bound beyond which the motion comes.
const DIGITS: u32 = 12;

/// The certificate that the witness of a condition comes beyond its value rounded against it; none where there is no witness.
pub fn certificate(system: &System, part: &Part) -> Option<String> {
    let witness = part.witness.as_ref().filter(|witness| !witness.at.is_zero() && system.is_written_out())?;
    let condition = &part.condition;
    let turned = condition.side == Side::AtLeast;
    // Row and value as a greatest value, without the constant.
    let row: Vec<Rational> = condition.row.iter().map(|x| if turned { -x } else { x.clone() }).collect();
    let value = if turned { &condition.constant - &witness.value.hi } else { &witness.value.lo - &condition.constant };
    let unit = rational(1, 1_000_000_000_000);
    let bound = parse_rational(&decimal(&(value - unit), DIGITS, false)).ok()?;
    let (n, inputs, modes) = (system.states.len(), system.inputs.len(), system.modes.len());
    let mut text = format!(
        "flockproof-certificate 1 motion\nclaim a motion of the system of {modes} linear modes and {n} states below, from its start, with its inputs within their \
         bounds and its modes for the times below, ends with row x > {bound}\n"
    );
    written(&mut text, system);
    matrix(&mut text, "row", &[row]);
    text += &format!("bound {bound}\n");
    matrix(&mut text, "start", std::slice::from_ref(&witness.start));
    let stretches = witness.stretches();
    text += &format!("stretches {}\n", stretches.len());
    for (mode, time, values) in stretches {
        text += &format!("mode {}\ntime {time}\n", mode + 1);
        if inputs > 0 {
            matrix(&mut text, "u", &[values]);
        }
    }
    text += "end\n";
    Some(text)
}

/// States, inputs and modes.
fn written(text: &mut String, system: &System) {
    let (n, inputs, modes) = (system.states.len(), system.inputs.len(), system.modes.len());
    *text += &format!("states {n}\ninputs {inputs}\nmodes {modes}\n");
    ends(text, ["start_least", "start_most"], &system.start);
    if inputs > 0 {
        let ranges: Vec<Range> = system.inputs.iter().map(|input| input.range.clone()).collect();
        ends(text, ["input_least", "input_most"], &ranges);
        let kept = system.inputs.iter().map(|input| rational(i64::from(input.constant), 1)).collect();
        matrix(text, "constant", &[kept]);
    }
    for mode in &system.modes {
        matrix(text, "A", &mode.a);
        if inputs > 0 {
            matrix(text, "B", &mode.b);
        }
        matrix(text, "c", std::slice::from_ref(&mode.c));
    }
}

/// Why there is no certificate from above.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unbounded {
    /// The work was stopped.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The checker has no proof of this kind.
    #[error("{0}")]
    Unfit(&'static str),
    /// It refused the finest steps.
    #[error(
        "the bounds are too near to the worst cases for the checker, or the system is too large or followed for too long: {0}"
    )]
    Refused(String),
}

/// A certificate that no motion violates the checks that hold at all times, which the checker accepted.
///
/// # Errors
/// [`Unbounded`].
pub fn bounded(system: &System, decided: &[Decided], progress: &dyn Progress) -> Result<String, Unbounded> {
    let unfit = |why| Err(Unbounded::Unfit(why));
    let Some(until) = system.until.as_ref().filter(|until| until.is_positive()) else {
        return unfit("the checker bounds motions up to a time, and `until` is none");
    };
    if !system.is_written_out() {
        return unfit("the checker bounds platoons of at most 100 followers");
    }
    let rows = rows(decided);
    if rows.is_empty() {
        return unfit("no check at all times holds that a certificate could be about");
    }
    let (order, ways): (&str, Vec<Vec<Stretch>>) = match &system.switching {
        Switching::Arbitrary => ("any", disturbances(system, until, progress)?),
        switching => match stretches(switching, until) {
            Some(stretches) => {
                ("given", vec![stretches.into_iter().map(|(mode, time)| stretch(system, mode, time)).collect()])
            }
            None => return unfit("the checker bounds motions with a fixed order of modes, or with any"),
        },
    };
    let (n, modes, count) = (system.states.len(), system.modes.len(), rows.len());
    let how =
        if order == "any" { "any measurable choice of its modes up to the time" } else { "its modes for the times" };
    let mut head = format!(
        "flockproof-certificate 1 bound\nclaim no motion of the system of {modes} linear modes and {n} states below, from a start and with inputs within their bounds and with {how} \
         below, comes at any of these times with any of the {count} rows to a value above its bound\n"
    );
    written(&mut head, system);
    head += &format!("rows {count}\n");
    let (left, right): (Vec<Vec<Rational>>, Vec<Rational>) = rows.into_iter().unzip();
    matrix(&mut head, "row", &left);
    matrix(&mut head, "bound", &[right]);
    head += &format!("order {order}\n");
    let mut refused = String::new();
    for finer in 0..FINEST {
        for way in &ways {
            progress.checkpoint()?;
            let mut text = head.clone();
            if order == "given" {
                text += &format!("stretches {}\n", way.len());
            }
            for (begun, time, norm) in way {
                // The checker asks for steps of norm at most 1/2.
                let steps = (norm * time * rational(2 << finer, 1)).ceil().max(Rational::ONE);
                text += &format!("{begun}time {time}\nsteps {steps}\n");
            }
            text += "end\n";
            match flockproof_checker::check(text.as_bytes()) {
                Ok(_) => return Ok(text),
                Err(refusal) => refused = refusal.reason,
            }
        }
        if ["too many steps", "take too long", "is expected"].iter().any(|why| refused.contains(why)) {
            break;
        }
    }
    Err(Unbounded::Refused(refused))
}

/// How the lines of a stretch begin, how long it lasts, and the norm of its matrix.
type Stretch = (String, Rational, Rational);

/// Halvings of the steps.
const FINEST: u32 = 12;

/// The rows of all conditions that hold at all times, each once, turned so that they are bounded from above.
fn rows(decided: &[Decided]) -> Vec<(Vec<Rational>, Rational)> {
    let mut rows: Vec<(Vec<Rational>, Rational)> = Vec::new();
    let held = decided.iter().filter(|found| found.verdict == Verdict::Holds && found.check.at.is_none());
    for part in held.flat_map(|found| &found.parts) {
        let (row, bound) = turned(part);
        match rows.iter_mut().find(|(known, _)| *known == row) {
            Some((_, least)) => *least = least.clone().min(bound),
            None => rows.push((row, bound)),
        }
    }
    rows
}

fn turned(part: &Part) -> (Vec<Rational>, Rational) {
    let Condition { row, constant, side, strict, bound } = &part.condition;
    // Below a bound that is not reached there is another one.
    let safe = if *side == Side::AtLeast { &part.lo } else { &part.hi };
    let bound = match safe {
        Some(safe) if *strict => (bound + safe) * rational(1, 2),
        _ => bound.clone(),
    };
    match side {
        Side::AtLeast => (row.iter().map(|x| -x).collect(), constant - bound),
        Side::AtMost => (row.clone(), bound - constant),
    }
}

/// The largest absolute sum of a row, of a matrix whose other columns are inputs that keep one value.
fn norm(a: &[Vec<Rational>]) -> Rational {
    a.iter().map(|row| row.iter().map(|x| x.abs()).sum::<Rational>()).max().unwrap_or_default()
}

fn stretch(system: &System, mode: usize, time: Rational) -> Stretch {
    (format!("mode {}\n", mode + 1), time, norm(&Prepared::new(system).motions[mode].a))
}

/// The modes in a fixed order up to a time, each with how long it lasts; none where the order is not fixed.
fn stretches(switching: &Switching, until: &Rational) -> Option<Vec<(usize, Rational)>> {
    let ends: Vec<(usize, Rational)> = match switching {
        Switching::Periodic { order, period } => {
            let count = (until / period).ceil().to_integer().to_usize()?;
            let end = |k: usize| (order[k % order.len()], period * rational(k as i64 + 1, 1));
            (0..count).map(end).collect()
        }
        Switching::Windows { order, windows } if windows.iter().all(Range::is_point) => {
            let ends = windows.iter().map(|window| window.lo.clone()).chain([until.clone()]);
            order.iter().copied().zip(ends).collect()
        }
        _ => return None,
    };
    let mut before = Rational::ZERO;
    let mut stretches = Vec::new();
    for (mode, end) in ends {
        let end = end.min(until.clone());
        if end > before {
            stretches.push((mode, &end - &before));
            before = end;
        }
    }
    Some(stretches)
}

/// Limits of the disturbances by which any order of modes is one, some more generous than others, with the time and the norm.
fn disturbances(system: &System, until: &Rational, progress: &dyn Progress) -> Result<Vec<Vec<Stretch>>, Unbounded> {
    let prepared = Prepared::new(system);
    let Some(found) = Comparison::find(&prepared, Some(until), progress)? else {
        return Err(Unbounded::Unfit("the disturbances that switching makes are not proved to stay bounded"));
    };
    let norm = norm(found.mean());
    let limits = found.limits(system.states.len());
    let way = |more: Rational| {
        let limits = limits.iter().map(|x| x * &more).collect();
        let mut text = String::new();
        matrix(&mut text, "disturbance", &[limits]);
        vec![(text, until.clone(), norm.clone())]
    };
    Ok([rational(1001, 1000), rational(101, 100)].map(way).into())
}

fn ends(text: &mut String, names: [&str; 2], ranges: &[Range]) {
    matrix(text, names[0], &[ranges.iter().map(|range| range.lo.clone()).collect()]);
    matrix(text, names[1], &[ranges.iter().map(|range| range.hi.clone()).collect()]);
}

/// A matrix over its least common denominator, a line for each row.
fn matrix(text: &mut String, name: &str, rows: &[Vec<Rational>]) {
    let denominator = common_denominator(rows.iter().flatten());
    *text += &format!("{name} over {denominator}\n");
    let scale = Rational::from_integer(denominator);
    for row in rows {
        let entries: Vec<String> = row.iter().map(|x| (x * &scale).to_string()).collect();
        *text += &format!("{}\n", entries.join(" "));
    }
}
