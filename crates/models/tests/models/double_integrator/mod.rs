//! Mirrors `src/double_integrator`: laws, potentials, kinks, linearisations and the float motion against naive twins.

mod by_hand;
mod closed_loops;
mod enclosed;
mod engine;
mod equilibria;
mod exact;
mod flock;
mod forks;
mod individual;
mod inputs;
mod motion;
mod observation;
mod potentials;
mod rest;
mod setups;
mod switching;
mod thresholds;

use algebra::graph::Graph;
use algebra::matrix::{Inertia, RationalMatrix, inertia};
use arithmetic::{Dual, Field, Interval, Number, Rational, Ring, rational};
use models::double_integrator::{
    Coordinates, HeadingDifference, Kink, Potential, PotentialError, Span, State, agent_potential, gyroscopic, heading,
    heading_rate, heading_spread, hessian, kinetic_energy, linearisation, linked_within, potential_energy,
    potential_gradients, rotated, tied, velocity_alignment,
};
use proptest::prelude::*;
use std::f64::consts::PI;

#[test]
fn the_spread_of_headings_is_that_of_all_pairs() {
    let naive = |angles: &[f64]| {
        let turn = |a: f64, b: f64| ((a - b + PI).rem_euclid(2.0 * PI) - PI).abs();
        angles.iter().flat_map(|a| angles.iter().map(move |b| turn(*a, *b))).fold(0.0, f64::max)
    };
    for angles in [&[][..], &[0.3], &[0.0, 3.0], &[0.1, 7.0, -2.0], &[3.1, -3.1, 3.0], &[1.0, 2.5, 4.0, 5.5, 0.2]] {
        assert!((heading_spread(angles) - naive(angles)).abs() < 1e-12, "{angles:?}");
    }
}

/// Opposite but for rounding, on either side, and a third one beside: none of them is overlooked.
#[test]
fn headings_that_are_opposite_but_for_rounding_are_found() {
    for k in 0..400 {
        let angle = 0.013 * f64::from(k);
        for shift in [-4e-16, -2e-16, 0.0, 2e-16, 4e-16] {
            let opposite = angle + PI * (1.0 + shift);
            assert!(heading_spread(&[angle, opposite, angle + 0.1]) > PI - 1e-9, "{angle} {shift}");
            assert!(heading_spread(&[angle, opposite, angle - 0.1, opposite + 0.2]) > PI - 1e-9, "{angle} {shift}");
        }
    }
}

const PLANE: Coordinates = Coordinates::Cartesian;

fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

fn state(list: &[(i64, i64)], velocities: &[(i64, i64)]) -> State<Rational> {
    let vectors = |list: &[(i64, i64)]| list.iter().map(|&(x, y)| [rational(x, 2), rational(y, 2)]).collect();
    State { positions: vectors(list), velocities: vectors(velocities) }
}

fn places(count: usize) -> impl Strategy<Value = Vec<(i64, i64)>> {
    prop::collection::vec((-9i64..=9, -9i64..=9), count)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The law against sums over all ordered pairs, straight from equation (4).
    #[test]
    fn the_law_is_the_double_sum(r in places(4), v in places(4), code in 0usize..64) {
        let state = state(&r, &v);
        let graph = Graph::all(4).nth(code).unwrap();
        let Ok(found) = velocity_alignment(&state, &graph.edges(), PLANE, |_, _, s| spring().slope(s)) else { return Ok(()) };
        for (i, found) in found.iter().enumerate() {
            let mut naive = [rational(0, 1), rational(0, 1)];
            for j in (0..4).filter(|&j| j != i && graph.has_edge(i, j)) {
                let (rx, ry) = (&state.positions[i][0] - &state.positions[j][0], &state.positions[i][1] - &state.positions[j][1]);
                let s = &rx * &rx + &ry * &ry;
                // V = s + 1/s - 2: V' = 1 - 1/s².
                let slope = (rational(1, 1) - rational(1, 1) / (&s * &s)) * rational(2, 1);
                naive[0] -= &state.velocities[i][0] - &state.velocities[j][0] + &slope * rx;
                naive[1] -= &state.velocities[i][1] - &state.velocities[j][1] + &slope * ry;
            }
            prop_assert_eq!(found, &naive);
        }
    }

    /// Energies: half the sum over agents is the sum over edges; its gradient is the force.
    #[test]
    fn energies_and_forces_agree(r in places(3), code in 0usize..8) {
        let state = state(&r, &[(0, 0); 3]);
        let edges = Graph::all(3).nth(code).unwrap().edges();
        let value = |_: usize, _: usize, s: &Rational| spring().rational_value(s);
        let Ok(total) = potential_energy(&state.positions, &edges, PLANE, value) else { return Ok(()) };
        let agents: Rational = (0..3).map(|i| agent_potential(i, &state.positions, &edges, PLANE, value).unwrap()).sum();
        prop_assert_eq!(agents, total * rational(2, 1));
        let gradients = potential_gradients(&state.positions, &edges, PLANE, |_, _, s| spring().slope(s)).unwrap();
        let list: Vec<Rational> = state.positions.iter().flatten().cloned().collect();
        let by_duals = arithmetic::gradient(&list, |x| {
            let positions: Vec<[Dual<Rational>; 2]> = x.chunks(2).map(|p| [p[0].clone(), p[1].clone()]).collect();
            potential_energy(&positions, &edges, PLANE, |_, _, s| spring().rational_value(s))
        }).unwrap();
        prop_assert_eq!(gradients.into_iter().flatten().collect::<Vec<_>>(), by_duals);
    }

    /// Links and ties against distances.
    #[test]
    fn links_are_strictly_within(r in places(4), square in 1i64..40) {
        let state = state(&r, &[(0, 0); 4]);
        let square = rational(square, 4);
        let (graph, ties) = (linked_within(&state.positions, &square, PLANE), tied(&state.positions, &square, PLANE));
        for j in 0..4 {
            for i in 0..j {
                let s = PLANE.square(&state.separation(i, j));
                prop_assert_eq!(graph.has_edge(i, j), s < square);
                prop_assert_eq!(ties.contains(&(i, j)), s == square);
            }
        }
    }

    /// The gyroscopic force does no work, and turns headings by the right side of (7) where there are no potentials.
    #[test]
    fn the_gyroscopic_force_turns_only(r in places(3), v in places(3), angles in prop::collection::vec(-5i64..=5, 3)) {
        let state = state(&r, &v);
        let none = vec![[rational(0, 1), rational(0, 1)]; 3];
        let edges = [(0, 1), (1, 2)];
        let Ok(turning) = gyroscopic(&state, &none, &edges, |i, j| rational(angles[i] - angles[j], 3)) else { return Ok(()) };
        for i in 0..3 {
            prop_assert_eq!(PLANE.product(&turning[i], &state.velocities[i]), rational(0, 1));
            let Ok(rate) = heading_rate(&state.velocities[i], &turning[i]) else { continue };
            let claimed: Rational = (0..3usize).filter(|&j| j.abs_diff(i) == 1).map(|j| {
                -rational(angles[i] - angles[j], 3) / PLANE.square(&state.separation(i, j))
            }).sum();
            prop_assert_eq!(rate, claimed);
        }
    }

    /// The heading encloses the angle of the vector.
    #[test]
    fn headings_are_angles(x in -50i64..=50, y in -50i64..=50) {
        prop_assume!((x, y) != (0, 0));
        let v = [x, y].map(|n| Interval::from_rational(&rational(n, 7), 80));
        let angle = heading(&v).unwrap();
        let (sin, cos) = angle.sin_cos().unwrap();
        let length = PLANE.square(&v).sqrt().unwrap();
        prop_assert!((length.clone() * cos).overlaps(&v[0]) && (length * sin).overlaps(&v[1]));
        prop_assert!((angle.to_f64() - (y as f64).atan2(x as f64)).abs() < 1e-12);
    }

    /// Kinks: the generalised derivative is the largest of difference quotients near the point.
    #[test]
    fn generalised_derivatives_are_upper_limits(left in -9i64..=9, right in -9i64..=9, w in -4i64..=4) {
        let kink = Kink { left: rational(left, 2), right: rational(right, 2) };
        let value = |x: &Rational| if *x < rational(0, 1) { &kink.left * x } else { &kink.right * x };
        let (w, step) = (rational(w, 1), rational(1, 100));
        let best = (-10..=10).map(|k| {
            let y = rational(k, 2) * &step;
            (value(&(&y + &step * &w)) - value(&y)) / &step
        }).max().unwrap();
        prop_assert_eq!(kink.clarke(&w), best);
        prop_assert_eq!(kink.directional(&w), value(&w));
        prop_assert!(!kink.gradient().is_empty());
        prop_assert_eq!(kink.subgradient().is_empty(), left > right);
    }
}

#[test]
fn kinks_and_spans_of_numbers() {
    let kink = |left: i64, right: i64| Kink { left: rational(left, 1), right: rational(right, 1) };
    let span = |lo: i64, hi: i64| Span { lo: rational(lo, 1), hi: rational(hi, 1) };
    assert_eq!(kink(2, -3).negated(), kink(-2, 3));
    assert_eq!((kink(2, -3).gradient(), kink(2, -3).subgradient()), (span(-3, 2), span(2, -3)));
    assert_eq!((kink(-1, 4).gradient(), kink(-1, 4).subgradient()), (span(-1, 4), span(-1, 4)));
    let within = |(lo, hi): (i64, i64)| span(lo, hi).is_within(&span(1, 3));
    assert_eq!([(1, 3), (2, 2), (0, 2), (2, 4), (0, 4), (9, 8)].map(within), [true, true, false, false, false, true]);
}

#[test]
fn potentials_of_definition_3_are_recognised() {
    let one = rational(1, 1);
    for m in [1, 2, 5] {
        let m = rational(m, 2);
        assert_eq!(Potential::inverse_square_log(&m).check_definition3(), Ok(()));
        assert_eq!(Potential::inverse_square_log(&m).critical(), Some(vec![m.clone()]));
        assert_eq!(Potential::inverse_square_spring(&m, &rational(1, 3)).check_definition3(), Ok(()));
    }
    for a in 2..5 {
        let inflected = Potential::with_inflection(&rational(a, 1));
        assert_eq!(inflected.check_definition3(), Ok(()));
        assert_eq!(inflected.critical(), Some(vec![one.clone(), rational(a, 1)]));
    }
    let of = |slope: &[(i32, i64)]| {
        Potential::new(slope.iter().map(|&(k, c)| (k, rational(c, 1))).collect(), (one.clone(), one.clone()))
    };
    assert_eq!(of(&[(0, 1)]).check_definition3(), Err(PotentialError::NoRepulsion));
    assert_eq!(of(&[(-2, 1), (-3, -1)]).check_definition3(), Err(PotentialError::Bounded));
    // Two minima: V' = (s - 1)(s - 2)(s - 3)/s.
    assert_eq!(of(&[(2, 1), (1, -6), (0, 11), (-1, -6)]).check_definition3(), Err(PotentialError::Minimum));
}

#[test]
fn values_have_their_slopes() {
    for potential in [spring(), Potential::with_inflection(&rational(2, 1))] {
        for n in 1..9 {
            let s = Dual::new(rational(n, 3), rational(1, 1));
            let value = potential.rational_value(&s).unwrap();
            assert_eq!(value.derivative, potential.slope(&s.value).unwrap());
        }
    }
    let log = Potential::inverse_square_log(&rational(2, 1));
    let s = Dual::new(0.75, 1.0);
    let value = log.value(&s).unwrap();
    assert!((value.value - (2.0 / 0.75 + (0.75f64 / 2.0).ln())).abs() < 1e-14);
    assert!((value.derivative - log.slope(&0.75).unwrap()).abs() < 1e-14);
    assert!(log.rational_value(&rational(1, 1)).is_err());
}

#[test]
fn triangular_coordinates_are_those_of_the_lattice() {
    let corner = [Coordinates::Triangular; 3].map(|c| c.square(&[rational(-1, 1), rational(1, 1)]));
    assert!(corner.iter().all(|s| *s == rational(1, 1)));
    // A pair along each direction behaves the same in both bases.
    let pair = |coordinates| {
        let positions = [[rational(0, 1), rational(0, 1)], [rational(1, 1), rational(0, 1)]];
        let rows = hessian(&positions, &[(0, 1)], coordinates, &spring()).unwrap();
        RationalMatrix::from_rows(&rows).unwrap().characteristic_polynomial().unwrap()
    };
    assert_eq!(pair(Coordinates::Cartesian), pair(Coordinates::Triangular));
}

#[test]
fn the_row_of_three_is_a_saddle() {
    let q = |n: i64| rational(n, 1);
    let positions = [[q(-1), q(0)], [q(0), q(0)], [q(1), q(0)]];
    let potential = Potential::inverse_square_log(&rational(4, 3));
    let edges = [(0, 1), (0, 2), (1, 2)];
    let gradients = potential_gradients(&positions, &edges, PLANE, |_, _, s| potential.slope(s)).unwrap();
    assert!(gradients.iter().flatten().all(|x| *x == q(0)));
    let matrix = RationalMatrix::from_rows(&hessian(&positions, &edges, PLANE, &potential).unwrap()).unwrap();
    assert_eq!(matrix, matrix.transpose());
    assert_eq!(inertia(&matrix.to_rows()).unwrap(), Inertia { negative: 1, zero: 3, positive: 2 });
}

#[test]
fn the_linearised_pair_has_the_known_modes() {
    let q = |n: i64| rational(n, 1);
    let state = State { positions: vec![[q(0), q(0)], [q(1), q(0)]], velocities: vec![[q(0), q(0)], [q(0), q(0)]] };
    let rows = linearisation(&state, &[(0, 1)], PLANE, &spring()).unwrap();
    let polynomial = RationalMatrix::from_rows(&rows).unwrap().characteristic_polynomial().unwrap();
    // V'' = 2: along the line x² + 2x + 2 · 4 · 2, across x (x + 2), and x² twice for the mean.
    let expected = [0, 0, 0, 0, 0, 32, 20, 4, 1].map(q);
    assert_eq!(polynomial.coefficients(), expected.to_vec());
    let nobody = State::<Rational> { positions: vec![], velocities: vec![] };
    assert_eq!(linearisation(&nobody, &[], PLANE, &spring()), Ok(vec![]));
}

#[test]
fn refusals_are_errors() {
    let q = |n: i64| rational(n, 1);
    let same = State { positions: vec![[q(0), q(0)], [q(0), q(0)]], velocities: vec![[q(0), q(0)], [q(0), q(0)]] };
    assert!(velocity_alignment(&same, &[(0, 1)], PLANE, |_, _, s| spring().slope(s)).is_err());
    assert!(velocity_alignment(&same, &[], PLANE, |_, _, s| spring().slope(s)).is_ok());
    // A link to an agent that is not there.
    for nobody in [&same.positions[..], &[]] {
        assert!(hessian(nobody, &[(0, 2)], PLANE, &spring()).is_err());
    }
    assert!(heading(&[0.0, 0.0]).is_err());
    assert!(heading_rate(&[q(0), q(0)], &[q(1), q(0)]).is_err());
    assert!(kinetic_energy::<Rational>(&[], PLANE).is_err());
    assert!(State::<Rational>::from_list(2, &[q(0), q(1)]).is_none());
    assert!(State::<Rational>::from_list(1 << 62, &[]).is_none());
    assert_eq!(rotated(&[q(1), q(2)]), [q(-2), q(1)]);
    assert!((HeadingDifference::Wrapped.read(6.0) - (6.0 - std::f64::consts::TAU)).abs() < 1e-15);
    assert!((HeadingDifference::Wrapped.read(-6.0) + (6.0 - std::f64::consts::TAU)).abs() < 1e-15);
    assert_eq!([HeadingDifference::Raw, HeadingDifference::Unwrapped].map(|d| d.read(6.0)), [6.0, 6.0]);
    assert_eq!(HeadingDifference::Wrapped.read(3.0), 3.0);
    assert_eq!(PLANE.square(&[q(3), q(4)]), q(25).square().over(&q(25)).unwrap());
}
