//! Answers to a user's own questions as pieces of a page: for the live pages, and for pages that stand alone in a file.
//!
//! Each function returns HTML without a frame; [`page`] puts one around it, with all that it needs in the same file.

mod flock;
mod graph;
mod pattern;
mod platoon;
mod question;
mod reach;
mod simulation;
mod tube;

pub use flock::flock;
pub(crate) use graph::network;
pub use graph::spectrum;
pub use pattern::{PatternError, PatternRow, patterns};
pub use platoon::PlatoonError;
pub use platoon::resonance;
pub use question::question;
pub use reach::{reach, worst_cases};
pub use simulation::simulation;
pub use tube::tubes;

use crate::page::player::Motion;
use crate::page::{Frame, Links};
use crate::plot::Picture;
use arithmetic::{Interval, decimals};
use maud::{Markup, PreEscaped, html};
use motion::sets::Verdict;

/// A page of its own: its title, the command that makes it again, and what is shown.
pub fn page(title: &str, command: &str, shown: &str) -> String {
    let body = html! { h1 { (title) } (PreEscaped(shown)) };
    Frame { links: Links::Alone, title, version: crate::version(), command, class: "shown" }.around(&body)
}

/// One of several answers on a page, under a heading of its own.
pub fn part(title: &str, shown: &str) -> String {
    html! { section aria-label=(title) { h2 { (title) } (PreEscaped(shown)) } }.into_string()
}

/// What a checker says of a certificate: its kind and the sentence that is certified, or the line and the reason of a refusal.
pub fn certificate(said: &Result<(&str, String), (usize, String)>) -> String {
    let shown = match said {
        Ok((kind, claim)) => html! {
            (verdict("holds", "✓", "accepted", &format!("A certificate of kind {kind}. It shows:")))
            blockquote.statement { p { (claim) } }
        },
        Err((line, reason)) => verdict("false", "✗", "refused", &format!("Line {line}: {reason}.")),
    };
    shown.into_string()
}

/// The verdict on a statement about a set of motions.
fn decided(found: Verdict, sentence: &str) -> Markup {
    let (class, mark) = match found {
        Verdict::Holds => ("holds", "✓"),
        Verdict::False => ("false", "✗"),
        Verdict::Undecided => ("undecided", "?"),
        Verdict::Withheld => ("not_checkable", "–"),
    };
    verdict(class, mark, found.word(), sentence)
}

/// A verdict in one sentence; `class` is that of a verdict of the ledger.
fn verdict(class: &str, mark: &str, word: &str, sentence: &str) -> Markup {
    html! { p.verdict.(class) { strong { span aria-hidden="true" { (mark) } " " (word) } " " span { (sentence) } } }
}

/// A picture with its text as text. `name` tells it from others on the same page.
fn picture(picture: &Picture, name: &str, about: &str) -> Markup {
    html! { figure.shown { (drawing(picture, name, about)) figcaption { (about) } } }
}

/// The same without a sentence below it.
pub(crate) fn drawing(picture: &Picture, name: &str, about: &str) -> Markup {
    // Names of clipped parts are those of the whole page.
    let svg = picture
        .svg()
        .replace("id=\"panel", &format!("id=\"{name}-panel"))
        .replace("url(#panel", &format!("url(#{name}-panel"));
    html! { div.picture role="img" aria-label=(about) tabindex="0" { (PreEscaped(svg)) } }
}

/// A motion that can be played.
fn played(motion: &Motion, about: &str) -> Markup {
    html! { section.live aria-label=(motion.title) { (motion.section(about)) } p.small { (about) } }
}

/// A table of numbers.
fn table(name: &str, head: &[&str], rows: &[Vec<String>]) -> Markup {
    html! {
        div.wide tabindex="0" role="region" aria-label=(name) { table.numbers {
            thead { tr { @for cell in head { th scope="col" { (cell) } } } }
            tbody { @for row in rows { tr { @for (k, (label, cell)) in head.iter().zip(row).enumerate() {
                @if k == 0 { th scope="row" data-label=(label) { (cell) } } @else { td data-label=(label) { (cell) } }
            } } } }
        } }
    }
}

/// An enclosure with so many digits: one number where both ends are the same.
fn enclosed(x: &Interval, digits: u32) -> String {
    let (lo, hi) = decimals(x, digits);
    if lo == hi { lo } else { format!("[{lo}, {hi}]") }
}
