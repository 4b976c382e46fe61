//! Inequalities that are attained where a part of a function is 0 at a number without a closed form: each with near misses, true and false.

use super::expression::{Tree, above, at_least, c, decided, nano, sides, x, y};
use arithmetic::{PreciseNumber, Rational, Sign, Signed, random, rational};
use polynomials::Side;
use polynomials::decide::{Decision, Effort};
use rand_chacha::rand_core::Rng;

/// Parts that change their sign once in `[1/2, 2]`.
fn part(kind: usize, stream: &mut impl Rng) -> Tree {
    let mut small = |lo: i64, hi: i64| c(lo + (stream.next_u64() % (hi - lo + 1) as u64) as i64, 1);
    match kind {
        0 => x().to(3) - small(1, 7),
        1 => x().to(3) - x() - small(1, 5),
        2 => x().to(5) + x() * small(1, 3) - small(2, 9),
        3 => x().call("exp") - x() - small(2, 4),
        4 => x() * x().call("exp") - small(1, 9),
        5 => x().to(2) + x().call("log") - small(1, 3),
        6 => x() + x().call("sin") - c(3, 2),
        _ => (x().to(3) - c(2, 1)) / (c(1, 1) + x()),
    }
}

/// Functions that are 0 where their argument is, and above 0 elsewhere near it.
fn outer(kind: usize, u: &Tree) -> Tree {
    let u = || u.clone();
    match kind {
        0 => u().call("exp") - c(1, 1) - u(),
        1 => (u().call("exp") - c(1, 1)) * u(),
        2 => c(1, 1) - u().call("cos"),
        3 => u().abs() + u().to(2) * x().call("exp"),
        4 => u().call("exp") + (-u()).call("exp") - c(2, 1),
        5 => u().call("cos") - c(1, 1) + u().to(2) * c(1, 2),
        _ => u().call("exp") - c(1, 1) - u() + u().to(2) * x() * c(1, 8),
    }
}

/// The slow twin: whether the part changes its sign at the numbers that are told.
fn has_root(part: &Tree, text: &str) -> bool {
    let (lo, hi) = super::attained::ends(text);
    let wide = rational(1, 1_000_000_000_000);
    let sign = |q: Rational| part.value(&[PreciseNumber::exact(q, 400)]).ok().and_then(|value| value.sign());
    matches!(
        (sign(lo - &wide), sign(hi + wide)),
        (Some(Sign::Negative), Some(Sign::Positive)) | (Some(Sign::Positive), Some(Sign::Negative))
    )
}

/// Whether the difference is certainly below 0 somewhere on a dense grid.
fn is_negative_on_a_grid(tree: &Tree) -> bool {
    (0..=200).any(|k| {
        let at = [PreciseNumber::exact(rational(100 + 300 * k / 200, 200), 128)];
        tree.value(&at).ok().and_then(|value| value.sign()) == Some(Sign::Negative)
    })
}

#[test]
fn what_is_attained_at_a_solution_of_an_equation_is_decided() {
    let mut stream = random::generator("polynomials", "solutions", 0);
    let domain = || vec![Side::between(rational(1, 2), rational(2, 1))];
    let effort = Effort { boxes: 4000, ..Effort::default() };
    let one = |clause| decided(clause, &domain(), effort);
    let (mut attained, mut apart, mut left) = (0, 0, Vec::new());
    for (inner, kind) in (0..8).flat_map(|inner| (0..7).map(move |kind| (inner, kind))) {
        let u = part(inner, &mut stream);
        let f = outer(kind, &u);
        assert!(!is_negative_on_a_grid(&f), "the generator is wrong: {f:?}");
        match one(vec![at_least(f.clone(), c(0, 1))]) {
            Decision::Holds(_) => {}
            Decision::Undecided(open) => left.push(format!("{f:?}: {}", open.why)),
            wrong => panic!("{f:?}: {wrong:?}"),
        }
        // Strictly it fails, at the root of the part or, where that lies outside, nowhere.
        match one(vec![above(f.clone(), c(0, 1))]) {
            Decision::FailsAt(places) => {
                assert!(
                    places.iter().all(|place| !place.to_string().starts_with('[') || has_root(&u, &place.to_string()))
                );
                attained += 1;
            }
            Decision::Fails(at) => assert_eq!(u.value(&at).expect("a value"), rational(0, 1), "{f:?} at {at:?}"),
            Decision::Holds(_) => {
                let ends = [rational(1, 2), rational(2, 1)].map(|q| u.value(&[PreciseNumber::exact(q, 256)]));
                let signs = ends.map(|value| value.expect("a value").sign());
                assert_eq!(signs[0], signs[1], "{f:?} is said to be above 0");
                apart += 1;
                continue;
            }
            Decision::Undecided(open) => left.push(format!("strictly {f:?}: {}", open.why)),
        }
        // Near misses: a little less is false, though what stands inside is 0 at the same place; and so is what is 0 there, but with a slope.
        let false_ones = [f.clone() - nano(1), f.clone() - nano(1) * x(), f.clone() - nano(1) * u.clone()];
        for less in &false_ones[..if kind == 3 { 2 } else { 3 }] {
            let said = one(vec![at_least(less.clone(), c(0, 1))]);
            assert!(!matches!(said, Decision::Holds(_)), "{less:?} is said to hold");
        }
        assert!(!matches!(one(vec![above(f.clone() + nano(1), c(0, 1))]), Decision::Fails(_) | Decision::FailsAt(_)));
    }
    println!("attained: {attained}, nowhere 0: {apart}, left open: {left:#?}");
    assert!(left.is_empty() && attained >= 40);
}

/// In several numbers: each from a part of its own, one of them simple, and two that are not zero together.
#[test]
fn solutions_in_several_numbers_are_told_apart() {
    let square = || sides(&[(0, 2), (0, 2)]);
    let grown = |u: &Tree| u.clone().call("exp") - c(1, 1) - u.clone();
    let (cube, quintic) = (x().to(3) - c(2, 1), y().to(5) - y() - c(1, 1));
    let effort = Effort { boxes: 4000, ..Effort::default() };
    let both = grown(&cube) + grown(&quintic);
    let end = grown(&(cube.clone() + y())) + y().to(2);
    let simple = grown(&cube) + y().to(2) * y().call("exp");
    for tree in [both.clone(), end, simple.clone()] {
        let said = decided(vec![at_least(tree.clone(), c(0, 1))], &square(), effort);
        assert!(matches!(said, Decision::Holds(_)), "{tree:?}: {said:?}");
        let said = decided(vec![at_least(tree.clone(), nano(1))], &square(), effort);
        assert!(matches!(said, Decision::Fails(_)), "{tree:?}: {said:?}");
    }
    // The numbers of two equations that differ by very little are two.
    let near = x().to(3) - c(2, 1) - nano(1);
    let apart = grown(&cube).call("exp") - c(1, 1) + near.abs();
    assert!(matches!(
        decided(vec![above(apart, c(0, 1))], &square(), effort),
        Decision::Holds(_) | Decision::Undecided(_)
    ));
    assert!(!matches!(decided(vec![at_least(both, c(0, 1) + nano(1) * x())], &square(), effort), Decision::Holds(_)));
}
