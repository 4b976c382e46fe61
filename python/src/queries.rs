//! Resonances, spectra, products of stochastic matrices.

use super::convert::{Ends, Matrix, Ratio, count, digits as digits_of, ends, exact, matrix, optional_count, pair};
use super::refuse;
use super::watch::{briefly, watched};
use flockproof::arithmetic::{ArithmeticError, Interval, Number, Rational, decimal};
use flockproof::graph::read::read_graph_file;
use flockproof::graph::{LaplacianKind, NamedGraph, WeightedGraph};
use flockproof::matrix::read::read_normalised;
use flockproof::matrix::{MatrixError, StochasticMatrix, prefix_products, stabilisers, tau_2_squared};
use flockproof::platoon::{Gains, ResonanceError, resonance as main_resonance, theorem1};
use flockproof::spectrum::{Eigenvalue, Method, graph_spectrum, named_spectrum};
use num_bigint::BigInt;
use pyo3::prelude::*;

/// Digits up to which a resonance takes well under a second.
const QUICK: u32 = 200;

/// Frequency and amplitude.
#[pyfunction]
pub fn resonance(
    py: Python<'_>,
    followers: &Bound<'_, PyAny>,
    f: &Bound<'_, PyAny>,
    g: &Bound<'_, PyAny>,
    digits: &Bound<'_, PyAny>,
) -> PyResult<(Ends, Ends)> {
    let gains = Gains { f: exact("f", f)?, g: exact("g", g)? };
    let (followers, digits) = (count("followers", followers)?, digits_of(digits)?);
    let work = move || {
        let found = main_resonance(&gains, followers, digits)?;
        Ok::<_, ResonanceError>((ends(&found.omega, digits + 3), ends(&found.amplitude, digits + 3)))
    };
    if digits <= QUICK { briefly(py, work)? } else { watched(py, None, move |_| work())? }.map_err(refuse)
}

/// Frequency and amplitude by Theorem 1, rounded down.
#[pyfunction]
pub fn theorem_1(
    py: Python<'_>,
    followers: u64,
    f: &Bound<'_, PyAny>,
    g: &Bound<'_, PyAny>,
    digits: u32,
) -> PyResult<(String, String)> {
    let gains = Gains { f: exact("f", f)?, g: exact("g", g)? };
    let work = move || {
        let intervals = gains.map(|q| Interval::from_rational(q, 4 * digits + 64));
        let leading = |x: Interval| decimal(&x.to_rationals().0, digits, false);
        let frequency = theorem1::frequency(&intervals, followers)?;
        Ok::<_, ArithmeticError>((leading(frequency), leading(theorem1::amplitude(&intervals, followers)?)))
    };
    if digits <= QUICK { briefly(py, work)? } else { watched(py, None, move |_| work())? }.map_err(refuse)
}

/// A graph as Python gives it.
#[derive(FromPyObject)]
pub enum GraphInput {
    /// Order, tails, heads, numerators of the weights, common denominator; every edge as two arcs.
    Arcs(usize, Vec<usize>, Vec<usize>, Vec<BigInt>, BigInt),
    /// `name`, `text` or `text from 0`, and a name such as `ring:12` or the contents of a file, whose vertices may count from 0.
    Words(String, String),
}

/// Why a text is not the name of a graph; nothing where it is one.
#[pyfunction]
pub fn graph_name_problem(name: &str) -> Option<String> {
    name.parse::<NamedGraph>().err().map(|error| error.to_string())
}

type Part = (Ends, Option<Ends>, usize, Option<Ratio>);

/// Order, method, reason, and the eigenvalues.
#[pyfunction]
pub fn spectrum(
    py: Python<'_>,
    graph: GraphInput,
    kind: &str,
    root: Option<&Bound<'_, PyAny>>,
    digits: Option<&Bound<'_, PyAny>>,
) -> PyResult<(usize, &'static str, String, Vec<Part>)> {
    let kind = LaplacianKind::from_name(kind).ok_or_else(|| {
        let names: Vec<&str> = LaplacianKind::NAMES.iter().map(|(name, _)| *name).collect();
        refuse(format!("kind: `{kind}` is none of {}", names.join(", ")))
    })?;
    let root = optional_count("root", root)?;
    if root.is_some() && kind != LaplacianKind::Reduced {
        return Err(refuse(format!("root is for kind=\"reduced\", not for \"{}\"", kind.name())));
    }
    let digits = digits.map(digits_of).transpose()?;
    let found = watched(py, None, move |_| found_spectrum(graph, kind, root.unwrap_or(1), digits))?;
    found.map_err(refuse)
}

fn found_spectrum(
    graph: GraphInput,
    kind: LaplacianKind,
    root: u64,
    digits: Option<u32>,
) -> Result<(usize, &'static str, String, Vec<Part>), String> {
    let spectrum = match graph {
        GraphInput::Words(what, name) if what == "name" && root == 1 => {
            let named: NamedGraph = name.parse().map_err(|error: flockproof::graph::NameError| error.to_string())?;
            named_spectrum(&named, kind, digits)
        }
        other => {
            let graph = stored(other)?;
            let root = usize::try_from(root).unwrap_or(usize::MAX);
            if !(1..=graph.order().max(1)).contains(&root) {
                let order = graph.order();
                return Err(format!(
                    "root: vertex {root} is not one of the {order} vertices, which are counted from 1"
                ));
            }
            graph_spectrum(&graph, kind, root - 1, digits)
        }
    };
    let spectrum = spectrum.map_err(|error| error.to_string())?;
    // As the command line: those asked for and three more, so that the ends of an enclosure differ.
    let shown = match (digits, spectrum.method) {
        (Some(digits), Method::ClosedForm | Method::Exact) => digits + 3,
        (None, Method::ClosedForm | Method::Exact) => 20,
        (_, Method::Certified) => 17,
    };
    let part = |part: &Eigenvalue| {
        let im = (!part.is_real()).then(|| ends(&part.im, shown));
        (ends(&part.re, shown), im, part.multiplicity, part.exact.clone().map(pair))
    };
    let parts = spectrum.eigenvalues.iter().map(part).collect();
    Ok((spectrum.order, spectrum.method.name(), spectrum.reason, parts))
}

fn stored(graph: GraphInput) -> Result<WeightedGraph, String> {
    match graph {
        GraphInput::Arcs(order, tails, heads, weights, denominator) => {
            if denominator == BigInt::ZERO {
                return Err(MatrixError::ZeroDenominator.to_string());
            }
            let places = tails.into_iter().zip(heads).zip(weights);
            let arcs = places.map(|((i, j), w)| (i, j, Rational::new(w, denominator.clone())));
            Ok(WeightedGraph::from_arcs(order, arcs))
        }
        GraphInput::Words(what, text) if what.starts_with("text") => {
            let file = read_graph_file(&text, what == "text from 0").map_err(|error| error.to_string())?;
            Ok(file.graph)
        }
        GraphInput::Words(_, name) => {
            let named: NamedGraph = name.parse().map_err(|error: flockproof::graph::NameError| error.to_string())?;
            named.build().map_err(|error| error.to_string())
        }
    }
}

/// The matrices of a file of `ergodicity`; with `normalise` each row divided by its sum, and which rows had which other sum, both from 1.
#[pyfunction]
pub fn read_sequence(text: &str, normalise: bool) -> PyResult<(Vec<Whole>, Vec<(usize, usize, Ratio)>)> {
    let (factors, changed) = match normalise {
        true => read_normalised(text).map_err(refuse)?,
        false => (flockproof::matrix::read::read_sequence(text).map_err(refuse)?, Vec::new()),
    };
    let changed = changed.into_iter().map(|row| (row.matrix, row.row, pair(row.sum))).collect();
    Ok((factors.iter().map(|factor| matrix(&factor.to_rational_matrix())).collect(), changed))
}

/// Rows, columns, numerators row by row, common denominator.
type Whole = (usize, usize, Vec<BigInt>, BigInt);
type Prefix = (Ratio, Ratio, Ends, String);
type Products = (Whole, Vec<Prefix>, Vec<(usize, Vec<usize>)>);

/// The product over its least common denominator; for each prefix `tau_1`, the square of `tau_2`, `tau_2` and the footprint; the stabilisers.
#[pyfunction]
pub fn ergodicity(py: Python<'_>, matrices: Vec<Matrix>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Products> {
    watched(py, progress, move |watch| products(matrices, &**watch))?.map_err(refuse)
}

fn products(matrices: Vec<Matrix>, progress: &dyn flockproof::arithmetic::Progress) -> Result<Products, String> {
    let mut factors: Vec<StochasticMatrix> = Vec::with_capacity(matrices.len());
    for (k, given) in matrices.into_iter().enumerate() {
        let refuse = |error: MatrixError| format!("matrix {}: {error}", k + 1);
        let factor = StochasticMatrix::try_from(&given.into_matrix().map_err(refuse)?).map_err(refuse)?;
        if let Some(before) = factors.last().filter(|before| before.rows() != factor.cols()) {
            let error = MatrixError::Shapes { left_cols: factor.cols(), right_rows: before.rows() };
            return Err(format!("matrix {} cannot multiply the one before it: {error}", k + 1));
        }
        factors.push(factor);
    }
    let mut prefixes = Vec::with_capacity(factors.len());
    let mut product = None;
    for prefix in prefix_products(&factors) {
        progress.checkpoint().map_err(|stopped| stopped.to_string())?;
        let prefix = prefix.map_err(|error| error.to_string())?;
        prefixes.push(measured(&prefix)?);
        progress.tell("products", prefixes.len() as u64, Some(factors.len() as u64));
        product = Some(prefix);
    }
    let product = product.ok_or("there is no matrix in it")?;
    let square = factors.iter().all(|m| m.rows() == m.cols());
    let footprints: Vec<_> = factors.iter().map(StochasticMatrix::footprint).collect();
    let found = if square { stabilisers(&footprints) } else { Vec::new() };
    let found = found.into_iter().map(|s| (s.time, s.members.into_iter().map(|i| i + 1).collect())).collect();
    Ok((
        matrix(&product.to_rational_matrix().reduced_watched(progress).map_err(|stopped| stopped.to_string())?),
        prefixes,
        found,
    ))
}

fn measured(product: &StochasticMatrix) -> Result<Prefix, String> {
    let square = tau_2_squared(&product.to_rational_matrix());
    let tau_2 = Interval::from_rational(&square, 128).sqrt().map_err(|error| error.to_string())?;
    Ok((pair(product.tau_1()), pair(square), ends(&tau_2, 20), product.footprint().to_string()))
}
