//! Routh's table against polynomials with known roots.

use algebra::spectrum::Polynomial;
use arithmetic::{Rational, rational};

fn of(coefficients: &[i64]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(|&c| c.into()).collect())
}

/// A product of factors, the constant coefficients first.
fn product(factors: &[&[i64]]) -> Vec<i64> {
    factors.iter().fold(vec![1], |product, factor| {
        let mut next = vec![0; product.len() + factor.len() - 1];
        for (i, a) in product.iter().enumerate() {
            factor.iter().enumerate().for_each(|(j, b)| next[i + j] += a * b);
        }
        next
    })
}

#[test]
fn stable_products_and_those_with_one_unstable_factor() {
    // Roots -1, -3, -2 +- i, -1/2; then 1, 0, +-i, 1 +- 2i, with and without others.
    let stable: [&[i64]; 4] = [&[1, 1], &[3, 1], &[5, 4, 1], &[1, 2]];
    let unstable: [&[i64]; 5] = [&[-1, 1], &[0, 1], &[1, 0, 1], &[5, -2, 1], &[-4, 0, 1]];
    for count in 0..=stable.len() {
        for sign in [1, -1] {
            let with = |more: &[&[i64]]| of(&product(&[&stable[..count], more, &[&[sign]]].concat()));
            assert!(with(&[]).is_hurwitz(), "{count} {sign}");
            for factor in unstable {
                assert!(!with(&[factor]).is_hurwitz(), "{count} {sign} {factor:?}");
            }
        }
    }
    assert!(!of(&[]).is_hurwitz());
}

#[test]
fn moved_roots() {
    // (x - 1) (x + 2) (x - 4) moved by 3/2.
    let moved = of(&product(&[&[-1, 1], &[2, 1], &[-4, 1]])).with_roots_moved(&rational(3, 2));
    let roots: Vec<Rational> = [rational(5, 2), rational(-1, 2), rational(11, 2)].to_vec();
    assert!(moved.at(&rational(9, 1)) > rational(0, 1) && moved.at(&rational(-9, 1)) < rational(0, 1));
    assert!(moved.degree() == 3 && roots.iter().all(|root| moved.at(root) == rational(0, 1)));
}
