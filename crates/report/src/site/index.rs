//! The list of all claims with its filters.

use super::words::{mark, scope_key, spoken};
use super::{Site, claim::chip};
use crate::page::Links;
use crate::papers::{paper, papers};
use ledger::{Entry, Fault, Grade, Verdict};
use maud::{Markup, html};

const FAULTS: [Fault; 4] = [Fault::False, Fault::Slip, Fault::Typo, Fault::Hypothesis];
const REACHES: [(&str, &str); 4] = [
    ("all", "every clause for all parameters"),
    ("part", "some clauses for all parameters"),
    ("instances", "on instances only"),
    ("none", "no evidence"),
];

/// The contents of the page.
pub(super) fn body(site: &Site) -> Markup {
    html! {
        h1 { "What is claimed about flocking, checked" }
        p.lead {
            "Every statement of five papers as an executable check: a verdict, graded evidence, and altered variants that the same \
             check must refute. " a href="guarantees.html" { "What a verdict promises" } "; " a href="results.html" { "what was found" } "."
        }
        (totals(site))
        (filters())
        p #count.small role="status" { (site.entries().len()) " claims" }
        table.stack.claims #claims {
            caption.hidden { "All claims" }
            thead { tr {
                th scope="col" { "Claim" } th scope="col" { "Statement" } th scope="col" { "Verdict" }
                th scope="col" { abbr title="clauses covered for all parameters" { "All" } } th scope="col" { "Evidence" }
            } }
            tbody { @for own in [false, true] { @for entry in site.entries().iter().filter(|e| (e.paper == "beyond") == own) { (row(site, entry)) } } }
        }
        p #nothing hidden { "No claim is like that. " button type="button" #reset-below { "Show all" } }
    }
}

/// Verdicts per paper.
fn totals(site: &Site) -> Markup {
    let keys: Vec<&str> = papers().map(|paper| paper.key).chain(["beyond"]).collect();
    let count = |key: &str, v: Verdict| site.entries().iter().filter(|e| e.paper == key && e.verdict == v).count();
    let name = |key: &str| paper(key).map_or("Beyond the papers".to_string(), |p| format!("{} {}", p.short, p.year));
    html! {
        div.wide tabindex="0" role="region" aria-label="Verdicts per paper" { table.totals {
            thead { tr { th scope="col" { "Paper" } @for v in Verdict::ALL { th scope="col" { (spoken(v)) } } } }
            tbody { @for key in keys {
                @let page = if key == "beyond" { "results.html".to_string() } else { format!("papers/{key}.html") };
                tr {
                    th scope="row" { a href=(page) { (name(key)) } }
                    @for v in Verdict::ALL {
                        @let n = count(key, v);
                        td data-label=(spoken(v)) { @if n > 0 { a href={ "#paper=" (key) "&verdict=" (v.word()) } { (n) } } @else { span.none { "·" } } }
                    }
                }
            } }
        } }
    }
}

fn filters() -> Markup {
    let choice = |name: &str, label: &str, options: Vec<(String, String)>| {
        html! {
            label { span { (label) } select name=(name) {
                option value="" { "any" }
                @for (value, text) in options { option value=(value) { (text) } }
            } }
        }
    };
    let of = |value: &str, text: &str| (value.to_string(), text.to_string());
    let named = papers().map(|p| (p.key.to_string(), format!("{} {}", p.short, p.year)));
    html! {
        form #filters hidden role="search" aria-label="Filter the claims" {
            label.words { span { "Words" } input type="search" name="words" autocomplete="off" spellcheck="false" placeholder="in id, place, statement   (press /)"; }
            (choice("paper", "Paper", named.chain([of("beyond", "beyond the papers")]).collect()))
            (choice("verdict", "Verdict", Verdict::ALL.iter().map(|v| (v.word().to_string(), format!("{} {}", mark(*v), spoken(*v)))).collect()))
            (choice("fault", "Fault", FAULTS.iter().map(|f| of(f.word(), f.word())).collect()))
            (choice("grade", "Evidence", Grade::ALL.iter().map(|g| (g.word().to_string(), format!("{}: {}", g.word(), g.meaning()))).collect()))
            (choice("scope", "Reach", REACHES.iter().map(|(value, text)| of(value, text)).collect()))
            button type="reset" { "Show all" }
        }
    }
}

fn row(site: &Site, entry: &Entry) -> Markup {
    let grades = entry.grades().iter().map(|g| g.word()).collect::<Vec<_>>().join(" ");
    let (whole, clauses) = entry.reach();
    let words = format!("{} {}", entry.statement, entry.corrected.as_deref().unwrap_or_default()).to_lowercase();
    html! {
        tr id=(entry.id) data-paper=(entry.paper) data-verdict=(entry.verdict.word()) data-fault=(entry.fault.map_or("", Fault::word))
            data-grade=(grades) data-scope=(scope_key(entry)) data-words=(words) {
            th scope="row" { a href={ "claims/" (entry.id) ".html" } { (breakable(&entry.id)) } span.place { (entry.place) } }
            td.statement { (site.names.rich(&entry.statement, Links::Alone)) }
            td.short data-label="Verdict" { (chip(entry)) }
            td.short data-label="All" { (whole) "/" (clauses) }
            td.short data-label="Evidence" { (entry.grades().first().map_or("", |g| g.word())) }
        }
    }
}

/// An id that may be broken after its points and underscores.
pub(super) fn breakable(id: &str) -> Markup {
    let mut parts = id.split_inclusive(['.', '_']).peekable();
    html! { @while let Some(part) = parts.next() { (part) @if parts.peek().is_some() { wbr; } } }
}
