//! Motions with a network that switches: closed forms, ties, grazing, energy, and a twin that looks at many instants.

use arithmetic::{Rational, Unwatched, rational};
use models::double_integrator::{
    Alignment, Coordinates, EventKind, Flock, Motion, Network, Options, Pair, Potential, State, linked_within,
    random_flock,
};
use motion::Tolerance;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

const PLANE: Coordinates = Coordinates::Cartesian;

fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

/// No forces but the alignment: two linked agents keep their direction, and their relative velocity decays like `exp(-2t)`.
fn nothing() -> Potential {
    Potential::new(Vec::new(), (rational(1, 1), rational(0, 1)))
}

fn flock(potential: Potential, network: Network, agents: &[([f64; 2], [f64; 2])]) -> Flock {
    let start =
        State { positions: agents.iter().map(|a| a.0).collect(), velocities: agents.iter().map(|a| a.1).collect() };
    Flock::new(Alignment::Velocity, potential, network, start).unwrap()
}

fn run(flock: &Flock, until: f64) -> Motion {
    flock.run(until, &[until], &Options::default(), &Unwatched).unwrap()
}

fn kinds(motion: &Motion) -> Vec<(Pair, EventKind)> {
    motion.events.iter().map(|e| (e.pair, e.kind)).collect()
}

#[test]
fn an_entry_from_free_flight_is_located_to_rounding() {
    // r = (5 - t, 6/5): |r| = 2 at 5 - t = 8/5.
    let pair = [([5.0, 1.2], [-1.0, 0.0]), ([0.0, 0.0], [0.0, 0.0])];
    let motion = run(&flock(spring(), Network::Within(2.0), &pair), 3.5);
    assert_eq!(kinds(&motion), [((0, 1), EventKind::Link)]);
    assert!((motion.events[0].time - 3.4).abs() < 4e-15, "{}", motion.events[0].time);
    assert!((motion.events[0].rate + 3.2).abs() < 1e-13);
    assert!(motion.choices.is_empty() && motion.energy.is_monotone());
}

/// The exact twin: roots of the quadratic `|r + vt|² = R²` enclosed by rationals.
#[test]
fn entries_are_roots_of_quadratics() {
    let q = |n: i64| rational(n, 16);
    for (k, (x, y, u, v)) in
        [(77, 13, -20, 1), (-90, 40, 33, -12), (3, 200, 1, -64), (64, 64, -9, -10)].into_iter().enumerate()
    {
        let f = |n: i64| n as f64 / 16.0;
        let pair = [([f(x), f(y)], [f(u), f(v)]), ([0.0, 0.0], [0.0, 0.0])];
        let motion = run(&flock(spring(), Network::Within(2.0), &pair), 20.0);
        let time = motion.events[0].time;
        let value = |t: f64| -> Rational {
            let t = Rational::from_float(t).unwrap();
            let (a, b) = (q(x) + q(u) * &t, q(y) + q(v) * &t);
            &a * &a + &b * &b - rational(4, 1)
        };
        let (before, after) = (value(time * (1.0 - 1e-14)), value(time * (1.0 + 1e-14)));
        assert!(before > rational(0, 1) && after < rational(0, 1), "case {k}: {time}");
    }
}

/// Two agents pass each other at the closest distance `b`: without potential the time inside has a closed form.
#[test]
fn passages_have_their_closed_form_down_to_grazing() {
    let radius = 2.0;
    for depth in [0.1, 1e-3, 1e-6, 1e-9, 1e-11] {
        let b: f64 = radius - depth;
        let pair = [([-5.0, b], [1.0, 0.0]), ([0.0, 0.0], [0.0, 0.0])];
        let half = ((radius - b) * (radius + b)).sqrt();
        let motion = run(&flock(nothing(), Network::Within(radius), &pair), 20.0);
        let enter = 5.0 - half;
        if 4.0 * half >= 1.0 {
            assert_eq!(motion.events.len(), 1);
            continue;
        }
        assert_eq!(kinds(&motion), [((0, 1), EventKind::Link), ((0, 1), EventKind::Unlink)], "depth {depth}");
        let inside = -(1.0 - 4.0 * half).ln() / 2.0;
        // |r|² is known to a few units in the last place, its rate at the threshold is 2 half.
        let allowed = 1e-9 * half + 1e-14 / half;
        assert!((motion.events[0].time - enter).abs() < allowed, "depth {depth}");
        assert!((motion.events[1].time - enter - inside).abs() < 2.0 * allowed, "depth {depth}");
    }
    // Just outside: nothing happens.
    for depth in [1e-3, 1e-9, 1e-11] {
        let pair = [([-5.0, radius + depth], [1.0, 0.0]), ([0.0, 0.0], [0.0, 0.0])];
        assert!(run(&flock(nothing(), Network::Within(radius), &pair), 20.0).events.is_empty());
    }
}

#[test]
fn an_exact_graze_is_a_touch_and_a_choice_where_the_link_would_hold() {
    let pair = [([-5.0, 2.0], [1.0, 0.0]), ([0.0, 0.0], [0.0, 0.0])];
    // d²s/dt² = 2 without the link; 8 V'(R²) R² = 30 less with it.
    let motion = run(&flock(spring(), Network::Within(2.0), &pair), 20.0);
    assert_eq!(kinds(&motion), [((0, 1), EventKind::Touch)]);
    assert!((motion.events[0].time - 5.0).abs() < 1e-7);
    assert_eq!((motion.choices.len(), motion.choices[0].branches.len()), (1, 3));
    assert!(motion.choices[0].branches.iter().all(|b| b.decided));
    assert!((motion.samples[0].state.positions[0][0] - 15.0).abs() < 1e-12);
    // With a weak potential the pair leaves again either way: one way on.
    let weak = Potential::inverse_square_spring(&rational(1, 1), &rational(1, 20));
    let motion = run(&flock(weak, Network::Within(2.0), &pair), 20.0);
    assert_eq!((kinds(&motion), motion.choices.len()), (vec![((0, 1), EventKind::Touch)], 0));
}

/// At `R = 1/2` the spring pushes a linked pair apart with `-4 V'(1/4) R = 30`. A pair that comes straight on with the speed `u` turns at
/// the depth `u²/60` and leaves after `u/15` at its speed, but for what the alignment takes: `2 u/30` times two thirds of a part.
#[test]
fn a_pair_that_comes_straight_on_bounces_at_any_speed() {
    for speed in [1e-1, 1e-2, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6] {
        let pair = [([0.5 + speed / 4.0, 0.0], [-speed, 0.0]), ([0.0, 0.0], [0.0, 0.0])];
        let motion = run(&flock(spring(), Network::Within(0.5), &pair), 0.5);
        assert_eq!(kinds(&motion), [((0, 1), EventKind::Link), ((0, 1), EventKind::Unlink)], "{speed}");
        let rounding = 1e-14 / (speed * speed);
        let inside = motion.events[1].time - motion.events[0].time;
        assert!((inside * 15.0 / speed - 1.0).abs() < 0.1 * speed + rounding, "{speed}: {inside}");
        let after = &motion.samples[0].state;
        let apart = after.velocities[0][0] - after.velocities[1][0];
        assert!((apart / speed - 1.0).abs() < 0.1 * speed + rounding, "{speed}: {apart}");
    }
}

#[test]
fn pairs_that_arrive_together_switch_together() {
    let triples = [
        vec![([0.0, 0.0], [0.0, 0.0]), ([5.0, 0.0], [-1.0, 0.0]), ([-5.0, 0.0], [1.0, 0.0])],
        vec![([0.0, 0.0], [0.0, 0.0]), ([3.0, 4.0], [-0.6, -0.8]), ([-3.0, -4.0], [0.6, 0.8])],
        vec![([1.0, 1.0], [0.0, 0.0]), ([1.0, 6.0], [0.0, -1.0]), ([6.0, 1.0], [-1.0, 0.0])],
    ];
    for agents in triples {
        let motion = run(&flock(spring(), Network::Within(2.0), &agents), 3.1);
        assert_eq!(kinds(&motion), [((0, 1), EventKind::Link), ((0, 2), EventKind::Link)]);
        assert_eq!(motion.events[0].time, motion.events[1].time);
        assert!((motion.events[0].time - 3.0).abs() < 1e-14);
    }
    // A star of five, whose positions are rounded.
    let mut star = vec![([0.0, 0.0], [0.0, 0.0])];
    star.extend((0..5).map(|k| {
        let (y, x) = (std::f64::consts::TAU * f64::from(k) / 5.0).sin_cos();
        ([7.0 * x, 7.0 * y], [-x, -y])
    }));
    let motion = run(&flock(spring(), Network::Within(2.0), &star), 5.01);
    assert_eq!(motion.events.len(), 5);
    assert!(motion.events.iter().all(|e| e.time == motion.events[0].time && e.pair.0 == 0));
}

fn random(seed: u64, count: usize, half: f64) -> Flock {
    let start = random_flock(count, half, 1.0, &mut ChaCha8Rng::seed_from_u64(seed));
    Flock::new(Alignment::Velocity, Potential::inverse_square_log(&rational(1, 1)), Network::Within(2.0), start)
        .unwrap()
}

/// The links at many instants against the distances there: an arrival that is missed would leave them different.
#[test]
fn links_are_those_of_the_distances_at_every_instant() {
    let times: Vec<f64> = (0..=6000).map(|k| f64::from(k) / 400.0).collect();
    for seed in 0..6 {
        let motion = random(seed, 10, 3.0).run(15.0, &times, &Options::default(), &Unwatched).unwrap();
        assert!(!motion.events.is_empty());
        for sample in &motion.samples {
            let near = linked_within(&sample.state.positions, &4.0, PLANE);
            for j in 0..10 {
                for i in 0..j {
                    let off = (PLANE.square(&sample.state.separation(i, j)) - 4.0).abs();
                    assert!(
                        off < 1e-9 || near.has_edge(i, j) == sample.links.contains(&(i, j)),
                        "{seed} {}",
                        sample.time
                    );
                }
            }
        }
        // Events alternate for every pair.
        for j in 0..10 {
            for i in 0..j {
                let own: Vec<EventKind> = motion.events.iter().filter(|e| e.pair == (i, j)).map(|e| e.kind).collect();
                assert!(own.windows(2).all(|w| w[0] != w[1]), "{own:?}");
            }
        }
    }
}

#[test]
fn the_saturated_energy_neither_rises_nor_jumps() {
    for (seed, count, half) in (0..40).map(|seed| (seed, 10, 3.0)).chain([(50, 40, 6.0), (51, 3, 1.5), (52, 1, 1.0)]) {
        for relative in [1e-6, 1e-9, 1e-12] {
            let options = Options { tolerance: Tolerance { relative, absolute: relative }, ..Options::default() };
            let motion = random(seed, count, half).run(10.0, &[], &options, &Unwatched).unwrap();
            assert!(motion.energy.is_monotone(), "seed {seed}, {relative}: {:?}", motion.energy);
            assert!(motion.energy.last <= motion.energy.first);
        }
    }
}

#[test]
fn samples_do_not_change_the_motion() {
    let times: Vec<f64> = (0..=100).map(|k| f64::from(k) / 10.0).collect();
    let flock = random(3, 10, 3.0);
    let (few, many) = (run(&flock, 10.0), flock.run(10.0, &times, &Options::default(), &Unwatched).unwrap());
    assert_eq!((few.samples.last(), &few.events), (many.samples.last(), &many.events));
}

#[test]
fn threads_do_not_change_the_motion() {
    let flock = random(4, 30, 5.0);
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| run(&flock, 5.0))
    };
    assert_eq!(of(1), of(3));
}

#[test]
fn tighter_tolerances_converge() {
    let flock = random(5, 8, 2.5);
    let of = |relative: f64| {
        let options = Options { tolerance: Tolerance { relative, absolute: relative }, ..Options::default() };
        flock.run(6.0, &[6.0], &options, &Unwatched).unwrap()
    };
    let best = of(1e-13);
    for relative in [1e-7, 1e-9, 1e-11] {
        let found = of(relative);
        assert_eq!(kinds(&found), kinds(&best));
        let late = found.events.iter().zip(&best.events).map(|(a, b)| (a.time - b.time).abs()).fold(0.0, f64::max);
        let places = found.samples[0].state.positions.iter().zip(&best.samples[0].state.positions);
        let off = places.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max);
        assert!(late < 1e4 * relative && off < 1e4 * relative, "{relative}: {late} {off}");
    }
}
