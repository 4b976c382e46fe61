//! Power series of fixed length against those of any length, and falls of polynomials with known roots.

use arithmetic::random::{generator, uniform};
use arithmetic::{ArithmeticError, Field, Ring, Series};
use motion::{Jet, first_downcrossing, shifted, value_at};

#[test]
fn jets_are_series() {
    let mut random = generator("series", "jets", 1);
    let mut draw = || -> [f64; 6] { std::array::from_fn(|_| 2.0 * uniform(&mut random) - 1.0) };
    let series = |c: &[f64; 6]| Series::from_coefficients(c[0], c[1..].iter().copied());
    for _ in 0..50 {
        let (a, mut b) = (draw(), draw());
        b[0] += 3.0f64.copysign(b[0]);
        let (s, t, u, v) = (series(&a), series(&b), Jet(a), Jet(b));
        for (long, short) in [
            (s.clone() + &t, u + v),
            (s.clone() - &t, u - v),
            (s.clone() * &t, u * v),
            (-s.clone(), -u),
            (s.square(), u.square()),
            (t.recip().unwrap(), v.recip().unwrap()),
            (s.integer(3), u.integer(3)),
        ] {
            let close = long.coefficients().iter().zip(short.0).all(|(x, y)| (x - y).abs() < 1e-13);
            assert!(close, "{long:?} {short:?}");
        }
    }
    assert_eq!(Jet([0.0, 1.0]).recip(), Err(ArithmeticError::DivisionByZero));
}

/// Coefficients of a product of linear factors.
fn product(roots: &[f64], factor: f64) -> [f64; 8] {
    let mut all = [0.0; 8];
    all[0] = factor;
    for root in roots {
        for k in (0..8).rev() {
            all[k] = (if k > 0 { all[k - 1] } else { 0.0 }) - root * all[k];
        }
    }
    all
}

#[test]
fn falls_are_found() {
    let p = product(&[0.5, 0.75, 2.0], -1.0);
    // Positive before 1/2, negative up to 3/4.
    assert!((first_downcrossing(&p, 1.0).unwrap() - 0.5).abs() < 1e-15);
    assert_eq!(first_downcrossing(&p, 0.499), None);
    let risen = shifted(&p, 0.6);
    assert!((value_at(&risen, -0.1) - value_at(&p, 0.5)).abs() < 1e-15);
    // Two roots so close that the signs at most points say nothing.
    for gap in [1e-2, 1e-4, 1e-6] {
        let p = product(&[0.3, 0.3 + gap, -1.0, 5.0], -1.0);
        let found = first_downcrossing(&p, 1.0).unwrap();
        assert!((found - 0.3).abs() < 1e-15 / gap, "{gap}: {found}");
        let apart = [p[0] + 2.0 * gap * gap, p[1], p[2], p[3], p[4], p[5], p[6], p[7]];
        assert_eq!(first_downcrossing(&apart, 1.0), None, "{gap}");
    }
    // From zero: what rises comes back, what falls is there.
    let back = product(&[0.0, 0.25, 0.5], 1.0);
    assert!((first_downcrossing(&back, 1.0).unwrap() - 0.25).abs() < 1e-15);
    assert_eq!(first_downcrossing(&product(&[0.0, 0.25], 1.0), 1.0), Some(0.0));
    assert_eq!(first_downcrossing(&product(&[0.0, 0.0, 0.5], -1.0), 0.4), None);
    assert!((first_downcrossing(&product(&[0.0, 0.0, 0.5], -1.0), 1.0).unwrap() - 0.5).abs() < 1e-15);
    assert_eq!(first_downcrossing(&[0.0; 4], 1.0), None);
    // Against many points.
    let mut random = generator("series", "falls", 1);
    for _ in 0..300 {
        let mut p: [f64; 7] = std::array::from_fn(|_| 2.0 * uniform(&mut random) - 1.0);
        p[0] = 0.2 * uniform(&mut random);
        let points = (1..=20_000).map(|k| 1.7 * f64::from(k) / 20_000.0);
        let seen = points.clone().find(|x| value_at(&p, *x) < 0.0);
        match (first_downcrossing(&p, 1.7), seen) {
            (Some(found), Some(seen)) => assert!(found <= seen && found > seen - 1e-4, "{found} {seen}"),
            (None, None) => {}
            // A dip between two of the points.
            (Some(found), None) => assert!(value_at(&p, found).abs() < 1e-7, "{found}"),
            (None, Some(seen)) => panic!("{p:?} at {seen}"),
        }
    }
}
