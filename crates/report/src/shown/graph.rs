//! Graphs and their spectra.

use super::{enclosed, picture, table};
use crate::plot::{Axis, Panel, Picture, Series};
use algebra::graph::WeightedGraph;
use algebra::spectrum::{Eigenvalue, Method, Spectrum};
use maud::{Markup, html};

/// Most vertices of a graph that is drawn, and most that have numbers.
const DRAWN: usize = 120;
const NUMBERED: usize = 40;

/// The eigenvalues as a table and as points, and the graph, drawn with arcs where it is `directed`.
pub fn spectrum(graph: &WeightedGraph, directed: bool, spectrum: &Spectrum) -> String {
    let digits = match spectrum.method {
        Method::Certified => 17,
        _ => 20,
    };
    let value = |part: &Eigenvalue| match &part.exact {
        Some(exact) => exact.to_string(),
        None if part.is_real() => enclosed(&part.re, digits),
        None => format!("{} + i {}", enclosed(&part.re, digits), enclosed(&part.im, digits)),
    };
    let rows: Vec<Vec<String>> =
        spectrum.eigenvalues.iter().map(|part| vec![part.multiplicity.to_string(), value(part)]).collect();
    let arcs: Vec<(usize, usize)> = graph.adjacency().entries().map(|(i, j, _)| (i, j)).collect();
    let shown = html! {
        p { (spectrum.order) " eigenvalues, " (spectrum.method.name()) ": " (spectrum.reason) }
        (table("Eigenvalues", &["multiplicity", "eigenvalue"], &rows))
        (picture(&points(spectrum), "spectrum", "The eigenvalues in the complex plane."))
        (drawn(graph.order(), &arcs, directed))
    };
    shown.into_string()
}

fn points(spectrum: &Spectrum) -> Picture {
    let places = spectrum.eigenvalues.iter().map(|part| (part.re.to_f64(), part.im.to_f64()));
    let panel =
        Panel::new("", Axis::linear("real part"), Axis::linear("imaginary part")).series(Series::points("", places));
    Picture::new("").grid(1, (720.0, 260.0)).panel(panel)
}

/// A graph with its vertices on a circle, arcs with heads, and its size in words; nothing where it is too large to be seen.
pub(super) fn drawn(order: usize, arcs: &[(usize, usize)], directed: bool) -> Markup {
    match network(order, arcs, directed, 320.0) {
        Some((drawn, about)) => html! { (drawn) p.small { (about) "." } },
        None => html! {},
    }
}

/// The drawing, so many pixels wide and high, and the size of the graph in words.
pub(crate) fn network(order: usize, arcs: &[(usize, usize)], directed: bool, size: f64) -> Option<(Markup, String)> {
    if order == 0 || order > DRAWN {
        return None;
    }
    let (middle, radius) = (size / 2.0, size / 2.0 - 24.0);
    let place = |k: usize| {
        let angle = std::f64::consts::TAU * (k as f64 / order as f64 - 0.25);
        (middle + radius * angle.cos(), middle + radius * angle.sin())
    };
    let node = if order > NUMBERED { 3.0 } else { 9.0 };
    // From rim to rim, so that heads are seen.
    let ends = |i: usize, j: usize| {
        let ((x, y), (u, v)) = (place(i), place(j));
        let length = (u - x).hypot(v - y).max(1e-9);
        let (a, b) = ((u - x) / length * (node + 1.0), (v - y) / length * (node + 1.0));
        (x + a, y + b, u - a, v - b)
    };
    let lines = arcs.iter().filter(|(i, j)| i != j && (directed || i < j));
    let plural = |count: usize, one: &str, many: &str| format!("{count} {}", if count == 1 { one } else { many });
    let (one, many) = if directed { ("arc", "arcs") } else { ("edge", "edges") };
    let count = plural(lines.clone().count(), one, many);
    let about = format!("Graph with {} and {count}", plural(order, "vertex", "vertices"));
    let drawn = html! {
        div.network role="img" aria-label=(about) {
            svg width=(size) height=(size) viewBox=(format!("0 0 {size} {size}")) {
                @for &(i, j) in lines {
                    @let (x, y, u, v) = ends(i, j);
                    line x1=(format!("{x:.1}")) y1=(format!("{y:.1}")) x2=(format!("{u:.1}")) y2=(format!("{v:.1}")) {}
                    @if directed { polygon points=(head((x, y), (u, v))) {} }
                }
                @for k in 0..order {
                    @let (x, y) = place(k);
                    circle cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r=(node) {}
                    @if order <= NUMBERED { text x=(format!("{x:.1}")) y=(format!("{:.1}", y + 3.6)) { (k + 1) } }
                }
            }
        }
    };
    Some((drawn, about))
}

/// The head of an arrow.
fn head((x, y): (f64, f64), (u, v): (f64, f64)) -> String {
    let length = (u - x).hypot(v - y).max(1e-9);
    let (a, b) = ((u - x) / length, (v - y) / length);
    let corner = |back: f64, side: f64| format!("{:.1},{:.1}", u - back * a - side * b, v - back * b + side * a);
    [corner(0.0, 0.0), corner(8.0, 3.0), corner(8.0, -3.0)].join(" ")
}
