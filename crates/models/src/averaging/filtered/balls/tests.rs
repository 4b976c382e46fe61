//! Balls against exact flocks: the exact state lies in them, and each bound is the one of `notes/exact_flocks.md`, by the numbers of its steps.

use super::*;
use crate::averaging::{Flock, Hysteresis, Start};
use algebra::graph::Graph;
use arithmetic::{Unwatched, rational};
use num_traits::{Pow, ToPrimitive};

/// Limbs of the balls here.
const L: usize = 2;

/// A bent path of three birds, a pair, and one alone, all slow; coordinates that are no binary fractions.
fn start(dimension: usize, weights: Weights) -> Start {
    let places = [(0, 0), (7, 3), (14, 0), (40, 1), (47, -2), (90, 5)];
    let row = |(x, y): (i64, i64)| {
        (0..dimension)
            .map(|k| [rational(x, 9), rational(y, 9), rational(x - y, 70), rational(2 * y, 35)][k].clone())
            .collect()
    };
    let speed = |i: i64| (0..dimension as i64).map(|k| rational((5 * i + 3 * k) % 7 - 3, 900 + k)).collect();
    Start {
        positions: places.map(row).to_vec(),
        velocities: (0..6).map(speed).collect(),
        weights,
        hysteresis: Hysteresis::None,
    }
}

fn balls(flock: &Flock) -> Balls<L> {
    Balls::new(&flock.integers(), flock.network().clone(), flock.weights(), (0, 0)).unwrap().unwrap()
}

/// Whether the state of the flock lies in the balls (step 1).
fn hold(balls: &Balls<L>, flock: &Flock) -> bool {
    let near = |list: &[Words<L>], rows: Vec<Vec<Rational>>, error: u128| {
        let unit = Rational::from_integer(Pow::pow(BigInt::from(2), balls.fraction));
        let error = Rational::from_integer(BigInt::from(error));
        list.iter().zip(rows.into_iter().flatten()).all(|(word, x)| {
            let off = Rational::from_integer(word.to_integer()) - x * &unit;
            off <= error && -off <= error
        })
    };
    near(&balls.positions, flock.positions(), balls.position_error)
        && near(&balls.velocities, flock.velocities(), balls.velocity_error)
}

/// The pairs that the step changed.
fn changed(before: &Graph, after: &Graph) -> Vec<(u32, u32)> {
    let n = before.order();
    let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (j, i)));
    pairs.filter(|&(i, j)| before.has_edge(i, j) != after.has_edge(i, j)).map(|(i, j)| (i as u32, j as u32)).collect()
}

/// Steps 2 to 4, for one to four coordinates and each kind of weights.
#[test]
fn the_exact_state_stays_in_the_balls() {
    let given = Weights::Given((2..8).map(|k| rational(2, 3 * k)).collect());
    for weights in [Weights::Lazy, Weights::Vicsek, given] {
        for dimension in 1..=4 {
            let mut flock = Flock::new(&start(dimension, weights.clone())).unwrap();
            let mut balls = balls(&flock);
            assert!(hold(&balls, &flock) && (balls.position_error, balls.velocity_error) == (1, 1));
            for t in 1..=30u64 {
                let before = flock.network().clone();
                flock.step().unwrap();
                balls.step(&changed(&before, flock.network())).unwrap();
                assert!(hold(&balls, &flock), "{dimension} coordinates, t = {t}");
                let (t, lost) = (u128::from(t), L as u128 + 2);
                assert_eq!(balls.velocity_error, 1 + lost * t);
                assert_eq!(balls.position_error, 1 + t + lost * t * (t - 1) / 2);
                assert_eq!((u128::from(balls.time), u128::from(balls.room)), (t, (1 << 32) - t));
            }
        }
    }
}

/// Ten birds that fly past each other: weights follow the networks.
#[test]
fn weights_follow_the_changes_of_the_network() {
    let place = |i: i64| vec![rational(2 * (7 * i % 10), 5), rational(2 * (3 * i % 10), 5)];
    let weak = Weights::Given((0..10).map(|i| rational(1, 200 + i)).collect());
    for (weights, slow, least) in [(Weights::Vicsek, 1, 2), (weak, 10, 4)] {
        let speed = |i: i64| vec![rational(5 * i % 7 - 3, 3 * slow), rational(4 * i % 9 - 4, 4 * slow)];
        let (positions, velocities) = ((0..10).map(place).collect(), (0..10).map(speed).collect());
        let start = Start { positions, velocities, weights, hysteresis: Hysteresis::None };
        let mut flock = Flock::new(&start).unwrap();
        let (mut stepped, mut followed, mut changes) = (balls(&flock), balls(&flock), Vec::new());
        for time in 1..=25 {
            let before = flock.network().clone();
            flock.step().unwrap();
            let pairs = changed(&before, flock.network());
            stepped.step(&pairs).unwrap();
            assert!(hold(&stepped, &flock), "t = {time}");
            if !pairs.is_empty() {
                changes.push(Change { time, pairs });
            }
        }
        assert!(changes.len() >= least, "{changes:?}");
        followed.follow(&changes, 25, &Unwatched).unwrap();
        assert_eq!((followed.positions, followed.velocities), (stepped.positions, stepped.velocities));
        assert_eq!((followed.time, followed.applied), (25, changes.len()));
    }
}

/// 128 bits less those of the largest number, its sign, 32 for the steps, and those of the sums over all birds.
#[test]
fn resolution_leaves_room_for_steps_and_sums() {
    let of = |position: i64, velocity: i64, unit: u32, birds: usize| {
        let rows = |x: i64| vec![vec![BigInt::from(x)]; birds];
        let state = IntegerState { positions: rows(position), velocities: rows(velocity), unit: BigInt::from(unit) };
        let network = Graph::empty(birds);
        Balls::<L>::new(&state, network, &Weights::Lazy, (3, 2)).unwrap().map(|b| (b.fraction, b.time, b.applied))
    };
    assert_eq!(of(5, 0, 1, 6), Some((128 - 32 - 4 - 6, 3, 2)));
    assert_eq!(of(0, 5, 1, 6), Some((128 - 32 - 4 - 6, 3, 2)));
    assert_eq!(of(5, 100, 1, 7), Some((128 - 32 - 8 - 6, 3, 2)));
    assert_eq!(of(5, 0, 1, 8), Some((128 - 32 - 4 - 7, 3, 2)));
    assert_eq!(of(5 * 1024, 0, 1024, 6), Some((128 - 32 - 4 - 6, 3, 2)));
    assert_eq!(of(1, 1, 1 << 20, 6), Some((128 - 32 - 6, 3, 2)));
    assert_eq!(of(1 << 55, 0, 1, 6), Some((33, 3, 2)));
    assert_eq!(of(1 << 56, 0, 1, 6), None);
}

#[test]
fn resolution_is_given_up_for_room() {
    let mut flock = Flock::new(&start(2, Weights::Lazy)).unwrap();
    let mut balls = balls(&flock);
    let fraction = balls.fraction;
    balls.room = 0;
    (balls.position_error, balls.velocity_error) = ((1 << 34) + 9, (1 << 33) + 5);
    balls.step(&[]).unwrap();
    flock.step().unwrap();
    assert_eq!((balls.position_error, balls.velocity_error), (4 + 2 + 2 + 2, 2 + 2 + L as u128 + 2));
    assert_eq!((balls.fraction, balls.room), (fraction - 32, (1 << 32) - 1));
    assert!(hold(&balls, &flock));
    // What is left of the resolution, and then nothing: they hold everything.
    while balls.fraction > 0 {
        let before = balls.fraction;
        balls.coarsen();
        assert_eq!((balls.fraction, balls.room), (before - before.min(32), 1 << before.min(32)));
        assert!(hold(&balls, &flock));
    }
    balls.coarsen();
    assert_eq!((balls.position_error, balls.velocity_error, balls.room), (u128::MAX, u128::MAX, u64::MAX));
}

/// Differences of two birds in floats and in integers, coordinate by coordinate.
#[test]
fn differences_are_those_of_the_birds() {
    for dimension in [1, 3] {
        let flock = Flock::new(&start(dimension, Weights::Lazy)).unwrap();
        let balls = balls(&flock);
        let (x, v) = (flock.positions(), flock.velocities());
        let unit = 2f64.powi(-(balls.fraction as i32));
        let (positions, velocities) = balls.floats();
        for (i, j) in [(2, 0), (1, 4), (5, 3)] {
            let pair = balls.pair(i, j);
            for k in 0..dimension {
                let (dx, dv) = (&x[i][k] - &x[j][k], &v[i][k] - &v[j][k]);
                let next = &dx + &dv;
                let close = |found: f64, exact: &Rational| (found - exact.to_f64().unwrap()).abs() < 1e-14;
                let integer = |found: &BigInt, exact: &Rational| close(found.to_f64().unwrap() * unit, exact);
                assert!(
                    close(balls.position_difference(i, j, k), &dx) && close(balls.velocity_difference(i, j, k), &dv)
                );
                let (now, moved) = balls.next_difference(i, j, k);
                assert!(close(now, &next) && close(moved, &dv));
                assert!(integer(&pair.now[k], &next) && integer(&pair.moved[k], &dv));
                assert!(
                    close(positions[i * dimension + k], &x[i][k]) && close(velocities[i * dimension + k], &v[i][k])
                );
            }
            assert_eq!((pair.now_error, pair.moved_error, pair.fraction), (4.into(), 2.into(), balls.fraction));
        }
        let mut wide = balls;
        (wide.position_error, wide.velocity_error) = (1000, 70);
        let pair = wide.pair(0, 1);
        assert_eq!((pair.now_error, pair.moved_error), (2140.into(), 140.into()));
        let (position, velocity) = wide.errors();
        assert!((1000.0 * unit..1000.01 * unit).contains(&position) && position > 1000.0 * unit);
        assert!((70.0 * unit..70.001 * unit).contains(&velocity) && velocity > 70.0 * unit);
    }
}

/// Step 14: the mean is rounded down, the bounds grow by `s (e_v + 2) + 2Z` and by `2 + max|u|` and a unit each, and the exact state lies in what results.
#[test]
fn jumps_keep_the_exact_state() {
    for (dimension, weights) in [(1, Weights::Lazy), (2, Weights::Vicsek)] {
        let mut flock = Flock::new(&start(dimension, weights.clone())).unwrap();
        let mut balls = balls(&flock);
        for _ in 0..80 {
            let before = flock.network().clone();
            flock.step().unwrap();
            balls.step(&changed(&before, flock.network())).unwrap();
        }
        let network = flock.network().clone();
        let members = vec![0, 1, 2];
        let reciprocal = |i: usize| weights.of(balls.network.degree(i), i).unwrap().recip();
        let total = members.iter().map(|&i| reciprocal(i)).sum::<Rational>();
        let mean = balls.mean(&members).unwrap();
        for (k, mean) in mean.iter().enumerate() {
            let whole = |i: usize| Rational::from_integer(balls.velocities[i * dimension + k].to_integer());
            let exact = members.iter().map(|&i| whole(i) * reciprocal(i)).sum::<Rational>() / &total;
            assert_eq!(mean.to_integer(), exact.floor().to_integer());
        }
        assert_eq!(balls.mean(&[5]).unwrap(), balls.velocities[5 * dimension..]);
        let wholes = balls.wholes();
        let most = |of: fn(&Whole) -> f64| wholes.iter().map(of).fold(0.0, f64::max) / balls.scales[0];
        let (stray, range) = (2.0 * most(|w| w.stray), most(|w| w.range));
        assert!(stray > 1000.0 && range > 10.0);
        let drift = balls.velocity_error + 2;
        let mut jumped = balls.clone();
        assert!(jumped.jump(300));
        assert_eq!(jumped.position_error, balls.position_error + 300 * drift + stray as u128 + 1);
        assert_eq!(jumped.velocity_error, drift + range as u128 + 1);
        assert_eq!((jumped.time, jumped.room), (380, balls.room - 300));
        for _ in 0..300 {
            flock.step_on(&network).unwrap();
        }
        assert!(hold(&jumped, &flock));
        // All of the room, and not more; nor what costs more than half of the bits.
        let mut short = balls.clone();
        short.room = 300;
        assert!(!short.clone().jump(301) && short.jump(300) && short.room == 0);
        let most = ((2f64.powi(balls.fraction as i32 / 2) - stray) / drift as f64) as u64;
        let mut long = Balls { room: u64::MAX, ..balls };
        assert!(!long.clone().jump(most + 2) && long.jump(most));
    }
}

/// The exact state lies in what leaps lead to, from small and from large velocities, and little precision is lost.
#[test]
fn leaps_keep_the_exact_state() {
    for (dimension, weights, quiet) in [(1, Weights::Lazy, 0), (2, Weights::Vicsek, 40), (4, Weights::Lazy, 3)] {
        let mut flock = Flock::new(&start(dimension, weights)).unwrap();
        let mut balls = balls(&flock);
        let network = flock.network().clone();
        for _ in 0..quiet {
            flock.step_on(&network).unwrap();
            balls.step(&[]).unwrap();
        }
        for steps in [250, 301] {
            let before = (balls.position_error, balls.velocity_error, balls.room, balls.time);
            assert!(balls.leap(steps), "{steps}");
            for _ in 0..steps {
                flock.step_on(&network).unwrap();
            }
            assert!(hold(&balls, &flock));
            assert_eq!((balls.room, balls.time), (before.2 - steps, before.3 + steps));
            assert!(balls.velocity_error < before.1 + (1 << 40) && balls.position_error < before.0 + (1 << 50));
        }
        balls.room = 299;
        assert!(!balls.leap(300));
    }
}

/// A distance of at most 1 is certain exactly where the farthest corner of the box is that near; a larger one is claimed only where all corners are farther away.
#[test]
fn near_is_decided_by_the_corners() {
    let side = 8i64;
    let mut decided = [0; 3];
    for (x, y, e) in (-10..=10).flat_map(|x| (-10..=10).flat_map(move |y| (0..=2).map(move |e| (x, y, e)))) {
        let big = |list: &[i64]| list.iter().map(|&x| BigInt::from(x)).collect::<Vec<_>>();
        let pair = PairBall {
            now: big(&[x, y]),
            moved: big(&[0, 0]),
            now_error: e.into(),
            moved_error: 0.into(),
            fraction: 3,
        };
        let far = (x.abs() + e).pow(2) + (y.abs() + e).pow(2);
        let margin = (2 * x.abs() + e) * e + (2 * y.abs() + e) * e;
        let expected =
            if far <= side * side { Some(true) } else { (x * x + y * y - margin > side * side).then_some(false) };
        assert_eq!(pair.is_near(), expected, "{x}, {y}, {e}");
        let reach = |x: i64| (x.abs() - e).max(0);
        assert!(expected != Some(false) || reach(x).pow(2) + reach(y).pow(2) > side * side);
        decided[expected.map_or(2, usize::from)] += 1;
    }
    assert!(decided.iter().all(|&count| count > 50), "{decided:?}");
}

/// Under the threshold 1/8, in units of 1/64: what is claimed holds for every state in the box; and it is claimed where the bounds of step 5 leave it.
#[test]
fn held_is_decided_for_the_whole_box() {
    let threshold = Threshold::new(Hysteresis::Constant(rational(1, 8)), 2).unwrap();
    let (limit, mut decided) = (8i64, [0; 3]);
    let axis =
        |now: std::ops::RangeInclusive<i64>| now.step_by(7).flat_map(|x| (-12..=12i64).step_by(2).map(move |v| (x, v)));
    for ((x, v), (y, u), (e, m)) in axis(-70..=70).flat_map(|a| {
        [(0, 0), (40, 5), (-33, 9)]
            .into_iter()
            .flat_map(move |b| [(0, 0), (1, 1), (2, 0), (0, 2)].map(move |errors| (a, b, errors)))
    }) {
        let big = |list: [i64; 2]| list.map(BigInt::from).to_vec();
        let pair =
            PairBall { now: big([x, y]), moved: big([v, u]), now_error: e.into(), moved_error: m.into(), fraction: 6 };
        let found = pair.is_held(&threshold);
        let length = |a: i64, b: i64| ((a * a + b * b) as f64).sqrt();
        let box_of = |c: i64, r: i64| [c - r, c, c + r];
        for (x, y) in box_of(x, e).into_iter().flat_map(|x| box_of(y, e).map(|y| (x, y))) {
            for (v, u) in box_of(v, m).into_iter().flat_map(|v| box_of(u, m).map(|u| (v, u))) {
                let change = (length(x, y) - length(x - v, y - u)).abs();
                assert!(found != Some(true) || change < limit as f64 + 1e-9, "{x} {y} {v} {u}");
                assert!(found != Some(false) || change > limit as f64 - 1e-9, "{x} {y} {v} {u}");
            }
        }
        let error: i64 = [(x, v), (y, u)]
            .iter()
            .map(|&(x, v)| (2 * x - v).abs() * m + v.abs() * (2 * e + m) + m * (2 * e + m))
            .sum();
        let change = (v * (2 * x - v) + u * (2 * y - u)).abs();
        let roots = (x * x + y * y).isqrt() + ((x - v).pow(2) + (y - u).pow(2)).isqrt();
        let roots_error = (2 * e + m) * 2 + 2;
        let expected = if change - error > 0 && change - error > limit * (roots + roots_error) {
            Some(false)
        } else {
            (change + error < limit * (roots - roots_error).max(0)).then_some(true)
        };
        assert_eq!(found, expected, "{x} {y} {v} {u} {e} {m}");
        decided[expected.map_or(2, usize::from)] += 1;
    }
    assert!(decided.iter().all(|&count| count > 50), "{decided:?}");
}
