//! Cell lists against all pairs.

use flockproof::simulate::{CellError, CellList};
use proptest::prelude::*;

fn naive(points: &[[f64; 2]], radius: f64) -> Vec<(usize, usize)> {
    let near = |i: usize, j: usize| {
        let r = [points[j][0] - points[i][0], points[j][1] - points[i][1]];
        r[0] * r[0] + r[1] * r[1] < radius * radius
    };
    (0..points.len()).flat_map(|i| (i + 1..points.len()).map(move |j| (i, j))).filter(|&(i, j)| near(i, j)).collect()
}

fn assert_pairs(points: &[[f64; 2]], radius: f64) {
    let list = CellList::new(points, radius).expect("finite");
    let pairs = naive(points, radius);
    assert_eq!(list.pairs(), pairs);
    let counts = list.fold_neighbours(0usize, |count, _, _, _, _| count + 1);
    assert_eq!(counts.iter().sum::<usize>(), 2 * pairs.len());
    let sums = list.fold_neighbours([0.0; 2], |sum, i, j, r, square| {
        assert_eq!(r, [points[j][0] - points[i][0], points[j][1] - points[i][1]]);
        [sum[0] + square, sum[1] + j as f64]
    });
    for (i, sum) in sums.iter().enumerate() {
        let others: usize = pairs
            .iter()
            .map(|&(a, b)| {
                if a == i {
                    b
                } else if b == i {
                    a
                } else {
                    0
                }
            })
            .sum();
        assert_eq!(sum[1] as usize, others);
    }
}

#[test]
fn lattices_equal_points_and_far_ones() {
    let lattice: Vec<[f64; 2]> = (0..12).flat_map(|i| (0..9).map(move |j| [f64::from(i), f64::from(j)])).collect();
    for radius in [0.5, 1.0, 1.0 + 1e-12, 2.0, 2.5, 100.0] {
        assert_pairs(&lattice, radius);
    }
    assert_pairs(&[[1.0, 1.0]; 20], 0.1);
    assert_pairs(&[], 1.0);
    assert_pairs(&[[3.0, 4.0]], 1.0);
    // A few points far apart must not ask for cells without end.
    assert_pairs(&[[0.0, 0.0], [1e12, 0.0], [1e12, 0.5], [0.0, -1e12], [0.3, 0.0]], 1.0);
    assert_pairs(&[[1e15, 1.0], [1e15, 1.2], [-1e15, 0.0]], 0.5);
    assert_eq!(CellList::new(&[[0.0, f64::NAN]], 1.0).map(|_| ()), Err(CellError::Position(0)));
    assert_eq!(CellList::new(&[], 0.0).map(|_| ()), Err(CellError::Radius(0.0)));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn points_anywhere(points in prop::collection::vec((-10i32..10, -300i32..300), 0..80), radius in 0.1f64..8.0) {
        let points: Vec<[f64; 2]> = points.into_iter().map(|(x, y)| [f64::from(x) / 2.0, f64::from(y) / 7.0]).collect();
        assert_pairs(&points, radius);
    }
}
