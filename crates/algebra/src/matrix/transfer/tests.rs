//! Transfer functions against elimination over the rationals.

use super::*;
use crate::matrix::{RationalMatrix, solve_over_field};
use arithmetic::rational;
use proptest::prelude::*;

fn value(list: &[BigInt], s: &Rational) -> Rational {
    list.iter().rev().fold(rational(0, 1), |sum, c| sum * s + Rational::from_integer(c.clone()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Numbers with fractions, many of them zero, so that some matrices have no vector whose powers span all.
    #[test]
    fn values_are_those_of_elimination(
        n in 1usize..6, inputs in 1usize..3, numbers in prop::collection::vec((-4i64..5, 1i64..4, 0u8..3), 64),
    ) {
        let mut next = numbers.iter().map(|(p, q, keep)| if *keep == 0 { rational(0, 1) } else { rational(*p, *q) });
        let mut take = |count: usize| next.by_ref().take(count).collect::<Vec<_>>();
        let a: Vec<Vec<Rational>> = (0..n).map(|_| take(n)).collect();
        let b: Vec<Vec<Rational>> = (0..n).map(|_| take(inputs)).collect();
        let (c, d) = (take(n), take(inputs));
        let found = transfer_function(&a, &b, &c, &d).unwrap();
        for s in [rational(17, 3), rational(-23, 2), rational(101, 1)] {
            let powers: Vec<Rational> = (0..inputs).map(|k| s.power(k as u64)).collect();
            let weigh = |row: &[Rational]| row.iter().zip(&powers).map(|(x, y)| x * y).sum::<Rational>();
            let rows = (0..n).map(|i| {
                let entry = |j: usize| if i == j { &s - &a[i][j] } else { -a[i][j].clone() };
                (0..n).map(entry).chain([weigh(&b[i])]).collect()
            });
            let Ok(x) = solve_over_field(rows.collect()) else { continue };
            let known = c.iter().zip(&x).map(|(c, x)| c * x).sum::<Rational>() + weigh(&d);
            let denominator = value(&found.denominator, &s);
            prop_assert!(!denominator.is_zero());
            prop_assert_eq!(value(&found.numerator, &s) / denominator, known);
        }
        let known = RationalMatrix::from_rows(&a).unwrap().characteristic_polynomial().unwrap().coefficients();
        let lead = Rational::from_integer(found.denominator[n].clone());
        prop_assert!(lead > rational(0, 1));
        let monic: Vec<Rational> =
            found.denominator.iter().map(|c| Rational::from_integer(c.clone()) / &lead).collect();
        prop_assert_eq!(monic, known);
    }
}

/// Several copies of one block have no vector whose powers span all: the way by Hessenberg's form.
#[test]
fn copies_of_a_block_are_counted() {
    let zero = rational(0, 1);
    let a: Vec<Vec<Rational>> = (0..6)
        .map(|i| {
            (0..6)
                .map(|j| if i / 2 == j / 2 { rational([0, 1, -2, -3][2 * (i % 2) + j % 2], 1) } else { zero.clone() })
                .collect()
        })
        .collect();
    let b = vec![vec![rational(1, 1)]; 6];
    let c = vec![rational(1, 3); 6];
    let found = transfer_function(&a, &b, &c, &[zero]).unwrap();
    // (s² + 3 s + 2)³, times the scale 3.
    let cube: Vec<BigInt> = [8, 36, 66, 63, 33, 9, 1].into_iter().map(|c| BigInt::from(3 * c)).collect();
    assert_eq!(found.denominator, cube);
}

#[test]
fn shapes_are_checked() {
    let one = rational(1, 1);
    let square = vec![vec![one.clone()]];
    assert!(transfer_function(&[vec![]], &square, std::slice::from_ref(&one), std::slice::from_ref(&one)).is_err());
    assert!(transfer_function(&square, &[], std::slice::from_ref(&one), std::slice::from_ref(&one)).is_err());
    assert!(transfer_function(&square, &square, &[], std::slice::from_ref(&one)).is_err());
    assert!(transfer_function(&square, &square, &[one], &[]).is_err());
}
