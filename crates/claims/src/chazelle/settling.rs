//! chazelle.eq3.18, chazelle.lem3.9, chazelle.lem3.10 and chazelle.thm1.1.time: when flocks that approach settle.

use super::lower_bound::{MIRRORED, PRINTED, groups};
use super::sequences::{four_birds, settled};
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::{Rational, Ring, rational};
use ledger::{CheckError, Evidence, Grade, Outcome, Record, Run};
use models::averaging::settle::Ending;
use models::averaging::{Hysteresis, Weights, rational_modes, transition_matrix};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;
use std::collections::BTreeMap;

/// Two birds whose difference tends to a unit vector, on fixed networks with rational spectra:
/// `x_i - x_j = A - sum_k Psi_k mu_k^s`.
struct TieCase {
    name: String,
    birds: usize,
    limit: Vec<Rational>,
    /// `(mu_k, Psi_k)`.
    terms: Vec<(Rational, Vec<Rational>)>,
    /// `|x_i - x_j|² - 1` for s = 0, 1, .., by the transition matrices.
    excess: Vec<Rational>,
}

/// One flock: its network, its weights and the bird that is looked at.
struct Side {
    name: &'static str,
    graph: Graph,
    weights: Weights,
}

fn sides() -> Vec<Side> {
    let star = |n| Graph::from_fn(n, |i, _| i == 0);
    let complete = |n| Graph::from_fn(n, |_, _| true);
    let given = |p, q, n| Weights::Given(vec![rational(p, q); n]);
    vec![
        Side { name: "lazy pair", graph: Graph::path(2), weights: Weights::Lazy },
        Side { name: "pair with c_i = 1/3", graph: Graph::path(2), weights: given(1, 3, 2) },
        Side { name: "lazy path of 3", graph: Graph::path(3), weights: Weights::Lazy },
        Side { name: "lazy path of 4", graph: Graph::path(4), weights: Weights::Lazy },
        Side { name: "lazy star of 4", graph: star(4), weights: Weights::Lazy },
        Side { name: "vicsek triangle", graph: complete(3), weights: Weights::Vicsek },
        Side { name: "complete 4, c_i = 1/5", graph: complete(4), weights: given(1, 5, 4) },
    ]
}

const STEPS: usize = 14;

/// The motion `A_i - sum` of every bird of one flock in every coordinate: random amplitudes of the modes k > 1.
struct Swarm {
    p: RationalMatrix,
    /// `(lambda_k, Phi_k/(1 - lambda_k))` by bird and coordinate.
    transients: Vec<(Rational, Vec<Vec<Rational>>)>,
}

impl Swarm {
    fn new(side: &Side, dimension: usize, random: &mut ChaCha8Rng) -> Result<Self, CheckError> {
        let p = transition_matrix(&side.graph, &side.weights)?;
        let c = side.weights.all(&side.graph)?;
        let modes =
            rational_modes(&p, &c)?.ok_or_else(|| CheckError::Other(format!("{}: irrational spectrum", side.name)))?;
        let transients = modes.into_iter().skip(1).map(|mode| {
            let amplitudes: Vec<Rational> =
                (0..dimension).map(|_| rational(i64::from(random.next_u32() % 13) - 6, 8)).collect();
            let rows = mode.right.iter().map(|r| amplitudes.iter().map(|a| r * a).collect()).collect();
            (mode.eigenvalue, rows)
        });
        Ok(Swarm { p, transients: transients.collect() })
    }

    /// The transient displacement of all birds at `s = 0, 1, ..`: `P^s` times that at 0, without eigenvalues.
    fn displacements(&self, coordinate: usize) -> Result<Vec<Vec<Rational>>, CheckError> {
        let mut now = vec![rational(0, 1); self.p.rows()];
        for (_, rows) in &self.transients {
            now.iter_mut().zip(rows).for_each(|(x, row)| *x += &row[coordinate]);
        }
        let mut all = vec![now];
        for s in 0..STEPS {
            let next = self.p.apply(&all[s])?;
            all.push(next);
        }
        Ok(all)
    }
}

/// All pairs of birds of all pairs of flocks, and of one flock.
fn tie_cases(run: &Run) -> Result<Vec<TieCase>, CheckError> {
    let mut random = run.random(7);
    let sides = sides();
    let mut cases = Vec::new();
    for (a, one) in sides.iter().enumerate() {
        for (b, two) in sides.iter().enumerate().take(a + 1) {
            run.checkpoint()?;
            let dimension = 1 + (a + b) % 2;
            let limit = if dimension == 1 { vec![rational(1, 1)] } else { vec![rational(3, 5), rational(-4, 5)] };
            let (p, q) = (Swarm::new(one, dimension, &mut random)?, Swarm::new(two, dimension, &mut random)?);
            let pick = |n: usize, random: &mut ChaCha8Rng| random.next_u32() as usize % n;
            // Birds i and j of two flocks; where both are the same network also two birds of one flock.
            let (i, j) = (pick(p.p.rows(), &mut random), pick(q.p.rows(), &mut random));
            cases.push(tie_case(format!("{} and {}", one.name, two.name), &limit, (&p, i), Some(&q), j)?);
            if a == b {
                let j = (i + 1) % p.p.rows();
                cases.push(tie_case(format!("two birds of the {}", one.name), &limit, (&p, i), None, j)?);
            }
        }
    }
    Ok(cases)
}

/// The difference of bird `i` of one flock and bird `j` of another (or of the same one).
fn tie_case(
    name: String,
    limit: &[Rational],
    (p, i): (&Swarm, usize),
    other: Option<&Swarm>,
    j: usize,
) -> Result<TieCase, CheckError> {
    let q = other.unwrap_or(p);
    let minus = |row: &Vec<Rational>| row.iter().map(|x| -x).collect::<Vec<_>>();
    let mut terms: Vec<(Rational, Vec<Rational>)> =
        p.transients.iter().map(|(l, rows)| (l.clone(), rows[i].clone())).collect();
    terms.extend(q.transients.iter().map(|(l, rows)| (l.clone(), minus(&rows[j]))));
    let mut excess = vec![rational(-1, 1); STEPS + 1];
    for (k, a) in limit.iter().enumerate() {
        let (first, second) = (p.displacements(k)?, q.displacements(k)?);
        for (s, e) in excess.iter_mut().enumerate() {
            *e += (a - &first[s][i] + &second[s][j]).square();
        }
    }
    let birds = p.p.rows() + other.map_or(0, |q| q.p.rows());
    Ok(TieCase { name, birds, limit: limit.to_vec(), terms, excess })
}

impl TieCase {
    /// `rho -> (Upsilon^+, Upsilon^-)`, by expanding `|A - sum Psi mu^s|²`.
    fn upsilons(&self) -> BTreeMap<Rational, (Rational, Rational)> {
        let mut all: BTreeMap<Rational, (Rational, Rational)> = BTreeMap::new();
        let mut add = |mu: Rational, value: Rational| {
            if !mu.is_zero() {
                let slot = all.entry(mu.abs()).or_insert_with(|| (rational(0, 1), rational(0, 1)));
                if mu.is_positive() { slot.0 += value } else { slot.1 += value }
            }
        };
        let dot = |a: &[Rational], b: &[Rational]| -> Rational { a.iter().zip(b).map(|(x, y)| x * y).sum() };
        for (mu, psi) in &self.terms {
            add(mu.clone(), dot(&self.limit, psi) * rational(-2, 1));
            for (other, phi) in &self.terms {
                add(mu * other, dot(psi, phi));
            }
        }
        all
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
    let printed = ExpansionVariant { alternating: true, products: true, from: 1, most: |n| n * n };
    Record::new(
        "chazelle.eq3.18",
        "Square (3.17) with B = 0 and |A| = 1 and collect equal moduli; a negative mu gives (-1)^(t - t_1), whose constant sign (-1)^t_1 belongs to \
         Upsilon^-. There are at most n - 1 values |mu_k| and n(n-1)/2 products, fewer than n². Reading: t > t_1; at t = t_1 an eigenvalue 0 still \
         contributes to the left side, but not to the right one, which has nonzero values only.",
        printed,
        check_distance_expansion,
    )
    .control("without (-1)^t", ExpansionVariant { alternating: false, ..printed })
    .control("without products of eigenvalues", ExpansionVariant { products: false, ..printed })
    .control("at t = t_1 too", ExpansionVariant { from: 0, ..printed })
    .control("fewer than n terms", ExpansionVariant { most: |n| n, ..printed })
}

fn check_distance_expansion(variant: &ExpansionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let fails = |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the expansion", "exact powers")));
    let cases = tie_cases(run)?;
    for case in &cases {
        let mut upsilons = case.upsilons();
        if !variant.products {
            upsilons.retain(|rho, _| case.terms.iter().any(|(mu, _)| mu.abs() == *rho));
        }
        if upsilons.len() >= (variant.most)(case.birds) || upsilons.keys().any(|rho| *rho >= rational(1, 1)) {
            return fails(format!("{}: {} values of rho with {} birds", case.name, upsilons.len(), case.birds));
        }
        for (s, excess) in case.excess.iter().enumerate().skip(variant.from) {
            let sign = rational(if variant.alternating && s % 2 == 1 { -1 } else { 1 }, 1);
            let sum: Rational =
                upsilons.iter().map(|(rho, (plus, minus))| (plus + minus * &sign) * rho.pow(s as i32)).sum();
            if sum != *excess {
                return fails(format!("{}: at t - t_1 = {s} the sum is {sum}, not {excess}", case.name));
            }
        }
    }
    Ok(Outcome::Holds(vec![Evidence::new(
            Grade::Exact,
            "the expansion for t > t_1, and fewer than n² terms",
            "proof by squaring (3.17); pairs of birds of 7 networks with rational spectra, 0 and equal moduli among them, dimension 1 and 2, \
             against powers of P",
        )
        .cases(cases.len() * STEPS)]))
}

/// `rho_k < (1 - 2^(-n^gap)) rho_1` and `2^(-bits) < |Upsilon_k| <= n^size`, with `bits` from `n` and the length of the numbers.
#[derive(Clone, Copy)]
pub struct GapsVariant {
    gap: u32,
    bits: fn(u64, u64) -> u64,
    size: u32,
}

/// Whether a positive number is more than `2^-bits`.
fn exceeds(x: &Rational, bits: u64) -> bool {
    // At least one over the denominator, which has fewer bits.
    x.denom().bits() <= bits || (x.numer() << bits.min(1 << 20)) > *x.denom()
}

pub fn gaps() -> Record<GapsVariant> {
    let printed = GapsVariant { gap: 10, bits: |n, length| length << n.min(32), size: 8 };
    Record::new(
        "chazelle.lem3.10",
        "Reading: Upsilon_k for even or for odd t, where it is not zero. The squares of the rho are eigenvalues of (P (x) P)², which m^4 makes \
         integral, m <= n^(an): distinct roots of an integer polynomial of degree n² differ by at least 2^(-(5+4a) n^6) after division (Mahler, Mignotte). A \
         coefficient Upsilon_k lies in the field of its rho_k², of degree at most n²: a difference operator removes the other terms, the rest is a nonzero algebraic \
         number whose denominators and conjugates have t_1 n^O(1) bits, so even 2^(-t_1 n^O(1)) < |Upsilon_k|. The upper bound sums at most 2n^2 \
         products of n^O(1) (notes/settling.md).",
        printed,
        check_gaps,
    )
    .control("rho_k < rho_1/2", GapsVariant { gap: 0, ..printed })
    .control("2^-4 < |Upsilon_k|", GapsVariant { bits: |_, _| 4, ..printed })
    .control("|Upsilon_k| <= 1", GapsVariant { size: 0, ..printed })
}

fn check_gaps(variant: &GapsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let fails = |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the bounds", "exact values")));
    let cases = tie_cases(run)?;
    let (mut closest, mut smallest) = (rational(0, 1), rational(1, 1));
    for case in &cases {
        let n = case.birds as u64;
        let length = |x: &Rational| x.numer().bits() + x.denom().bits();
        let bits: u64 = case.excess.iter().take(2).map(length).sum();
        for parity in [1, -1] {
            let sum = |(plus, minus): &(Rational, Rational)| plus + minus * rational(parity, 1);
            let upsilons: Vec<(Rational, Rational)> =
                case.upsilons().iter().map(|(rho, u)| (rho.clone(), sum(u))).filter(|(_, u)| !u.is_zero()).collect();
            for (_, upsilon) in &upsilons {
                if !exceeds(&upsilon.abs(), (variant.bits)(n, bits))
                    || upsilon.abs() > rational(n as i64, 1).pow(variant.size as i32)
                {
                    return fails(format!("{}: Upsilon = {upsilon} with n = {n}", case.name));
                }
                smallest = smallest.min(upsilon.abs());
            }
            // Increasing in rho: the last is rho_1.
            for pair in upsilons.windows(2).rev().take(1) {
                let ratio = &pair[0].0 / &pair[1].0;
                let gap = Rational::new(BigInt::from(1), BigInt::from(1) << n.pow(variant.gap).min(1 << 16));
                if ratio >= rational(1, 1) - gap {
                    return fails(format!("{}: rho_2/rho_1 = {ratio} with n = {n}", case.name));
                }
                closest = closest.max(ratio);
            }
        }
    }
    run.value("largest_ratio_seen", closest.to_string());
    run.value("smallest_coefficient_seen", smallest.to_string());
    Ok(Outcome::Holds(vec![
        Evidence::new(
            Grade::Exact,
            "both bounds, for all n",
            "proof in notes/settling.md with explicit exponents; pairs of birds of 7 networks with rational spectra",
        )
        .cases(cases.len()),
    ]))
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

impl ContactVariant {
    fn fails_at(&self, name: &str, before: &BigInt, time: &BigInt, n: u64, merger: bool) -> Option<String> {
        let t = u64::try_from(before.clone()).unwrap_or(u64::MAX).max(1);
        let fails =
            if merger { time.bits() > (self.distinct)(t, n) } else { time > &(BigInt::from(t) << (self.same)(n)) };
        fails.then(|| format!("{name}: a contact at t = {time} after t_1 = {t}, merger: {merger}"))
    }
}

pub fn next_contact() -> Record<ContactVariant> {
    let printed = ContactVariant { distinct: |t, n| t.saturating_mul(16 * n * log2(n)), same: |n| n.pow(4) };
    Record::new(
        "chazelle.lem3.9",
        "Distinct flocks with B != 0: B has the denominator of v(t_1+1) times that of pi, n^O(t_1 n), so |B| >= n^-O(t_1 n), and |A + B s| > 1 + \
         transients once s > n^O(t_1 n). B = 0, |A| != 1: ||A| - 1| >= n^-O(t_1 n), and transients fall below that within t_1 n^O(1) steps. |A| = 1: the \
         leading term of (3.18) rules after t_1 2^(n^O(1)) steps (lem3.10). The exponents are explicit in notes/settling.md; t_1 > \
         n^(2n^4) serves to have no losses, and t_1 2^(n^O(1)) = n^O(t_1 n) for distinct flocks with B = 0. The settling decision of this project is this proof, carried out.",
        printed,
        check_next_contact,
    )
    .control("distinct flocks within t_1 2^(n²)", ContactVariant { distinct: |t, n| log2(t) + n * n, ..printed })
    .control("distinct flocks within 2^(t_1)", ContactVariant { distinct: |t, _| t, ..printed })
    .control("the same flock within 2 t_1", ContactVariant { same: |_| 1, ..printed })
}

fn check_next_contact(variant: &ContactVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let speed = |c: u32| rational(1, 8i64.pow(c));
    let mut starts = vec![
        ("two groups of four, one mirrored".to_string(), groups(&[MIRRORED, PRINTED], &speed(3), Hysteresis::Paper)),
        ("four groups".to_string(), groups(&[PRINTED, MIRRORED, MIRRORED, PRINTED], &speed(3), Hysteresis::Paper)),
        ("one group, n^c = 4".to_string(), groups(&[PRINTED], &rational(1, 4), Hysteresis::Paper)),
        ("the four birds".to_string(), four_birds(Hysteresis::Paper)),
    ];
    let mut random = run.random(0);
    for k in 0..run.cases(40, 600) {
        starts.push((format!("flock {k}"), super::sequences::random_start(&mut random, Hysteresis::None)));
    }
    let (mut mergers, mut joins) = (0, 0);
    for (name, start) in &starts {
        run.checkpoint()?;
        let n = start.positions.len() as u64;
        let (switches, _) = settled(start, run)?;
        let mut network = models::averaging::Flock::new(start)?.network().clone();
        let mut before = BigInt::ZERO;
        for switch in switches {
            for &(i, j) in &switch.gained {
                let merger = !network.components().iter().any(|f| f.contains(&i) && f.contains(&j));
                *(if merger { &mut mergers } else { &mut joins }) += 1;
                if let Some(what) = variant.fails_at(name, &before, &switch.time, n, merger) {
                    return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the time", "settled exactly")));
                }
            }
            network = switch.applied_to(&network);
            before = switch.time;
        }
    }
    Ok(Outcome::Holds(vec![Evidence::new(
            Grade::Exact,
            "both bounds, for all flocks",
            format!("proof in notes/settling.md with explicit exponents; {mergers} mergers and {joins} joins of exact flocks, one after 10^84 steps"),
        )
        .cases(mergers + joins)]))
}

/// A bound of the time to steady state, by the height of a tower of twos; model K or not.
#[derive(Clone, Copy)]
pub struct TimeVariant {
    /// `height(n)`: the time is at most `2 ^^ height(n)`.
    height: fn(u64) -> u64,
    /// Whether the statement is about model K too.
    kinematic: bool,
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
    let printed = TimeVariant { height: |n| 2 * n + 5, kinematic: true };
    Record::new(
        "chazelle.thm1.1.time",
        "Model D: after n^(2n^4) no edge is lost (lem3.8). Of the at most n(n-1)/2 edges that are gained later, at most n - 1 join distinct flocks, \
         each within log2 t <= K t_1 n log2 n, and the others multiply the time by 2^(n^O(1)) (lem3.9). As K n log2 n <= t_1, a merger costs \
         two levels: t <= 2^(t_1²) <= 2^(2^t_1), starting from 2^(n^O(1)), which covers the factors of the others. So the network stands still before 2^^(2n + O(1)). Model K: its positions are not rational, \
         so the separation bounds of the proof do not apply, and the paper adds \"an extra rule to simplify the proofs\" that it does not state.",
        printed,
        check_steady_state,
    )
    .control("at most 16 steps", TimeVariant { height: |_| 3, ..printed })
    .control("at most 65536 steps", TimeVariant { height: |_| 4, ..printed })
}

fn check_steady_state(variant: &TimeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let fails = |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "model D", "settled exactly")));
    let starts = [
        ("the four birds", four_birds(Hysteresis::Paper)),
        ("eight birds, one group mirrored", groups(&[MIRRORED, PRINTED], &rational(1, 512), Hysteresis::Paper)),
    ];
    for (name, start) in &starts {
        let (_, end) = settled(start, run)?;
        let height = tower_height(end.last_switch.bits().into());
        if !matches!(end.ending, Ending::Steady) || height > (variant.height)(start.positions.len() as u64) {
            return fails(format!("{name}: steady from t = {} on", end.last_switch));
        }
    }
    // The recursion: the start and two levels for each merger.
    const LARGEST: u64 = 64;
    for n in 2..=LARGEST {
        // From 2^(n^12) on, the factors 2^(n^O(1)) of the joins within flocks are covered by T² in place of T.
        let start_bits = u128::from(n).pow(12);
        let height = tower_height(start_bits) + 2 * (n - 1);
        if height > (variant.height)(n) || start_bits < u128::from(2 * n.pow(4) * log2(n)) {
            return fails(format!("n = {n}: the recursion gives a height of {height}"));
        }
    }
    let evidence = vec![
        Evidence::new(
            Grade::Exact,
            "model D, all n",
            "proof in notes/settling.md from lem3.8 and lem3.9; its recursion in heights of towers for n = 2, ..., 64",
        )
        .cases(LARGEST as usize - 1),
        Evidence::new(Grade::Exact, "flocks of model D", "four birds steady from t = 322 on, eight from 10^84 on")
            .cases(starts.len()),
    ];
    Ok(if variant.kinematic {
        Outcome::NotCheckable(
                "for model D it holds (see the evidence); for model K the paper adds an extra rule that it does not state, so there is no definite \
                 statement to check"
                    .to_string(),
                evidence,
            )
    } else {
        Outcome::Holds(evidence)
    })
}
