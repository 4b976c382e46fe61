//! Eigenvalues of the matrices of a graph, one after the other.

use crate::error::Problem;
use crate::failure::Failure;
use algebra::graph::{AnyGraph, Graph, LaplacianKind};
use algebra::matrix::SparseMatrix;
use algebra::spectrum::{
    Eigenvalue, FloatEnclosure, LARGEST_DIGITS, matrix_spectrum, named_spectrum, small_symmetric_eigenvalues,
    symmetric_enclosures,
};
use arithmetic::{Algebraic, RealNumber as Number};
use arithmetic::{Dyadic, Interval, Rational, common_denominator};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

/// One matrix of a graph with what has been found out about its eigenvalues.
pub(super) struct Spectra {
    graph: Arc<AnyGraph>,
    kind: LaplacianKind,
    matrix: OnceCell<Result<SparseMatrix, String>>,
    floats: OnceCell<Option<Vec<Place>>>,
    small: OnceCell<Option<Vec<FloatEnclosure>>>,
    exact: RefCell<Option<(u32, Vec<Place>)>>,
}

/// One eigenvalue in order.
#[derive(Clone)]
struct Place {
    enclosure: Interval,
    exact: Option<Rational>,
}

/// Bits up to which floating-point enclosures are tried first.
const FLOAT_BITS: u32 = 64;

/// Largest order of a graph whose eigenvalues are found by rotations.
const LARGEST_SMALL: usize = 12;

impl Spectra {
    pub fn new(graph: Arc<AnyGraph>, kind: LaplacianKind) -> Self {
        Spectra {
            graph,
            kind,
            matrix: OnceCell::new(),
            floats: OnceCell::new(),
            small: OnceCell::new(),
            exact: RefCell::new(None),
        }
    }

    /// Number of eigenvalues.
    pub fn order(&self) -> usize {
        self.graph.order() - usize::from(self.kind == LaplacianKind::Reduced)
    }

    /// The k-th smallest eigenvalue, from 1; there are [`Spectra::order`].
    pub fn eigenvalue(&self, k: usize, precision: u32) -> Result<Number, Failure> {
        if precision <= FLOAT_BITS
            && let Some(number) = self.small_eigenvalue(k)
        {
            return Ok(number);
        }
        let matrix = self.matrix()?;
        if precision <= FLOAT_BITS
            && let Some(places) = self.floats(matrix)
            && let Some(place) = places.get(k - 1)
        {
            return Ok(number(place, matrix));
        }
        self.refine(matrix, precision)?;
        match self.exact.borrow().as_ref().and_then(|(_, places)| places.get(k - 1)) {
            Some(place) => Ok(number(place, matrix)),
            None => Err(Failure::open("an eigenvalue could not be enclosed", None)),
        }
    }

    /// The k-th eigenvalue of a symmetric matrix of a small graph, of which families have thousands.
    fn small_eigenvalue(&self, k: usize) -> Option<Number> {
        let AnyGraph::Simple(graph) = self.graph.as_ref() else { return None };
        if graph.order() > LARGEST_SMALL || self.order() == 0 {
            return None;
        }
        let found = self.small.get_or_init(|| small_spectrum(graph, self.kind));
        let place = found.as_ref()?.get(k - 1)?;
        let [lo, hi] = [(place.re - place.radius).next_down(), (place.re + place.radius).next_up()];
        let enclosure = Interval::between(Dyadic::from_f64(lo)?, Dyadic::from_f64(hi)?, FLOAT_BITS);
        let bounds = match self.kind {
            LaplacianKind::Normalised | LaplacianKind::Walk => bounds(self.matrix().ok()?),
            // The matrix has integers, and no sum of sizes in a row is above twice the largest degree.
            _ => {
                let largest = BigInt::from(2 * (0..graph.order()).map(|i| graph.degree(i)).max().unwrap_or(0));
                Algebraic { degree: self.order() as u64, upper: largest.bits(), lower: 0 }
            }
        };
        Some(Number::Enclosed(enclosure, Some(bounds)))
    }

    /// The sum of these powers of all eigenvalues: the trace of the power of the matrix. Of higher powers only where all eigenvalues are known to be real.
    pub fn power_sum(&self, power: u32) -> Option<Rational> {
        const MOST: u32 = 8;
        let matrix = self.matrix().ok()?;
        if power == 0 || power > MOST || power > 1 && !matrix.is_symmetric() {
            return None;
        }
        let row = |i: usize| {
            let mut row = vec![Rational::zero(); matrix.order()];
            row[i] = Rational::one();
            // The row of the power.
            for _ in 0..power {
                let mut next = vec![Rational::zero(); matrix.order()];
                for (k, x) in row.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
                    matrix.row(k).iter().for_each(|(j, entry)| next[*j] += x * entry);
                }
                row = next;
            }
            row.swap_remove(i)
        };
        Some((0..matrix.order()).map(row).sum())
    }

    fn matrix(&self) -> Result<&SparseMatrix, Failure> {
        let found = self.matrix.get_or_init(|| self.graph.weighted().matrix(self.kind).map_err(|e| e.to_string()));
        found.as_ref().map_err(|error| Failure::Refused(0, Problem::Other(error.clone())))
    }

    /// Enclosures in floating point, with proved bounds, of symmetric matrices.
    fn floats(&self, matrix: &SparseMatrix) -> Option<&[Place]> {
        let found = self.floats.get_or_init(|| symmetric_enclosures(matrix).ok().map(|parts| in_order(&parts)));
        found.as_deref()
    }

    /// Encloses the eigenvalues at so many bits, from closed forms or characteristic polynomials where there are such.
    fn refine(&self, matrix: &SparseMatrix, precision: u32) -> Result<(), Failure> {
        if self.exact.borrow().as_ref().is_some_and(|(bits, _)| *bits >= precision) {
            return Ok(());
        }
        let parts = eigenvalues(precision, &|digits| match self.graph.as_ref() {
            AnyGraph::Named(name, _) => named_spectrum(name, self.kind, digits).map(|found| found.eigenvalues),
            _ => matrix_spectrum(matrix, digits).map(|found| found.eigenvalues),
        })?;
        *self.exact.borrow_mut() = Some((precision, in_order(&parts)));
        Ok(())
    }
}

/// The eigenvalues at so many bits; where digits cannot be had, what floating point gives.
fn eigenvalues<E: std::fmt::Display>(
    precision: u32,
    find: &dyn Fn(Option<u32>) -> Result<Vec<Eigenvalue>, E>,
) -> Result<Vec<Eigenvalue>, Failure> {
    let digits = (f64::from(precision) * std::f64::consts::LOG10_2).ceil() as u32 + 1;
    if digits > LARGEST_DIGITS {
        let why = format!("it would take eigenvalues to more than {LARGEST_DIGITS} digits");
        return Err(Failure::open(why, None));
    }
    find(Some(digits))
        .or_else(|error| if precision <= FLOAT_BITS { find(None) } else { Err(error) })
        .map_err(|error| Failure::open(error.to_string(), None))
}

/// The second largest modulus of the eigenvalues of a stochastic matrix, counted with multiplicity; 0 of order 1.
pub(crate) fn second_modulus(matrix: &SparseMatrix, precision: u32) -> Result<Number, Failure> {
    let order = matrix.order();
    if order < 2 {
        return Ok(Number::integer(0));
    }
    let parts = eigenvalues(precision, &|digits| matrix_spectrum(matrix, digits).map(|found| found.eigenvalues))?;
    let modulus = |part: Eigenvalue| {
        let re = Number::interval(part.re.clone());
        let size = if part.is_real() {
            re.absolute(precision)
        } else {
            let im = Number::interval(part.im.clone());
            let square = re.times(&re, precision).plus(&im.times(&im, precision), precision).absolute(precision);
            square.sqrt(precision).map_err(|_| Failure::open("a modulus could not be enclosed", None))?
        };
        Ok(Eigenvalue { re: size.enclosure(precision), exact: part.exact.as_ref().map(Signed::abs), ..part })
    };
    let sizes = parts.into_iter().map(modulus).collect::<Result<Vec<Eigenvalue>, Failure>>()?;
    let places = in_order(&sizes);
    let place = places.get(order - 2).ok_or_else(|| Failure::open("a modulus could not be enclosed", None))?;
    Ok(match &place.exact {
        Some(q) => Number::Exact(q.clone()),
        // The root of the product of two conjugates, each in a field of degree at most `order`.
        None => {
            let own = bounds(matrix);
            let degree = 2 * (order as u64).saturating_mul(order as u64);
            Number::Enclosed(
                place.enclosure.clone(),
                Some(Algebraic { degree, upper: own.upper + 1, lower: own.lower }),
            )
        }
    })
}

/// All eigenvalues of a matrix of the graph in floating point, with proved bounds.
fn small_spectrum(graph: &Graph, kind: LaplacianKind) -> Option<Vec<FloatEnclosure>> {
    let skipped = usize::from(kind == LaplacianKind::Reduced);
    let order = graph.order() - skipped;
    let is_joined = |i: usize, j: usize| f64::from(u8::from(graph.has_edge(i, j)));
    let entry = |i: usize, j: usize| match kind {
        LaplacianKind::Adjacency => is_joined(i, j),
        LaplacianKind::Normalised | LaplacianKind::Walk if i == j => f64::from(u8::from(graph.degree(i) > 0)),
        // Similar to the walk's: D^1/2 (I - D^-1 A) D^-1/2.
        LaplacianKind::Normalised | LaplacianKind::Walk => {
            if graph.has_edge(i, j) {
                -1.0 / ((graph.degree(i) * graph.degree(j)) as f64).sqrt()
            } else {
                0.0
            }
        }
        _ if i == j => graph.degree(i) as f64,
        _ => -is_joined(i, j),
    };
    let entries: Vec<f64> =
        (0..order * order).map(|place| entry(place / order + skipped, place % order + skipped)).collect();
    let mut found = small_symmetric_eigenvalues(&entries, order)?;
    if matches!(kind, LaplacianKind::Normalised | LaplacianKind::Walk) {
        // Root and quotient are rounded once each, so that an entry of size at most 1 is off by less than 2^-51, and by Weyl's inequality no eigenvalue by
        // more than the sum of a row.
        let rounding = order as f64 * 2f64.powi(-51);
        found.iter_mut().for_each(|place| place.radius = (place.radius + rounding).next_up());
    }
    Some(found)
}

fn number(place: &Place, matrix: &SparseMatrix) -> Number {
    match &place.exact {
        Some(q) => Number::Exact(q.clone()),
        None => Number::Enclosed(place.enclosure.clone(), Some(bounds(matrix))),
    }
}

/// The real parts in order. The k-th smallest of numbers in given intervals lies between the k-th smallest lower end and the k-th smallest
/// upper end.
fn in_order(parts: &[Eigenvalue]) -> Vec<Place> {
    let listed: Vec<&Eigenvalue> = parts.iter().flat_map(|part| std::iter::repeat_n(part, part.multiplicity)).collect();
    let mut lower: Vec<&Dyadic> = listed.iter().map(|part| part.re.lo()).collect();
    let mut upper: Vec<&Dyadic> = listed.iter().map(|part| part.re.hi()).collect();
    lower.sort();
    upper.sort();
    let mut sorted = listed.clone();
    sorted.sort_by(|a, b| a.re.lo().cmp(b.re.lo()).then_with(|| a.re.hi().cmp(b.re.hi())));
    let place = |k: usize| {
        let (lo, hi) = (lower[k], upper[k]);
        let own = sorted[k];
        let alone = own.re.lo() == lo && own.re.hi() == hi;
        // Only where nothing else overlaps it is the k-th one this one.
        let apart =
            sorted.iter().all(|other| other.exact == own.exact && own.exact.is_some() || !other.re.overlaps(&own.re));
        let precision = own.re.precision();
        Place {
            enclosure: Interval::between(lo.clone(), hi.clone(), precision),
            exact: if alone && apart { own.exact.clone() } else { None },
        }
    };
    (0..listed.len()).map(place).collect()
}

/// Bounds of an eigenvalue, or of its real part: with the common denominator `q` of the entries, `q lambda` is an algebraic integer, and
/// all its conjugates are eigenvalues of `q A`, at most `q` times the largest sum of a row.
fn bounds(matrix: &SparseMatrix) -> Algebraic {
    let denominator = common_denominator(matrix.entries().map(|(_, _, x)| x));
    let mut sums = vec![Rational::from_integer(0.into()); matrix.order()];
    matrix.entries().for_each(|(i, _, x)| sums[i] += x.abs());
    let largest = sums.into_iter().max().unwrap_or_else(Rational::one).ceil().to_integer() * &denominator;
    let lower = if denominator.is_one() { 0 } else { denominator.bits() };
    let order = matrix.order().max(1) as u64;
    if matrix.is_symmetric() {
        return Algebraic { degree: order, upper: largest.bits(), lower };
    }
    // The real part is half the sum of two conjugates.
    Algebraic { degree: order.saturating_mul(order), upper: largest.bits() + 1, lower: lower + 2 }
}
