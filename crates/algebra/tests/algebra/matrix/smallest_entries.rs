//! The smallest entries of all products against products made one by one.

use algebra::matrix::{MatrixError, RationalMatrix, smallest_entries};
use arithmetic::{Rational, rational};
use num_traits::Zero;

fn set() -> Vec<RationalMatrix> {
    [[[1, 1, 0], [1, 1, 0], [0, 0, 2]], [[2, 0, 0], [0, 1, 1], [0, 1, 1]], [[1, 1, 0], [0, 1, 1], [1, 0, 1]]]
        .iter()
        .zip([2, 2, 2])
        .map(|(rows, denominator)| RationalMatrix::from_integers(rows, denominator).expect("a filled shape"))
        .collect()
}

fn product(set: &[RationalMatrix], factors: &[usize]) -> RationalMatrix {
    let later = factors[1..].iter().map(|&k| &set[k]);
    later.fold(set[factors[0]].clone(), |done, next| next.times(&done).expect("square matrices of one order"))
}

fn least(matrix: &RationalMatrix) -> Option<Rational> {
    matrix.to_rows().iter().map(|row| row[0].clone()).filter(|x| !x.is_zero()).min()
}

#[test]
fn smallest_entries_are_those_of_the_products_made_one_by_one() {
    let set = set();
    let (entries, count) = smallest_entries(&set, 4).expect("short products");
    assert_eq!(count, 3 + 9 + 27 + 81);
    for (length, found) in (1..=4).zip(&entries) {
        let words = (0..3usize.pow(length)).map(|w| (0..length).map(|k| w / 3usize.pow(k) % 3).collect::<Vec<_>>());
        assert_eq!(found.entry, words.filter_map(|word| least(&product(&set, &word))).min());
        assert_eq!(found.entry, least(&product(&set, &found.factors)), "the factors that are named");
        assert_eq!(found.factors.len(), length as usize);
    }
}

#[test]
fn a_zero_column_has_no_entry_and_what_does_not_fit_is_refused() {
    let shift = RationalMatrix::from_integers(&[[0, 1], [0, 0]], 1).expect("a filled shape");
    let (entries, count) = smallest_entries(&[shift], 2).expect("short products");
    assert_eq!((entries[0].entry.clone(), entries[1].entry.clone(), count), (None, None, 2));
    assert!(matches!(smallest_entries(&set(), 128), Err(MatrixError::TooLong)));
    let negative = RationalMatrix::from_rows(&[vec![rational(-1, 1)]]).expect("a filled shape");
    assert!(matches!(smallest_entries(&[negative], 1), Err(MatrixError::TooLong)));
    let other = RationalMatrix::from_integers(&[[1]], 1).expect("a filled shape");
    assert!(matches!(smallest_entries(&[set()[0].clone(), other], 1), Err(MatrixError::DifferentShapes { .. })));
    assert_eq!(smallest_entries(&[], 2).expect("no products").1, 0);
}
