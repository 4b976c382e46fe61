//! Functions that keep their sign along lines: those that depend on differences or sums only, up to exponentials as factors, and homogeneous ones. What holds on the sides of the domain through
//! which the lines leave it holds on all of it.

use super::attained::at_share;
use super::goals::held_at_points;
use super::local::{Signs, at_point, enclosed_on, seeded};
use super::places::{free, simple};
use super::{Decision, Effort, Proof, on_rest};
use crate::function::{Function, Literal, Side};
use crate::symbolic::{Extension, Symbolic};
use arithmetic::{Cancelled, Dual, Field, Progress, Rational, Ring, random, rational};
use nalgebra::DMatrix;
use num_traits::{Signed as _, Zero};

/// Largest number of variables that are looked at.
const MOST: usize = 5;

/// Points at which slopes are compared in floats.
const POINTS: usize = 12;

/// Along which lines no literal changes its sign.
enum Lines {
    /// All of these direction, with an entry for each variable.
    Parallel(Vec<Rational>),
    /// Through 0.
    Rays,
}

/// Decides on the sides of the domain; `None` where there are no such lines, or where it stays open there.
pub(super) fn decided<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Option<Decision>, Cancelled> {
    let free = free(domain);
    if !(2..=MOST).contains(&free.len()) || free.iter().any(|&k| domain[k].integer) {
        return Ok(None);
    }
    // Along a line a function may change its sign where it has no value.
    let is_total = |own: &Literal<F>| enclosed_on(&own.function, domain).is_some_and(|value| value.defined);
    if !effort.conditions && !clause.iter().all(is_total) {
        return Ok(None);
    }
    let parallel = || parallel(clause, domain, &free).map(Lines::Parallel);
    let Some(lines) = parallel().or_else(|| are_homogeneous(clause, domain, &free).then_some(Lines::Rays)) else {
        return Ok(None);
    };
    let Some(faces) = (match &lines {
        Lines::Parallel(direction) => crossed(domain, &free, direction),
        Lines::Rays => ahead(clause, domain, &free),
    }) else {
        return Ok(None);
    };
    let share = Effort { boxes: effort.boxes / 2, ..effort };
    let mut proof = Proof::default();
    for face in &faces {
        match on_rest(clause, face, share, progress)? {
            Decision::Holds(own) => proof.add(own),
            Decision::Undecided(_) => return Ok(None),
            fails => return Ok(Some(fails)),
        }
    }
    Ok(Some(Decision::Holds(proof)))
}

/// What a literal is at a point, in floats.
struct Seen {
    slopes: Vec<f64>,
    value: f64,
    /// The free numbers of the point.
    at: Vec<f64>,
    literal: usize,
}

/// All literals with their slopes at a few points.
fn slopes<F: Function>(clause: &[Literal<F>], domain: &[Side], free: &[usize]) -> Vec<Seen> {
    let mut stream = random::generator("inequality", "lines", domain.len() as u64);
    let mut rows = Vec::new();
    for _ in 0..POINTS {
        let x: Vec<f64> = domain.iter().map(|side| at_share(side, random::uniform(&mut stream))).collect();
        for (number, literal) in clause.iter().enumerate() {
            let slope = |&k: &usize| literal.function.value(&seeded(&x, k)).ok().map(|value| value.derivative);
            let row: Option<Vec<f64>> = free.iter().map(slope).collect();
            let value = literal.function.value(&x[..]).ok();
            if let (Some(row), Some(value)) = (row, value)
                && row.iter().chain([&value]).all(|y| y.is_finite())
            {
                rows.push(Seen { slopes: row, value, at: free.iter().map(|&k| x[k]).collect(), literal: number });
            }
        }
    }
    rows
}

/// A direction along which each literal changes at a rate that is a multiple of it: proposed by the slopes at a few points, shown by identity.
fn parallel<F: Function>(clause: &[Literal<F>], domain: &[Side], free: &[usize]) -> Option<Vec<Rational>> {
    const FINE: f64 = 1e-9;
    let rows: Vec<Vec<f64>> = slopes(clause, domain, free)
        .into_iter()
        .map(|seen| {
            let mut row = seen.slopes;
            row.extend((0..clause.len()).map(|k| if k == seen.literal { -seen.value } else { 0.0 }));
            let size = row.iter().fold(0.0f64, |size, x| size.max(x.abs()));
            row.iter().map(|x| if size > 0.0 { x / size } else { *x }).collect()
        })
        .collect();
    // First without multiples, since what does not change at all is simpler.
    [0, clause.len()].into_iter().find_map(|more| {
        let columns = free.len() + more;
        let matrix =
            DMatrix::from_fn(rows.len().max(columns), columns, |i, j| rows.get(i).map_or(0.0, |row: &Vec<f64>| row[j]));
        let parts = matrix.svd(false, true);
        let least = parts.singular_values.imin();
        if rows.len() < columns || parts.singular_values[least] > FINE * parts.singular_values.max() {
            return None;
        }
        let row = parts.v_t?.row(least).clone_owned();
        let size = row.iter().take(free.len()).fold(0.0f64, |size, x| size.max(x.abs()));
        let mut direction = vec![rational(0, 1); domain.len()];
        for (&k, x) in free.iter().zip(row.iter()) {
            direction[k] = simple(x / size, FINE, 64)?;
        }
        let multiple =
            |k: usize| if more > 0 { simple(row[free.len() + k] / size, FINE, 64) } else { Some(rational(0, 1)) };
        let along = |x: &[Symbolic]| {
            x.iter().zip(&direction).map(|(x, rate)| Dual::new(x.clone(), x.rational(rate))).collect::<Vec<_>>()
        };
        let stays = |(k, literal): (usize, &Literal<F>)| {
            let changes = |multiple: Rational| is_multiple(derivative(literal, domain, along), &multiple);
            multiple(k).is_some_and(changes)
        };
        (direction.iter().any(|rate| !rate.is_zero()) && clause.iter().enumerate().all(stays)).then_some(direction)
    })
}

/// Whether a rate is this multiple of the value, by identity.
fn is_multiple(found: Option<Dual<Symbolic>>, multiple: &Rational) -> bool {
    let rest = found.map(|found| found.derivative - found.value.clone() * found.value.rational(multiple));
    rest.is_some_and(|rest| rest.as_constant().is_some_and(|c| c.is_zero()))
}

/// A literal as a function, with its rate along a direction of each point.
fn derivative<F: Function>(
    literal: &Literal<F>,
    domain: &[Side],
    along: impl Fn(&[Symbolic]) -> Vec<Dual<Symbolic>>,
) -> Option<Dual<Symbolic>> {
    let x = held_at_points(&Extension::new(domain.len()).arguments(), domain);
    literal.function.value(&along(&x)).ok()
}

/// Whether each literal is homogeneous, of any degree, in the free variables, by Euler's identity.
fn are_homogeneous<F: Function>(clause: &[Literal<F>], domain: &[Side], free: &[usize]) -> bool {
    let along = |x: &[Symbolic]| {
        let rate = |(k, x): (usize, &Symbolic)| if free.contains(&k) { x.clone() } else { x.zero() };
        x.iter().enumerate().map(|own| Dual::new(own.1.clone(), rate(own))).collect::<Vec<_>>()
    };
    clause.iter().all(|literal| {
        let rows = slopes(std::slice::from_ref(literal), domain, free);
        let degree = |seen: &Seen| {
            let rate: f64 = seen.slopes.iter().zip(&seen.at).map(|(slope, x)| slope * x).sum();
            (seen.value.abs() > 1e-6).then(|| rate / seen.value)
        };
        let Some(degree) = rows.iter().find_map(degree).and_then(|degree| simple(degree, 1e-9, 24)) else {
            return false;
        };
        is_multiple(derivative(literal, domain, along), &degree)
    })
}

fn with(domain: &[Side], k: usize, at: &Rational) -> Vec<Side> {
    let mut face = domain.to_vec();
    face[k] = Side::point(at.clone());
    face
}

/// The sides through which parallel lines leave the domain in one of both directions; where no line leaves it, a plane that all of them cross.
fn crossed(domain: &[Side], free: &[usize], direction: &[Rational]) -> Option<Vec<Vec<Side>>> {
    let moving: Vec<usize> = free.iter().copied().filter(|&k| !direction[k].is_zero()).collect();
    let ends = |forwards: bool| -> Vec<Vec<Side>> {
        let end = |&k: &usize| {
            let side = &domain[k];
            let end = if direction[k].is_positive() == forwards { &side.hi } else { &side.lo };
            end.as_ref().map(|end| with(domain, k, end))
        };
        moving.iter().filter_map(end).collect()
    };
    let both = [ends(true), ends(false)];
    if both.iter().all(Vec::is_empty) {
        return moving.first().map(|&k| vec![with(domain, k, &rational(0, 1))]);
    }
    both.into_iter().filter(|faces| !faces.is_empty()).min_by_key(Vec::len)
}

/// The sides through which rays from 0 leave the domain; of all reals, and of all on one side of 0, those of the cube from -1 to 1. At 0 itself the clause has to be
/// true.
fn ahead<F: Function>(clause: &[Literal<F>], domain: &[Side], free: &[usize]) -> Option<Vec<Vec<Side>>> {
    let zero = rational(0, 1);
    let is_cone =
        |k: &usize| [&domain[*k].lo, &domain[*k].hi].iter().all(|end| end.as_ref().is_none_or(|q| q.is_zero()));
    let is_bounded = |k: &usize| domain[*k].lo.is_some() && domain[*k].hi.is_some();
    let mut box_of = domain.to_vec();
    if free.iter().all(is_cone) {
        for &k in free {
            let end = |end: &Option<Rational>, far| end.clone().unwrap_or_else(|| rational(far, 1));
            box_of[k] = Side::between(end(&domain[k].lo, -1), end(&domain[k].hi, 1));
        }
    } else if !free.iter().all(is_bounded) {
        return None;
    }
    let origin: Vec<Rational> =
        (0..domain.len()).map(|k| if free.contains(&k) { zero.clone() } else { domain[k].middle() }).collect();
    let has_origin = origin.iter().zip(domain).all(|(q, side)| side.contains(q));
    if has_origin && !matches!(at_point(clause, &origin), Signs::Holds { .. }) {
        return None;
    }
    let mut faces = Vec::new();
    for &k in free {
        faces.extend(box_of[k].hi.iter().filter(|hi| **hi > zero).map(|hi| with(&box_of, k, hi)));
        faces.extend(box_of[k].lo.iter().filter(|lo| **lo < zero).map(|lo| with(&box_of, k, lo)));
    }
    Some(faces)
}
