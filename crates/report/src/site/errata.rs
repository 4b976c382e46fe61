//! The errata of a paper: fit to print, and to send to its authors.

use super::Site;
use super::by_hand::{Item, items};
use super::texts::words;
use crate::page::Links;
use crate::papers::{Paper, papers};
use ledger::{Entry, Fault};
use maud::{Markup, html};
use std::collections::BTreeMap;

/// A part of a page of errata.
pub(super) struct Kind {
    /// Its name in the files of items.
    pub key: &'static str,
    title: &'static str,
    about: &'static str,
    /// What the corrected text and the example are called.
    labels: [&'static str; 2],
}

/// The parts of a page, the mathematics first.
pub(super) const KINDS: [Kind; 7] = [
    Kind {
        key: "false",
        title: "Statements that are false",
        about: "Each fails within the paper's own hypotheses, at the example that is given.",
        labels: ["Correct", "Fails at"],
    },
    Kind {
        key: "open",
        title: "A statement whose proof does not stand",
        about: "Neither a proof nor a counterexample is known to us.",
        labels: ["State", "Fails at"],
    },
    Kind {
        key: "slip",
        title: "Slips",
        about: "A step is wrong; the use that the paper makes of it survives.",
        labels: ["Correct", "Fails at"],
    },
    Kind {
        key: "hypothesis",
        title: "Missing hypotheses",
        about: "True with a hypothesis that the paper does not state.",
        labels: ["Correct", "Fails at"],
    },
    Kind { key: "typo", title: "Misprints", about: "The intended text is evident.", labels: ["Correct", "Fails at"] },
    Kind {
        key: "scan",
        title: "Marks to compare with the printed page",
        about: "Each is one mark (a sign, an index, a dot, a radical, a bracket) that the scan which was read may have lost or altered. \
            If the printed page has it right, there is no error.",
        labels: ["Correct", "Fails at"],
    },
    Kind {
        key: "convention",
        title: "Conventions that a reader needs",
        about: "No errors: the text is right if it is read in one way, and not in another one that its words allow.",
        labels: ["In full", "Otherwise"],
    },
];

/// An item with the entries of its claims.
struct Found<'a> {
    item: Item<'static>,
    kind: &'static str,
    entries: Vec<&'a Entry>,
}

/// The items of a paper in the order of their kinds; items none of whose claims is in the ledger are left out.
fn found<'a>(site: &'a Site<'_>, paper: Paper) -> Vec<Found<'a>> {
    let mut all: Vec<Found> = items(paper.key)
        .filter_map(|item| {
            let entries: Vec<&Entry> =
                item.ids.iter().filter_map(|id| site.entries().iter().find(|e| e.id == *id)).collect();
            let kind = item.kind.or_else(|| entries.first()?.fault.map(key))?;
            (!entries.is_empty()).then_some(Found { item, kind, entries })
        })
        .collect();
    all.sort_by_key(|found| KINDS.iter().position(|kind| kind.key == found.kind));
    all
}

/// The kind of a fault.
fn key(fault: Fault) -> &'static str {
    match fault {
        Fault::False => "false",
        Fault::Slip => "slip",
        Fault::Hypothesis => "hypothesis",
        Fault::Typo => "typo",
    }
}

/// The list of errata.
pub(super) fn list(site: &Site) -> Markup {
    html! {
        h1 { "Errata" }
        p.lead { "For each paper one page that can be printed: place, what is printed, what is correct, why, and how to check it, by hand and by the program." }
        ul { @for paper in papers() {
            li { a href={ (paper.key) ".html" } { (paper.short) " " (paper.year) } ": "
                (found(site, paper).len()) " items" }
        } }
    }
}

/// The errata of one paper.
pub(super) fn body(site: &Site, paper: Paper) -> Markup {
    let all = found(site, paper);
    let numbers: BTreeMap<&str, usize> =
        all.iter().zip(1..).flat_map(|(one, k)| one.item.ids.iter().map(move |id| (*id, k))).collect();
    html! {
        h1 { "Errata: " (paper.title) }
        p.lead { (paper.citation()) }
        p { "What was read is the text of a scan, which may have lost a sign, an index or the extent of a radical: compare each item with the \
            printed page. " (remark(paper.key)) }
        p { "Symbols, equations and places are those of the paper. " b { "Printed" } " gives a statement with what it takes from its surroundings, not always \
            word for word. " b { "By hand" } " says how an item is seen in a minute: mostly by a program of a few \
            lines that needs Python and NumPy and nothing else and prints what stands behind " code { "#" } ". " b { "Check" } " names the command that \
            computes the whole entry again, with proofs and enclosures, by the program flockproof " (env!("CARGO_PKG_VERSION")) "; nothing here leans on it." }
        @for kind in &KINDS {
            @let of_kind: Vec<&Found> = all.iter().filter(|one| one.kind == kind.key).collect();
            @if !of_kind.is_empty() {
                h2 { (kind.title) }
                p { (kind.about) }
                @for one in of_kind { (erratum(site, kind, one, &numbers)) }
            }
        }
    }
}

/// What a reader of one paper has to know besides.
fn remark(paper: &str) -> Markup {
    let text = match paper {
        "veerman" => {
            "The frequency omega is also written w. Section 2 asks for x_{i-1} < x_i, which puts the followers in front of the leader, and Section 7 starts from \
             x_i = -i, behind it: the equations are the same for both orders."
        }
        "tanner2" => {
            "Sections and equations are those of the authors' preprint, which cites by author and year, not of the pages of the journal. V' is the derivative \
             with respect to s = |r_ij|^2. The velocities that are called three dimensional before (9) are those of the plane."
        }
        "tanner1" => "V' is the derivative with respect to s = |r_ij|^2.",
        _ => "",
    };
    super::notation::set(text)
}

fn erratum(site: &Site, kind: &Kind, Found { item, entries, .. }: &Found, numbers: &BTreeMap<&str, usize>) -> Markup {
    // Other items are named by their numbers.
    let rich = |text: &str| {
        let text: String =
            words(text).map(|word| numbers.get(word).map_or(word.to_string(), |k| format!("item {k}"))).collect();
        site.names.rich(&text, Links::Alone)
    };
    let several = entries.len() > 1;
    let each = |text: fn(&Entry) -> Option<&str>| {
        html! { @for e in entries { @if let Some(text) = text(e) { div { @if several { i { (e.place) ". " } } (rich(text)) } } } }
    };
    let mut places: Vec<&str> = entries.iter().map(|e| e.place.as_str()).collect();
    places.dedup();
    let lead = entries[0];
    let why = item.why.or_else(|| site.derivation(&lead.id)).filter(|text| !text.is_empty());
    html! {
        article.erratum id=(lead.id) {
            h3 { @if let Some(k) = numbers.get(lead.id.as_str()) { (k) ". " } (places.join("; ")) }
            dl {
                dt { "Printed" } dd { (each(|e| Some(&e.statement))) }
                dt { (kind.labels[0]) }
                dd { @match item.correct { Some(text) => (rich(text)), None => (each(|e| e.corrected.as_deref())) } }
                @if let Some(text) = item.fails.or(lead.counterexample.as_deref()) { dt { (kind.labels[1]) } dd { (rich(text)) } }
                @if let Some(text) = why { dt { "Why" } dd { (rich(text)) } }
                dt { "By hand" } dd { (rich(item.what)) @if !item.code.is_empty() { pre tabindex="0" { code { (item.code) } } } }
                dt { "Check" }
                dd { @for e in entries { div { a href={ "../claims/" (e.id) ".html" } { code { "flockproof explain " (e.id) } } } } }
            }
        }
    }
}
