//! Distances within a hair of 1, with numbers longer than the leading bits that are looked at first.

use super::flock::Naive;
use arithmetic::{Rational, rational};
use models::averaging::{Flock, FlockError, Hysteresis, Start, Weights};
use num_bigint::BigInt;
use proptest::prelude::*;

/// `2^-bits`.
fn hair(bits: u32) -> Rational {
    Rational::new(BigInt::from(1), BigInt::from(1) << bits)
}

fn at_rest(positions: Vec<Vec<Rational>>) -> Start {
    let velocities = positions.iter().map(|x| vec![rational(0, 1); x.len()]).collect();
    Start { positions, velocities, weights: Weights::Lazy, hysteresis: Hysteresis::None }
}

/// Directions of length 1 in up to four dimensions.
fn directions() -> Vec<Vec<Rational>> {
    let vector = |x: &[i64], by: i64| x.iter().map(|&x| rational(x, by)).collect();
    vec![vector(&[1], 1), vector(&[3, -4], 5), vector(&[2, -6, 3], 7), vector(&[1, -1, 1, 1], 2)]
}

proptest! {
    #[test]
    fn pairs_near_distance_one_are_decided_as_by_rationals(
        direction in 0usize..4, bits in 10u32..200, over in -3i64..=3, far in 0i64..1000, long in 100u32..260
    ) {
        // A common denominator far beyond the window, and a place far from the origin.
        let place = rational(far, 7) + hair(long);
        let stretch = rational(1, 1) + hair(bits) * rational(over, 1);
        let direction = &directions()[direction];
        let first: Vec<Rational> = direction.iter().map(|_| place.clone()).collect();
        let second = direction.iter().map(|x| &place + x * &stretch).collect();
        let third = direction.iter().map(|x| &place - x * &stretch * rational(1, 3)).collect();
        let start = at_rest(vec![first, second, third]);
        let mut flock = Flock::new(&start).expect("a valid start");
        let naive = Naive::new(&start);
        prop_assert_eq!(flock.network(), &naive.network);
        prop_assert_eq!(&flock.distance_network(), &naive.network);
        flock.step().expect("a step");
        prop_assert_eq!(flock.network(), &naive.network);
    }
}

/// Pythagorean triples of some sixty bits: their distance is exactly 1, where floats give a little more or less.
#[test]
fn exact_distances_with_long_numbers_are_ties() {
    for k in 0..200i64 {
        let (m, n) = (BigInt::from((1i64 << 31) + 7919 * k), BigInt::from((1i64 << 30) - 104_729 * k));
        let (square, other) = (&m * &m, &n * &n);
        let over = |x: BigInt| Rational::new(x, &square + &other);
        let second = vec![over(&square - &other), over(BigInt::from(2) * m * n)];
        let mut flock = Flock::new(&at_rest(vec![vec![rational(0, 1); 2], second])).expect("a valid start");
        assert!(flock.network().has_edge(0, 1) && flock.distance_network().has_edge(0, 1), "{k}");
    }
}

/// The network of the distance rule after steps whose network was given.
/// Bird 2 comes from 2 to 1, where the birds become linked, and goes on.
#[test]
fn ties_are_those_of_the_last_decision() {
    let numbers = |list: [i64; 2]| list.map(|x| rational(x, 1)).to_vec();
    let start = Start::on_the_line(numbers([0, 2]), numbers([0, -1]), Weights::Lazy, Hysteresis::None);
    let mut flock = Flock::new(&start).expect("a flock");
    let ties = [(); 3].map(|()| flock.step().map(|_| flock.ties().to_vec()).expect("a step"));
    assert_eq!(ties, [vec![(0, 1)], vec![], vec![]]);
}

#[test]
fn the_distance_rule_is_that_of_the_present_positions() {
    let numbers = |list: [i64; 3]| list.map(|x| rational(x, 1 << 20)).to_vec();
    let (positions, velocities) = (numbers([0, 3 << 19, 3 << 20]), numbers([1 << 18, 0, -(1 << 18)]));
    let mut flock =
        Flock::new(&Start::on_the_line(positions, velocities, Weights::Lazy, Hysteresis::None)).expect("a valid start");
    let none = flock.network().clone();
    assert!(none.edges().is_empty());
    assert_eq!(flock.step().expect("a step"), None);
    for edges in [2, 2, 3] {
        flock.step_on(&none).expect("a step");
        assert_eq!(flock.distance_network().edges().len(), edges);
    }
}

#[test]
fn starts_of_different_dimensions_are_refused_where_they_differ() {
    let row = |count: usize| vec![rational(0, 1); count];
    let start = |positions: Vec<Vec<Rational>>, velocities: Vec<Vec<Rational>>| Start {
        positions,
        velocities,
        weights: Weights::Lazy,
        hysteresis: Hysteresis::None,
    };
    let refused = |start: Start| Flock::new(&start).map(drop).expect_err("refused").to_string();
    let of_velocity = refused(start(vec![row(2); 3], vec![row(2), row(1), row(3)]));
    let of_position = refused(start(vec![row(2), row(1), row(3)], vec![row(2); 3]));
    for said in [&of_velocity, &of_position] {
        assert!(said.contains("bird 2") && !said.contains("bird 3"), "{said}");
    }
    assert!(matches!(Flock::new(&start(vec![], vec![])), Err(FlockError::NoBirds)));
    assert!(matches!(Flock::new(&start(vec![row(0); 2], vec![row(0); 2])), Err(FlockError::NoBirds)));
}

/// A threshold of zero holds nothing, one that is larger holds what moves by less.
#[test]
fn thresholds_hold_what_moves_by_less() {
    let start = |hysteresis: Hysteresis, speed: Rational| Start {
        positions: vec![vec![rational(0, 1)], vec![rational(1, 1)]],
        velocities: vec![vec![rational(0, 1)], vec![speed]],
        weights: Weights::Lazy,
        hysteresis,
    };
    let slow = hair(40);
    let cases = [
        (Hysteresis::None, &slow, 0),
        (Hysteresis::Constant(rational(0, 1)), &slow, 0),
        (Hysteresis::Constant(slow.clone()), &slow, 0),
        (Hysteresis::Constant(&slow + &hair(300)), &slow, 1),
        (Hysteresis::Constant(&slow - &hair(300)), &slow, 0),
    ];
    for (hysteresis, speed, edges) in cases {
        let mut flock = Flock::new(&start(hysteresis.clone(), (*speed).clone())).expect("a valid start");
        assert_eq!(flock.network().edges().len(), 1);
        flock.step().expect("a step");
        assert_eq!(flock.network().edges().len(), edges, "{hysteresis:?}");
    }
}
