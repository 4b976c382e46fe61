//! Functions far out and beside numbers at which they have no slope: random ones beside exact samples, and planted ones that fail very far out.

use super::expression::{Of, Tree, above, at_least, c, decided, nano, x, y};
use arithmetic::{PreciseNumber, Rational, Sign, Signed, random, rational};
use polynomials::decide::{Decision, Effort};
use polynomials::{Function, Side};
use rand_chacha::rand_core::Rng;

fn from(lo: i64) -> Vec<Side> {
    vec![Side { lo: Some(rational(lo, 1)), hi: None, integer: false }]
}

fn unit() -> Vec<Side> {
    vec![Side::between(rational(0, 1), rational(1, 1))]
}

/// A function of one number of so many levels.
fn drawn(stream: &mut impl Rng, levels: u32) -> Tree {
    let mut of = |below: u32| drawn(stream, below);
    if levels == 0 {
        return match stream.next_u64() % 3 {
            0 => c(1 + (stream.next_u64() % 5) as i64, 1 + (stream.next_u64() % 3) as i64),
            _ => x(),
        };
    }
    let (a, b) = (of(levels - 1), of(levels - 1));
    match stream.next_u64() % 12 {
        0 | 1 => a + b,
        2 | 3 => a - b,
        4 | 5 => a * b,
        6 => a / b,
        7 => a.root(),
        8 => a.call("cbrt"),
        9 => (-a).call("exp"),
        10 => a.call("log"),
        _ => a.call("sin"),
    }
}

/// The sign at a number, by enclosure.
fn sign(tree: &Tree, at: &Rational) -> Option<Sign> {
    let at = [PreciseNumber::exact(at.clone(), 200)];
    Of(tree.clone()).value(&at).ok().and_then(|value| value.sign())
}

/// Numbers from 2 on up to 10^18, and their inverses.
fn samples() -> Vec<Rational> {
    let steps = (0..160).map(|k| Rational::from_float(2.0 * 1.3f64.powi(k)).unwrap());
    steps.chain((0..60).map(|k| rational(20 + k, 10))).collect()
}

#[test]
fn random_functions_get_no_wrong_answer_at_the_ends() {
    let mut stream = random::generator("polynomials", "ends", 0);
    let effort = Effort { boxes: 120, squares: false, certified: false, conditions: false };
    let (mut holds, mut fails) = (0, 0);
    for number in 0..400 {
        let tree = drawn(&mut stream, 2 + number % 3);
        for (domain, inverse) in [(from(2), false), (unit(), true)] {
            let of = |q: &Rational| if inverse { q.recip() } else { q.clone() };
            let signs: Vec<(Rational, Option<Sign>)> = samples().iter().map(|q| (of(q), sign(&tree, &of(q)))).collect();
            match decided(vec![at_least(tree.clone(), c(0, 1))], &domain, effort) {
                Decision::Holds(_) => {
                    holds += 1;
                    let below = signs.iter().find(|(_, sign)| *sign == Some(Sign::Negative));
                    assert!(below.is_none(), "{tree:?} is negative at {below:?}");
                }
                Decision::Fails(at) => {
                    fails += 1;
                    assert_ne!(sign(&tree, &at[0]), Some(Sign::Positive), "{tree:?} at {at:?}");
                }
                _ => {}
            }
        }
    }
    println!("{holds} hold, {fails} fail of 800");
    assert!(holds >= 250 && fails >= 100, "{holds} hold, {fails} fail");
}

/// True ones, and the same with a part in 10^9 more: false far out, or very near to 0.
#[test]
fn what_fails_far_out_is_not_said_to_hold() {
    let e = |tree: Tree| tree.call("exp");
    let pairs: Vec<(Tree, Tree, Vec<Side>)> = vec![
        (e(-x()), c(1, 1) / x(), from(2)),
        (e(-x()) + nano(1), c(1, 1) / x(), from(2)),
        (x().call("log"), x().root(), from(2)),
        (x().call("log") + x() * nano(1), x().root(), from(2)),
        ((x().to(2) + c(1, 1)).root(), x() + c(1, 2) / x(), from(2)),
        ((x().to(2) + c(1, 1)).root() + nano(1), x() + c(1, 2) / x(), from(2)),
        (x() * (c(1, 1) / x()).call("sin"), c(1, 1), from(2)),
        (x() * (c(1, 1) / x()).call("sin") + nano(1), c(1, 1), from(2)),
        (x() * x().call("sin"), x().to(2), from(2)),
        (x() + x().call("sin") * c(2, 1), x() + c(2, 1) - nano(1), from(2)),
        (x().root().call("sin"), x().root(), unit()),
        (x().root().call("sin") + x() * x().root() * c(158, 1000), x().root(), unit()),
        (x().root().call("sin") + x() * x().root() * c(167, 1000), x().root(), unit()),
        (e(-(c(1, 1) / (x() + nano(0)))), x().to(9) * c(400_000, 1), unit()),
        (x().to(9) * nano(1), e(-(c(1, 1) / x())), unit()),
    ];
    let is_true = [true, false, true, false, true, false, true, false, true, false, true, true, false, true, false];
    for ((less, more, domain), is_true) in pairs.into_iter().zip(is_true) {
        let found = decided(vec![at_least(more.clone(), less.clone())], &domain, Effort::default());
        assert_eq!(matches!(found, Decision::Holds(_)), is_true, "{less:?} <= {more:?}: {found:?}");
        let strict = decided(vec![above(more.clone(), less.clone())], &domain, Effort::default());
        assert!(is_true || !matches!(strict, Decision::Holds(_)), "{less:?} < {more:?}: {strict:?}");
    }
}

/// Homogeneous functions and functions of a sum, random ones beside a grid.
#[test]
fn random_functions_along_lines_get_no_wrong_answer() {
    let mut stream = random::generator("polynomials", "faces", 0);
    let (mut holds, mut fails) = (0, 0);
    let mut small = move || (stream.next_u64() % 9) as i64 - 4;
    for number in 0..120 {
        let (p, q, r) = (c(small(), 1), c(small(), 2), c(small(), 3));
        let tree = match number % 3 {
            0 => p * x().to(2) + q * x() * y() + r * y().to(2),
            1 => (p * (x() + y())).call("exp") - q * (x() + y()) - r,
            _ => p * (x().to(2) + y().to(2)).root() + q * x() + r * y(),
        };
        let domain =
            vec![Side::between(rational(-1, 1), rational(2, 1)), Side::between(rational(-2, 1), rational(1, 1))];
        let effort = Effort { boxes: 600, squares: false, certified: false, conditions: false };
        let value = |x: i64, y: i64| {
            let at = [rational(x, 10), rational(y, 10)].map(|q| PreciseNumber::exact(q, 200));
            Of(tree.clone()).value(&at).ok().and_then(|value| value.sign())
        };
        match decided(vec![at_least(tree.clone(), c(0, 1))], &domain, effort) {
            Decision::Holds(_) => {
                holds += 1;
                let below = (-10..=20)
                    .flat_map(|x| (-20..=10).map(move |y| (x, y)))
                    .find(|(x, y)| value(*x, *y) == Some(Sign::Negative));
                assert!(below.is_none(), "{tree:?} at {below:?}");
            }
            Decision::Fails(_) | Decision::FailsAt(_) => fails += 1,
            Decision::Undecided(_) => {}
        }
    }
    assert!(holds >= 10 && fails >= 50, "{holds} hold, {fails} fail");
}
