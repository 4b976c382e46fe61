//! `spectrum`: the eigenvalues of a matrix of a graph, enclosed.

use super::{CliError, output, progress};
use flockproof::arithmetic::threads::side_by_side;
use flockproof::arithmetic::{Interval, decimals, shown};
use flockproof::graph::read::{GraphFile, read_graph_file};
use flockproof::graph::{AnyGraph, LaplacianKind, NamedGraph, WeightedGraph};
use flockproof::report::Provenance;
use flockproof::spectrum::{Eigenvalue, Method, Spectrum, SpectrumError, graph_spectrum, named_spectrum};
use serde_json::{Value, json};
use std::path::Path;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "An edge list has lines `i j [weight]`, vertices from 1 or by name, lines `directed` and `vertices N` before them, # for comments; that of networkx \
is read too.\n\n\
Examples:\n  flockproof spectrum --graph ring:12\n  flockproof spectrum --graph circulant:12:1,3 --kind walk --digits 40\n  flockproof spectrum --graph edges.txt --json"
)]
pub struct Arguments {
    /// A graph, such as ring:12, cycle:5, path:30, complete:5, star:7, petersen, hypercube:3, grid:3x4, bipartite:3,4, circulant:12:1,3,
    /// platoon1:8, platoon2:8 (8 followers and the leader), geometric:50:1/4:7 (points, radius, seed), edges:4:1-2,2-3 or
    /// arcs:4:1-2,2-3 (vertices, edges), graph6:.., sparse6:.., or a file: an edge list, graph6, Matrix Market or GraphML; `-` is standard input
    #[arg(long, value_name = "SPEC|FILE")]
    graph: String,
    /// laplacian, out-degree, in-degree, normalised (or normalized), walk, reduced (without one vertex, see --root) or adjacency
    #[arg(long, value_name = "KIND", default_value = "laplacian")]
    kind: String,
    /// The vertex that `reduced` leaves out, its number from 1 or its name in the file [default: 1]
    #[arg(long, value_name = "K")]
    root: Option<String>,
    /// The vertices of the edge list are numbered from 0
    #[arg(long)]
    zero_based: bool,
    /// Significant digits [default: 20 where they are exact, otherwise what floating point gives]
    #[arg(long, value_name = "D", value_parser = clap::value_parser!(u32).range(1..=10000))]
    digits: Option<u32>,
    /// Print one JSON document, flockproof.spectrum/1
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let kind = kind_named(&arguments.kind)?;
    if arguments.root.is_some() && kind != LaplacianKind::Reduced {
        return Err(CliError::Use(format!("--root is for `--kind reduced`, not for `{}`", kind.name())));
    }
    let bar = progress::spinner("enclosing the eigenvalues");
    let found = find(arguments, kind);
    bar.finish_and_clear();
    let found = found?;
    if arguments.json {
        output::print_json(&stamped(arguments, kind, &found))?;
    } else {
        output::print(&table(&arguments.graph, kind, &found, shown_digits(&found.spectrum, arguments.digits)))?;
    }
    Ok(ExitCode::SUCCESS)
}

fn kind_named(name: &str) -> Result<LaplacianKind, CliError> {
    LaplacianKind::from_name(name).ok_or_else(|| {
        let names: Vec<&str> = LaplacianKind::NAMES.iter().map(|(name, _)| *name).collect();
        CliError::Use(format!("--kind: `{}` is none of {}", shown(name), names.join(", ")))
    })
}

/// The document with where it comes from.
fn stamped(arguments: &Arguments, kind: LaplacianKind, found: &Found) -> Value {
    let digits = shown_digits(&found.spectrum, arguments.digits);
    let configuration = json!({
        "command": "spectrum", "graph": arguments.graph, "file": found.file, "zero_based": arguments.zero_based,
        "kind": kind.name(), "root": found.root, "digits": arguments.digits,
    });
    Provenance::new("flockproof.spectrum/1", None, configuration).stamp(document(&arguments.graph, kind, found, digits))
}

/// A graph that was read, with its spectrum.
pub struct OfText {
    pub document: Value,
    pub graph: WeightedGraph,
    /// Whether its name or its text says that it is made of arcs.
    pub directed: bool,
    pub spectrum: Spectrum,
}

/// The spectrum of a graph by its name, or of an edge list as it would come from standard input; `most` is the largest order.
pub fn of_text(name: &str, list: output::Input, kind: &str, most: usize) -> Result<OfText, CliError> {
    let kind = kind_named(kind)?;
    let wrong = |error: &dyn std::fmt::Display| CliError::Use(format!("{}: {error}", shown(name)));
    let small = |order: usize| match order > most {
        true => Err(CliError::Use(format!("the graph has more than {most} vertices; the command line takes more"))),
        false => Ok(()),
    };
    let graph = if name.is_empty() { "-" } else { name };
    let arguments = Arguments {
        graph: graph.to_string(),
        kind: kind.name().to_string(),
        root: None,
        zero_based: false,
        digits: None,
        json: true,
    };
    let (graph, directed, found) = if name.is_empty() {
        let file = read_graph_file(&list.text, false).map_err(|error| CliError::Use(error.to_string()))?;
        small(file.graph.order())?;
        let (graph, directed) = (file.graph.clone(), file.directed);
        (graph, directed, of_file(&arguments, kind, file, list.origin)?)
    } else if let Ok(named) = name.parse::<NamedGraph>() {
        small(named.order())?;
        (named.build().map_err(|error| wrong(&error))?, named.is_directed(), of_name(&arguments, kind, &named)?)
    } else {
        let found: AnyGraph = name.parse().map_err(|error| wrong(&error))?;
        small(found.order())?;
        (found.weighted(), found.is_directed(), of_listed(&arguments, kind, &found)?)
    };
    Ok(OfText { document: stamped(&arguments, kind, &found), graph, directed, spectrum: found.spectrum })
}

/// A spectrum and what it is of.
struct Found {
    spectrum: Spectrum,
    /// The vertex that `reduced` leaves out, from 1.
    root: usize,
    /// The file that the graph comes from, and the names of its vertices.
    file: Option<Value>,
    labels: Option<Vec<String>>,
}

/// A graph of a file, or of standard input for `-`.
pub fn read_file(path: &Path, zero_based: bool) -> Result<(GraphFile, Value), CliError> {
    let input = output::read_input(path)?;
    let file = read_graph_file(&input.text, zero_based).map_err(|error| CliError::file(path, error))?;
    Ok((file, input.origin))
}

/// Refuses `--zero-based` beside a name, which it would not change.
pub fn zero_based_name(graph: &str) -> CliError {
    CliError::Use(format!("--zero-based is for the numbers of a file, and {graph} names a graph"))
}

/// The file that a graph is read from: `file:NAME`, or its name alone.
pub fn named_file(graph: &str) -> &Path {
    Path::new(graph.strip_prefix("file:").unwrap_or(graph))
}

fn find(arguments: &Arguments, kind: LaplacianKind) -> Result<Found, CliError> {
    let graph = &arguments.graph;
    let path = named_file(graph);
    // A file wins over a name only where the name means nothing. Graphs with names need not be stored.
    if let Ok(named) = graph.parse::<NamedGraph>() {
        return if arguments.zero_based { Err(zero_based_name(graph)) } else { of_name(arguments, kind, &named) };
    }
    match graph.parse::<AnyGraph>() {
        Ok(_) if arguments.zero_based => Err(zero_based_name(graph)),
        Ok(found) => of_listed(arguments, kind, &found),
        Err(_) if path.exists() || graph == "-" || graph.starts_with("file:") => {
            let (file, origin) = read_file(path, arguments.zero_based)?;
            of_file(arguments, kind, file, origin)
        }
        Err(error) if graph.contains(':') => Err(CliError::Use(format!("--graph: {error}"))),
        Err(error) => Err(CliError::Use(format!("--graph: there is no file of that name, and {error}"))),
    }
}

/// A graph whose edges the argument lists.
fn of_listed(arguments: &Arguments, kind: LaplacianKind, graph: &AnyGraph) -> Result<Found, CliError> {
    let root = root_of(arguments, graph.order(), |word| word.parse().ok())?;
    let found = graph_spectrum(&graph.weighted(), kind, root - 1, arguments.digits);
    let spectrum = found.map_err(|error| CliError::Use(format!("{}: {error}", arguments.graph)))?;
    Ok(Found { spectrum, root, file: None, labels: None })
}

fn of_name(arguments: &Arguments, kind: LaplacianKind, named: &NamedGraph) -> Result<Found, CliError> {
    let digits = arguments.digits;
    let root = root_of(arguments, named.order(), |word| word.parse().ok())?;
    let found = if root == 1 {
        named_spectrum(named, kind, digits)
    } else {
        named.build().map_err(SpectrumError::from).and_then(|graph| graph_spectrum(&graph, kind, root - 1, digits))
    };
    let spectrum = found.map_err(|error| CliError::Use(format!("{}: {error}", arguments.graph)))?;
    Ok(Found { spectrum, root, file: None, labels: None })
}

fn of_file(arguments: &Arguments, kind: LaplacianKind, file: GraphFile, origin: Value) -> Result<Found, CliError> {
    let root = root_of(arguments, file.graph.order(), |word| file.vertex(word).map(|k| k + 1))?;
    let found = graph_spectrum(&file.graph, kind, root - 1, arguments.digits);
    let spectrum = found.map_err(|error| CliError::file(Path::new(&arguments.graph), error))?;
    Ok(Found { spectrum, root, file: Some(origin), labels: file.labels })
}

/// The vertex of `--root`, from 1.
fn root_of(arguments: &Arguments, order: usize, number: impl Fn(&str) -> Option<usize>) -> Result<usize, CliError> {
    let Some(word) = &arguments.root else { return Ok(1) };
    number(word).filter(|root| (1..=order).contains(root)).ok_or_else(|| {
        let word = shown(word);
        CliError::Use(format!("--root: vertex {word} is not one of the {order} vertices, which are counted from 1"))
    })
}

/// What the kind means, with the vertex that is left out.
fn meaning(kind: LaplacianKind, root: usize) -> String {
    match kind {
        LaplacianKind::Reduced if root != 1 => format!("D - A without the row and column of vertex {root}"),
        _ => kind.meaning().to_string(),
    }
}

/// Digits that are printed: those asked for and three more, so that the ends of an enclosure differ.
fn shown_digits(spectrum: &Spectrum, digits: Option<u32>) -> u32 {
    match (digits, spectrum.method) {
        (Some(digits), Method::ClosedForm | Method::Exact) => digits + 3,
        (None, Method::ClosedForm | Method::Exact) => 20,
        (_, Method::Certified) => 17,
    }
}

fn document(graph: &str, kind: LaplacianKind, found: &Found, digits: u32) -> Value {
    let spectrum = &found.spectrum;
    let ends = |x: &Interval| {
        let (lo, hi) = decimals(x, digits);
        json!({"lo": lo, "hi": hi})
    };
    let part = |part: &Eigenvalue| {
        let mut value = if part.is_real() {
            ends(&part.re)
        } else {
            json!({"re": ends(&part.re), "im": ends(&part.im), "certificate": spectrum.reason})
        };
        value["multiplicity"] = json!(part.multiplicity);
        if let Some(exact) = &part.exact {
            value["exact"] = json!(exact.to_string());
        }
        value
    };
    let mut document = json!({
        "graph": graph,
        "kind": kind.name(),
        "order": spectrum.order,
        "method": spectrum.method.name(),
        "reason": spectrum.reason,
        "eigenvalues": side_by_side(&spectrum.eigenvalues, part),
    });
    if kind == LaplacianKind::Reduced {
        document["root"] = json!(found.root);
    }
    if let Some(labels) = &found.labels {
        document["vertices"] = json!(labels);
    }
    document
}

fn table(graph: &str, kind: LaplacianKind, found: &Found, digits: u32) -> String {
    let (spectrum, root) = (&found.spectrum, found.root);
    let count = output::counted(spectrum.order, "eigenvalue");
    let head = format!("{graph}: {count} of `{}` ({})", kind.name(), meaning(kind, root));
    let how = format!("{}: {}", spectrum.method.name(), spectrum.reason);
    let what = match spectrum.method {
        Method::Certified => "Each line: how many eigenvalues lie in the enclosure.",
        _ => "Each line: the multiplicity of one eigenvalue, and the eigenvalue.",
    };
    let mut text = String::new();
    for paragraph in [&head, &how, what] {
        text.push_str(&textwrap::fill(paragraph, 80));
        text.push('\n');
    }
    let lines: Vec<String> = side_by_side(&spectrum.eigenvalues, |part| line(part, digits));
    text.extend(lines);
    text
}

/// One eigenvalue on one line where it fits in 80 columns, otherwise its ends on lines of their own.
fn line(part: &Eigenvalue, digits: u32) -> String {
    let number = |x: &Interval| {
        let (lo, hi) = decimals(x, digits);
        if lo == hi { lo } else { format!("[{lo}, {hi}]") }
    };
    let times = part.multiplicity;
    if let Some(exact) = &part.exact {
        return format!("{times:>8}  {exact}\n");
    }
    if part.is_real() {
        let whole = format!("{times:>8}  {}\n", number(&part.re));
        return if whole.len() <= 81 { whole } else { whole.replace(", ", &format!(",\n{:>11}", "")) };
    }
    let (re, im) = (number(&part.re), number(&part.im));
    let broken = |x: String, room: usize| if x.len() <= room { x } else { x.replace(", ", &format!(",\n{:>16}", "")) };
    format!("{times:>8}  re {}\n{:>8}  im {}\n", broken(re, 67), "", broken(im, 67))
}
