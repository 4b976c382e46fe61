//! The closed loops at any state with any slopes, term by term.

use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Dual, Rational, Ring, rational};
use models::double_integrator::{AnyHeadings, AnyPotentials, State, SteadyMotion, Vector, cross, dot};
use models::double_integrator::{Coordinates, Potential};
use proptest::prelude::*;

type Vectors = Vec<Vector<Rational>>;

/// Position and velocity of an agent, in whole numbers.
type Whole = ((i64, i64), (i64, i64));

/// A path of four with a further edge: agents 0, 1, 2 in a triangle, 3 beside.
fn graph() -> Graph {
    Graph::path(4).with_edges(&[(0, 2)])
}

fn numbers(list: &[i64]) -> Vec<Rational> {
    list.iter().map(|n| rational(*n, 2)).collect()
}

/// `sum over the neighbours of (own slope) 2 r_ij`.
fn gradients(flock: &AnyPotentials<Rational>) -> Vectors {
    let slope = |i: usize, j: usize| {
        let place = flock.edges.iter().position(|pair| *pair == (i.min(j), i.max(j)));
        place.map_or(rational(0, 1), |place| flock.slopes[place].clone())
    };
    let of = |i: usize| {
        let others = (0..4).filter(|&j| j != i);
        others.fold([rational(0, 1), rational(0, 1)], |sum, j| {
            let (r, g) = (flock.state.separation(i, j), slope(i, j));
            [0, 1].map(|k| &sum[k] + rational(2, 1) * &g * &r[k])
        })
    };
    (0..4).map(of).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn gradients_have_the_slopes_of_their_pairs(at in prop::collection::vec(-9i64..=9, 20)) {
        let at = numbers(&at);
        let flock = AnyPotentials::read(&graph(), &at).unwrap();
        prop_assert_eq!(&flock.slopes[..], &at[16..]);
        prop_assert_eq!(&flock.state, &State::from_list(4, &at[..16]).unwrap());
        let known = gradients(&flock);
        prop_assert_eq!(flock.gradients().unwrap(), known.clone());
        // The law: -sum (v_i - v_j) - gradient.
        for (i, a) in flock.accelerations().unwrap().iter().enumerate() {
            for k in [0, 1] {
                let near = flock.edges.iter().filter(|(a, b)| *a == i || *b == i).map(|(a, b)| a + b - i);
                let aligned: Rational = near.map(|j| &flock.state.velocities[j][k] - &flock.state.velocities[i][k]).sum();
                prop_assert_eq!(&a[k], &(aligned - &known[i][k]));
            }
        }
        for ((i, j), (first, second)) in flock.edges.iter().zip(flock.pair_gradients().unwrap()) {
            let place = flock.edges.iter().position(|pair| pair == &(*i, *j)).unwrap();
            let pull = flock.state.separation(*i, *j).map(|x| rational(2, 1) * &flock.slopes[place] * x);
            prop_assert_eq!(&first, &pull);
            prop_assert_eq!(second, pull.map(|x| -x));
        }
        for k in [0, 1] {
            prop_assert_eq!(flock.axis(k), flock.state.velocities.iter().map(|v| v[k].clone()).collect::<Vec<_>>());
        }
        // d/dt V_i = sum over the neighbours of 2 g r.(v_i - v_j).
        for (i, rate) in flock.agent_rates().unwrap().iter().enumerate() {
            let own = flock.edges.iter().zip(&flock.slopes).filter(|((a, b), _)| *a == i || *b == i);
            let naive: Rational = own.map(|(&(a, b), g)| {
                rational(2, 1) * g * dot(&flock.state.separation(a, b), &flock.state.relative_velocity(a, b))
            }).sum();
            prop_assert_eq!(rate, &naive);
        }
        // p/q sum V_i + sum |v_i|²/2, with every V_ij in two of the V_i, and its rate along any accelerations.
        let speeds: Rational = flock.state.velocities.iter().map(|v| dot(v, v)).sum();
        let potential: Rational = flock.edges.iter().zip(&flock.slopes).map(|(&(i, j), g)| {
            let r = flock.state.separation(i, j);
            g * dot(&r, &r)
        }).sum();
        let accelerations: Vectors = (0..4).map(|i| [rational(i, 3), rational(1 - i, 2)]).collect();
        let rate: Rational = flock.state.velocities.iter().zip(&accelerations).map(|(v, a)| dot(v, a)).sum();
        let work: Rational = gradients(&flock).iter().zip(&flock.state.velocities).map(|(g, v)| dot(g, v)).sum();
        for (p, q) in [(1, 2), (1, 1), (3, 7), (-2, 5)] {
            let found = flock.energy(&flock.state.moving(&accelerations), (p, q)).unwrap();
            prop_assert_eq!(found.value, &potential * rational(2 * p, q) + &speeds / rational(2, 1));
            prop_assert_eq!(found.derivative, &work * rational(2 * p, q) + &rate);
        }
    }

    #[test]
    fn headings_turn_by_gradients_and_differences(at in prop::collection::vec(-9i64..=9, 24)) {
        let at = numbers(&at);
        let Ok(whole) = AnyHeadings::read(&graph(), &at) else { return Ok(()) };
        prop_assert_eq!(&whole.headings[..], &at[20..]);
        let velocities = whole.flock.state.velocities.clone();
        prop_assume!(velocities.iter().all(|v| dot(v, v) != rational(0, 1)));
        let over = |i: usize, j: usize| {
            let r = whole.flock.state.separation(i, j);
            (&whole.headings[i] - &whole.headings[j]) / dot(&r, &r)
        };
        let near = |i: usize| whole.flock.edges.iter().filter(move |(a, b)| *a == i || *b == i).map(move |(a, b)| a + b - i);
        let (laplacian, potential) = (whole.laplacian().unwrap(), whole.potential_rates().unwrap());
        prop_assert_eq!((laplacian.len(), potential.len()), (4, 4));
        let rates = whole.heading_rates().unwrap();
        let known = gradients(&whole.flock);
        for i in 0..4 {
            prop_assert_eq!(&laplacian[i], &near(i).map(|j| over(i, j)).sum::<Rational>());
            prop_assert_eq!(&potential[i], &(-cross(&velocities[i], &known[i]) / dot(&velocities[i], &velocities[i])));
            prop_assert_eq!(&rates[i], &(&potential[i] - &laplacian[i]));
            for k in [0, 1] {
                prop_assert_eq!(&whole.alignment()[i][k], &(&whole.accelerations[i][k] + &known[i][k]));
            }
        }
        // d/dt of p sum V_i + q sum |v_i|² + h sum theta_i².
        let sum = |terms: Vec<Rational>| terms.into_iter().sum::<Rational>();
        let potentials = sum(known.iter().zip(&velocities).map(|(g, v)| rational(2, 1) * dot(g, v)).collect());
        let speeds = sum(whole.accelerations.iter().zip(&velocities).map(|(a, v)| rational(2, 1) * dot(a, v)).collect());
        let angles = sum(whole.headings.iter().zip(&rates).map(|(x, rate)| rational(2, 1) * x * rate).collect());
        for (p, q, h) in [((1, 2), (1, 2), (0, 1)), ((1, 1), (0, 1), (0, 1)), ((0, 1), (1, 3), (0, 1)), ((0, 1), (0, 1), (2, 5)), ((3, 7), (-1, 4), (5, 2))] {
            let known = &potentials * rational(p.0, p.1) + &speeds * rational(q.0, q.1) + &angles * rational(h.0, h.1);
            prop_assert_eq!(whole.rate_of(p, q, h).unwrap(), known);
        }
    }
}

/// A list for each agent and each edge, no longer and no shorter.
#[test]
fn lists_of_another_length_are_no_loops() {
    assert_eq!((AnyPotentials::variables(&graph()), AnyHeadings::variables(&graph())), (20, 24));
    let names = AnyPotentials::names(&Graph::path(2));
    assert_eq!(names, ["x1", "y1", "x2", "y2", "vx1", "vy1", "vx2", "vy2", "V'_12"]);
    let list = |count: i64| (1..=count).map(|k| rational(k * k, 1)).collect::<Vec<_>>();
    for (count, is_read) in [(19, false), (20, false), (23, false), (24, true), (25, false)] {
        assert_eq!(AnyHeadings::read(&graph(), &list(count)).is_ok(), is_read, "{count}");
    }
    for (count, is_read) in [(15, false), (16, true), (20, true)] {
        assert_eq!(AnyPotentials::read(&graph(), &list(count)).is_ok(), is_read, "{count}");
    }
    let few = AnyPotentials::read(&graph(), &list(19)).unwrap();
    assert_eq!(few.gradients(), Err(ArithmeticError::Domain("a slope for each edge")));
    let value = Dual::new(rational(1, 1), rational(0, 1));
    assert_eq!(value.one().value, rational(1, 1));
}

/// One agent agrees with itself; three at the corners of a triangle, in oblique coordinates, are each at a minimum of their own.
#[test]
fn few_agents_are_steady_too() {
    let spring = Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1));
    let of = |edges: &[(usize, usize)], agents: &[Whole]| {
        SteadyMotion::new("few", edges, Coordinates::Triangular, spring.clone(), agents)
    };
    let alone = of(&[], &[((3, 4), (1, 2))]);
    assert!(alone.agrees() && alone.is_steady() == Ok(true) && alone.not_minimised() == Ok(None));
    let corners = of(&[(0, 1), (0, 2), (1, 2)], &[((0, 0), (0, 0)), ((1, 0), (0, 0)), ((0, 1), (0, 0))]);
    assert_eq!((corners.not_minimised(), corners.is_critical()), (Ok(None), Ok(true)));
}
