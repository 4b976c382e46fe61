//! Matrices of few entries against dense ones.

use super::rational_matrix;
use algebra::matrix::{MatrixError, RationalMatrix, SparseMatrix};
use arithmetic::{Rational, rational};
use num_traits::Zero;
use proptest::prelude::*;

type Entry = (usize, usize, i64);

fn of(order: usize, entries: &[Entry]) -> SparseMatrix {
    SparseMatrix::from_entries(order, entries.iter().map(|&(i, j, x)| (i, j, rational(x, 1))))
}

fn entries_of(matrix: &SparseMatrix) -> Vec<(usize, usize, Rational)> {
    matrix.entries().map(|(i, j, x)| (i, j, x.clone())).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Places inside and outside, in any order, many of them twice, with sums that may vanish.
    #[test]
    fn entries_are_summed(order in 0usize..6, entries in prop::collection::vec((0usize..7, 0usize..7, -2i64..3), 0..30)) {
        let matrix = of(order, &entries);
        prop_assert_eq!(matrix.order(), order);
        let sum = |i: usize, j: usize| entries.iter().filter(|e| (e.0, e.1) == (i, j)).map(|e| e.2).sum::<i64>();
        let places = (0..order).flat_map(|i| (0..order).map(move |j| (i, j)));
        let naive: Vec<_> = places.map(|(i, j)| (i, j, rational(sum(i, j), 1))).filter(|e| !e.2.is_zero()).collect();
        prop_assert_eq!(&entries_of(&matrix), &naive);
        for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))) {
            let there = naive.iter().find(|e| (e.0, e.1) == (i, j)).map(|e| &e.2);
            prop_assert_eq!(matrix.get(i, j), there);
        }
        for i in 0..8 {
            let row: Vec<_> = naive.iter().filter(|e| e.0 == i).map(|e| (e.1, e.2.clone())).collect();
            prop_assert_eq!(matrix.row(i), row.as_slice());
        }
        let sums: Vec<Rational> = (0..order).map(|i| naive.iter().filter(|e| e.0 == i).map(|e| &e.2).sum()).collect();
        prop_assert_eq!(matrix.row_sums(), sums);
    }

    #[test]
    fn dense_matrices_come_back(a in (1usize..6).prop_flat_map(|n| rational_matrix(n, n)), kept in prop::collection::vec(0usize..7, 0..5)) {
        let sparse = SparseMatrix::from_dense(&a).unwrap();
        prop_assert_eq!(sparse.to_dense().unwrap(), a.clone());
        prop_assert_eq!(sparse.transpose().to_dense().unwrap(), a.transpose());
        prop_assert_eq!(sparse.is_symmetric(), a == a.transpose());
        // Different names, some of which are not there.
        let mut kept = kept;
        kept.sort_unstable();
        kept.dedup();
        let half = kept.len() / 2;
        kept.rotate_left(half);
        let part = sparse.principal(&kept);
        prop_assert_eq!(part.order(), kept.len());
        for (i, j) in (0..kept.len()).flat_map(|i| (0..kept.len()).map(move |j| (i, j))) {
            prop_assert_eq!(part.get(i, j).cloned().unwrap_or_default(), a.entry(kept[i], kept[j]));
        }
    }
}

#[test]
fn shapes_that_are_refused() {
    let flat = RationalMatrix::from_integers(&[[1, 2]], 1).expect("filled");
    assert_eq!(SparseMatrix::from_dense(&flat), Err(MatrixError::NotSquare { rows: 1, cols: 2 }));
    assert_eq!(of(0, &[]).to_dense(), Err(MatrixError::Empty));
    assert!(of(0, &[]).is_symmetric() && of(0, &[]).strong_components().is_empty());
}
