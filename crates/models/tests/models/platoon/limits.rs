//! Limits of long platoons in closed form, and passages of a car whose motion is known.

use arithmetic::{Field, Interval, Number, Real, Ring, parse_rational, rational};
use models::platoon::next_order::{amplitude_limit, frequency_limit};
use models::platoon::time_domain::{Modes, StopAndGo};
use models::platoon::{Gains, theorem1};
use std::f64::consts::{PI, TAU};

const PRECISION: u32 = 160;

fn gains(f: i64, g: i64) -> Gains<Interval> {
    Gains { f: rational(f, 1), g: rational(g, 1) }.map(|q| Interval::from_rational(q, PRECISION))
}

/// With `f = -4` and `g = -6`, `b = 3`.
#[test]
fn limits_of_long_platoons_in_closed_form() {
    let gains = gains(-4, -6);
    let (pi, root) = (gains.f.pi(), gains.f.integer(2).sqrt().unwrap());
    // -2 (pi³/(16 sqrt2)) (1/12 + 9/8) and sqrt2 (3 (36 - pi²)/96 - 1/36).
    let cube = pi.clone() * &pi * &pi;
    let frequency = cube * &root * gains.f.rational(&rational(-29, 384));
    let amplitude = root * (gains.f.rational(&rational(79, 72)) - pi.square() * gains.f.rational(&rational(1, 32)));
    for (found, expected) in
        [(frequency_limit(&gains).unwrap(), frequency), (amplitude_limit(&gains).unwrap(), amplitude)]
    {
        assert!(found.overlaps(&expected) && found.width().top() < -140 && expected.width().top() < -140);
    }
}

/// The resonance of 10 000 cars with `f = g = -1`, from the Arb peer. By the bounds of `next_order` the frequency is off by at most
/// `1.7 a0^4 w_0 M³ < 3e-8`, the amplitude by at most `11 a0^4 A_0 M < 2e-7`, with `a0² = pi²/(8 M²)`.
#[test]
fn limits_are_where_a_long_platoon_is() {
    let unit = gains(-1, -1);
    let digits = |text: &str| Interval::from_rational(&parse_rational(text).unwrap(), PRECISION);
    let m = unit.f.integer(10_000);
    let omega = digits("0.0001110720731684806586221164") - theorem1::frequency(&unit, 10_000).unwrap();
    let scaled = omega * &m * &m * &m;
    assert!((scaled - frequency_limit(&unit).unwrap()).to_f64().abs() < 3e-8);
    let amplitude = digits("11463.18339172372061377134") - theorem1::amplitude(&unit, 10_000).unwrap();
    assert!((amplitude * &m - amplitude_limit(&unit).unwrap()).to_f64().abs() < 2e-7);
}

/// One car with `e'' = f e + g e' - a`, whose free motion is `C(t) = e^{-t/5} (cos t + sin t/5)` times the start: behind a leader with
/// `a = 1` for one period `e` is then a multiple of `C(t)`, zero where `cot t = -1/5`.
fn one_car() -> StopAndGo<f64> {
    let modes = Modes::new(&Gains { f: -1.04, g: -0.4 }, 1).unwrap();
    modes.behind_accelerating_leader(&[(0.0, 1.0), (TAU, -1.0)]).unwrap()
}

#[test]
fn passages_of_one_car_are_half_a_turn_apart() {
    let first = TAU + PI / 2.0 + 0.2f64.atan();
    let found = one_car().passages(7.0, 0.1, (3, 200)).unwrap();
    assert_eq!(found.len(), 3);
    for (k, t) in found.iter().enumerate() {
        // Bisected to 0.1/2^40; the floats are off by some units of the last place.
        assert!((t - first - k as f64 * PI).abs() < 1e-12, "{k} {t}");
    }
    // The second is at 11.19, after 40 steps; another start leaves out the first.
    assert_eq!(one_car().passages(7.0, 0.1, (3, 40)).unwrap().len(), 1);
    let later = one_car().passages(9.0, 0.1, (1, 200)).unwrap();
    assert!(later.len() == 1 && (later[0] - first - PI).abs() < 1e-12, "{later:?}");
}
