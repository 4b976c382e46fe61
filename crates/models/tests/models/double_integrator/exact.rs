//! The closed loops at any state, saturated energies, ties, steady motions and the two special flocks, against naive twins.

use super::{PLANE, places, spring, state};
use algebra::graph::Graph;
use arithmetic::{Rational, rational};
use models::double_integrator::{
    AnyHeadings, AnyPotentials, Coordinates, HeadingDifference, Potential, State, SteadyMotion, TiedRate, cross,
    crosses_for_ever, dot, follow, gyroscopic, heading, kinetic_energy, linked_within, potential_gradients, rhombus,
    saturated_potential, saturated_rate, symmetric_modes, tied, turning_triangle,
};
use motion::Tolerance;
use proptest::prelude::*;

fn square(s: i64) -> Rational {
    rational(s, 4)
}

/// `U` summed over all pairs, from its definition.
fn naive_saturated(state: &State<Rational>, square: &Rational) -> Option<Rational> {
    let mut total = rational(0, 1);
    for j in 0..state.count() {
        for i in 0..j {
            let s = PLANE.square(&state.separation(i, j));
            total += spring().rational_value(if s < *square { &s } else { square }).ok()?;
        }
    }
    Some(total)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn saturated_potentials_are_sums_over_all_pairs(r in places(4), s in 1i64..40) {
        let (state, square) = (state(&r, &[(0, 0); 4]), square(s));
        let links = linked_within(&state.positions, &square, PLANE).edges();
        let value = |_: usize, _: usize, s: &Rational| spring().rational_value(s);
        let beyond = spring().rational_value(&square).unwrap();
        let found = saturated_potential(&state.positions, &links, PLANE, value, &beyond).ok();
        prop_assert_eq!(found, naive_saturated(&state, &square));
    }

    /// The forward rate against a difference quotient of the definition along a parabola.
    #[test]
    fn rates_of_the_saturated_energy_are_limits(r in places(3), v in places(3), s in 1i64..40) {
        let (state, square) = (state(&r, &v), square(s));
        let Ok((rate, form)) = saturated_rate(&state, &square, &spring()) else { return Ok(()) };
        if tied(&state.positions, &square, PLANE).is_empty() {
            prop_assert_eq!(&rate, &form);
        }
        let edges = linked_within(&state.positions, &square, PLANE).edges();
        let a = models::double_integrator::velocity_alignment(&state, &edges, PLANE, |_, _, s| spring().slope(s)).unwrap();
        let step = rational(1, 1 << 40);
        let moved = |x: &[[Rational; 2]], rate: &[[Rational; 2]]| -> Vec<[Rational; 2]> {
            x.iter().zip(rate).map(|(x, v)| [0, 1].map(|k| &x[k] + &step * &v[k])).collect()
        };
        let later = State {
            positions: moved(&state.positions, &state.velocities),
            velocities: moved(&state.velocities, &a),
        };
        let energy = |state: &State<Rational>| {
            Some(naive_saturated(state, &square)? + kinetic_energy(&state.velocities, PLANE).ok()?)
        };
        let (Some(now), Some(then)) = (energy(&state), energy(&later)) else { return Ok(()) };
        let quotient = (then - now) / &step;
        let error = num_traits::Signed::abs(&(quotient - &rate));
        prop_assert!(error < rational(1, 1 << 12), "{}", error);
    }

    /// The generalised derivative against all weights on a grid: every number in it is reached for every `z`, none outside is.
    #[test]
    fn generalised_derivatives_are_intersections(p in -6i64..=6, q in 0i64..=6, base in -3i64..=0) {
        let tied = TiedRate { base: rational(base, 1), ties: vec![(rational(p, 1), rational(q, 1))] };
        let found = tied.derivative();
        let inside = |x: &Rational| (0..=10).all(|z| {
            let (first, second) = (&tied.base + rational(z * p, 10), &tied.base + rational(z * p, 10) - rational(p + q, 1));
            let (lo, hi) = if first < second { (first, second) } else { (second, first) };
            lo <= *x && *x <= hi
        });
        for k in -80..=80 {
            let x = rational(k, 4);
            prop_assert_eq!(found.contains(&x), inside(&x));
        }
        prop_assert_eq!(tied.hull().lo, tied.all_linked());
    }

    /// The loop at any state has the law's accelerations and loses the energy of the alignment.
    #[test]
    fn any_potentials_follow_the_law(at in prop::collection::vec(-9i64..=9, 15)) {
        let graph = Graph::path(3).with_edges(&[(0, 2)]);
        let at: Vec<Rational> = at.iter().map(|n| rational(*n, 2)).collect();
        let flock = AnyPotentials::read(&graph, &at).unwrap();
        prop_assert_eq!(AnyPotentials::variables(&graph), 15);
        prop_assert_eq!(AnyPotentials::names(&graph).len(), 15);
        let lost: Rational = graph.edges().iter().map(|&(i, j)| {
            let v = flock.state.relative_velocity(i, j);
            dot(&v, &v)
        }).sum();
        prop_assert_eq!(flock.energy_rate().unwrap(), -lost);
        let half: Rational = flock.agent_rates().unwrap().iter().sum::<Rational>() / rational(2, 1);
        let work: Rational = flock.gradients().unwrap().iter().zip(&flock.state.velocities).map(|(g, v)| dot(g, v)).sum();
        prop_assert_eq!(half, work);
    }

    /// The headings of the loop turn by the cross product, and the mechanical energy is constant.
    #[test]
    fn any_headings_follow_the_law(at in prop::collection::vec(-9i64..=9, 17)) {
        let graph = Graph::path(3);
        let at: Vec<Rational> = at.iter().map(|n| rational(*n, 2)).collect();
        let Ok(whole) = AnyHeadings::read(&graph, &at) else { return Ok(()) };
        let naive: Vec<[Rational; 2]> = gyroscopic(&whole.flock.state, &whole.gradients, &graph.edges(), |i, j| {
            &whole.headings[i] - &whole.headings[j]
        }).unwrap();
        prop_assert_eq!(&whole.accelerations, &naive);
        let Ok(rates) = whole.heading_rates() else { return Ok(()) };
        for (i, rate) in rates.iter().enumerate() {
            let v = &whole.flock.state.velocities[i];
            prop_assert_eq!(rate * dot(v, v), cross(v, &naive[i]));
        }
        prop_assert_eq!(whole.rate_of((1, 2), (1, 2), (0, 1)).unwrap(), rational(0, 1));
    }
}

#[test]
fn short_lists_are_refused() {
    let graph = Graph::path(2);
    assert!(AnyPotentials::read(&graph, &[rational(1, 1)]).is_err());
    assert!(AnyHeadings::read(&graph, &[rational(1, 1)]).is_err());
    let missing = AnyPotentials::read(&graph, &vec![rational(1, 1); 8]).unwrap();
    assert!(missing.accelerations().is_err());
}

#[test]
fn steady_motions_stay() {
    let pair = SteadyMotion::new("a pair", &[(0, 1)], PLANE, spring(), &[((0, 0), (1, 0)), ((1, 0), (1, 0))]);
    assert_eq!(pair.is_steady(), Ok(true));
    assert!(pair.agrees() && pair.coincident().is_none());
    assert_eq!(pair.not_minimised(), Ok(None));
    assert_eq!(pair.is_critical(), Ok(true));
    assert_eq!(pair.squares(), [rational(1, 1)]);
    assert_eq!(pair.is_stable_up_to_motions(), Some(true));
    let floats = pair.state.map(|x| num_traits::ToPrimitive::to_f64(x).unwrap());
    let tolerance = Tolerance { relative: 1e-10, absolute: 1e-10 };
    let law = |state: &State<f64>| {
        models::double_integrator::velocity_alignment(state, &[(0, 1)], PLANE, |_, _, s| spring().slope(s))
    };
    let end = follow(&floats, &[5.0], tolerance, law).unwrap();
    assert!((end[0].positions[1][0] - 6.0).abs() < 1e-9);
    let wide = SteadyMotion::new("apart", &[(0, 1)], PLANE, spring(), &[((0, 0), (0, 0)), ((2, 0), (0, 0))]);
    assert_eq!((wide.is_steady(), wide.not_minimised()), (Ok(false), Ok(Some(0))));
}

#[test]
fn the_rhombus_turns_about_its_shape() {
    let three = rational(3, 1);
    assert_eq!(Coordinates::Triangular.square(&rhombus().separation(0, 2)), three);
    assert_eq!(crosses_for_ever(&Potential::with_inflection(&three), &three), Ok(true));
    assert_eq!(crosses_for_ever(&Potential::with_inflection(&three), &rational(4, 1)), Ok(false));
    assert_eq!(crosses_for_ever(&spring(), &three), Ok(false));
    // V'' = 2 at 1: bars of stiffness 8 along and alignment; the side bars at 30 degrees to the long diagonal.
    let sides = [(0, 1), (1, 2), (0, 3), (2, 3), (1, 3)];
    // (x² + 4x + 20)(x² + 2x + 12) - 48.
    let modes = symmetric_modes(&sides, &spring()).unwrap();
    assert_eq!(modes.coefficients(), [192, 88, 40, 6, 1].map(num_bigint::BigInt::from));
    assert!(rhombus().velocities.iter().flatten().all(|v| *v == rational(0, 1)));
}

/// Slope `(s - 1)(s - 3)(b s + a)`: an equilibrium with both links whatever a and b are.
#[test]
fn the_rhombus_needs_modes_that_turn_with_and_without_its_link() {
    let three = rational(3, 1);
    let crosses = |a: Rational, b: Rational| {
        let slope = [(3, b.clone()), (2, &a - rational(4, 1) * &b), (1, rational(3, 1) * &b - rational(4, 1) * &a)];
        let slope = slope.into_iter().chain([(0, rational(3, 1) * &a)]).collect();
        crosses_for_ever(&Potential::new(slope, (rational(1, 1), rational(0, 1))), &three)
    };
    // V'' = -2 (a + b) at 1 and 2 (a + 3 b) at 3.
    let with = |first: (i64, i64), third: i64| {
        let (first, third) = (rational(-first.0, 2 * first.1), rational(third, 2));
        let b = (&third - &first) / rational(2, 1);
        crosses(first - &b, b)
    };
    assert_eq!(with((2, 1), 1), Ok(true));
    assert_eq!(with((-2, 1), 1), Ok(false), "unstable");
    assert_eq!(with((1, 100), 1), Ok(false), "overdamped");
    assert_eq!(with((0, 1), 1), Ok(false), "without stiffness");
    // Linked (x² + 4x + k) with k above 4 twice; not linked (x² + 4x + 4.2)(x² + 2x + 2.52) - 2.1168, negative at -2.
    assert_eq!(with((42, 100), 20), Ok(false), "overdamped without the link");
}

#[test]
fn laws_without_accelerations_for_all_stop_the_motion() {
    let tolerance = Tolerance { relative: 1e-6, absolute: 1e-6 };
    let start = State { positions: vec![[0.0, 0.0], [1.0, 0.0]], velocities: vec![[0.0, 1.0], [0.0, 1.0]] };
    let along =
        |count: usize| follow(&start, &[1.0], tolerance, |_| Ok(vec![[0.0, 0.0]; count])).map(|mut s| s.remove(0));
    let end = along(2).unwrap();
    assert!((0..2).all(|k| end.positions[k][0] == k as f64 && (end.positions[k][1] - 1.0).abs() < 1e-9));
    assert!(along(1).is_err() && along(3).is_err());
    let none = |_: &State<f64>| Err(arithmetic::ArithmeticError::DivisionByZero);
    assert!(follow(&start, &[1.0], tolerance, none).is_err());
}

#[test]
fn the_triangle_turns_in_floats_too() {
    let potential = Potential::inverse_square_log(&rational(1, 1));
    assert_eq!(turning_triangle(&potential, &rational(1, 1), [0; 3]), Ok(true));
    assert_eq!(turning_triangle(&potential, &rational(2, 1), [0; 3]), Ok(false));
    assert_eq!(turning_triangle(&spring(), &rational(1, 1), [0; 3]), Ok(false));
    // Whole turns count where they do not cancel; agents at rest have no headings.
    assert_eq!(turning_triangle(&potential, &rational(1, 1), [1, -1, 1]), Ok(true));
    for turns in [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]] {
        assert_eq!(turning_triangle(&potential, &rational(1, 1), turns), Ok(false));
    }
    let rests = Potential::inverse_square_spring(&rational(2, 1), &rational(1, 1));
    assert_eq!(turning_triangle(&rests, &rational(0, 1), [0; 3]), Ok(false));
    let (radius, omega) = ((2.0f64 / 3.0).sqrt(), 1.5f64.sqrt());
    let corner = |k: usize, time: f64| {
        let angle = std::f64::consts::TAU * k as f64 / 3.0 + 0.4 + omega * time;
        [radius * angle.cos(), radius * angle.sin()]
    };
    let positions: Vec<[f64; 2]> = (0..3).map(|k| corner(k, 0.0)).collect();
    let velocities = positions.iter().map(|r| [-omega * r[1], omega * r[0]]).collect();
    let edges = [(0, 1), (0, 2), (1, 2)];
    let law = |state: &State<f64>| {
        let gradients = potential_gradients(&state.positions, &edges, PLANE, |_, _, s| potential.slope(s))?;
        let angles = state.velocities.iter().map(heading).collect::<Result<Vec<f64>, _>>()?;
        gyroscopic(state, &gradients, &edges, |i, j| HeadingDifference::Wrapped.read(angles[i] - angles[j]))
    };
    let tolerance = Tolerance { relative: 1e-11, absolute: 1e-11 };
    let end = follow(&State { positions, velocities }, &[1.0], tolerance, law).unwrap();
    for (k, r) in end[0].positions.iter().enumerate() {
        let expected = corner(k, 1.0);
        assert!((r[0] - expected[0]).abs() + (r[1] - expected[1]).abs() < 1e-7);
    }
}
