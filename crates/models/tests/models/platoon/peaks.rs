//! The certificate of a resonance from starts of any quality, and the lesser resonances by their number.

use super::gains;
use arithmetic::{Interval, Rational, Signed, significant_digits};
use models::platoon::{
    Gains, LARGEST_DIGITS, LARGEST_FOLLOWERS, ResonanceError, chebyshev, frequency_response, is_below_full_phase,
    lesser_resonance, peak_near, resonance, resonance_from,
};
use num_traits::ToPrimitive;

/// The frequencies at which `F` turns from falling to rising, and those at which it turns from rising to falling, on a grid up to
/// `w = 1.5 sqrt(2 |f|)`, in floats.
fn extremes(gains: &Gains<Rational>, followers: u64) -> (Vec<f64>, Vec<f64>) {
    const STEPS: u32 = 4000;
    let floats = gains.map(|q| q.to_f64().unwrap());
    let end = 1.5 * (-2.0 * floats.f).sqrt();
    let at = |k: u32| end * f64::from(k) / f64::from(STEPS);
    let falls = |w: f64| frequency_response(&floats, followers, &w, |d| chebyshev(followers, d)).unwrap().slope < 0.0;
    let turn = |falling: bool| {
        let turns = move |k: &u32| falls(at(*k)) == falling && falls(at(*k + 1)) != falling;
        (1..STEPS).filter(turns).map(|k| 0.5 * (at(k) + at(k + 1))).collect()
    };
    (turn(true), turn(false))
}

fn is_around(x: &Interval, w: f64, share: f64) -> bool {
    (x.to_f64() / w - 1.0).abs() < share
}

#[test]
fn lesser_resonances_have_the_numbers_of_the_maxima() {
    for (f, g) in [("-1", "-1/100"), ("-1/3", "-1/50"), ("-7", "-1/10")] {
        let gains = gains(f, g);
        for m in [2u64, 3, 5, 8] {
            let (minima, _) = extremes(&gains, m);
            let count = minima.len() as u64;
            assert!(count >= 2 && count <= m, "one peak for each mode, but for those that are damped away");
            assert!(is_around(&resonance(&gains, m, 8).unwrap().omega, minima[0], 1e-2));
            for k in 2..=count {
                let found = lesser_resonance(&gains, m, k, 8).unwrap();
                let share = (minima[k as usize - 1] - minima[k as usize - 2]) / minima[k as usize - 1] / 10.0;
                assert!(is_around(&found.omega, minima[k as usize - 1], share.max(1e-3)), "{f} {g} {m} {k}");
                let value = |w: &Rational| frequency_response(&gains, m, w, |d| chebyshev(m, d)).unwrap().slope;
                let (lo, hi) = found.omega.to_rationals();
                assert!(!value(&lo).is_certainly_positive() && !value(&hi).is_certainly_negative());
            }
            for k in count + 1..=m {
                assert!(matches!(lesser_resonance(&gains, m, k, 8), Err(ResonanceError::NotIsolated(_))));
            }
            assert_eq!(lesser_resonance(&gains, m, m + 1, 8).unwrap_err(), ResonanceError::NotIsolated(0));
        }
    }
}

/// What is proposed is certified or refused: the first peak, other peaks, minima of the response.
#[test]
fn proposals_are_certified_or_refused() {
    let gains = gains("-2", "-1/20");
    for m in [3u64, 6] {
        let (peaks, between) = extremes(&gains, m);
        let main = resonance(&gains, m, 10).unwrap();
        for (k, w) in peaks.iter().enumerate() {
            // To about the digits that a float has.
            let near = lesser_resonance(&gains, m, k as u64 + 1, 10).unwrap().omega.to_f64();
            let found = peak_near(&gains, m, near, 10).unwrap();
            assert!(is_around(&found.omega, *w, 1e-2) && significant_digits(&found.amplitude) >= 10);
            assert_eq!(is_below_full_phase(&gains, m, &found.omega), k == 0);
            match resonance_from(&gains, m, near, 10) {
                Ok(found) => assert!(k == 0 && found.omega.overlaps(&main.omega)),
                Err(error) => assert!(k > 0 && error == ResonanceError::NotIsolated(64), "{error}"),
            }
        }
        for w in between {
            let (mut low, mut high) = (0.99 * w, 1.01 * w);
            let floats = gains.map(|q| q.to_f64().unwrap());
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let falls = frequency_response(&floats, m, &middle, |d| chebyshev(m, d)).unwrap().slope < 0.0;
                (low, high) = if falls { (low, middle) } else { (middle, high) };
            }
            assert!(matches!(peak_near(&gains, m, low, 10), Err(ResonanceError::NotIsolated(_))));
        }
    }
}

/// A start from far away, and one in the middle of nowhere: bisection finds the same.
#[test]
fn the_main_resonance_does_not_depend_on_the_start() {
    for (f, g, m) in [("-1", "-1", 5u64), ("-1", "-50", 3), ("-3", "-1/4", 2), ("-1", "-1", 1), ("-2", "-30", 1)] {
        let gains = gains(f, g);
        let known = resonance(&gains, m, 20).unwrap();
        // Places where there is no peak, and what is no frequency.
        for share in [0.5, 0.9, -1.0, 0.0, f64::NAN, f64::INFINITY] {
            let found = resonance_from(&gains, m, share * known.omega.to_f64(), 20).unwrap();
            assert!(found.omega.overlaps(&known.omega) && found.amplitude.overlaps(&known.amplitude));
            assert!(significant_digits(&found.omega) >= 20 && significant_digits(&found.amplitude) >= 20);
        }
    }
}

/// `w^4 M^4 <= 16 (f² + w² g²)`, either side of the frequency where it ends.
#[test]
fn the_end_of_the_full_phase_is_that_of_its_inequality() {
    for (f, g) in [(-1.0f64, -1.0f64), (-0.25, -3.0), (-5.0, -0.5), (-1.0, -40.0)] {
        for m in [2u64, 3, 10, 1000] {
            let m4 = (m as f64).powi(4);
            let square = (8.0 * g * g + (64.0 * g.powi(4) + 16.0 * f * f * m4).sqrt()) / m4;
            let gains = Gains { f, g }.map(|x| Rational::from_float(*x).unwrap());
            let at = |share: f64| Interval::from_rational(&Rational::from_float(share * square.sqrt()).unwrap(), 100);
            assert!(is_below_full_phase(&gains, m, &at(1.0 - 1e-12)), "{f} {g} {m}");
            assert!(!is_below_full_phase(&gains, m, &at(1.0 + 1e-12)), "{f} {g} {m}");
        }
    }
}

/// Both frequency and amplitude have the digits, where one of them is much harder to have than the other.
#[test]
fn frequency_and_amplitude_both_have_the_digits() {
    for (f, g, m) in [("-1", "-1", 1_000_000_000u64), ("-1", "-1e8", 3), ("-1", "-1e6", 1)] {
        let gains = gains(f, g);
        for digits in [1, 5, 14, 33] {
            let found = resonance(&gains, m, digits).unwrap();
            assert!(significant_digits(&found.omega) >= digits, "{f} {g} {m} {digits}");
            assert!(significant_digits(&found.amplitude) >= digits, "{f} {g} {m} {digits}");
            let better = resonance(&gains, m, digits + 10).unwrap();
            assert!(found.omega.overlaps(&better.omega) && found.amplitude.overlaps(&better.amplitude));
        }
    }
}

/// The largest arguments are taken, and one more is not; there is no lesser resonance of one car.
#[test]
fn arguments_of_lesser_resonances_are_checked() {
    let ask = |f: &str, m, k, digits| lesser_resonance(&gains(f, "-1"), m, k, digits).unwrap_err();
    assert_eq!(ask("-1", 1, 2, LARGEST_DIGITS), ResonanceError::NotIsolated(0));
    assert_eq!(ask("-1", LARGEST_FOLLOWERS, u64::MAX, 5), ResonanceError::NotIsolated(0));
    assert_eq!(ask("-1", LARGEST_FOLLOWERS + 1, 2, 5), ResonanceError::Followers(LARGEST_FOLLOWERS + 1));
    assert_eq!(ask("-1", 1, 2, LARGEST_DIGITS + 1), ResonanceError::Digits(LARGEST_DIGITS + 1));
    assert!(matches!(ask("1", 1, 2, 5), ResonanceError::GainNotNegative { name: "f", .. }));
    let near = |m, start| peak_near(&gains("-1", "-1"), m, start, 10).unwrap_err();
    assert_eq!((near(0, 0.3), near(3, -0.3)), (ResonanceError::Followers(0), ResonanceError::NotIsolated(0)));
}
