//! Platoons with weights ahead and behind, against the equations written out car by car.

use arithmetic::{Complex, Field, Rational, Unwatched, rational};
use models::platoon::banded::BandedPlatoon;
use models::platoon::growth::peak_of_car;
use models::platoon::state_space::StateSpace;
use models::platoon::{
    Communication, CommunicationGraph, Gains, Line, LineError, Parameter, PeakError, Platoon, peak_of_platoon,
    peak_on_graph,
};
use num_traits::ToPrimitive;

fn list(numbers: &[(i64, i64)]) -> Vec<Rational> {
    numbers.iter().map(|(p, q)| rational(*p, *q)).collect()
}

fn all(f: (i64, i64), g: (i64, i64)) -> Line {
    Line::default().with(Parameter::F, list(&[f])).with(Parameter::G, list(&[g]))
}

/// Four numbers for each car: shares ahead and behind of the positions, then of the velocities; and the gains.
type Row = ([Rational; 4], Gains<Rational>);

/// The amplitudes from the last car forwards: `a_k = r_k a_(k-1)`, exactly.
fn by_ratios(rows: &[Row], w: &Rational) -> Vec<Complex<Rational>> {
    let mut ratios: Vec<Complex<Rational>> = Vec::new();
    for ([pa, pb, va, vb], Gains { f, g }) in rows.iter().rev() {
        let ahead = Complex::new(f * pa, w * g * va);
        let behind = Complex::new(f * pb, w * g * vb);
        // -w² a_k = f (a_k - pa a_(k-1) - pb a_(k+1)) + iwg (a_k - va a_(k-1) - vb a_(k+1)).
        let mut own = Complex::new(f + w * w, w * g);
        if let Some(next) = ratios.last() {
            own = own - behind * next;
        }
        ratios.push(ahead.over(&own).unwrap());
    }
    let mut amplitude = Complex::real(rational(1, 1));
    ratios
        .into_iter()
        .rev()
        .map(|ratio| {
            amplitude = amplitude.clone() * &ratio;
            amplitude.clone()
        })
        .collect()
}

/// Five different cars, with other weights for positions than for velocities.
fn different() -> (Line, Vec<Row>) {
    let (f, g) = ([(-1, 1), (-2, 1), (-1, 3), (-1, 1), (-3, 2)], [(-2, 1), (-1, 1), (-1, 2), (-3, 1), (-1, 1)]);
    let (pa, pb) = ([(3, 5), (1, 2), (2, 1), (1, 1), (1, 7)], [(2, 5), (1, 2), (1, 1), (0, 1), (1, 1)]);
    let va = [(1, 4), (1, 1), (2, 3), (1, 2), (9, 10)];
    let line = Line::default()
        .with(Parameter::F, list(&f))
        .with(Parameter::G, list(&g))
        .with(Parameter::FAhead, list(&pa))
        .with(Parameter::FBehind, list(&pb))
        .with(Parameter::GAhead, list(&va));
    let at = |list: &[(i64, i64)], k: usize| rational(list[k].0, list[k].1);
    let rows = (0..5).map(|k| {
        let sum = at(&pa, k) + at(&pb, k);
        let own = match k {
            4 => [rational(1, 1), rational(0, 1), rational(1, 1), rational(0, 1)],
            _ => [at(&pa, k) / &sum, at(&pb, k) / &sum, at(&va, k), rational(1, 1) - at(&va, k)],
        };
        (own, Gains { f: at(&f, k), g: at(&g, k) })
    });
    (line, rows.collect())
}

fn floats(platoon: &Platoon<Rational>) -> Platoon<f64> {
    platoon.map(|q| q.to_f64().unwrap())
}

#[test]
fn responses_are_those_of_the_equations_written_out() {
    let (line, rows) = different();
    let platoon = line.platoon(5).unwrap();
    for w in [rational(1, 9), rational(1, 2), rational(3, 2), rational(11, 1)] {
        let known = by_ratios(&rows, &w);
        assert_eq!(platoon.response(&w).unwrap(), known, "{w}");
        for car in 1..=5 {
            let system = StateSpace::of_platoon(&platoon, car).unwrap();
            assert_eq!(system.response(&w).unwrap(), known[car - 1], "{w}, car {car}");
        }
        let w = w.to_f64().unwrap();
        let banded = BandedPlatoon::of(&platoon).response_of_cars(floats(&platoon).gains(), w).unwrap();
        for (found, known) in banded.iter().zip(&known) {
            let error = (found.re - known.re.to_f64().unwrap()).hypot(found.im - known.im.to_f64().unwrap());
            assert!(error < 1e-12, "{w}: {found:?} {known:?}");
        }
    }
    // Another number somewhere is another platoon.
    let other = line.with(Parameter::GAhead, list(&[(1, 4), (1, 1), (2, 3), (1, 2), (9, 10)].map(|(p, q)| (q - p, q))));
    let w = rational(1, 2);
    // Of car 2 the weight ahead is zero, which is no error while it tracks the car behind.
    assert_ne!(other.platoon(5).unwrap().response(&w).unwrap(), by_ratios(&rows, &w));
}

/// Accelerations and matrices, by the law.
#[test]
fn accelerations_are_those_of_the_law() {
    let (line, rows) = different();
    let platoon = line.platoon(5).unwrap();
    let y = list(&[(1, 1), (-2, 3), (5, 1), (0, 1), (7, 2), (-1, 4)]);
    let u = list(&[(3, 1), (1, 1), (-1, 2), (2, 1), (-6, 5), (4, 1)]);
    let zero = rational(0, 1);
    let known: Vec<Rational> = (1..=5)
        .map(|k| {
            let ([pa, pb, va, vb], Gains { f, g }) = &rows[k - 1];
            let behind = |list: &[Rational]| list.get(k + 1).cloned().unwrap_or_else(|| zero.clone());
            f * (&y[k] - pa * &y[k - 1] - pb * behind(&y)) + g * (&u[k] - va * &u[k - 1] - vb * behind(&u))
        })
        .collect();
    assert_eq!(platoon.accelerations((&y[0], &u[0]), &y[1..], &u[1..]), known);
    // Of the first three cars alone those of the first two, which track nobody farther behind.
    assert_eq!(platoon.accelerations((&y[0], &u[0]), &y[1..4], &u[1..4]), known[..2]);
    let state: Vec<&Rational> = y[1..].iter().zip(&u[1..]).flat_map(|(y, u)| [y, u]).collect();
    let (motion, leader) = (platoon.motion_rows().unwrap(), platoon.leader_rows());
    for k in 0..5 {
        let product = |row: &[Rational]| row.iter().zip(&state).fold(zero.clone(), |sum, (a, x)| sum + a * *x);
        assert_eq!(product(&motion[2 * k]), u[k + 1]);
        assert_eq!(product(&motion[2 * k + 1]) + &leader[k][0] * &y[0] + &leader[k][1] * &u[0], known[k]);
    }
}

#[test]
fn the_platoons_of_the_paper_have_weights_too() {
    for m in [1usize, 2, 3, 7] {
        let both = CommunicationGraph::of(Communication::FrontAndBack, m).unwrap();
        let front = CommunicationGraph::of(Communication::Front, m).unwrap();
        let half = all((-1, 1), (-2, 1)).with(Parameter::Ahead, list(&[(1, 2)]));
        for line in [
            all((-1, 1), (-2, 1)),
            half.clone(),
            half.clone().with(Parameter::Behind, list(&[(1, 2)])),
            // Weights are shares.
            all((-1, 1), (-2, 1)).with(Parameter::Ahead, list(&[(7, 1)])).with(Parameter::Behind, list(&[(7, 1)])),
        ] {
            let platoon = line.platoon(m).unwrap();
            assert_eq!(platoon.one_graph(), Some(&both));
            assert_eq!(platoon.with_equal_gains(), Some((&both, &Gains { f: rational(-1, 1), g: rational(-2, 1) })));
        }
        for line in [
            all((-1, 1), (-2, 1)).with(Parameter::Ahead, list(&[(1, 1)])),
            all((-1, 1), (-2, 1)).with(Parameter::Behind, list(&[(0, 1)])),
        ] {
            assert_eq!(line.platoon(m).unwrap().one_graph(), Some(&front));
        }
        // The car behind alone: the leader is not heard, and the last car has nobody.
        let none = all((-1, 1), (-2, 1)).with(Parameter::Behind, list(&[(1, 1)])).platoon(m);
        assert_eq!(none, Err(LineError::Nobody { car: m, is_last: true, what: "positions" }));
    }
}

/// Gains of the links: as `-k_f` and `-k_b` of the literature, with that of its one link for the last car.
#[test]
fn gains_of_links_are_gains_with_weights() {
    let links = Line::default()
        .with(Parameter::FAhead, list(&[(-3, 5)]))
        .with(Parameter::FBehind, list(&[(-2, 5)]))
        .with(Parameter::GAhead, list(&[(-2, 1), (-1, 1), (-1, 2)]))
        .with(Parameter::GBehind, list(&[(-1, 1), (0, 1), (-5, 1)]));
    let platoon = links.platoon(3).unwrap();
    let gains: Vec<_> = [(-1, 1, -3, 1), (-1, 1, -1, 1), (-3, 5, -1, 2)]
        .map(|(a, b, c, d)| Gains { f: rational(a, b), g: rational(c, d) })
        .into();
    assert_eq!(platoon.gains(), gains);
    let tracked = |graph: &CommunicationGraph| (1..=3).map(|k| graph.tracked_by(k).to_vec()).collect::<Vec<_>>();
    let (p, one) = (rational(3, 5), rational(1, 1));
    let q = &one - &p;
    assert_eq!(
        tracked(platoon.positions()),
        [vec![(0, p.clone()), (2, q.clone())], vec![(1, p), (3, q)], vec![(2, one.clone())]]
    );
    assert_eq!(
        tracked(platoon.velocities()),
        [vec![(0, rational(2, 3)), (2, rational(1, 3))], vec![(1, one.clone())], vec![(2, one)]]
    );
}

/// No frequency of a scan is worse than the peak, which is attained; a control is below it.
#[test]
fn peaks_are_the_largest_of_exact_responses() {
    let (line, rows) = different();
    let platoon = line.platoon(5).unwrap();
    for car in [1, 3, 5] {
        let peak = peak_of_platoon(&platoon, car, 15, &Unwatched).unwrap();
        let (lo, hi) = peak.amplitude.to_rationals();
        let squared = |w: &Rational| by_ratios(&rows, w)[car - 1].norm_squared();
        for k in 1..160 {
            assert!(squared(&rational(k, 40)) <= &hi * &hi, "{k}");
        }
        let (from, to) = peak.omega.unwrap().to_rationals();
        let there = squared(&((from + to) / rational(2, 1)));
        let near = rational(1_000_000_000, 999_999_999);
        assert!(&there * &near >= &lo * &lo && there <= &hi * &hi);
        assert!(&there * near < &hi * &hi * rational(1_000_001, 1_000_000));
        let searched = peak_of_car(&floats(&platoon), car).unwrap().unwrap();
        assert!((searched.value / peak.amplitude.to_f64() - 1.0).abs() < 1e-9);
    }
    // With velocities as positions it is another one.
    let alike = Platoon::new(platoon.positions().clone(), platoon.gains().to_vec()).unwrap();
    let [own, other] = [&platoon, &alike].map(|p| peak_of_platoon(p, 5, 15, &Unwatched).unwrap().amplitude.to_f64());
    assert!((own - other).abs() > 1e-3, "{own} {other}");
    let graph = platoon.positions();
    let on_graph = peak_on_graph(graph, platoon.gains(), 5, 15, &Unwatched).unwrap().amplitude.to_f64();
    assert_eq!(other, on_graph);
}

/// Velocities of the car behind alone in a pair that swings against each other.
#[test]
fn what_is_not_stable_has_no_peak() {
    // Car 1 tracks the velocity of car 2 alone, nearly, and car 2 is slow.
    let line = all((-1, 1), (-1, 1))
        .with(Parameter::FAhead, list(&[(1, 1)]))
        .with(Parameter::GBehind, list(&[(1, 1), (0, 1)]));
    let platoon = line.platoon(2).unwrap();
    let found = peak_of_platoon(&platoon, 2, 10, &Unwatched);
    // s² = -1 - s + s r with r of car 2: by Routh's table of the polynomial of degree four.
    let stable = models::platoon::vector_form::is_stable(
        &algebra::matrix::RationalMatrix::from_rows(&platoon.motion_rows().unwrap()).unwrap(),
    )
    .unwrap();
    assert_eq!(stable, !matches!(found, Err(PeakError::NotStable)));
    // (s² + s + 1)² - s (s + 1) = s⁴ + 2s³ + 2s² + s + 1: 2·2·1 - 1 - 4 < 0.
    assert!(!stable);
}

#[test]
fn wrong_numbers_say_which_and_why() {
    let told = |line: Line, m: usize| line.platoon(m).unwrap_err().to_string();
    let good = || all((-1, 1), (-1, 1));
    assert!(told(all((1, 1), (-1, 1)), 3).starts_with("f must be negative, but it is 1: the law is y'' = f e + g e'"));
    assert!(told(all((-1, 1), (0, 1)), 3).starts_with("g must be negative, but it is 0"));
    for (line, m, words) in [
        (Line::default().with(Parameter::F, list(&[(-1, 1)])), 2, "g is needed: the gain of the velocities"),
        (
            good().with(Parameter::Ahead, list(&[(1, 2); 3])),
            2,
            "ahead has 3 numbers for 2 followers: one, or one for each follower",
        ),
        (
            good().with(Parameter::Ahead, list(&[(1, 2)])).with(Parameter::GAhead, list(&[(1, 2)])),
            2,
            "ahead and g_ahead cannot both be given",
        ),
        (good().with(Parameter::Ahead, list(&[(-1, 2)])), 2, "ahead is -1/2, but a weight is not negative"),
        (
            good().with(Parameter::Behind, list(&[(3, 2)])),
            2,
            "behind is 3/2, but a weight is between 0 and 1 where the other one is the rest to one",
        ),
        (
            good().with(Parameter::Ahead, list(&[(0, 1)])).with(Parameter::Behind, list(&[(0, 1)])),
            2,
            "car 1 has the weight zero ahead and behind: it would not keep track of any positions",
        ),
        (
            good().with(Parameter::GAhead, list(&[(0, 1)])),
            2,
            "car 2 has the weight zero ahead, and nobody behind: it would not keep track of any velocities",
        ),
        (
            Line::default().with(Parameter::G, list(&[(-1, 1)])).with(Parameter::FAhead, list(&[(-1, 1)])),
            2,
            "f_behind is needed: the gain of the link on its other side is given",
        ),
        (good(), 0, "a platoon needs at least one follower"),
    ] {
        assert_eq!(told(line, m), words);
    }
    let link = Line::default()
        .with(Parameter::G, list(&[(-1, 1)]))
        .with(Parameter::FAhead, list(&[(3, 5)]))
        .with(Parameter::FBehind, list(&[(2, 5)]));
    assert!(
        told(link, 2)
            .starts_with("f_ahead is 3/5, but without f it is the gain of a link, which is negative or zero: ")
    );
    for (name, parameter) in Parameter::NAMES {
        assert_eq!((parameter.name(), Parameter::from_name(name)), (name, Some(parameter)));
    }
}

/// Only what the leader does is followed: by positions, by velocities, or by both.
#[test]
fn the_leader_reaches_by_positions_or_velocities() {
    let one = || rational(1, 1);
    let positions = CommunicationGraph::new(vec![vec![(2, one())], vec![(1, one())], vec![]]).unwrap();
    let velocities = CommunicationGraph::new(vec![vec![], vec![(0, one())], vec![(3 - 1, one())]]).unwrap();
    let gains = vec![Gains { f: rational(-1, 1), g: rational(-1, 1) }; 3];
    let platoon = Platoon::new(positions, gains.clone()).unwrap();
    assert_eq!(platoon.reached_by_leader(), [true, false, false, false]);
    assert!(platoon.response(&one()).unwrap().iter().all(|a| *a == Complex::real(rational(0, 1))));
    let platoon = platoon.with_velocities(velocities.clone()).unwrap();
    assert_eq!(platoon.reached_by_leader(), [true; 4]);
    assert_eq!(platoon.links(), [(1, 2), (2, 1), (2, 0), (3, 2)]);
    let short = CommunicationGraph::of(Communication::Front, 2).unwrap();
    assert!(platoon.with_velocities(short).is_err());
    assert!(Platoon::new(velocities, gains[..2].to_vec()).is_err());
}
