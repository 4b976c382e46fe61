//! The abscissa of polynomials with known roots.

use algebra::spectrum::{Polynomial, complex_abscissa};
use arithmetic::{Complex, Interval, Rational, rational};
use proptest::prelude::*;

type Root = Complex<Rational>;

/// The monic polynomial with these roots, the constant coefficient first.
fn with_roots(roots: &[Root]) -> Vec<Root> {
    let mut coefficients = vec![Complex::real(rational(1, 1))];
    for root in roots {
        let mut next = vec![Complex::real(rational(0, 1)); coefficients.len() + 1];
        for (k, c) in coefficients.iter().enumerate() {
            next[k] = next[k].clone() - c.clone() * root;
            next[k + 1] = next[k + 1].clone() + c;
        }
        coefficients = next;
    }
    coefficients
}

fn roots(most: usize) -> impl Strategy<Value = Vec<Root>> {
    let root = (-60i64..60, -60i64..60).prop_map(|(x, y)| Complex::new(rational(x, 12), rational(y, 7)));
    prop::collection::vec(root, 1..=most)
}

fn largest(roots: &[Root]) -> Rational {
    roots.iter().map(|z| z.re.clone()).max().unwrap()
}

proptest! {
    #[test]
    fn the_abscissa_of_a_complex_polynomial_is_enclosed(roots in roots(4)) {
        let enclosed: Vec<Complex<Interval>> = with_roots(&roots)
            .iter()
            .map(|c| Complex::new(Interval::from_rational(&c.re, 400), Interval::from_rational(&c.im, 400)))
            .collect();
        let found = complex_abscissa(&enclosed, 50).unwrap();
        prop_assert!(found.contains(&largest(&roots)));
        prop_assert!(found.width().to_f64() < 1e-6);
    }

    #[test]
    fn the_abscissa_of_an_integer_polynomial_is_enclosed(half in roots(4)) {
        let both: Vec<Root> = half.iter().flat_map(|z| [z.clone(), z.conj()]).collect();
        let real: Vec<Rational> = with_roots(&both).into_iter().map(|c| c.re).collect();
        let found = Polynomial::from_rationals(&real).abscissa(70).unwrap();
        prop_assert!(found.contains(&largest(&half)));
        prop_assert!(found.width().to_f64() < 1e-6);
    }
}

#[test]
fn constants_have_no_roots() {
    assert!(Polynomial::from_rationals(&[rational(3, 1)]).abscissa(40).is_none());
    assert!(Polynomial::from_rationals(&[]).abscissa(40).is_none());
    assert!(complex_abscissa(&[Complex::real(Interval::from_rational(&rational(1, 1), 64))], 40).is_none());
    assert!(complex_abscissa(&[], 40).is_none());
}

#[test]
fn coefficients_of_little_precision_give_wide_enclosures() {
    // (s + 1)^2 with 20 bits: the enclosure is wide, and right.
    let c =
        |n| Complex::real(Interval::hull_of_rationals(&(rational(n, 1) - rational(1, 1 << 20)), &rational(n, 1), 64));
    let one = Complex::real(Interval::from_rational(&rational(1, 1), 64));
    let found = complex_abscissa(&[c(1), c(2), one], 60).unwrap();
    assert!(found.contains(&rational(-1, 1)));
    assert!(found.width().to_f64() > 1e-9);
}
