use arithmetic::{Ball, Enclosure, FloatInterval, Interval, Rational, rational};
use proptest::prelude::*;

/// What must be true of every enclosure; `exact` where the ends can be thirds.
fn keeps_its_numbers<T: Enclosure>(like: &T, a: &Rational, b: &Rational, c: &Rational) {
    let (x, y) = (like.around(a, b), like.around(b, c));
    let inside = |x: &T, q: &Rational| x.ends().is_some_and(|(lo, hi)| lo <= *q && *q <= hi);
    let float = |x: f64| Rational::from_float(x).expect("finite");
    for (set, points) in [(&x, [a, b]), (&y, [b, c]), (&x.joined(&y), [a, c])] {
        for q in points {
            assert!(inside(set, q), "{q} in {set:?}");
            assert!(float(set.lower()) <= *q && *q <= float(set.upper()));
        }
        let (lo, hi) = set.ends().expect("bounded");
        assert!(float(set.lower()) <= lo && hi <= float(set.upper()) && &hi - &lo <= float(set.spread()));
        assert!(float(set.largest()) >= hi && float(set.largest()) >= -lo.clone());
        let middle = set.middle().ends().expect("bounded");
        assert!(set.joined(&set.middle()).ends().expect("bounded").0 <= middle.0);
    }
    assert!(inside(&x.common(&y).expect("b is in both"), b));
}

proptest! {
    #[test]
    fn every_enclosure_keeps_its_numbers(n in prop::array::uniform3(-1000i64..1000), d in prop::array::uniform3(1i64..50)) {
        let [a, b, c] = [0, 1, 2].map(|k| rational(n[k], d[k]));
        keeps_its_numbers(&FloatInterval::point(0.0), &a, &b, &c);
        keeps_its_numbers(&Interval::from_rational(&rational(0, 1), 60), &a, &b, &c);
        let zero = Interval::from_rational(&rational(0, 1), 200);
        keeps_its_numbers(&Ball::<4>::from_interval(&zero), &a, &b, &c);
    }
}

#[test]
fn sets_without_a_common_number_and_without_a_bound_are_known() {
    let [one, two] = [1, 2].map(|n| FloatInterval::point(f64::from(n)));
    assert_eq!(one.common(&two), None);
    assert!(FloatInterval::LINE.ends().is_none());
    assert_eq!(FloatInterval::LINE.middle(), FloatInterval::point(0.0));
    // Ends that are floats are bounds themselves.
    let exact = Interval::from_rational(&rational(3, 4), 60);
    assert_eq!((exact.lower(), exact.upper(), exact.spread()), (0.75, 0.75, 0.0));
    let third = Interval::from_rational(&rational(1, 3), 100);
    assert!(third.upper() == third.lower().next_up());
}
