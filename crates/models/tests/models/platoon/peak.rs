//! Peaks over all frequencies of any platoon and any system, with proof, against dense scans in floating point.

use arithmetic::rand_chacha::rand_core::Rng;
use arithmetic::{Complex, Progress, Rational, Unwatched, parse_rational, random, rational, significant_digits};
use models::platoon::state_space::StateSpace;
use models::platoon::{Communication, CommunicationGraph, Gains, Peak, PeakError, peak_of_system, peak_on_graph};
use num_traits::ToPrimitive;
use std::sync::atomic::{AtomicUsize, Ordering};

type Arcs = Vec<Vec<(usize, Rational)>>;

/// Rows of weights scaled to a sum of one.
fn graph(rows: &[&[(usize, i64)]]) -> CommunicationGraph {
    let shares = |row: &&[(usize, i64)]| {
        let sum: i64 = row.iter().map(|(_, weight)| weight).sum();
        row.iter().map(|(agent, weight)| (*agent, rational(*weight, sum))).collect()
    };
    CommunicationGraph::new(rows.iter().map(shares).collect::<Arcs>()).unwrap()
}

fn gains(f: &str, g: &str) -> Vec<Gains<Rational>> {
    let list = |text: &str| text.split(',').map(|part| parse_rational(part).unwrap()).collect::<Vec<_>>();
    list(f).into_iter().zip(list(g)).map(|(f, g)| Gains { f, g }).collect()
}

fn float(q: &Rational) -> f64 {
    q.to_f64().unwrap()
}

/// The amplitude of a car in floating point, by elimination.
fn amplitude(graph: &CommunicationGraph, gains: &[Gains<Rational>], car: usize, w: f64) -> f64 {
    let floats: Vec<Gains<f64>> = gains.iter().map(|gains| gains.map(float)).collect();
    graph.response_of_cars(&floats, &w).map_or(0.0, |all| all[car - 1].norm_squared().sqrt())
}

fn peak(graph: &CommunicationGraph, gains: &[Gains<Rational>], car: usize) -> Result<Peak, PeakError> {
    peak_on_graph(graph, gains, car, 15, &Unwatched)
}

/// A narrow peak that a grid misses: car 5 of seven vertices, 1 leading.
#[test]
fn a_peak_between_the_frequencies_of_a_grid_is_found() {
    // Vertices 2 to 7 are followers 1 to 6.
    let graph =
        graph(&[&[(5, 10)], &[(4, 1)], &[(6, 1), (2, 100)], &[(5, 1), (2, 100)], &[(3, 10)], &[(0, 100), (4, 1)]]);
    let own = gains("-10,-1,-1,-2,-2,-2", "-1/10,-1,-1/100,-1/2,-1/10,-1");
    match peak(&graph, &own, 4) {
        Ok(found) => {
            let omega = found.omega.unwrap();
            assert!((found.amplitude.to_f64() - 168.164).abs() < 1e-3 && (omega.to_f64() - 0.0080049).abs() < 1e-7);
            assert!(significant_digits(&omega) >= 15 && significant_digits(&found.amplitude) >= 15);
        }
        Err(error) => panic!("{error}"),
    }
}

/// One lightly damped car beside a usual one: a peak whose width is 10^-7 of its frequency, between the frequencies of any grid.
#[test]
fn a_peak_of_a_width_of_ten_to_the_minus_seven_is_found() {
    let graph = graph(&[&[(0, 1)], &[(1, 1), (0, 3)]]);
    let own = gains("-1,-17/5", "-1,-1/10000000");
    let found = peak(&graph, &own, 2).unwrap();
    // Near w = sqrt(17/5) the second car multiplies by sqrt(17/5)/10^-7.
    let w = 3.4f64.sqrt();
    assert!((found.omega.unwrap().to_f64() - w).abs() < 1e-6 && found.amplitude.to_f64() > 1e6);
}

/// Random directed graphs with weights 1, 10 and 100 and very different gains: no frequency of a dense scan is worse, the height is taken at the
/// place, and what is not stable grows in time.
#[test]
fn random_platoons_have_no_higher_amplitude() {
    let mut stable = 0;
    for case in 0..60 {
        let mut random = random::generator("7", "peaks of platoons", case);
        let mut pick = |n: usize| (random.next_u64() % n as u64) as usize;
        let followers = 1 + pick(6);
        let rows: Arcs = (1..=followers)
            .map(|k| {
                let mut heard: Vec<usize> = (0..=followers).filter(|&agent| agent != k && pick(3) == 0).collect();
                if heard.is_empty() {
                    heard.push(k - 1);
                }
                let weights: Vec<i64> = heard.iter().map(|_| [1, 10, 100][pick(3)]).collect();
                let sum: i64 = weights.iter().sum();
                heard.into_iter().zip(weights).map(|(agent, weight)| (agent, rational(weight, sum))).collect()
            })
            .collect();
        let graph = CommunicationGraph::new(rows).unwrap();
        let equal = pick(2) == 0;
        const GAINS: [(i64, i64); 6] = [(-10, 1), (-2, 1), (-1, 1), (-1, 2), (-1, 10), (-1, 100)];
        let mut gain = || GAINS[pick(6)];
        let first = (gain(), gain());
        let own: Vec<Gains<Rational>> = (0..followers)
            .map(|_| if equal { first } else { (gain(), gain()) })
            .map(|((a, b), (c, d))| Gains { f: rational(a, b), g: rational(c, d) })
            .collect();
        let found = match peak(&graph, &own, followers) {
            Ok(found) => found,
            Err(error) => {
                assert_eq!(error, PeakError::NotStable);
                continue;
            }
        };
        stable += 1;
        let (height, omega) = (found.amplitude.to_f64(), found.omega.unwrap().to_f64());
        let scan = (0..6000).map(|k| 1e-4 * 1.0025f64.powi(k)).map(|w| amplitude(&graph, &own, followers, w));
        let most = scan.fold(0.0, f64::max);
        assert!(most <= height * (1.0 + 1e-7), "{case}: {most} {height}");
        if omega > 0.0 {
            let there = amplitude(&graph, &own, followers, omega);
            assert!((there / height - 1.0).abs() < 1e-5, "{case}: {there} {height}");
        }
    }
    assert!(stable > 20, "{stable}");
}

/// Falling from the start, rising to infinity, and without bound.
#[test]
fn peaks_of_systems_at_the_ends() {
    let rows =
        |list: &[&[i64]]| list.iter().map(|row| row.iter().map(|&x| rational(x, 1)).collect()).collect::<Vec<Vec<_>>>();
    let system = |b: &[&[i64]], c: i64, d: Option<&[i64]>| {
        let d = d.map(|d| rows(&[d]));
        StateSpace::new(&rows(&[&[-3]]), &rows(b), &rows(&[&[c]]), d.as_deref()).unwrap()
    };
    let at = |system: &StateSpace| peak_of_system(system, 12, &Unwatched);
    let falling = at(&system(&[&[3]], 1, None)).unwrap();
    assert!(falling.omega.unwrap().contains(&rational(0, 1)) && falling.amplitude.contains(&rational(1, 1)));
    let rising = at(&system(&[&[-3]], 1, Some(&[1]))).unwrap();
    assert!(rising.omega.is_none() && rising.amplitude.contains(&rational(1, 1)));
    assert_eq!(at(&system(&[&[1, 0]], 1, Some(&[0, 1]))).unwrap_err(), PeakError::Unbounded);
    let still = StateSpace::new(&rows(&[&[0]]), &rows(&[&[1]]), &rows(&[&[1]]), None).unwrap();
    assert_eq!(at(&still).unwrap_err(), PeakError::NotStable);
    // The response is that of the matrices.
    let w = rational(2, 7);
    let known = system(&[&[5, 2]], 7, Some(&[1, -3])).response(&w).unwrap();
    let transfer = system(&[&[5, 2]], 7, Some(&[1, -3])).transfer(&Unwatched).unwrap();
    let value = |list: &[num_bigint::BigInt]| {
        let turn = Complex::new(rational(0, 1), w.clone());
        list.iter().rev().fold(Complex::real(rational(0, 1)), |sum, c| {
            sum * turn.clone() + Complex::real(Rational::from_integer(c.clone()))
        })
    };
    assert_eq!(value(&transfer.numerator), known * value(&transfer.denominator));
}

/// Cars that nobody leads stay where they are pushed; gains and cars that are not there are refused.
#[test]
fn platoons_without_a_peak() {
    let one = graph(&[&[(0, 1)], &[(3, 1)], &[(2, 1)]]);
    let own = gains("-1,-1,-1", "-1,-1,-1");
    assert_eq!(peak(&one, &own, 1).unwrap_err(), PeakError::NotStable);
    for (count, car) in [(2, 1), (3, 0), (3, 4)] {
        assert!(
            matches!(peak(&one, &own[..count], car), Err(PeakError::System(_) | PeakError::Platoon(_))),
            "{count} {car}"
        );
    }
}

/// Stops after it was asked so often.
struct After(usize, AtomicUsize);

impl Progress for After {
    fn is_cancelled(&self) -> bool {
        self.1.fetch_add(1, Ordering::Relaxed) >= self.0
    }
}

/// The polynomials, Routh's table and the search each ask whether to go on.
#[test]
fn peaks_can_be_stopped_at_every_stage() {
    let graph = CommunicationGraph::of(Communication::FrontAndBack, 6).unwrap();
    let gains: Vec<Gains<Rational>> = (1..=6).map(|k| Gains { f: rational(-1, k), g: rational(-1, 2) }).collect();
    let asked = |most: usize| {
        let progress = After(most, AtomicUsize::new(0));
        let found = peak_on_graph(&graph, &gains, 6, 10, &progress);
        (found, progress.1.into_inner())
    };
    let (whole, total) = asked(usize::MAX);
    assert!(whole.is_ok() && total > 12, "{total}");
    for most in [0, 1, 4, total / 2, total - 1] {
        assert!(matches!(asked(most).0, Err(PeakError::Cancelled(_))), "{most} of {total}");
    }
    assert!(asked(total).0.is_ok());
}
