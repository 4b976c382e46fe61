//! The hysteresis rule at its corners: edges of any length, changes at the threshold, thresholds that are not written out.

use algebra::graph::Graph;
use arithmetic::{Rational, rational};
use models::averaging::{FilteredFlock, Flock, FlockError, Hysteresis, Start, Weights};
use num_bigint::BigInt;

/// Whether an edge stays whose two birds, of `birds`, go from one distance to another in a step.
fn stays(birds: i64, from: Rational, to: Rational, hysteresis: Hysteresis) -> Result<bool, FlockError> {
    let mut positions: Vec<Rational> = (0..birds).map(|k| rational(10 * k, 1)).collect();
    let mut velocities = vec![rational(0, 1); positions.len()];
    (positions[1], velocities[1]) = (from.clone(), to - from);
    let start = Start::on_the_line(positions, velocities, Weights::Lazy, hysteresis);
    let network = Graph::from_edges(start.positions.len(), &[(0, 1)]).expect("two birds");
    let mut flock = Flock::resume(&start, network, BigInt::from(0))?;
    flock.step()?;
    Ok(flock.network().has_edge(0, 1))
}

#[test]
fn edges_longer_than_one_stay_where_their_length_changes_by_less_than_the_threshold() {
    let constant = |p, q| Hysteresis::Constant(rational(p, q));
    for (from, to, hysteresis, expected) in [
        (2, 2, Hysteresis::None, false),
        (2, 2, constant(0, 1), false),
        (2, 2, constant(1, 100), true),
        (2, 2, Hysteresis::Paper, true),
        // From nothing to 2.
        (0, 2, constant(201, 100), true),
        (0, 2, constant(2, 1), false),
        // Shorter, by 1.
        (4, 3, constant(99, 100), false),
        (4, 3, constant(1, 1), false),
        (4, 3, constant(101, 100), true),
    ] {
        let found = stays(2, rational(from, 1), rational(to, 1), hysteresis.clone());
        assert_eq!(found, Ok(expected), "{from} to {to}, {hysteresis:?}");
    }
}

/// Two birds in the plane part aslant: `(17/20, -1/2)` becomes `(11/10, 0)`, of length 1.1 after 0.986. With a difference of the wrong sign
/// the length before would be 1.44.
#[test]
fn lengths_before_and_after_a_step_belong_to_one_difference() {
    let vector = |x: (i64, i64), y: (i64, i64)| vec![rational(x.0, x.1), rational(y.0, y.1)];
    let (still, aside) = (vector((0, 1), (0, 1)), vector((17, 20), (-1, 2)));
    for (threshold, expected) in [(rational(1, 5), true), (rational(3, 25), true), (rational(11, 100), false)] {
        for turned in [false, true] {
            let mut positions = vec![still.clone(), aside.clone()];
            let mut velocities = vec![still.clone(), vector((1, 4), (1, 2))];
            if turned {
                positions.reverse();
                velocities.reverse();
            }
            let hysteresis = Hysteresis::Constant(threshold.clone());
            let mut flock =
                Flock::new(&Start { positions, velocities, weights: Weights::Lazy, hysteresis }).expect("a flock");
            assert!(flock.network().has_edge(0, 1));
            flock.step().expect("a step");
            assert_eq!(flock.network().has_edge(0, 1), expected, "{threshold}, {turned}");
        }
    }
}

/// From nearly nothing, by nearly 2.
#[test]
fn lengths_of_very_different_size_are_compared() {
    let from = Rational::new(1.into(), BigInt::from(1) << 40u32);
    let held = |p, q| stays(2, from.clone(), rational(2, 1), Hysteresis::Constant(rational(p, q)));
    assert_eq!((held(201, 100), held(199, 100)), (Ok(true), Ok(false)));
}

/// The threshold of 160 birds has more than 4e9 bits. What does not change is held without it, what moves by 1 is not.
#[test]
fn thresholds_too_long_to_write_are_needed_only_near_them() {
    assert_eq!(stays(160, rational(2, 1), rational(2, 1), Hysteresis::Paper), Ok(true));
    assert_eq!(stays(160, rational(2, 1), rational(3, 1), Hysteresis::Paper), Ok(false));
}

/// `2^(-16)` for two birds.
#[test]
fn a_threshold_is_written_out_up_to_the_bits_that_are_allowed() {
    assert_eq!(Hysteresis::Paper.exact(2, 16), Ok(Some(rational(1, 1 << 16))));
    assert_eq!(Hysteresis::Paper.exact(2, 15), Err(FlockError::ThresholdTooLong { bits: 16.0 }));
    assert_eq!(Hysteresis::None.exact(2, 0), Ok(None));
}

/// Of few bits, and of 12 · 2^48, where a part in 10^12 is thousands.
#[test]
fn logarithms_of_thresholds_are_bounded_from_below() {
    for (p, q) in [(1, 1), (3, 1), (1, 3), (1023, 1), (1, 1023), (1024, 1), (1, 1024), (5, 7)] {
        let below = Hysteresis::Constant(rational(p, q)).log2_below(2).expect("a threshold");
        let power = Rational::new(BigInt::from(1) << below.max(0), BigInt::from(1) << (-below).max(0));
        assert!(power <= rational(p, q) && (below as f64) > (p as f64 / q as f64).log2() - 6.0, "{p}/{q}: {below}");
    }
    let exact = -12 * (1i64 << 48);
    assert!(Hysteresis::Paper.log2_below(4096).is_some_and(|below| below <= exact && below > exact - 10_000));
    assert_eq!((Hysteresis::None.log2_below(4), Hysteresis::Constant(rational(0, 1)).log2_below(4)), (None, None));
}

/// Bird 3 pulls bird 2 away from bird 1: held in the first step, lost in the second, by a little more than the threshold.
#[test]
fn an_edge_that_will_be_lost_is_not_held_for_good() {
    let unit = |p: i64| Rational::new(p.into(), BigInt::from(1) << 42u32);
    let numbers = |list: [i64; 3]| list.map(|p| rational(p, 2)).to_vec();
    let velocities = vec![unit(0), unit(2), unit(15)];
    let start = Start::on_the_line(numbers([0, 2, 3]), velocities, Weights::Lazy, Hysteresis::Constant(unit(4)));
    let (mut exact, mut filtered) =
        (Flock::new(&start).expect("a flock"), FilteredFlock::new(&start).expect("a flock"));
    for edges in [2, 1, 1, 1] {
        assert_eq!(filtered.step(&arithmetic::Unwatched), exact.step());
        assert_eq!((exact.network().edges().len(), filtered.network() == exact.network()), (edges, true));
    }
}

/// `n^4 log2 n` is about `2^60.4` for the first number of birds here and above `2^64` for the last.
#[test]
fn thresholds_with_exponents_beyond_an_integer_have_no_logarithm() {
    let below = |birds: usize| Hysteresis::Paper.log2_below(birds);
    assert!(below(18_000).is_some_and(|log2| log2 < -(1 << 60)));
    assert_eq!([21_000, 40_000, 70_000, usize::MAX].map(below), [None; 4]);
    assert_eq!((below(0), below(1)), (None, Some(-3)));
    let error = FlockError::ThresholdTooSmall { birds: 21_000 }.to_string();
    assert_eq!(error, "the hysteresis threshold of the paper is too small to be enclosed for 21000 birds");
}
