//! Sums of square roots are equal exactly when their square-free parts are.

use arithmetic::{RadicalSum, Rational, rational};

fn sum(terms: &[(i64, i64, i64)]) -> RadicalSum {
    let mut sum = RadicalSum::default();
    for &(coefficient, p, q) in terms {
        assert!(sum.add_root(&Rational::from_integer(coefficient.into()), &rational(p, q)));
    }
    sum
}

#[test]
fn squares_are_taken_out() {
    let nothing = RadicalSum::default();
    for (left, right) in [
        ((1, 8, 1), (2, 2, 1)),
        ((2, 1, 2), (1, 2, 1)),
        ((4, 1, 8), (1, 2, 1)),
        ((2, 9, 4), (3, 1, 1)),
        ((1, 720, 1), (12, 5, 1)),
        ((1, 343, 1), (7, 7, 1)),
        ((1, 4 * 49 * 121, 1), (154, 1, 1)),
        ((6, 5, 12), (1, 15, 1)),
        ((1, 96, 1), (4, 6, 1)),
    ] {
        let (c, p, q) = right;
        assert_eq!(sum(&[left]), sum(&[right]), "{left:?} and {right:?}");
        assert_eq!(sum(&[left, (-c, p, q)]), nothing, "{left:?} less {right:?}");
    }
    assert_eq!(sum(&[(1, 12, 1), (1, 27, 1)]), sum(&[(5, 3, 1)]));
    assert_ne!(sum(&[(1, 30, 1)]), sum(&[(1, 6, 1)]));
    assert_ne!(sum(&[(1, 2, 1), (1, 3, 1)]), sum(&[(1, 5, 1)]));
}

#[test]
fn zero_adds_nothing_and_negative_radicands_are_refused() {
    let mut one = sum(&[(1, 1, 1)]);
    let before = one.clone();
    assert!(one.add_root(&rational(5, 1), &rational(0, 1)) && one == before);
    assert!(!one.add_root(&rational(5, 1), &rational(-2, 1)) && one == before);
}
