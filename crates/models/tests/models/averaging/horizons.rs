//! How many steps a decision takes until nothing can change: by formulas of their own for flocks of pairs and single birds.
//!
//! Allowed no steps, the decision says how many it needs. The weights of a pair sum to `2^-k`: the difference of its velocities shrinks by
//! `1 - 2^-k` in a step, to less than half in `2^k` steps and not in half as many. All numbers are multiples of powers of two, so that the
//! integers around a binary logarithm do not depend on how fractions are written.

use arithmetic::{Rational, rational};
use models::averaging::settle::{Ending, Limits, settle};
use models::averaging::{Flock, Hysteresis, Start, Weights};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

/// The floor of the binary logarithm of a multiple of a power of two.
fn floor_log2(x: &Rational) -> i64 {
    x.numer().bits() as i64 - x.denom().bits() as i64
}

/// At least, and at most, the binary logarithm of `p/q`.
fn above(p: &Rational, q: &Rational) -> i64 {
    floor_log2(p) - floor_log2(q) + 1
}

fn below(p: &Rational, q: &Rational) -> i64 {
    floor_log2(p) - floor_log2(q) - 1
}

fn dot(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn minus(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    a.iter().zip(b).map(|(x, y)| x - y).collect()
}

fn power_of_two(k: i32) -> Rational {
    rational(2, 1).pow(k)
}

/// Birds `2m` and `2m + 1` are a pair with the weights `first 2^-k` and `(1 - first) 2^-k`, or single birds.
#[derive(Debug)]
struct Pairs {
    start: Start,
    /// `k`, and the share of the first bird; none for two single birds.
    weights: Vec<Option<(i32, Rational)>>,
}

/// Where a bird goes: `place + s drift`, but for transients that are at most `range`, halved every `halving` steps.
struct Way {
    place: Vec<Rational>,
    drift: Vec<Rational>,
    range: Rational,
    /// The range of the velocities.
    speeds: Rational,
    halving: u64,
}

impl Pairs {
    /// The ways of all birds from these positions and velocities on.
    fn ways(&self, x: &[Vec<Rational>], v: &[Vec<Rational>]) -> Vec<Way> {
        let mut ways = Vec::new();
        for (m, weights) in self.weights.iter().enumerate() {
            let (i, j) = (2 * m, 2 * m + 1);
            for (one, other) in [(i, j), (j, i)] {
                let mut way = Way {
                    place: x[one].clone(),
                    drift: v[one].clone(),
                    range: rational(0, 1),
                    speeds: rational(0, 1),
                    halving: 1,
                };
                if let Some((k, first)) = weights {
                    // In the mean each counts with the weight of the other.
                    let mine = if one == i { rational(1, 1) - first } else { first.clone() };
                    let theirs = rational(1, 1) - &mine;
                    for (c, drift) in way.drift.iter_mut().enumerate() {
                        *drift = &v[one][c] * &mine + &v[other][c] * &theirs;
                        way.place[c] = &x[one][c] + (&v[one][c] - &*drift) * power_of_two(*k);
                        way.speeds = &way.speeds + (&v[one][c] - &v[other][c]).abs();
                    }
                    way.range = &way.speeds * power_of_two(*k);
                    way.halving = 1 << k;
                }
                ways.push(way);
            }
        }
        ways
    }

    /// The steps after which every pair keeps its status or follows its polynomial.
    fn horizon(&self, flock: &Flock) -> u64 {
        let ways = self.ways(&flock.positions(), &flock.velocities());
        let halving = ways.iter().map(|way| way.halving).max().unwrap();
        let one = rational(1, 1);
        let mut horizon = 0;
        for j in 0..ways.len() {
            for i in 0..j {
                let same = i / 2 == j / 2 && self.weights[i / 2].is_some();
                let size = if same { ways[i].range.clone() } else { &ways[i].range + &ways[j].range };
                let until = |size: &Rational, limit: i64| {
                    let halvings = if size.is_zero() { 0 } else { above(size, &one) - limit };
                    halvings.max(0) as u64 * halving
                };
                let (a, b) = (minus(&ways[i].place, &ways[j].place), minus(&ways[i].drift, &ways[j].drift));
                let excess = dot(&a, &a) - &one;
                let steps = if b.iter().any(|x| !x.is_zero()) {
                    approach(&excess, &(dot(&a, &b) * rational(2, 1)), &dot(&b, &b), &|limit| until(&size, limit))
                } else if excess.is_negative() {
                    until(&size, below(&-excess, &one) - 1)
                } else if let (true, Hysteresis::Constant(threshold)) = (same, flock.hysteresis()) {
                    until(&ways[i].speeds, floor_log2(threshold) - 3)
                } else {
                    until(&size, below(&excess, &(&excess + rational(3, 1))))
                };
                horizon = horizon.max(steps);
            }
        }
        horizon
    }
}

/// For `q(s) = a + b s + c s²`: until transients are small against what `q` is at its least, or against its unit.
fn approach(a: &Rational, b: &Rational, c: &Rational, until: &dyn Fn(i64) -> u64) -> u64 {
    let q = |s: &BigInt| (c * Rational::from_integer(s.clone()) + b) * Rational::from_integer(s.clone()) + a;
    let unit = [a, b, c].into_iter().map(|x| floor_log2(&(rational(1, 1) / Rational::from_integer(x.denom())))).min();
    let latest = until(unit.unwrap() - 1 - 2);
    // The integer from 1 on at which q is least, and the first at which it is not positive.
    let vertex = (-b / (c * rational(2, 1))).floor().to_integer().max(BigInt::from(1));
    let next: BigInt = &vertex + 1;
    let lowest = if q(&vertex) <= q(&next) { vertex } else { next };
    let mut contact = None;
    if !q(&lowest).is_positive() {
        let (mut before, mut after) = (BigInt::from(0), lowest);
        while &after - &before > BigInt::from(1) {
            let middle: BigInt = (&after + &before) / 2;
            if q(&middle).is_positive() { before = middle } else { after = middle }
        }
        contact = Some(after);
    }
    let log2 = match contact {
        Some(s) if s > BigInt::from(latest) * 2 + 2 => below(&q(&(s / 2)), &rational(1, 1)),
        Some(_) => return latest,
        None if !b.is_negative() && a.is_positive() => below(a, &rational(1, 1)),
        None => {
            let least = a * c * rational(4, 1) - b * b;
            if !least.is_positive() || !b.is_negative() {
                return latest;
            }
            below(&least, &(c * rational(4, 1)))
        }
    };
    until(log2.min(0) - 2).min(latest)
}

/// What is said to be needed, where no step is allowed.
fn needed(start: &Start) -> Result<u64, String> {
    let limits = Limits { steps: 0, switches: 1, jump_bits: 0 };
    let settled = settle(Flock::new(start).unwrap(), &limits, &mut |_| {}, &arithmetic::Unwatched).unwrap();
    let Ending::Undecided(why) = settled.ending else { return Err(settled.why) };
    why.split_once(" exact steps would be needed on one network, more than the limit of 0")
        .and_then(|(number, _)| number.parse().ok())
        .ok_or(why)
}

/// Forty-eight steps are taken before anything is analysed; twice as many where a jump has to be taken back.
fn compared(pairs: &Pairs) -> Option<(u64, [u64; 2])> {
    let mut flock = Flock::new(&pairs.start).unwrap();
    let edges = flock.network().edges();
    let wanted: Vec<(usize, usize)> =
        (0..pairs.weights.len()).filter(|&m| pairs.weights[m].is_some()).map(|m| (2 * m, 2 * m + 1)).collect();
    if edges != wanted {
        return None;
    }
    let mut expected = [0; 2];
    for count in &mut expected {
        for _ in 0..48 {
            if flock.step().unwrap().is_some() {
                return None;
            }
        }
        *count = pairs.horizon(&flock);
    }
    needed(&pairs.start).ok().map(|found| (found, expected))
}

fn weights(pairs: &[Option<(i32, Rational)>]) -> Weights {
    let both = |pair: &Option<(i32, Rational)>| match pair {
        Some((k, first)) => {
            let sum = power_of_two(-k);
            [first * &sum, (rational(1, 1) - first) * sum]
        }
        None => [rational(1, 1024), rational(1, 1024)],
    };
    Weights::Given(pairs.iter().flat_map(both).collect())
}

prop_compose! {
    fn flocks()(dimension in 1usize..3, count in 1usize..4)(
        kinds in prop::collection::vec(prop::option::weighted(0.7, (4i32..9, 1i64..8)), count),
        places in prop::collection::vec(prop::collection::vec(0i64..1 << 12, dimension), 2 * count),
        speeds in prop::collection::vec(prop::collection::vec(-64i64..64, dimension), 2 * count),
        drifts in prop::collection::vec(prop::collection::vec(-8i64..8, dimension), count),
        slow in 0i32..30,
        held in prop::option::of(4i32..40),
        dimension in Just(dimension),
    ) -> Pairs {
        let weights_of: Vec<_> = kinds.iter().map(|kind| kind.map(|(k, first)| (k, rational(first, 8)))).collect();
        let (mut positions, mut velocities) = (Vec::new(), Vec::new());
        for (m, kind) in kinds.iter().enumerate() {
            for bird in [2 * m, 2 * m + 1] {
                // Pairs within distance 1, other birds farther away.
                let inner = if kind.is_some() { 13 + dimension as i32 - 1 } else { 11 };
                let place = |c: usize| {
                    let far = if c > 0 { 0 } else if kind.is_some() { 6 * m as i64 } else { 6 * m as i64 + 3 * (bird % 2) as i64 };
                    rational(places[bird][c], 1) * power_of_two(-inner) + rational(far, 1)
                };
                positions.push((0..dimension).map(place).collect::<Vec<_>>());
                let shrink = kind.map_or(-40, |(k, _)| -k - 8);
                let speed = |c: usize| {
                    let own = if kind.is_some() { rational(speeds[bird][c], 1) * power_of_two(shrink) } else { rational(0, 1) };
                    own + rational(drifts[m][c], 1) * power_of_two(-10 - slow)
                };
                velocities.push((0..dimension).map(speed).collect::<Vec<_>>());
            }
        }
        let hysteresis = held.map_or(Hysteresis::None, |k| Hysteresis::Constant(power_of_two(-k)));
        let weights = weights(&weights_of);
        Pairs { start: Start { positions, velocities, weights, hysteresis }, weights: weights_of }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn the_steps_needed_are_those_of_the_formula(pairs in flocks()) {
        // Where none are needed it goes on, and what is said belongs to a later network.
        if let Some((found, expected)) = compared(&pairs).filter(|(_, expected)| expected[0] > 0) {
            prop_assert!(expected.contains(&found), "{found}, not {expected:?}");
        }
    }
}

/// Two pairs that widen, each by 1/8, and come to a little more than 1 from one another; one that widens to a little more or less than 1.
#[test]
fn distances_that_tend_to_nearly_one() {
    let w = power_of_two(-10);
    let pair = |at: Rational, gap: Rational| ([at.clone(), at + gap - rational(1, 8)], [-w.clone(), w.clone()]);
    let half = Some((6, rational(1, 2)));
    for k in [1, 3, 5, 7] {
        // Below what double precision tells apart.
        let tiny = power_of_two(-50) * rational(k, 1);
        for hysteresis in [Hysteresis::None, Hysteresis::Constant(power_of_two(-60))] {
            let two = [pair(rational(0, 1), rational(5, 8)), pair(rational(13, 8) + &tiny, rational(5, 8))];
            let wide = [pair(rational(0, 1), rational(1, 1) + &tiny)];
            let narrow = [pair(rational(0, 1), rational(1, 1) - &tiny)];
            for pairs in [&two[..], &wide, &narrow] {
                let x = pairs.iter().flat_map(|(x, _)| x.clone()).collect();
                let v = pairs.iter().flat_map(|(_, v)| v.clone()).collect();
                let shares = vec![half.clone(); pairs.len()];
                let start = Start::on_the_line(x, v, weights(&shares), hysteresis.clone());
                let (found, expected) = compared(&Pairs { start, weights: shares }).unwrap();
                assert!(expected[0] > 1000 && expected.contains(&found), "{found}, not {expected:?}");
            }
        }
    }
}

/// A bird that comes near a pair between two steps only.
#[test]
fn contacts_between_steps_are_none() {
    let row = |x: (i64, i64), y: i64| vec![rational(x.0, x.1), rational(y, 4)];
    let shares = [Some((6, rational(1, 4))), None];
    let start = Start {
        positions: vec![row((-1, 4), 0), row((1, 4), 0), row((-802, 1), 2), row((-802, 1), 80)],
        velocities: vec![row((-1, 1024), 0), row((3, 1024), 0), row((4, 1), 0), row((4, 1), 0)],
        weights: weights(&shares),
        hysteresis: Hysteresis::None,
    };
    let (found, expected) = compared(&Pairs { start, weights: shares.to_vec() }).unwrap();
    assert!(expected[0] == 512 && expected.contains(&found), "{found}, not {expected:?}");
}

/// A bird, three on a path whose ends go to `gap` from the middle, and far away four that alternate for ever; all of it turned and moving.
fn alternating(gap: &Rational, other: [Rational; 4]) -> Start {
    let u = rational(1, 32);
    let [x, y, v, w] = other;
    let (mut positions, mut velocities) = (vec![[x, y]], vec![[v, w]]);
    for k in [-1, 0, 1] {
        let side = rational(k, 1);
        // The velocities of the ends fall to a third in each step: 1 + 1/3 + .. = 3/2.
        positions.push([&side * (gap - &u * rational(3, 2)), rational(0, 1)]);
        velocities.push([&side * &u, rational(0, 1)]);
    }
    positions.extend([0, 8, 21, 29].map(|x| [rational(x, 16), rational(1000, 1)]));
    velocities.extend([1, -1, 1, -1].map(|v| [rational(v, 8), rational(0, 1)]));
    let turned = |[x, y]: &[Rational; 2]| {
        vec![
            (x * rational(3, 1) - y * rational(4, 1)) / rational(5, 1),
            (x * rational(4, 1) + y * rational(3, 1)) / rational(5, 1),
        ]
    };
    let moving = |v: &[Rational; 2]| turned(v).into_iter().map(|x| x + rational(1, 7)).collect();
    Start {
        positions: positions.iter().map(turned).collect(),
        velocities: velocities.iter().map(moving).collect(),
        weights: Weights::Lazy,
        hysteresis: Hysteresis::None,
    }
}

/// The steps for which a cycle of two networks would have to be followed.
fn to_be_followed(start: &Start) -> u64 {
    let limits = Limits { steps: 1, switches: 100, ..Limits::default() };
    let settled = settle(Flock::new(start).unwrap(), &limits, &mut |_| {}, &arithmetic::Unwatched).unwrap();
    let number = settled.why.split_once("which would have to be followed for ").map(|(_, rest)| rest);
    let number = number.and_then(|rest| rest.split(' ').next()).unwrap_or_else(|| panic!("{}", settled.why));
    number.parse().unwrap()
}

#[test]
fn cycles_are_followed_as_long_as_the_formula_says() {
    let log2 = |x: &Rational| x.numer().bits() as i64 - x.denom().bits() as i64;
    let tiny = power_of_two(-60);
    let one = rational(1, 1);
    let away = || [rational(-500, 1), rational(0, 1), rational(0, 1), rational(0, 1)];
    let zero = || rational(0, 1);
    // The limit of the left end is at -3/4.
    let wide = rational(3, 4);
    let cases = [1, 3, 5, 7].into_iter().flat_map(|k| {
        let tiny = &tiny * rational(k, 1);
        [
            // The ends go to just below 1 from the middle.
            (&one - &tiny, away()),
            // A bird to the left, to which the distance goes to just above 1: at rest, moving away, and passing.
            (wide.clone(), [-rational(7, 4) - &tiny, zero(), zero(), zero()]),
            (wide.clone(), [-rational(7, 4) - &tiny, zero(), -power_of_two(-70), zero()]),
            (wide.clone(), [rational(-8, 1), &one + &tiny, power_of_two(-9), zero()]),
            (wide.clone(), [rational(-8, 1), rational(-2, 1), power_of_two(-9), zero()]),
        ]
    });
    // The leading terms of the pair that swings around 1 have a sign after one round of twice the cycle, and that is seen in another.
    let base = to_be_followed(&alternating(&wide, away()));
    assert_eq!(base, 8);
    for (gap, other) in cases {
        let start = alternating(&gap, other);
        let mut flock = Flock::new(&start).unwrap();
        (0..24).for_each(|_| drop(flock.step().unwrap()));
        let mut expected = base;
        for phase in 0..2 {
            let (x, v) = (flock.positions(), flock.velocities());
            // In a round of two steps the velocities of the ends fall to a ninth: they come 1 + 1/3 times 1/(1 - 1/9) farther than
            // the middle one. The sizes in both coordinates are added.
            let place = |i: usize| -> Vec<Rational> {
                let swing = minus(&v[i], &v[2]);
                x[i].iter().zip(swing).map(|(x, v)| if i > 0 { x + v * rational(3, 2) } else { x.clone() }).collect()
            };
            let speeds: Rational = minus(&v[3], &v[1]).iter().map(Signed::abs).sum();
            let size = speeds * rational(9, 8) * rational(2, 1);
            for (i, j) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
                let a = minus(&place(i), &place(j));
                let drift = if i == 0 { minus(&v[0], &v[2]) } else { vec![zero(), zero()] };
                let b: Vec<Rational> = drift.into_iter().map(|w| w * rational(2, 1)).collect();
                let excess = dot(&a, &a) - &one;
                let limit = if b.iter().any(|w| !w.is_zero()) {
                    let along = dot(&a, &b);
                    let least = if along.is_negative() { &excess - &along * &along / dot(&b, &b) } else { excess };
                    least.min(one.clone()) * rational(1, 4)
                } else if excess.is_negative() {
                    -excess * rational(1, 2)
                } else {
                    &excess / (&excess + rational(3, 1))
                };
                // In each round the transients fall to a ninth, so that one halves them.
                let halvings = (log2(&size) + 1) - (log2(&limit) - 1);
                expected = expected.max(halvings.max(0) as u64 * 2 + phase);
            }
            flock.step().unwrap();
        }
        assert_eq!(to_be_followed(&start), expected);
        // One step less is not enough, and as many are.
        let ending = |steps: u64| {
            let limits = Limits { steps, switches: 100, ..Limits::default() };
            settle(Flock::new(&start).unwrap(), &limits, &mut |_| {}, &arithmetic::Unwatched).unwrap().ending
        };
        assert!(matches!(ending(expected - 1), Ending::Undecided(_)));
        assert!(matches!(ending(expected), Ending::Alternating { period: 2 }));
    }
}

/// On a path of three with `c = 1/8` the velocities have parts `(-1, 0, 1)` and `(1, -2, 1)` that fall to 7/8 and 5/8 in each step; the gap
/// of the first two tends to 1 and the other one to 3/4.
#[test]
fn ties_are_settled_when_the_leading_term_outweighs_the_others() {
    let start = |k: i32, dimension: usize, hysteresis: &Hysteresis| {
        let fast = rational(-1, 32);
        let slow = power_of_two(-5 - k);
        let velocities = [&fast - &slow, &fast * rational(-2, 1), &fast + &slow];
        // What is still to come: 8 and 8/3 times the velocities.
        let gap = |limit: Rational, sign: i64| {
            limit - (&slow + &fast * rational(3 * sign, 1) * rational(1, 3)) * rational(8, 1)
        };
        let first = gap(rational(1, 1), -1);
        let places = [rational(0, 1), first.clone(), first + gap(rational(3, 4), 1)];
        let row = |x: &Rational| (0..dimension).map(|c| if c == 0 { x.clone() } else { rational(0, 1) }).collect();
        Start {
            positions: places.iter().map(row).collect(),
            velocities: velocities.iter().map(row).collect(),
            weights: Weights::Given(vec![rational(1, 8); 3]),
            hysteresis: hysteresis.clone(),
        }
    };
    // After the 48 steps the second part is 2^(k - 23.3) times the first, and falls by 25/49 in two steps: the powers of two from which on it
    // is less are 1, 64, 64 and 128.
    for (k, steps) in [(0, 4), (60, 130), (70, 130), (90, 258)] {
        // A threshold of zero holds nothing.
        for hysteresis in [Hysteresis::None, Hysteresis::Constant(rational(0, 1))] {
            assert_eq!(needed(&start(k, 1, &hysteresis)), Ok(steps));
            assert_eq!(needed(&start(k, 2, &hysteresis)), Ok(steps));
        }
    }
    let settled = |steps: u64| {
        let limits = Limits { steps, ..Limits::default() };
        settle(Flock::new(&start(90, 1, &Hysteresis::None)).unwrap(), &limits, &mut |_| {}, &arithmetic::Unwatched)
            .unwrap()
    };
    assert!(settled(257).why.starts_with("258 exact steps would be needed"));
    let steady = settled(258);
    assert!(matches!(steady.ending, Ending::Steady) && steady.why.ends_with("there is no pair with relative drift"));
}

#[test]
fn limits_are_those_that_are_stated() {
    let limits = Limits::default();
    assert_eq!((limits.steps, limits.switches, limits.jump_bits), (400_000, 100_000, 4_194_304));
}
