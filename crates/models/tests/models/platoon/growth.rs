//! Banded responses, neighbourhoods, measured peaks and growth against naive twins.

use arithmetic::{Complex, Rational, rational};
use models::platoon::banded::BandedPlatoon;
use models::platoon::growth::{Growth, peak};
use models::platoon::observe::{largest, measured_amplitude, measured_resonance, smallest_gap};
use models::platoon::time_domain::Modes;
use models::platoon::{
    Communication, CommunicationGraph, Gains, Neighbourhood, amplitude_with_first_car, amplitudes_two_sided, resonance,
    theorem1,
};
use proptest::prelude::*;

const UNIT: Gains<f64> = Gains { f: -1.0, g: -1.0 };

fn rule(weights: &[(i64, i64)]) -> Neighbourhood {
    Neighbourhood::new(weights.iter().map(|&(d, w)| (d, rational(w, 1)))).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// The band solver against elimination of the whole matrix.
    #[test]
    fn banded_responses_agree_with_full_ones(
        numbers in prop::array::uniform6(0i64..4), followers in 1usize..20, f in 1i64..9, g in 1i64..9, w in 1i64..40,
    ) {
        let offsets = [-3i64, -2, -1, 1, 2, 3];
        let weights: Vec<(i64, i64)> = offsets.into_iter().zip(numbers).collect();
        // Car 1 must hear the leader at once, so that everyone who hears of it is reached.
        prop_assume!(numbers[2] > 0);
        let graph = rule(&weights).graph(followers).unwrap();
        let gains = Gains { f: -(f as f64) / 4.0, g: -(g as f64) / 4.0 };
        let w = w as f64 / 10.0;
        let full = graph.response(&gains, &w).unwrap();
        let banded = BandedPlatoon::new(&graph).response(&gains, w).unwrap();
        let size = full.iter().map(Complex::norm_squared).fold(1.0, f64::max).sqrt();
        for (a, b) in full.iter().zip(&banded) {
            prop_assert!((a.clone() - b).norm_squared().sqrt() < 1e-9 * size, "{a:?} {b:?}");
        }
    }

    /// The golden sections find the top of a parabola.
    #[test]
    fn the_largest_value_is_found(top in -3f64..3.0, height in -5f64..5.0) {
        let found = largest::<()>((-3.0, 3.0), 10, |x| Ok(height - (x - top) * (x - top))).unwrap();
        prop_assert!((found.at - top).abs() < 1e-6 && (found.value - height).abs() < 1e-12);
    }
}

#[test]
fn the_smallest_neighbourhood_is_system_2() {
    let two_sided = rule(&[(-1, 1), (1, 1)]);
    for followers in 1..6 {
        let graph = two_sided.graph(followers).unwrap();
        assert_eq!(graph, CommunicationGraph::of(Communication::FrontAndBack, followers).unwrap());
    }
    assert_eq!(two_sided.moment(1), rational(0, 1));
    // Re l = 1 - cos q = l: g² l³ = |2 sin(q/2)|^6/8.
    assert!((two_sided.wave_margin(&UNIT) - 0.125).abs() < 1e-12);
    assert!(rule(&[(-1, 1)]).wave_margin(&UNIT) < 0.0);
    for weights in [vec![], vec![(0, 1)], vec![(1, -1), (2, 2)]] {
        assert!(Neighbourhood::new(weights.into_iter().map(|(d, w)| (d, rational(w, 1)))).is_err());
    }
}

#[test]
fn peaks_of_the_two_systems() {
    let exact = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    for followers in [2usize, 17, 200] {
        let graph = CommunicationGraph::of(Communication::FrontAndBack, followers).unwrap();
        let (found, enclosed) =
            (peak(&graph, &UNIT).unwrap().unwrap(), resonance(&exact, followers as u64, 12).unwrap());
        assert!((found.value / enclosed.amplitude.to_f64() - 1.0).abs() < 1e-9, "{followers}: {found:?}");
        assert!((found.at / enclosed.omega.to_f64() - 1.0).abs() < 1e-4);
        // One-sided: the gain (1 + 2/sqrt3)^(1/2) to the power M.
        let front = CommunicationGraph::of(Communication::Front, followers.min(30)).unwrap();
        let expected = (1.0 + 2.0 / 3f64.sqrt()).powf(0.5 * followers.min(30) as f64);
        assert!((peak(&front, &UNIT).unwrap().unwrap().value / expected - 1.0).abs() < 1e-9);
    }
}

#[test]
fn growth_is_told_from_local_exponents() {
    let of = |f: &dyn Fn(f64) -> f64| Growth::of(&[16.0, 24.0, 32.0, 48.0, 64.0].map(|m| (m, f(m))));
    assert_eq!(of(&|m| 1.1 * m + 0.2 / m), Growth::Linear);
    assert!(matches!(of(&|m| m * m), Growth::Power(p) if (p - 2.0).abs() < 1e-9));
    assert!(matches!(of(&|_| 3.0), Growth::Power(p) if p == 0.0));
    assert_eq!(of(&|m| 1.05f64.powf(m)), Growth::Exponential);
    assert_eq!(of(&|m| m.sqrt() * 1.2f64.powf(m)), Growth::Exponential);
    assert_eq!(Growth::of(&[(1.0, 1.0), (2.0, 2.0), (4.0, 4.0)]), Growth::Undecided);
}

/// Most weight behind: the slowest mode dies out like (1/3)^M and is given up before rounding hides it.
#[test]
fn modes_that_are_too_slow_are_not_guessed() {
    let backward = rule(&[(-1, 1), (1, 3)]);
    let found = |m: usize| peak(&backward.graph(m).unwrap(), &UNIT).unwrap();
    let (small, larger) = (found(8).unwrap(), found(12).unwrap());
    assert!(((larger.value / small.value).ln() / 4.0 - 3f64.ln() / 2.0).abs() < 0.02, "{small:?} {larger:?}");
    assert!(found(40).is_none());
}

#[test]
fn the_first_car_of_equation_2_gives_the_response_of_equation_2() {
    let gains = Gains { f: rational(-2, 3), g: rational(-1, 5) };
    let (w, weights) = (rational(3, 7), [rational(1, 1), rational(1, 2), rational(1, 2)]);
    for followers in 2..6u64 {
        let all = amplitudes_two_sided(&gains, &w, followers as usize).unwrap();
        assert_eq!(amplitude_with_first_car(&gains, &w, followers, &weights).unwrap(), all[followers as usize - 1]);
        // Without the velocity of the leader: f/(f + iwg) times that.
        let without: [Rational; 3] = [weights[0].clone(), rational(0, 1), weights[2].clone()];
        let blind = amplitude_with_first_car(&gains, &w, followers, &without).unwrap();
        let law = Complex::new(gains.f.clone(), gains.g.clone() * &w);
        assert_eq!(blind * law, all[followers as usize - 1].scale(&gains.f));
    }
}

#[test]
fn long_observation_measures_the_certified_peak() {
    let exact = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    for followers in [4u64, 16] {
        let enclosed = resonance(&exact, followers, 12).unwrap();
        let guess = theorem1::frequency(&UNIT, followers).unwrap();
        let found = measured_resonance(&UNIT, followers, guess, 300.0).unwrap();
        assert!((found.value / enclosed.amplitude.to_f64() - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.at / enclosed.omega.to_f64() - 1.0).abs() < 1e-4, "{found:?}");
        // Early on the amplitude is smaller.
        let modes = Modes::new(&UNIT, followers).unwrap();
        assert!(measured_amplitude(&modes, found.at, 1.0).unwrap() < 0.9 * found.value);
    }
}

#[test]
fn gaps_are_those_between_neighbours() {
    assert_eq!(smallest_gap(0.0, &[0.5, 0.25], 1.0), 0.5);
    assert_eq!(smallest_gap(2.0, &[0.5, 0.25], 1.0), 1.25);
    assert!(smallest_gap(0.0, &[0.0, 1.5], 1.0) < 0.0);
}
