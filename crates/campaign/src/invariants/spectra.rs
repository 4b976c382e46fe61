//! Spectra against characteristic polynomials.

use super::{Checked, Invariant, OrFails, Stop, Tested, require, shown};
use crate::draws::Draws;
use crate::strategies::{graph, symmetric};
use algebra::graph::Graph;
use algebra::matrix::{RationalMatrix, SparseMatrix, inertia};
use algebra::spectrum::{Circulant, Eigenvalue, matrix_spectrum, symmetric_enclosures};
use arithmetic::rational;

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "spectrum.exact",
        statement: "Every enclosure of Laplacian eigenvalues holds as many roots of the characteristic polynomial as its multiplicity says, \
                    and all of them together hold all roots.",
        control: "the characteristic polynomial of the graph with its first pair toggled",
        block: 20,
        check: exact,
    },
    Invariant {
        id: "spectrum.certified",
        statement: "The same for enclosures from floating point with proved bounds, for symmetric rational matrices.",
        control: "the characteristic polynomial of the matrix plus 2^-20 in its first entry",
        block: 20,
        check: certified,
    },
    Invariant {
        id: "spectrum.circulant",
        statement: "The same for symmetric circulant matrices from their Fourier transform.",
        control: "the characteristic polynomial of the matrix plus 2^-20 in its first entry",
        block: 20,
        check: circulant,
    },
    Invariant {
        id: "matrix.inertia",
        statement: "The inertia of a symmetric matrix by congruences counts the signs of the roots of its characteristic polynomial.",
        control: "the inertia of the negative matrix",
        block: 50,
        check: signs,
    },
];

/// Whether enclosures hold the eigenvalues of a matrix whose eigenvalues are all real.
fn holds_all(enclosures: &[Eigenvalue], matrix: &RationalMatrix, described: &dyn Fn() -> String) -> Result<(), Stop> {
    let polynomial = matrix.characteristic_polynomial().or_fails("the characteristic polynomial is refused")?;
    let order = polynomial.degree();
    let told: usize = enclosures.iter().map(|part| part.multiplicity).sum();
    require(told == order, format!("{told} eigenvalues are told of a matrix of order {order}"), described)?;
    for part in enclosures {
        let (lo, hi) = part.re.to_rationals();
        let inside = order - polynomial.count_above(&hi) - polynomial.count_below(&lo);
        let why = format!("[{lo}, {hi}] holds {inside} roots, not {}", part.multiplicity);
        require(inside == part.multiplicity, why, described)?;
        require(part.im.contains_zero(), "a real eigenvalue has an imaginary part", described)?;
        if let Some(value) = &part.exact {
            let times = polynomial.multiplicity(value);
            require(times == part.multiplicity, format!("{value} is a root {times} times"), described)?;
        }
    }
    Ok(())
}

fn exact(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(2, 7);
    let graph = graph(draws, order);
    let digits = draws.between(5, 40) as u32;
    let described = || format!("order {order}, edges {:?}, {digits} digits", graph.edges());
    let laplacian = graph.laplacian().or_fails("the Laplacian is refused")?;
    let sparse = SparseMatrix::from_dense(&laplacian).or_fails("the Laplacian is refused")?;
    let found = matrix_spectrum(&sparse, Some(digits)).or_fails("the spectrum is refused")?;
    let other = Graph::from_fn(order, |i, j| graph.has_edge(i, j) != (tested.is_altered() && (i, j) == (0, 1)));
    let other = other.laplacian().or_fails("the Laplacian is refused")?;
    holds_all(&found.eigenvalues, &other, &described)?;
    Ok(None)
}

/// The matrix, or the matrix of the control.
fn altered(matrix: &RationalMatrix, tested: Tested) -> Result<RationalMatrix, Stop> {
    let mut rows = matrix.to_rows();
    if tested.is_altered() {
        rows[0][0] += rational(1, 1 << 20);
    }
    RationalMatrix::from_rows(&rows).or_fails("a matrix is refused")
}

fn certified(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 7);
    let matrix = symmetric(draws, order).or_fails("a matrix is refused")?;
    let described = || format!("rows {}", shown(matrix.to_rows().iter().map(shown)));
    let sparse = SparseMatrix::from_dense(&matrix).or_fails("a matrix is refused")?;
    let found = symmetric_enclosures(&sparse).or_fails("the spectrum is refused")?;
    holds_all(&found, &altered(&matrix, tested)?, &described)?;
    Ok(None)
}

fn circulant(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(3, 9);
    let half: Vec<i64> = (0..=order / 2).map(|_| draws.below(9) as i64 - 4).collect();
    let entry = |offset: usize| rational(half[offset.min(order - offset)], 3);
    let described = || format!("first row {}", shown((0..order).map(entry)));
    let rows: Vec<Vec<_>> = (0..order).map(|i| (0..order).map(|j| entry((j + order - i) % order)).collect()).collect();
    let matrix = RationalMatrix::from_rows(&rows).or_fails("a matrix is refused")?;
    let circulant = Circulant::new(order, (0..order).map(|k| (k, entry(k)))).or_fails("a circulant is refused")?;
    let found = circulant.eigenvalues().and_then(|spectrum| spectrum.enclosures()).or_fails("it has no spectrum")?;
    holds_all(&found, &altered(&matrix, tested)?, &described)?;
    Ok(None)
}

fn signs(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 6);
    let matrix = symmetric(draws, order).or_fails("a matrix is refused")?;
    let polynomial = matrix.characteristic_polynomial().or_fails("the characteristic polynomial is refused")?;
    let zero = rational(0, 1);
    let factor = rational(if tested.is_altered() { -1 } else { 1 }, 1);
    let found = inertia(&matrix.scaled(&factor).to_rows()).or_fails("the inertia is refused")?;
    let expected = (polynomial.count_above(&zero), polynomial.count_below(&zero), polynomial.multiplicity(&zero));
    let why = format!("{found:?}, but the roots have the signs {expected:?}");
    require((found.positive, found.negative, found.zero) == expected, why, || {
        format!("rows {}", shown(matrix.to_rows().iter().map(shown)))
    })?;
    Ok(None)
}
