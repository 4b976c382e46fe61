//! The files of the Coq development as pages, with an address for each theorem of the table.

use crate::page::{Links, escape};
use maud::{Markup, PreEscaped, html};
use proofs::kernel::{Source, theorems};

/// The contents of the page of a file.
pub(super) fn body(file: &Source) -> Markup {
    let named: Vec<&str> = theorems().iter().filter(|t| t.file == file.name).map(|t| t.name).collect();
    let mut seen = std::collections::BTreeSet::new();
    let mut text = String::new();
    for line in file.text.lines() {
        let name = stated(line).filter(|name| named.contains(name) && seen.insert(*name));
        match name {
            Some(name) => text.push_str(&format!("<mark id=\"{}\">{}</mark>\n", escape(name), escape(line))),
            None => text.push_str(&(escape(line) + "\n")),
        }
    }
    html! {
        h1 { (file.name) ".v" }
        p { "proofs_checks/coq/" (file.name) ".v" @if !file.needs.is_empty() { ", which needs "
            @for (k, need) in file.needs.iter().enumerate() { @if k > 0 { ", " } (Links::Folder.link(&format!("coq/{need}.html"), html! { (need) })) } } "." }
        p.small { "SHA-256 with what it needs: " code.digest { (file.digest) } ". Checked by " code { "flockproof prove" } "." }
        pre.source tabindex="0" { (PreEscaped(text)) }
    }
}

/// The name that a line states.
fn stated(line: &str) -> Option<&str> {
    let kinds = ["Theorem ", "Lemma ", "Corollary ", "Proposition ", "Fact ", "Remark "];
    let rest = kinds.iter().find_map(|kind| line.trim_start().strip_prefix(kind))?;
    Some(&rest[..rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '\'')).unwrap_or(rest.len())])
}
