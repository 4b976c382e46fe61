//! Verdicts: worst cases against the bounds that are asked for.

use crate::comparison::{Comparison, Shape, greatest};
use crate::ellipsoid::{Ellipsoid, abscissa, kept_box};
use crate::flow::Flows;
use crate::guess::bad_order;
use crate::modal::ModalError;
use crate::orders::Times;
use crate::platoon::{self, Platoon, Swung};
use crate::prepared::Prepared;
use crate::relaxed::relaxed;
use crate::search::allowance;
use crate::system::{Check, Condition, Input, Range, Side, Switching, System};
use crate::walk::{Depth, Leg, longest_of, worst};
use crate::witness::{Witness, attaining};
use crate::worst::Worst;
use arithmetic::{Cancelled, Enclosure, FloatInterval, Progress, Rational, rational};
pub use motion::sets::Verdict;
use num_traits::{Signed, Zero};

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReachError {
    /// The work was stopped.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A mode that may last for ever and is not stable.
    #[error(
        "the mode `{mode}` may last for ever and is not known to be stable (an eigenvalue has real part {growth:.3}), so that no worst cases are known for unbounded time; give `until` a number"
    )]
    Unstable {
        /// Its name.
        mode: String,
        /// The largest real part of an eigenvalue, in floats.
        growth: f64,
    },
    /// A platoon whose modes are out of reach of floats.
    #[error("{0}")]
    Platoon(String),
    /// More than can be followed.
    #[error("`until` = {until} is more than {most} steps of the fastest mode, the longest that is followed")]
    TooLong {
        /// The last time.
        until: String,
        /// The most steps.
        most: usize,
    },
}

/// What was found about one condition.
#[derive(Debug, Clone)]
pub struct Part {
    /// The condition.
    pub condition: Condition,
    /// The verdict.
    pub verdict: Verdict,
    /// The worst value of the left side is not below this.
    pub lo: Option<Rational>,
    /// The worst value of the left side is not above this.
    pub hi: Option<Rational>,
    /// It is attained between these times, where that is known.
    pub at: Option<Range>,
    /// Whether no motion attains the end on the side of the bound: values only come near to it.
    pub is_unattained: bool,
    /// A motion whose value is as near to the worst as was found.
    pub witness: Option<Witness>,
    /// How the value was bounded, or why there is no verdict.
    pub why: String,
}

impl Part {
    /// How far the worst value is from the bound; above 0 where the condition holds.
    pub fn margin(&self) -> Option<Range> {
        let worst = Range { lo: self.lo.clone()?, hi: self.hi.clone()? };
        let by = &self.condition.bound;
        Some(match self.condition.side {
            Side::AtLeast => worst.moved(&-by),
            Side::AtMost => worst.negated().moved(by),
        })
    }

    /// The time up to which it is drawn: the last one that is looked at, or else the end of the motion that was found.
    pub fn drawn_until(&self, system: &System) -> Rational {
        let end = || self.witness.as_ref().map(|witness| witness.at.clone());
        system.until.clone().or_else(end).unwrap_or(Rational::ONE)
    }
}

/// What was found about a check: its conditions, each by itself.
#[derive(Debug, Clone)]
pub struct Decided {
    /// The check.
    pub check: Check,
    /// That of all conditions together.
    pub verdict: Verdict,
    /// Each condition.
    pub parts: Vec<Part>,
}

impl Decided {
    /// The condition that the verdict comes from: one that is false, or undecided, or else the one nearest to its bound.
    pub fn decisive(&self) -> &Part {
        let margin = |part: &Part| match part.condition.side {
            Side::AtLeast => part.lo.as_ref().map(|lo| lo - &part.condition.bound),
            Side::AtMost => part.hi.as_ref().map(|hi| &part.condition.bound - hi),
        };
        let first = self.parts.iter().find(|part| part.verdict == self.verdict && self.verdict != Verdict::Holds);
        first.or_else(|| self.parts.iter().min_by_key(|part| margin(part))).unwrap_or(&self.parts[0])
    }
}

/// Digits more, where a bound lies within an enclosure.
const MORE: u32 = 20;

/// Bits of the enclosure of a witness's value: those of its digits, and some for the way there.
fn bits(digits: u32) -> u32 {
    96 + 4 * digits
}

/// Decides all checks; worst cases to so many digits where the order of modes is fixed.
///
/// # Errors
/// [`ReachError`].
pub fn decide(system: &System, digits: u32, progress: &dyn Progress) -> Result<Vec<Decided>, ReachError> {
    if let Some(platoon) = &system.platoon
        && let Some(decided) = by_modes(system, platoon, digits, progress)?
    {
        return Ok(decided);
    }
    let prepared = Prepared::new(system);
    within_limits(system, &prepared)?;
    stable_for_ever(system)?;
    // Checks that are about the same times share the tables of the flows.
    let mut times: Vec<Option<Rational>> = Vec::new();
    for check in &system.checks {
        if !times.contains(&check.at) {
            times.push(check.at.clone());
        }
    }
    let mut parts: Vec<Vec<Part>> = vec![Vec::new(); system.checks.len()];
    for at in &times {
        let (asked, rows) = rows(system, prepared.order(), at);
        let mut found = worst_of(system, &prepared, at.as_ref(), &rows, digits, progress)?;
        // A bound that lies within the enclosure may be met exactly: more digits, in which small numbers are exact, may tell.
        for (_, condition, index) in &asked {
            let worst = &found[*index].0;
            let (lo, hi) = left_side(condition, worst);
            let is_met = lo.is_some() && lo == hi;
            let between = lo.is_some_and(|lo| lo <= condition.bound) && hi.is_some_and(|hi| hi >= condition.bound);
            if between && !is_met && !worst.is_unattained && worst.is_closed(digits) {
                let finer = worst_of(system, &prepared, at.as_ref(), &rows[*index..=*index], digits + MORE, progress)?;
                found.splice(*index..=*index, finer);
            }
        }
        let witnesses = witnesses(system, &prepared, &rows, &found, digits);
        for (check, condition, index) in asked {
            let (worst, how) = &found[index];
            parts[check].push(part(condition, worst, how, witnesses[index].clone(), digits));
        }
    }
    Ok(together(system, parts))
}

/// The verdict of each check from those of its parts.
fn together(system: &System, parts: Vec<Vec<Part>>) -> Vec<Decided> {
    let decided = |(check, parts): (&Check, Vec<Part>)| {
        let any = |verdict| parts.iter().any(|part| part.verdict == verdict);
        let verdict = match (any(Verdict::False), any(Verdict::Undecided)) {
            (true, _) => Verdict::False,
            (_, true) => Verdict::Undecided,
            _ => Verdict::Holds,
        };
        Decided { check: check.clone(), verdict, parts }
    };
    system.checks.iter().zip(parts).map(decided).collect()
}

/// The checks of a platoon as sums over its modes, where they can be: the worst cases grow with time, so that they are those of the last.
fn by_modes(
    system: &System,
    platoon: &Platoon,
    digits: u32,
    progress: &dyn Progress,
) -> Result<Option<Vec<Decided>>, ReachError> {
    let (m, order) = (platoon.graph.followers(), system.states.len());
    let lags = |check: &Check| check.conditions.iter().all(|c| c.row[m..].iter().all(Zero::is_zero));
    let Some(way) = platoon.way().filter(|_| system.checks.iter().all(lags)) else { return Ok(None) };
    let mut parts: Vec<Vec<Part>> = vec![Vec::new(); system.checks.len()];
    let mut times: Vec<&Option<Rational>> = Vec::new();
    for check in &system.checks {
        if !times.contains(&&check.at) {
            times.push(&check.at);
        }
    }
    for at in times {
        let (asked, rows) = rows(system, order, at);
        let last = at.as_ref().or(system.until.as_ref());
        let found = match platoon::greatest(system, (platoon, &way), &rows, last, progress) {
            Err(ModalError::Cancelled(cancelled)) => return Err(cancelled.into()),
            // Small ones are left to the general method.
            Err(_) if system.is_written_out() => return Ok(None),
            Err(error) => return Err(ReachError::Platoon(error.to_string())),
            Ok(found) => found,
        };
        for (check, condition, index) in asked {
            let Swung { lo, hi, witness } = &found[index];
            let witness = witness.clone().map(|witness| match at {
                Some(at) => platoon::after_rest(witness, at),
                None => witness,
            });
            let time = last.cloned().map(Range::point);
            let worst = Worst { lo: Some(lo.clone()), hi: Some(hi.clone()), at: time, ..Worst::default() };
            parts[check].push(part(condition, &worst, SUMMED, witness, digits));
        }
    }
    Ok(Some(together(system, parts)))
}

const SUMMED: &str = "integrated over the response of the platoon to its leader, by modes or car by car; near the other end comes a leader whose acceleration follows the sign of the response";

/// A condition with its check, and the row whose greatest value it asks for.
type Asked<'a> = (usize, &'a Condition, usize);

/// The rows whose greatest values are asked for at these times, each once, and which condition asks for which.
fn rows<'a>(system: &'a System, order: usize, at: &Option<Rational>) -> (Vec<Asked<'a>>, Vec<Vec<Rational>>) {
    let (mut asked, mut rows): (Vec<_>, Vec<Vec<Rational>>) = (Vec::new(), Vec::new());
    for (k, check) in system.checks.iter().enumerate().filter(|(_, check)| check.at == *at) {
        for condition in &check.conditions {
            let turned = condition.side == Side::AtLeast;
            let mut row: Vec<Rational> = condition.row.iter().map(|x| if turned { -x } else { x.clone() }).collect();
            row.resize(order, Rational::ZERO);
            let index = rows.iter().position(|known| *known == row).unwrap_or_else(|| {
                rows.push(row);
                rows.len() - 1
            });
            asked.push((k, condition, index));
        }
    }
    (asked, rows)
}

const EXACT: &str = "enclosed over all inputs, starts and orders of modes";
const COMPARED: &str = "bounded for any switching by the mean of the modes with disturbances whose bounds are proved; the other end is attained";
const KEPT: &str = "bounded for any switching by an ellipsoid that no mode leads out of; the other end is attained";
const NO_BOUND: &str = "no bound was found: the disturbances that switching makes are not proved to stay bounded";
const UNATTAINED: &str = "bounded by the equation that the value itself obeys; no motion attains the bound";
const MANY: &str = "the search over durations ended before both ends met";

/// The greatest value of each row, and how it was found.
pub(crate) fn worst_of(
    system: &System,
    prepared: &Prepared,
    at: Option<&Rational>,
    rows: &[Vec<Rational>],
    digits: u32,
    progress: &dyn Progress,
) -> Result<Vec<(Worst, &'static str)>, ReachError> {
    let last = at.or(system.until.as_ref());
    let compared = match (&system.switching, last) {
        (Switching::Arbitrary | Switching::Dwell { .. }, _) | (Switching::Periodic { .. }, None) => {
            Comparison::find(prepared, last, Shape::Polygons, progress)?
        }
        _ => None,
    };
    let times = match (at, &system.until) {
        (Some(at), _) => Some(Times::At(at.clone())),
        (None, Some(until)) => Some(Times::Until(until.clone())),
        (None, None) => {
            let kept = match &compared {
                Some(comparison) => comparison.kept_box(progress)?,
                None => kept_for_ever(system, prepared, progress)?,
            };
            let back = rational(if matches!(system.switching, Switching::Dwell { .. }) { 16 } else { 8 }, 1);
            kept.map(|rest| Times::Forever { back, rest })
        }
    };
    let fixed = match &system.switching {
        Switching::Periodic { .. } => true,
        Switching::Windows { windows, .. } => windows.iter().all(Range::is_point),
        _ => false,
    };
    // Where modes follow each other in any order, a few digits are what a search over their durations gives; where instants are free, or a limit is approached in each
    // of many periods, those of floats.
    let digits = match (&system.switching, last) {
        (Switching::Periodic { order, .. }, None) if order.len() > 1 => digits.min(8),
        _ if fixed => digits,
        (Switching::Windows { .. }, _) => digits.min(8),
        _ => digits.min(3),
    };
    let listed = match &times {
        Some(times) => greatest(prepared, &system.switching, times, rows, digits, progress)?,
        None => None,
    };
    // What a search over instants leaves open, bounds for any switching may close.
    let open = listed.iter().flatten().any(|worst| !worst.is_closed(digits));
    let compared = match &system.switching {
        Switching::Windows { .. } if open && !fixed => Comparison::find(prepared, last, Shape::Polygons, progress)?,
        _ => compared,
    };
    let switched = matches!(system.switching, Switching::Arbitrary | Switching::Dwell { .. });
    let (bounds, bounded) = match &compared {
        Some(comparison) => (comparison.bounds(rows, progress)?, COMPARED),
        None if switched => {
            let kept = Ellipsoid::find(&prepared.motions, &prepared.start);
            let bound = |row: &Vec<Rational>| kept.as_ref().and_then(|kept| kept.bound(row, &prepared.start));
            (rows.iter().map(bound).collect::<Option<Vec<_>>>(), KEPT)
        }
        None => (None, NO_BOUND),
    };
    let mut found = Vec::new();
    for (k, row) in rows.iter().enumerate() {
        let bound = bounds.as_ref().map(|bounds| bounds[k].clone());
        found.push(match listed.as_ref().map(|listed| listed[k].clone()) {
            Some(worst) => {
                let how = if worst.is_closed(digits) { EXACT } else { MANY };
                let hi = worst.hi.iter().chain(&bound).min().cloned();
                (Worst { hi, ..worst }, how)
            }
            None => {
                let how = if bound.is_some() { bounded } else { NO_BOUND };
                (guessed(system, prepared, row, (at, last), bound, progress)?, how)
            }
        });
    }
    for (row, (worst, how)) in rows.iter().zip(&mut found) {
        if let Some(known) = relaxed(&prepared.motions, &prepared.start, row) {
            *worst = std::mem::take(worst).with(&known, at);
            *how = if worst.is_unattained { UNATTAINED } else { *how };
        }
    }
    Ok(found)
}

/// A box in which the states are, at unbounded times, where that is known: they keep it in all modes, or in the last, from where the others led them.
fn kept_for_ever(
    system: &System,
    prepared: &Prepared,
    progress: &dyn Progress,
) -> Result<Option<Vec<Range>>, Cancelled> {
    let Switching::Windows { order, windows } = &system.switching else {
        return Ok(kept_box(&prepared.motions, &prepared.start));
    };
    let Some(&last) = order.last() else { return Ok(None) };
    let start = match windows.last() {
        None => Some(prepared.start.clone()),
        Some(window) => {
            let times = Times::Until(window.hi.clone());
            let found = greatest(prepared, &system.switching, &times, &prepared.sides(), DIGITS_OF_BOX, progress)?;
            let most = found.and_then(|found| found.into_iter().map(|worst| worst.hi).collect::<Option<Vec<_>>>());
            most.map(|most| most.chunks(2).map(|pair| Range { lo: -&pair[1], hi: pair[0].clone() }).collect())
        }
    };
    Ok(start.and_then(|start| kept_box(std::slice::from_ref(&prepared.motions[last]), &start)))
}

/// Digits of the sides of a box in which states stay.
pub(crate) const DIGITS_OF_BOX: u32 = 3;

/// The greatest value up to some time for which there are few enough orders of modes.
fn attained_early(
    system: &System,
    prepared: &Prepared,
    row: &[Rational],
    progress: &dyn Progress,
) -> Result<Option<Worst>, ReachError> {
    for until in [16, 4, 1] {
        let last = rational(until, 1).min(system.until.clone().unwrap_or(rational(until, 1)));
        let times = Times::Until(last);
        if let Some(found) = greatest(prepared, &system.switching, &times, &[row.to_vec()], 3, progress)? {
            return Ok(found.into_iter().next());
        }
    }
    Ok(None)
}

/// Halvings of a time after which motions are not yet lost in their enclosure.
const SHORTER: usize = 8;

/// The greatest value of a row at the end of legs, backwards from there, in floats.
fn enclosed(prepared: &Prepared, row: &[Rational], legs: &[(usize, Rational)]) -> Option<(Rational, Rational)> {
    let longest = longest_of(legs, prepared.motions.len());
    let flows = Flows::new(&prepared.motions, &longest, &[], &FloatInterval::point(0.0));
    let walk: Vec<Leg> = legs.iter().map(Leg::fixed).collect();
    let floats: Vec<FloatInterval> = row.iter().map(FloatInterval::from_rational).collect();
    worst(&flows, &floats, &walk, &prepared.start, Depth::Value).value?.ends()
}

/// The legs that end an order of modes, of which backwards the first are given first, for a time.
fn ending(order: &[(usize, Rational)], time: &Rational) -> Vec<(usize, Rational)> {
    let (mut legs, mut left) = (Vec::new(), time.clone());
    for (mode, duration) in order {
        if !left.is_positive() {
            break;
        }
        let duration = duration.clone().min(left.clone());
        left -= &duration;
        legs.push((*mode, duration));
    }
    legs
}

/// A bound, and the value of a bad order of modes that was guessed.
fn guessed(
    system: &System,
    prepared: &Prepared,
    row: &[Rational],
    (at, last): (Option<&Rational>, Option<&Rational>),
    hi: Option<Rational>,
    progress: &dyn Progress,
) -> Result<Worst, ReachError> {
    let nothing = Worst { hi: hi.clone(), ..Worst::default() };
    if !matches!(system.switching, Switching::Arbitrary) {
        let early = if at.is_none() { attained_early(system, prepared, row, progress)? } else { None };
        return Ok(early.map_or(nothing, |worst| Worst { hi, ..worst }));
    }
    // For unbounded time, as long as motions are remembered.
    let slowest = prepared.motions.iter().filter_map(|motion| abscissa(&motion.a)).fold(f64::NEG_INFINITY, f64::max);
    let memory = Rational::from_float((30.0 / slowest.abs().max(1e-2)).ceil());
    let Some(until) = last.cloned().or(memory) else { return Ok(nothing) };
    let order = bad_order(prepared, row, &until, progress)?;
    let (mut legs, mut value) = (order.clone(), enclosed(prepared, row, &order));
    let is_lost = |value: &Option<(Rational, Rational)>| {
        value.as_ref().is_none_or(|(lo, hi)| hi - lo > allowance(&rational(1, 1000), lo))
    };
    let mut until = until;
    // Where values grow without end, the enclosure of a long motion says nothing, and that of a shorter one does.
    if at.is_none() && is_lost(&value) {
        for _ in 0..SHORTER {
            until *= rational(1, 2);
            if !is_lost(&enclosed(prepared, row, &ending(&order, &until))) {
                break;
            }
        }
        legs = bad_order(prepared, row, &until, progress)?;
        value = enclosed(prepared, row, &legs);
    }
    let value = value.map(|(lo, _)| lo);
    // The start itself may be worse than what any order makes of it in the end.
    let most = |(x, side): (&Rational, &Range)| (x * &side.lo).max(x * &side.hi);
    let begun: Rational = row.iter().zip(&prepared.start).map(most).sum();
    if at.is_none() && value.as_ref().is_none_or(|value| *value < begun) {
        return Ok(Worst { lo: Some(begun), hi, at: Some(Range::point(Rational::ZERO)), ..Worst::default() });
    }
    Ok(Worst { lo: value, hi, at: Some(Range::point(until)), legs, ..Worst::default() })
}

/// A motion for each row of which a value is attained; they share the tables of the flows.
fn witnesses(
    system: &System,
    prepared: &Prepared,
    rows: &[Vec<Rational>],
    found: &[(Worst, &str)],
    digits: u32,
) -> Vec<Option<Witness>> {
    use rayon::prelude::*;
    let legs: Vec<(usize, Rational)> = found.iter().flat_map(|(worst, _)| worst.legs.iter().cloned()).collect();
    let longest = longest_of(&legs, prepared.motions.len());
    let flows = Flows::new(&prepared.motions, &longest, &[], &FloatInterval::point(0.0));
    let one = |(row, (worst, _)): (&Vec<Rational>, &(Worst, &str))| {
        worst.lo.as_ref().map(|_| witness(system, prepared, &flows, row, worst, digits))
    };
    rows.par_iter().zip(found).map(one).collect()
}

fn witness(
    system: &System,
    prepared: &Prepared,
    flows: &Flows<FloatInterval>,
    row: &[Rational],
    worst: &Worst,
    digits: u32,
) -> Witness {
    let mut witness = attaining(system, prepared, flows, row, &worst.legs);
    // A motion of many stretches loses bits on each of them.
    for more in [1, 4, 16] {
        let Some((lo, hi)) = witness.value_of(system, &row[..system.states.len()], more * bits(digits)).ends() else {
            continue;
        };
        let is_tight = &hi - &lo <= allowance(&rational(1, 1_000_000), &lo);
        witness.value = Range { lo, hi };
        if is_tight {
            break;
        }
    }
    // The start is exact.
    if witness.at.is_zero() || worst.stays {
        witness.value = Range::point(row.iter().zip(&witness.start).map(|(x, start)| x * start).sum());
    }
    witness
}

/// A value of the row, which is turned for `>=`, as one of the left side.
fn turned(condition: &Condition, x: &Rational) -> Rational {
    let x = if condition.side == Side::AtLeast { -x } else { x.clone() };
    x + &condition.constant
}

/// The ends of the worst value of the left side.
fn left_side(condition: &Condition, worst: &Worst) -> (Option<Rational>, Option<Rational>) {
    let end = |x: &Option<Rational>| x.as_ref().map(|x| turned(condition, x));
    let (low, high) = (end(&worst.lo), end(&worst.hi));
    if condition.side == Side::AtLeast { (high, low) } else { (low, high) }
}

/// From the greatest value of the row, which is turned for `>=`, to the worst value of the left side.
fn part(condition: &Condition, worst: &Worst, how: &str, witness: Option<Witness>, digits: u32) -> Part {
    let (lo, hi) = left_side(condition, worst);
    let witness = witness.map(|mut witness| {
        let (a, b) = (turned(condition, &witness.value.lo), turned(condition, &witness.value.hi));
        witness.value = if a <= b { Range { lo: a, hi: b } } else { Range { lo: b, hi: a } };
        witness
    });
    let kept = |x: &Rational| condition.admits(x);
    let (safe, attained) = if condition.side == Side::AtLeast { (&lo, &hi) } else { (&hi, &lo) };
    let violated = |witness: &Witness| !kept(&witness.value.lo) && !kept(&witness.value.hi);
    let verdict = match (safe, attained, &witness) {
        (Some(safe), _, _) if kept(safe) => Verdict::Holds,
        (Some(safe), _, _) if worst.is_unattained && *safe == condition.bound => Verdict::Holds,
        (_, Some(attained), Some(witness)) if !kept(attained) && violated(witness) => Verdict::False,
        _ => Verdict::Undecided,
    };
    let why = match verdict {
        Verdict::Undecided if safe.is_some() && attained.is_some() => {
            format!("{how}; the bound lies between both ends ({digits} digits)")
        }
        Verdict::Undecided if attained.as_ref().is_some_and(|attained| !kept(attained)) => {
            format!(
                "{how}; the order of modes that was found violates the bound, but its motion could not be confirmed forwards in time"
            )
        }
        _ => how.to_string(),
    };
    let (at, is_unattained) = (worst.at.clone(), worst.is_unattained);
    Part { condition: condition.clone(), verdict, lo, hi, at, is_unattained, witness, why }
}

/// Whether the flows can be tabulated.
fn within_limits(system: &System, prepared: &Prepared) -> Result<(), ReachError> {
    let norm = prepared
        .motions
        .iter()
        .flat_map(|motion| (0..motion.a.len()).map(|j| motion.a.iter().map(|row| row[j].abs()).sum::<Rational>()));
    let norm = norm.max().unwrap_or_default();
    let longest =
        system.checks.iter().filter_map(|check| check.at.clone()).chain(system.until.clone()).max().unwrap_or_default();
    // Steps are at most halved below the inverse of the norm.
    if (norm + Rational::ONE) * &longest * rational(2, 1) > rational(MOST as i64, 1) {
        return Err(ReachError::TooLong { until: longest.to_string(), most: MOST });
    }
    Ok(())
}

/// Most steps of time.
const MOST: usize = 200_000;

/// A mode that may last for ever is stable where the time is not bounded.
fn stable_for_ever(system: &System) -> Result<(), ReachError> {
    if system.until.is_some() {
        return Ok(());
    }
    let lasting: Vec<usize> = match &system.switching {
        Switching::Windows { order, .. } => order.last().copied().into_iter().collect(),
        Switching::Periodic { order, .. } if order.len() == 1 => order.clone(),
        Switching::Periodic { .. } => Vec::new(),
        Switching::Arbitrary => (0..system.modes.len()).collect(),
        Switching::Dwell { stays, .. } => (0..stays.len()).filter(|&mode| stays[mode].most.is_none()).collect(),
    };
    for mode in lasting {
        let mode = &system.modes[mode];
        // States that do not move are numbers, not motions.
        let moves =
            |(factor, input): (&Rational, &Input)| !factor.is_zero() && input.range != Range::point(Rational::ZERO);
        let is_moved = |i: usize| mode.b[i].iter().zip(&system.inputs).any(moves);
        let moving: Vec<usize> = (0..mode.a.len())
            .filter(|&i| is_moved(i) || !mode.a[i].iter().chain([&mode.c[i]]).all(Zero::is_zero))
            .collect();
        let a: Vec<Vec<Rational>> =
            moving.iter().map(|&i| moving.iter().map(|&j| mode.a[i][j].clone()).collect()).collect();
        if let Some(growth) = abscissa(&a).filter(|growth| *growth >= -1e-9 && !moving.is_empty()) {
            return Err(ReachError::Unstable {
                mode: mode.name.clone(),
                growth: if growth.abs() < 1e-9 { 0.0 } else { growth },
            });
        }
    }
    Ok(())
}
