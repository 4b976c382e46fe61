//! The page of a paper: its claims, its tables and figures beside ours.

use super::claim::chip;
use super::index::breakable;
use super::words::spoken;
use super::{Site, figure, graph};
use crate::page::Links;
use crate::papers::{Paper, papers};
use ledger::Verdict;
use maud::{Markup, PreEscaped, html};

/// The list of papers.
pub(super) fn list(site: &Site) -> Markup {
    html! {
        h1 { "The papers" }
        @for paper in papers() {
            section aria-labelledby=(paper.key) {
                h2 id=(paper.key) { a href={ (paper.key) ".html" } { (paper.title) } }
                p { (paper.citation()) }
                (counts(site, paper))
            }
        }
    }
}

fn counts(site: &Site, paper: Paper) -> Markup {
    let of = |v: Verdict| site.entries().iter().filter(|e| e.paper == paper.key && e.verdict == v).count();
    let counts = Verdict::ALL.into_iter().map(|v| (v, of(v))).filter(|(_, n)| *n > 0);
    html! {
        p.small {
            @for (k, (v, n)) in counts.enumerate() { @if k > 0 { ", " } a href={ "../index.html#paper=" (paper.key) "&verdict=" (v.word()) } { (n) " " (spoken(v)) } }
            " · " a href={ "../errata/" (paper.key) ".html" } { "errata" }
        }
    }
}

/// The page of one paper.
pub(super) fn body(site: &Site, paper: Paper) -> Markup {
    let links = Links::Folder;
    let figures: Vec<_> = site.figures.iter().filter(|made| made.figure.paper() == paper.key).collect();
    html! {
        h1 { (paper.title) }
        p.lead { (paper.citation()) }
        (counts(site, paper))
        nav.within aria-label="On this page" {
            a href="#claims" { "Claims" } " "
            a href="#theorems" { "Claims, corrections, theorems" } " "
            @if !figures.is_empty() { a href="#figures" { "Tables and figures" } }
        }
        section aria-labelledby="claims" {
            h2 #claims { "Claims" }
            table.stack.claims {
                thead { tr { th scope="col" { "Claim" } th scope="col" { "Statement" } th scope="col" { "Verdict" } } }
                tbody { @for e in site.entries().iter().filter(|e| e.paper == paper.key) {
                    tr {
                        th scope="row" { a href={ "../claims/" (e.id) ".html" } { (breakable(&e.id)) } span.place { (e.place) } }
                        td.statement { (site.names.rich(&e.statement, Links::Alone)) }
                        td.short data-label="Verdict" { (chip(e)) }
                    }
                } }
            }
        }
        section aria-labelledby="theorems" {
            h2 #theorems { "Claims, corrections, theorems" }
            p { "Printed claims on the left, what corrects or goes beyond them in the middle, the files of Coq proofs on the right." }
            div.wide.graph tabindex="0" { (PreEscaped(graph::picture(site, paper.key, links))) }
        }
        @if !figures.is_empty() {
            section aria-labelledby="figures" {
                h2 #figures { "Tables and figures" }
                p { "Computed by the program; numbers of the paper stand beside ours where it prints any." }
                @for made in figures { (figure::in_full(site, made, links)) }
            }
        }
    }
}
