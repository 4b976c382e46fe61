//! Figures on pages, and which belong to which claim.

use super::{Made, Site};
use crate::page::Links;
use ledger::Entry;
use maud::{Markup, PreEscaped, html};

/// A table of a figure is shown on the page if it has at most so many rows.
const ROWS: usize = 32;

/// The figures that bear on a claim.
pub(super) fn of_claim(site: &Site, entry: &Entry, links: Links) -> Markup {
    let own = |made: &&Made| made.figure.claims.contains(&entry.id.as_str());
    html! {
        @for made in site.figures.iter().filter(own) {
            figure.shown {
                @for picture in pictures(made) { (image(made, picture, links)) }
                figcaption {
                    (links.link(&format!("papers/{}.html#{}", made.figure.paper(), made.figure.name), html! { (made.figure.name) }))
                    ": " (made.figure.about) ". " code { "flockproof reproduce " (made.figure.name) " --out DIR" }
                }
            }
        }
    }
}

/// A figure in full, on the page of its paper.
pub(super) fn in_full(site: &Site, made: &Made, links: Links) -> Markup {
    let tables: Vec<&crate::File> = made.files.iter().filter(|file| file.name.ends_with(".csv")).collect();
    html! {
        section id=(made.figure.name) aria-label=(made.figure.name) {
            h3 { (made.figure.name) }
            figure.shown {
                @for picture in pictures(made) { (image(made, picture, links)) }
                figcaption { (made.figure.about) ". Claims: "
                    @for (k, id) in made.figure.claims.iter().enumerate() { @if k > 0 { ", " } (site.names.linked(id, links)) } "." }
            }
            @for file in &tables { (table(file)) }
            details { summary { "What was computed, and how it compares" } pre tabindex="0" { (site.names.linked(&made.text, links)) } }
            p.small {
                code { "flockproof reproduce " (made.figure.name) " --out DIR" } " · "
                @for (k, file) in made.files.iter().enumerate() {
                    @if k > 0 { ", " }
                    @if let Some(address) = links.to(&format!("figures/{}", file.name)) { a href=(address) { (file.name) } }
                }
            }
        }
    }
}

fn pictures(made: &Made) -> impl Iterator<Item = &crate::File> {
    made.files.iter().filter(|file| file.name.ends_with(".svg"))
}

fn image(made: &Made, picture: &crate::File, links: Links) -> Markup {
    let text = format!("{}: {}", made.figure.name, made.figure.about);
    match links.to(&format!("figures/{}", picture.name)) {
        Some(address) => html! { a.picture href=(address) { img src=(address) alt=(text) loading="lazy"; } },
        None => {
            html! { div.picture role="img" aria-label=(text) { (PreEscaped(String::from_utf8_lossy(&picture.contents))) } }
        }
    }
}

/// A short table as it is in the file.
fn table(file: &crate::File) -> Markup {
    let text = String::from_utf8_lossy(&file.contents);
    let mut rows = text.lines().map(cells);
    let Some(header) = rows.next() else { return html! {} };
    let header: Vec<String> = header.iter().map(|cell| cell.replace('_', " ")).collect();
    let rows: Vec<Vec<String>> = rows.collect();
    if rows.len() > ROWS {
        return html! {};
    }
    html! {
        div.wide tabindex="0" role="region" aria-label=(file.name) { table.numbers {
            thead { tr { @for cell in &header { th scope="col" { (cell) } } } }
            tbody { @for row in rows { tr { @for (label, cell) in header.iter().zip(row) { td data-label=(label) { (cell) } } } } }
        } }
    }
}

/// The cells of a line of our own CSV, where quotes may stand around a whole cell.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell)),
            _ => cell.push(c),
        }
    }
    cells.push(cell);
    cells
}
