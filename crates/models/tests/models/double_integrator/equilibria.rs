//! Hessians against directional derivatives, equilibria that are known exactly, rates of a pair.

use algebra::graph::Graph;
use arithmetic::{Dual, rational};
use models::double_integrator::equilibria::{Framework, classes, distances, random_places};
use models::double_integrator::relaxation::relaxation;
use models::double_integrator::{Coordinates, Potential, hessian, potential_gradients};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

fn framework(graph: &Graph) -> Framework {
    Framework { edges: graph.edges(), potential: Potential::inverse_square_log(&rational(1, 1)) }
}

fn complete(count: usize) -> Graph {
    Graph::from_fn(count, |_, _| true)
}

/// The Hessian is assembled edge by edge; column by column it is the derivative of all gradients.
#[test]
fn the_hessian_is_the_derivative_of_the_gradients() {
    let potential = Potential::inverse_square_spring(&rational(2, 1), &rational(3, 1));
    let places = [[0, 0], [2, 1], [-1, 3], [4, -2]].map(|r| r.map(|x| rational(x, 3)));
    for coordinates in [Coordinates::Cartesian, Coordinates::Triangular] {
        for graph in Graph::all(4).step_by(7) {
            let found = hessian(&places, &graph.edges(), coordinates, &potential).unwrap();
            for column in 0..8 {
                let rate = |index: usize| rational(i64::from(index == column), 1);
                let moved: Vec<_> = places
                    .iter()
                    .enumerate()
                    .map(|(i, r)| [0, 1].map(|k| Dual::new(r[k].clone(), rate(2 * i + k))))
                    .collect();
                let gradients =
                    potential_gradients(&moved, &graph.edges(), coordinates, |_, _, s| potential.slope(s)).unwrap();
                let naive: Vec<_> = gradients.into_iter().flatten().map(|x| x.derivative).collect();
                let own: Vec<_> = found.iter().map(|row| row[column].clone()).collect();
                assert_eq!(own, naive);
            }
        }
    }
}

#[test]
fn known_equilibria_are_proved() {
    let a = 0.75f64.sqrt();
    let row = framework(&complete(3)).approach(&[[-a, 0.0], [1e-3, 0.0], [a, 0.0]]).unwrap();
    let proved = framework(&complete(3)).enclose(&row).unwrap();
    assert_eq!((proved.negative, proved.zero, proved.positive), (1, 0, 2));
    let triangle = framework(&complete(3)).descend(&[[0.0, 0.0], [1.2, 0.1], [0.4, 0.8]]).unwrap();
    assert!(distances(&triangle.positions).iter().all(|d| (d - 1.0).abs() < 1e-9));
    let proved = framework(&complete(3)).enclose(&triangle).unwrap();
    assert_eq!((proved.negative, proved.zero, proved.positive), (0, 0, 3));
    let pair = framework(&complete(2)).descend(&[[0.0, 0.0], [0.3, 1.2]]).unwrap();
    assert_eq!(framework(&complete(2)).enclose(&pair).unwrap().positive, 1);
}

#[test]
fn nothing_is_proved_away_from_rest_or_where_it_bends() {
    let path = framework(&Graph::path(3));
    let bent = path.descend(&[[0.0, 0.0], [1.1, 0.1], [1.2, 1.3]]).unwrap();
    assert_eq!((bent.inertia.negative, bent.inertia.zero), (0, 4));
    assert!(path.enclose(&bent).is_none());
    let mut off = framework(&complete(3)).descend(&[[0.0, 0.0], [1.2, 0.1], [0.4, 0.8]]).unwrap();
    off.positions[2] = [5.0, 5.0];
    assert!(framework(&complete(3)).enclose(&off).is_none());
}

#[test]
fn congruent_configurations_are_one_class() {
    let framework = framework(&complete(3));
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let found: Vec<_> = (0..20).filter_map(|_| framework.descend(&random_places(3, &mut random))).collect();
    assert!(found.len() > 10);
    let classes = classes(found);
    assert_eq!(classes.len(), 1);
    assert!((classes[0].0.energy - 3.0).abs() < 1e-9);
}

/// A pair: `x'' + 2x' + 8x = 0` along the line, rate 2 across it, and a rotation of rate 0.
#[test]
fn the_rates_of_a_pair() {
    let pair = framework(&complete(2));
    let found = pair.descend(&[[0.0, 0.0], [1.2, 0.3]]).unwrap();
    let rates = relaxation(&pair, &found).unwrap();
    assert!((rates.rate - 1.0).abs() < 1e-9 && rates.swings && rates.neutral == 1, "{rates:?}");
    // x'' + 2x' + x/4 = 0: the slow rate is 1 - sqrt(3)/2.
    let soft = Framework { potential: pair.potential.times(&rational(1, 32)), ..pair };
    let rates = relaxation(&soft, &found).unwrap();
    assert!((rates.rate - (1.0 - 0.75f64.sqrt())).abs() < 1e-9 && !rates.swings, "{rates:?}");
}
