//! Potentials as sums of powers: multiples, slopes and curvatures, minima, Definition 3.

use arithmetic::{ArithmeticError, Interval, Rational, rational};
use models::double_integrator::{Potential, PotentialError};

fn potentials() -> Vec<Potential> {
    vec![
        Potential::inverse_square_log(&rational(3, 2)),
        Potential::inverse_square_spring(&rational(5, 1), &rational(2, 3)),
        Potential::with_inflection(&rational(3, 1)),
        Potential::new(
            vec![(2, rational(1, 1)), (-2, rational(-1, 1)), (-1, rational(1, 2))],
            (rational(2, 1), rational(7, 1)),
        ),
    ]
}

#[test]
fn a_multiple_has_the_multiple_of_every_value() {
    for potential in potentials() {
        let times = potential.times(&rational(3, 7));
        for s in [rational(1, 3), rational(1, 1), rational(3, 2), rational(9, 1)] {
            let over = |p: &Potential| p.value(&Interval::from_rational(&s, 200)).expect("a value");
            let difference = over(&potential) * Interval::from_rational(&rational(3, 7), 200) - over(&times);
            let (lo, hi) = difference.to_rationals();
            assert!(lo <= rational(0, 1) && rational(0, 1) <= hi, "{potential:?} at {s}");
            assert_eq!(times.slope(&s), potential.slope(&s).map(|x| x * rational(3, 7)));
            assert_eq!(times.curvature(&s), potential.curvature(&s).map(|x| x * rational(3, 7)));
        }
    }
}

#[test]
fn values_slopes_and_curvatures_are_those_of_closed_forms() {
    // m/s + log(s/m), stiffness (s/m + m/s - 2), and the sum of powers written out.
    let (m, s) = (rational(3, 2), rational(4, 1));
    let log = Potential::inverse_square_log(&m);
    assert_eq!(log.slope(&s), Ok(rational(1, 1) / &s - &m / (&s * &s)));
    assert_eq!(log.curvature(&s), Ok(rational(2, 1) * &m / (&s * &s * &s) - rational(1, 1) / (&s * &s)));
    let spring = Potential::inverse_square_spring(&rational(5, 1), &rational(2, 3));
    let at = Interval::from_rational(&rational(10, 1), 100);
    let (lo, hi) = spring.value(&at).expect("a value").to_rationals();
    let value = rational(2, 3) * (rational(2, 1) + rational(1, 2) - rational(2, 1));
    assert!(lo <= value && value <= hi);
}

/// Terms with the coefficient 0 count for nothing, and the value may be given anywhere.
#[test]
fn ends_and_minimum_are_those_of_the_terms_that_are_there() {
    let of = |terms: &[(i32, i64)], at: i64, value: i64| {
        let slope = terms.iter().map(|&(k, c)| (k, rational(c, 1))).collect();
        Potential::new(slope, (rational(at, 1), rational(value, 1)))
    };
    let padded = of(&[(-3, 0), (-2, -1), (0, 1), (4, 0)], 1, 0);
    assert!(padded.repels() && padded.confines() && padded.check_definition3() == Ok(()));
    assert_eq!(of(&[(0, -1), (1, 1)], 1, 1).check_definition3(), Err(PotentialError::NoRepulsion));
    // s + 1/s - 5/2 and s + 1/s - 2, by their values at 2 and at 1.
    assert_eq!(of(&[(-2, -1), (0, 1)], 2, 0).check_definition3(), Err(PotentialError::Negative));
    assert_eq!(of(&[(-2, -1), (0, 1)], 1, 0).check_definition3(), Ok(()));
    assert_eq!(Potential::with_inflection(&rational(3, 1)).rational_value(&rational(1, 1)), Ok(rational(0, 1)));
    let (numerator, power) = of(&[(2, 3)], 1, 0).slope_numerator();
    assert_eq!((numerator.coefficients().len(), power), (3, 0));
}

#[test]
fn minima_are_found_in_order_and_decide_definition_3() {
    let critical = |p: &Potential| p.critical();
    assert_eq!(
        critical(&Potential::inverse_square_spring(&rational(10, 1), &rational(1, 1))),
        Some(vec![rational(10, 1)])
    );
    assert_eq!(critical(&Potential::with_inflection(&rational(3, 1))), Some(vec![rational(1, 1), rational(3, 1)]));
    let constant = Potential::new(Vec::new(), (rational(1, 1), rational(0, 1)));
    assert_eq!(critical(&constant), None);
    // Slope (s - 1)(s - 2)(s - 3)/s^2, two minima.
    let cubic = |c: &[i64]| -> Vec<(i32, Rational)> { (-2..).zip(c).map(|(k, &c)| (k, rational(c, 1))).collect() };
    let two_minima = Potential::new(cubic(&[-6, 11, -6, 1]), (rational(1, 1), rational(1, 1)));
    assert_eq!(critical(&two_minima), Some(vec![rational(1, 1), rational(2, 1), rational(3, 1)]));
    assert_eq!(two_minima.check_definition3(), Err(PotentialError::Minimum));
    // Slope (s - 1)^2 (s - 3)/s^2: the double zero comes first.
    let double_first = Potential::new(cubic(&[-3, 7, -5, 1]), (rational(1, 1), rational(1, 1)));
    assert_eq!(critical(&double_first), Some(vec![rational(1, 1), rational(3, 1)]));
    // Slope (s - 2)/s^2 = 1/s - 2/s^2 with value -1/100 or 0 at its minimum.
    let slope = cubic(&[-2, 1]);
    let with = |value: Rational| Potential::new(slope.clone(), (rational(2, 1), value)).check_definition3();
    assert_eq!(with(rational(0, 1)), Ok(()));
    assert_eq!(with(rational(-1, 100)), Err(PotentialError::Negative));
    // Bounded at 0, and bounded at infinity.
    let of = |terms: &[(i32, i64)]| {
        let slope = terms.iter().map(|&(k, c)| (k, rational(c, 1))).collect();
        Potential::new(slope, (rational(1, 1), rational(1, 1))).check_definition3()
    };
    assert_eq!(of(&[(0, 1)]), Err(PotentialError::NoRepulsion));
    assert_eq!(of(&[(-2, -1), (-3, 1)]), Err(PotentialError::NoRepulsion));
    assert_eq!(of(&[(-3, -1), (-2, 1)]), Err(PotentialError::Bounded));
    assert_eq!(of(&[(-2, -1), (0, -1)]), Err(PotentialError::Bounded));
    // 1/s diverges at both ends: log(s) alone is unbounded below, and 1/s + log s is a potential.
    assert_eq!(of(&[(-1, 1)]), Err(PotentialError::NoRepulsion));
    assert_eq!(of(&[(-2, -1), (-1, 1)]), Ok(()));
}

#[test]
fn the_numerator_of_a_slope_is_it_times_the_least_power_that_makes_it_a_polynomial() {
    let of = |terms: &[(i32, i64)]| {
        let slope = terms.iter().map(|&(k, c)| (k, rational(c, 1))).collect();
        let (numerator, power) = Potential::new(slope, (rational(1, 1), rational(1, 1))).slope_numerator();
        (numerator.coefficients().iter().map(ToString::to_string).collect::<Vec<_>>().join(" "), power)
    };
    assert_eq!(of(&[(1, 1), (2, 3)]), ("0 1 3".to_string(), 0));
    assert_eq!(of(&[(-2, -5), (0, 1)]), ("-5 0 1".to_string(), 2));
    assert_eq!(of(&[(-3, 1), (-2, -2)]), ("1 -2".to_string(), 3));
}

#[test]
fn the_largest_exponent_has_no_integral() {
    let potential = |k: i32| Potential::new(vec![(k, rational(1, 1))], (rational(1, 1), rational(0, 1)));
    assert!(matches!(potential(i32::MAX).value(&1.0), Err(ArithmeticError::Domain(_))));
    assert_eq!((potential(i32::MAX).slope(&1.0), potential(i32::MAX - 1).value(&1.0)), (Ok(1.0), Ok(0.0)));
    assert_eq!(potential(i32::MIN).value(&1.0), Ok(0.0));
}
