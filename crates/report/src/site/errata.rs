//! The errata of a paper: fit to print, and to send to its authors.

use super::Site;
use super::by_hand::by_hand;
use super::words::spoken;
use crate::page::Links;
use crate::papers::{Paper, papers};
use ledger::{Entry, Fault};
use maud::{Markup, html};

/// The entries of a paper whose printed form fails.
fn errata<'a>(site: &'a Site, paper: Paper) -> impl Iterator<Item = &'a Entry> {
    site.entries().iter().filter(move |e| e.paper == paper.key && e.fault.is_some())
}

/// The list of errata.
pub(super) fn list(site: &Site) -> Markup {
    html! {
        h1 { "Errata" }
        p.lead { "For each paper one page that can be printed: place, what is printed, what is correct, why, and how to check it, by hand and by the program." }
        ul { @for paper in papers() {
            li { a href={ (paper.key) ".html" } { (paper.short) " " (paper.year) } ": " (errata(site, paper).count()) " entries" }
        } }
    }
}

/// The errata of one paper, the mathematics first.
pub(super) fn body(site: &Site, paper: Paper) -> Markup {
    let kinds = [
        (
            Fault::False,
            "Statements that are false",
            "Each fails within the paper's own hypotheses, at the example that is given.",
        ),
        (Fault::Slip, "Slips", "A step is wrong; the use that the paper makes of it survives."),
        (Fault::Hypothesis, "Missing hypotheses", "True with a hypothesis that the paper does not state."),
        (Fault::Typo, "Misprints", "The intended text is evident."),
    ];
    let mut number = 0;
    html! {
        h1 { "Errata: " (paper.title) }
        p.lead { (paper.citation()) }
        p { "Each correction is checked by the same computation that refutes the printed form. What was read \
            is the text of a scan, which may have lost a sign, an index or the extent of a radical: compare each item with the printed page." @if paper.key == "tanner2" {
            " Sections and equations are those of the authors' preprint, which cites by author and year, not of the pages of the journal." } }
        p { "Symbols, equations and places are those of the paper. " b { "By hand" } " is a program of a few lines that needs Python and NumPy and nothing else: \
            it prints what stands behind " code { "#" } ". " b { "Check" } " names the command that computes the whole entry again, with proofs and \
            enclosures, by the program flockproof " (env!("CARGO_PKG_VERSION")) "." }
        @for (fault, title, about) in kinds {
            @let of_kind: Vec<&Entry> = errata(site, paper).filter(|e| e.fault == Some(fault)).collect();
            @if !of_kind.is_empty() {
                h2 { (title) }
                p { (about) }
                @for e in of_kind {
                    @let () = number += 1;
                    (erratum(site, e, number))
                }
            }
        }
    }
}

fn erratum(site: &Site, e: &Entry, number: usize) -> Markup {
    let rich = |text: &str| site.names.rich(text, Links::Folder);
    html! {
        article.erratum id=(e.id) {
            h3 { (number) ". " (e.place) }
            dl {
                dt { "Printed" } dd { (rich(&e.statement)) }
                @if let Some(text) = &e.corrected { dt { "Correct" } dd { (rich(text)) } }
                @if let Some(text) = &e.counterexample { dt { "Fails at" } dd { (rich(text)) } }
                @if let Some(text) = site.derivation(&e.id).filter(|text| !text.is_empty()) { dt { "Why" } dd { (rich(text)) } }
                @if let Some(plain) = by_hand(&e.id) { dt { "By hand" } dd { (rich(plain.what)) pre tabindex="0" { code { (plain.code) } } } }
                dt { "Check" }
                dd { code { "flockproof explain " (e.id) } ", " a href={ "../claims/" (e.id) ".html" } { (e.id) } " (" (spoken(e.verdict)) ")" }
            }
        }
    }
}
