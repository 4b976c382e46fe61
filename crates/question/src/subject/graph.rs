//! Graphs and their spectra.

use crate::bindings::GraphValue;
use crate::error::Problem;
use crate::failure::Failure;
use crate::timeline::Measured;
use algebra::graph::{Graph, LaplacianKind};
use algebra::matrix::SparseMatrix;
use algebra::spectrum::{
    Eigenvalue, FloatEnclosure, matrix_spectrum, named_spectrum, small_symmetric_eigenvalues, symmetric_enclosures,
};
use arithmetic::{Algebraic, RealNumber as Number};
use arithmetic::{Dyadic, Interval, Rational, common_denominator};
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive};
use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

/// A graph with what has been found out about it.
pub(crate) struct GraphSubject {
    graph: Arc<GraphValue>,
    kind: LaplacianKind,
    matrix: OnceCell<Result<SparseMatrix, String>>,
    floats: OnceCell<Option<Vec<Place>>>,
    small: OnceCell<Option<Vec<FloatEnclosure>>>,
    exact: RefCell<Option<(u32, Vec<Place>)>>,
    distances: OnceCell<Option<usize>>,
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

impl GraphSubject {
    pub fn new(graph: Arc<GraphValue>, kind: LaplacianKind) -> Self {
        GraphSubject {
            graph,
            kind,
            matrix: OnceCell::new(),
            floats: OnceCell::new(),
            small: OnceCell::new(),
            exact: RefCell::new(None),
            distances: OnceCell::new(),
        }
    }

    /// A quantity by its name.
    pub fn measure(&self, name: &str, arguments: &[Number], precision: u32) -> Result<Measured, Failure> {
        let count = |n: usize| Ok(Measured::Number(Number::integer(n as i64)));
        match name {
            "n" => count(self.graph.order()),
            "edges" => {
                let arcs = self.graph.arcs();
                count(if self.graph.is_directed() { arcs.len() } else { arcs.iter().filter(|(i, j)| i <= j).count() })
            }
            "min_degree" => count(self.degrees().into_iter().min().unwrap_or(0)),
            "max_degree" => count(self.degrees().into_iter().max().unwrap_or(0)),
            "connected" => Ok(Measured::Truth(self.diameter().is_some())),
            "diameter" => match self.diameter() {
                Some(diameter) => count(diameter),
                None => Err(refused("the diameter of a graph that is not connected does not exist".to_string())),
            },
            _ => self.eigenvalue(arguments, precision).map(Measured::Number),
        }
    }

    fn degrees(&self) -> Vec<usize> {
        if let GraphValue::Simple(graph) = self.graph.as_ref() {
            return (0..graph.order()).map(|i| graph.degree(i)).collect();
        }
        let mut degrees = vec![0; self.graph.order()];
        self.graph.arcs().into_iter().for_each(|(i, _)| degrees[i] += 1);
        degrees
    }

    /// The largest distance along arcs; `None` where some vertex cannot be reached.
    fn diameter(&self) -> Option<usize> {
        *self.distances.get_or_init(|| {
            let order = self.graph.order();
            let mut around = vec![Vec::new(); order];
            self.graph.arcs().into_iter().for_each(|(i, j)| around[i].push(j));
            let reach = |start: usize| {
                let mut distance = vec![usize::MAX; order];
                distance[start] = 0;
                let mut queue = vec![start];
                let mut next = 0;
                while let Some(&i) = queue.get(next) {
                    next += 1;
                    for &j in &around[i] {
                        if distance[j] == usize::MAX {
                            distance[j] = distance[i] + 1;
                            queue.push(j);
                        }
                    }
                }
                distance.into_iter().max().filter(|&d| d < usize::MAX)
            };
            (0..order).map(reach).try_fold(0, |most, reach| reach.map(|d| most.max(d)))
        })
    }

    fn eigenvalue(&self, arguments: &[Number], precision: u32) -> Result<Number, Failure> {
        let order = self.graph.order();
        let index = arguments.first().and_then(Number::as_integer);
        let Some(k) = index.as_ref().and_then(ToPrimitive::to_usize).filter(|k| (1..=order).contains(k)) else {
            let found = arguments.first().map_or("nothing".to_string(), Number::text);
            let what = "the index of `lambda`".to_string();
            return Err(Failure::Refused(
                0,
                match index {
                    None => Problem::NotInteger { what, found },
                    Some(_) => Problem::Range { what, expected: format!("between 1 and {order}"), found },
                },
            ));
        };
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
            return Ok(self.number(place, matrix));
        }
        self.refine(matrix, precision)?;
        match self.exact.borrow().as_ref().and_then(|(_, places)| places.get(k - 1)) {
            Some(place) => Ok(self.number(place, matrix)),
            None => Err(Failure::open("an eigenvalue could not be enclosed", None)),
        }
    }

    /// The k-th eigenvalue of the Laplacian of a small graph, of which families have thousands.
    fn small_eigenvalue(&self, k: usize) -> Option<Number> {
        let GraphValue::Simple(graph) = self.graph.as_ref() else { return None };
        let order = graph.order();
        if self.kind != LaplacianKind::Combinatorial || order > LARGEST_SMALL {
            return None;
        }
        let found = self.small.get_or_init(|| {
            let entry = |i: usize, j: usize| match i == j {
                true => graph.degree(i) as f64,
                false => -f64::from(u8::from(graph.has_edge(i, j))),
            };
            let entries: Vec<f64> = (0..order * order).map(|place| entry(place / order, place % order)).collect();
            small_symmetric_eigenvalues(&entries, order)
        });
        let place = found.as_ref()?.get(k - 1)?;
        let [lo, hi] = [(place.re - place.radius).next_down(), (place.re + place.radius).next_up()];
        let enclosure = Interval::between(Dyadic::from_f64(lo)?, Dyadic::from_f64(hi)?, FLOAT_BITS);
        // All eigenvalues lie between 0 and twice the largest degree, and the matrix has integers.
        let largest = BigInt::from(2 * (0..order).map(|i| graph.degree(i)).max().unwrap_or(0));
        Some(Number::Enclosed(enclosure, Some(Algebraic { degree: order as u64, upper: largest.bits(), lower: 0 })))
    }

    fn number(&self, place: &Place, matrix: &SparseMatrix) -> Number {
        match &place.exact {
            Some(q) => Number::Exact(q.clone()),
            None => Number::Enclosed(place.enclosure.clone(), Some(bounds(matrix))),
        }
    }

    fn matrix(&self) -> Result<&SparseMatrix, Failure> {
        let found = self.matrix.get_or_init(|| self.graph.weighted().matrix(self.kind).map_err(|e| e.to_string()));
        found.as_ref().map_err(|error| refused(error.clone()))
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
        let digits = (f64::from(precision) * std::f64::consts::LOG10_2).ceil() as u32 + 1;
        let find = |digits: Option<u32>| match self.graph.as_ref() {
            GraphValue::Named(name, _) => named_spectrum(name, self.kind, digits),
            _ => matrix_spectrum(matrix, digits),
        };
        // Where digits cannot be had, what floating point gives.
        let spectrum = match find(Some(digits)) {
            Ok(spectrum) => spectrum,
            Err(_) if precision <= FLOAT_BITS => find(None).map_err(|error| Failure::open(error.to_string(), None))?,
            Err(error) => return Err(Failure::open(error.to_string(), None)),
        };
        *self.exact.borrow_mut() = Some((precision, in_order(&spectrum.eigenvalues)));
        Ok(())
    }
}

fn refused(message: String) -> Failure {
    Failure::Refused(0, Problem::Other(message))
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

/// The graphs with one link more, or less.
pub(crate) fn changed_by_one_link(graph: &Graph, more: bool) -> Vec<Graph> {
    let order = graph.order();
    let pairs = (0..order).flat_map(|j| (0..j).map(move |i| (i, j)));
    let toggled = |(i, j): (usize, usize)| {
        Graph::from_fn(order, |a, b| if (a, b) == (i, j) { more } else { graph.has_edge(a, b) })
    };
    pairs.filter(|&(i, j)| graph.has_edge(i, j) != more).map(toggled).collect()
}
