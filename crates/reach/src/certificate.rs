//! Certificates for the separate checker: the worst motion that was found, of kind `motion`, which it follows itself; and that no motion comes beyond what the checks allow, of
//! kind `bound`, which it shows by sums over steps of its own, how many being found by asking it, or of kind `kept`, a set that no mode leads out of.

use crate::comparison::{Comparison, Shape};
use crate::decide::{DIGITS_OF_BOX, Decided, Part, ReachError, Verdict, worst_of};
use crate::ellipsoid::{Ellipsoid, moving_abscissa};
use crate::prepared::{Motion, Prepared};
use crate::system::{Condition, Range, Side, Stay, Switching, System};
use arithmetic::{Cancelled, Progress, Rational, common_denominator, decimal, parse_rational, rational};
use num_traits::{Signed, ToPrimitive, Zero};

/// Digits of the bound beyond which the motion comes.
const DIGITS: u32 = 12;

/// Why no motion is certified.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unshown {
    /// There is none, or the matrices of its system are left out.
    #[error("no motion was found that it could show")]
    Missing,
    /// It is more than the checker follows.
    #[error("the checker does not follow the motion that was found, {duration} units of time long: {reason}")]
    Refused {
        /// How long it lasts.
        duration: String,
        /// What the checker says.
        reason: String,
    },
}

/// The certificate that the witness of a condition comes beyond its value rounded against it, which the checker accepted.
///
/// # Errors
/// [`Unshown`].
pub fn certificate(system: &System, part: &Part) -> Result<String, Unshown> {
    let text = motion(system, part).ok_or(Unshown::Missing)?;
    match (flockproof_checker::check(text.as_bytes()), &part.witness) {
        (Ok(_), _) => Ok(text),
        (Err(refusal), witness) => {
            let duration = witness.as_ref().map_or_else(String::new, |witness| decimal(&witness.at, 6, false));
            Err(Unshown::Refused { duration, reason: refusal.reason })
        }
    }
}

fn motion(system: &System, part: &Part) -> Option<String> {
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
         bounds and its modes for the times below, as the switching below allows, ends with row x > {bound}\n"
    );
    written(&mut text, system, Some(&witness.at));
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

/// States, inputs, modes and which orders of them are allowed, up to a later time where one is given.
fn written(text: &mut String, system: &System, later: Option<&Rational>) {
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
    allowed(text, &system.switching);
    match &system.until {
        Some(until) => *text += &format!("until {}\n", later.unwrap_or(until).max(until)),
        None => *text += "until ever\n",
    }
}

/// Which orders of modes are allowed.
fn allowed(text: &mut String, switching: &Switching) {
    let turns = |order: &[usize]| order.iter().map(|mode| format!(" {}", mode + 1)).collect::<String>();
    *text += &match switching {
        Switching::Arbitrary => "switching any\n".to_string(),
        Switching::Periodic { order, period } => {
            format!("switching periodic\nturns{}\nperiod {period}\n", turns(order))
        }
        Switching::Windows { order, windows } => {
            let windows = windows.iter().map(|window| format!("window {} {}\n", window.lo, window.hi));
            format!("switching windows\nturns{}\n{}", turns(order), windows.collect::<String>())
        }
        Switching::Dwell { first, stays } => {
            let first = first.map_or("any".to_string(), |first| (first + 1).to_string());
            let stays = stays.iter().map(|stay| {
                let most = stay.most.as_ref().map_or("none".to_string(), Rational::to_string);
                format!("stay {} {most}\n", stay.least)
            });
            format!("switching dwell\nfirst {first}\n{}", stays.collect::<String>())
        }
    };
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
    if system.until.as_ref().is_some_and(|until| !until.is_positive()) {
        return unfit("the checker bounds motions up to a time above 0, or for ever");
    }
    if !system.is_written_out() {
        return unfit("the checker bounds platoons of at most 100 followers");
    }
    if system.until.is_none() && system.states.len() > LARGEST {
        return unfit("for ever the checker bounds systems of at most 40 states");
    }
    let rows = rows(decided);
    if rows.is_empty() {
        return unfit("no check at all times holds that a certificate could be about");
    }
    let refused = match stepped(system, &rows, progress) {
        Err(Unbounded::Cancelled(cancelled)) => return Err(cancelled.into()),
        Ok(text) => return Ok(text),
        Err(error) => error,
    };
    // What steps of time do not show, a set that no motion leaves may.
    kept(system, &rows).filter(|text| flockproof_checker::check(text.as_bytes()).is_ok()).ok_or(refused)
}

/// Rows with their bounds from above.
type Rows = Vec<(Vec<Rational>, Rational)>;

/// A certificate of kind `kept`: an ellipsoid that no mode leads out of.
fn kept(system: &System, rows: &Rows) -> Option<String> {
    let (prepared, n) = (Prepared::new(system), system.states.len());
    let found =
        Ellipsoid::find(&prepared.motions, &prepared.start).filter(|found| found.moving.len() == n && n <= LARGEST)?;
    let (modes, count) = (system.modes.len(), rows.len());
    let mut text = format!(
        "flockproof-certificate 1 kept\nclaim no motion of the system of {modes} linear modes and {n} states below, from a start and with inputs within their bounds and with its modes as the switching below \
         allows, comes at {times} with any of the {count} rows to a value above its bound\n",
        times = times_of(system)
    );
    written(&mut text, system, None);
    bounds(&mut text, rows);
    matrix(&mut text, "P", &found.form);
    text += &format!("rate {}\nradius {}\n", found.rate, found.radius);
    let solved = rows.iter().map(|(row, _)| found.solved(row, Rational::clone)).collect::<Option<Vec<_>>>()?;
    matrix(&mut text, "y", &solved);
    Some(text + "end\n")
}

/// Most states of a system that is bounded for ever: of a box each side is a worst case, and an ellipsoid is written exactly.
const LARGEST: usize = 40;

/// The lines of rows and their bounds.
fn bounds(text: &mut String, rows: &Rows) {
    let (left, right): (Vec<Vec<Rational>>, Vec<Rational>) = rows.iter().cloned().unzip();
    *text += &format!("rows {}\n", rows.len());
    matrix(text, "row", &left);
    matrix(text, "bound", &[right]);
}

/// How a claim puts the times that are looked at.
fn times_of(system: &System) -> &'static str {
    if system.until.is_some() { "any time up to the last one" } else { "any time" }
}

/// A certificate of kind `bound`, which the checker accepted, by steps of time.
fn stepped(system: &System, rows: &Rows, progress: &dyn Progress) -> Result<String, Unbounded> {
    if let Some(ways) = fixed(system, progress)? {
        return tried(system, rows, &ways, progress);
    }
    // What any switching does is shown with the least work, where it is within the bounds.
    let refused = match any(system, rows, progress).and_then(|ways| tried(system, rows, &ways, progress)) {
        Err(Unbounded::Cancelled(cancelled)) => return Err(cancelled.into()),
        Ok(text) => return Ok(text),
        Err(error) => error,
    };
    match free(system, progress)? {
        Some(ways) => tried(system, rows, &ways, progress),
        None => Err(refused),
    }
}

/// The first of the ways that the checker accepts, with finer and finer steps.
fn tried(system: &System, rows: &Rows, ways: &[Way], progress: &dyn Progress) -> Result<String, Unbounded> {
    let (n, modes, count) = (system.states.len(), system.modes.len(), rows.len());
    let mut body = String::new();
    written(&mut body, system, None);
    bounds(&mut body, rows);
    let mut refused = String::new();
    for finer in 0..FINEST {
        let mut open = false;
        for way in ways {
            progress.checkpoint()?;
            let mut text = format!(
                "flockproof-certificate 1 bound\nclaim no motion of the system of {modes} linear modes and {n} states below, from a start and with inputs within their bounds and with its modes as the \
                 switching below allows, comes at {} with any of the {count} rows to a value above its bound\n{body}{}",
                times_of(system),
                way.begun
            );
            for (begun, time, norm) in &way.stretches {
                // The checker asks for steps of norm at most 1/2.
                let steps = (norm * time * rational(2 << finer, 1)).ceil().max(Rational::ONE);
                text += &format!("{begun}steps {steps}\n");
            }
            text += &format!("{}end\n", way.ended);
            match flockproof_checker::check(text.as_bytes()) {
                Ok(_) => return Ok(text),
                Err(refusal) => {
                    open |= !TOO_MUCH.iter().any(|why| refusal.reason.contains(why));
                    refused = refusal.reason;
                }
            }
        }
        if !open {
            break;
        }
    }
    Err(Unbounded::Refused(refused))
}

/// What the checker says of files that finer steps only make worse.
const TOO_MUCH: [&str; 3] = ["too many steps", "take too long", "is expected"];

/// One way to write the orders of modes: what stands before and after the stretches, and these.
struct Way {
    begun: String,
    stretches: Vec<Stretch>,
    ended: String,
}

/// How the lines of a stretch begin, how long it lasts, and the norm of its matrix.
type Stretch = (String, Rational, Rational);

/// Halvings of the steps.
const FINEST: u32 = 12;

/// The order of modes where it is fixed; none where it is not, or where it does not repeat itself for ever.
fn fixed(system: &System, progress: &dyn Progress) -> Result<Option<Vec<Way>>, Unbounded> {
    let prepared = Prepared::new(system);
    let way = |order: Vec<(usize, Rational)>, begun: &str, ended: String| {
        let begun = format!("{begun}\nstretches {}\n", order.len());
        let stretch = |(mode, time): (usize, Rational)| {
            (format!("mode {}\ntime {time}\n", mode + 1), time, norm(&prepared.motions[mode].a))
        };
        Way { begun, stretches: order.into_iter().map(stretch).collect(), ended }
    };
    if let Some(until) = &system.until {
        let order = stretches(&system.switching, until);
        return Ok(order.map(|order| vec![way(order, "order given", String::new())]));
    }
    let (order, period) = match &system.switching {
        Switching::Periodic { order, period } => (order, period.clone()),
        Switching::Windows { order, windows } if windows.is_empty() => (order, Rational::ONE),
        _ => return Ok(None),
    };
    let motions: Vec<Motion> = order.iter().map(|&mode| prepared.motions[mode].clone()).collect();
    let lengths = memories(&motions);
    let found = match worst_of(system, &prepared, None, &prepared.sides(), DIGITS_OF_BOX, progress) {
        Ok(found) => found,
        Err(ReachError::Cancelled(cancelled)) => return Err(cancelled.into()),
        Err(_) => return Ok(None),
    };
    let Some(most) = found.into_iter().map(|(worst, _)| worst.hi).collect::<Option<Vec<_>>>() else { return Ok(None) };
    let ended = |cycle: usize| format!("cycle {cycle}\n{}", sides(system, &most, &rational(101, 100)));
    let ways = lengths.into_iter().map(|length| match &order[..] {
        [mode] => way(vec![(*mode, length)], "order given for ever", ended(1)),
        _ => {
            let cycles =
                (length / (&period * rational(order.len() as i64, 1))).ceil().to_integer().to_usize().unwrap_or(1);
            let turns = (0..=cycles).flat_map(|_| order.iter().map(|&mode| (mode, period.clone())));
            way(turns.collect(), "order given for ever", ended(order.len()))
        }
    });
    Ok(Some(ways.collect()))
}

/// How long, roughly, until a start is forgotten, to a few and to twice as many digits.
fn memories(motions: &[Motion]) -> Vec<Rational> {
    let slowest = motions.iter().filter_map(moving_abscissa).filter(|x| *x < -1e-9).fold(-1e9, f64::max);
    [6.0, 12.0].into_iter().filter_map(|digits| Rational::from_float((digits / -slowest * 8.0).ceil() / 8.0)).collect()
}

/// A box larger by a factor than the greatest values of the states in both signs.
fn sides(system: &System, most: &[Rational], factor: &Rational) -> String {
    let side = |pair: &[Rational]| pair.iter().max().map_or(Rational::ONE, |x| x * factor + rational(1, 1 << 20));
    let mut text = String::new();
    matrix(&mut text, "box", &[most.chunks(2).take(system.states.len()).map(side).collect()]);
    text
}

/// The simplest set of disturbances that is small enough for the bounds of all rows.
fn comparison(system: &System, rows: &Rows, progress: &dyn Progress) -> Result<(Comparison, Shape), Unbounded> {
    let prepared = Prepared::new(system);
    let (left, right): (Vec<Vec<Rational>>, Vec<&Rational>) = rows
        .iter()
        .map(|(row, bound)| {
            let mut row = row.clone();
            row.resize(prepared.order(), Rational::ZERO);
            (row, bound)
        })
        .unzip();
    let mut why = Unbounded::Unfit("the disturbances that switching makes are not proved to stay bounded");
    for shape in [Shape::Box, Shape::Polygons] {
        let Some(found) = Comparison::find(&prepared, system.until.as_ref(), shape, progress)? else { continue };
        match found.bounds(&left, progress)? {
            Some(bounds) if bounds.iter().zip(&right).all(|(found, bound)| found <= *bound) => {
                return Ok((found, shape));
            }
            _ => why = Unbounded::Refused("the disturbances that switching makes are too large".to_string()),
        }
    }
    Err(why)
}

/// Any order of modes: disturbances by which it is one, some more generous than others.
fn any(system: &System, rows: &Rows, progress: &dyn Progress) -> Result<Vec<Way>, Unbounded> {
    let prepared = Prepared::new(system);
    let (found, shape) = comparison(system, rows, progress)?;
    let norm = norm(&found.mean().a);
    let edges = found.edges(system.states.len());
    let (times, begun, ended) = match &system.until {
        Some(until) => (vec![until.clone()], "order any", String::new()),
        None => {
            let Some(most) = found.bounds(&prepared.sides(), progress)? else {
                return Err(Unbounded::Unfit("the states are not proved to stay bounded"));
            };
            let times = memories(std::slice::from_ref(found.mean()));
            (times, "order any for ever", sides(system, &most, &rational(101, 100)))
        }
    };
    let way = |time: &Rational, more: Rational| {
        let mut text = String::new();
        let edges: Vec<Vec<Rational>> = edges.iter().map(|edge| edge.iter().map(|x| x * &more).collect()).collect();
        match shape {
            Shape::Box => {
                let limits = (0..system.states.len()).map(|i| edges.iter().map(|edge| edge[i].clone()).sum());
                matrix(&mut text, "disturbance", &[limits.collect()]);
            }
            Shape::Polygons => {
                text += &format!("edges {}\n", edges.len());
                matrix(&mut text, "edge", &edges);
            }
        }
        text += &format!("time {time}\n");
        Way { begun: format!("{begun}\n"), stretches: vec![(text, time.clone(), norm.clone())], ended: ended.clone() }
    };
    Ok(times.iter().flat_map(|time| [rational(1001, 1000), rational(101, 100)].map(|more| way(time, more))).collect())
}

/// Switches at free instants, within windows or after durations that are allowed; none where these are not the question, or where states are not known to stay bounded.
fn free(system: &System, progress: &dyn Progress) -> Result<Option<Vec<Way>>, Unbounded> {
    if !matches!(system.switching, Switching::Windows { .. } | Switching::Dwell { .. }) {
        return Ok(None);
    }
    let prepared = Prepared::new(system);
    let found = match worst_of(system, &prepared, None, &prepared.sides(), DIGITS_OF_BOX, progress) {
        Ok(found) => found,
        Err(ReachError::Cancelled(cancelled)) => return Err(cancelled.into()),
        Err(_) => return Ok(None),
    };
    let Some(most) = found.into_iter().map(|(worst, _)| worst.hi).collect::<Option<Vec<_>>>() else { return Ok(None) };
    // Where time ends, so far that the box is not needed.
    let times = match (&system.until, &system.switching) {
        (None, _) => memories(&prepared.motions),
        (Some(until), Switching::Dwell { .. }) => vec![until * rational(9, 8)],
        (Some(until), _) => vec![until.clone()],
    };
    let norms: Vec<Rational> = prepared.motions.iter().map(|motion| norm(&motion.a)).collect();
    let begun = |factor: &Rational| format!("order free\n{}", sides(system, &most, factor));
    let mut ways = Vec::new();
    for time in &times {
        for factor in [rational(101, 100), rational(11, 10)] {
            match &system.switching {
                Switching::Windows { order, windows } => {
                    ways.push(windows_of(order, windows, (&system.until, time), &norms, begun(&factor)));
                }
                Switching::Dwell { stays, .. } => {
                    let legs = [2, 3, 5, 8].map(|legs| dwell_of(stays, time, legs, &norms, begun(&factor)));
                    ways.extend(legs);
                }
                _ => {}
            }
        }
    }
    Ok(Some(ways))
}

/// The pieces of time between and in windows, the last one of a given length where time does not end.
fn windows_of(
    order: &[usize],
    windows: &[Range],
    (until, last): (&Option<Rational>, &Rational),
    norms: &[Rational],
    mut begun: String,
) -> Way {
    let mut ends: Vec<(Rational, Rational)> = Vec::new();
    for (pair, window) in order.windows(2).zip(windows) {
        ends.push((norms[pair[0]].clone(), window.lo.clone()));
        ends.push((norms[pair[0]].clone().max(norms[pair[1]].clone()), window.hi.clone()));
    }
    let end = windows.last().map_or(Rational::ZERO, |window| window.hi.clone()) + last;
    if until.is_none() {
        begun += &format!("last {last}\n");
    }
    let end = until.clone().unwrap_or(end);
    ends.push((order.last().map_or(Rational::ONE, |&mode| norms[mode].clone()), end.clone()));
    let mut now = Rational::ZERO;
    let mut stretches = Vec::new();
    for (norm, to) in ends {
        let to = to.min(end.clone());
        if to > now {
            stretches.push((String::new(), &to - &now, norm));
            now = to;
        }
    }
    Way { begun, stretches, ended: String::new() }
}

/// Legs of each mode, followed back for a time and for so many of them.
fn dwell_of(stays: &[Stay], back: &Rational, legs: usize, norms: &[Rational], begun: String) -> Way {
    let stretch = |(stay, norm): (&Stay, &Rational)| {
        let time = stay.most.clone().unwrap_or(back.clone()).min(back.clone());
        (format!("time {time}\n"), time, norm.clone())
    };
    let begun = format!("{begun}back {back}\nlegs {legs}\n");
    Way { begun, stretches: stays.iter().zip(norms).map(stretch).collect(), ended: String::new() }
}

/// The rows of all conditions that hold at all times, each once, turned so that they are bounded from above.
fn rows(decided: &[Decided]) -> Rows {
    let mut rows: Rows = Vec::new();
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
