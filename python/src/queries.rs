//! Resonances, spectra, products of stochastic matrices.

use super::convert::{Ends, Matrix, Ratio, count, digits as digits_of, ends, exact, matrix, optional_count, pair};
use super::refuse;
use super::watch::{briefly, watched};
use flockproof::arithmetic::{ArithmeticError, Interval, Number, Progress, Rational, Signed, decimal};
use flockproof::graph::read::read_graph_file;
use flockproof::graph::{AnyGraph, LaplacianKind, NamedGraph, WeightedGraph};
use flockproof::matrix::read::read_normalised;
use flockproof::matrix::{
    MatrixError, RationalMatrix, SparseMatrix, StochasticMatrix, prefix_products, stabilisers, tau_2_squared,
};
use flockproof::platoon::state_space::StateSpace;
use flockproof::platoon::{
    CommunicationGraph, Gains, Line, MOST_FOLLOWERS_PROVED, MOST_STATES_PROVED, Parameter, Peak, PeakError, Platoon,
    ResonanceError, peak_of_platoon, peak_of_system, read_numbers, resonance as main_resonance, theorem1,
};
use flockproof::reach::{System, answer, decide, tube};
use flockproof::report::PatternRow;
use flockproof::spectrum::{Eigenvalue, Method, graph_spectrum, matrix_spectrum, named_spectrum};
use num_bigint::BigInt;
use pyo3::prelude::*;
use std::collections::BTreeMap;

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

/// Frequency, where there is one, and amplitude of a peak.
type PeakEnds = (Option<Ends>, Ends);

fn peak_ends(found: Result<Peak, PeakError>, digits: u32) -> Result<PeakEnds, String> {
    let Peak { omega, amplitude } = found.map_err(|error| error.to_string())?;
    Ok((omega.map(|omega| ends(&omega, digits + 3)), ends(&amplitude, digits + 3)))
}

/// The peak of a car of a platoon on a graph; vertices are counted from 1, by default the first leads and the last one that does not is looked at.
#[pyfunction]
pub fn peak(
    py: Python<'_>,
    graph: GraphInput,
    gains: (Vec<Bound<'_, PyAny>>, Vec<Bound<'_, PyAny>>),
    vertices: (Option<Bound<'_, PyAny>>, Option<Bound<'_, PyAny>>),
    digits: &Bound<'_, PyAny>,
) -> PyResult<PeakEnds> {
    let (f, g) = (listed("f", &gains.0)?, listed("g", &gains.1)?);
    let leader = optional_count("leader", vertices.0.as_ref())?;
    let car = optional_count("car", vertices.1.as_ref())?;
    let digits = digits_of(digits)?;
    watched(py, None, move |watch| found_peak(graph, (&f, &g), (leader, car), digits, watch.as_ref()))?.map_err(refuse)
}

fn found_peak(
    graph: GraphInput,
    (f, g): (&[Rational], &[Rational]),
    (leader, car): (Option<u64>, Option<u64>),
    digits: u32,
    progress: &dyn Progress,
) -> Result<PeakEnds, String> {
    let graph = stored(graph)?;
    let order = graph.order();
    let vertex = |name: &str, number: u64| {
        let found = usize::try_from(number).ok().filter(|vertex| (1..=order).contains(vertex));
        found.ok_or_else(|| {
            format!("{name}: vertex {number} is not one of the {order} vertices, which are counted from 1")
        })
    };
    let leader = vertex("leader", leader.unwrap_or(1))?;
    let last = if leader == order { order.saturating_sub(1) } else { order };
    let car = car.map_or(Ok(last), |car| vertex("car", car))?;
    if car == leader {
        return Err(format!("car: vertex {car} leads; another one is to be looked at"));
    }
    let followers = order.saturating_sub(1);
    if followers > MOST_FOLLOWERS_PROVED {
        return Err(format!(
            "graph: {followers} followers are more than the {MOST_FOLLOWERS_PROVED} of which the peak is proved"
        ));
    }
    let platoon = CommunicationGraph::behind(&graph, leader - 1).map_err(|error| format!("graph: {error}"))?;
    let place = car - usize::from(car > leader);
    if !platoon.reached_by_leader()[place] {
        return Err(format!("the leader {leader} does not reach car {car}, which stays at rest"));
    }
    let line = Line::default().with(Parameter::F, f.to_vec()).with(Parameter::G, g.to_vec());
    let platoon = line.on(platoon).map_err(|error| error.to_string())?;
    peak_ends(peak_of_platoon(&platoon, place, digits, progress), digits)
}

/// A platoon on a line: names of parameters with their numbers.
type Parameters<'py> = Vec<(String, Vec<Bound<'py, PyAny>>)>;

/// Numbers of a platoon; one text alone may be a list, as on the command line.
fn listed(name: &str, numbers: &[Bound<'_, PyAny>]) -> PyResult<Vec<Rational>> {
    if let [one] = numbers
        && let Ok(text) = one.extract::<String>()
    {
        return read_numbers(&text).map_err(|error| refuse(format!("{name}: {error}")));
    }
    numbers.iter().map(|number| exact(name, number)).collect()
}

/// The platoon of so many followers whose numbers are given.
fn on_a_line(followers: &Bound<'_, PyAny>, parameters: &Parameters<'_>) -> PyResult<Platoon<Rational>> {
    let followers = usize::try_from(count("followers", followers)?).unwrap_or(usize::MAX);
    if followers > MOST_STATES_PROVED {
        return Err(refuse(format!("followers: at most {MOST_STATES_PROVED}, not {followers}")));
    }
    let mut line = Line::default();
    for (name, numbers) in parameters {
        let parameter = Parameter::from_name(name).ok_or_else(|| refuse(format!("`{name}` is no parameter")))?;
        line = line.with(parameter, listed(name, numbers)?);
    }
    line.platoon(followers).map_err(|error| refuse(error.to_string()))
}

/// The car, from 1.
fn car_of(car: &Bound<'_, PyAny>, platoon: &Platoon<Rational>) -> PyResult<usize> {
    let followers = platoon.followers();
    let car = usize::try_from(count("car", car)?).unwrap_or(usize::MAX);
    let wrong = || refuse(format!("car: there are the followers 1 to {followers}"));
    (1..=followers).contains(&car).then_some(car).ok_or_else(wrong)
}

/// The peak of a car of a platoon on a line.
#[pyfunction]
pub fn platoon_peak(
    py: Python<'_>,
    followers: &Bound<'_, PyAny>,
    parameters: Parameters<'_>,
    car: &Bound<'_, PyAny>,
    digits: &Bound<'_, PyAny>,
) -> PyResult<PeakEnds> {
    let platoon = on_a_line(followers, &parameters)?;
    let (car, digits) = (car_of(car, &platoon)?, digits_of(digits)?);
    if platoon.followers() > MOST_FOLLOWERS_PROVED {
        let followers = platoon.followers();
        let most = MOST_FOLLOWERS_PROVED;
        return Err(refuse(format!("followers: {followers} are more than the {most} of which the peak is proved")));
    }
    let work = move |progress: &dyn Progress| peak_ends(peak_of_platoon(&platoon, car, digits, progress), digits);
    watched(py, None, move |watch| work(watch.as_ref()))?.map_err(refuse)
}

/// Amplitude and phase, where there is one, of each of some cars at a frequency.
#[pyfunction]
pub fn platoon_response(
    py: Python<'_>,
    followers: &Bound<'_, PyAny>,
    parameters: Parameters<'_>,
    cars: Vec<Bound<'_, PyAny>>,
    frequency: &Bound<'_, PyAny>,
    digits: &Bound<'_, PyAny>,
) -> PyResult<Vec<(Ends, Option<Ends>)>> {
    let platoon = on_a_line(followers, &parameters)?;
    let cars = cars.iter().map(|car| car_of(car, &platoon)).collect::<PyResult<Vec<_>>>()?;
    let (w, digits) = (exact("frequency", frequency)?, digits_of(digits)?);
    if w.is_certainly_negative() {
        return Err(refuse(format!("frequency must not be negative, but it is {w}")));
    }
    let work = move || {
        let all = platoon.enclosed_response(&w, digits).map_err(|error| error.to_string())?;
        let of = |car: &usize| {
            let polar = &all[car - 1];
            (ends(&polar.amplitude, digits + 3), polar.phase.as_ref().map(|phase| ends(phase, digits + 3)))
        };
        Ok::<_, String>(cars.iter().map(of).collect())
    };
    watched(py, None, move |_| work())?.map_err(refuse)
}

/// The rows of the matrices of `x' = A x + B u, y = C x` with exact entries, for these cars as outputs.
#[pyfunction]
pub fn platoon_matrices(
    followers: &Bound<'_, PyAny>,
    parameters: Parameters<'_>,
    car: &Bound<'_, PyAny>,
) -> PyResult<[Vec<Vec<Ratio>>; 4]> {
    let platoon = on_a_line(followers, &parameters)?;
    let car = car_of(car, &platoon)?;
    let system = StateSpace::of_platoon(&platoon, car).map_err(|error| refuse(error.to_string()))?;
    let row = |row: Vec<Rational>| row.into_iter().map(pair).collect();
    Ok(system.matrices().map(|rows| rows.into_iter().map(row).collect()))
}

/// The eigenvalues of `A`: real parts, imaginary parts where they are not known to be zero, multiplicities.
#[pyfunction]
pub fn platoon_poles(
    py: Python<'_>,
    followers: &Bound<'_, PyAny>,
    parameters: Parameters<'_>,
) -> PyResult<Vec<(Ends, Option<Ends>, usize)>> {
    let platoon = on_a_line(followers, &parameters)?;
    let work = move || {
        let rows = platoon.motion_rows().map_err(|error| error.to_string())?;
        let matrix = RationalMatrix::from_rows(&rows).map_err(|error| error.to_string())?;
        let sparse = SparseMatrix::from_dense(&matrix).map_err(|error| error.to_string())?;
        let spectrum = matrix_spectrum(&sparse, None).map_err(|error| error.to_string())?;
        let part = |part: &Eigenvalue| {
            let im = (!part.is_real()).then(|| ends(&part.im, 17));
            (ends(&part.re, 17), im, part.multiplicity)
        };
        Ok::<_, String>(spectrum.eigenvalues.iter().map(part).collect())
    };
    watched(py, None, move |_| work())?.map_err(refuse)
}

/// The peak of `x' = A x + B u, y = C x + D u`.
#[pyfunction]
pub fn system_peak(
    py: Python<'_>,
    matrices: (Matrix, Matrix, Matrix, Option<Matrix>),
    digits: &Bound<'_, PyAny>,
) -> PyResult<PeakEnds> {
    let digits = digits_of(digits)?;
    let work = move |progress: &dyn Progress| {
        let rows =
            |matrix: Matrix| matrix.into_matrix().map(|matrix| matrix.to_rows()).map_err(|error| error.to_string());
        let (a, b, c, d) = matrices;
        let (a, b, c, d) = (rows(a)?, rows(b)?, rows(c)?, d.map(rows).transpose()?);
        if a.len() > MOST_STATES_PROVED {
            return Err(format!(
                "A: {} states are more than the {MOST_STATES_PROVED} of which the peak is proved",
                a.len()
            ));
        }
        let system = StateSpace::new(&a, &b, &c, d.as_deref()).map_err(|error| error.to_string())?;
        peak_ends(peak_of_system(&system, digits, progress), digits)
    };
    watched(py, None, move |watch| work(watch.as_ref()))?.map_err(refuse)
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
    // Graphs with names need not be stored.
    if name.parse::<NamedGraph>().is_ok() {
        return None;
    }
    name.parse::<AnyGraph>().err().map(|error| error.to_string())
}

/// The names of the vertices in the text of a file, where they are no numbers.
#[pyfunction]
pub fn graph_labels(text: &str, zero_based: bool) -> Option<Vec<String>> {
    read_graph_file(text, zero_based).ok()?.labels
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
        GraphInput::Words(what, name) if what == "name" && root == 1 && name.parse::<NamedGraph>().is_ok() => {
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
            let found: AnyGraph = name.parse().map_err(|error: flockproof::graph::GraphTextError| error.to_string())?;
            Ok(found.weighted())
        }
    }
}

/// The document and the words about the checks of a system.
#[pyfunction]
pub fn reach(
    py: Python<'_>,
    text: String,
    files: BTreeMap<String, String>,
    digits: &Bound<'_, PyAny>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(String, String)> {
    let digits = digits_of(digits)?;
    watched(py, progress, move |watch| {
        let system = system_beside(&text, &files)?;
        let decided = decide(&system, digits, &**watch).map_err(|error| error.to_string())?;
        Ok::<_, String>((answer::json(&system, &decided, digits).to_string(), answer::text(&system, &decided, digits)))
    })?
    .map_err(refuse)
}

fn system_beside(text: &str, files: &BTreeMap<String, String>) -> Result<System, String> {
    let file = |name: &str| files.get(name).cloned().ok_or_else(|| format!("there is no file `{name}`"));
    System::read_beside(text, &file).map_err(|error| error.to_string())
}

/// A quantity of a system over time: its name, the bound, `[from, to, least, most]` of all motions, and of the worst one that was found.
type TubeOf = (String, String, Vec<[f64; 4]>, Vec<[f64; 4]>);

/// The quantity that decides one check, over time in so many sections.
#[pyfunction]
pub fn reach_tube(
    py: Python<'_>,
    text: String,
    files: BTreeMap<String, String>,
    digits: &Bound<'_, PyAny>,
    check: usize,
    samples: usize,
) -> PyResult<TubeOf> {
    let digits = digits_of(digits)?;
    watched(py, None, move |watch| {
        let mut system = system_beside(&text, &files)?;
        system.checks = system.checks.into_iter().skip(check).take(1).collect();
        let decided = decide(&system, digits, &**watch).map_err(|error| error.to_string())?;
        let found = decided.first().ok_or("the system has no such check")?.decisive();
        let drawn = tube(&system, found, samples, &**watch).map_err(|error| error.to_string())?;
        let bound = found.condition.bound.to_string();
        let run = drawn.runs.into_iter().next().unwrap_or_default();
        Ok::<_, String>((drawn.quantity, bound, drawn.sections, run))
    })?
    .map_err(refuse)
}

/// Clusters, verdict, eigenvalues 0, largest real part, a wave number that attains it.
type PatternFound = (usize, &'static str, usize, Option<Ends>, Option<usize>);

/// A row for each number of clusters that divides the number of particles.
#[pyfunction]
pub fn pattern(
    py: Python<'_>,
    particles: &Bound<'_, PyAny>,
    gains: Vec<Bound<'_, PyAny>>,
    omega0: &Bound<'_, PyAny>,
    spacing: &Bound<'_, PyAny>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Vec<PatternFound>> {
    let particles = usize::try_from(count("particles", particles)?).unwrap_or(usize::MAX);
    let gains = gains.iter().map(|gain| exact("gains", gain)).collect::<PyResult<Vec<_>>>()?;
    let circular = (exact("omega0", omega0)?, exact("spacing", spacing)?);
    let work = move |progress: &dyn Progress| {
        PatternRow::all(particles, (&circular.0, &circular.1), &gains, progress).map_err(|error| error.to_string())
    };
    let rows = watched(py, progress, move |watch| work(watch.as_ref()))?.map_err(refuse)?;
    let found = |row: PatternRow| {
        let abscissa = row.abscissa.as_ref().map(|x| ends(x, PatternRow::DIGITS));
        (row.clusters, row.verdict(), row.zeros, abscissa, row.wave)
    };
    Ok(rows.into_iter().map(found).collect())
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
