//! What is said to be certain on a network that stays, against the formulas of `notes/exact_flocks.md` and against stepping.

use super::super::links::Links;
use super::*;
use crate::averaging::{Flock, Hysteresis, Start, Weights};
use arithmetic::{Rational, Unwatched, rational};

fn flock(x: &[(i64, i64)], v: &[(i64, i64)], weights: Weights) -> Flock {
    let numbers = |list: &[(i64, i64)]| list.iter().map(|&(p, q)| rational(p, q)).collect::<Vec<Rational>>();
    Flock::new(&Start::on_the_line(numbers(x), numbers(v), weights, Hysteresis::None)).unwrap()
}

fn balls(flock: &Flock) -> Balls<2> {
    Balls::new(&flock.integers(), Links::new(flock.network()), flock.weights(), (0, 0)).unwrap().unwrap()
}

/// The largest whole number of steps after which, and before which, the distance is certainly beyond the limit.
fn stepped(place: [f64; 2], drift: [f64; 2], limit: f64, error: f64, most: u64) -> u64 {
    let beyond = |s: u64| {
        let s = s as f64;
        (place[0] + s * drift[0]).hypot(place[1] + s * drift[1]) > limit + s * error
    };
    (0..most).take_while(|&s| beyond(s + 1)).count() as u64
}

/// Never more steps than stepping finds; for ever only where it finds no end; and hardly fewer.
#[test]
fn birds_stay_apart_as_long_as_is_said() {
    let cases = [
        ([30.0, 0.0], [-0.1, 0.0], 1.5),
        ([30.0, 1.25], [-0.1, 0.0], 1.5),
        ([30.0, 1.49], [-0.1, 0.0], 1.5),
        ([30.0, 1.51], [-0.1, 0.0], 1.5),
        ([-20.0, 21.0], [0.07, -0.07], 1.0),
        ([3.0, 4.0], [0.3, 0.1], 4.5),
        ([3.0, 4.0], [0.3, 0.1], 5.5),
        ([3.0, 4.0], [-0.004, 0.003], 2.0),
    ];
    for (place, drift, limit) in cases {
        let (distance, speed) = (norm(&place), norm(&drift));
        for error in [0.0, 1e-9, 1e-7] {
            let said = apart(&place, &drift, distance, speed, limit, error, true);
            let found = stepped(place, drift, limit, error, 20_000);
            if said == u64::MAX {
                assert_eq!(found, 20_000, "{place:?}");
            } else {
                assert!(said <= found && found <= said + 3, "{place:?} {limit} {error}: {said} {found}");
            }
            // Without a certain direction, only as long as the distance takes at full speed.
            let said = apart(&place, &drift, distance, speed, limit, error, false);
            assert_eq!(said, ((distance - limit) / (speed + error) * (1.0 - SLACK)).max(0.0) as u64);
        }
    }
    let forever = |place: [f64; 2], drift: [f64; 2], limit: f64| {
        apart(&place, &drift, norm(&place), norm(&drift), limit, 0.0, true) == u64::MAX
    };
    assert!(forever([30.0, 1.51], [-0.1, 0.0], 1.5) && !forever([30.0, 1.49], [-0.1, 0.0], 1.5));
    assert!(forever([3.0, 4.0], [0.0, 1.0], 4.9) && !forever([3.0, 4.0], [0.0, 1.0], 5.1));
    assert!(forever([3.0, 4.0], [4.0, -3.0], 4.9) && forever([3.0, 4.0], [-4.0, 3.0], 4.9));
    assert_eq!(apart(&[3.0, 0.0], &[0.0, 0.0], 3.0, 0.0, 1.0, 0.0, false), u64::MAX - 1);
}

/// Pairs of one flock: both sides of four times the stray, and edges that hysteresis holds.
#[test]
fn pairs_of_one_flock_keep_their_side() {
    let none = Threshold::new(Hysteresis::None, 3).unwrap();
    let of = |gap: (i64, i64), speed: (i64, i64)| {
        let flock =
            flock(&[(0, 1), (3, 4), (3 * gap.1 + 4 * gap.0, 4 * gap.1)], &[(0, 1), speed, (0, 1)], Weights::Lazy);
        let balls = balls(&flock);
        let whole = balls.wholes().remove(0);
        assert_eq!(whole.members, [0, 1, 2]);
        (within(&balls, &whole, &none), whole.stray, flock.network().has_edge(0, 2))
    };
    // The pair 1-2 is 1/4 from the limit, 2-3 as far as the gap says, and 1-3 is no edge.
    let (quiet, stray, _) = of((3, 4), (1, 4000));
    assert!(quiet == u64::MAX && 4.0 * stray < 0.25, "{stray}");
    let (quiet, stray, _) = of((3, 4), (1, 400));
    assert!(quiet == 0 && 4.0 * stray > 0.25, "{stray}");
    // At distance 1 to within the error nothing is certain without hysteresis.
    assert_eq!(of((1, 1), (0, 1)).0, 0);
    let held = Threshold::new(Hysteresis::Constant(rational(1, 1000)), 2).unwrap();
    let of = |speed: (i64, i64), threshold: &Threshold| {
        let pair = flock(&[(0, 1), (1, 1)], &[(0, 1), speed], Weights::Lazy);
        let balls = balls(&pair);
        within(&balls, &balls.wholes()[0], threshold)
    };
    // An edge at distance 1 is held where twice the range, four differences, is below half of 2^-12, the power of two that is taken for the threshold.
    assert_eq!((of((1, 33_000), &held), of((1, 32_000), &held), of((1, 33_000), &none)), (u64::MAX, 0, 0));
}

/// Two flocks of two and one of one: pairs that certainly drift, and for how long nothing happens.
#[test]
fn flocks_that_part_are_counted_pair_by_pair() {
    let none = Threshold::new(Hysteresis::None, 5).unwrap();
    let of = |last: (i64, i64)| {
        let (slow, fast) = ((1, 1_000_000), (1, 8));
        let flock =
            flock(&[(0, 1), (1, 2), (10, 1), (21, 2), (60, 1)], &[(0, 1), slow, fast, fast, last], Weights::Lazy);
        outlook(&balls(&flock), &none, &Unwatched).unwrap()
    };
    let all = of((1, 4));
    assert!(all.is_steady() && all.drifting == 8, "{all:?}");
    // The last one comes back to the flock at 21/2: the distance 49.5 - 1 closes at 1/8 + 1/8, in 194 steps.
    let back = of((-1, 8));
    assert!(back.drifting == 8 && (190..=194).contains(&back.quiet) && !back.is_steady(), "{back:?}");
    // Flocks at rest beside each other: no drift is certain, but it would be slow.
    let still = flock(&[(0, 1), (3, 1)], &[(1, 8), (1, 8)], Weights::Lazy);
    let still = outlook(&balls(&still), &none, &Unwatched).unwrap();
    assert!(still.drifting == 0 && !still.is_steady() && still.quiet > 1 << 40, "{still:?}");
}
