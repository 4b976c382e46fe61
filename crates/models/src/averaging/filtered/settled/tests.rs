//! Flocks of which settled ones are left behind, against the same flocks without that: the same switches, bit for bit.

use super::*;
use crate::averaging::{Flock, Hysteresis, Start, Weights};
use arithmetic::random::generator;
use arithmetic::{Rational, Unwatched, rational};
use rand_chacha::rand_core::Rng;

/// Up to 60 birds in a square, on a coarse grid (ties) or a fine one.
fn crowd(case: u64) -> Start {
    let mut random = generator("test", "settled", case);
    let mut below = |k: u32| i64::from(random.next_u32() % k);
    let birds = 3 + below(58);
    let grid = [2, 5, 1000][below(3) as usize];
    let side = 1 + below(8);
    let row = |low: i64, high: i64, unit: i64, below: &mut dyn FnMut(u32) -> i64| -> Vec<Rational> {
        (0..2).map(|_| rational(low + below((high - low) as u32), unit)).collect()
    };
    let positions = (0..birds).map(|_| row(0, side * grid, grid, &mut below)).collect();
    let slow = [8, 40, 200][below(3) as usize];
    let velocities = (0..birds).map(|_| row(-grid, grid + 1, slow * grid, &mut below)).collect();
    let weights = match below(3) {
        0 => Weights::Lazy,
        1 => Weights::Vicsek,
        _ => Weights::Given((0..birds).map(|i| rational(1, 61 + i % 3)).collect()),
    };
    let hysteresis =
        [Hysteresis::None, Hysteresis::Paper, Hysteresis::Constant(rational(1, 5000))][below(3) as usize].clone();
    Start { positions, velocities, weights, hysteresis }
}

fn behind(flock: &FilteredFlock) -> usize {
    flock.birds() - flock.names.len()
}

/// Every switch of every step, the network, and whether birds were left behind while others still changed their neighbours.
#[test]
fn who_is_left_behind_changes_nothing() {
    let (mut left, mut later) = (0, 0);
    for case in 0..160 {
        let start = crowd(case);
        let mut plain = FilteredFlock::new(&start).unwrap();
        let mut lighter = plain.clone();
        for t in 1..=1500u64 {
            if t.is_multiple_of(16) && t < 64 || t.is_multiple_of(150) {
                lighter.leave_settled(t, &Unwatched).unwrap();
            }
            let switch = plain.step(&Unwatched);
            assert_eq!(lighter.step(&Unwatched), switch, "t = {t} of case {case}: {start:?}");
            if switch.is_err() {
                break;
            }
            later += usize::from(switch.unwrap().is_some() && behind(&lighter) > 0);
        }
        assert_eq!(lighter.network(), plain.network());
        left += usize::from(behind(&lighter) > 0);
    }
    assert!(left > 30 && later > 60, "{left} {later}");
}

/// The exact twin, to the last digit, for a few birds.
#[test]
fn the_exact_flock_goes_on_with_all_birds() {
    let mut left = 0;
    for case in (0..400).filter(|&case| crowd(case).positions.len() < 12) {
        let mut exact = Flock::new(&crowd(case)).unwrap();
        let mut lighter = FilteredFlock::from_exact(exact.clone()).unwrap();
        for t in 1..=80 {
            if t % 20 == 0 {
                lighter.leave_settled(400, &Unwatched).unwrap();
            }
            assert_eq!(lighter.step(&Unwatched), exact.step(), "t = {t} of case {case}");
        }
        left += behind(&lighter);
        assert_eq!(lighter.denominator_bits(), exact.denominator_bits());
        let found = lighter.exact(&Unwatched).unwrap();
        assert_eq!((found.positions(), found.velocities()), (exact.positions(), exact.velocities()));
    }
    assert!(left > 40, "{left}");
}

fn on_the_line(x: &[(i64, i64)], v: &[(i64, i64)], weights: Weights) -> FilteredFlock {
    let numbers = |list: &[(i64, i64)]| list.iter().map(|&(p, q)| rational(p, q)).collect();
    FilteredFlock::new(&Start::on_the_line(numbers(x), numbers(v), weights, Hysteresis::None)).unwrap()
}

/// Who meets another one, however late, or could if the others of a flock turned it, is not left behind; who flies away is.
#[test]
fn who_is_met_later_is_not_left_behind() {
    let after = |x: &[(i64, i64)], v: &[(i64, i64)]| {
        let mut flock = on_the_line(x, v, Weights::Lazy);
        flock.leave_settled(10_000, &Unwatched).unwrap();
        flock.names
    };
    // A pair that oscillates across distance 1 at first, and pairs and single birds that have settled.
    let pair = [(0, 1), (19, 20)];
    let turning = [(0, 1), (1, 5)];
    let with = |list: [(i64, i64); 2], more: &[(i64, i64)]| [&list[..], more].concat();
    // The others leave for good, though the pair may turn as its fastest does.
    assert_eq!(after(&with(pair, &[(9, 1), (-9, 1)]), &with(turning, &[(1, 4), (-1, 100)])), [0, 1]);
    // One is slower than the pair may become: it is met if the faster one goes on alone.
    assert_eq!(after(&with(pair, &[(9, 1), (-9, 1)]), &with(turning, &[(19, 100), (-1, 100)])), [0, 1, 2]);
    // It comes back after a million steps.
    assert_eq!(after(&with(pair, &[(1_000_000, 1), (-9, 1)]), &with(turning, &[(-1, 1), (-2, 1)])), [0, 1, 2]);
    // Equal velocities are not known to be so.
    assert_eq!(after(&with(pair, &[(9, 1), (-9, 1)]), &with(turning, &[(1, 5), (-1, 100)])), [0, 1, 2]);
}

/// A bird that gets too many neighbours is named by its own number, whoever was left behind before.
#[test]
fn birds_keep_their_numbers() {
    let x = [(-50, 1), (0, 1), (9, 10), (36, 10)];
    let v = [(-1, 1), (0, 1), (0, 1), (-1, 10)];
    let weights = Weights::Given(vec![rational(3, 5); 4]);
    let mut plain = on_the_line(&x, &v, weights.clone());
    let mut lighter = on_the_line(&x, &v, weights);
    lighter.leave_settled(100, &Unwatched).unwrap();
    assert_eq!(lighter.names, [1, 2, 3]);
    let end = |flock: &mut FilteredFlock| (0..100).find_map(|_| flock.step(&Unwatched).err());
    let refused = end(&mut plain);
    assert!(matches!(refused, Some(FlockError::Inadmissible { .. })), "{refused:?}");
    assert_eq!(end(&mut lighter), refused);
}
