//! Cell lists against all pairs.

use arithmetic::Complex;
use models::oscillator::Neighbours;
use motion::{CellError, CellList, nearest};
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
    let counts = list.fold_neighbours(points.len(), 0usize, |count, _, _, _, _| count + 1);
    assert_eq!(counts.iter().sum::<usize>(), 2 * pairs.len());
    let half = points.len() / 2;
    assert_eq!(list.fold_neighbours(half, 0usize, |count, _, _, _, _| count + 1), counts[..half]);
    let sums = list.fold_neighbours(points.len(), [0.0; 2], |sum, i, j, r, square| {
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

fn assert_nearest(points: &[[f64; 2]], count: usize) {
    let complex: Vec<Complex<f64>> = points.iter().map(|p| Complex::new(p[0], p[1])).collect();
    let expected = Neighbours::nearest(&complex, count);
    for (k, found) in nearest(points, count).expect("finite").iter().enumerate() {
        assert_eq!(found, expected.of_particle(k), "{count} nearest of {k}");
    }
}

/// Points up to any radius, whatever that of the list.
fn assert_up_to(points: &[[f64; 2]], of_list: f64, radius: f64) {
    let list = CellList::new(points, of_list).expect("finite");
    for (place, &i) in list.numbers().iter().enumerate() {
        let square = |j: usize| (points[j][0] - points[i][0]).powi(2) + (points[j][1] - points[i][1]).powi(2);
        let mut found = Vec::new();
        list.visit_up_to(place, radius, |j, r| {
            assert_eq!(r, square(j));
            found.push(j);
        });
        found.sort_unstable();
        let expected: Vec<usize> = (0..points.len()).filter(|&j| j != i && square(j) <= radius * radius).collect();
        assert_eq!(found, expected);
    }
}

#[test]
fn nearest_among_equal_distances_and_equal_points() {
    let lattice: Vec<[f64; 2]> = (0..9).flat_map(|i| (0..7).map(move |j| [f64::from(i), f64::from(j)])).collect();
    for count in [0, 1, 3, 4, 6, 62, 63, 100] {
        assert_nearest(&lattice, count);
    }
    for count in [1, 2] {
        assert_nearest(&[], count);
        assert_nearest(&[[1.0, 1.0]], count);
        assert_nearest(&[[1.0, 1.0]; 40], count);
        let line: Vec<[f64; 2]> = (0..50).map(|k| [0.0, f64::from(k * k)]).collect();
        assert_nearest(&line, count);
        // Far apart, and two crowds.
        assert_nearest(&[[0.0, 0.0], [1e12, 0.0], [1e12, 0.5], [0.0, -1e12], [0.3, 0.0]], count);
        assert_nearest(&[[1e-200, 0.0], [-1e-200, 1e-200], [1e150, 3.0]], count);
    }
    assert_eq!(nearest(&[[0.0, f64::NAN]], 1), Err(CellError::Position(0)));
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
        assert_nearest(&points, (radius * 2.0) as usize);
        for factor in [0.3, 1.0, 2.7] {
            assert_up_to(&points, radius, factor * radius);
        }
    }
}

/// The reciprocal of so small a radius is infinite, and so would the number of cells be.
#[test]
fn places_and_radii_near_the_least_numbers_have_cells() {
    for radius in [5e-324, 1e-310] {
        let points = [[0.0, 0.0], [1e-320, 1e-320], [5e-324, 0.0]];
        let list = CellList::new(&points, radius).expect("finite");
        assert_eq!(list.numbers(), [0, 1, 2]);
        // Squares of such numbers are zero.
        assert_eq!(list.pairs(), []);
    }
    assert_eq!(nearest(&[[0.0, 0.0], [1e-320, 0.0], [5e-324, 0.0]], 5).expect("finite"), [[1, 2], [0, 2], [0, 1]]);
}
