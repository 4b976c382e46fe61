//! Flocks stepped by balls against exact ones: the same networks, bit for bit.

use super::flock::starts;
use arithmetic::{Rational, Unwatched, rational};
use models::averaging::{FilteredFlock, Flock, Hysteresis, Start, Weights};
use num_traits::Pow;
use proptest::prelude::*;

fn agree(start: &Start, steps: u64) {
    let (mut exact, mut filtered) = (Flock::new(start).unwrap(), FilteredFlock::new(start).unwrap());
    for t in 1..=steps {
        assert_eq!(filtered.step(&Unwatched), exact.step(), "t = {t} of {start:?}");
        assert_eq!(filtered.network(), exact.network());
    }
    assert_eq!(filtered.time(), *exact.time());
    assert_eq!(filtered.denominator_bits(), exact.denominator_bits());
    let after = filtered.exact(&Unwatched).unwrap();
    assert_eq!((after.positions(), after.velocities()), (exact.positions(), exact.velocities()));
}

fn hysteresis() -> impl Strategy<Value = Hysteresis> {
    prop_oneof![
        Just(Hysteresis::None),
        Just(Hysteresis::Constant(rational(0, 1))),
        (1i64..40).prop_map(|k| Hysteresis::Constant(rational(k, 1600))),
        Just(Hysteresis::Paper)
    ]
}

fn weights() -> impl Strategy<Value = Weights> {
    prop_oneof![Just(Weights::Lazy), Just(Weights::Vicsek)]
}

/// Many birds in a small square, on a coarse or a fine grid.
fn crowds() -> impl Strategy<Value = Start> {
    (18usize..40, prop_oneof![Just(4i64), Just(1000i64)], 2i64..7, weights(), hysteresis()).prop_flat_map(
        |(birds, grid, side, weights, hysteresis)| {
            let rows = |range: std::ops::Range<i64>, unit: i64| {
                prop::collection::vec(prop::collection::vec(range.prop_map(move |x| rational(x, unit)), 2), birds)
            };
            (rows(0..side * grid, grid), rows(-grid..grid, 8 * grid)).prop_map(move |(positions, velocities)| Start {
                positions,
                velocities,
                weights: weights.clone(),
                hysteresis: hysteresis.clone(),
            })
        },
    )
}

/// Pieces of lattices of spacing 1, each in a motion of its own: most distances are exactly 1, or the root of 2.
fn lattices() -> impl Strategy<Value = Start> {
    let piece = (1i64..4, 1i64..4, -2i64..3, -2i64..3);
    (prop::collection::vec(piece, 1..4), weights(), hysteresis(), 1i64..30).prop_map(
        |(pieces, weights, hysteresis, unit)| {
            let (mut positions, mut velocities, mut left) = (Vec::new(), Vec::new(), 0);
            for (columns, rows, u, v) in pieces {
                for (x, y) in (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y))) {
                    positions.push(vec![rational(left + x, 1), rational(y, 1)]);
                    velocities.push(vec![rational(u, unit), rational(v, unit)]);
                }
                left += columns + 1;
            }
            Start { positions, velocities, weights, hysteresis }
        },
    )
}

/// Pairs whose distance comes to 1, or misses it, by far less than a ball shows.
fn near_ties() -> impl Strategy<Value = Start> {
    (1i64..9, 1i64..9, 1u32..700, -1i64..2, hysteresis()).prop_map(|(p, q, bits, side, hysteresis)| {
        let tiny = rational(side, 1) / Rational::from_integer(Pow::pow(num_bigint::BigInt::from(2), bits));
        let speed = rational(p, 8 * q);
        // Birds 1 and 2 come within distance 1 after eight steps but for `tiny`, by its sign; two more are far away.
        let x =
            vec![rational(0, 1), rational(1, 1) + rational(8, 1) * &speed + tiny, rational(50, 1), rational(101, 2)];
        let v = vec![speed, rational(0, 1), rational(1, 7), rational(-1, 7)];
        Start::on_the_line(x, v, Weights::Given(vec![rational(1, 1000); 4]), hysteresis)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1024))]

    #[test]
    fn small_flocks(start in starts()) {
        agree(&start, 40);
    }

    #[test]
    fn distances_of_nearly_one(start in near_ties()) {
        agree(&start, 24);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn crowds_of_birds(start in crowds()) {
        agree(&start, 40);
    }

    #[test]
    fn pieces_of_lattices(start in lattices()) {
        agree(&start, 40);
    }

    #[test]
    fn longer_runs(start in starts()) {
        agree(&start, 600);
    }
}

/// A fast bird comes from afar to birds at rest in a row, as the first and as the last by number: of more birds than are looked at one
/// by one.
#[test]
fn a_fast_bird_meets_a_row_of_birds_at_rest() {
    for first in [true, false] {
        let mut birds: Vec<(i64, i64, i64)> = (0..18).map(|k| (30 * k + k % 7, 7 * (k % 3), 0)).collect();
        birds.insert(if first { 0 } else { 18 }, (-220, 3, 7));
        let row = |x: i64, y: i64, unit: i64| vec![rational(x, unit), rational(y, unit)];
        let start = Start {
            positions: birds.iter().map(|&(x, y, _)| row(x, y, 10)).collect(),
            velocities: birds.iter().map(|&(_, _, u)| row(u, 0, 10)).collect(),
            weights: Weights::Vicsek,
            hysteresis: Hysteresis::None,
        };
        agree(&start, 60);
    }
}

#[test]
fn four_birds_under_the_threshold_of_the_paper() {
    let x = [(0, 16), (8, 16), (21, 16), (29, 16)].map(|(p, q)| rational(p, q)).to_vec();
    let v = [(1, 8), (-1, 8), (1, 8), (-1, 8)].map(|(p, q)| rational(p, q)).to_vec();
    for hysteresis in [Hysteresis::Paper, Hysteresis::None] {
        agree(&Start::on_the_line(x.clone(), v.clone(), Weights::Lazy, hysteresis), 1300);
    }
}

#[test]
fn a_start_that_does_not_fit_into_balls() {
    let far = Rational::from_integer(Pow::pow(num_bigint::BigInt::from(10), 40u32));
    let x = vec![rational(0, 1), far.clone() + rational(1, 2), far];
    agree(
        &Start::on_the_line(x, vec![rational(1, 8), rational(-1, 8), rational(0, 1)], Weights::Lazy, Hysteresis::None),
        50,
    );
}
