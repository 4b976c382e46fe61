//! Boxes that are divided until on each of them some literal is true: in layers, each on all cores, so that the result does not depend on their number.

use super::local::{Local, Sided, Signs, at_point, from_width};
use super::places::{Place, only_free, truth};
use super::tail::End;
use super::{Decision, Effort, Extended, Method, Open, Proof};
use crate::function::{Compared, Function, Literal, Side};
use arithmetic::{Cancelled, Progress, Rational, rational, simplest_between};
use num_traits::ToPrimitive;
use rayon::prelude::*;

/// Sides are not divided further below this, compared with the size of their numbers.
const THINNEST: f64 = 1e-11;

/// Open boxes that are told.
const TOLD: usize = 4096;

struct Cell {
    sides: Vec<Side>,
    depth: u32,
}

enum Standing {
    Closed(Vec<Method>, Option<Vec<Rational>>),
    /// By convexity, around a zero in closed form.
    ClosedAround(Vec<Place>),
    Fails(Vec<Rational>),
    FailsAt(Vec<Place>),
    Split(Vec<Extended>),
}

fn sided<'a, F>(literal: &'a Literal<F>, negative: bool) -> Sided<'a, F> {
    let strict = literal.compared != Compared::NotNegative;
    Sided { function: &literal.function, negative, strict, guarded: literal.guarded }
}

/// One literal on a box.
fn one<F: Function>(literal: &Literal<F>, sides: &[Side]) -> Local {
    match literal.compared {
        Compared::Positive | Compared::NotNegative => sided(literal, false).on_box(sides),
        Compared::NotZero => match sided(literal, false).on_box(sides) {
            found @ (Local::True { .. } | Local::TrueBut(_)) => found,
            _ => match sided(literal, true).on_box(sides) {
                // Neither sign everywhere says nothing about zero.
                found @ (Local::True { .. } | Local::TrueAround(_) | Local::TrueBut(_) | Local::Open(_)) => found,
                Local::False | Local::FailsAt(_) | Local::FailsAround(_) => Local::Open(Vec::new()),
            },
        },
        // Never by boxes; a point can refute it.
        Compared::Zero if sided(literal, false).is_apart(sides) => Local::False,
        Compared::Zero => Local::Open(Vec::new()),
    }
}

/// Whether some literal is shown to be true by a rule for functions of one sign.
fn one_is_true<F: Function>(clause: &[Literal<F>], rule: impl Fn(Sided<F>) -> bool) -> bool {
    clause.iter().any(|literal| match literal.compared {
        Compared::Positive | Compared::NotNegative => rule(sided(literal, false)),
        Compared::NotZero => [false, true].iter().any(|&turned| rule(sided(literal, turned))),
        Compared::Zero => false,
    })
}

/// Whether the clause is true on a box around a place: there exactly, and on either side of it by one literal.
fn is_true_around<F: Function>(clause: &[Literal<F>], sides: &[Side], place: &Place) -> bool {
    let Some(free) = only_free(sides) else { return false };
    let Some(at) = place.enclosure() else { return false };
    let Side { lo, hi, .. } = &sides[free];
    let inside = lo.as_ref().is_none_or(|lo| Extended::of(lo).hi < at.lo)
        && hi.as_ref().is_none_or(|hi| at.hi < Extended::of(hi).lo);
    let point: Vec<Rational> = sides.iter().map(Side::middle).collect();
    inside
        && [false, true].iter().all(|&above| one_is_true(clause, |own| own.beside(sides, free, place, above)))
        && matches!(truth(clause, &place.on_line(&point, free)), Signs::Holds { .. })
}

/// What is true at one end of a box in one number, and from there on, or at infinity: the points at which it was looked at exactly.
fn is_true_from_end<F: Function>(clause: &[Literal<F>], sides: &[Side]) -> Option<Option<Vec<Rational>>> {
    let free = only_free(sides).filter(|&k| !sides[k].integer)?;
    let beside = |end: End, from: Extended| one_is_true(clause, |own| own.is_true_at_end(sides, free, end, from));
    let is_true = |there: &[Side]| clause.iter().any(|literal| matches!(one(literal, there), Local::True { .. }));
    let far = |end: End, from: &Rational| (*from > rational(1, 1) && beside(end, Extended::of(from))).then_some(None);
    match (&sides[free].lo, &sides[free].hi) {
        (Some(lo), None) => far(End::Above, lo),
        (None, Some(hi)) => far(End::Below, &-hi.clone()),
        (None, None) => None,
        (Some(lo), Some(hi)) => {
            let from = from_width(Extended::of(&(hi - lo)))?;
            [(lo, true), (hi, false)].into_iter().find_map(|(at, after)| {
                let place = Place::of(at.clone());
                let end = if after { End::After(&place) } else { End::Before(&place) };
                let mut there = sides.to_vec();
                there[free] = Side::point(at.clone());
                let point: Vec<Rational> = there.iter().map(Side::middle).collect();
                let zero = match at_point(clause, &point) {
                    Signs::Holds { zero } => zero,
                    // Without a value there.
                    Signs::Unknown if is_true(&there) => false,
                    _ => return None,
                };
                beside(end, from).then(|| zero.then_some(point))
            })
        }
    }
}

fn look<F: Function>(clause: &[Literal<F>], cell: &Cell, places: &[Place]) -> Standing {
    let admitted = |point: &Vec<Rational>| cell.sides.iter().zip(point).all(|(side, q)| side.contains(q));
    let mut slopes = Vec::new();
    let mut open = false;
    let (mut candidates, mut around) = (Vec::new(), None);
    // A literal without slopes.
    let mut is_rough = false;
    for literal in clause {
        match one(literal, &cell.sides) {
            Local::True { method, zero } => {
                let zero = zero.filter(|zero| literal.compared == Compared::NotNegative && admitted(zero));
                return Standing::Closed(vec![method], zero);
            }
            Local::TrueAround(places) => return Standing::ClosedAround(places),
            Local::FailsAround(places) => {
                open = true;
                around = Some(places);
            }
            // Another literal may be true at that point.
            Local::TrueBut(point) => match at_point(clause, &point) {
                Signs::Holds { .. } => return Standing::Closed(vec![Method::Expansion], None),
                _ => {
                    open = true;
                    candidates.push(point);
                }
            },
            Local::False => {}
            Local::FailsAt(point) => {
                open = true;
                candidates.push(point);
            }
            Local::Open(own) => {
                open = true;
                is_rough |= own.is_empty();
                if slopes.is_empty() {
                    slopes = own;
                }
            }
        }
    }
    if !open {
        candidates.push(cell.sides.iter().map(Side::middle).collect());
    }
    match candidates.into_iter().find(|point| admitted(point) && at_point(clause, point) == Signs::Fails) {
        Some(point) => Standing::Fails(point),
        None if around.as_ref().is_some_and(|places| truth(clause, places) == Signs::Fails) => {
            Standing::FailsAt(around.unwrap_or_default())
        }
        None if places.iter().any(|place| is_true_around(clause, &cell.sides, place)) => {
            Standing::Closed(vec![Method::Expansion], None)
        }
        None if is_rough || is_far(&cell.sides) => match is_true_from_end(clause, &cell.sides) {
            Some(zero) => Standing::Closed(vec![Method::Ends], zero),
            None => Standing::Split(slopes),
        },
        None => Standing::Split(slopes),
    }
}

fn is_far(sides: &[Side]) -> bool {
    sides.iter().any(|side| side.lo.is_none() || side.hi.is_none())
}

/// The side to be divided: along which the function may change most, every third time the widest one.
fn direction(cell: &Cell, slopes: &[Extended], domain: &[Side]) -> Option<usize> {
    let width = |k: usize| {
        let (lo, hi) = cell.sides[k].floats();
        let (a, b) = domain[k].floats();
        if cell.sides[k].as_point().is_some() {
            return 0.0;
        }
        let whole = if (b - a).is_finite() { b - a } else { 1.0 };
        let size = if lo > 0.0 || hi < 0.0 { lo.abs().max(hi.abs()).min(whole) } else { whole };
        match (hi - lo) / size {
            // Integers are apart, however large they are.
            width if width.is_finite() && cell.sides[k].integer => width.max(2.0 * THINNEST),
            width if (hi - lo).is_finite() => width,
            _ => f64::INFINITY,
        }
    };
    let smear = |k: usize| {
        let (lo, hi) = cell.sides[k].floats();
        slopes.get(k).map_or(0.0, |slope| slope.hi.max(-slope.lo) * (hi - lo))
    };
    let smears: Vec<f64> = (0..cell.sides.len()).map(smear).collect();
    let useful = cell.depth % 3 != 2 && smears.iter().all(|x| x.is_finite()) && smears.iter().any(|x| *x > 0.0);
    let wide: Vec<usize> = (0..cell.sides.len()).filter(|&k| width(k) > THINNEST).collect();
    let key = |&k: &usize| if useful { smears[k] } else { width(k) };
    // Of equal ones the first.
    wide.iter().copied().rev().max_by(|a, b| key(a).total_cmp(&key(b)))
}

fn halves(cell: &Cell, k: usize) -> [Cell; 2] {
    let side = &cell.sides[k];
    let at = match (&side.lo, &side.hi) {
        (Some(lo), Some(hi)) => (lo + hi) * rational(1, 2),
        (Some(lo), None) if *lo >= rational(1, 1) => lo * rational(2, 1),
        (Some(_), None) => rational(1, 1).max(side.lo.clone().unwrap_or_default() + rational(1, 1)),
        (None, Some(hi)) if *hi <= rational(-1, 1) => hi * rational(2, 1),
        (None, Some(_)) => rational(-1, 1).min(side.hi.clone().unwrap_or_default() - rational(1, 1)),
        (None, None) => rational(0, 1),
    };
    parted(cell, k, at)
}

fn parted(cell: &Cell, k: usize, at: Rational) -> [Cell; 2] {
    let with = |side: Side| {
        let mut sides = cell.sides.clone();
        sides[k] = side;
        Cell { sides, depth: cell.depth + 1 }
    };
    let side = &cell.sides[k];
    let (at, after) = if side.integer { (at.floor(), at.floor() + rational(1, 1)) } else { (at.clone(), at) };
    let (lower, upper) = (side.clone(), side.clone());
    [with(Side { hi: Some(at), ..lower }), with(Side { lo: Some(after), ..upper })]
}

/// A box that is too thin to be halved, parted at the simplest number of a side: kinks of `abs`, `min` and `max` at such numbers are never reached by halves.
fn at_kink(cell: &Cell) -> Option<[Cell; 2]> {
    let inside = |k: usize| {
        let (lo, hi) = cell.sides[k].lo.as_ref().zip(cell.sides[k].hi.as_ref())?;
        let at = simplest_between(lo, hi);
        (at != *lo && at != *hi && !cell.sides[k].integer).then_some((k, at))
    };
    let (k, at) = (0..cell.sides.len()).find_map(inside)?;
    Some(parted(cell, k, at))
}

/// The product of the widths, where all are bounded; a side that is a number counts as 1.
pub(super) fn volume(sides: &[Side]) -> Option<f64> {
    let width = |side: &Side| match (&side.lo, &side.hi) {
        (Some(lo), Some(hi)) if lo == hi => Some(1.0),
        (Some(lo), Some(hi)) if side.integer => (hi - lo + rational(1, 1)).to_f64(),
        (Some(lo), Some(hi)) => (hi - lo).to_f64(),
        _ => None,
    };
    sides.iter().map(width).product()
}

/// Divides the domain into at most about so many boxes; `places` are numbers at which a literal is 0.
pub(super) fn divide<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    places: &[Place],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Decision, Cancelled> {
    let mut layer = vec![Cell { sides: domain.to_vec(), depth: 0 }];
    let mut proof = Proof::default();
    let mut thin = Vec::new();
    // Large steps cost more in many variables.
    let most = (effort.boxes / (domain.len() as u64).max(1)).max(16);
    while !layer.is_empty() && proof.boxes + layer.len() as u64 <= most {
        proof.boxes += layer.len() as u64;
        let standing = |cell: &Cell| -> Result<Standing, Cancelled> {
            progress.checkpoint()?;
            Ok(look(clause, cell, places))
        };
        let found = layer.par_iter().map(standing).collect::<Result<Vec<_>, _>>()?;
        let mut next = Vec::new();
        for (cell, standing) in layer.into_iter().zip(found) {
            match standing {
                Standing::Fails(point) => return Ok(Decision::Fails(point)),
                Standing::FailsAt(places) => return Ok(Decision::FailsAt(places)),
                Standing::ClosedAround(places) => {
                    proof.methods.push(Method::Convexity);
                    proof.places.push(places);
                }
                Standing::Closed(methods, zero) => {
                    proof.methods.extend(methods);
                    proof.zeros.extend(zero.filter(|zero| !proof.zeros.contains(zero)));
                }
                Standing::Split(slopes) => match direction(&cell, &slopes, domain) {
                    Some(k) => next.extend(halves(&cell, k)),
                    None => match at_kink(&cell) {
                        Some(halves) => next.extend(halves),
                        None => thin.push(cell),
                    },
                },
            }
        }
        proof.methods.sort_unstable();
        proof.methods.dedup();
        layer = next;
    }
    layer.extend(thin);
    if layer.is_empty() {
        return Ok(Decision::Holds(proof));
    }
    let whole = volume(domain).filter(|whole| *whole > 0.0);
    let parts = layer.iter().map(|cell| volume(&cell.sides)).sum::<Option<f64>>();
    let share = whole.zip(parts).map(|(whole, parts)| (parts / whole).min(1.0));
    let why = "the sign could not be told on all boxes".to_string();
    let boxes = layer.into_iter().take(TOLD).map(|cell| cell.sides).collect();
    Ok(Decision::Undecided(Open { why, boxes, share, looked: proof.boxes, degrees: Vec::new() }))
}
