//! Functions that were computed as quotients of polynomials, decided as functions.

use arithmetic::{Field, Number, Rational, Ring, Unwatched, rational};
use polynomials::decide::{Decision, Effort, decide};
use polynomials::{Compared, Extension, Function, Literal, Side, Symbolic};

fn decided(function: &Symbolic, compared: Compared, range: (i64, i64, i64)) -> Decision {
    let literal = Literal { function: function.clone(), compared, guarded: true };
    let side = Side::between(rational(range.0, range.2), rational(range.1, range.2));
    decide(&[literal], &[side], Effort { boxes: 200, squares: false, certified: false, conditions: false }, &Unwatched)
        .expect("not stopped")
}

/// The cosine and the sine by the tangent of half the angle: their product is 1/2 where that is the root of two less one.
#[test]
fn a_quotient_is_decided_where_it_is_touched_at_an_irrational_number() {
    let s = Extension::new(1).arguments().remove(0);
    let size = (s.square() + s.one()).recip().unwrap();
    let (cosine, sine) = ((s.one() - s.square()) * &size, s.clone() * s.integer(2) * &size);
    let below = s.ratio(1, 2) - cosine.clone() * &sine;
    for range in [(2, 3, 7), (41421, 41422, 100_000), (414_213_562, 414_213_563, 1_000_000_000)] {
        assert!(matches!(decided(&below, Compared::NotNegative, range), Decision::Holds(_)), "{range:?}");
        assert!(!matches!(decided(&below, Compared::Positive, range), Decision::Holds(_)), "{range:?}");
        let lower = below.clone() - s.ratio(1, 1_000_000_000_000);
        assert!(!matches!(decided(&lower, Compared::NotNegative, range), Decision::Holds(_)), "{range:?}");
    }
    // What a function is at points is what it was computed from.
    let at = |q: &Rational| below.value(std::slice::from_ref(q)).unwrap();
    for (p, q) in [(0, 1), (1, 3), (-7, 2)] {
        let u = rational(p, q);
        let d = u.square() + rational(1, 1);
        let naive = rational(1, 2) - (rational(1, 1) - u.square()) * (&u * rational(2, 1)) / (&d * &d);
        assert_eq!(at(&u), naive);
    }
    // Roots, absolute values and exponentials.
    let distance = (s.square() + s.one()).sqrt().unwrap() - (s.clone() - s.one()).size();
    let value = distance.value(&[-2.0]).unwrap();
    assert!((value - (5f64.sqrt() - 3.0)).abs() < 1e-12, "{value}");
    assert!((s.exp().unwrap().value(&[1.0]).unwrap() - 1f64.exp()).abs() < 1e-12);
}
