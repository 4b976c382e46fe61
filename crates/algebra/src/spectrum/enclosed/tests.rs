//! Parts of a spectrum: their order, and how those that meet become one.

use super::{Eigenvalue, bits, least_top, merged, order};
use arithmetic::{Dyadic, Interval, Rational, rational};
use num_bigint::BigInt;

fn between(lo: i64, hi: i64) -> Interval {
    Interval::between(Dyadic::new(BigInt::from(lo), 0), Dyadic::new(BigInt::from(hi), 0), 64)
}

fn part(re: (i64, i64), im: (i64, i64), multiplicity: usize) -> Eigenvalue {
    Eigenvalue { re: between(re.0, re.1), im: between(im.0, im.1), multiplicity, exact: None }
}

/// Ends of both parts, number, exact value.
fn read(parts: &[Eigenvalue]) -> Vec<([Rational; 4], usize, Option<Rational>)> {
    let ends = |x: &Eigenvalue| {
        let ((a, b), (c, d)) = (x.re.to_rationals(), x.im.to_rationals());
        ([a, b, c, d], x.multiplicity, x.exact.clone())
    };
    parts.iter().map(ends).collect()
}

fn expected(re: (i64, i64), im: (i64, i64), multiplicity: usize) -> ([Rational; 4], usize, Option<Rational>) {
    ([re.0, re.1, im.0, im.1].map(|x| rational(x, 1)), multiplicity, None)
}

#[test]
fn parts_that_meet_become_one_and_others_stay_apart() {
    // In a chain, at a common end, one inside the other; and side by side or one above the other.
    let chain =
        vec![part((4, 6), (0, 0), 1), part((0, 2), (0, 0), 2), part((2, 5), (0, 0), 3), part((9, 9), (0, 0), 4)];
    assert_eq!(read(&merged(chain)), [expected((0, 6), (0, 0), 6), expected((9, 9), (0, 0), 4)]);
    let inside = vec![part((0, 9), (-1, 1), 1), part((3, 4), (0, 5), 1), part((20, 21), (0, 1), 1)];
    assert_eq!(read(&merged(inside)), [expected((0, 9), (-1, 5), 2), expected((20, 21), (0, 1), 1)]);
    let above = vec![part((0, 9), (2, 3), 1), part((3, 4), (-3, -2), 1), part((3, 4), (4, 5), 2)];
    assert_eq!(
        read(&merged(above)),
        [expected((3, 4), (-3, -2), 1), expected((3, 4), (4, 5), 2), expected((0, 9), (2, 3), 1)]
    );
    // What two make together meets a third that met neither.
    let corner = vec![part((0, 1), (0, 9), 1), part((1, 9), (0, 1), 1), part((5, 6), (5, 6), 1)];
    assert_eq!(read(&merged(corner)), [expected((0, 9), (0, 9), 3)]);
}

#[test]
fn only_equal_exact_values_stay_exact() {
    let exact = |q: Rational| Eigenvalue::rational(q, 1, 64);
    let third = rational(1, 3);
    let same = merged(vec![exact(third.clone()), exact(third.clone()), exact(rational(2, 3))]);
    assert_eq!(same.iter().map(|x| x.multiplicity).collect::<Vec<_>>(), [2, 1]);
    assert_eq!(same[0].exact, Some(third.clone()));
    // Close to each other: one enclosure, and no exact value.
    let close = &third + rational(1, 2).pow(200);
    for pair in [vec![exact(third.clone()), exact(close)], vec![exact(third), part((0, 1), (0, 0), 1)]] {
        let one = merged(pair.clone());
        assert_eq!((one.len(), one[0].multiplicity, &one[0].exact), (1, 2, &None));
        assert!(pair.iter().all(|x| x.re.to_rationals().0 >= one[0].re.to_rationals().0));
        assert!(pair.iter().all(|x| x.re.to_rationals().1 <= one[0].re.to_rationals().1));
    }
}

#[test]
fn parts_are_real_only_where_nothing_is_left_of_the_imaginary_part() {
    for (im, real) in [((0, 0), true), ((0, 1), false), ((-1, 0), false), ((-1, 1), false)] {
        assert_eq!(part((0, 1), im, 1).is_real(), real);
    }
}

#[test]
fn the_order_is_that_of_the_middles() {
    use std::cmp::Ordering::{Equal, Greater, Less};
    let at = |re: (i64, i64), im: (i64, i64)| part(re, im, 1);
    assert_eq!(order(&at((0, 10), (0, 0)), &at((4, 5), (0, 0))), Greater);
    assert_eq!(order(&at((-9, 2), (7, 7)), &at((-1, 0), (-7, -7))), Less);
    assert_eq!(order(&at((1, 2), (0, 10)), &at((1, 2), (4, 5))), Greater);
    assert_eq!(order(&at((1, 2), (-9, 2)), &at((0, 3), (-1, 0))), Less);
    assert_eq!(order(&at((1, 2), (0, 2)), &at((0, 3), (1, 1))), Equal);
}

#[test]
fn the_least_absolute_value_of_an_interval_bounds_a_power_of_two() {
    for (lo, hi, top) in [(1, 1, 0), (3, 100, 1), (-100, -3, 1), (4, 4, 2), (-7, -7, 2)] {
        assert_eq!(least_top(&between(lo, hi)), top, "[{lo}, {hi}]");
    }
}

#[test]
fn bits_hold_the_digits_and_no_more() {
    for digits in 1..=400u32 {
        let (power, ten) = (BigInt::from(1) << bits(digits), BigInt::from(10).pow(digits));
        assert!(ten < power && power < ten * 2, "{digits}");
    }
}

#[test]
fn powers_of_two_below_intervals() {
    for (lo, hi, exponent) in [(9, 11, -1), (10, 15, 0), (10, 10, 0), (11, 39, 0), (21, 39, 1)] {
        let (lo, hi) = (rational(lo, 10), rational(hi, 10));
        assert_eq!(least_top(&Interval::hull_of_rationals(&lo, &hi, 80)), exponent);
        assert_eq!(least_top(&Interval::hull_of_rationals(&-hi, &-lo, 80)), exponent);
    }
}
