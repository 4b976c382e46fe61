//! A set that no motion leaves: an ellipsoid of a quadratic Lyapunov function, found in floats, rounded, and proved by the inertia of two matrices.
//!
//! With `P > 0` and `A^T P + P A + alpha P <= 0` in every mode, `|x| = sqrt(x^T P x)` obeys `|x|' <= -alpha/2 |x| + beta`, where `beta` bounds `|drift + sum of
//! inputs|`: so `|x| <= max(|x(0)|, 2 beta / alpha)` for ever.

use crate::family::dyadic_near;
use crate::prepared::{Motion, Push};
use crate::system::Range;
use algebra::matrix::{inertia, solve_over_field};
use arithmetic::{Enclosure, Field, Interval, Number, Rational, rational};
use dense::faer::Mat;
use num_traits::{Signed, ToPrimitive};

/// Bits of the enclosures that prove.
const BITS: u32 = 240;

/// `x^T P x <= radius^2` at all times, for the states that move.
#[derive(Debug, Clone)]
pub(crate) struct Ellipsoid {
    /// Those states.
    pub moving: Vec<usize>,
    /// `P`, by rows.
    pub form: Vec<Vec<Rational>>,
    /// `A^T P + P A + rate P < 0` in every mode.
    pub rate: Rational,
    pub radius: Rational,
}

/// The fastest growth of a matrix in floats: the largest real part of its eigenvalues.
pub(crate) fn abscissa(a: &[Vec<Rational>]) -> Option<f64> {
    let n = a.len();
    let float = Mat::from_fn(n, n, |i, j| a[i][j].to_f64().unwrap_or(f64::NAN));
    let eigen = dense::eigen(float.as_ref())?;
    eigen.values.iter().map(|value| value.re).reduce(f64::max)
}

/// The same for the states of a mode that move.
pub(crate) fn moving_abscissa(motion: &Motion) -> Option<f64> {
    let moving: Vec<usize> = (0..motion.a.len()).filter(|&i| !motion.stands(i)).collect();
    let row = |&i: &usize| moving.iter().map(|&j| motion.a[i][j].clone()).collect();
    abscissa(&moving.iter().map(row).collect::<Vec<_>>())
}

/// A box that no motion of the modes leaves, however they are switched; none where no proof was found. States that do not move keep their range.
pub(crate) fn kept_box(motions: &[Motion], start: &[Range]) -> Option<Vec<Range>> {
    let ellipsoid = Ellipsoid::find(motions, start)?;
    let mut all = start.to_vec();
    for &i in &ellipsoid.moving {
        let unit: Vec<Rational> = (0..start.len()).map(|j| rational(i64::from(i == j), 1)).collect();
        let reach = ellipsoid.bound(&unit, start)?;
        all[i] = Range { lo: -reach.clone(), hi: reach };
    }
    Some(all)
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
    /// Tries the Lyapunov function of the mean of the modes, and the sum of those of all modes, with ever slower decay.
    pub fn find(motions: &[Motion], start: &[Range]) -> Option<Self> {
        let moving: Vec<usize> = (0..start.len()).filter(|&i| !motions.iter().all(|motion| motion.stands(i))).collect();
        let motions: Vec<Motion> = motions.iter().map(|motion| without(motion, &moving, start)).collect();
        let start: Vec<Range> = moving.iter().map(|&i| start[i].clone()).collect();
        let n = start.len();
        let share = rational(1, motions.len() as i64);
        let mean = |i: usize, j: usize| motions.iter().map(|motion| motion.a[i][j].clone()).sum::<Rational>() * &share;
        let mean: Vec<Vec<Rational>> = (0..n).map(|i| (0..n).map(|j| mean(i, j)).collect()).collect();
        let modes: Vec<&Vec<Vec<Rational>>> = motions.iter().map(|motion| &motion.a).collect();
        if n == 0 {
            return Some(Ellipsoid { moving, form: Vec::new(), rate: Rational::ONE, radius: Rational::ZERO });
        }
        [vec![&mean], modes].into_iter().find_map(|of| {
            let growth = of.iter().map(|a| abscissa(a)).try_fold(f64::NEG_INFINITY, |most, x| Some(x?.max(most)))?;
            (growth < 0.0).then_some(())?;
            [0.9, 0.6, 0.3, 0.1, 0.01].into_iter().find_map(|part| {
                let rate = Rational::from_float(-growth * part)? * rational(2, 1);
                let forms = of.iter().map(|a| lyapunov(a, -growth * part)).collect::<Option<Vec<_>>>()?;
                let sum = |i: usize, j: usize| forms.iter().map(|form| form[i][j].clone()).sum::<Rational>();
                let form: Vec<Vec<Rational>> = (0..n).map(|i| (0..n).map(|j| sum(i, j)).collect()).collect();
                motions.iter().all(|motion| decays(&motion.a, &form, &rate)).then_some(())?;
                let radius = radius(&form, &rate, &motions, &start)?;
                Some(Ellipsoid { moving: moving.clone(), form, rate, radius })
            })
        })
    }

    /// The solution `y` of `P y = row`, the row restricted to the states that move.
    pub fn solved<T: Field>(&self, row: &[Rational], scalar: impl Fn(&Rational) -> T) -> Option<Vec<T>> {
        let rows = self.moving.iter().zip(&self.form);
        let rows = rows.map(|(&i, form)| form.iter().chain([&row[i]]).map(&scalar).collect());
        solve_over_field(rows.collect::<Vec<Vec<T>>>()).ok()
    }

    /// A bound of a row: `radius sqrt(row P^-1 row)`, and the most of what does not move.
    pub fn bound(&self, row: &[Rational], start: &[Range]) -> Option<Rational> {
        let zero = Interval::from_rational(&Rational::ZERO, BITS);
        let solved = self.solved(row, |q| zero.rational(q))?;
        let square =
            solved.into_iter().zip(&self.moving).fold(zero.clone(), |sum, (y, &i)| sum + y * zero.rational(&row[i]));
        let mut bound = (square.sqrt().ok()? * zero.rational(&self.radius)).ends()?.1;
        for (i, range) in start.iter().enumerate().filter(|(i, _)| !self.moving.contains(i)) {
            bound += &row[i] * range.centre() + row[i].abs() * range.radius();
        }
        Some(bound)
    }
}

/// A size of the ellipsoid that holds the start and that no mode leads out of.
fn radius(form: &[Vec<Rational>], rate: &Rational, motions: &[Motion], start: &[Range]) -> Option<Rational> {
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
        radius = radius.joined(&push.over(&zero.rational(&(rate * rational(1, 2)))).ok()?);
    }
    // A little more, of few digits, for the checker, which rounds too.
    let most = radius.ends()?.1 + rational(1, 1 << 60);
    Some(dyadic_near(&(&most * rational((1 << 20) + 1, 1 << 20)), &(&most * rational(1, 1 << 22))))
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
