//! Complex, dual and series numbers over exact rationals; derivatives along a flow.

use arithmetic::{
    ArithmeticError, Complex, Dual, Field, FloatInterval, Interval, Number, Rational, Ring, Series, Sign, Signed,
    along_flow, gradient, rational,
};
use proptest::prelude::*;

fn small() -> impl Strategy<Value = Rational> {
    (-30i64..30, 1i64..9).prop_map(|(p, q)| rational(p, q))
}

fn gaussian() -> impl Strategy<Value = Complex<Rational>> {
    (small(), small()).prop_map(|(re, im)| Complex::new(re, im))
}

proptest! {
    #[test]
    fn gaussian_rationals_are_a_field(a in gaussian(), b in gaussian(), c in gaussian()) {
        prop_assert_eq!(a.clone() * (b.clone() + &c), a.clone() * &b + a.clone() * &c);
        prop_assert_eq!(a.square(), a.clone() * &a);
        prop_assert_eq!((a.clone() * &b).norm_squared(), a.norm_squared() * b.norm_squared());
        prop_assert_eq!(a.dot(&b), (a.conj() * &b).re);
        prop_assert_eq!(a.scale(&b.re), a.clone() * Complex::real(b.re.clone()));
        prop_assert_eq!(a.rational(&b.re), Complex::real(b.re.clone()));
        match b.recip() {
            Ok(inverse) => prop_assert_eq!(b.clone() * inverse, b.one()),
            Err(error) => {
                prop_assert_eq!(error, ArithmeticError::DivisionByZero);
                prop_assert_eq!(b.clone(), b.zero());
            }
        }
    }

    /// d/dx of x^n / (1 + x²), by duals and by hand.
    #[test]
    fn dual_numbers_differentiate_exactly(x in small(), n in 1u64..6) {
        let dual = Dual::new(x.clone(), x.one());
        let denominator = dual.square() + dual.one();
        let quotient = dual.power(n).over(&denominator).unwrap();
        let d = denominator.value.clone();
        let by_hand = (x.integer(n as i64) * x.power(n - 1) * &d - x.power(n) * x.integer(2) * &x) / d.square();
        prop_assert_eq!(quotient.derivative, by_hand);
    }

    /// Series of 1/(1 - h)² has coefficients 1, 2, 3, ...
    #[test]
    fn series_invert(order in 2usize..12) {
        let h = Series::variable(rational(1, 1), order);
        let inverse = (h.one() - &h).square().recip().unwrap();
        for (n, c) in inverse.coefficients().iter().enumerate() {
            prop_assert_eq!(c, &rational(n as i64 + 1, 1));
        }
        prop_assert_eq!(inverse.coefficients().len(), order);
    }
}

/// The energy of a harmonic oscillator x'' = -k x is conserved; with friction -c v it changes at the rate -c v².
#[test]
fn derivative_along_a_flow() {
    let (k, c) = (rational(3, 2), rational(1, 5));
    let (x, v) = (rational(7, 3), rational(-2, 9));
    let velocity = [v.clone(), -(k.clone() * &x) - c.clone() * &v];
    let energy = |s: &[Dual<Rational>]| {
        let half = s[0].ratio(1, 2);
        Ok(half.clone() * s[1].square() + half * s[0].rational(&k) * s[0].square())
    };
    assert_eq!(along_flow(&[x.clone(), v.clone()], &velocity, energy).unwrap(), -c * v.square());
    assert_eq!(gradient(&[x.clone(), v.clone()], energy).unwrap(), vec![k.clone() * x, v]);
}

/// Duals over intervals: d/dx of every elementary function against its known derivative.
#[test]
fn duals_over_intervals_know_the_elementary_functions() {
    let x = Interval::from_rational(&rational(5, 7), 120);
    let dual = Dual::new(x.clone(), x.one());
    let (sin, cos) = x.sin_cos().unwrap();
    let (sinh, cosh) = x.sinh_cosh().unwrap();
    let pairs = [
        (dual.exp().unwrap(), x.exp().unwrap()),
        (dual.ln().unwrap(), x.recip().unwrap()),
        (dual.sin().unwrap(), cos),
        (dual.cos().unwrap(), -sin),
        (dual.atan().unwrap(), (x.square() + x.one()).recip().unwrap()),
        (dual.cosh().unwrap(), sinh),
        (dual.sinh_cosh().unwrap().0, cosh),
        (dual.sqrt().unwrap(), (x.integer(2) * x.sqrt().unwrap()).recip().unwrap()),
    ];
    for (k, (computed, expected)) in pairs.iter().enumerate() {
        assert!(computed.derivative.overlaps(expected), "function {k}");
        assert!(computed.derivative.width().top() < -100, "function {k} is wide");
    }
    let values = [(dual.ln(), x.ln()), (dual.atan(), x.atan()), (dual.exp(), x.exp()), (dual.sqrt(), x.sqrt())];
    for (dual, value) in values {
        let (a, b) = (dual.unwrap().value, value.unwrap());
        assert_eq!((a.lo(), a.hi()), (b.lo(), b.hi()));
    }
}

/// Every function of a series, at random coefficients: its inverse or its defining equation gives the series back, and its value is that of the sum for a small argument.
#[test]
fn functions_of_series_are_those_of_their_sums() {
    let mut random = arithmetic::random::generator("series", "functions", 0);
    for _ in 0..50 {
        let mut coefficient = || 2.0 * arithmetic::random::uniform(&mut random) - 1.0;
        let series = Series::from_coefficients(1.5 + coefficient(), (0..7).map(|_| coefficient()));
        let h = 0.01;
        let sum = |s: &Series<f64>| s.coefficients().iter().rev().fold(0.0, |sum, c| sum * h + c);
        let x = sum(&series);
        let (sin, cos) = series.sin_cos().unwrap();
        let (sinh, cosh) = series.sinh_cosh().unwrap();
        for (found, wanted) in [
            (series.sqrt().unwrap(), x.sqrt()),
            (series.exp().unwrap(), x.exp()),
            (series.ln().unwrap(), x.ln()),
            (series.atan().unwrap(), x.atan()),
            (sin.clone(), x.sin()),
            (cos.clone(), x.cos()),
            (sinh, x.sinh()),
            (cosh, x.cosh()),
        ] {
            // What is left out is of order h^8, with coefficients that stay below 10^3.
            assert!((sum(&found) - wanted).abs() < 1e-12 * (1.0 + wanted.abs()), "{found:?}");
        }
        for (one, other) in [
            (series.sqrt().unwrap().square(), series.clone()),
            (series.exp().unwrap().ln().unwrap(), series.clone()),
            (sin.square() + cos.square(), series.one()),
        ] {
            for (a, b) in one.coefficients().iter().zip(other.coefficients()) {
                assert!((a - b).abs() < 1e-9, "{a} {b}");
            }
        }
    }
}

/// Over enclosures the coefficients contain those of a point inside.
#[test]
fn functions_of_enclosed_series_contain_those_of_their_points() {
    let of = |x: f64, w: f64| {
        Series::from_coefficients(FloatInterval::between(x - w, x + w), [FloatInterval::point(0.5); 5])
    };
    for x in [0.3, 1.0, 2.7] {
        let (point, around) = (of(x, 0.0), of(x, 0.01));
        type Function = fn(&Series<FloatInterval>) -> Result<Series<FloatInterval>, ArithmeticError>;
        for function in
            [Number::sqrt, Number::exp, Number::ln, Number::atan, Number::sin, Number::cosh] as [Function; 6]
        {
            let (inner, outer) = (function(&point).unwrap(), function(&around).unwrap());
            for (a, b) in inner.coefficients().iter().zip(outer.coefficients()) {
                assert!(b.lo() <= a.lo() && a.hi() <= b.hi());
            }
        }
    }
    assert!(of(0.0, 0.0).sqrt().is_err() && of(0.0, 0.1).ln().is_err());
}

#[test]
fn signs_of_series_and_duals_are_told_where_they_stay() {
    let series = |a: i64, b: i64| Series::from_coefficients(rational(a, 1), [rational(b, 1)]);
    let signs = [series(1, -9).sign(), series(-1, 9).sign(), series(0, 0).sign(), series(0, 1).sign()];
    assert_eq!(signs, [Some(Sign::Positive), Some(Sign::Negative), Some(Sign::Zero), None]);
    let dual = |a: i64, b: i64| Dual::new(rational(a, 1), rational(b, 1));
    let signs = [dual(1, -9).sign(), dual(-1, 9).sign(), dual(0, 0).sign(), dual(0, 1).sign()];
    assert_eq!(signs, [Some(Sign::Positive), Some(Sign::Negative), Some(Sign::Zero), None]);
}
