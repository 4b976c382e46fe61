//! Intervals of floats: what is exact is exact, what is not is a step wider, what is not finite is the whole line.

use arithmetic::{
    ArithmeticError, Dyadic, Field, FloatInterval, Interval, Number, Rational, Real, Ring, Sign, Signed, rational,
};
use num_bigint::BigInt;
use proptest::prelude::*;

fn exact(x: f64) -> Rational {
    Dyadic::from_f64(x).unwrap().to_rational()
}

const LINE: FloatInterval = FloatInterval::LINE;

fn between(a: f64, b: f64) -> FloatInterval {
    FloatInterval::between(a, b)
}

/// Ends of one step outside of one float.
fn a_step_around(x: f64) -> FloatInterval {
    between(x.next_down(), x.next_up())
}

#[test]
fn what_is_not_finite_is_the_whole_line() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(FloatInterval::point(bad), LINE);
        assert_eq!(between(bad, 1.0), LINE);
        assert_eq!(between(1.0, bad), LINE);
    }
    assert!(!LINE.is_bounded() && between(1.0, 2.0).is_bounded());
    let huge = FloatInterval::point(f64::MAX);
    assert_eq!(huge + huge, LINE);
    assert_eq!(-huge - huge, LINE);
    assert_eq!(huge * huge, LINE);
    for large in [huge, -huge, between(-f64::MAX, 1.0)] {
        assert_eq!((large.square().lo(), large.square().hi()), (0.0, f64::INFINITY));
    }
    assert_eq!(between(1.0, f64::MAX) + huge, LINE);
    assert_eq!(LINE * between(1.0, 2.0), LINE);
    assert_eq!(between(1.0, 2.0) * LINE, LINE);
    assert_eq!(LINE.square(), LINE);
    assert_eq!((LINE.midpoint(), LINE.sign()), (0.0, None));
    assert_eq!(LINE.recip().unwrap_err(), ArithmeticError::DivisionByZero);
}

#[test]
fn zero_and_whole_numbers_are_exact() {
    let (zero, x) = (FloatInterval::point(0.0), between(0.1, 0.3));
    assert_eq!([x + zero, zero + x, x - zero, zero - x], [x, x, x, -x]);
    assert_eq!([x * zero, zero * x, zero * LINE, LINE * zero, zero.square()], [zero; 5]);
    let (from_zero, to_zero) = (between(0.0, 1.0), between(-1.0, 0.0));
    assert_eq!(from_zero + x, between(0.1f64.next_down(), 1.3f64.next_up()));
    assert_eq!(to_zero + x, between((-0.9f64).next_down(), 0.3f64.next_up()));
    assert_eq!(from_zero * x, between(0f64.next_down(), 0.3f64.next_up()));
    assert_eq!(to_zero * x, between((-0.3f64).next_down(), 0f64.next_up()));
    let largest = 1i64 << 53;
    for n in [0, 1, -7, largest, -largest] {
        assert_eq!(x.integer(n), FloatInterval::point(n as f64));
    }
    assert_eq!(x.integer(largest + 1), a_step_around(largest as f64));
    assert_eq!(x.integer(i64::MIN), a_step_around(i64::MIN as f64));
}

#[test]
fn fractions_are_exact_or_a_step_wide() {
    let (x, third) = (FloatInterval::point(0.0), 1.0 / 3.0);
    assert_eq!(x.ratio(3, 4), FloatInterval::point(0.75));
    assert_eq!(x.ratio(-1, -8), FloatInterval::point(0.125));
    assert_eq!(x.ratio(1, 3), a_step_around(third));
    let limit = 1i64 << 53;
    assert_eq!(x.ratio(limit, 1), FloatInterval::point(limit as f64));
    assert_eq!(x.ratio(1, limit), FloatInterval::point(1.0 / limit as f64));
    for (p, q) in [(limit + 1, 3), (3, limit + 1), (limit + 1, 1), (1, limit + 1), (limit, 3), (5, limit - 1)] {
        let (found, q) = (x.ratio(p, q), Rational::new(BigInt::from(p), BigInt::from(q)));
        assert!(exact(found.lo()) <= q && q <= exact(found.hi()), "{q}");
        assert!(found.lo().next_up().next_up().next_up() >= found.hi(), "{q}: {found}");
    }
    // A denominator that is no float moves the quotient by more than a step.
    for p in 1..400 {
        let (p, q) = (p, (3 << 52) + 1);
        let (found, exactly) = (x.ratio(p, q), rational(p, q));
        assert!(exact(found.lo()) <= exactly && exactly <= exact(found.hi()), "{p}/{q}");
    }
    assert_eq!(FloatInterval::from_rational(&rational(3, 4)), FloatInterval::point(0.75));
    for (p, q) in [(1, 3), (-22, 7), (1, 1_000_000_007), (limit + 1, 1)] {
        let found = FloatInterval::from_rational(&rational(p, q));
        assert!(exact(found.lo()) < rational(p, q) && rational(p, q) < exact(found.hi()));
        assert!(found.lo().next_up().next_up().next_up() >= found.hi(), "{p}/{q}: {found}");
        assert_eq!(x.rational(&rational(p, q)), found);
    }
    // Both ends of the enclosure are the same float, which is not the number.
    let near_one = rational(1, 1) + Rational::new(BigInt::from(1), BigInt::from(1) << 70);
    assert_eq!(FloatInterval::from_rational(&near_one), a_step_around(1.0));
}

#[test]
fn signs_and_reciprocals_at_zero() {
    for (x, sign) in [
        (between(0.5, 0.7), Some(Sign::Positive)),
        (between(-0.7, -0.5), Some(Sign::Negative)),
        (between(0.0, 0.0), Some(Sign::Zero)),
        (between(0.0, 0.5), None),
        (between(-0.5, 0.0), None),
        (between(-0.5, 0.5), None),
    ] {
        assert_eq!(x.sign(), sign, "{x}");
        assert_eq!(x.recip().is_err(), x.contains(0.0), "{x}");
    }
    assert_eq!(between(0.25, 0.5).recip().unwrap(), between(2f64.next_down(), 4f64.next_up()));
    assert_eq!(between(-2.0, -1.0).recip().unwrap(), between((-1f64).next_down(), (-0.5f64).next_up()));
}

proptest! {
    #[test]
    fn sets_are_those_of_their_ends(a in -9i32..9, b in -9i32..9, c in -9i32..9, d in -9i32..9) {
        let (x, y) = (between(a.into(), b.into()), between(c.into(), d.into()));
        let ((a, b), (c, d)) = ((f64::from(a.min(b)), f64::from(a.max(b))), (f64::from(c.min(d)), f64::from(c.max(d))));
        prop_assert_eq!((x.lo(), x.hi(), y.lo(), y.hi()), (a, b, c, d));
        let hull = x.hull(&y);
        prop_assert_eq!((hull.lo(), hull.hi()), (a.min(c), b.max(d)));
        let meet = x.intersection(&y).map(|z| (z.lo(), z.hi()));
        prop_assert_eq!(meet, (a.max(c) <= b.min(d)).then_some((a.max(c), b.min(d))));
        for p in [c, d, c - 0.5] {
            prop_assert_eq!(x.contains(p), a <= p && p <= b);
        }
        prop_assert_eq!(x.midpoint(), (a + b) / 2.0);
        prop_assert_eq!(x.magnitude(), a.abs().max(b.abs()));
        prop_assert_eq!(x.width(), if a == b { 0.0 } else { (b - a).next_up() });
        let square = x.square();
        let (near, far) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
        let below = if a <= 0.0 && 0.0 <= b { 0.0 } else { (near * near).next_down().max(0.0) };
        let above = if far == 0.0 { 0.0 } else { (far * far).next_up() };
        prop_assert_eq!((square.lo(), square.hi()), (below, above));
    }

    /// The general intervals contain and compare as their ends do.
    #[test]
    fn general_intervals_contain_what_lies_between_their_ends(a in -9i64..9, b in -9i64..9, c in -9i64..9) {
        let x = Interval::hull_of_rationals(&rational(a, 1), &rational(b, 1), 60);
        for q in [rational(c, 1), rational(a, 1), rational(2 * c + 1, 2)] {
            prop_assert_eq!(x.contains(&q), rational(a.min(b), 1) <= q && q <= rational(a.max(b), 1));
        }
        prop_assert_eq!(x.contains_zero(), a.min(b) <= 0 && 0 <= a.max(b));
        let sign = if a.min(b) > 0 { Some(Sign::Positive) } else if a.max(b) < 0 { Some(Sign::Negative) } else { None };
        prop_assert_eq!(x.sign(), if a == 0 && b == 0 { Some(Sign::Zero) } else { sign });
    }
}

/// Whether the interval contains a rational and ends at most so many floats from it on either side.
fn is_near(x: FloatInterval, q: &Rational, floats: u64) -> bool {
    let steps = |y: f64, step: fn(f64) -> f64| (0..floats).fold(y, |y, _| step(y));
    exact(x.lo()) <= *q
        && *q <= exact(x.hi())
        && exact(steps(x.lo(), f64::next_up)) >= *q
        && exact(steps(x.hi(), f64::next_down)) <= *q
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// Numerators and denominators that no float holds, one or both.
    #[test]
    fn long_fractions_are_enclosed(p in any::<i64>(), q in any::<i64>(), cut in 0u32..11, other in 0u32..11) {
        let (p, q) = (p >> cut, (q >> other) | 1);
        let fraction = rational(p, q);
        prop_assert!(is_near(FloatInterval::from_rational(&fraction), &fraction, 2), "{p}/{q}");
        prop_assert!(is_near(between(0.0, 1.0).ratio(p, q), &fraction, 2), "{p}/{q}");
    }
}

#[test]
fn general_intervals_become_intervals_of_floats() {
    let of = |p: i64, q: i64| {
        let x = Interval::hull_of_rationals(&rational(p, 3), &rational(q, 3), 80);
        (FloatInterval::from_interval(&x), x)
    };
    for (p, q) in [(1, 2), (-2, -1), (-1, 2), (0, 2), (-2, 0)] {
        let (found, x) = of(p, q);
        let (lo, hi) = x.to_rationals();
        assert_ends(found, &lo, &hi);
    }
    assert_eq!(of(0, 0).0, FloatInterval::point(0.0));
    let tenth = Dyadic::from_f64(0.1).unwrap().to_rational();
    let found = FloatInterval::from_rational(&tenth);
    assert_eq!((found.lo(), found.hi()), (0.1, 0.1));
    assert!(!LINE.is_bounded() && between(-1.0, 2.0).is_bounded());
    assert!(![between(1e300, 2e300), between(-2e300, -1e300)].iter().any(|x| (*x * *x).is_bounded()));
}

fn assert_ends(found: FloatInterval, lo: &Rational, hi: &Rational) {
    assert!(exact(found.lo()) <= *lo && *hi <= exact(found.hi()), "{found:?}");
    assert!(exact(found.lo().next_up().next_up()) >= *lo && exact(found.hi().next_down().next_down()) <= *hi);
}

/// The value of a function of a float at 200 bits.
fn finely(x: f64, function: impl Fn(&Interval) -> Interval) -> Interval {
    function(&Interval::from_rational(&exact(x), 200))
}

fn is_around(found: FloatInterval, value: &Interval) -> bool {
    found.is_bounded() && exact(found.lo()) <= value.lo().to_rational() && value.hi().to_rational() <= exact(found.hi())
}

proptest! {
    /// The enclosure over an interval contains the value at every float in it, and is hardly wider than needed at a point.
    #[test]
    fn functions_enclose_their_values(a in -40f64..40.0, width in 0f64..3.0, part in 0f64..1.0) {
        type OfFloats = fn(&FloatInterval) -> Result<FloatInterval, ArithmeticError>;
        type OfIntervals = fn(&Interval) -> Result<Interval, ArithmeticError>;
        let functions: [(OfFloats, OfIntervals, bool); 8] = [
            (Number::sqrt, Number::sqrt, true), (Number::ln, Number::ln, true), (Number::exp, Number::exp, false), (Number::sin, Number::sin, false),
            (Number::cos, Number::cos, false), (Number::atan, Number::atan, false), (Number::cosh, Number::cosh, false),
            (|x| Ok(x.sinh_cosh()?.0), |x| Ok(x.sinh_cosh()?.0), false),
        ];
        for (of_floats, of_intervals, positive) in functions {
            let a = if positive { a.abs() + 1e-9 } else { a };
            let b = a + width;
            let x = (a + part * width).clamp(a, b);
            let over = of_floats(&between(a, b)).unwrap();
            let value = finely(x, |x| of_intervals(x).unwrap());
            prop_assert!(is_around(over, &value));
            let at = of_floats(&FloatInterval::point(x)).unwrap();
            prop_assert!(is_around(at, &value));
            prop_assert!(at.width() <= 8.0 * f64::EPSILON * at.magnitude());
        }
    }
}

#[test]
fn functions_outside_of_their_domains_and_at_their_ends() {
    let zero = FloatInterval::point(0.0);
    assert_eq!(zero.sqrt().unwrap(), zero);
    assert_eq!(zero.exp().unwrap(), FloatInterval::point(1.0));
    assert!(between(0.0, 4.0).sqrt().unwrap().lo() == 0.0);
    assert!(is_around(zero.pi(), &Interval::from_rational(&rational(0, 1), 200).pi()));
    for bad in [between(-1e-300, 1.0), LINE] {
        assert_eq!(bad.sqrt().unwrap_err(), ArithmeticError::Argument("sqrt"));
    }
    assert!(between(0.0, 1.0).ln().is_err() && LINE.ln().is_err() && LINE.exp().is_err() && LINE.atan().is_err());
    let turn = between(0.0, 7.0).sin_cos().unwrap();
    assert!(turn.0.lo() <= -1.0 && turn.0.hi() >= 1.0 && turn.1.lo() <= -1.0 && turn.1.hi() >= 1.0);
    // Numbers beyond the floats become the whole line, never a wrong bound.
    assert!(FloatInterval::point(800.0).exp().unwrap().hi().is_infinite());
}
