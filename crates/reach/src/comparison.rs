//! Bounds for any switching: every mode is the mean of the modes plus disturbances, whose bounds are assumed and then proved.
//!
//! Let `A = mean of A_m`, and let `d(t)` be what mode `m(t)` adds: `d = (A_m - A) x + (drift_m - drift) + (B_m - B) u`. If with `d` in a set `D` the
//! system `x' = A x + drift + B u + d` keeps what every mode would add strictly inside `D`, then so does the switched system: up to the first time at which
//! it reaches the boundary it is a motion of the other. So worst cases of one mode with more inputs bound those of any switching. `D` is an interval for one state,
//! and for two states a polygon, since what switching does to both is not independent.

use crate::ellipsoid::kept_box;
use crate::orders::Times;
use crate::prepared::{Motion, Prepared, Push};
use crate::system::{Range, Switching};
use crate::worst::{Solver, Worst};
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_traits::{Signed, ToPrimitive, Zero};

/// Digits of the bounds: the disturbances leave more of a gap than they do.
const DIGITS: u32 = 5;

/// The number of an input that is none of the system's.
const DISTURBANCE: usize = usize::MAX;

/// No motion is followed further back; less far where each mode that it leads through has a duration of its own.
const LONGEST: i64 = 5000;
const LONGEST_OF_SEVERAL: i64 = 16;

/// The one mode with disturbances, whose motions include those of any switching.
#[derive(Debug, Clone)]
pub(crate) struct Comparison {
    prepared: Prepared,
    times: Times,
}

/// What a mode adds along the normal of a face: a row of the states, and the rest, which is bounded at once.
struct Deviation {
    row: Vec<Rational>,
    rest: Rational,
    face: usize,
}

/// How disturbances are bounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Each by itself, as the checker has it.
    Box,
    /// Those of two states together, where there are few.
    Polygons,
}

/// Pairs of opposite faces of a polygon.
const FACES: usize = 8;

/// Most states whose disturbances are bounded together with another's.
const PAIRED: usize = 6;

/// The edges of a set of disturbances, and the normals of its faces: a face of a polygon has the number of the edge that it is along, to which it is perpendicular.
struct Faces {
    edges: Vec<Vec<Rational>>,
    normals: Vec<Vec<Rational>>,
    /// How many faces each polygon has, in turn: an interval has one.
    counts: Vec<usize>,
}

impl Faces {
    fn new(motions: &[Motion], mean: &Motion, shape: Shape) -> Self {
        let n = mean.a.len();
        let unit = |i: usize| (0..n).map(|j| rational(i64::from(i == j), 1)).collect::<Vec<Rational>>();
        let size = |i: usize| {
            let sizes = motions.iter().map(|motion| {
                let (row, rest) = added(motion, mean, &unit(i));
                row.iter().map(|x| x.abs()).sum::<Rational>() + rest
            });
            sizes.max().unwrap_or_default()
        };
        let disturbed: Vec<(usize, Rational)> =
            (0..n).map(|i| (i, size(i))).filter(|(_, size)| !size.is_zero()).collect();
        let mut faces = Faces { edges: Vec::new(), normals: Vec::new(), counts: Vec::new() };
        let paired = shape == Shape::Polygons && disturbed.len() <= PAIRED;
        for group in disturbed.chunks(if paired { 2 } else { 1 }) {
            let [(i, first), (j, second)] = group else {
                group.iter().for_each(|(i, _)| faces.push(unit(*i), unit(*i)));
                faces.counts.push(group.len());
                continue;
            };
            for k in 0..FACES {
                let angle = std::f64::consts::PI * k as f64 / FACES as f64;
                let near = |x: f64| rational((x * f64::from(1 << 20)).round() as i64, 1 << 20);
                let (cos, sin) = (near(angle.cos()), near(angle.sin()));
                let at = |x: Rational, y: Rational| {
                    let mut vector = vec![Rational::ZERO; n];
                    (vector[*i], vector[*j]) = (x, y);
                    vector
                };
                faces.push(at(-&sin * first, &cos * second), at(&cos / first, &sin / second));
            }
            faces.counts.push(FACES);
        }
        faces
    }

    fn push(&mut self, edge: Vec<Rational>, normal: Vec<Rational>) {
        self.edges.push(edge);
        self.normals.push(normal);
    }

    /// Half the lengths of the edges, from how far the faces are from the middle, in floats.
    fn lengths(&self, far: &[f64]) -> Vec<f64> {
        let (mut lengths, mut from) = (Vec::new(), 0);
        for &count in &self.counts {
            let far = &far[from..from + count];
            from += count;
            let angle = std::f64::consts::PI / count as f64;
            for k in 0..count {
                let beside = far[(k + 1) % count] + far[(k + count - 1) % count];
                lengths.push(match count {
                    1 => far[0],
                    _ => (beside - 2.0 * angle.cos() * far[k]).max(0.0) / (2.0 * angle.sin()),
                });
            }
        }
        lengths
    }

    /// How far a face is from the middle.
    fn far(&self, face: usize, lengths: &[Rational]) -> Rational {
        let along = |edge: &Vec<Rational>| product(edge, &self.normals[face]).abs();
        self.edges.iter().zip(lengths).map(|(edge, length)| along(edge) * length).sum()
    }
}

fn product(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).filter(|(x, _)| !x.is_zero()).map(|(x, y)| x * y).sum()
}

fn one_mode() -> Switching {
    Switching::Windows { order: vec![0], windows: Vec::new() }
}

/// The times for one mode: up to the last that is looked at, or for ever.
pub(crate) fn times_of(prepared: &Prepared, until: Option<&Rational>) -> Option<Times> {
    match until {
        Some(until) => Some(Times::Until(until.clone())),
        None => {
            let rest = kept_box(&prepared.motions, &prepared.start)?;
            Some(Times::Forever { back: rational(8, 1), rest })
        }
    }
}

/// The greatest values of rows for one mode, for ever if need be: what lies far back is followed until it no longer matters.
pub(crate) fn greatest(
    prepared: &Prepared,
    switching: &Switching,
    times: &Times,
    rows: &[Vec<Rational>],
    digits: u32,
    progress: &dyn Progress,
) -> Result<Option<Vec<Worst>>, Cancelled> {
    let longest = match switching {
        Switching::Dwell { .. } => LONGEST_OF_SEVERAL,
        Switching::Windows { windows, .. } if windows.iter().any(|window| !window.is_point()) => LONGEST_OF_SEVERAL,
        _ => LONGEST,
    };
    let mut times = times.clone();
    loop {
        let Some(solver) = Solver::new(prepared, switching, &times, digits, progress) else { return Ok(None) };
        let found = solver.all(rows)?;
        match &mut times {
            Times::Forever { back, .. }
                if *back < rational(longest, 1) && found.iter().any(|worst| !worst.is_closed(digits)) =>
            {
                *back *= rational(2, 1);
            }
            _ => return Ok(Some(found)),
        }
    }
}

impl Comparison {
    /// Finds bounds of the disturbances and proves them; none where they do not close.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn find(
        prepared: &Prepared,
        until: Option<&Rational>,
        shape: Shape,
        progress: &dyn Progress,
    ) -> Result<Option<Self>, Cancelled> {
        let mean = mean(&prepared.motions);
        let faces = Faces::new(&prepared.motions, &mean, shape);
        let deviations = deviations(&prepared.motions, &mean, &faces);
        let alone = Prepared { motions: vec![mean.clone()], start: prepared.start.clone() };
        let count = faces.normals.len();
        let most = |prepared: &Prepared, deviations: &[Deviation]| -> Result<Option<Vec<Rational>>, Cancelled> {
            let Some(times) = times_of(prepared, until) else { return Ok(None) };
            let rows: Vec<Vec<Rational>> = deviations.iter().map(|deviation| deviation.row.clone()).collect();
            let found = greatest(prepared, &one_mode(), &times, &rows, DIGITS, progress)?;
            Ok(found.and_then(|found| farthest(deviations, &found, count)))
        };
        let Some(free) = most(&alone, &deviations)? else { return Ok(None) };
        // From rest and with one disturbance the greatest value of a row is that of its negative.
        let unit = |d: &Deviation| Deviation { rest: Rational::ZERO, row: d.row.clone(), face: d.face };
        let one_sign = |d: &&Deviation| d.row.iter().find(|x| !x.is_zero()).is_some_and(|x| x.is_positive());
        let halves: Vec<Deviation> = deviations.iter().filter(one_sign).map(unit).collect();
        let still = Motion { drift: vec![Rational::ZERO; mean.a.len()], pushes: Vec::new(), a: mean.a.clone() };
        let mut gains = Vec::new();
        for edge in &faces.edges {
            let one = disturbed_by(&still, std::slice::from_ref(edge), &[Rational::ONE]);
            let still = Prepared { motions: vec![one], start: vec![Range::point(Rational::ZERO); mean.a.len()] };
            let Some(gain) = most(&still, &halves)? else { return Ok(None) };
            gains.push(gain);
        }
        let Some(lengths) = fixed_point(&faces, &free, &gains) else { return Ok(None) };
        let motions = vec![disturbed_by(&mean, &faces.edges, &lengths)];
        let moved = Prepared { motions, start: prepared.start.clone() };
        let Some(proved) = most(&moved, &deviations)? else { return Ok(None) };
        let closes = proved.iter().enumerate().all(|(face, found)| *found < faces.far(face, &lengths));
        let times = times_of(&moved, until).filter(|_| closes);
        Ok(times.map(|times| Comparison { prepared: moved, times }))
    }

    /// The mean of the modes, with its disturbances.
    pub fn mean(&self) -> &Motion {
        &self.prepared.motions[0]
    }

    /// The edges of the set of disturbances, half as long as they are, each over the first states.
    pub fn edges(&self, states: usize) -> Vec<Vec<Rational>> {
        let pushes = self.mean().pushes.iter().filter(|push| push.input == DISTURBANCE);
        pushes.map(|push| push.column[..states].iter().map(|entry| entry * &push.radius).collect()).collect()
    }

    /// Bounds of the greatest values of rows at all times that are looked at.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn bounds(&self, rows: &[Vec<Rational>], progress: &dyn Progress) -> Result<Option<Vec<Rational>>, Cancelled> {
        let found = greatest(&self.prepared, &one_mode(), &self.times, rows, DIGITS, progress)?;
        Ok(found.and_then(|found| found.into_iter().map(|worst| worst.hi).collect()))
    }

    /// A box that no motion leaves, however it is switched.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn kept_box(&self, progress: &dyn Progress) -> Result<Option<Vec<Range>>, Cancelled> {
        let Some(bounds) = self.bounds(&self.prepared.sides(), progress)? else { return Ok(None) };
        Ok(Some(bounds.chunks(2).map(|pair| Range { lo: -pair[1].clone(), hi: pair[0].clone() }).collect()))
    }
}

/// The mean mode.
fn mean(motions: &[Motion]) -> Motion {
    let n = motions[0].a.len();
    let share = rational(1, motions.len() as i64);
    let average = |entry: &dyn Fn(&Motion) -> Rational| motions.iter().map(entry).sum::<Rational>() * &share;
    let mut inputs: Vec<&Push> = Vec::new();
    for push in motions.iter().flat_map(|motion| &motion.pushes) {
        if inputs.iter().all(|known| known.input != push.input) {
            inputs.push(push);
        }
    }
    let pushes = inputs.iter().map(|push| {
        let column = (0..n).map(|i| average(&|motion| effect(motion, push.input, i))).collect();
        Push { column, ..(*push).clone() }
    });
    Motion {
        a: (0..n).map(|i| (0..n).map(|j| average(&|motion| motion.a[i][j].clone())).collect()).collect(),
        drift: (0..n).map(|i| average(&|motion| motion.drift[i].clone())).collect(),
        pushes: pushes.collect(),
    }
}

/// What an input adds to the rate of a state.
fn effect(motion: &Motion, input: usize, i: usize) -> Rational {
    motion.pushes.iter().find(|push| push.input == input).map_or(Rational::ZERO, |push| push.column[i].clone())
}

/// What a mode adds to the mean along a normal: a row of the states, and a bound of the rest in absolute value.
fn added(motion: &Motion, mean: &Motion, normal: &[Rational]) -> (Vec<Rational>, Rational) {
    let n = mean.a.len();
    let of = |entry: &dyn Fn(usize) -> Rational| -> Rational {
        (0..n).filter(|&i| !normal[i].is_zero()).map(|i| &normal[i] * entry(i)).sum()
    };
    let row = (0..n).map(|j| of(&|i| &motion.a[i][j] - &mean.a[i][j])).collect();
    let mut rest = of(&|i| &motion.drift[i] - &mean.drift[i]).abs();
    for push in &mean.pushes {
        let most = push.centre.abs() + &push.radius;
        rest += of(&|i| effect(motion, push.input, i) - &push.column[i]).abs() * most;
    }
    (row, rest)
}

/// What each mode adds along each normal, in both signs.
fn deviations(motions: &[Motion], mean: &Motion, faces: &Faces) -> Vec<Deviation> {
    let mut deviations: Vec<Deviation> = Vec::new();
    for (face, normal) in faces.normals.iter().enumerate() {
        for motion in motions {
            let (row, rest) = added(motion, mean, normal);
            for row in [row.iter().map(|x| -x).collect(), row] {
                match deviations.iter_mut().find(|d| d.face == face && d.row == row) {
                    Some(known) => known.rest = known.rest.clone().max(rest.clone()),
                    None => deviations.push(Deviation { row, rest: rest.clone(), face }),
                }
            }
        }
    }
    deviations
}

/// The motion with a disturbance along each edge.
fn disturbed_by(mean: &Motion, edges: &[Vec<Rational>], lengths: &[Rational]) -> Motion {
    let mut motion = mean.clone();
    for (edge, length) in edges.iter().zip(lengths) {
        let push = Push { input: DISTURBANCE, centre: Rational::ZERO, radius: length.clone(), column: edge.clone() };
        motion.pushes.push(push);
    }
    motion
}

/// How far disturbances come along each normal.
fn farthest(deviations: &[Deviation], found: &[Worst], count: usize) -> Option<Vec<Rational>> {
    let mut most = vec![Rational::ZERO; count];
    for (deviation, worst) in deviations.iter().zip(found) {
        let size = worst.hi.as_ref()? + &deviation.rest;
        let most = &mut most[deviation.face];
        *most = most.clone().max(size);
    }
    Some(most)
}

/// Lengths of edges a little above those of the set that is kept, in floats: they are proved afterwards. None where there is none.
fn fixed_point(faces: &Faces, free: &[Rational], gains: &[Vec<Rational>]) -> Option<Vec<Rational>> {
    let floats =
        |row: &[Rational]| -> Option<Vec<f64>> { row.iter().map(|q| q.to_f64().filter(|x| x.is_finite())).collect() };
    let free = floats(free)?;
    let gains: Vec<Vec<f64>> = gains.iter().map(|gains| floats(gains)).collect::<Option<_>>()?;
    let mut lengths = faces.lengths(&free);
    for _ in 0..20_000 {
        let mut far = free.clone();
        for (length, gains) in lengths.iter().zip(&gains) {
            far.iter_mut().zip(gains).for_each(|(sum, gain)| *sum += gain * length);
        }
        let next = faces.lengths(&far);
        let still = next.iter().zip(&lengths).all(|(x, y)| (x - y).abs() <= 1e-9 * y);
        lengths = next;
        if still {
            return lengths
                .iter()
                .map(|x| Rational::from_float((x * 1.0005 + 1e-9) as f32).map(|x| x * rational(10_001, 10_000)))
                .collect();
        }
        if lengths.iter().any(|x| *x > 1e12) {
            return None;
        }
    }
    None
}
