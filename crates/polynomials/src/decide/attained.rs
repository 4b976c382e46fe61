//! Where a function is 0: in closed form, at a root of a polynomial in one number, or at a point that Krawczyk's operator proves to be in a small box.

use super::local::{is_positive_definite, polish, seeded};
use super::parted::system;
use super::places::{Place, free, has_value, points_near, vanishes};
use super::{Extended, roots};
use crate::function::{Function, Literal, Side};
use crate::symbolic::{Extension, Symbolic};
use arithmetic::{Dual, Field, Rational, Ring, random, simplest_between};
use nalgebra::{DMatrix, DVector};
use num_traits::ToPrimitive;
use rand_chacha::rand_core::Rng;

/// Values of this size may be zero.
const NEAR: f64 = 1e-8;
/// Points from which zeros are looked for.
const STARTS: usize = 12;
/// More variables are not looked at.
const MOST_FREE: usize = 8;

/// A point of the domain at which the function of a literal is 0, which is proved; `None` where none was found.
pub(super) fn zero<F: Function>(literal: &Literal<F>, domain: &[Side]) -> Option<Vec<Place>> {
    let free = free(domain);
    if free.is_empty() || free.len() > MOST_FREE || domain.iter().any(|side| side.integer || side.is_empty()) {
        return None;
    }
    let search = Search { literal, domain, ends: domain.iter().map(Side::floats).collect(), free };
    search.starts().into_iter().find_map(|start| search.from(start)).or_else(|| search.root())
}

/// A float at a share between 0 and 1 of a side, or of a part of it that is bounded.
pub(super) fn at_share(side: &Side, share: f64) -> f64 {
    match side.floats() {
        (lo, hi) if (hi - lo).is_finite() => lo + (hi - lo) * share,
        (lo, hi) => (side.middle().to_f64().unwrap_or(0.0) + 6.0 * (share - 0.5)).clamp(lo, hi),
    }
}

struct Search<'a, F> {
    literal: &'a Literal<F>,
    domain: &'a [Side],
    ends: Vec<(f64, f64)>,
    free: Vec<usize>,
}

/// A point as it is looked at: floats, and the numbers of those variables that are held.
type Held = Vec<Option<Rational>>;

impl<F: Function> Search<'_, F> {
    fn starts(&self) -> Vec<Vec<f64>> {
        let mut stream = random::generator("inequality", "zeros", self.domain.len() as u64);
        let mut share = || (stream.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        let mut start = |round: usize| -> Vec<f64> {
            let one = |side: &Side| {
                let share = share();
                if round == 0 { side.middle().to_f64().unwrap_or(0.0) } else { at_share(side, share) }
            };
            self.domain.iter().map(one).collect()
        };
        (0..STARTS).map(&mut start).collect()
    }

    /// A zero to which Newton's method leads from here.
    fn from(&self, mut x: Vec<f64>) -> Option<Vec<Place>> {
        let own = |x: &[f64]| self.literal.function.value(x).is_ok_and(|value| value.abs() <= NEAR);
        let Some(jacobian) = self.solve(&mut x, &self.free) else {
            // Without parts that vanish: where the function itself is least.
            polish(&self.literal.function, &mut x, &self.ends);
            return own(&x).then(|| self.in_closed_form(&x)).flatten();
        };
        let mut least = x.clone();
        polish(&self.literal.function, &mut least, &self.ends);
        if let Some(found) = own(&least).then(|| self.in_closed_form(&least)).flatten() {
            return Some(found);
        }
        let moving = pivots(jacobian)?;
        let moving: Vec<usize> = moving.into_iter().map(|k| self.free[k]).collect();
        // Simple numbers for those variables that the others can follow.
        for reach in [1e-1, 1e-3, 1e-6, 0.0] {
            let mut at = x.clone();
            let Some(held) = self.held(&mut at, &moving, reach) else { continue };
            if self.solve(&mut at, &moving).is_none() {
                continue;
            }
            let found = self.in_closed_form(&at).or_else(|| self.enclosed(&at, &held, &moving));
            if found.is_some() || moving.len() == self.free.len() {
                return found;
            }
        }
        None
    }

    /// The numbers of those variables that do not move, also put into the point.
    fn held(&self, x: &mut [f64], moving: &[usize], reach: f64) -> Option<Held> {
        let mut held = vec![None; x.len()];
        for k in (0..x.len()).filter(|k| !moving.contains(k)) {
            let exact = Rational::from_float(x[k])?;
            let size = Rational::from_float(reach * x[k].abs().max(1.0))?;
            let simple = self.domain[k].nearest(simplest_between(&(&exact - &size), &(exact + size)));
            x[k] = simple.to_f64()?;
            held[k] = Some(simple);
        }
        Some(held)
    }

    /// The derivatives of the parts in some variables, one row for each part.
    fn jacobian(&self, x: &[f64], moving: &[usize]) -> Option<DMatrix<f64>> {
        let column = |k: &usize| {
            let parts = system(&self.literal.function, &seeded(x, *k), x)?;
            Some(DVector::from_iterator(parts.len(), parts.iter().map(|part| part.derivative)))
        };
        let columns: Vec<DVector<f64>> = moving.iter().map(column).collect::<Option<_>>()?;
        let finite = columns.iter().flat_map(|column| column.iter()).all(|x| x.is_finite());
        (finite && !columns.first()?.is_empty()).then(|| DMatrix::from_columns(&columns))
    }

    /// Newton's method, with the shortest step, to where all parts are 0 in floats; their derivatives there.
    fn solve(&self, x: &mut [f64], moving: &[usize]) -> Option<DMatrix<f64>> {
        const STEPS: usize = 60;
        const FLAT: f64 = 1e-12;
        for _ in 0..STEPS {
            let jacobian = self.jacobian(x, moving)?;
            let values = DVector::from_vec(system(&self.literal.function, x, x)?);
            let inverse = jacobian.pseudo_inverse(FLAT).ok()?;
            let step = inverse * values;
            let mut moved = 0.0f64;
            for (&k, change) in moving.iter().zip(step.iter()) {
                let next = (x[k] - change).clamp(self.ends[k].0, self.ends[k].1);
                moved = moved.max((next - x[k]).abs() / x[k].abs().max(1.0));
                x[k] = next;
            }
            if !moved.is_finite() {
                return None;
            }
            if moved <= 1e-15 {
                break;
            }
        }
        let is_zero = system(&self.literal.function, x, x)?.iter().all(|part| part.abs() <= 1e-2 * NEAR);
        if is_zero { self.jacobian(x, moving) } else { None }
    }

    fn in_closed_form(&self, x: &[f64]) -> Option<Vec<Place>> {
        let function = &self.literal.function;
        points_near(function, x, self.domain).find(|places| vanishes(function, places))
    }

    /// A zero of as many parts as there are variables that move, in a box around a point.
    fn enclosed(&self, x: &[f64], held: &Held, moving: &[usize]) -> Option<Vec<Place>> {
        const REACHES: [f64; 4] = [1e-12, 1e-10, 1e-8, 1e-6];
        let inverse = self.jacobian(x, moving).filter(DMatrix::is_square)?.try_inverse()?;
        REACHES.iter().find_map(|reach| self.in_box(x, held, moving, &inverse, *reach))
    }

    /// Krawczyk's operator on a box of this reach.
    fn in_box(
        &self,
        x: &[f64],
        held: &Held,
        moving: &[usize],
        inverse: &DMatrix<f64>,
        reach: f64,
    ) -> Option<Vec<Place>> {
        let known = |k: usize| held[k].as_ref().map_or_else(|| Extended::between(x[k], x[k]), Extended::of);
        let middle: Vec<Extended> = (0..x.len()).map(known).collect();
        let boxed = around(x, &middle, self.domain, moving, reach)?;
        let values = system(&self.literal.function, &middle, x)?;
        let columns: Vec<Vec<Extended>> = moving.iter().map(|k| self.slopes(&boxed, *k, x)).collect::<Option<_>>()?;
        let narrow = krawczyk(&middle, &boxed, moving, inverse, &values, &columns)?;
        let place = |(own, held): (&Extended, &Option<Rational>)| match held {
            Some(q) => Some(Place::of(q.clone())),
            None => Some(Place::between(Rational::from_float(own.lo)?, Rational::from_float(own.hi)?)),
        };
        let places: Vec<Place> = narrow.iter().zip(held).map(place).collect::<Option<_>>()?;
        has_value(&self.literal.function, &places).then_some(places)
    }

    /// The derivatives of the parts in one variable on a box, where they are smooth there.
    fn slopes(&self, boxed: &[Extended], k: usize, guide: &[f64]) -> Option<Vec<Extended>> {
        let parts = system(&self.literal.function, &seeded(boxed, k), guide)?;
        let smooth = |part: &Dual<Extended>| part.value.defined && !part.value.is_empty() && is_known(&part.derivative);
        parts.iter().all(smooth).then(|| parts.iter().map(|part| part.derivative).collect())
    }

    /// In one number: a root of a polynomial.
    fn root(&self) -> Option<Vec<Place>> {
        let [free] = self.free[..] else { return None };
        let extension = Extension::new(self.domain.len());
        let known = |(x, side): (Symbolic, &Side)| side.as_point().map_or_else(|| x.clone(), |q| x.rational(q));
        let arguments: Vec<Symbolic> = extension.arguments().into_iter().zip(self.domain).map(known).collect();
        let (polynomial, divisors) = self.literal.function.value(&arguments).ok()?.parts();
        let place = divisors.is_empty().then(|| roots::one_in(&polynomial, free, &self.domain[free])).flatten()?;
        let point: Vec<Rational> = self.domain.iter().map(Side::middle).collect();
        let places = place.on_line(&point, free);
        has_value(&self.literal.function, &places).then_some(places)
    }
}

/// A box around a point in the directions that move, if it lies in the domain.
fn around(x: &[f64], middle: &[Extended], domain: &[Side], moving: &[usize], reach: f64) -> Option<Vec<Extended>> {
    let mut boxed = middle.to_vec();
    for &k in moving {
        let reach = reach * x[k].abs().max(1.0);
        boxed[k] = Extended::between(x[k] - reach, x[k] + reach);
        let inside = |end: f64| Rational::from_float(end).is_some_and(|q| domain[k].contains(&q));
        if !(inside(boxed[k].lo) && inside(boxed[k].hi)) {
            return None;
        }
    }
    Some(boxed)
}

/// Where in a box a system of as many equations as there are numbers that move has its only zero: by Krawczyk's operator, if that maps the box into its inside.
/// `columns` are derivatives on the box, one list for each number that moves, `values` those of the equations at its middle.
fn krawczyk(
    middle: &[Extended],
    boxed: &[Extended],
    moving: &[usize],
    inverse: &DMatrix<f64>,
    values: &[Extended],
    columns: &[Vec<Extended>],
) -> Option<Vec<Extended>> {
    let n = moving.len();
    let mut narrow = middle.to_vec();
    for (i, &k) in moving.iter().enumerate() {
        let row = |j: usize| Extended::between(inverse[(i, j)], inverse[(i, j)]);
        let newton = (0..n).fold(middle[k], |sum, j| sum - row(j) * values[j]);
        let image = (0..n).fold(newton, |sum, l| {
            let one = middle[k].integer(i64::from(l == i));
            let rest = (0..n).fold(one, |rest, j| rest - row(j) * columns[l][j]);
            sum + rest * (boxed[moving[l]] - middle[moving[l]])
        });
        if !(image.defined && boxed[k].lo < image.lo && image.hi < boxed[k].hi) {
            return None;
        }
        narrow[k] = image;
    }
    Some(narrow)
}

/// The only point in a small box around one of floats at which a function is least: an enclosure of its value there. The slopes vanish at one point of the box, and
/// the second derivatives are positive definite on it.
pub(super) fn least<F: Function>(function: &F, x: &[f64], domain: &[Side]) -> Option<Extended> {
    const REACHES: [f64; 3] = [1e-10, 1e-8, 1e-6];
    let free = free(domain);
    if free.is_empty() || free.len() > MOST_FREE || free.iter().any(|&k| domain[k].integer) {
        return None;
    }
    let middle: Vec<Extended> =
        x.iter().zip(domain).map(|(x, side)| side.as_point().map_or(Extended::between(*x, *x), Extended::of)).collect();
    let values: Vec<Extended> = free.iter().map(|&k| slope(function, &middle, k)).collect::<Option<_>>()?;
    REACHES.iter().find_map(|reach| {
        let boxed = around(x, &middle, domain, &free, *reach)?;
        let second =
            |i: usize| free.iter().map(|&j| curvature(function, &boxed, free[i], j)).collect::<Option<Vec<_>>>();
        let columns: Vec<Vec<Extended>> = (0..free.len()).map(second).collect::<Option<_>>()?;
        let centre = DMatrix::from_fn(free.len(), free.len(), |i, j| columns[j][i].lo / 2.0 + columns[j][i].hi / 2.0);
        let narrow = krawczyk(&middle, &boxed, &free, &centre.try_inverse()?, &values, &columns)?;
        let value = function.value(&narrow).ok().filter(|value| value.defined && !value.is_empty())?;
        is_positive_definite(columns).then_some(value)
    })
}

fn slope<F: Function>(function: &F, at: &[Extended], k: usize) -> Option<Extended> {
    function.value(&seeded(at, k)).ok().map(|value| value.derivative).filter(is_known)
}

/// A second derivative on a box.
fn curvature<F: Function>(function: &F, boxed: &[Extended], i: usize, j: usize) -> Option<Extended> {
    let value = function.value(&seeded(&seeded(boxed, i), j)).ok().filter(|value| value.value.value.defined)?;
    Some(value.derivative.derivative).filter(is_known)
}

fn is_known(x: &Extended) -> bool {
    x.defined && x.lo.is_finite() && x.hi.is_finite()
}

/// The columns of the largest pivots of a matrix, one for each row; `None` where its rows are dependent, or nearly so, or too many.
fn pivots(mut matrix: DMatrix<f64>) -> Option<Vec<usize>> {
    const FLAT: f64 = 1e-9;
    let (rows, columns) = matrix.shape();
    let size = matrix.amax();
    let mut found: Vec<usize> = Vec::new();
    for step in 0..rows {
        let left = (step..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).filter(|(_, j)| !found.contains(j));
        let (i, j) = left.max_by(|a, b| matrix[*a].abs().total_cmp(&matrix[*b].abs()))?;
        if matrix[(i, j)].abs() <= FLAT * size {
            return None;
        }
        matrix.swap_rows(step, i);
        for i in step + 1..rows {
            let factor = matrix[(i, j)] / matrix[(step, j)];
            for l in 0..columns {
                matrix[(i, l)] -= factor * matrix[(step, l)];
            }
        }
        found.push(j);
    }
    found.sort_unstable();
    Some(found)
}
