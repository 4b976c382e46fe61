//! Cosines and sines as exact numbers, and inertia over them.

use algebra::matrix::{Inertia, RationalMatrix, inertia};
use arithmetic::{Complex, CosineField, Field, Rational, Ring, Sign, Signed, rational};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

#[test]
fn cosines_enclose_floats_and_obey_their_laws() {
    for parts in 1..=30u32 {
        let field = CosineField::new(parts);
        for k in -3..=i64::from(parts) {
            let angle = std::f64::consts::TAU * k as f64 / f64::from(parts);
            let z = field.phasor(k);
            assert!((z.re.enclose(256).unwrap().to_f64() - angle.cos()).abs() < 1e-12, "{parts} {k}");
            assert!((z.im.enclose(256).unwrap().to_f64() - angle.sin()).abs() < 1e-12, "{parts} {k}");
            assert_eq!(z.norm_squared(), z.re.one());
            assert_eq!(z, field.phasor(1).power(k.rem_euclid(i64::from(parts)) as u64));
        }
        let sum =
            (0..i64::from(parts)).fold(Complex::real(field.number(&rational(0, 1))), |sum, k| sum + field.phasor(k));
        assert_eq!(sum, Complex::real(field.number(&rational(i64::from(parts == 1), 1))));
    }
}

#[test]
fn degrees_are_half_of_eulers_function() {
    // lcm(4, parts): 4, 12, 20, 28, 44, 12 with phi 2, 4, 8, 12, 20, 4.
    for (parts, degree) in [(1, 1), (2, 1), (3, 2), (5, 4), (7, 6), (11, 10), (12, 2), (8, 2), (16, 4)] {
        assert_eq!(CosineField::new(parts).degree(), degree, "{parts}");
    }
}

#[test]
fn inverses_and_signs() {
    for parts in [5, 7, 9, 12, 16] {
        let field = CosineField::new(parts);
        for k in 0..i64::from(parts) {
            let x = field.cos(k) * field.number(&rational(3, 2)) + field.sin(2 * k) + field.number(&rational(-1, 7));
            assert_eq!(x.recip().unwrap() * &x, x.one());
            let float = x.enclose(256).unwrap().to_f64();
            assert_eq!(x.sign(), Some(if float > 0.0 { Sign::Positive } else { Sign::Negative }));
        }
        assert!(field.number(&rational(0, 1)).recip().is_err());
        // sin² + cos² - 1 is zero exactly.
        assert_eq!((field.cos(1).square() + field.sin(1).square() - field.cos(0)).sign(), Some(Sign::Zero));
    }
}

#[test]
fn inertia_agrees_with_the_characteristic_polynomial() {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    for case in 0..400 {
        let order = 1 + case % 5;
        // Few different entries, zeros on the diagonal often: singular and indefinite matrices.
        let drawn: Vec<i64> = (0..order * order).map(|_| i64::from(random.next_u32() % 3) - 1).collect();
        let entry = |i: usize, j: usize| match (i, j) {
            _ if i == j && case % 2 == 0 => rational(0, 1),
            _ => rational(drawn[i.max(j) * order + i.min(j)], 1),
        };
        let rows: Vec<Vec<Rational>> = (0..order).map(|i| (0..order).map(|j| entry(i, j)).collect()).collect();
        let zero: Rational = rational(0, 1);
        let polynomial = RationalMatrix::from_rows(&rows).unwrap().characteristic_polynomial().unwrap();
        let expected = Inertia {
            positive: polynomial.count_above(&zero),
            negative: polynomial.count_below(&zero),
            zero: polynomial.multiplicity(&zero),
        };
        assert_eq!(inertia(&rows).unwrap(), expected, "{rows:?}");
    }
}
