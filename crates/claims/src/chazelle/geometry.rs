//! chazelle.eq3.15, chazelle.lem3.7 and chazelle.lem3.8: the geometry of flocking, and when edges are lost.
//!
//! The key is the virtual origin `E_i(t) = x_i(t) - t v_i(t)`: `E(1) = x(0)` and `E(t+1) = P(t) E(t) + (I - P(t))
//! x(t)`, whose last term is bounded and has stationary mean zero on a fixed network (notes/settling.md).

use super::sequences::{settled, show_start};
use super::switching::SwitchesVariant;
use crate::prelude::*;
use arithmetic::Signed;
use models::averaging::settle::Ending;
use models::averaging::{Flock, Hysteresis, Start, Weights, transition_matrix};
use num_bigint::BigInt;
use rand_chacha::rand_core::Rng;

const PRECISION: u32 = 128;

/// `N(n) <= n^switch_exponent` for entries of at least `n^-a` and speeds up to `n^c` (beyond.chazelle.switches).
pub fn switch_exponent(n: u64, a: u64, c: u64) -> u64 {
    (SwitchesVariant::QUADRATIC.exponent)(n, a, c)
}

/// No edge is lost after `n^(n^4 + loss_exponent)`, for Euclidean speeds and coordinates of `x(0)` up to `n^c` in dimension up to `n²`.
pub fn loss_exponent(n: u64, a: u64, c: u64) -> u64 {
    switch_exponent(n, a, c) + 2 * a + c + 11
}

fn dot(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn minus(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    a.iter().zip(b).map(|(x, y)| x - y).collect()
}

/// The angle between `(a, 1)` and `(b, 1)`, or between `a` and `b`, and the distance of `a` and `b`.
fn angle_and_distance(a: &[Rational], b: &[Rational], lifted: bool) -> Result<(Interval, Interval), CheckError> {
    let enclose = |q: &Rational| Interval::from_rational(q, PRECISION);
    let one = rational(i64::from(lifted), 1);
    let cosine = &one + dot(a, b);
    let squared_sine = (&one + dot(a, a)) * (&one + dot(b, b)) - cosine.square();
    let difference = minus(a, b);
    let distance = enclose(&dot(&difference, &difference)).sqrt()?;
    let sine = enclose(&squared_sine).sqrt()?;
    let angle = if cosine > one.zero() {
        sine.over(&enclose(&cosine))?.atan()?
    } else {
        sine.pi() * sine.ratio(1, 2) + enclose(&-cosine).over(&sine)?.atan()?
    };
    Ok((angle, distance))
}

/// `1/(1 + R^power) <= angle/distance^of <= 1`, where `R` bounds both vectors.
#[derive(Clone, Copy)]
pub struct AngleVariant {
    power: u64,
    of: u64,
    /// The angle is that of the lifted vectors.
    lifted: bool,
}

impl AngleVariant {
    fn fails_at(&self, a: &[Rational], b: &[Rational]) -> Result<Option<String>, CheckError> {
        let (angle, distance) = angle_and_distance(a, b, self.lifted)?;
        let reach = Interval::from_rational(&dot(a, a).max(dot(b, b)), PRECISION).sqrt()?;
        let ratio = angle.over(&distance.power(self.of))?;
        let lower = (reach.one() + reach.power(self.power)).recip()?;
        // Both bounds are approached, so that they are decided up to 2^-64 of the quotient.
        let slack = ratio.scaled(-64);
        let above = !at_most(&ratio, &(ratio.one() + &slack))?;
        let below = !at_most(&lower, &(ratio.clone() + slack))?;
        let side = if above { "above 1" } else { "below the lower bound" };
        let what = || format!("w = ({}), v = ({}): the quotient {:.6} is {side}", list(a), list(b), ratio.to_f64());
        Ok((above || below).then(what))
    }
}

pub fn quotient_of_angle() -> Record<AngleVariant> {
    Record::new(
        "chazelle.eq3.15",
        "(v, 1) and (w, 1) lie in a plane that touches the unit sphere. Projection to the sphere maps the segment \
         between them to an arc of the length of the angle, and shrinks lengths at distance r from the point of \
         contact by a factor between 1/(1 + r²) and 1. So 1/(1 + R²) <= angle/|v - w| <= 1, with R the larger of |v| \
         and |w|, and R <= n^O(1) because w is the mean of velocities plus x_i(0)/t. Both constants are best \
         (notes/settling.md).",
        AngleVariant { power: 2, of: 1, lifted: true },
        check_quotient,
    )
    .clauses(&[
        "If v_i(t) != w = x_i(t)/t, then angle(x_i(t), v_i(t))/||v_i(t) - w||_2 = O(1).",
        "If v_i(t) != w = x_i(t)/t, then angle(x_i(t), v_i(t))/||v_i(t) - w||_2 > n^{-O(1)}.",
    ])
    .altered("the square of the distance", |v| v.of = 2)
    .altered("a lower bound of 1/(1 + R)", |v| v.power = 1)
    .altered("birds that are not lifted", |v| v.lifted = false)
}

fn check_quotient(variant: &AngleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    // Near the point of contact, and far from it in its direction.
    let line = |x: (i64, i64)| vec![rational(x.0, x.1)];
    let mut pairs = vec![
        (line((3, 1)), line((4, 1))),
        (line((1, 1000)), line((1, 500))),
        (line((100, 1)), line((10_001, 100))),
        (line((-1, 1)), line((1, 1))),
        (line((-50, 1)), line((50, 1))),
        (vec![rational(3, 1), rational(0, 1)], vec![rational(0, 1), rational(3, 1)]),
    ];
    for _ in 0..run.cases(400, 5000) {
        let dimension = 1 + random.next_u32() as usize % 3;
        let scale = [1, 16, 256][random.next_u32() as usize % 3];
        let mut point =
            || (0..dimension).map(|_| rational(i64::from(random.next_u32() % 2001) - 1000, scale)).collect();
        let pair: (Vec<Rational>, Vec<Rational>) = (point(), point());
        if pair.0 != pair.1 {
            pairs.push(pair);
        }
    }
    let detail = "enclosures for vectors in dimension 1 to 3, obtuse angles among them; up to 2^-64 of the quotient";
    let evidence = certified("1/(1 + R²) <= angle/distance <= 1", detail).on([1, 2]);
    Run::all([
        run.every(evidence, &pairs, |(w, v)| variant.fails_at(w, v)).checks("step 2"),
        argued(&[1, 2], "1/(1 + R²) <= angle/distance <= 1, and R <= n^O(1)", "notes/settling.md, (3.15), steps 1-3"),
    ])
}

/// What the angle between `x_i(t)` and `v_i(t)` is compared with.
#[derive(Clone, Copy)]
pub struct OriginVariant {
    /// The share of `(I - P) x` in the recursion of the origins.
    coupling: (i64, i64),
    /// The angle is at most this share of `|v - x/t|`.
    share: (i64, i64),
    /// It is the angle of the lifted vectors, `(x, t)` and `(v, 1)`.
    lifted: bool,
    /// `|E(t)| <= |x(0)| + steps (switches + 1) 4 H` with `H = n^h`.
    steps: i64,
    h: fn(u64) -> u32,
    /// `|v - x/t| <= |E| (log2 t)^logarithm / t^power`.
    power: i32,
    logarithm: u32,
}

impl OriginVariant {
    /// (log t/t) n^O(n³), as printed.
    pub const PRINTED: Self = OriginVariant {
        coupling: (1, 1),
        share: (1, 1),
        lifted: true,
        steps: 1,
        h: |a| 2 * a as u32 + 3,
        power: 1,
        logarithm: 1,
    };
    /// Without the logarithm.
    pub const SHARPER: Self = OriginVariant { logarithm: 0, ..Self::PRINTED };
}

/// A statement about the angle with its controls.
pub fn about_origins(id: &'static str, derivation: &'static str, printed: OriginVariant) -> Record<OriginVariant> {
    // The printed bound names no constants.
    let examine = |variant: &OriginVariant, run: &mut Run| {
        let computed = origins_of_flocks(variant, run);
        if variant.logarithm == 0 {
            return Run::all([computed.on([1, 2]), argued(&[1, 2], IN_GENERAL, ORIGINS)]);
        }
        argued_with(&[], IN_GENERAL, ORIGINS, [computed])
    };
    Record::new(id, derivation, printed, examine)
        .altered("half of (I - P) x in the recursion", |v| v.coupling = (1, 2))
        .altered("1/t² instead of 1/t", |v| v.power = 2)
        .altered("the virtual origins stay within max|x(0)|", |v| v.steps = 0)
        .altered("half of |v - x/t|", |v| v.share = (1, 2))
        .altered("the angle in R^d, without the lifting", |v| v.lifted = false)
}

const IN_GENERAL: &str = "the angle and the virtual origins at all times, for all flocks of model D whose weights change only when the network does";
const ORIGINS: &str = "notes/settling.md, Virtual origins, steps 1-4, with (3.15) and Mixing on a fixed network";

/// The recursion of the virtual origins and the bound of the angle that follows from it.
fn origins_of_flocks(variant: &OriginVariant, run: &Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    // One bird, the four birds of the paper without hysteresis (they switch forever), random flocks.
    let single = Start::on_the_line(vec![rational(5, 1)], vec![rational(0, 1)], Weights::Lazy, Hysteresis::Paper);
    // In the plane, passing the origin at a distance.
    let passing = Start {
        positions: vec![vec![rational(1, 1), rational(0, 1)]],
        velocities: vec![vec![rational(0, 1), rational(1, 100)]],
        ..single.clone()
    };
    let mut starts = vec![passing, single, Start::four_birds(Hysteresis::None), Start::four_birds(Hysteresis::Paper)];
    starts.extend(
        (0..run.cases(60, 600))
            .map(|k| Start::random(if k % 2 == 0 { Hysteresis::Paper } else { Hysteresis::None }, &mut random)),
    );
    let evidence = fuzzed(
        "the recursion of the virtual origins, their bound, and the angle",
        "exact flocks of 1 to 5 birds in dimension 1 to 3 for t = 2, ..., 20, the four birds of the paper with and \
         without hysteresis; the angle enclosed at t = 20",
    );
    run.every(evidence, &starts, |start| follow(variant, start))
        .checks("step 1, the bound of step 3, the angle of step 4")
}

fn follow(variant: &OriginVariant, start: &Start) -> Result<Option<String>, CheckError> {
    const UNTIL: u32 = 20;
    let mut flock = Flock::new(start)?;
    let n = flock.birds() as u64;
    let largest = |rows: &[Vec<Rational>]| rows.iter().flatten().map(num_traits::Signed::abs).max();
    let first = largest(&start.positions).unwrap_or_else(|| rational(0, 1));
    let h = rational(n as i64, 1).pow((variant.h)(if *flock.weights() == Weights::Vicsek { 1 } else { 2 }) as i32);
    let mut before = flock.positions();
    let mut switches = i64::from(flock.step()?.is_some());
    let mut now = flock.virtual_origins(&before);
    for t in 2..=UNTIL {
        before = flock.positions();
        let p = transition_matrix(flock.network(), flock.weights())?;
        let switched = flock.step()?.is_some();
        let next = flock.virtual_origins(&before);
        let q = rational(variant.coupling.0, variant.coupling.1);
        for k in 0..flock.dimension() {
            let column = |rows: &[Vec<Rational>]| -> Vec<Rational> { rows.iter().map(|row| row[k].clone()).collect() };
            let (averaged, x) = (p.apply(&column(&now))?, column(&before));
            let pulled = p.apply(&x)?;
            let expected = averaged.iter().zip(x.iter().zip(&pulled)).map(|(e, (x, px))| e + (x - px) * &q);
            if expected.ne(column(&next)) {
                return Ok(Some(format!(
                    "{}: the origins at t = {t} are not those of the recursion",
                    show_start(start)
                )));
            }
        }
        now = next;
        // The printed bound, on |v - x/t| = |E|/t per coordinate, which is at least the angle over sqrt(d).
        let time = rational(i64::from(t), 1);
        let bound = &first + &h * rational(4 * variant.steps * (switches + 1), 1);
        let logarithm = rational(i64::from(t.ilog2()), 1).pow(variant.logarithm as i32);
        let size = largest(&now).unwrap_or_else(|| rational(0, 1)) / &time;
        if size > bound * logarithm / time.pow(variant.power) {
            return Ok(Some(format!("{} at t = {t}: |v - x/t| reaches {size}", show_start(start))));
        }
        // Switches before t: the one at t does not count yet.
        switches += i64::from(switched);
    }
    let time = Rational::from_integer(flock.time().clone());
    for (x, old) in flock.positions().iter().zip(&before) {
        let (v, w) = (minus(x, old), x.iter().map(|x| x / &time).collect::<Vec<_>>());
        if v == w {
            continue;
        }
        let (angle, distance) = angle_and_distance(&v, &w, variant.lifted)?;
        let (p, q) = variant.share;
        if (angle.clone() - angle.ratio(p, q) * distance).is_certainly_positive() {
            return Ok(Some(format!("{} at t = {time}: the angle is {:.6}", show_start(start), angle.to_f64())));
        }
    }
    Ok(None)
}

pub fn angle_decays() -> Record<OriginVariant> {
    about_origins(
        "chazelle.lem3.7",
        "With E_i(t) = x_i(t) - t v_i(t), the angle is at most |v_i - x_i/t| = |E_i|/t by (3.15). E(1) = x(0) and \
         E(t+1) = P(t) E(t) + (I - P(t)) x(t); (I - P) x is bounded by 2 because neighbours are near, and its \
         stationary mean is zero, so that on a fixed network E grows by at most 4 sum_r tau_1(P^r) <= 4 n^(2a+3) \
         altogether. N(n) + 1 networks give |E(t)| <= n^O(n³), even n^O(n²), at all t >= 1: no waiting time is \
         needed, nor the logarithm (beyond.chazelle.angle).",
        OriginVariant::PRINTED,
    )
    .reading(
        "\"=\" bounds from above; the birds are lifted into R^{d+1}, as for (3.15); n is large enough for Lemma 3.6, by which no edge \
         is longer than 2; weights change only when the network does, as model D has it.",
    )
}

/// After `n^time(n)` no edge is lost.
#[derive(Clone, Copy)]
pub struct LossVariant {
    /// The exponent.
    pub time: fn(u64) -> u64,
    /// The hysteresis rule, or none.
    pub hysteresis: bool,
    /// `v_i(t) - v_j(t) = (x_i(t-1) - x_j(t-1) - E_i(t) + E_j(t))/(t - earlier)`.
    pub earlier: i64,
}

/// A statement about lost edges with its controls.
pub fn about_losses(id: &'static str, derivation: &'static str, printed: LossVariant) -> Record<LossVariant> {
    Record::new(id, derivation, printed, examine_losses)
        .altered("after n^n", |v| v.time = |n| n)
        .altered("without hysteresis", |v| v.hysteresis = false)
        .altered("step 5 of the proof: with t in place of t - 1", |v| v.earlier = 0)
        .altered("step 6 of the proof: with the exponent n^4 + 2(n-1)² + 10(n-1)", |v| {
            v.time = |n| n.pow(4) + 2 * (n - 1).pow(2) + 10 * (n - 1)
        })
}

/// Decides from when on no edge is lost: the four birds, and the two computations of the proof.
fn examine_losses(variant: &LossVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let starts: Vec<Start> = (0..run.cases(30, 300)).map(|_| Start::random(Hysteresis::Paper, &mut random)).collect();
    let step_5 = fuzzed(
        "step 5: differences of velocities from virtual origins",
        "all pairs of birds of exact flocks of 2 to 5 birds in dimension 1 to 3, t = 2, ..., 8",
    );
    let sizes = (4..=64).flat_map(|n| [(n, 1), (n, 2)]);
    let step_6 =
        "exact integers from the bounds of steps 1 to 5, n = 4, ..., 64 and entries >= 1/n, 1/n² (vicsek, lazy)";
    Run::all([
        last_loss(variant, run).checks("the conclusion"),
        run.every(step_5, &starts, |start| variant.wrong_difference(start)),
        run.instances("step 6: the threshold is reached in time", step_6, sizes, |(n, a)| Ok(variant.too_late(n, a))),
        argued(
            &[],
            "no edge is lost after that time, for all flocks",
            "notes/settling.md, Virtual origins, steps 1-6, with Lemma 3.6(ii) and the bound of \
             beyond.chazelle.switches",
        ),
    ])
}

/// The four birds of the paper: when they lose an edge for the last time.
fn last_loss(variant: &LossVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let hysteresis = if variant.hysteresis { Hysteresis::Paper } else { Hysteresis::None };
    let (switches, end) = settled(&Start::four_birds(hysteresis), run)?;
    let last = switches.iter().rev().find(|s| !s.lost.is_empty()).map_or(BigInt::ZERO, |s| s.time.clone());
    run.value("four_birds_last_loss", last.to_string());
    let steady = matches!(end.ending, Ending::Steady);
    let late = last > BigInt::from(4).pow((variant.time)(4) as u32);
    let what = || match steady {
        true => format!("the four birds lose the edge 2-3 at t = {last}"),
        false => format!("the four birds: {}", end.why),
    };
    unless((!steady || late).then(what), exact("the four birds", format!("last loss at t = {last}, settled exactly")))
}

impl LossVariant {
    /// Where the difference of two velocities is not that of step 5.
    fn wrong_difference(&self, start: &Start) -> Result<Option<String>, CheckError> {
        let mut flock = Flock::new(start)?;
        flock.step()?;
        for t in 2..=8 {
            let before = flock.positions();
            flock.step()?;
            let (now, origins) = (flock.positions(), flock.virtual_origins(&before));
            for (i, j) in (0..flock.birds()).flat_map(|j| (0..j).map(move |i| (i, j))) {
                let left = minus(&minus(&now[i], &before[i]), &minus(&now[j], &before[j]));
                let right = minus(&minus(&before[i], &before[j]), &minus(&origins[i], &origins[j]));
                if right.iter().map(|x| x / rational(t - self.earlier, 1)).ne(left) {
                    return Ok(Some(format!("{} at t = {t}: birds {} and {}", show_start(start), i + 1, j + 1)));
                }
            }
        }
        Ok(None)
    }

    /// Step 6 for Euclidean speeds and coordinates of `x(0)` up to `n` in dimension up to `n²`, entries of at least `n^-a`: with
    /// `|E| <= n (n + 4 (N + 1) n^(2a+3))`, `n^(n^4) (2 + 2|E|)` is to be at most `n^time - 1`.
    fn too_late(&self, n: u64, a: u64) -> Option<String> {
        let power = |exponent: u64| BigInt::from(n).pow(exponent as u32);
        let origin = n * (n + 4 * (power(switch_exponent(n, a, 1)) + 1) * power(2 * a + 3));
        // Longer exponents than these two digits more than the left side has are not needed.
        let room = (self.time)(n).saturating_sub(n.pow(4)).min(loss_exponent(n, a, 1) + 2);
        (2 + 2 * origin + 1 > power(room)).then(|| {
            format!(
                "step 6 with n = {n}, a = {a}: n^(n^4) (2 + 2|E|) is not below n^{}, by the bounds of |E|",
                (self.time)(n)
            )
        })
    }
}

pub fn no_losses() -> Record<LossVariant> {
    about_losses(
        "chazelle.lem3.8",
        "For an edge of G_{t-1}, v_i(t) - v_j(t) = (x_i(t-1) - x_j(t-1) - E_i(t) + E_j(t))/(t-1), at most (2 + \
         2|E|)/(t-1). By Lemma 2.1 the edge stays once that is below eps = n^(-n^4): after n^(n^4 + K) with K = O(n²) \
         from |E| <= n^O(n²) (lem3.7). K <= n^4 for n >= 4 with n > a + c: weights with denominators up to n^a, speeds and absolute \
         coordinates of x(0) up to n^c, d <= n² (notes/settling.md). So n^(2n^4) is enough.",
        LossVariant { time: |n| 2 * n.pow(4), hysteresis: true, earlier: 1 },
    )
    .reading("n is large enough: n >= 4 and n > a + c, with weights of a log_2 n bits, Euclidean speeds and absolute coordinates of \
         x(0) up to n^c, in dimension d <= n^2 (n >= 4 for lazy or vicsek weights and c = 1); weights change only when the \
         network does, as model D has it.")
}
