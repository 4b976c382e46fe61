//! Signs of eigenvalues against the characteristic polynomial.

use algebra::matrix::{Inertia, RationalMatrix, inertia};
use arithmetic::{Interval, Rational, rational};

fn naive(rows: &[Vec<Rational>]) -> Inertia {
    let polynomial = RationalMatrix::from_rows(rows).and_then(|a| a.characteristic_polynomial()).expect("square");
    let zero = rational(0, 1);
    Inertia {
        positive: polynomial.count_above(&zero),
        negative: polynomial.count_below(&zero),
        zero: polynomial.multiplicity(&zero),
    }
}

fn symmetric(order: usize, entry: impl Fn(usize) -> i64) -> Vec<Vec<Rational>> {
    let place = |i: usize, j: usize| i.max(j) * (i.max(j) + 1) / 2 + i.min(j);
    (0..order).map(|i| (0..order).map(|j| rational(entry(place(i, j)), 1)).collect()).collect()
}

#[test]
fn all_small_matrices_and_some_larger_ones() {
    for code in 0..729usize {
        let rows = symmetric(3, |k| (code / 3usize.pow(k as u32) % 3) as i64 - 1);
        assert_eq!(inertia(&rows), Ok(naive(&rows)), "{rows:?}");
    }
    for seed in 0..200usize {
        // Mostly zeros on the diagonal.
        let rows = symmetric(5, |k| ((k * k * 31 + seed * (2 * k + 7)) % 7) as i64 - 3);
        let hollow: Vec<Vec<Rational>> = (0..5)
            .map(|i| {
                (0..5).map(|j| if i == j && i != seed % 9 { rational(0, 1) } else { rows[i][j].clone() }).collect()
            })
            .collect();
        for rows in [rows, hollow] {
            assert_eq!(inertia(&rows), Ok(naive(&rows)), "{rows:?}");
            // What is above the diagonal is not read.
            let lower: Vec<Vec<Rational>> = rows.iter().enumerate().map(|(i, row)| row[..=i].to_vec()).collect();
            assert_eq!(inertia(&lower), inertia(&rows));
        }
    }
    assert_eq!(inertia::<Rational>(&[]), Ok(Inertia { positive: 0, negative: 0, zero: 0 }));
}

#[test]
fn signs_of_intervals_have_to_be_certain() {
    let between = |lo: i64, hi: i64| Interval::hull_of_rationals(&rational(lo, 1), &rational(hi, 1), 64);
    let point = |x: i64| between(x, x);
    let certain = [vec![between(2, 3)], vec![between(-1, 1), between(-9, -8)]];
    assert_eq!(inertia(&certain), Ok(Inertia { positive: 1, negative: 1, zero: 0 }));
    assert!(inertia(&[vec![between(-1, 1)]]).is_err());
    assert!(inertia(&[vec![point(0)], vec![between(-1, 1), point(0)]]).is_err());
    assert_eq!(inertia(&[vec![point(0)], vec![point(5), point(0)]]), Ok(Inertia { positive: 1, negative: 1, zero: 0 }));
}
