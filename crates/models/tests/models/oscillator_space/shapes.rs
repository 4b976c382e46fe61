//! Nearest neighbours that are certain, directions of shapes, stability of matrices with known eigenvalues.

use arithmetic::{ArithmeticError, Complex, Interval, Rational, Ring, rational};
use models::oscillator::{Neighbours, Stability, State, phasor, shape_dimension, stability};

fn places(list: &[(i64, i64)]) -> Vec<Complex<Rational>> {
    list.iter().map(|&(x, y)| Complex::new(rational(x, 1), rational(y, 1))).collect()
}

fn nearest(list: &[(i64, i64)], count: usize) -> Option<Vec<(usize, usize)>> {
    Neighbours::nearest_without_ties(&places(list), count).map(|network| network.arcs().collect())
}

#[test]
fn nearest_neighbours_without_ties() {
    let row = [(0, 0), (1, 0), (3, 0), (7, 0)];
    assert_eq!(nearest(&row, 1), Some(vec![(0, 1), (1, 0), (2, 1), (3, 2)]));
    let two = vec![(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1), (3, 1), (3, 2)];
    assert_eq!(nearest(&row, 2), Some(two));
    // The one in the middle has both others at distance 1.
    let even = [(0, 0), (1, 0), (2, 0)];
    assert_eq!(nearest(&even, 1), None);
    assert_eq!(nearest(&even, 2).map(|arcs| arcs.len()), Some(6), "everyone, tied or not");
    // Two at distance 3 of the first, which does not matter for its nearest.
    let cross = [(0, 0), (1, 0), (0, 3), (0, -3)];
    assert_eq!(nearest(&cross, 1), Some(vec![(0, 1), (1, 0), (2, 0), (3, 0)]));
    assert_eq!(nearest(&cross, 2), None);
}

#[test]
fn nearest_neighbours_that_are_not_certain() {
    let between = |lo: i64, hi: i64| {
        let x = Interval::hull_of_rationals(&rational(lo, 1), &rational(hi, 1), 60);
        Complex::new(x.clone(), x.integer(0))
    };
    let found = |far: i64| Neighbours::nearest_without_ties(&[between(0, 0), between(1, 3), between(far, far)], 1);
    assert_eq!(found(-2), None, "at distance 1 to 3, and 2");
    let certain = found(-4).map(|network| network.arcs().collect::<Vec<_>>());
    assert_eq!(certain, Some(vec![(0, 1), (1, 0), (2, 0)]));
}

/// Only the translations and the rotation keep a shape, which are three directions also where particles or phases coincide.
#[test]
fn shapes_change_in_all_directions_but_three() {
    let of = |list: &[(i64, i64)], turns: &[i64]| {
        let phasors = turns.iter().map(|&t| phasor(&rational(t, 1)).unwrap()).collect();
        shape_dimension(&State { positions: places(list), phasors })
    };
    assert_eq!(of(&[(5, -2)], &[3]), Ok(0));
    assert_eq!(of(&[(0, 0), (4, 1)], &[0, 2]), Ok(3));
    assert_eq!(of(&[(1, 1), (1, 1)], &[2, 2]), Ok(3));
    assert_eq!(of(&[(0, 0), (1, 0), (2, 0)], &[0, 0, 1]), Ok(6));
    assert_eq!(of(&[], &[]), Err(ArithmeticError::Domain("at least one particle")));
}

/// A matrix of blocks on the diagonal.
fn blocks(list: &[&[&[Rational]]]) -> Vec<Vec<Rational>> {
    let order = list.iter().map(|block| block.len()).sum();
    let mut rows = Vec::new();
    for block in list {
        let start = rows.len();
        for row in *block {
            let mut whole = vec![rational(0, 1); order];
            whole[start..start + row.len()].clone_from_slice(row);
            rows.push(whole);
        }
    }
    rows
}

#[test]
fn stability_of_known_eigenvalues() {
    let q = |x: i64| rational(x, 1);
    // ± 2 i, twice 0 in one chain, and a number or -1 ± i or 1 ± i.
    let turning: &[&[Rational]] = &[&[q(0), q(-2)], &[q(2), q(0)]];
    let zeros: &[&[Rational]] = &[&[q(0), q(1)], &[q(0), q(0)]];
    let spiral = |rate: i64| [[q(rate), q(-1)], [q(1), q(rate)]];
    let of = |block: &[&[Rational]], omega: i64, translations| {
        stability(&blocks(&[turning, zeros, block]), &q(omega), translations)
    };
    let is = |stable, positive| Ok::<_, ArithmeticError>(Stability { zeros: 2, stable, positive });
    assert_eq!(of(&[&[rational(-1, 9)]], 2, true), is(true, false));
    assert_eq!(of(&[&[rational(-1, 9)]], -2, true), is(true, false), "either sense of rotation");
    assert_eq!(of(&[&[rational(-1, 9)]], 2, false), is(false, false), "± 2 i are no symmetries");
    for positive in [rational(1, 1000), rational(1000, 1)] {
        assert_eq!(of(&[&[positive]], 2, true), is(false, true));
    }
    let [[a, b], [c, d]] = spiral(-1);
    assert_eq!(of(&[&[a, b], &[c, d]], 2, true), is(true, false));
    let [[a, b], [c, d]] = spiral(1);
    assert_eq!(of(&[&[a, b], &[c, d]], 2, true), is(false, false), "unstable without a positive eigenvalue");
    assert_eq!(of(turning, 2, true), is(false, false), "once only");
    let other = Err(ArithmeticError::Domain("a law that is invariant under translations"));
    assert_eq!(of(&[&[q(-1)]], 3, true), other);
    assert_eq!(stability(&[vec![q(1), q(0)]], &q(2), false), Err(ArithmeticError::Domain("a square matrix")));
}
