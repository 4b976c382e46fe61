//! Mirrors `src/platoon`: the law, the response, the resonance against naive twins.

mod by_definition;
mod front;
mod graphs_and_time;
mod growth;
mod limits;
mod line;
mod matrices;
mod observed;
mod own_gains;
mod peak;
mod peaks;

use arithmetic::{
    Complex, Dual, Field, Interval, Number, Rational, Real, Ring, Signed, parse_rational, rational, significant_digits,
};
use models::platoon::{
    Communication, Gains, LARGEST_DIGITS, LARGEST_FOLLOWERS, ResonanceError, accelerations, amplitude_one_sided,
    amplitudes_two_sided, chebyshev, frequency_response, resonance, strongest_one_sided_square, theorem1,
};
use proptest::prelude::*;

fn gains(f: &str, g: &str) -> Gains<Rational> {
    Gains { f: parse_rational(f).unwrap(), g: parse_rational(g).unwrap() }
}

/// log of the last amplitude in plain floats, by the product over the modes: an independent formula.
fn log_amplitude(f: f64, g: f64, m: u64, w: f64) -> f64 {
    let (s, b) = (w * w / -f, g * g / -f);
    let mode = |k: u64| {
        let d = 1.0 - ((2 * k - 1) as f64 * std::f64::consts::PI / (2 * m) as f64).cos();
        // |gamma - cos|² = ((s - d)² + b s d²)/(1 + b s), and T_M = 2^(M-1) prod.
        (4.0 * ((s - d).powi(2) + b * s * d * d) / (1.0 + b * s)).ln()
    };
    -0.5 * ((1..=m).map(mode).sum::<f64>() - 4f64.ln())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// No frequency of a fine grid does better than the enclosed one, and the value at it is the enclosed one.
    #[test]
    fn nothing_beats_the_resonance(m in 1u64..40, f in 1i64..400, g in 1i64..4000) {
        let exact = Gains { f: rational(-f, 20), g: rational(-g, 20) };
        let found = resonance(&exact, m, 12).unwrap();
        let (f, g) = (-(f as f64) / 20.0, -(g as f64) / 20.0);
        let (w, a) = (found.omega.to_f64(), found.amplitude.to_f64());
        let best = log_amplitude(f, g, m, w);
        // m factors, each with a few roundings.
        let tolerance = 1e-13 * (m as f64 + 1.0);
        prop_assert!((best - a.ln()).abs() < tolerance, "{best} {}", a.ln());
        for k in 1..4000 {
            let other = 4.0 * (-f).sqrt() * k as f64 / 4000.0;
            prop_assert!(log_amplitude(f, g, m, other) <= best + tolerance);
        }
        for k in -200i32..200 {
            let near = w * (1.0 + f64::from(k) * 1e-3);
            prop_assert!(log_amplitude(f, g, m, near) <= best + tolerance);
        }
    }

    /// F' changes sign across the enclosure, by exact rational evaluation of F itself on both sides.
    #[test]
    fn the_response_falls_on_both_sides(m in 2u64..30, f in 1i64..40, g in 1i64..400) {
        let exact = Gains { f: rational(-f, 7), g: rational(-g, 7) };
        let found = resonance(&exact, m, 12).unwrap();
        let (lo, hi) = found.omega.to_rationals();
        let value = |w: &Rational| frequency_response(&exact, m, w, |d| chebyshev(m, d)).unwrap();
        prop_assert!(value(&lo).slope.is_certainly_negative() || value(&lo).slope == rational(0, 1));
        prop_assert!(value(&hi).slope.is_certainly_positive() || value(&hi).slope == rational(0, 1));
        prop_assert!(significant_digits(&found.omega) >= 12 && significant_digits(&found.amplitude) >= 12);
        // The amplitude at an end of the enclosure cannot exceed the enclosure of the maximum.
        let (_, top) = found.amplitude.to_rationals();
        prop_assert!(value(&lo).inverse_square.recip() <= top.square());
    }

    /// The step of notes/resonance.md that covers strong damping: h' > 0 at every zero of h with w² g² >= 4 f². Here: the
    /// derivative of F has at most one change of sign over the whole range where that holds.
    #[test]
    fn strongly_damped_platoons_have_one_peak(m in 2u64..25, beta in 1f64..1e6) {
        let d: Vec<f64> = (1..=m).map(|k| 1.0 - ((2 * k - 1) as f64 * std::f64::consts::PI / (2 * m) as f64).cos()).collect();
        let h = |s: f64| -> f64 {
            let p = beta * s * s + 2.0 * s;
            d.iter().map(|d| (p - 2.0 * d) / ((s - d).powi(2) + beta * s * d * d)).sum()
        };
        let start: f64 = 4.0 / beta;
        let mut positive = h(start) > 0.0;
        for k in 1..3000 {
            let s = start * (1.0 + 0.01f64).powi(k);
            let now = h(s) > 0.0;
            prop_assert!(now || !positive, "a passage from plus to minus at s = {s}");
            positive = now;
        }
    }

    /// The closed amplitudes satisfy the law, system by system.
    #[test]
    fn amplitudes_satisfy_the_law(m in 1usize..9, f in 1i64..30, g in 1i64..30, w in 1i64..40) {
        let real = Gains { f: rational(-f, 6), g: rational(-g, 6) };
        let w = rational(w, 10);
        let complex = real.map(|x| Complex::real(x.clone()));
        let iw = Complex::new(rational(0, 1), w.clone());
        for communication in [Communication::Front, Communication::FrontAndBack] {
            let amplitudes = match communication {
                Communication::Front => (1..=m as u64).map(|k| amplitude_one_sided(&real, &w, k).unwrap()).collect(),
                Communication::FrontAndBack => amplitudes_two_sided(&real, &w, m).unwrap(),
            };
            let rates: Vec<_> = amplitudes.iter().map(|a: &Complex<Rational>| a.clone() * &iw).collect();
            let forces = accelerations(communication, &complex, (&iw.one(), &iw), &amplitudes, &rates);
            for (rate, force) in rates.iter().zip(&forces) {
                prop_assert_eq!(rate.clone() * &iw, force.clone());
            }
        }
    }

    #[test]
    fn chebyshev_chain_agrees_with_the_recurrence(n in 0u64..60, p in -30i64..30) {
        let d = rational(p, 11);
        let x = d.one() + &d;
        let (mut t, mut next) = (x.one(), x.clone());
        let (mut u, mut u_next) = (x.zero(), x.one());
        for _ in 0..n {
            (t, next) = (next.clone(), x.integer(2) * &x * &next - t);
            (u, u_next) = (u_next.clone(), x.integer(2) * &x * &u_next - u);
        }
        prop_assert_eq!(chebyshev(n, &d), (t, u));
    }

    /// Slope and curvature against dual numbers over exact rationals.
    #[test]
    fn derivatives_of_the_response_agree_with_duals(m in 1u64..12, w in 1i64..30) {
        let real = gains("-3/2", "-1/3");
        let w = rational(w, 17);
        let dual = Dual::new(w.clone(), w.one());
        let over_duals = frequency_response(&real.map(|x| Dual::constant(x.clone())), m, &dual, |d| chebyshev(m, d)).unwrap();
        let plain = frequency_response(&real, m, &w, |d| chebyshev(m, d)).unwrap();
        prop_assert_eq!(over_duals.inverse_square.derivative, plain.slope.clone());
        prop_assert_eq!(over_duals.slope.derivative, plain.curvature);
    }
}

/// The digits that the Arb peer certifies for f = g = -1.
#[test]
fn known_resonances() {
    for (m, omega, amplitude) in [
        (128, "0.008677369607588462626823824", "146.7308337780503871466687"),
        (10_000, "0.0001110720731684806586221164", "11463.18339172372061377134"),
        (1_000_000, "1.110720734539306083257877e-6", "1146318.336501779611683321"),
    ] {
        let found = resonance(&gains("-1", "-1"), m, 25).unwrap();
        for (x, digits) in [(&found.omega, omega), (&found.amplitude, amplitude)] {
            let known = parse_rational(digits).unwrap();
            let slack = known.clone() / rational(10, 1).pow(24);
            let around = Interval::hull_of_rationals(&(known.clone() - &slack), &(known + slack), 120);
            assert!(around.overlaps(x) && significant_digits(x) >= 25, "M = {m}");
        }
    }
}

#[test]
fn extreme_platoons() {
    for (m, f, g) in [
        (2, "-1", "-2"),
        (4, "-1", "-100"),
        (7, "-1", "-1e20"),
        (100, "-1", "-1e45"),
        (2, "-1e-90", "-1"),
        (2, "-7/3", "-1e-30"),
        (9, "-1e-90", "-1e-90"),
        (1, "-1", "-1e40"),
        (LARGEST_FOLLOWERS, "-1", "-1"),
        (1_000_000_000, "-1", "-1e12"),
    ] {
        let found = resonance(&gains(f, g), m, 25).unwrap_or_else(|error| panic!("{m} {f} {g}: {error}"));
        assert!(significant_digits(&found.omega) >= 25 && significant_digits(&found.amplitude) >= 25, "{m} {f} {g}");
    }
    let many = resonance(&gains("-1", "-1"), 128, 1000).unwrap();
    assert!(significant_digits(&many.omega) >= 1000);
}

#[test]
fn bad_input_is_refused() {
    let ask = |f, g, m, digits| resonance(&gains(f, g), m, digits).unwrap_err();
    assert!(matches!(ask("0", "-1", 3, 10), ResonanceError::GainNotNegative { name: "f", .. }));
    assert!(matches!(ask("-1", "1/2", 3, 10), ResonanceError::GainNotNegative { name: "g", .. }));
    assert_eq!(ask("-1", "-1", 0, 10), ResonanceError::Followers(0));
    assert_eq!(ask("-1", "-1", LARGEST_FOLLOWERS + 1, 10), ResonanceError::Followers(LARGEST_FOLLOWERS + 1));
    assert_eq!(ask("-1", "-1", 3, 0), ResonanceError::Digits(0));
    assert_eq!(ask("-1", "-1", 3, u32::MAX), ResonanceError::Digits(u32::MAX));
    assert_eq!(ask("-1", "-1", 3, LARGEST_DIGITS + 1), ResonanceError::Digits(LARGEST_DIGITS + 1));
    assert_eq!(ask("-1e-500", "-1", 3, 10), ResonanceError::Extreme);
}

#[test]
fn leading_terms_for_unit_gains() {
    let unit = gains("-1", "-1").map(|q| Interval::from_rational(q, 100));
    // pi sqrt2/16 and 32 sqrt2/pi².
    let frequency = theorem1::frequency(&unit, 4).unwrap();
    let expected = unit.f.pi() * unit.f.integer(2).sqrt().unwrap() * unit.f.ratio(1, 16);
    assert!(frequency.overlaps(&expected) && frequency.width().top() < -90);
    let amplitude = theorem1::amplitude(&unit, 4).unwrap();
    assert!((amplitude.to_f64() - 4.585_273_346).abs() < 1e-9);
    // pi²/(8 sqrt2).
    let exponent = theorem1::exponent(&unit).unwrap();
    assert!((exponent.to_f64() - std::f64::consts::PI.powi(2) / 128f64.sqrt()).abs() < 1e-15);
    let strongest = strongest_one_sided_square(&unit).unwrap();
    assert!((strongest.to_f64() - (3f64.sqrt() - 1.0)).abs() < 1e-15);
}
