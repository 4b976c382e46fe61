//! The one-sided platoon in time against the two-sided one of a single car, a naive integration, and its own differential equation far out.

use arithmetic::{Interval, Rational, rational};
use models::platoon::Gains;
use models::platoon::front_in_time::FrontMotion;
use models::platoon::time_domain::{Followers, Modes};

fn interval(q: &Rational) -> Interval {
    Interval::from_rational(q, 128)
}

fn start(followers: usize) -> Followers<Rational> {
    let position = |k: i64| rational(3 * k % 7 - 3, 2);
    let velocity = |k: i64| rational(5 * k % 11 - 4, 3);
    let cars = 1..=followers as i64;
    Followers { positions: cars.clone().map(position).collect(), velocities: cars.map(velocity).collect() }
}

fn enclosed(followers: &Followers<Rational>) -> Followers<Interval> {
    let list = |list: &[Rational]| list.iter().map(interval).collect();
    Followers { positions: list(&followers.positions), velocities: list(&followers.velocities) }
}

/// Complex roots, real ones, and a double one.
fn pairs() -> [Gains<Rational>; 4] {
    [(-1, 1, -1, 1), (-1, 4, -5, 1), (-1, 1, -2, 1), (-9, 4, -3, 1)]
        .map(|(a, b, c, d)| Gains { f: rational(a, b), g: rational(c, d) })
}

/// Fourth-order steps of `e_k'' = f (e_k - e_(k-1)) + g (e_k' - e_(k-1)') + A w² cos wt`, `e_0 = 0`.
fn integrated(gains: &Gains<f64>, first: &Followers<f64>, (amplitude, w): (f64, f64), until: f64) -> Followers<f64> {
    const STEPS: usize = 4000;
    let n = first.positions.len();
    let mut state: Vec<f64> = first.positions.iter().chain(&first.velocities).copied().collect();
    let rate = |t: f64, state: &[f64]| -> Vec<f64> {
        let in_front = |k: usize, offset: usize| if k == 0 { 0.0 } else { state[offset + k - 1] };
        let force = |k: usize| {
            let (place, speed) = (state[k] - in_front(k, 0), state[n + k] - in_front(k, n));
            gains.f * place + gains.g * speed + amplitude * w * w * (w * t).cos()
        };
        state[n..].iter().copied().chain((0..n).map(force)).collect()
    };
    let h = until / STEPS as f64;
    for step in 0..STEPS {
        let t = h * step as f64;
        let moved = |by: f64, rates: &[f64]| state.iter().zip(rates).map(|(x, v)| x + by * v).collect::<Vec<f64>>();
        let a = rate(t, &state);
        let b = rate(t + h / 2.0, &moved(h / 2.0, &a));
        let c = rate(t + h / 2.0, &moved(h / 2.0, &b));
        let d = rate(t + h, &moved(h, &c));
        for (k, x) in state.iter_mut().enumerate() {
            *x += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
        }
    }
    let velocities = state.split_off(n);
    Followers { positions: state, velocities }
}

#[test]
fn motions_are_those_of_a_naive_integration() {
    for gains in pairs() {
        let float = |q: &Rational| interval(q).to_f64();
        let list = |list: &[Rational]| list.iter().map(float).collect::<Vec<f64>>();
        for followers in [1, 2, 3, 5] {
            let first = start(followers);
            let (amplitude, w) = (rational(1, 2), rational(3, 2));
            let motion = FrontMotion::new(&gains.map(interval), followers).unwrap();
            let exact = motion.behind_swinging_leader(&enclosed(&first), &interval(&amplitude), &interval(&w)).unwrap();
            let floats = Followers { positions: list(&first.positions), velocities: list(&first.velocities) };
            for until in [rational(0, 1), rational(1, 3), rational(4, 1), rational(12, 1)] {
                let found = exact.deviations(&interval(&until)).unwrap();
                let known = integrated(&gains.map(float), &floats, (float(&amplitude), float(&w)), float(&until));
                let pairs = found.positions.iter().zip(&known.positions);
                for (x, y) in pairs.chain(found.velocities.iter().zip(&known.velocities)) {
                    assert!((x.to_f64() - y).abs() < 1e-8, "{gains:?} {followers} {until}: {x} {y}");
                    assert!((x.hi().to_f64() - x.lo().to_f64()).abs() < 1e-20, "{x}");
                }
            }
        }
    }
}

/// One car that tracks the leader is the two-sided platoon of one, at any time; an interval of times contains its points.
#[test]
fn one_car_is_both_platoons() {
    for gains in pairs() {
        let gains = gains.map(interval);
        let (first, amplitude, w) = (enclosed(&start(1)), interval(&rational(1, 4)), interval(&rational(2, 3)));
        let front = FrontMotion::new(&gains, 1).unwrap().behind_swinging_leader(&first, &amplitude, &w).unwrap();
        let both = Modes::new(&gains, 1).unwrap().behind_swinging_leader(&first, &amplitude, &w).unwrap();
        for t in [0, 1, 40, 100_000] {
            let (a, b) = (
                front.deviations(&interval(&rational(t, 1))).unwrap(),
                both.deviations(&interval(&rational(t, 1))).unwrap(),
            );
            assert!(a.positions[0].overlaps(&b.positions[0]) && a.velocities[0].overlaps(&b.velocities[0]), "{t}");
        }
        let around = Interval::hull_of_rationals(&rational(7, 4), &rational(9, 4), 128);
        let (wide, point) = (front.deviations(&around).unwrap(), front.deviations(&interval(&rational(2, 1))).unwrap());
        assert!(wide.positions[0].lo() <= point.positions[0].lo() && point.positions[0].hi() <= wide.positions[0].hi());
    }
}

/// Far out only the swing is left, `a_k = gamma^-k` of the leader's.
#[test]
fn free_motions_die_out() {
    for gains in pairs() {
        let exact = gains.map(interval);
        let motion = FrontMotion::new(&exact, 12).unwrap();
        let still = interval(&rational(0, 1));
        let found = motion.behind_swinging_leader(&enclosed(&start(12)), &still, &interval(&rational(1, 1))).unwrap();
        let far = found.deviations(&interval(&rational(2000, 1))).unwrap();
        for x in far.positions.iter().chain(&far.velocities) {
            assert!(x.magnitude().to_f64() < 1e-30, "{gains:?}: {x}");
        }
    }
    // Roots that may coincide are told apart or refused.
    let nearly = Gains {
        f: interval(&rational(-1, 1)),
        g: Interval::hull_of_rationals(&rational(-2, 1), &rational(-1999, 1000), 64),
    };
    assert!(FrontMotion::new(&nearly, 2).is_err());
}
