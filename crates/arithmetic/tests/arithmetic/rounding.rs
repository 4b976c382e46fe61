//! Directed rounding to the last bit: every end of a result of [`Interval`] is the exact end, rounded outward once. A naive twin
//! computes the exact ends from all pairs of ends.

use arithmetic::{Dyadic, Field, FloatInterval, Interval, Number, Rational, Ring, rational};
use num_bigint::{BigInt, Sign};
use num_traits::{Signed, Zero as _};
use proptest::prelude::*;

/// An interval whose ends have few or many bits, are near or far apart, positive, negative or zero.
fn any_interval() -> impl Strategy<Value = Interval> {
    let end = (any::<i64>(), 0u32..64, -70i64..70);
    (end.clone(), end, 0u32..8, 8u32..80).prop_map(|((p, cut, shift), (q, other_cut, other_shift), form, precision)| {
        let a = Dyadic::new(BigInt::from(p >> cut), shift);
        let b = match form {
            0 => a.clone(),
            1 => Dyadic::zero(),
            2 => a.negated(),
            _ => Dyadic::new(BigInt::from(q >> other_cut), other_shift),
        };
        Interval::between(a, b, precision)
    })
}

fn ends(x: &Interval) -> [Rational; 2] {
    let (lo, hi) = x.to_rationals();
    [lo, hi]
}

/// The number of significant bits of a dyadic rational.
fn bits(q: &Rational) -> u64 {
    let twos = q.numer().trailing_zeros().unwrap_or(0);
    (q.numer().abs() >> twos).bits()
}

/// One unit in the last of `precision` significant bits of a number.
fn unit(q: &Rational, precision: u32) -> Rational {
    let two = |k: i64| {
        let power = Rational::from_integer(BigInt::from(1) << k.unsigned_abs());
        if k < 0 { power.recip() } else { power }
    };
    let mut top = q.numer().bits() as i64 - q.denom().bits() as i64;
    while two(top) > q.abs() {
        top -= 1;
    }
    while two(top + 1) <= q.abs() {
        top += 1;
    }
    two(top + 1 - i64::from(precision))
}

/// Whether the interval has the exact ends, rounded outward to its precision and no further.
fn is_rounded_once(x: &Interval, lo: &Rational, hi: &Rational) -> bool {
    let [below, above] = ends(x);
    let fits = |end: &Rational, exact: &Rational| {
        let is_exact = bits(exact) <= u64::from(x.precision())
            && exact.denom().bits() == exact.denom().trailing_zeros().unwrap_or(0) + 1;
        let distance = (end - exact).abs();
        bits(end) <= u64::from(x.precision())
            && if is_exact { distance.is_zero() } else { distance < unit(exact, x.precision()) }
    };
    below <= *lo && *hi <= above && fits(&below, lo) && fits(&above, hi)
}

/// Least and largest of some numbers.
fn span(all: impl IntoIterator<Item = Rational>) -> (Rational, Rational) {
    let all: Vec<Rational> = all.into_iter().collect();
    (all.iter().min().unwrap().clone(), all.iter().max().unwrap().clone())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn sums_and_products_are_rounded_once(x in any_interval(), y in any_interval()) {
        let (a, b) = (ends(&x), ends(&y));
        let least = x.precision().min(y.precision());
        for (result, (lo, hi)) in [
            (x.clone() + &y, (&a[0] + &b[0], &a[1] + &b[1])),
            (x.clone() - &y, (&a[0] - &b[1], &a[1] - &b[0])),
            (x.clone() * &y, span(a.iter().flat_map(|p| b.iter().map(move |q| p * q)))),
        ] {
            prop_assert_eq!(result.precision(), least);
            prop_assert!(is_rounded_once(&result, &lo, &hi), "{:?} of {:?} and {:?} is not [{}, {}]", result, x, y, lo, hi);
        }
        // A hull needs no rounding.
        let hull = x.hull(&y);
        prop_assert_eq!(hull.precision(), least);
        prop_assert_eq!(ends(&hull), [a[0].clone().min(b[0].clone()), a[1].clone().max(b[1].clone())]);
        prop_assert_eq!(x.encloses(&y), a[0] <= b[0] && b[1] <= a[1]);
        prop_assert_eq!(x.overlaps(&y), a[0].clone().max(b[0].clone()) <= a[1].clone().min(b[1].clone()));
    }

    #[test]
    fn quotients_are_rounded_once(x in any_interval(), y in any_interval()) {
        let (a, b) = (ends(&x), ends(&y));
        let has_zero = !b[0].is_positive() && !b[1].is_negative();
        prop_assert_eq!(y.contains_zero(), has_zero);
        match x.over(&y) {
            Err(_) => prop_assert!(has_zero),
            Ok(result) => {
                prop_assert!(!has_zero);
                let (lo, hi) = span(a.iter().flat_map(|p| b.iter().map(move |q| p / q)));
                prop_assert!(is_rounded_once(&result, &lo, &hi), "{:?} is not [{}, {}]", result, lo, hi);
                prop_assert_eq!(result.precision(), x.precision().min(y.precision()));
                prop_assert!(is_rounded_once(&y.recip().unwrap(), &b[1].recip(), &b[0].recip()));
            }
        }
        // Roots and logarithms of what is not positive are refused, wherever the upper end lies.
        prop_assert_eq!(x.sqrt().is_err(), a[0].is_negative());
        prop_assert!(a[0].is_positive() || x.ln().is_err());
    }

    #[test]
    fn squares_and_roots_are_rounded_once(x in any_interval()) {
        let a = ends(&x);
        let (mut lo, hi) = span(a.iter().map(|p| p * p));
        if !a[0].is_positive() && !a[1].is_negative() {
            lo = rational(0, 1);
        }
        prop_assert!(is_rounded_once(&x.square(), &lo, &hi));
        prop_assert!(is_rounded_once(&-x.clone(), &-a[1].clone(), &-a[0].clone()));
        match x.sqrt() {
            Err(_) => prop_assert!(a[0].is_negative()),
            Ok(root) => {
                prop_assert!(!a[0].is_negative());
                let [below, above] = ends(&root);
                for (end, square, is_lower) in [(below, &a[0], true), (above, &a[1], false)] {
                    prop_assert!(bits(&end) <= u64::from(root.precision()));
                    let own = &end * &end;
                    if own == *square {
                        continue;
                    }
                    prop_assert_eq!(own < *square, is_lower);
                    // One unit further is on the other side.
                    let step = unit(&end, root.precision());
                    let next = if is_lower { &end + step } else { &end - step };
                    prop_assert_eq!(&next * &next > *square, is_lower);
                }
            }
        }
    }

    #[test]
    fn rationals_are_rounded_once(p in any::<i64>(), q in 1..i64::MAX, cut in 0u32..63, precision in 8u32..80) {
        let x = Rational::new(BigInt::from(p >> cut), BigInt::from((q >> (62 - cut)) | 1));
        prop_assert!(is_rounded_once(&Interval::from_rational(&x, precision), &x, &x));
        let whole = Rational::from_integer(BigInt::from(p));
        let integer = Interval::from_rational(&x, precision).integer(p);
        prop_assert!(is_rounded_once(&integer, &whole, &whole));
    }

    #[test]
    fn width_midpoint_and_magnitude_are_those_of_the_ends(x in any_interval(), precision in 8u32..80, shift in -9i64..9) {
        let [lo, hi] = ends(&x);
        let width = &hi - &lo;
        let found = x.width().to_rational();
        prop_assert!(found >= width && bits(&found) <= u64::from(x.precision()));
        prop_assert!(width.is_zero() || found - &width < unit(&width, x.precision()));
        let (middle, half) = (x.midpoint(precision), (&lo + &hi) / rational(2, 1));
        let [below, above] = ends(&middle);
        prop_assert!(below == above && middle.precision() == precision);
        prop_assert!(below <= half && (half.is_zero() || half - below < unit(&((&lo + &hi) / rational(2, 1)), precision)));
        prop_assert_eq!(x.magnitude().to_rational(), lo.abs().max(hi.abs()));
        let power = rational(2, 1).pow(shift as i32);
        prop_assert_eq!(ends(&x.scaled(shift)), [&lo * &power, &hi * &power]);
        let coarse = x.with_precision(precision);
        prop_assert!(coarse.precision() == precision && is_rounded_once(&coarse, &lo, &hi));
        let nearest = num_traits::ToPrimitive::to_f64(&((&lo + &hi) / rational(2, 1))).unwrap();
        prop_assert!((x.to_f64() - nearest).abs() <= 1e-15 * nearest.abs());
    }

    /// The order of dyadics, their floors and their floats are those of the rationals.
    #[test]
    fn dyadics_are_rationals((p, e) in (any::<i64>(), -80i64..80), (q, f) in (any::<i64>(), -80i64..80), cut in 0u32..63) {
        let (x, y) = (Dyadic::new(BigInt::from(p >> cut), e), Dyadic::new(BigInt::from(q >> cut), f));
        let (a, b) = (x.to_rational(), y.to_rational());
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(x.cmp(&Dyadic::new(BigInt::from(p >> cut) << 3u32, e - 3)), std::cmp::Ordering::Equal);
        prop_assert_eq!(x.negated().cmp(&y.negated()), b.cmp(&a));
        prop_assert_eq!(x.plus(&y).to_rational(), &a + &b);
        prop_assert_eq!(x.midpoint(&y).to_rational(), (&a + &b) / rational(2, 1));
        prop_assert_eq!(x.absolute().to_rational(), a.abs());
        prop_assert_eq!(Rational::from_integer(x.floor()), a.floor());
        prop_assert_eq!(x.is_zero(), a.is_zero());
        prop_assert_eq!((x.is_positive(), x.is_negative()), (a > rational(0, 1), a < rational(0, 1)));
        if !a.is_zero() {
            let top = rational(2, 1).pow(x.top() as i32);
            prop_assert!(a.abs() < top && a.abs() * rational(2, 1) >= top);
        }
        let float = p as f64 * 2f64.powi(e as i32);
        prop_assert_eq!(Dyadic::new(BigInt::from(p), e).to_f64(), float);
        prop_assert_eq!(Dyadic::from_f64(float).unwrap().to_f64(), float);
    }

    /// Ends of float intervals are one or two floats outside of the exact ones, and exact where they can be.
    #[test]
    fn float_intervals_are_a_step_wider(p in -1e9f64..1e9, q in -1e9f64..1e9, r in -1e9f64..1e9, s in -1e9f64..1e9) {
        let exact = |x: f64| Dyadic::from_f64(x).unwrap().to_rational();
        let (x, y) = (FloatInterval::between(p, q), FloatInterval::between(r, s));
        let (a, b) = ([exact(x.lo()), exact(x.hi())], [exact(y.lo()), exact(y.hi())]);
        let mut results = vec![
            (x + y, (&a[0] + &b[0], &a[1] + &b[1])),
            (x - y, (&a[0] - &b[1], &a[1] - &b[0])),
            (x * y, span(a.iter().flat_map(|p| b.iter().map(move |q| p * q)))),
        ];
        if let Ok(inverse) = y.recip() {
            results.push((inverse, span(b.iter().map(|q| q.recip()))));
        }
        for (result, (lo, hi)) in results {
            let (below, above) = (result.lo(), result.hi());
            prop_assert!(exact(below) < lo && hi < exact(above));
            prop_assert!(exact(below.next_up().next_up()) > lo && exact(above.next_down().next_down()) < hi);
        }
        prop_assert!(exact(x.width()) >= &a[1] - &a[0] && (x.lo() == x.hi() || exact(x.width().next_down().next_down()) < &a[1] - &a[0]));
        prop_assert!(exact(x.magnitude()) == a[0].abs().max(a[1].abs()));
    }
}

/// A carry through all bits, a number that needs no rounding, and zero.
#[test]
fn carries_and_exact_numbers() {
    let all_ones = rational((1 << 20) - 1, 1);
    let x = Interval::from_rational(&all_ones, 10);
    assert_eq!(ends(&x), [rational((1 << 20) - (1 << 10), 1), rational(1 << 20, 1)]);
    assert_eq!(x.hi().mantissa().bits(), 10);
    let exact = Interval::from_rational(&rational(3 << 40, 1), 8);
    assert_eq!(exact.lo(), exact.hi());
    assert_eq!(Dyadic::zero().top(), i64::MIN / 4);
    assert!(Dyadic::new(BigInt::ZERO, -5).to_rational().is_integer());
    assert_eq!(Dyadic::new(BigInt::from_slice(Sign::Minus, &[1]), -1).floor(), BigInt::from(-1));
    assert_eq!(Interval::from_rational(&rational(1, 3), 3).precision(), 8);
    assert_eq!(Interval::between(Dyadic::zero(), Dyadic::zero(), 0).precision(), 8);
}
