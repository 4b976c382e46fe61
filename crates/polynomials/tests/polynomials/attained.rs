//! Points at which a function is 0: proved, and never said where there is none.

use super::expression::{Of, Tree, c, lines, nano, sides, x, y};
use arithmetic::{Rational, random, rational};
use polynomials::decide::{Decision, Effort, zero};
use polynomials::univariate::Polynomial;
use polynomials::{Compared, Literal, Side};
use rand_chacha::rand_core::Rng;

/// The numbers of a point as texts; those that are enclosed are in brackets.
fn found(tree: Tree, domain: &[Side]) -> Option<Vec<String>> {
    let literal = Literal { function: Of(tree), compared: Compared::NotNegative, guarded: true };
    zero(&literal, domain).map(|places| places.iter().map(ToString::to_string).collect())
}

/// The ends of an enclosure.
pub fn ends(text: &str) -> (Rational, Rational) {
    let (lo, hi) = text.trim_matches(['[', ']']).split_once(", ").expect("two ends");
    let number = |text: &str| {
        let (whole, part) = text.split_once('.').unwrap_or((text, ""));
        let ten = |k: usize| num_bigint::BigInt::from(10).pow(k as u32);
        Rational::new(format!("{whole}{part}").parse().expect("digits"), ten(part.len()))
    };
    (number(lo), number(hi))
}

fn contains(text: &str, number: f64) -> bool {
    use num_traits::ToPrimitive;
    let (lo, hi) = ends(text);
    lo.to_f64().unwrap() <= number && number <= hi.to_f64().unwrap() && (hi - lo).to_f64().unwrap() < 1e-9
}

#[test]
fn points_of_equality_are_found_and_proved() {
    let square = || sides(&[(-2, 2), (-2, 3)]);
    assert_eq!(found((x().to(2) - c(2, 1)).to(2), &sides(&[(0, 2)])), Some(vec!["sqrt(2)".into()]));
    let circle = (x().to(2) + y().to(2) - c(1, 1)).to(2) + (x() - y()).to(2);
    let at = found(circle.clone(), &square()).expect("a point");
    assert!(at == ["sqrt(2)/2", "sqrt(2)/2"] || at == ["-sqrt(2)/2", "-sqrt(2)/2"], "{at:?}");
    assert_eq!(found(circle, &lines(2)).map(|at| at.len()), Some(2));
    let at = found((x().to(2) - y()).to(2) + (y() - c(2, 1)).to(2), &square()).expect("a point");
    assert!(["sqrt(2)", "-sqrt(2)"].contains(&at[0].as_str()) && at[1] == "2", "{at:?}");
    // A circle without rational points: one of its numbers is put to a simple one.
    let at = found((x().to(2) + y().to(2) - c(3, 1)).to(2), &square()).expect("a point");
    assert!(at.iter().all(|text| !text.is_empty()), "{at:?}");
    // No closed form.
    let root = 1.213_411_662_762_229_6;
    let cubic = || x().to(3) + x() - c(3, 1);
    for weight in [c(1, 1), x().call("exp"), c(3, 1) + y().to(2)] {
        let at = found(cubic().to(2) + (y() - x()).to(2) * weight, &square()).expect("a point");
        assert!(at.iter().all(|text| contains(text, root)), "{at:?}");
    }
    // No slopes at the point itself.
    for tree in [
        cubic().to(2) + (y() - x()).abs(),
        cubic().abs() + (y() - x()).abs(),
        cubic().abs().root() + (y() - x()).abs(),
        cubic().abs().max((y() - x()).to(2)),
    ] {
        let at = found(tree.clone(), &square()).expect("a point");
        assert!(at.iter().all(|text| contains(text, root)), "{tree:?}: {at:?}");
    }
    let at = found((x().call("cos") - y()).to(2) + (y() - x()).to(2), &sides(&[(0, 1), (0, 1)])).expect("a point");
    assert!(at.iter().all(|text| contains(text, 0.739_085_133_215_160_6)), "{at:?}");
    // The root of a polynomial that is no square as it is written.
    let squared = cubic() * cubic();
    let at = found(squared, &sides(&[(-2, 2)])).expect("a point");
    assert!(contains(&at[0], root), "{at:?}");
    let at = found(x().to(6) - c(4, 1) * x().to(3) + c(4, 1), &sides(&[(-2, 2)]));
    assert_eq!(at, Some(vec!["2^(1/3)".into()]));
    let at = found((x().to(5) * c(3, 1) + c(2, 1)).to(2), &sides(&[(-2, 2)]));
    assert_eq!(at, Some(vec!["-(2/3)^(1/5)".into()]));
    let at = found((x().to(5) - x() - c(1, 1)).to(2), &lines(1)).expect("a point");
    assert!(contains(&at[0], 1.167_303_978_261_418_7), "{at:?}");
}

/// Planted: what is nowhere 0, though nearly; what is 0 outside, or where there is no value.
#[test]
fn no_point_is_said_where_there_is_none() {
    let square = || sides(&[(-2, 2), (-2, 3)]);
    let cube = || x().to(3) - c(2, 1);
    let none: Vec<(Tree, Vec<Side>)> = vec![
        ((x().to(2) - c(2, 1)).to(2) + nano(1), sides(&[(-2, 2)])),
        ((x().to(2) - c(2, 1)).to(2) + (x().to(2) - c(2, 1) - nano(1)).to(2), sides(&[(-2, 2)])),
        (cube().to(2) + nano(1), lines(1)),
        (cube().to(2) + (x() - y()).to(2) + nano(1), square()),
        (cube().to(2) + (x() - y()).to(2) + (x() * y() - x().to(2) - nano(1)).to(2), square()),
        ((x() - y()).to(2) + (x() - y() - nano(1)).to(2), square()),
        ((x().to(2) + y().to(2) + nano(1)).to(2), square()),
        ((x().to(2) + c(1, 1)).to(2) + y().to(2), square()),
        // Outside: 2^(1/3) is 1.2599..
        (cube().to(2), vec![Side::between(rational(-2, 1), rational(1259, 1000))]),
        (cube().to(2) + (x() - y()).to(2), vec![Side::between(rational(-2, 1), rational(1259, 1000)), Side::line()]),
        ((x().to(2) - c(2, 1)).to(2), vec![Side::between(rational(3, 2), rational(2, 1))]),
        // Without a value.
        (cube().to(2) / cube(), sides(&[(1, 2)])),
        (cube().to(2) + (x() - y()).to(2) / cube().to(2), square()),
        (cube() * cube().call("log"), vec![Side::between(rational(1, 1), rational(7, 5))]),
        (cube().call("exp"), sides(&[(-2, 2)])),
        // A product is 0 with one of its factors, a sum is not.
        (cube().to(2) * (y().to(2) + c(1, 1)) + nano(1) * y().to(2) + nano(1), square()),
        ((x() - y()).abs() + cube().abs() + nano(1), square()),
        ((x().to(2) - c(2, 1)).to(2).root() + nano(1), square()),
        ((x() - y()).abs() + cube().to(2) + (x() - y() - nano(1)).abs(), square()),
        (cube().abs().max((x() - y()).abs()) + (x() + y()).abs(), square()),
        ((x() - y()).abs().root() + cube().abs() / cube().abs(), square()),
        (x().max(y()).to(2) + (x() + c(1, 1)).to(2) + (y() + c(1, 1)).to(2), square()),
    ];
    for (tree, domain) in none {
        let said = found(tree.clone(), &domain);
        assert_eq!(said, None, "{tree:?}");
    }
}

/// What has to be strict fails at a point without a closed form, unless another literal is true there.
#[test]
fn strict_inequalities_fail_where_they_are_zero() {
    use super::expression::{above, at_least, decided, other_than};
    let square = || sides(&[(-2, 2), (-2, 3)]);
    let bowl = || (x().to(3) - c(2, 1)).to(2) + (y() - x()).to(2);
    let effort = Effort { boxes: 2000, ..Effort::default() };
    let fails = |clause| matches!(decided(clause, &square(), effort), Decision::FailsAt(_));
    assert!(fails(vec![above(bowl(), c(0, 1))]));
    assert!(fails(vec![other_than(bowl(), c(0, 1))]));
    assert!(fails(vec![above(bowl(), c(0, 1)), above(x(), y() + c(1, 1))]));
    assert!(!fails(vec![above(bowl(), c(0, 1)), at_least(x() + c(1, 1), y())]));
    assert!(!fails(vec![above(bowl() + nano(1), c(0, 1))]));
    let one = |clause| decided(clause, &sides(&[(-2, 2)]), effort);
    let quintic = || (x().to(5) - x() - c(1, 1)).to(2);
    assert!(matches!(one(vec![above(quintic(), c(0, 1))]), Decision::FailsAt(_)));
    assert!(!matches!(
        one(vec![above(quintic(), c(0, 1)), above(x(), c(1, 1))]),
        Decision::FailsAt(_) | Decision::Fails(_)
    ));
}

/// The slow twin, exact: `y = q(x)` and `p(x, q(x)) = 0` is one equation in one number, of which Sturm's chains count the roots between the ends that are told.
#[test]
fn enclosed_points_are_roots_by_another_way() {
    let mut stream = random::generator("polynomials", "attained", 0);
    let (mut enclosed, mut closed) = (0, 0);
    for _ in 0..60 {
        let mut small = || (stream.next_u64() % 7) as i64 - 3;
        let (p, q) = ([small(), small(), small(), small(), small()], [small(), small(), 1 + small().abs()]);
        // p0 + p1 x + p2 y + p3 x y + p4 x^3, y = q0 + q1 x + q2 x^2.
        let curve = c(q[0], 1) + c(q[1], 1) * x() + c(q[2], 1) * x().to(2);
        let other = c(p[0], 1) + c(p[1], 1) * x() + c(p[2], 1) * y() + c(p[3], 1) * x() * y() + c(p[4], 1) * x().to(3);
        let sum = other.to(2) + (y() - curve).to(2);
        let Some(at) = found(sum, &sides(&[(-3, 3), (-9, 9)])) else { continue };
        let line =
            [p[0] + p[2] * q[0], p[1] + p[2] * q[1] + p[3] * q[0], p[2] * q[2] + p[3] * q[1], p[3] * q[2] + p[4]];
        let line = Polynomial::new(line.iter().map(|c| (*c).into()).collect());
        if !at[0].starts_with('[') {
            closed += 1;
            continue;
        }
        let (lo, hi) = ends(&at[0]);
        let roots: usize = line.square_free_factors().iter().map(|(factor, _)| factor.roots_in(&lo, &hi).len()).sum();
        assert_eq!(roots, 1, "{line:?} between {lo} and {hi}");
        enclosed += 1;
    }
    println!("enclosed: {enclosed}, in closed form: {closed}");
    assert!(enclosed >= 10, "{enclosed} and {closed}");
}
