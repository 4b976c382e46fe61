//! Gains for each car, and margins.

use algebra::spectrum::Polynomial;
use arithmetic::{Complex, Rational, rational};
use models::platoon::banded::BandedPlatoon;
use models::platoon::growth::peak_of_car;
use models::platoon::margins::margins;
use models::platoon::vector_form::{motion_matrix, motion_rows_of_cars};
use models::platoon::{Communication, CommunicationGraph, Gains, resonance};

fn gains(f: f64, g: f64) -> Gains<f64> {
    Gains { f, g }
}

#[test]
fn equal_gains_give_the_certified_resonance() {
    let exact = Gains { f: rational(-1, 2), g: rational(-3, 1) };
    for m in [1usize, 2, 5, 16, 64] {
        let graph = CommunicationGraph::of(Communication::FrontAndBack, m).unwrap();
        let certified = resonance(&exact, m as u64, 12).unwrap();
        let found = peak_of_car(&graph, &vec![gains(-0.5, -3.0); m], m).unwrap().unwrap();
        assert!((found.value / certified.amplitude.to_f64() - 1.0).abs() < 1e-9, "{m}");
        assert!((found.at / certified.omega.to_f64() - 1.0).abs() < 1e-4, "{m}");
    }
    let graph = CommunicationGraph::of(Communication::Front, 3).unwrap();
    assert!(peak_of_car(&graph, &[gains(-1.0, -1.0)], 1).is_err());
    assert!(peak_of_car(&graph, &vec![gains(-1.0, -1.0); 3], 4).is_err());
    assert!(peak_of_car(&graph, &vec![gains(-1.0, -1.0); 3], 0).is_err());
}

/// The response of bands, of dense elimination, and the equations of motion themselves.
#[test]
fn responses_of_cars_solve_the_equations_of_motion() {
    let graph = CommunicationGraph::in_series(&[3, 4]).unwrap();
    let own: Vec<Gains<f64>> = (1..=7).map(|k| gains(-0.5 * k as f64, -2.0 / k as f64)).collect();
    for w in [0.1, 0.7, 2.0] {
        let dense = graph.response_of_cars(&own, &w).unwrap();
        let banded = BandedPlatoon::new(&graph).response_of_cars(&own, w).unwrap();
        for k in 1..=7 {
            assert!((dense[k - 1].clone() - banded[k - 1].clone()).norm_squared() < 1e-20);
            let mean = graph.tracked_by(k).iter().fold(Complex::real(0.0), |sum, (agent, weight)| {
                let value = if *agent == 0 { Complex::real(1.0) } else { dense[agent - 1].clone() };
                sum + value.scale(&num_traits::ToPrimitive::to_f64(weight).unwrap())
            });
            let (deviation, own) = (dense[k - 1].clone() - mean, &own[k - 1]);
            // y'' = f e + g e'.
            let force = Complex::new(own.f, own.g * w) * &deviation;
            assert!((force + dense[k - 1].scale(&(w * w))).norm_squared() < 1e-20, "{k}");
        }
    }
}

#[test]
fn rows_of_cars_with_equal_gains_are_those_of_the_paper() {
    let graph = CommunicationGraph::of(Communication::FrontAndBack, 4).unwrap();
    let reduced = graph.reduced_laplacian().unwrap();
    let equal: Gains<Rational> = Gains { f: rational(-1, 3), g: rational(-2, 1) };
    let rows = motion_rows_of_cars(&reduced, |_| &equal);
    assert_eq!(rows, motion_matrix(&reduced, &equal).unwrap().to_rows());
}

/// For one car the loop is (|f| + i w |g|)/w², and the margin is known; complex modes lose stability at the factor that is told.
#[test]
fn margins_are_where_stability_ends() {
    let one = margins(&gains(-1.0, -1.0), &[Complex::real(1.0)]).unwrap();
    let crossing = ((1.0 + 5f64.sqrt()) / 2.0).sqrt();
    assert!((one.phase - crossing.atan()).abs() < 1e-12 && one.critical_factor.is_none());
    assert!(margins(&gains(-1.0, -1.0), &[]).is_none());
    // Three cars that track each other in a circle, the first of them also the leader: complex eigenvalues of P.
    let graph = CommunicationGraph::new(vec![
        vec![(0, rational(1, 10)), (3, rational(9, 10))],
        vec![(1, rational(1, 1))],
        vec![(2, rational(1, 1))],
    ])
    .unwrap();
    let reduced = graph.reduced_laplacian().unwrap();
    // (1 - p)³ = 9/10.
    let root = 0.9f64.cbrt();
    let eigenvalues: Vec<Complex<f64>> = (0..3)
        .map(|k| 2.0 * std::f64::consts::PI * f64::from(k) / 3.0)
        .map(|angle| Complex::new(1.0 - root * angle.cos(), -root * angle.sin()))
        .collect();
    let factor = margins(&gains(-5.0, -1.0), &eigenvalues).unwrap().critical_factor.unwrap();
    let stable = |factor: f64| {
        let factor = Rational::from_float(factor).unwrap();
        let scaled = Gains { f: rational(-5, 1) * &factor, g: rational(-1, 1) * factor };
        let motion = motion_matrix(&reduced, &scaled).unwrap();
        Polynomial::from_rationals(&motion.characteristic_polynomial().unwrap().coefficients()).is_hurwitz()
    };
    assert!(stable(factor * 1.0001) && !stable(factor * 0.9999), "{factor}");
}
