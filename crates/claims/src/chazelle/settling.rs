//! chazelle.eq3.18, chazelle.lem3.9, chazelle.lem3.10 and chazelle.thm1.1.time: when flocks that approach settle.

use super::lower_bound::{MIRRORED, PRINTED, groups};
use super::sequences::settled;
use super::switching;
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use models::averaging::settle::Ending;
use models::averaging::{Flock, Hysteresis, Separation, Start, Transients, Weights};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::Signed;
use rand_chacha::rand_core::Rng;

/// Two birds whose difference tends to a unit vector, on fixed networks with rational spectra.
struct TieCase {
    name: String,
    birds: usize,
    /// A common denominator of the transition matrices.
    denominator: BigInt,
    separation: Separation,
    /// `|x_i - x_j|² - 1` for s = 0, 1, .., by the transition matrices.
    excess: Vec<Rational>,
}

fn sides() -> Vec<(&'static str, Graph, Weights)> {
    let given = |p, q, n| Weights::Given(vec![rational(p, q); n]);
    vec![
        ("lazy pair", Graph::path(2), Weights::Lazy),
        ("pair with c_i = 1/3", Graph::path(2), given(1, 3, 2)),
        ("lazy path of 3", Graph::path(3), Weights::Lazy),
        ("lazy path of 4", Graph::path(4), Weights::Lazy),
        ("lazy star of 4", Graph::star(4), Weights::Lazy),
        ("vicsek triangle", Graph::complete(3), Weights::Vicsek),
        ("complete 4, c_i = 1/5", Graph::complete(4), given(1, 5, 4)),
    ]
}

/// Steps that are followed: enough for two steps for each modulus.
const STEPS: usize = 30;

/// Pairs of birds of all pairs of flocks, and of one flock, with random amplitudes of the modes.
fn tie_cases(run: &Run) -> Result<Vec<TieCase>, CheckError> {
    let mut random = run.random(7);
    let sides = sides();
    let mut cases = Vec::new();
    for (a, one) in sides.iter().enumerate() {
        for (b, two) in sides.iter().enumerate().take(a + 1) {
            run.checkpoint()?;
            let dimension = 1 + (a + b) % 2;
            let limit = if dimension == 1 { vec![rational(1, 1)] } else { vec![rational(3, 5), rational(-4, 5)] };
            let mut flock = |(name, graph, weights): &(&str, Graph, Weights)| -> Result<Transients, CheckError> {
                let amplitude = |_: usize| rational(i64::from(random.next_u32() % 13) - 6, 8);
                let mut amplitude = amplitude;
                Transients::new(graph, weights, |_| (0..dimension).map(&mut amplitude).collect())?
                    .ok_or_else(|| CheckError::Other(format!("{name}: irrational spectrum")))
            };
            let (p, q) = (flock(one)?, flock(two)?);
            let mut pick = |n: usize| random.next_u32() as usize % n;
            let (i, j) = (pick(p.p.rows()), pick(q.p.rows()));
            let birds = p.p.rows() + q.p.rows();
            let name = format!("{} and {}", one.0, two.0);
            cases.push(TieCase::new(name, birds, limit.clone(), (&p, i), (&q, j))?);
            // Where both are the same network also two birds of one flock.
            if a == b {
                let (birds, j) = (p.p.rows(), (i + 1) % p.p.rows());
                cases.push(TieCase::new(format!("two birds of the {}", one.0), birds, limit, (&p, i), (&p, j))?);
            }
        }
    }
    Ok(cases)
}

/// A flock and one of its birds.
type Bird<'a> = (&'a Transients, usize);

impl TieCase {
    fn new(name: String, birds: usize, limit: Vec<Rational>, i: Bird, j: Bird) -> Result<Self, CheckError> {
        let separation = Separation::new(limit, i, j);
        let excess = separation.excess(i, j, STEPS)?;
        let of = |p: &RationalMatrix| p.reduced().denominator().clone();
        Ok(TieCase { name, birds, denominator: of(&i.0.p).lcm(&of(&j.0.p)), separation, excess })
    }
}

/// What is altered in the expansion.
#[derive(Clone, Copy)]
pub struct ExpansionVariant {
    /// The sign `(-1)^t` of the second part.
    alternating: bool,
    /// Whether products of eigenvalues count.
    products: bool,
    /// From this `s = t - t_1` on.
    from: usize,
    /// An upper bound (strict) of the number of terms.
    most: fn(usize) -> usize,
}

pub fn distance_expansion() -> Record<ExpansionVariant> {
    Record::new(
        "chazelle.eq3.18",
        "Square (3.17) with B = 0 and |A| = 1 and collect equal moduli; a negative mu gives (-1)^(t - t_1), whose \
         constant sign (-1)^t_1 belongs to Upsilon^-. There are at most n - 1 values |mu_k| and n(n-1)/2 products, \
         fewer than n² (notes/settling.md).",
        ExpansionVariant { alternating: true, products: true, from: 1, most: |n| n * n },
        check_distance_expansion,
    )
    .reading(
        "t > t_1: at t = t_1 an eigenvalue 0 still contributes to the left side, but not to the right one, which has \
         nonzero values only.",
    )
    .clauses(&[
        "If B = 0 and ||A||_2 = 1, then ||x_i(t) - x_j(t)||_2^2 - 1 = sum_{k=1}^N Upsilon_k rho_k^{t-t_1} with \
         Upsilon_k = Upsilon_k^+ + (-1)^t Upsilon_k^- and 1 > rho_1 > ... > rho_N > 0 the distinct nonzero values \
         among |mu_k|, |mu_k mu_k'|.",
        "N < n^2.",
    ])
    .altered("without (-1)^t", |v| v.alternating = false)
    .altered("without products of eigenvalues", |v| v.products = false)
    .altered("at t = t_1 too", |v| v.from = 0)
    .altered("fewer than n terms", |v| v.most = |n| n)
}

fn check_distance_expansion(variant: &ExpansionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "pairs of birds of 7 networks with rational spectra, 0 and equal moduli among them, dimension 1 and \
                  2, 30 steps, against powers of P";
    let evidence = exact("the expansion for t > t_1, and fewer than n² terms", detail).on([1, 2]);
    Run::all([
        run.every(evidence, tie_cases(run)?, |case| Ok(variant.fails_at(&case))).checks("steps 1 and 2"),
        argued(&[1, 2], "both, for all flocks", "notes/settling.md, (3.18) and Lemma 3.10, steps 1-2"),
    ])
}

impl ExpansionVariant {
    fn fails_at(&self, case: &TieCase) -> Option<String> {
        let mut upsilons = case.separation.expansion();
        if !self.products {
            upsilons.retain(|rho, _| case.separation.terms.iter().any(|(mu, _)| mu.abs() == *rho));
        }
        if upsilons.len() >= (self.most)(case.birds) || upsilons.keys().any(|rho| *rho >= rational(1, 1)) {
            return Some(format!("{}: {} values of rho with {} birds", case.name, upsilons.len(), case.birds));
        }
        case.excess.iter().enumerate().skip(self.from).find_map(|(s, excess)| {
            let sign = rational(if self.alternating && s % 2 == 1 { -1 } else { 1 }, 1);
            let sum: Rational =
                upsilons.iter().map(|(rho, (plus, minus))| (plus + minus * &sign) * rho.pow(s as i32)).sum();
            (sum != *excess).then(|| format!("{}: at t - t_1 = {s} the sum is {sum}, not {excess}", case.name))
        })
    }
}

/// The three computations in the proof.
#[derive(Clone, Copy)]
pub struct GapsVariant {
    /// Step 3: `m^power rho_k²` is an integer, `m` the common denominator of `P`.
    power: u32,
    /// Step 5: the difference operator starts at this term.
    first: usize,
    /// Step 7: `|Upsilon_k| <= factor sum |Psi_k| + (sum |Psi_k|)²`, with sums of absolute coordinates.
    factor: i64,
}

pub fn gaps() -> Record<GapsVariant> {
    Record::new(
        "chazelle.lem3.10",
        "The squares of the rho are eigenvalues of (P (x) P)², which m^4 makes integral, m <= n^(an): distinct roots \
         of an integer polynomial of degree n² differ by at least 2^(-(5+4a) n^6) after division (Mahler, Mignotte). \
         A coefficient Upsilon_k lies in the field of its rho_k², of degree at most n²: a difference operator removes \
         the other terms, the rest is a nonzero algebraic number whose denominators and conjugates have t_1 n^O(1) \
         bits, so even 2^(-t_1 n^O(1)) < |Upsilon_k|. The upper bound sums at most 2n^2 products of n^O(1). The \
         bounds are for large n and cannot fail on small flocks; what is computed are the steps of the proof \
         (notes/settling.md).",
        GapsVariant { power: 4, first: 1, factor: 2 },
        check_gaps,
    )
    .reading("Upsilon_k for even or for odd t, where it is not zero.")
    .clauses(&[
        "For all k > 1, rho_k < (1 - 2^{-n^{O(1)}}) rho_1.",
        "For all k >= 1, 2^{-t_1 2^{n^{O(1)}}} < |Upsilon_k|.",
        "For all k >= 1, |Upsilon_k| = n^{O(1)}.",
    ])
    .altered("step 3 of the proof: with m^2 rho_k^2", |v| v.power = 2)
    .altered("step 5 of the proof: with the term at t_1", |v| v.first = 0)
    .altered("step 7 of the proof: without the terms that are linear in Psi", |v| v.factor = 0)
}

fn check_gaps(variant: &GapsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let cases = tie_cases(run)?;
    let (mut closest, mut smallest) = (rational(0, 1), rational(1, 1));
    for (_, upsilons) in
        cases.iter().flat_map(|case| [0, 1].map(|parity| (case, case.separation.coefficients(parity == 1))))
    {
        if let [.., second, first] = upsilons.as_slice() {
            closest = closest.max(&second.0 / &first.0);
        }
        smallest = upsilons.iter().map(|(_, upsilon)| upsilon.abs()).fold(smallest, Ord::min);
    }
    run.value("largest_ratio_seen", closest.to_string());
    run.value("smallest_coefficient_seen", smallest.to_string());
    let detail = "pairs of birds of 7 networks with rational spectra, even and odd steps";
    let steps = [
        run.instances("step 3: m^4 rho_k² is an algebraic integer", detail, &cases, |case| Ok(variant.step_3(case))),
        run.instances("step 5: a difference operator leaves one coefficient", detail, &cases, |case| {
            Ok([0, 1].into_iter().find_map(|parity| variant.step_5(case, parity)))
        }),
        run.instances("step 7: sums of products", detail, &cases, |case| Ok(variant.step_7(case))),
    ];
    let place = "notes/settling.md, (3.18) and Lemma 3.10, steps 3-7";
    argued_with(&[1, 2, 3], "the three bounds, for all n", place, steps)
}

impl GapsVariant {
    fn step_3(&self, case: &TieCase) -> Option<String> {
        let scale = Rational::from_integer(case.denominator.pow(self.power));
        let expansion = case.separation.expansion();
        let wrong = expansion.keys().find(|rho| !(rho.square() * &scale).is_integer())?;
        Some(format!("step 3, {}: rho = {wrong}, m = {}", case.name, case.denominator))
    }

    /// With `chi` the polynomial with the roots `rho_l²` and `chi/(x - rho_k²) = sum_l g_l x^l`, the sum of the
    /// `g_l f(l + first)` is `Upsilon_k rho_k^(parity + 2 first) sum_l g_l rho_k^(2l)`, `f` the excess on every
    /// second step.
    fn step_5(&self, case: &TieCase, parity: usize) -> Option<String> {
        let upsilons = case.separation.coefficients(parity == 1);
        let f: Vec<&Rational> = case.excess.iter().skip(parity).step_by(2).collect();
        upsilons.iter().find_map(|(rho, upsilon)| {
            // The coefficients of the product of the other x - rho_l², from the constant one on.
            let mut g = vec![rational(1, 1)];
            for (other, _) in upsilons.iter().filter(|(other, _)| other != rho) {
                let root = other.square();
                let mut next = vec![rational(0, 1); g.len() + 1];
                for (l, x) in g.iter().enumerate() {
                    next[l + 1] += x;
                    next[l] -= x * &root;
                }
                g = next;
            }
            let left: Rational = g.iter().zip(f.iter().skip(self.first)).map(|(g, f)| g * *f).sum();
            let value: Rational = g.iter().enumerate().map(|(l, g)| g * rho.pow(2 * l as i32)).sum();
            let right = upsilon * rho.pow((parity + 2 * self.first) as i32) * value;
            (left != right)
                .then(|| format!("step 5, {}, parity {parity}, rho = {rho}: {left} is not {right}", case.name))
        })
    }

    fn step_7(&self, case: &TieCase) -> Option<String> {
        let sum: Rational = case.separation.terms.iter().flat_map(|(_, psi)| psi).map(Signed::abs).sum();
        let bound = &sum * rational(self.factor, 1) + sum.square();
        let all = [0, 1].into_iter().flat_map(|parity| case.separation.coefficients(parity == 1));
        let (rho, upsilon) = all.into_iter().find(|(_, upsilon)| upsilon.abs() > bound)?;
        Some(format!("step 7, {}: the coefficient of rho = {rho} is {upsilon}, more than {bound}", case.name))
    }
}

/// Bounds of the time of the next contact after `t_1`, by their binary logarithms.
#[derive(Clone, Copy)]
pub struct ContactVariant {
    /// Distinct flocks: `log2 t <= distinct(t_1, n)`.
    distinct: fn(u64, u64) -> u64,
    /// One flock: `log2 (t/t_1) <= same(n)`.
    same: fn(u64) -> u64,
}

/// An integer above `log2 n`.
fn log2(n: u64) -> u64 {
    u64::from(u64::BITS - n.leading_zeros())
}

pub fn next_contact() -> Record<ContactVariant> {
    Record::new(
        "chazelle.lem3.9",
        "Distinct flocks with B != 0: B has the denominator of v(t_1+1) times that of pi, n^O(t_1 n), so |B| >= \
         n^-O(t_1 n), and |A + B s| > 1 + transients once s > n^O(t_1 n). B = 0, |A| != 1: ||A| - 1| >= n^-O(t_1 n), \
         and transients fall below that within t_1 n^O(1) steps. |A| = 1: the leading term of (3.18) decides after \
         t_1 2^(n^O(1)) steps (lem3.10). With t_1 > n^(2n^4) no edge is lost later, and t_1 2^(n^O(1)) = n^O(t_1 n) \
         for distinct flocks with B = 0 (notes/settling.md). `flock settle` decides by the same three cases.",
        ContactVariant { distinct: |t, n| t.saturating_mul(16 * n * log2(n)), same: |n| n.pow(4) },
        check_next_contact,
    )
    .clauses(&[
        "If G_t is invariant during [t_1, t-1], t_1 > n^{2n^4}, and two birds of distinct flocks at time t-1 are \
         adjacent in G_t, then t = n^{O(t_1 n)}.",
        "If G_t is invariant during [t_1, t-1], t_1 > n^{2n^4}, and two birds of the same flock are adjacent in G_t \
         but not in G_{t-1}, then t = t_1 2^{n^{O(1)}}.",
    ])
    .altered("distinct flocks within t_1 2^(n²)", |v| v.distinct = |t, n| log2(t) + n * n)
    .altered("the same flock within 2 t_1", |v| v.same = |_| 1)
}

fn check_next_contact(variant: &ContactVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let speed = rational(1, 512);
    let mut starts = vec![
        groups(&[MIRRORED, PRINTED], &speed, Hysteresis::Paper),
        groups(&[PRINTED, MIRRORED, MIRRORED, PRINTED], &speed, Hysteresis::Paper),
        groups(&[PRINTED], &rational(1, 4), Hysteresis::Paper),
        Start::four_birds(Hysteresis::Paper),
    ];
    let mut random = run.random(0);
    starts.extend((0..run.cases(40, 600)).map(|_| Start::random(Hysteresis::None, &mut random)));
    let detail = "flocks settled exactly, whatever t_1 is: every merger within n^(16 t_1 n), one of them after 10^84 \
                  steps, every other contact within t_1 2^(n^4)";
    let times = run
        .instances("the times of contacts", detail, &starts, |start| variant.fails_at(start, run))
        .checks("the conclusion");
    argued_with(&[1, 2], "both bounds, for all flocks", "notes/settling.md, Lemma 3.9, steps 1-5", [times])
}

impl ContactVariant {
    fn fails_at(&self, start: &Start, run: &Run) -> Result<Option<String>, CheckError> {
        let n = start.positions.len() as u64;
        let (switches, _) = settled(start, run)?;
        let mut network = Flock::new(start)?.network().clone();
        let mut before = BigInt::ZERO;
        for switch in switches {
            let t = u64::try_from(before).unwrap_or(u64::MAX).max(1);
            for (i, j) in &switch.gained {
                let merger = !network.components().iter().any(|f| f.contains(i) && f.contains(j));
                let late = if merger {
                    switch.time.bits() > (self.distinct)(t, n)
                } else {
                    switch.time > BigInt::from(t) << (self.same)(n)
                };
                if late {
                    let what = if merger { "two flocks meet" } else { "two birds of a flock meet" };
                    return Ok(Some(format!("{n} birds, the last switch at t_1 = {t}: {what} at t = {}", switch.time)));
                }
            }
            network = switch.applied_to(&network);
            before = switch.time;
        }
        Ok(None)
    }
}

/// A bound of the time to steady state, by the height of a tower of twos: the time is at most `2 ^^ height(n)`.
#[derive(Clone, Copy)]
pub struct TimeVariant {
    height: fn(u64) -> u64,
}

/// The least height of a tower of twos that is at least the number with this many bits (or fewer).
fn tower_height(bits: u128) -> u64 {
    // 2^^1 = 2, 2^^(h+1) = 2^(2^^h): bits <= 2^^h is enough for height h + 1.
    let (mut height, mut reach) = (1, 2u128);
    while reach < bits && height < 8 {
        reach = if reach >= 128 { u128::MAX } else { 1 << reach };
        height += 1;
    }
    height + 1
}

pub fn steady_state() -> Record<TimeVariant> {
    Record::new(
        "chazelle.thm1.1.time",
        "Model D: after n^(2n^4) no edge is lost (lem3.8). Of the at most n(n-1)/2 edges that are gained later, at \
         most n - 1 join distinct flocks, each within log2 t <= K t_1 n log2 n, and the others multiply the time by \
         2^(n^O(1)) (lem3.9). As K n log2 n <= t_1, a merger costs two levels of the tower: t <= 2^(t_1²) <= 2^(2^t_1), starting \
         from 2^(n^O(1)), which covers the factors of the others. So the network is steady before 2^^(2n + O(1)). \
         Model K: its positions are not rational, so the separation bounds of the proof do not apply, and the paper \
         adds \"an extra rule to simplify the proofs\" that it does not state.",
        TimeVariant { height: |n| 2 * n + 5 },
        check_steady_state,
    )
    .clauses(&[
        "In model D with K(t) = I, a group of n birds with O(log n)-bit inputs reaches steady state in at most \
         2^^O(n) steps.",
        "In model K with kappa = 0, a group of n birds with O(log n)-bit inputs reaches steady state in at most \
         2^^O(n) steps.",
    ])
    .altered("at most 65536 steps", |v| v.height = |_| 4)
    .altered("step 3 of the proof: with 2n + 3 levels", |v| v.height = |n| 2 * n + 3)
}

fn check_steady_state(variant: &TimeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let starts = [
        ("the four birds", Start::four_birds(Hysteresis::Paper)),
        ("eight birds, one group mirrored", groups(&[MIRRORED, PRINTED], &rational(1, 512), Hysteresis::Paper)),
    ];
    let flocks = "four birds steady from t = 322 on, eight from 10^84 on, settled exactly";
    let steps = [
        run.instances("flocks of model D", flocks, &starts, |(name, start)| {
            let (_, end) = settled(start, run)?;
            let late = tower_height(end.last_switch.bits().into()) > (variant.height)(start.positions.len() as u64);
            let wrong = late || !matches!(end.ending, Ending::Steady);
            Ok(wrong.then(|| format!("{name}: steady from t = {} on", end.last_switch)))
        })
        .checks("the conclusion"),
        // The start and two levels for each merger: from 2^(n^12) on, the factors 2^(n^O(1)) of the joins within
        // flocks are covered by T² in place of T.
        run.instances("step 3: heights of towers", "model D, n = 2, ..., 64", 2..=64, |n: u64| {
            let start_bits = u128::from(n).pow(12);
            let height = tower_height(start_bits) + 2 * (n - 1);
            let wrong = height > (variant.height)(n) || start_bits < u128::from(2 * n.pow(4) * log2(n));
            Ok(wrong.then(|| format!("step 3 with n = {n}: two levels for each merger make {height}")))
        }),
    ];
    let place = "notes/settling.md, Theorem 1.1, the time, steps 1-3, from lem3.8 and lem3.9";
    Ok(match argued_with(&[1], "model D, all n", place, steps)? {
        Outcome::Holds(evidence) => Outcome::NotCheckable(switching::MODEL_K.to_string(), evidence),
        other => other,
    })
}
