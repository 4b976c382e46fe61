//! chazelle.hyst, chazelle.hyst.remark, chazelle.lem3.6.i and chazelle.lem3.6.ii: the hysteresis rule and its
//! soundness.

use super::geometry::{loss_exponent, switch_exponent};
use super::sequences::{settled, show_start};
use crate::prelude::*;
use arithmetic::Signed;
use models::averaging::settle::Ending;
use models::averaging::{Flock, Hysteresis, Start, Weights};
use num_bigint::BigInt;

/// `n^(-n^power)`.
fn threshold(n: i64, power: u32) -> Rational {
    rational(1, n).pow(n.pow(power) as i32)
}

/// The rule that the networks are compared with.
#[derive(Clone, Copy)]
pub struct RuleVariant {
    /// The threshold is `n^(-n^power)`.
    power: u32,
    /// Changes below the threshold, or up to it.
    strict: bool,
    /// Whether old edges only stay, or every pair with a small change is joined.
    old_only: bool,
    /// Whether an edge that would be lost by distance can stay at all.
    holds: bool,
}

impl RuleVariant {
    fn joins(&self, n: i64, was_edge: bool, before: &Rational, now: &Rational) -> bool {
        let change = if now > before { now - before } else { before - now };
        let limit = threshold(n, self.power);
        let small = if self.strict { change < limit } else { change <= limit };
        *now <= rational(1, 1) || (self.holds && small && (was_edge || !self.old_only))
    }
}

pub fn rule() -> Record<RuleVariant> {
    Record::new(
        "chazelle.hyst",
        "A definition has no truth value. What can be checked is that it determines the network, and that the flocks \
         of this project follow it to the letter.",
        RuleVariant { power: 4, strict: true, old_only: true, holds: true },
        check_rule,
    )
    .reading(
        "An existing edge is one of G_{t-1}, however it came about (printed is G_t, which the rule is to determine); \
         it stays whatever its length is; \"less than\" is strict; n is the number of birds; G_0 is the network of \
         the distance rule.",
    )
    .altered("the threshold n^(-n^3)", |v| v.power = 3)
    .altered("changes up to the threshold", |v| v.strict = false)
    .altered("pairs that were not joined", |v| v.old_only = false)
    .altered("no hysteresis", |v| v.holds = false)
}

fn check_rule(variant: &RuleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const PART: &str = "flocks follow the rule as read";
    let fails = |what: String| Ok(Outcome::fails(what, exact(PART, "an exact flock")));
    let mut cases = 0;
    for n in 2..=4i64 {
        let epsilon = threshold(n, 4);
        // Birds 1 and 2 cross (or keep beyond) distance 1 with a change of a multiple of the threshold; others are far.
        for (was_edge, quarters) in [(true, 1), (true, 3), (true, 5), (true, 4), (true, 800), (false, 1), (false, 5)] {
            let change = &epsilon * rational(quarters, 4);
            let half = &change / rational(2, 1);
            let before = if was_edge { rational(1, 1) - &half } else { rational(1, 1) + &half };
            let now = &before + &change;
            let mut x = vec![rational(0, 1), before.clone()];
            x.extend((2..n).map(|k| rational(100 * k, 1)));
            let mut v = vec![rational(0, 1); n as usize];
            v[1].clone_from(&change);
            let mut flock = Flock::new(&Start::on_the_line(x, v, Weights::Lazy, Hysteresis::Paper))?;
            flock.step()?;
            cases += 1;
            let found = flock.network().has_edge(0, 1);
            if flock.network().edges().len() > 1 || found != variant.joins(n, was_edge, &before, &now) {
                return fails(format!(
                    "{n} birds, distance {} the threshold short of or beyond 1, then a change of {quarters}/4 of it: \
                     edge {found}",
                    rational(quarters, 8)
                ));
            }
        }
    }
    // The four birds of Section 3: gaps in closed form, the edge 2-3 by the rule.
    let mut flock = Flock::new(&Start::four_birds(Hysteresis::Paper))?;
    let mut before = flock.positions();
    for t in 1..=340 {
        run.checkpoint()?;
        let was_edge = flock.network().has_edge(1, 2);
        flock.step()?;
        let now = flock.positions();
        let gap = |x: &[Vec<Rational>]| &x[2][0] - &x[1][0];
        cases += 1;
        if flock.network().has_edge(1, 2) != variant.joins(4, was_edge, &gap(&before), &gap(&now)) {
            return fails(format!("the four birds at t = {t}: birds 2 and 3 do not follow the rule"));
        }
        before = now;
    }
    let evidence = exact(
        PART,
        "two of 2, 3, 4 birds crossing distance 1 by 1/4 to 200 thresholds, joined before or not; the four birds for \
         340 steps",
    );
    let why = "a definition, which is neither true nor false; the flocks of this project follow it (see the evidence)";
    Ok(Outcome::NotCheckable(why.to_string(), vec![evidence.cases(cases)]))
}

/// The threshold `2^-100 n^(-n^4)`.
#[derive(Clone, Copy)]
pub struct SmallerThresholdVariant {
    /// No threshold at all.
    without: bool,
    /// Step 1 is `n^lasting(n) > n^4 ln n + 100 ln 2`.
    lasting: fn(u64) -> u64,
    /// Whether the times of the four-bird example are among the results.
    examples: bool,
}

pub fn smaller_threshold() -> Record<SmallerThresholdVariant> {
    Record::new(
        "chazelle.hyst.remark",
        "The threshold enters the results in three places: e^(-n^(n²)) < eps (the edges of V_k last), the growth of \
         long edges in Lemma 3.6(ii), which is less with a smaller threshold, and the time n^(2n^4) of Lemma 3.8, \
         which n^O(n²)/eps must not exceed. All three hold with 2^-100 n^(-n^4) for n >= 4 (notes/settling.md, The \
         smaller threshold).",
        SmallerThresholdVariant { without: false, lasting: |n| n * n, examples: false },
        check_smaller_threshold,
    )
    .reading(
        "The results are the theorem and the lemmas, for n large enough (here n >= 4), not the times of the example.",
    )
    .altered("no threshold at all", |v| v.without = true)
    .altered("step 1 of the proof: with n^n in place of n^(n²)", |v| v.lasting = |n| n)
    .altered("even the times of the example", |v| v.examples = true)
}

fn check_smaller_threshold(variant: &SmallerThresholdVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let inequalities = certified("steps 1 and 3", "enclosures for n = 4, ..., 24");
    Run::all([
        run.every(inequalities, 4..=24, |n| variant.fails_for(n)),
        variant.four_birds(run).checks("the conclusion"),
        argued(
            &[],
            "the three places where the threshold enters, n >= 4",
            "notes/settling.md, The smaller threshold, steps 1-3",
        ),
    ])
}

impl SmallerThresholdVariant {
    /// Steps 1 and 3: `n^(n²) > n^4 ln n + 100 ln 2`, and `2^100 n^(n^4)` times the factor of Lemma 3.8 is at most
    /// `n^(2n^4)`.
    fn fails_for(&self, n: u64) -> Result<Option<String>, CheckError> {
        let base = Interval::from_rational(&rational(n as i64, 1), 128);
        let (ln, lost) = (base.ln()?, base.integer(2).ln()? * base.integer(100));
        let quartic = base.power(4) * &ln;
        let lasting = base.power((self.lasting)(n)) - &quartic - &lost;
        let time = quartic - lost - base.integer(loss_exponent(n, 2, 1) as i64) * &ln;
        let wrong = if !lasting.is_certainly_positive() { Some("step 1") } else { None };
        let wrong = if time.is_certainly_positive() { wrong } else { Some("step 3") };
        Ok(wrong.map(|step| format!("{step} is wrong for n = {n}")))
    }

    /// The four birds of the paper end in the same network, at another time.
    fn four_birds(&self, run: &mut Run) -> Result<Outcome, CheckError> {
        let smaller = Hysteresis::Constant(threshold(4, 4) / rational(2, 1).pow(100));
        let (_, printed) = settled(&Start::four_birds(Hysteresis::Paper), run)?;
        let (_, found) = settled(&Start::four_birds(if self.without { Hysteresis::None } else { smaller }), run)?;
        run.value("four_birds_last_switch", found.last_switch.to_string());
        let detail = "the four birds end in the same network, at another time; settled exactly";
        let (steady, last) = (matches!(found.ending, Ending::Steady), &found.last_switch);
        let same = found.network == printed.network && (!self.examples || *last == printed.last_switch);
        let what = || match steady {
            true => format!("the four birds switch last at t = {last}, not {}", printed.last_switch),
            false => format!("the four birds: {}", found.why),
        };
        unless((!steady || !same).then(what), exact("the example", detail))
    }
}

/// Birds within `radius` are joined; or the converse.
#[derive(Clone, Copy)]
pub struct NearVariant {
    radius: (i64, i64),
    converse: bool,
}

fn squared_distance(x: &[Vec<Rational>], i: usize, j: usize) -> Rational {
    x[i].iter().zip(&x[j]).map(|(a, b)| (a - b).square()).sum()
}

pub fn near_birds_are_joined() -> Record<NearVariant> {
    Record::new(
        "chazelle.lem3.6.i",
        "The hysteresis rule only keeps edges: G_t contains the network of the distance rule at all times t, by its \
         definition.",
        NearVariant { radius: (1, 1), converse: false },
        check_near_birds_are_joined,
    )
    .altered("within distance 101/100", |v| v.radius = (101, 100))
    .altered("only birds within unit distance", |v| v.converse = true)
}

fn check_near_birds_are_joined(variant: &NearVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let starts: Vec<Start> = (0..run.cases(120, 2000))
        .map(|case| {
            let hysteresis = match case % 3 {
                0 => Hysteresis::Paper,
                1 => Hysteresis::Constant(rational(1, 40)),
                _ => Hysteresis::Constant(rational(1, 4)),
            };
            Start::random(hysteresis, &mut random)
        })
        .collect();
    let detail = "exact flocks of 2 to 5 birds in dimension 1 to 3, 12 steps";
    Run::all([
        run.every(fuzzed("pairs within unit distance", detail), &starts, |s| variant.fails_at(s)).checks("step 2"),
        argued(&[], "every pair within unit distance, at all times", "notes/settling.md, Lemma 3.6(i), steps 1 and 2"),
    ])
}

impl NearVariant {
    fn fails_at(&self, start: &Start) -> Result<Option<String>, CheckError> {
        let limit = rational(self.radius.0, self.radius.1).square();
        let mut flock = Flock::new(start)?;
        for t in 0..12 {
            let x = flock.positions();
            for (i, j) in (0..flock.birds()).flat_map(|j| (0..j).map(move |i| (i, j))) {
                let (near, joined) = (squared_distance(&x, i, j) <= limit, flock.network().has_edge(i, j));
                if near && !joined || self.converse && joined && !near {
                    return Ok(Some(format!(
                        "{} at t = {t}: birds {} and {}, joined: {joined}",
                        show_start(start),
                        i + 1,
                        j + 1
                    )));
                }
            }
            flock.step()?;
        }
        Ok(None)
    }
}

/// Adjacent birds are within `1 + n^(-n^power)`, weights of at least `1/weight`; a kept edge grows by at most
/// `growth` times the threshold in each step; mixing takes at most `n^(a + mixing)` steps; speeds are at most `n^speeds`.
#[derive(Clone, Copy)]
pub struct FarVariant {
    power: u32,
    weight: i64,
    growth: (i64, i64),
    mixing: u64,
    speeds: u64,
}

impl FarVariant {
    /// Steps 3 and 4: `S + 2 <= n^(a + mixing)`, and `n^4` is more than the exponents of the growth and `n^power` together.
    fn exponents_fail(&self, n: u64, a: u64) -> Option<String> {
        let power = |exponent: u64| BigInt::from(n).pow(exponent as u32);
        let c = self.speeds;
        // With ln n < n.
        let mixing = power(a + 2) * (n.pow(4) + 3 * a + c + 6) * n / 4 + 3;
        if mixing > power(a + self.mixing) {
            return Some(format!(
                "step 3 for n = {n}, a = {a}: mixing may take {mixing} steps, more than n^{}",
                a + self.mixing
            ));
        }
        let growth = switch_exponent(n, a, c) + a + self.mixing + 1;
        (n.pow(4) <= growth + n.pow(self.power))
            .then(|| format!("step 4 for n = {n}, a = {a}, c = {c}: the edges may grow by n^({growth} - n^4)"))
    }

    /// Step 1: in a flock with the threshold 1/40, how much longer than 1 a kept edge is.
    fn grows_too_fast(&self, start: &Start) -> Result<Option<String>, CheckError> {
        let most = rational(1, 40) * rational(self.growth.0, self.growth.1);
        let mut flock = Flock::new(start)?;
        let n = flock.birds();
        // For each pair the steps since its length was at most 1.
        let mut since = vec![0; n * n];
        for t in 0..16 {
            let x = flock.positions();
            for (i, j) in flock.network().edges() {
                let squared = squared_distance(&x, i, j);
                let steps = &mut since[i * n + j];
                *steps = if squared <= rational(1, 1) { 0 } else { *steps + 1 };
                if squared > (rational(1, 1) + &most * rational(*steps, 1)).square() {
                    return Ok(Some(format!(
                        "{} at t = {t}: birds {} and {} after {steps} steps",
                        show_start(start),
                        i + 1,
                        j + 1
                    )));
                }
            }
            flock.step()?;
        }
        Ok(None)
    }

    /// Two birds at distance 1 that part by 7/8 of the threshold in the first step: how far they get while joined.
    fn parting_pair(&self, n: i64) -> Result<Option<String>, CheckError> {
        let speed = threshold(n, 4) * rational(7, 8);
        let mut x = vec![rational(0, 1), rational(1, 1)];
        let mut v = vec![rational(0, 1), speed];
        x.extend((2..n).map(|k| rational(100 * k, 1)));
        v.resize(n as usize, rational(0, 1));
        let weights = Weights::Given(vec![rational(1, self.weight); n as usize]);
        let mut flock = Flock::new(&Start::on_the_line(x, v, weights, Hysteresis::Paper))?;
        let limit = rational(1, 1) + threshold(n, self.power);
        for t in 1..=4 * self.weight {
            flock.step()?;
            let x = flock.positions();
            let distance = &x[1][0] - &x[0][0];
            if flock.network().has_edge(0, 1) && distance > limit {
                return Ok(Some(format!(
                    "{n} birds, c_i = 1/{}: x(0) = (0, 1, ..), v(1) = (0, 7/8 eps, ..): at t = {t} birds 1 and 2 are \
                     joined at a distance above 1 + n^(-n^{})",
                    self.weight, self.power
                )));
            }
        }
        Ok(None)
    }

    /// The four birds of the paper until long after their last switch.
    fn four_birds(&self, run: &Run) -> Result<Outcome, CheckError> {
        let mut flock = Flock::new(&Start::four_birds(Hysteresis::Paper))?;
        let limit = (rational(1, 1) + threshold(4, self.power)).square();
        run.instances("the four birds", "400 steps, exactly", 1..=400, |t: u32| {
            flock.step()?;
            let x = flock.positions();
            let far = flock.network().edges().into_iter().find(|&(i, j)| squared_distance(&x, i, j) > limit);
            Ok(far.map(|(i, j)| format!("the four birds at t = {t}: birds {} and {}", i + 1, j + 1)))
        })
    }
}

pub fn far_birds_are_not() -> Record<FarVariant> {
    Record::new(
        "chazelle.lem3.6.ii",
        "An edge longer than 1 has been kept at every step since its length was at most 1. Each step adds less than \
         eps, and on a fixed network also less than the difference of the velocities, which mixing brings below any \
         limit: it grows by at most eps (mixing time + 2) between two switches. With N(n) <= n^(a(n-1)² + (c+9)(n-1) \
         + 1) switches and entries >= n^-a the sum is below n^(-n^3) for all n >= 4 with n > a + c: weights with \
         denominators up to n^a, speeds up to n^c (notes/settling.md).",
        FarVariant { power: 3, weight: 8, growth: (1, 1), mixing: 8, speeds: 1 },
        check_far_birds_are_not,
    )
    .reading(
        "n is large enough against the weights and speeds: n >= 4 and n > a + c, with weights of a log_2 n bits and \
         speeds up to n^c; so n >= 4 for lazy or vicsek weights and speeds up to n. Weights change only when the network \
         does, as model D has it. Two birds with c_i = 1/1024 show that n has to be large.",
    )
    .altered("1 + n^(-n^4)", |v| v.power = 4)
    .altered("two birds with c_i = 1/1024", |v| v.weight = 1024)
    .altered("step 1 of the proof: with half of the threshold", |v| v.growth = (1, 2))
    .altered("step 3 of the proof: with n^(a+6) steps", |v| v.mixing = 6)
    .altered("step 4 of the proof: with speeds up to n^45", |v| v.speeds = 45)
}

fn check_far_birds_are_not(variant: &FarVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let rule = Hysteresis::Constant(rational(1, 40));
    // First two birds at distance 1 that part by 7/8 of the threshold.
    let [x, v] = [rational(1, 1), rational(7, 320)].map(|second| vec![rational(0, 1), second]);
    let parting = Start::on_the_line(x, v, Weights::Lazy, rule.clone());
    let random = (0..run.cases(60, 600)).map(|_| Start::random(rule.clone(), &mut random));
    let starts: Vec<Start> = std::iter::once(parting).chain(random).collect();
    let step_1 = fuzzed(
        "step 1: how fast a kept edge grows",
        "exact flocks of 2 to 5 birds in dimension 1 to 3 with the threshold 1/40, first two that part, 16 steps",
    );
    let sizes = (4..=200).flat_map(|n| [(n, 1), (n, 2)]);
    let steps_3_4 = "exact integers for n = 4, ..., 200 and entries >= 1/n, 1/n², speeds up to n";
    Run::all([
        run.instances("parting pairs", "2 and 3 birds with c_i = 1/8, 32 steps", 2..=3, |n| variant.parting_pair(n))
            .checks("the conclusion"),
        variant.four_birds(run).checks("the conclusion"),
        run.every(step_1, &starts, |start| variant.grows_too_fast(start)),
        run.instances("steps 3 and 4", steps_3_4, sizes, |(n, a)| Ok(variant.exponents_fail(n, a))),
        argued(
            &[],
            "adjacent birds, for all n large enough",
            "notes/settling.md, Lemma 3.6(ii), steps 1-4, with the bound of beyond.chazelle.switches",
        ),
    ])
}
