//! Factors of characteristic polynomials with their powers, and eigenvalues to the digits that are asked for.

use super::*;
use arithmetic::Rational;

fn diagonal(entries: &[i64]) -> CharacteristicPolynomial {
    let row = |i: usize| (0..entries.len()).map(|j| if i == j { entries[i] } else { 0 }).collect::<Vec<i64>>();
    let rows: Vec<Vec<i64>> = (0..entries.len()).map(row).collect();
    RationalMatrix::from_integers(&rows, 1).and_then(|a| a.characteristic_polynomial()).expect("square")
}

/// Eigenvalues with their powers.
fn exact(parts: Option<Vec<Eigenvalue>>) -> Vec<(Rational, usize)> {
    let part = |x: Eigenvalue| (x.exact.expect("rational"), x.multiplicity);
    parts.expect("real").into_iter().map(part).collect()
}

#[test]
fn powers_of_common_factors_add_up() {
    let lists: [&[i64]; 4] = [&[1, 1, 2], &[1, 2, 2, 2, 3], &[5], &[3, 3, 4, 1, 1]];
    for count in 1..=4 {
        for reversed in [false, true] {
            let mut factors = Factors::default();
            let mut order: Vec<&[i64]> = lists[..count].to_vec();
            if reversed {
                order.reverse();
            }
            order.iter().for_each(|list| factors.multiply(&diagonal(list), 1));
            assert!(factors.list.iter().all(|(factor, _)| factor.degree() > 0));
            // Three at once are as three one after the other.
            let (mut at_once, mut by_turns) = (Factors::default(), Factors::default());
            order.iter().for_each(|list| at_once.multiply(&diagonal(list), 3));
            (0..3).for_each(|_| order.iter().for_each(|list| by_turns.multiply(&diagonal(list), 1)));
            assert_eq!(exact(at_once.roots(20)), exact(by_turns.roots(20)));
            let power = |x: i64| lists[..count].iter().flat_map(|list| list.iter()).filter(|&&y| x == y).count();
            let expected: Vec<(Rational, usize)> =
                (1..=5).map(|x| (rational(x, 1), power(x))).filter(|(_, power)| *power > 0).collect();
            assert_eq!(exact(factors.real_roots(20)), expected);
            assert_eq!(exact(factors.roots(20)), expected);
        }
    }
}

/// `x² - c` for `c` of many sizes, and with a root at zero beside it: as many digits as asked for, and the enclosure holds the root.
#[test]
fn roots_have_their_digits() {
    for (numerator, denominator) in [(2, 1), (2, 9), (3, 1_000_003), (1_000_003, 7), (7, 1 << 40), (1 << 40, 5)] {
        let c = rational(numerator, denominator);
        let matrix = RationalMatrix::from_rows(&[
            vec![rational(0, 1), c.clone(), rational(0, 1)],
            vec![rational(1, 1), rational(0, 1), rational(0, 1)],
            vec![rational(0, 1); 3],
        ]);
        let matrix = matrix.expect("a filled shape");
        for digits in [1, 3, 10, 19, 28, 50] {
            let parts = real_spectrum(&matrix, digits).expect("square").expect("real");
            assert_eq!(parts.iter().map(|part| part.multiplicity).collect::<Vec<_>>(), [1, 1, 1]);
            assert_eq!(parts[1].exact, Some(rational(0, 1)));
            for (part, is_negative) in [(&parts[0], true), (&parts[2], false)] {
                let (lo, hi) = part.re.to_rationals();
                let (inner, outer) = if is_negative { (-hi.clone(), -lo.clone()) } else { (lo.clone(), hi.clone()) };
                assert!(inner.is_positive() && inner.pow(2) <= c && c <= outer.pow(2), "{c}, {digits}");
                // |hi - lo| <= 10^-digits |x|.
                assert!((hi - lo) * rational(10, 1).pow(digits as i32) <= inner, "{c}, {digits}");
                assert!(part.is_real() && part.exact.is_none());
            }
        }
    }
}

/// `x² + 10^6 x - 1`: a root near 10^-6, though the leading coefficient is one; `-(5·10^5) + sqrt(25·10^10 + 1)`.
#[test]
fn small_roots_are_told_from_zero() {
    let matrix = RationalMatrix::from_integers(&[[0, 1], [1, -1_000_000]], 1).expect("filled");
    for digits in [1, 9, 30] {
        let parts = real_spectrum(&matrix, digits).expect("square").expect("real");
        let (lo, hi) = parts[1].re.to_rationals();
        let half = rational(500_000, 1);
        let square = half.pow(2) + rational(1, 1);
        assert!(lo.is_positive() && (&lo + &half).pow(2) <= square && square <= (&hi + &half).pow(2));
        assert!((&hi - &lo) * rational(10, 1).pow(digits as i32) <= lo, "{digits}");
    }
}

#[test]
fn complex_roots_come_in_pairs_beside_the_real_ones() {
    // (x² + 1)(x - 2), twice.
    let rows = [[0, -1, 0], [1, 0, 0], [0, 0, 2]];
    let polynomial =
        RationalMatrix::from_integers(&rows, 1).and_then(|a| a.characteristic_polynomial()).expect("square");
    let mut factors = Factors::default();
    factors.multiply(&polynomial, 1);
    factors.multiply(&polynomial, 1);
    assert!(factors.real_roots(10).is_none());
    let parts = factors.roots(10).expect("isolated");
    let is_near = |x: &Interval, value: f64| (x.to_f64() - value).abs() < 1e-9;
    let found: Vec<bool> = parts
        .iter()
        .zip([(0.0, -1.0), (0.0, 1.0), (2.0, 0.0)])
        .map(|(part, (re, im))| is_near(&part.re, re) && is_near(&part.im, im) && part.multiplicity == 2)
        .collect();
    assert_eq!(found, [true; 3]);
    assert_eq!(
        real_spectrum(&RationalMatrix::from_integers(&rows, 1).expect("filled"), 5).map(|x| x.is_none()),
        Ok(true)
    );
}

/// No root lies outside Cauchy's bound; here one lies as near to it as it can, `n + 1` for `x^k - n (x^(k-1) + .. + 1)`.
#[test]
fn the_bound_holds_all_roots() {
    for n in [1i64, 2, 3, 4, 7, 8, 100] {
        for lead in [1, 3, 4, 7] {
            let polynomial = Polynomial::new([-n, -n, -n, lead].map(num_bigint::BigInt::from).to_vec());
            assert_eq!(real_roots_of(&polynomial).len(), 1, "{n} {lead}");
            let far = Polynomial::new([-n, lead].map(num_bigint::BigInt::from).to_vec());
            assert_eq!(real_roots_of(&far).len(), 1, "{n} {lead}");
        }
    }
    assert!(real_roots_of(&Polynomial::new(Vec::new())).is_empty());
    assert!(real_roots_of(&Polynomial::new(vec![5.into()])).is_empty());
}
