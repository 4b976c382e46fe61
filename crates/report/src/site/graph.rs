//! The picture of claims, corrections and theorems, with links.

use super::Site;
use super::related::Tie;
use super::words::{mark, spoken};
use crate::page::{Links, escape};
use crate::papers::{paper as paper_of, papers};
use ledger::{Entry, correction_id};
use maud::{Markup, PreEscaped, html};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// Heights of a line, and where the three columns begin.
const LINE: f64 = 18.0;
const COLUMNS: [f64; 3] = [10.0, 360.0, 760.0];
const WIDTH: f64 = 980.0;
/// Where the writing of a column ends, about.
const LETTER: f64 = 6.6;

/// The page with the pictures of all papers.
pub(super) fn body(site: &Site) -> Markup {
    html! {
        h1 { "Claims, corrections, theorems" }
        p.lead { "Printed claims on the left, what corrects or goes beyond them in the middle, the files of Coq proofs on the right. \
                  The lines are inferred: from corrections, from the places that results name, and from the table of theorems. \
                  Claims without a line are left out." }
        @for paper in papers() {
            section aria-labelledby=(paper.key) {
                h2 id=(paper.key) { a href={ "papers/" (paper.key) ".html" } { (paper.short) " " (paper.year) } }
                div.wide.graph tabindex="0" { (PreEscaped(picture(site, paper.key, Links::Top))) }
            }
        }
    }
}

/// Nodes of a column with their heights.
type Column<'a> = BTreeMap<&'a str, f64>;

/// The picture of one paper.
pub(super) fn picture(site: &Site, paper: &str, links: Links) -> String {
    let edges = edges(site, paper);
    let side = |k: usize| -> BTreeSet<&str> {
        edges.iter().flat_map(|(a, b)| [*a, *b]).filter(|(column, _)| *column == k).map(|(_, name)| name).collect()
    };
    let columns: [Vec<&str>; 3] =
        [side(0).into_iter().collect(), side(1).into_iter().collect(), side(2).into_iter().collect()];
    let tallest = columns.iter().map(Vec::len).max().unwrap_or(0);
    let height = tallest as f64 * LINE + 12.0;
    let places: Vec<Column> = columns
        .iter()
        .map(|names| {
            let gap = tallest as f64 / names.len().max(1) as f64 * LINE;
            names.iter().enumerate().map(|(k, name)| (*name, 6.0 + (k as f64 + 0.5) * gap)).collect()
        })
        .collect();
    let title = paper_of(paper).map_or(paper, |p| p.short);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" role=\"group\" \
         aria-label=\"Claims, corrections and theorems: {}\">\n<g class=\"ties\">\n",
        escape(title)
    );
    // Writing to a string cannot fail, here and below.
    for ((from, one), (to, other)) in &edges {
        let (x0, y0) = (COLUMNS[*from] + one.len() as f64 * LETTER + 24.0, places[*from][one]);
        let (x1, y1) = (COLUMNS[*to], places[*to][other]);
        let bend = 0.5 * (x1 - x0);
        let _ = writeln!(
            out,
            "<path d=\"M{x0:.1} {y0:.1}C{:.1} {y0:.1} {:.1} {y1:.1} {x1:.1} {y1:.1}\"/>",
            x0 + bend,
            x1 - bend
        );
    }
    out.push_str("</g>\n");
    for (k, column) in places.iter().enumerate() {
        for (name, y) in column {
            node(site, k, name, *y, links, &mut out);
        }
    }
    out + "</svg>\n"
}

fn node(site: &Site, column: usize, name: &str, y: f64, links: Links, out: &mut String) {
    let x = COLUMNS[column];
    let (address, title, class, before) = match site.entry(name) {
        Some(e) => (
            format!("claims/{name}.html"),
            format!("{}: {}", spoken(e.verdict), short(&e.statement)),
            e.verdict.word(),
            mark(e.verdict),
        ),
        None => (format!("coq/{name}.html"), "file of the Coq development".to_string(), "file", "∎"),
    };
    let address = links.to(&address).unwrap_or_default();
    let _ = writeln!(
        out,
        "<a href=\"{address}\"><title>{}</title><text x=\"{x:.1}\" y=\"{:.1}\"><tspan class=\"{class}\">{before}</tspan> {}</text></a>",
        escape(&title),
        y + 4.0,
        escape(name)
    );
}

fn short(text: &str) -> String {
    let cut: String = text.chars().take(120).collect();
    if cut.len() < text.len() { format!("{cut} …") } else { cut }
}

/// A column and a name in it.
type Named<'a> = (usize, &'a str);

/// Lines from a name in one column to a name in a later one.
fn edges<'a>(site: &'a Site, paper: &str) -> BTreeSet<(Named<'a>, Named<'a>)> {
    let mut edges = BTreeSet::new();
    let about = |e: &Entry| e.paper == paper || e.id.starts_with(&format!("beyond.{paper}."));
    let column = |e: &Entry| usize::from(e.paper == "beyond");
    for entry in site.entries().iter().filter(|e| about(e)) {
        for (tie, other) in site.ties.get(&entry.id).into_iter().flatten() {
            let Some(other) = site.entry(other).filter(|other| about(other)) else { continue };
            let forward = matches!(tie, Tie::CorrectedBy | Tie::SharpenedBy | Tie::Names | Tie::NamedBy);
            if forward && column(entry) < column(other) {
                edges.insert(((0, entry.id.as_str()), (1, other.id.as_str())));
            }
        }
        let corrected = correction_id(&entry.id);
        for theorem in &site.names.theorems {
            // What is proved of a correction is drawn from the correction, where it is a claim of its own.
            let of_correction = theorem.covers == proofs::kernel::Covers::Corrected && site.entry(&corrected).is_some();
            let direct = theorem.claim == entry.id && !of_correction;
            let by_correction =
                theorem.covers == proofs::kernel::Covers::Corrected && correction_id(theorem.claim) == entry.id;
            if direct || by_correction {
                edges.insert(((column(entry), entry.id.as_str()), (2, theorem.file)));
            }
        }
    }
    edges
}
