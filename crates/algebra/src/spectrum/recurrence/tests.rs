//! Recurrences of sequences whose closed form is known, and when its terms decide, by hand.

use super::super::testing::After;
use super::*;
use arithmetic::Unwatched;

type Term = (Rational, Rational);

/// `early` and then `sum_j p_j r^j + sum_k c_k root_k^r`, so many terms.
fn sequence(early: &[i64], polynomial: &[Rational], sum: &[Term], count: usize) -> Vec<Rational> {
    let late = |r: usize| {
        let powers = polynomial.iter().enumerate().map(|(j, c)| rational(r as i64, 1).pow(j as i32) * c);
        powers.sum::<Rational>() + sum.iter().map(|(root, c)| root.pow(r as i32) * c).sum::<Rational>()
    };
    (0..count).map(|r| early.get(r).map_or_else(|| late(r), |&x| rational(x, 1))).collect()
}

fn recurrence(terms: Vec<Rational>) -> Recurrence {
    Recurrence::new(terms, &Unwatched).expect("not stopped")
}

/// Sequences by their parts: what comes before, the polynomial, the exponentials by decreasing root.
fn cases() -> Vec<(Vec<i64>, Vec<Rational>, Vec<Term>)> {
    let q = rational;
    vec![
        (vec![], vec![], vec![(q(1, 2), q(3, 1))]),
        (vec![], vec![q(5, 3)], vec![]),
        (vec![9], vec![], vec![(q(1, 2), q(-3, 1))]),
        (vec![4, 0, -7], vec![], vec![(q(2, 3), q(5, 1)), (q(1, 7), q(-8, 9))]),
        (vec![], vec![q(1, 1), q(-2, 3), q(7, 5)], vec![(q(3, 4), q(1, 9))]),
        (vec![0, 1], vec![q(0, 1), q(0, 1), q(0, 1), q(-1, 6)], vec![(q(3, 4), q(-10, 1)), (q(1, 5), q(2, 1))]),
        (vec![1, 1, 1], vec![q(-4, 1), q(1, 1)], vec![(q(9, 10), q(1, 3)), (q(1, 2), q(2, 7)), (q(1, 3), q(-6, 1))]),
        (vec![3, 8], vec![], vec![]),
        (vec![], vec![], vec![]),
    ]
}

#[test]
fn the_shortest_recurrence_has_the_roots_of_the_sequence() {
    for (early, polynomial, sum) in cases() {
        let found = recurrence(sequence(&early, &polynomial, &sum, 24));
        let roots = vec![rational(0, 1); early.len()].into_iter();
        let roots = roots.chain(vec![rational(1, 1); polynomial.len()]).chain(sum.iter().map(|(root, _)| root.clone()));
        let expected = roots.fold(vec![rational(1, 1)], |product, root| {
            let mut next = vec![rational(0, 1); product.len() + 1];
            for (k, c) in product.iter().enumerate() {
                next[k] -= c * &root;
                next[k + 1] += c;
            }
            next
        });
        assert_eq!(found.characteristic, expected, "{early:?} {polynomial:?} {sum:?}");
        assert_eq!((found.order(), found.is_zero()), (expected.len() - 1, expected.len() == 1));
    }
}

#[test]
fn the_closed_form_is_found_again() {
    for (early, polynomial, sum) in cases() {
        let found = recurrence(sequence(&early, &polynomial, &sum, 24)).decompose(256, &Unwatched);
        let found = found.expect("real roots").expect("precise enough");
        assert_eq!((found.start, &found.polynomial), (early.len() as u64, &polynomial));
        assert_eq!(found.terms.len(), sum.len());
        for ((root, coefficient), (exact_root, exact_coefficient)) in found.terms.iter().zip(&sum) {
            assert!(root.contains(exact_root) && root.width().to_f64() < 1e-70 && root.precision() == 256);
            assert!(coefficient.contains(exact_coefficient) && coefficient.width().to_f64() < 1e-60, "{coefficient:?}");
        }
    }
    // Half the terms are those of the order.
    for (early, polynomial, sum) in cases() {
        let order = early.len() + polynomial.len() + sum.len();
        let terms = sequence(&early, &polynomial, &sum, 2 * order);
        assert!(recurrence(terms).eventual_sign(&Unwatched).is_ok(), "{early:?} {polynomial:?} {sum:?}");
    }
}

/// Dyadic numbers, which are exact here.
fn point(numerator: i64, denominator: i64) -> Interval {
    Interval::from_rational(&rational(numerator, denominator), 128)
}

fn exponentials(start: u64, polynomial: &[i64], terms: &[(i64, i64, i64)]) -> ExponentialSum {
    let polynomial = polynomial.iter().map(|&c| rational(c, 1)).collect();
    let term = |&(numerator, denominator, c): &(i64, i64, i64)| (point(numerator, denominator), point(c, 1));
    ExponentialSum { start, polynomial, terms: terms.iter().map(term).collect() }
}

/// `8 (1/4)^r` is below `2^-bits (1/2)^r` where `2^(r - 3) > 2^bits`; together with `(1/16)^r` where `8 2^-r + 8^-r < 2^-bits`.
#[test]
fn the_first_term_leads_from_the_index_that_the_ratio_gives() {
    for c in [8, -8] {
        let one = exponentials(0, &[], &[(1, 2, 1), (1, 4, c)]);
        let two = exponentials(0, &[], &[(1, 2, -1), (1, 4, c), (1, 16, 1)]);
        for bits in [0u64, 2, 32] {
            let limit = bits + 3;
            let leads = |sum: &ExponentialSum, from: u64| sum.leads_from(from, bits as i64).expect("regular");
            assert!(!leads(&one, limit) && leads(&one, limit + 1) && !leads(&one, 0));
            assert!(!leads(&two, limit) && leads(&two, limit + 1));
        }
    }
    // Half of the leading coefficient, and one root that is not smaller.
    let half = exponentials(0, &[], &[(1, 2, -16), (1, 4, 8)]);
    assert!(half.leads_from(0, 0).expect("regular") && !half.leads_from(0, 1).expect("regular"));
    assert!(!exponentials(0, &[], &[(1, 2, 8), (1, 2, 1)]).leads_from(90, 0).expect("regular"));
    assert!(exponentials(0, &[], &[(1, 2, 8)]).leads_from(0, 500).expect("regular"));
    assert!(exponentials(0, &[], &[]).leads_from(0, 500).expect("regular"));
}

#[test]
fn signs_are_certain_from_the_index_that_the_bounds_give() {
    use Sign::{Negative, Positive};
    let sign = |sum: &ExponentialSum, from: u64| sum.sign_from(from).expect("regular");
    // No polynomial: the sign of the leading coefficient, from where it leads.
    for (c, expected) in [(1, Positive), (-1, Negative)] {
        let sum = exponentials(0, &[], &[(1, 2, c), (1, 4, 8)]);
        assert_eq!([3, 4].map(|from| sign(&sum, from)), [None, Some(expected)]);
    }
    assert_eq!(sign(&exponentials(0, &[], &[]), 7), None);
    // r² - 10 r + 5: beyond 16, the sum of the coefficients; of one sign at once.
    for (k, expected) in [(1, Positive), (-1, Negative)] {
        let mixed = exponentials(0, &[5 * k, -10 * k, k], &[]);
        assert_eq!([15, 16].map(|from| sign(&mixed, from)), [None, Some(expected)]);
        assert_eq!(sign(&exponentials(0, &[5 * k, 0, k], &[]), 0), Some(expected));
    }
    // 2 r² - 6 r: 1 + 3.
    assert_eq!([3, 4].map(|from| sign(&exponentials(0, &[0, -6, 2], &[]), from)), [None, Some(Positive)]);
    // 3 against 200 2^-r, which is 3.125 for r = 6; what has the same sign does no harm.
    for (k, expected) in [(1, Positive), (-1, Negative)] {
        let against = exponentials(0, &[3 * k], &[(1, 2, -200 * k)]);
        assert_eq!([6, 7].map(|from| sign(&against, from)), [None, Some(expected)]);
        assert_eq!(sign(&exponentials(0, &[3 * k], &[(1, 2, 200 * k)]), 0), Some(expected));
        // 1 + r against 40 2^-r and 40 4^-r together: 2.5 + 0.16 and 1.25 + 0.04 at 4 and 5; 50 at 0.
        let line = exponentials(0, &[k, k], &[(1, 2, -40 * k), (1, 4, -40 * k)]);
        assert_eq!([0, 2, 3].map(|from| sign(&line, from)), [None, None, None]);
        assert_eq!([4, 5].map(|from| sign(&line, from)), [Some(expected), Some(expected)]);
    }
    // The other exponential is large enough alone, and only that counts.
    let one_harmless = exponentials(0, &[3], &[(1, 2, 1000), (1, 4, -12)]);
    assert_eq!([1, 2].map(|from| sign(&one_harmless, from)), [None, Some(Positive)]);
}

#[test]
fn the_sign_in_the_long_run_with_its_index() {
    let q = rational;
    let eventual = |early: &[i64], polynomial: &[Rational], sum: &[Term]| {
        let found = recurrence(sequence(early, polynomial, sum, 24)).eventual_sign(&Unwatched).expect("decided");
        (found.sign, found.from)
    };
    // From the end of what comes before, at least 1, doubled until it is certain.
    assert_eq!(eventual(&[], &[], &[(q(1, 2), q(3, 1))]), (Sign::Positive, 1));
    assert_eq!(eventual(&[9, 9, 9], &[], &[(q(1, 2), q(-3, 1))]), (Sign::Negative, 3));
    assert_eq!(eventual(&[], &[], &[(q(1, 2), q(-1, 1)), (q(1, 4), q(7, 1))]), (Sign::Negative, 4));
    assert_eq!(eventual(&[9, 9, 9], &[], &[(q(1, 2), q(-1, 1)), (q(1, 4), q(9, 1))]), (Sign::Negative, 6));
    assert_eq!(eventual(&[3, 8], &[], &[]), (Sign::Zero, 2));
    assert_eq!(eventual(&[], &[], &[]), (Sign::Zero, 0));
    assert_eq!(eventual(&[], &[q(5, 1), q(-10, 1), q(1, 1)], &[]), (Sign::Positive, 16));
}

#[test]
fn sizes_far_out_hold_the_logarithm() {
    let q = rational;
    // Nearly 2^-32 beside 1 at r = 33: as much as what is left out may be.
    for (c, other, r) in [(3, 0, 1000), (-5, 1, 40), (8, 15, 33), (8, -15, 33), (-8, 15, 33)] {
        let sum: Vec<Term> =
            [(q(1, 2), q(c, 8)), (q(1, 4), q(other, 8))].into_iter().filter(|(_, c)| *c != q(0, 1)).collect();
        let found = recurrence(sequence(&[7], &[], &sum, 24)).leading(&BigInt::from(r), &Unwatched);
        let found = found.expect("decided").expect("not zero");
        let exact = sum.iter().map(|(root, c)| root.pow(r) * c).sum::<Rational>();
        assert_eq!(found.sign == Sign::Positive, exact > q(0, 1));
        let one = Interval::from_rational(&q(1, 1), 200);
        let log = one.rational(&exact.abs()).ln().and_then(|x| x.over(&one.integer(2).ln()?)).expect("a logarithm");
        let ((lo, hi), (least, most)) = (found.log2.to_rationals(), log.to_rationals());
        assert!(lo <= least && most <= hi && &hi - &lo <= q(2, 1).pow(-29), "{c} {other} {r}");
    }
    // The same far beyond 64 bits, from the logarithm of 3 alone.
    let far = BigInt::from(1) << 100u32;
    let found = recurrence(sequence(&[], &[], &[(q(1, 2), q(3, 1))], 24)).leading(&far, &Unwatched);
    let log2 =
        found.expect("decided").expect("not zero").log2 + Interval::from_rational(&Rational::from_integer(far), 300);
    let three = Interval::from_rational(&q(3, 1), 200);
    let log = three.ln().and_then(|x| x.over(&three.integer(2).ln()?)).expect("a logarithm");
    let ((lo, hi), (least, most)) = (log2.to_rationals(), log.to_rationals());
    assert!(lo <= least && most <= hi && hi - lo <= q(2, 1).pow(-29));
}

#[test]
fn sizes_of_what_is_zero_or_stays() {
    let q = rational;
    let leading = |early: &[i64], polynomial: &[Rational], sum: &[Term], r: i64| {
        recurrence(sequence(early, polynomial, sum, 24)).leading(&BigInt::from(r), &Unwatched)
    };
    assert!(matches!(leading(&[], &[], &[], 5), Ok(None)) && matches!(leading(&[1, 2], &[], &[], 5), Ok(None)));
    assert!(matches!(leading(&[], &[q(1, 1)], &[], 5), Err(RecurrenceError::Roots)));
    let constant = leading(&[], &[q(1, 1)], &[(q(1, 2), q(1, 1))], 500);
    assert!(matches!(constant, Err(RecurrenceError::Precision(16384))));
    // 8 4^-r is more than 2^-32 of 2^-r up to r = 35.
    let sum = [(q(1, 2), q(1, 1)), (q(1, 4), q(8, 1))];
    assert!(matches!(leading(&[], &[], &sum, 35), Err(RecurrenceError::Precision(16384))));
    assert!(matches!(leading(&[], &[], &sum, 36), Ok(Some(_))));
}

#[test]
fn what_is_refused() {
    let q = rational;
    let order = |terms: &[i64]| {
        let terms = terms.iter().map(|&x| q(x, 1)).collect();
        recurrence(terms).eventual_sign(&Unwatched)
    };
    assert_eq!(order(&[0, 0, 1]), Err(RecurrenceError::TooFewTerms { terms: 3, order: 3 }));
    assert_eq!(order(&[0, 0, 1, 0, 0]), Err(RecurrenceError::TooFewTerms { terms: 5, order: 3 }));
    assert_eq!(order(&[0, 0, 1, 0, 0, 0]), Ok(Eventual { sign: Sign::Zero, from: 3 }));
    // 2^r, (-1)^r and complex roots.
    for terms in [[1, 2, 4, 8, 16, 32], [1, -1, 1, -1, 1, -1], [1, 0, -1, 0, 1, 0]] {
        assert_eq!(order(&terms), Err(RecurrenceError::Roots));
    }
}

#[test]
fn work_can_be_stopped() {
    let terms = sequence(&[], &[], &[(rational(1, 2), rational(3, 1)), (rational(1, 3), rational(1, 1))], 6);
    for count in 0..6 {
        assert_eq!(Recurrence::new(terms.clone(), &After::new(count)).err(), Some(Cancelled));
    }
    let found = Recurrence::new(terms, &After::new(6)).expect("not stopped");
    assert_eq!(found.eventual_sign(&After::new(0)), Err(RecurrenceError::Cancelled(Cancelled)));
    // The chain has asked once, the search for roots as often as in a search alone; then each root is refined.
    let whole = (0..40).find(|&count| found.decompose(128, &After::new(count)).is_ok()).expect("it ends");
    let polynomial = Polynomial::from_rationals(&found.characteristic);
    let (zero, one) = (rational(0, 1), rational(1, 1));
    let search = (0..40).find(|&count| polynomial.roots_in_watched(&zero, &one, &After::new(count)).is_ok());
    let chain = (0..40).find(|&count| polynomial.is_square_free_watched(&After::new(count)).is_ok());
    assert_eq!(Some(whole), search.zip(chain).map(|(a, b)| a + b + 2));
}

#[test]
fn absolute_values_of_intervals() {
    let between = |lo: i64, hi: i64| Interval::hull_of_rationals(&rational(lo, 1), &rational(hi, 1), 64);
    for (lo, hi, expected) in [(2, 3, (2, 3)), (-3, -2, (2, 3)), (-1, 4, (-4, 4)), (-4, 1, (-4, 4)), (0, 0, (0, 0))] {
        let expected = (rational(expected.0, 1), rational(expected.1, 1));
        assert_eq!(absolute(&between(lo, hi)).to_rationals(), expected);
    }
}
