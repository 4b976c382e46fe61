//! The two shapes of test of certified arithmetic: the interval contains the exact value, and two ways to compute the
//! same thing overlap; at random precision.

use arithmetic::{ArithmeticError, Field, FloatInterval, Interval, Number, Rational, Real, Ring, Signed, rational};
use num_bigint::BigInt;
use num_traits::Signed as _;
use proptest::prelude::*;

/// Rationals of very different sizes, zero among them.
fn any_rational() -> impl Strategy<Value = Rational> {
    (any::<i64>(), 1..i64::MAX, -80i32..80, 0u32..4).prop_map(|(p, q, shift, form)| {
        let base = match form {
            0 => Rational::from_integer(BigInt::from(p >> 50)),
            1 => Rational::new(BigInt::from(p), BigInt::from(q)),
            2 => Rational::new(BigInt::from(p >> 40), BigInt::from(1u64 << 20)),
            _ => Rational::new(BigInt::from(p >> 55), BigInt::from(q >> 50 | 1)),
        };
        let power = Rational::from_integer(BigInt::from(1) << shift.unsigned_abs());
        if shift < 0 { base / power } else { base * power }
    })
}

/// An interval with a rational point inside.
fn interval_with_point() -> impl Strategy<Value = (Interval, Rational)> {
    (any_rational(), any_rational(), 0u32..=4, 8u32..300).prop_map(|(a, b, weight, precision)| {
        let inside = &a + (&b - &a) * rational(i64::from(weight), 4);
        (Interval::hull_of_rationals(&a, &b, precision), inside)
    })
}

/// A thin interval around a rational of moderate size.
fn moderate() -> impl Strategy<Value = (Interval, Rational)> {
    (any::<i32>(), 1..1_000_000i64, 8u32..300).prop_map(|(p, q, precision)| {
        let x = rational(i64::from(p) >> 12, q) * rational(1, 4);
        let x = if x.abs() > rational(1000, 1) { x * rational(1, 100_000) } else { x };
        (Interval::from_rational(&x, precision), x)
    })
}

fn assert_overlap(left: &Interval, right: &Interval, what: &str) -> Result<(), TestCaseError> {
    prop_assert!(left.overlaps(right), "{what}: {left:?} and {right:?} do not overlap");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn ring_operations_contain_the_exact_value((x, a) in interval_with_point(), (y, b) in interval_with_point()) {
        prop_assert!((x.clone() + &y).contains(&(&a + &b)));
        prop_assert!((x.clone() - &y).contains(&(&a - &b)));
        prop_assert!((x.clone() * &y).contains(&(&a * &b)));
        prop_assert!(x.square().contains(&(&a * &a)));
        prop_assert!((-x.clone()).contains(&-a.clone()));
        prop_assert!(x.power(5).contains(&a.power(5)));
        prop_assert!(!x.square().is_certainly_negative());
    }

    #[test]
    fn division_contains_the_exact_value_or_refuses((x, a) in interval_with_point(), (y, b) in interval_with_point()) {
        match x.over(&y) {
            Ok(quotient) => prop_assert!(quotient.contains(&(&a / &b))),
            Err(error) => {
                prop_assert_eq!(error, ArithmeticError::DivisionByZero);
                prop_assert!(y.contains_zero());
            }
        }
    }

    #[test]
    fn endpoints_keep_to_the_precision((x, _) in interval_with_point(), (y, _) in interval_with_point()) {
        for z in [x.clone() + &y, x.clone() * &y, x.square()] {
            prop_assert!(z.lo().mantissa().bits() <= u64::from(z.precision()));
            prop_assert!(z.hi().mantissa().bits() <= u64::from(z.precision()));
            prop_assert!(z.lo() <= z.hi());
        }
    }

    #[test]
    fn square_root_contains_and_is_tight(a in any_rational(), precision in 8u32..300) {
        let a = a.abs();
        let square = Interval::from_rational(&(&a * &a), precision);
        let root = square.sqrt().unwrap();
        prop_assert!(root.contains(&a));
        let slack = &a * Rational::new(BigInt::from(8), BigInt::from(1) << precision);
        prop_assert!(root.width().to_rational() <= slack);
    }

    #[test]
    fn sign_is_never_wrong((x, a) in interval_with_point()) {
        if let Some(sign) = x.sign() {
            prop_assert_eq!(Some(sign), a.sign());
        }
    }

    #[test]
    fn exp_and_ln_are_inverse((x, a) in moderate()) {
        let forth = x.exp().unwrap();
        prop_assert!(forth.is_certainly_positive());
        prop_assert!(forth.ln().unwrap().contains(&a));
        assert_overlap(&(forth.clone() * (-x.clone()).exp().unwrap()), &x.one(), "exp(x) exp(-x) = 1")?;
        assert_overlap(&(x.clone() + &x).exp().unwrap(), &forth.square(), "exp(2x) = exp(x)²")?;
    }

    #[test]
    fn sine_and_cosine_satisfy_their_identities((x, _) in moderate()) {
        let (sin, cos) = x.sin_cos().unwrap();
        assert_overlap(&(sin.square() + cos.square()), &x.one(), "sin² + cos² = 1")?;
        let (sin2, cos2) = (x.clone() + &x).sin_cos().unwrap();
        let product = sin.clone() * &cos;
        assert_overlap(&sin2, &(product.clone() + product), "sin 2x = 2 sin x cos x")?;
        assert_overlap(&cos2, &(cos.square() - sin.square()), "cos 2x = cos² - sin²")?;
        let (shifted, _) = (x.clone() + x.pi()).sin_cos().unwrap();
        assert_overlap(&shifted, &-sin, "sin(x + pi) = -sin x")?;
    }

    #[test]
    fn atan_inverts_the_tangent((x, a) in moderate()) {
        let angle = x.atan().unwrap();
        let (sin, cos) = angle.sin_cos().unwrap();
        prop_assert!(sin.over(&cos).unwrap().contains(&a));
        assert_overlap(&-angle, &(-x).atan().unwrap(), "atan is odd")?;
    }

    #[test]
    fn hyperbolic_functions_satisfy_their_identities((x, _) in moderate()) {
        let (sinh, cosh) = x.sinh_cosh().unwrap();
        assert_overlap(&(cosh.square() - sinh.square()), &x.one(), "cosh² - sinh² = 1")?;
        assert_overlap(&(cosh + sinh), &x.exp().unwrap(), "cosh + sinh = exp")?;
    }

    #[test]
    fn more_bits_stay_inside_fewer((x, _) in moderate()) {
        let fine = x.midpoint(400);
        let coarse = fine.with_precision(40);
        for f in [Number::exp, Number::atan, Number::sin, Number::cos, Number::cosh] {
            let (outer, inner) = (f(&coarse).unwrap(), f(&fine).unwrap());
            prop_assert!(outer.overlaps(&inner), "{outer:?} against {inner:?}");
        }
    }

    /// A function of a wide interval contains the function at every point of it.
    #[test]
    fn wide_arguments_contain_their_points(a in -900i64..900, width in 1i64..700, weight in 0i64..=8) {
        let (lo, hi) = (rational(a, 100), rational(a + width, 100));
        let wide = Interval::hull_of_rationals(&lo, &hi, 90);
        let point = Interval::from_rational(&(&lo + (&hi - &lo) * rational(weight, 8)), 140);
        let (sin, cos) = wide.sin_cos().unwrap();
        let (sin_at, cos_at) = point.sin_cos().unwrap();
        prop_assert!(sin.encloses(&sin_at) && cos.encloses(&cos_at));
        prop_assert!(wide.cosh().unwrap().encloses(&point.cosh().unwrap()));
        prop_assert!(wide.exp().unwrap().encloses(&point.exp().unwrap()));
    }
}

#[test]
fn results_are_as_tight_as_the_precision() {
    for precision in [53u32, 100, 333, 1000] {
        for (p, q) in [(1, 3), (-7, 5), (22, 7), (1, 1_000_000_007), (99, 1)] {
            let x = Interval::from_rational(&rational(p, q), precision + 20);
            let mut results = vec![x.pi(), x.exp().unwrap(), x.atan().unwrap(), x.sin().unwrap(), x.cosh().unwrap()];
            if p > 0 {
                results.push(x.ln().unwrap());
            }
            for (k, y) in results.iter().enumerate() {
                let relative = y.width().top() - y.magnitude().top();
                assert!(relative < -i64::from(precision), "function {k} at {p}/{q}: 2^{relative}, {precision} bits");
            }
        }
    }
}

#[test]
fn edges_of_the_domains() {
    let zero = Interval::from_rational(&rational(0, 1), 60);
    let minus = Interval::from_rational(&rational(-1, 1), 60);
    let around = Interval::hull_of_rationals(&rational(-1, 1), &rational(1, 1), 60);
    assert_eq!(zero.recip().unwrap_err(), ArithmeticError::DivisionByZero);
    assert_eq!(around.recip().unwrap_err(), ArithmeticError::DivisionByZero);
    assert_eq!(minus.sqrt().unwrap_err(), ArithmeticError::Argument("sqrt"));
    assert_eq!(zero.ln().unwrap_err(), ArithmeticError::Argument("ln"));
    assert!(zero.sqrt().unwrap().contains(&rational(0, 1)));
    assert!(zero.exp().unwrap().contains(&rational(1, 1)));
    assert!(around.square().contains(&rational(0, 1)) && !around.square().contains(&rational(-1, 1000)));
    assert_eq!(around.sign(), None);
    let huge = Interval::from_rational(&Rational::from_integer(BigInt::from(1) << 40), 60);
    assert_eq!(huge.exp().unwrap_err(), ArithmeticError::Argument("exp"));
    assert!((-huge.clone()).exp().unwrap().to_rationals().0 == rational(0, 1));
    let (sin, _) = Interval::from_rational(&Rational::from_integer(BigInt::from(1) << 70), 60).sin_cos().unwrap();
    assert!(sin.contains(&rational(1, 1)) && sin.contains(&rational(-1, 1)));
}

/// Between two extremes of one kind the other one is not added, and angles up to 2^60 are reduced.
#[test]
fn sines_of_wide_and_of_large_angles_are_sharp() {
    let above = |x: &Interval, p: i64| x.to_rationals().0 > rational(p, 10);
    let (sin, _) = Interval::hull_of_rationals(&rational(1, 1), &rational(2, 1), 60).sin_cos().unwrap();
    assert!(above(&sin, 8) && sin.contains(&rational(1, 1)));
    let (sin, cos) = Interval::hull_of_rationals(&rational(-2, 1), &rational(-1, 1), 60).sin_cos().unwrap();
    assert!(above(&-sin, 8) && above(&cos, -5));
    let (_, cos) = Interval::hull_of_rationals(&rational(3, 1), &rational(7, 2), 60).sin_cos().unwrap();
    assert!(above(&-cos, 9));
    let large = Interval::from_rational(&rational((1 << 60) - 1, 1), 200);
    let (sin, cos) = large.sin_cos().unwrap();
    assert!(sin.width().top() < -100 && cos.width().top() < -100);
}

/// Many bits: the count of lost units must not overflow.
#[test]
fn exp_at_many_bits() {
    for (precision, finer) in [(14_500, 16_000), (60_000, 62_000)] {
        for x in [rational(3, 5), rational(3_400_000_001, 10_000_000_000), rational(-3, 5)] {
            let coarse = Interval::from_rational(&x, precision).exp().unwrap();
            let fine = Interval::from_rational(&x, finer).exp().unwrap();
            assert!(coarse.overlaps(&fine));
            assert!(coarse.width().top() - coarse.magnitude().top() < 4 - i64::from(precision));
            let back = Interval::from_rational(&-x.clone(), precision).exp().unwrap();
            assert!((coarse * back).contains(&rational(1, 1)));
        }
    }
}

/// Adding numbers 10^6 bits apart costs no memory and still rounds outward.
#[test]
fn far_apart_operands() {
    let one = Interval::from_rational(&rational(1, 1), 60);
    let tiny = Interval::from_rational(&Rational::new(BigInt::from(1), BigInt::from(1) << 1_000_000), 60);
    let sum = one.clone() + &tiny;
    assert!(sum.lo().to_rational() == rational(1, 1) && sum.hi().to_rational() > rational(1, 1));
    let difference = one - tiny;
    assert!(difference.lo().to_rational() < rational(1, 1) && difference.hi().to_rational() == rational(1, 1));
}

/// Ends are rounded outward, to places after the point where the format says how many.
#[test]
fn intervals_print_what_they_enclose() {
    let third = Interval::from_rational(&rational(1, 3), 64);
    assert_eq!(format!("{third:.5}"), "[0.33333, 0.33334]");
    assert_eq!(format!("{:.2}", -third.clone()), "[-0.34, -0.33]");
    assert_eq!(format!("{:.0}", -third.clone()), "[-1, 0]");
    assert_eq!(third.to_string(), "[0.33333333333333333331, 0.33333333333333333335]");
    let exact = Interval::from_rational(&rational(-5, 4), 64);
    assert_eq!(format!("{exact} {exact:.3} {exact:.1}"), "[-1.25, -1.25] [-1.250, -1.250] [-1.3, -1.2]");
    assert_eq!(format!("{:.3}", FloatInterval::between(-0.0625, 1e3)), "[-0.063, 1000.000]");
    assert_eq!(FloatInterval::point(0.5).to_string(), "[0.5, 0.5]");
    assert_eq!(FloatInterval::LINE.to_string(), "[-inf, inf]");
}

#[test]
fn errors_say_what_is_wrong() {
    assert_eq!(ArithmeticError::Argument("ln").to_string(), "the argument of ln lies outside its domain");
    assert_eq!(ArithmeticError::Domain("two variables").to_string(), "this needs two variables");
}
