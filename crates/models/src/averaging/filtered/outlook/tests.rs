//! What is said to be certain on a network that stays, against the formulas of `notes/exact_flocks.md` and against stepping.

use super::*;
use crate::averaging::{Flock, Hysteresis, Start, Weights};
use arithmetic::random::generator;
use arithmetic::{Rational, Unwatched, rational};
use rand_chacha::rand_core::Rng;

fn flock(x: &[(i64, i64)], v: &[(i64, i64)], weights: Weights) -> Flock {
    let numbers = |list: &[(i64, i64)]| list.iter().map(|&(p, q)| rational(p, q)).collect::<Vec<Rational>>();
    Flock::new(&Start::on_the_line(numbers(x), numbers(v), weights, Hysteresis::None)).unwrap()
}

fn balls(flock: &Flock) -> Balls<2> {
    Balls::new(&flock.integers(), flock.network().clone(), flock.weights(), (0, 0)).unwrap().unwrap()
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

fn seen(flock: &Flock, threshold: &Threshold) -> Outlook {
    outlook(&balls(flock), threshold, &Classes::default(), u64::MAX, &Unwatched).unwrap()
}

/// Two birds at 3/4 of which the relative velocity is -1/3 of the one before: in the end they are 3/4 w farther apart, after the first step w.
#[test]
fn pairs_of_one_flock_keep_their_side() {
    let none = Threshold::new(Hysteresis::None, 2).unwrap();
    let quiet = |speed: (i64, i64)| {
        let flock = flock(&[(0, 1), (3, 4)], &[(0, 1), speed], Weights::Lazy);
        seen(&flock, &none).quiet
    };
    assert_eq!([(6, 25), (-1, 1), (0, 1)].map(quiet), [u64::MAX; 3]);
    assert_eq!([(13, 50), (1, 3), (1, 2)].map(quiet), [0; 3]);
    // At distance 1 to within the error nothing is certain without hysteresis.
    let held = Threshold::new(Hysteresis::Constant(rational(1, 1000)), 2).unwrap();
    let of = |speed: (i64, i64), threshold: &Threshold| {
        seen(&flock(&[(0, 1), (1, 1)], &[(0, 1), speed], Weights::Lazy), threshold).quiet
    };
    // An edge at distance 1 is held where twice the range, four differences, is below half of 2^-12, the power of two that is taken for the threshold.
    assert_eq!((of((1, 33_000), &held), of((1, 32_000), &held), of((1, 33_000), &none)), (u64::MAX, 0, 0));
}

/// The exact twin: while nothing is said to change, nothing does; and where something does soon, hardly less is said.
#[test]
fn nothing_changes_as_long_as_is_said() {
    const STEPS: u64 = 300;
    let (mut ever, mut sharp, mut late) = (0, 0, 0);
    for case in 0..150 {
        let mut random = generator("test", "outlook", case);
        let mut below = |k: u32| i64::from(random.next_u32() % k);
        let (n, dimension) = (2 + below(9) as usize, 1 + (case % 3) as usize);
        let side = [6, 3, 2][dimension - 1] * 256;
        let mut rows = |most: u32, unit: i64| -> Vec<Vec<Rational>> {
            (0..n)
                .map(|_| (0..dimension).map(|_| rational(below(most) - i64::from(most) / 2, unit)).collect())
                .collect()
        };
        let start = Start {
            positions: rows(side, 256),
            velocities: rows(64, 1 << (9 + 2 * (case % 4))),
            weights: [Weights::Lazy, Weights::Vicsek][case as usize % 2].clone(),
            hysteresis: if case % 5 == 0 { Hysteresis::Constant(rational(1, 4096)) } else { Hysteresis::None },
        };
        let threshold = Threshold::new(start.hysteresis.clone(), n).unwrap();
        let mut exact = Flock::new(&start).unwrap();
        for _ in 0..case % 7 {
            exact.step().unwrap();
        }
        let said = seen(&exact, &threshold);
        let first = (0..STEPS).find(|_| exact.step().unwrap().is_some());
        if let Some(first) = first {
            assert!(said.quiet <= first, "{case}: {said:?}, but {first}");
            sharp += usize::from(said.quiet + 2 + first / 20 >= first);
            late += usize::from(said.quiet + 2 + first / 20 < first);
        }
        ever += usize::from(said.is_steady());
    }
    assert!(ever > 20 && sharp > 50 && late < sharp / 4, "{ever} {sharp} {late}");
}

/// Two flocks of two and one of one: pairs that certainly drift, and for how long nothing happens.
#[test]
fn flocks_that_part_are_counted_pair_by_pair() {
    let none = Threshold::new(Hysteresis::None, 5).unwrap();
    let of = |last: (i64, i64)| {
        let (slow, fast) = ((1, 1_000_000), (1, 8));
        let flock =
            flock(&[(0, 1), (1, 2), (10, 1), (21, 2), (60, 1)], &[(0, 1), slow, fast, fast, last], Weights::Lazy);
        seen(&flock, &none)
    };
    let all = of((1, 4));
    assert!(all.is_steady() && all.drifting == 8, "{all:?}");
    // Beside one another two of the three flocks do not drift, or not certainly.
    assert_eq!(of((1, 8)).drifting, 0);
    // The last one comes back to the flock at 21/2: the distance 49.5 - 1 closes at 1/8 + 1/8, in 194 steps.
    let back = of((-1, 8));
    assert!((190..=194).contains(&back.quiet), "{back:?}");
    // Flocks at rest beside each other: no drift is certain, but it would be slow.
    let still = flock(&[(0, 1), (3, 1)], &[(1, 8), (1, 8)], Weights::Lazy);
    let said = seen(&still, &none);
    assert!(said.drifting == 0 && !said.is_steady() && said.quiet > 1 << 40, "{said:?}");
    // Known to move alike they stay apart for ever.
    let mut classes = Classes::default();
    classes.note((0, 1), || vec![0, 0]);
    let said = outlook(&balls(&still), &none, &classes, u64::MAX, &Unwatched).unwrap();
    assert_eq!((said.quiet, said.drifting), (u64::MAX, 0));
}
