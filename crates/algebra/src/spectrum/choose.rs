//! Which method a spectrum is found by.

use super::block::{is_symmetrisable, path_order, single, symmetrised};
use super::closed_form::closed_form;
use super::enclosed::{bits, merged, order};
use super::error::{
    LARGEST_DENSE_ORDER, LARGEST_DIGITS, LARGEST_EXACT_ORDER, LARGEST_GENERAL_ORDER, LARGEST_TRIDIAGONAL_ORDER,
    OUT_OF_RANGE, SpectrumError,
};
use super::exact::Factors;
use super::general::general_spectrum;
use super::symmetric::symmetric_spectrum;
use super::tridiagonal::tridiagonal_spectrum;
use super::{Circulant, Eigenvalue, Method, Spectrum};
use crate::graph::{LaplacianKind, NamedGraph, WeightedGraph};
use crate::matrix::{CharacteristicPolynomial, MatrixError, SparseMatrix};
use arithmetic::{Rational, rational};
use std::collections::{BTreeMap, BTreeSet};

/// Digits where none are asked for and any number is possible.
const USUAL_DIGITS: u32 = 20;

/// Order of the irreducible blocks up to which characteristic polynomials are used without being asked for digits.
const USUAL_EXACT_ORDER: usize = 12;

/// The spectrum of a matrix of a named graph: by a closed form where there is one, otherwise that of the matrix.
///
/// # Errors
/// [`SpectrumError`].
pub fn named_spectrum(graph: &NamedGraph, kind: LaplacianKind, digits: Option<u32>) -> Result<Spectrum, SpectrumError> {
    check(digits)?;
    graph.check()?;
    let Some(form) = closed_form(graph, kind) else {
        return match named_circulant(graph, kind) {
            Some(matrix) => circulant_spectrum(&matrix?, digits),
            None => matrix_spectrum(&graph.build()?.matrix(kind)?, digits),
        };
    };
    let unproved = |_| SpectrumError::Unproved("the closed form could not be evaluated");
    let eigenvalues = form.enclose(digits.unwrap_or(USUAL_DIGITS)).map_err(unproved)?;
    let order = eigenvalues.iter().map(|part| part.multiplicity).sum();
    Ok(Spectrum { order, method: Method::ClosedForm, reason: form.formula, eigenvalues })
}

/// Circulants whose eigenvalues are too many to be told apart exactly.
fn named_circulant(graph: &NamedGraph, kind: LaplacianKind) -> Option<Result<Circulant, SpectrumError>> {
    let NamedGraph::Circulant(order, offsets) = graph else { return None };
    let both: BTreeSet<usize> = offsets.iter().flat_map(|&a| [a, order - a]).collect();
    let degree = rational(both.len() as i64, 1);
    let weight = match kind {
        LaplacianKind::Reduced => return None,
        LaplacianKind::Walk | LaplacianKind::Normalised => degree.recip(),
        _ => rational(1, 1),
    };
    let arcs = both.into_iter().map(move |offset| (offset, weight.clone()));
    Some(match kind {
        LaplacianKind::Adjacency => Circulant::new(*order, arcs),
        _ => Circulant::laplacian(*order, arcs),
    })
}

/// The spectrum of a circulant matrix in floating point with a proved bound.
///
/// # Errors
/// [`SpectrumError`].
pub fn circulant_spectrum(matrix: &Circulant, digits: Option<u32>) -> Result<Spectrum, SpectrumError> {
    check(digits)?;
    let eigenvalues = matrix.eigenvalues()?.enclosures()?;
    let (order, possible) = (matrix.order(), certified_digits(&eigenvalues));
    if let Some(asked) = digits.filter(|&asked| asked > possible) {
        return Err(SpectrumError::TooManyDigits { asked, order, possible });
    }
    let reason = "sums over the offsets or a fast Fourier transform, with an error bound known beforehand".to_string();
    Ok(Spectrum { order, method: Method::Certified, reason, eigenvalues })
}

/// The spectrum of a matrix of a stored graph; the kind `Reduced` leaves out the row and column of the vertex `left_out`, counted
/// from 0. Other kinds do not look at it.
///
/// # Errors
/// [`SpectrumError`].
pub fn graph_spectrum(
    graph: &WeightedGraph,
    kind: LaplacianKind,
    left_out: usize,
    digits: Option<u32>,
) -> Result<Spectrum, SpectrumError> {
    let matrix = if kind == LaplacianKind::Reduced { graph.grounded(left_out)? } else { graph.matrix(kind)? };
    matrix_spectrum(&matrix, digits)
}

/// The spectrum of a matrix, block by irreducible block: exact for small blocks, otherwise in floating point with proved
/// bounds. With `digits`, every enclosure is at most `10^-digits` wide against the largest eigenvalue (exact ones:
/// against their own).
///
/// # Errors
/// [`SpectrumError`].
pub fn matrix_spectrum(matrix: &SparseMatrix, digits: Option<u32>) -> Result<Spectrum, SpectrumError> {
    check(digits)?;
    if matrix.order() == 0 {
        return Err(MatrixError::Empty.into());
    }
    let mut singles: BTreeMap<Rational, usize> = BTreeMap::new();
    let mut blocks = Vec::new();
    for members in matrix.strong_components() {
        let block = matrix.principal(&members);
        match single(&block) {
            Some(value) => *singles.entry(value).or_default() += 1,
            None => blocks.push(block),
        }
    }
    let limit = if digits.is_some() { LARGEST_EXACT_ORDER } else { USUAL_EXACT_ORDER };
    let exact = if blocks.iter().all(|block| block.order() <= limit) {
        exact_blocks(&blocks, digits.unwrap_or(USUAL_DIGITS))?
    } else {
        None
    };
    let (method, parts, reason) = match exact {
        Some(parts) => (Method::Exact, parts, EXACT_REASON),
        None => (Method::Certified, certified_blocks(&blocks, digits)?, CERTIFIED_REASON),
    };
    let eigenvalues = with_singles(parts, singles, bits(digits.unwrap_or(USUAL_DIGITS)) + 8);
    let eigenvalues = if method == Method::Certified { merged(eigenvalues) } else { eigenvalues };
    Ok(Spectrum { order: matrix.order(), method, reason: reason.to_string(), eigenvalues })
}

const EXACT_REASON: &str =
    "characteristic polynomials of the irreducible blocks, roots isolated by Sturm's theorem or discs of Smith";

const CERTIFIED_REASON: &str =
    "floating point with residual bounds on irreducible blocks (Weyl and Ostrowski, Sturm counts, or Gershgorin)";

fn check(digits: Option<u32>) -> Result<(), SpectrumError> {
    match digits {
        Some(digits) if digits == 0 || digits > LARGEST_DIGITS => Err(SpectrumError::Digits(digits)),
        _ => Ok(()),
    }
}

fn exact_blocks(blocks: &[SparseMatrix], digits: u32) -> Result<Option<Vec<Eigenvalue>>, SpectrumError> {
    // Many blocks are often few different ones.
    let mut places = BTreeMap::new();
    let mut different: Vec<(CharacteristicPolynomial, usize)> = Vec::new();
    for block in blocks {
        let polynomial = block.to_dense()?.characteristic_polynomial()?;
        let place = *places.entry(polynomial.coefficients()).or_insert(different.len());
        match different.get_mut(place) {
            Some((_, count)) => *count += 1,
            None => different.push((polynomial, 1)),
        }
    }
    let mut factors = Factors::default();
    different.iter().for_each(|(polynomial, count)| factors.multiply(polynomial, *count));
    Ok(factors.roots(digits))
}

/// Adds the eigenvalues of the blocks of order one; equal rationals become one.
fn with_singles(parts: Vec<Eigenvalue>, singles: BTreeMap<Rational, usize>, precision: u32) -> Vec<Eigenvalue> {
    let mut rationals = singles;
    let mut all = Vec::with_capacity(parts.len() + rationals.len());
    for part in parts {
        match part.exact {
            Some(value) => *rationals.entry(value).or_default() += part.multiplicity,
            None => all.push(part),
        }
    }
    all.extend(rationals.into_iter().map(|(value, times)| Eigenvalue::rational(value, times, precision)));
    all.sort_by(order);
    all
}

fn certified_blocks(blocks: &[SparseMatrix], digits: Option<u32>) -> Result<Vec<Eigenvalue>, SpectrumError> {
    let mut parts = Vec::new();
    for block in blocks {
        let found = certified(block)?;
        let possible = certified_digits(&found);
        if let Some(asked) = digits.filter(|&asked| asked > possible) {
            let order = blocks.iter().map(SparseMatrix::order).max().unwrap_or(0);
            return Err(if order > LARGEST_EXACT_ORDER {
                SpectrumError::TooManyDigits { asked, order, possible }
            } else {
                SpectrumError::NotIsolated { asked, possible }
            });
        }
        parts.extend(found);
    }
    Ok(parts)
}

/// Floating-point enclosures of the eigenvalues of an irreducible block.
fn certified(block: &SparseMatrix) -> Result<Vec<Eigenvalue>, SpectrumError> {
    let order = block.order();
    let symmetrisable = is_symmetrisable(block);
    if symmetrisable && let Some(path) = path_order(block) {
        if order > LARGEST_TRIDIAGONAL_ORDER {
            return Err(SpectrumError::TooLarge { order, most: LARGEST_TRIDIAGONAL_ORDER });
        }
        return tridiagonal_spectrum(block, &path);
    }
    let most = if symmetrisable { LARGEST_DENSE_ORDER } else { LARGEST_GENERAL_ORDER };
    if order > most {
        return Err(SpectrumError::TooLarge { order, most });
    }
    if symmetrisable { similar_to_symmetric(block, block.is_symmetric()) } else { general_spectrum(block) }
}

/// Floating-point enclosures of the eigenvalues of a symmetric matrix; overlapping ones come as one, with their number.
///
/// # Errors
/// [`SpectrumError::Unproved`].
pub fn symmetric_enclosures(matrix: &SparseMatrix) -> Result<Vec<Eigenvalue>, SpectrumError> {
    if !matrix.is_symmetric() {
        return Err(SpectrumError::Unproved("the matrix is not symmetric"));
    }
    similar_to_symmetric(matrix, true)
}

fn similar_to_symmetric(matrix: &SparseMatrix, is_symmetric: bool) -> Result<Vec<Eigenvalue>, SpectrumError> {
    let floats = symmetrised(matrix, is_symmetric).ok_or(OUT_OF_RANGE)?;
    symmetric_spectrum(&floats)
        .ok_or(SpectrumError::Unproved("the reduction to a tridiagonal matrix is too inaccurate"))
}

/// Digits that the widest enclosure settles against the largest eigenvalue.
fn certified_digits(parts: &[Eigenvalue]) -> u32 {
    let sizes = parts.iter().flat_map(|part| [&part.re, &part.im]).map(|x| x.magnitude().to_f64());
    let size = sizes.fold(0.0, f64::max);
    let widths = parts.iter().flat_map(|part| [&part.re, &part.im]).map(|x| x.width().to_f64());
    let width = widths.fold(0.0, f64::max);
    if width == 0.0 { LARGEST_DIGITS } else { (size / width).log10().floor().max(0.0) as u32 }
}
