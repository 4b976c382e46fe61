//! The parts of a network, against the formulas of `notes/exact_flocks.md`.

use super::super::balls::Balls;
use super::*;
use crate::averaging::{Flock, Hysteresis, Start};
use algebra::graph::Graph;
use arithmetic::rational;

fn balls(flock: &Flock) -> Balls<2> {
    Balls::new(&flock.integers(), flock.network().clone(), flock.weights(), (0, 0)).unwrap().unwrap()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * b.abs()
}

/// Steps 11 to 13 for a path of three with the weights 1/2, 1/3, 1/2 and one alone: the means, how far velocities are from them, and what is
/// left of the way.
#[test]
fn parts_of_the_network_have_the_bounds_of_the_notes() {
    let places = [0, 1, 2, 9].map(|x| rational(x, 1)).to_vec();
    let velocities = [1, 2, -1, 4].map(|v| rational(v, 8)).to_vec();
    let flock = Flock::new(&Start::on_the_line(places, velocities, Weights::Vicsek, Hysteresis::None)).unwrap();
    let parts = balls(&flock).wholes();
    assert_eq!(parts.iter().map(|w| w.members.clone()).collect::<Vec<_>>(), [vec![0, 1, 2], vec![3]]);
    // Less the first velocity they are 0, 1/8, -1/4, with the shares 2/7, 3/7, 2/7.
    assert!(close(parts[0].mean[0], (3.0 / 8.0 - 2.0 / 4.0) / 7.0));
    assert!(close(parts[0].range, 2.0 * 0.25));
    // Velocities less the mean are 1/56, 8/56, -13/56: Gamma u is 0, (1/28), .. by L y = C^-1 u, about the mean.
    let (first, last) = (2.0 / 56.0, 26.0 / 56.0);
    let (a, b) = (parts[0].rest[0] - parts[0].rest[1], parts[0].rest[2] - parts[0].rest[1]);
    assert!(close(a, first) && close(b, -last), "{a} {b}");
    assert!(parts[0].rest_error < 1e-12 && parts[0].stray >= first + last && close(parts[0].stray, first + last));
    assert!((parts[1].mean[0], parts[1].range, parts[1].stray) == (0.0, 0.0, 0.0));
    let error = 2.0 * balls(&flock).errors().1;
    assert!(
        close(parts[1].mean_error, error) && close(parts[0].mean_error, error + (1e-12 + 12.0 * f64::EPSILON) * 0.25)
    );
    // Where velocities are equal only the error of the balls is left, in the plane longer by the root of two.
    let row = |x: i64| vec![rational(x, 1), rational(0, 1)];
    let start = Start {
        positions: vec![row(0), row(1)],
        velocities: vec![row(1), row(1)],
        weights: Weights::Lazy,
        hysteresis: Hysteresis::None,
    };
    let flock = Flock::new(&start).unwrap();
    let parts = balls(&flock).wholes();
    assert!(close(parts[0].range, 2.0 * 2.0 * 2f64.sqrt() * balls(&flock).errors().1));
    // The root of nine halves is the bound of Gamma for a pair.
    let most = parts[0].range * 3f64.powf(1.5) * 0.5;
    assert!(parts[0].stray <= 2.01 * most && parts[0].stray > 0.0);
}

/// Twice the distance of the farthest from the first, and at most one less than there are nodes.
#[test]
fn longest_paths_are_no_longer_than_this() {
    let of = |n: usize, edges: &[(usize, usize)], members: &[usize]| {
        longest_path(&Graph::from_edges(n, edges).unwrap(), members)
    };
    assert_eq!(of(5, &[(0, 1), (1, 2), (2, 3), (3, 4)], &[0, 1, 2, 3, 4]), 4);
    assert_eq!(of(5, &[(2, 1), (1, 0), (0, 3), (3, 4)], &[0, 1, 2, 3, 4]), 4);
    assert_eq!(of(6, &[(1, 2), (1, 3), (1, 4), (1, 5)], &[1, 2, 3, 4, 5]), 2);
    assert_eq!(of(6, &[(1, 2), (2, 3), (3, 4), (4, 5), (5, 1)], &[1, 2, 3, 4, 5]), 4);
    assert_eq!(of(2, &[(0, 1)], &[0, 1]), 1);
}
