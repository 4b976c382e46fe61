//! A set that no motion leaves: an ellipsoid of a quadratic Lyapunov function, found in floats, rounded, and proved by the inertia of two matrices.
//!
//! With `P > 0` and `A^T P + P A + alpha P <= 0` in every mode, `|x| = sqrt(x^T P x)` obeys `|x|' <= -alpha/2 |x| + beta`, where `beta` bounds `|drift + sum of
//! inputs|`: so `|x| <= max(|x(0)|, 2 beta / alpha)` for ever.

use crate::prepared::{Motion, Push};
use crate::scalar::Scalar;
use crate::system::Range;
use algebra::matrix::{inertia, solve_over_field};
use arithmetic::{Enclosure, Field, Interval, Number, Rational, rational};
use dense::faer::Mat;
use num_traits::{Signed, ToPrimitive, Zero};

/// Bits of the enclosures that prove.
const BITS: u32 = 240;

/// `x^T P x <= radius^2` at all times.
#[derive(Debug, Clone)]
pub(crate) struct Ellipsoid {
    /// `P`, by rows.
    form: Vec<Vec<Rational>>,
    radius: Interval,
}

/// The fastest growth of a matrix in floats: the largest real part of its eigenvalues.
pub(crate) fn abscissa(a: &[Vec<Rational>]) -> Option<f64> {
    let n = a.len();
    let float = Mat::from_fn(n, n, |i, j| a[i][j].to_f64().unwrap_or(f64::NAN));
    let eigen = dense::eigen(float.as_ref())?;
    eigen.values.iter().map(|value| value.re).reduce(f64::max)
}

/// A box that no motion of the modes leaves, however they are switched; none where no proof was found. States that do not move keep their range.
pub(crate) fn kept_box(motions: &[Motion], start: &[Range]) -> Option<Vec<Range>> {
    let moving: Vec<usize> = (0..start.len()).filter(|&i| !motions.iter().all(|motion| stands(motion, i))).collect();
    let reduced: Vec<Motion> = motions.iter().map(|motion| without(motion, &moving, start)).collect();
    let starts: Vec<Range> = moving.iter().map(|&i| start[i].clone()).collect();
    let mut all = start.to_vec();
    if moving.is_empty() {
        return Some(all);
    }
    let ellipsoid = Ellipsoid::find(&reduced, &starts)?;
    for (k, &i) in moving.iter().enumerate() {
        let reach = ellipsoid.reach(k)?;
        all[i] = Range { lo: -reach.clone(), hi: reach };
    }
    Some(all)
}

/// Whether a state never moves.
fn stands(motion: &Motion, i: usize) -> bool {
    motion.a[i].iter().all(Zero::is_zero)
        && motion.drift[i].is_zero()
        && motion.pushes.iter().all(|push| push.column[i].is_zero())
}

/// The motion of the states that move; those that do not are inputs within their range.
fn without(motion: &Motion, moving: &[usize], start: &[Range]) -> Motion {
    let pick = |column: &dyn Fn(usize) -> Rational| moving.iter().map(|&i| column(i)).collect::<Vec<Rational>>();
    let drift = pick(&|i| motion.drift[i].clone());
    let mut pushes: Vec<Push> = Vec::new();
    for push in &motion.pushes {
        pushes.push(Push { column: pick(&|i| push.column[i].clone()), ..push.clone() });
    }
    for j in (0..start.len()).filter(|j| !moving.contains(j)) {
        let column = pick(&|i| motion.a[i][j].clone());
        pushes.push(Push { input: usize::MAX, centre: start[j].centre(), radius: start[j].radius(), column });
    }
    let a = moving.iter().map(|&i| moving.iter().map(|&j| motion.a[i][j].clone()).collect()).collect();
    Motion { a, drift, pushes }
}

impl Ellipsoid {
    /// Tries the Lyapunov function of the mean of the modes, with ever slower decay.
    fn find(motions: &[Motion], start: &[Range]) -> Option<Self> {
        let n = start.len();
        let share = rational(1, motions.len() as i64);
        let mean = |i: usize, j: usize| motions.iter().map(|motion| motion.a[i][j].clone()).sum::<Rational>() * &share;
        let mean: Vec<Vec<Rational>> = (0..n).map(|i| (0..n).map(|j| mean(i, j)).collect()).collect();
        let growth = abscissa(&mean)?;
        if growth >= 0.0 {
            return None;
        }
        [0.9, 0.6, 0.3, 0.1, 0.01].into_iter().find_map(|part| {
            let shift = Rational::from_float(-growth * part)?;
            let form = lyapunov(&mean, -growth * part)?;
            let rate = shift * rational(2, 1);
            motions.iter().all(|motion| decays(&motion.a, &form, &rate)).then_some(())?;
            Ellipsoid::around(form, &rate, motions, start)
        })
    }

    fn around(form: Vec<Vec<Rational>>, rate: &Rational, motions: &[Motion], start: &[Range]) -> Option<Self> {
        let zero = Interval::from_rational(&Rational::ZERO, BITS);
        let norm = |x: &[Rational]| -> Option<Interval> {
            let square: Rational =
                form.iter().zip(x).map(|(row, y)| y * row.iter().zip(x).map(|(p, z)| p * z).sum::<Rational>()).sum();
            zero.rational(&square).sqrt().ok()
        };
        let centre: Vec<Rational> = start.iter().map(Range::centre).collect();
        let mut radius = norm(&centre)?;
        for (i, range) in start.iter().enumerate() {
            radius = radius + zero.rational(&(form[i][i].clone() * range.radius() * range.radius())).sqrt().ok()?;
        }
        for motion in motions {
            let mut drift = motion.drift.clone();
            for input in &motion.pushes {
                drift.iter_mut().zip(&input.column).for_each(|(sum, x)| *sum += &input.centre * x);
            }
            let mut push = norm(&drift)?;
            for input in &motion.pushes {
                push = push + norm(&input.column)? * zero.rational(&input.radius);
            }
            let kept = push.over(&zero.rational(&(rate * rational(1, 2)))).ok()?;
            radius = radius.joined(&kept);
        }
        Some(Ellipsoid { form, radius: radius.top() })
    }

    /// A bound of the absolute value of a state.
    fn reach(&self, i: usize) -> Option<Rational> {
        let zero = Interval::from_rational(&Rational::ZERO, BITS);
        let unit = |j: usize| zero.rational(&rational(i64::from(i == j), 1));
        let rows = self
            .form
            .iter()
            .enumerate()
            .map(|(j, row)| row.iter().map(|q| zero.rational(q)).chain([unit(j)]).collect());
        let solved = solve_over_field(rows.collect::<Vec<Vec<Interval>>>()).ok()?;
        let reach = solved.get(i)?.sqrt().ok()? * &self.radius;
        Some(reach.ends()?.1)
    }
}

/// Whether `P > 0` and `-(A^T P + P A + rate P) > 0`, proved by enclosures of their inertia.
fn decays(a: &[Vec<Rational>], form: &[Vec<Rational>], rate: &Rational) -> bool {
    let n = a.len();
    let zero = Interval::from_rational(&Rational::ZERO, BITS);
    let product = |i: usize, j: usize| (0..n).map(|k| &form[i][k] * &a[k][j]).sum::<Rational>();
    let change = |i: usize, j: usize| -(product(i, j) + product(j, i) + rate * &form[i][j]);
    let positive = |entry: &dyn Fn(usize, usize) -> Rational| {
        let rows: Vec<Vec<Interval>> = (0..n).map(|i| (0..=i).map(|j| zero.rational(&entry(i, j))).collect()).collect();
        inertia(&rows).is_ok_and(|found| found.positive == n)
    };
    positive(&|i, j| form[i][j].clone()) && positive(&change)
}

/// The solution of `(A + shift)^T P + P (A + shift) = -1` in floats, by doubling, rounded to a symmetric rational matrix.
fn lyapunov(a: &[Vec<Rational>], shift: f64) -> Option<Vec<Vec<Rational>>> {
    let n = a.len();
    let shifted = Mat::from_fn(n, n, |i, j| a[i][j].to_f64().unwrap_or(f64::NAN) + if i == j { shift } else { 0.0 });
    // Cayley: S = (q + A)(q - A)^-1 has its eigenvalues in the unit disc, and P = 2 q sum (S^T)^k (q - A)^-T (q - A)^-1 S^k.
    let size: f64 = (0..n).map(|i| (0..n).map(|j| shifted[(i, j)].abs()).sum::<f64>()).fold(0.0, f64::max);
    let scale = (size / 4.0).max(f64::MIN_POSITIVE);
    let plus = Mat::from_fn(n, n, |i, j| shifted[(i, j)] + if i == j { scale } else { 0.0 });
    let minus = Mat::from_fn(n, n, |i, j| if i == j { scale } else { 0.0 } - shifted[(i, j)]);
    let complex = Mat::from_fn(n, n, |i, j| dense::c64::new(minus[(i, j)], 0.0));
    let inverse = dense::complex_inverse(complex.as_ref());
    let inverse = Mat::from_fn(n, n, |i, j| inverse[(i, j)].re);
    let mut step = dense::product(plus.as_ref(), inverse.as_ref());
    let mut sum = dense::product(inverse.transpose(), inverse.as_ref());
    for _ in 0..40 {
        let moved = dense::product(step.transpose(), dense::product(sum.as_ref(), step.as_ref()).as_ref());
        sum += moved;
        step = dense::product(step.as_ref(), step.as_ref());
    }
    let largest = (0..n).map(|i| sum[(i, i)]).fold(0.0, f64::max);
    let entry = |i: usize, j: usize| {
        let x = (sum[(i.max(j), i.min(j))] / largest * (1u64 << 40) as f64).round();
        Rational::from_float(x).map(|x| x * rational(1, 1 << 40))
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// The sum of absolute values of a row.
pub(crate) fn size(row: &[Rational]) -> Rational {
    row.iter().map(|x| x.abs()).sum()
}
