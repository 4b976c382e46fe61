//! Results beyond the papers.

use super::Site;
use super::claim::chip;
use super::index::breakable;
use crate::page::Links;
use ledger::correction_id;
use maud::{Markup, html};

/// The contents of the page.
pub(super) fn body(site: &Site) -> Markup {
    let printed: std::collections::BTreeSet<String> = site.entries().iter().map(|e| correction_id(&e.id)).collect();
    let own = site.entries().iter().filter(|e| e.paper == "beyond");
    let (corrections, new): (Vec<_>, Vec<_>) = own.partition(|e| printed.contains(&e.id));
    html! {
        (site.written("results", Links::Top))
        @for (id, title, entries) in [("beyond", "Results of this project", new), ("corrections", "Corrected statements", corrections)] {
            section aria-labelledby=(id) {
                h2 id=(id) { (title) }
                table.stack.claims {
                    thead { tr { th scope="col" { "Claim" } th scope="col" { "Statement" } th scope="col" { "Verdict" } } }
                    tbody { @for e in entries { tr {
                        th scope="row" { a href={ "claims/" (e.id) ".html" } { (breakable(&e.id)) } span.place { (e.place) } }
                        td.statement { (site.names.rich(&e.statement, Links::Alone)) }
                        td data-label="Verdict" { (chip(e)) }
                    } } }
                }
            }
        }
    }
}
