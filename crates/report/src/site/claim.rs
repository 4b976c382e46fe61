//! The page of one claim.

use super::markdown::markdown;
use super::words::{fault, mark, reach, sentence, spoken};
use super::{Site, notation};
use crate::page::Links;
use crate::papers::paper;
use crate::written::written_proofs;
use ledger::{Entry, Evidence, Grade, Scope, Verdict, Witness, correction_id};
use maud::{Markup, html};
use proofs::kernel::proofs_of;

/// The contents of the page.
pub(super) fn body(site: &Site, entry: &Entry, links: Links) -> Markup {
    let rich = |text: &str| site.names.rich(text, links);
    html! {
        article.claim {
            p.crumbs {
                span { (of_paper(entry, links)) }
                @if links != Links::Alone { (neighbours(site, entry)) }
            }
            h1 { (entry.id) }
            p.place { (site.names.linked(&entry.place, links)) }
            div.two {
                div {
                    (verdict(site, entry, links))
                    section aria-labelledby="statement" {
                        h2 #statement { @if entry.paper == "beyond" { "Statement" } @else { "As printed" } }
                        blockquote.statement { p { (rich(&entry.statement)) } }
                    }
                    @if let Some(text) = &entry.reading { (section("reading", "Read as", rich(text))) }
                    @if let Some(text) = &entry.counterexample { (counterexample(site, text, &entry.witnesses, links)) }
                    @if let Some(text) = &entry.corrected { (correction(site, entry, text, links)) }
                }
                (reliability(site, entry, links))
            }
            (super::figure::of_claim(site, entry, links))
            @if links != Links::Alone { (motions(entry)) }
            @if entry.clauses.len() > 1 { (clauses(site, entry, links)) }
            @if let Some(text) = site.derivation(&entry.id).filter(|text| !text.is_empty()) {
                (section("why", "Why", rich(text)))
            }
            @if !entry.evidence.is_empty() { (evidence(site, entry, links)) }
            (proofs(site, entry, links))
            @if entry.controls.total > 0 { (controls(site, entry, links)) }
            (theorems(entry, links))
            @if !entry.values.is_empty() {
                section aria-labelledby="values" {
                    h2 #values { "Values" }
                    div.wide tabindex="0" { table.named { tbody {
                        @for (name, value) in &entry.values { tr { th scope="row" { (name) } td { code { (value) } } } }
                    } } }
                }
            }
            @if links != Links::Alone { (related(site, entry)) }
            (check(site, entry, links))
        }
    }
}

fn section(id: &str, title: &str, text: Markup) -> Markup {
    html! { section aria-labelledby=(id) { h2 id=(id) { (title) } p { (text) } } }
}

/// The sentence, and what can be drawn of it.
fn counterexample(site: &Site, text: &str, witnesses: &[Witness], links: Links) -> Markup {
    html! {
        section aria-labelledby="counterexample" {
            h2 #counterexample { "Counterexample" }
            p { (site.names.rich(text, links)) }
            (super::counterexample::drawings(site, witnesses, links))
        }
    }
}

fn of_paper(entry: &Entry, links: Links) -> Markup {
    match paper(&entry.paper) {
        Some(paper) => links.link(
            &format!("papers/{}.html", paper.key),
            html! { (paper.short) " " (paper.year) ", " i { (paper.title) } },
        ),
        None => links.link("results.html", html! { "Beyond the papers" }),
    }
}

fn neighbours(site: &Site, entry: &Entry) -> Markup {
    let entries = site.entries();
    let at = entries.iter().position(|other| other.id == entry.id).unwrap_or(0);
    let next = entries.get(at + 1);
    let last = at.checked_sub(1).and_then(|k| entries.get(k));
    html! {
        span.neighbours {
            @if let Some(e) = last { a rel="prev" href={ (e.id) ".html" } { "← " (e.id) } }
            " "
            @if let Some(e) = next { a rel="next" href={ (e.id) ".html" } { (e.id) " →" } }
        }
    }
}

fn verdict(site: &Site, entry: &Entry, links: Links) -> Markup {
    html! {
        p.verdict.(entry.verdict.word()) {
            strong { span aria-hidden="true" { (mark(entry.verdict)) } " " (spoken(entry.verdict)) } " "
            span { (sentence(entry)) }
            @if let Some(why) = &entry.why { " " span { (site.names.rich(why, links)) } }
        }
    }
}

/// The motions that show it.
fn motions(entry: &Entry) -> Markup {
    let shows = super::explore::SHOWS.iter().filter(|show| show.claims.contains(&entry.id.as_str()));
    html! { @for show in shows { p { "See it move: " a href={ "../explore/" (show.name) ".html" } { (show.title) } "." } } }
}

fn correction(site: &Site, entry: &Entry, text: &str, links: Links) -> Markup {
    let own = correction_id(&entry.id);
    html! {
        section aria-labelledby="corrected" {
            h2 #corrected { "Corrected" }
            blockquote.statement { p { (site.names.rich(text, links)) } }
            @if site.names.claims.contains(&own) { p.small { "Checked as " (site.names.rich(&own, links)) "." } }
        }
    }
}

/// What stands behind the verdict, at a glance.
fn reliability(site: &Site, entry: &Entry, links: Links) -> Markup {
    let (whole, clauses) = entry.reach();
    let guarantees = |text: Markup| links.link("guarantees.html", text);
    let axioms: std::collections::BTreeSet<&str> = proofs_of(&entry.id).map(|(t, _)| t.axioms.words()).collect();
    let axioms = axioms.into_iter().collect::<Vec<_>>().join("; ");
    html! {
        aside.reliability aria-label="Reliability" {
            h2 { "Reliability" }
            dl {
                dt { "Verdict" } dd { (spoken(entry.verdict)) }
                @if let Some(what) = entry.fault { dt { "At fault" } dd { (fault(what)) } }
                dt { "For all parameters" } dd { (whole) " of " (clauses) " clause" @if clauses != 1 { "s" } }
                @if !entry.evidence.is_empty() {
                    dt { "Grades" }
                    dd { @for (k, grade) in entry.grades().into_iter().enumerate() {
                        @if k > 0 { ", " }
                        abbr title=(grade.meaning()) { (grade.word()) }
                    } }
                }
                @if !axioms.is_empty() { dt { "Axioms in Coq" } dd { (axioms) } }
                @if entry.controls.total > 0 {
                    dt { "Negative controls" }
                    dd { (entry.controls.refuted) " of " (entry.controls.total) " refuted" }
                }
                dt { "Rests on" } dd { (guarantees(html! { "what each grade rests on" })) }
                dt { "Computed by" } dd { "flockproof " (site.document.version) ", seed " code { (site.document.seed) } }
                @if let Some(address) = links.to(&format!("data/claims/{}.json", entry.id)) {
                    dt { "Data" } dd { a href=(address) { "JSON" } }
                }
            }
        }
    }
}

fn clauses(site: &Site, entry: &Entry, links: Links) -> Markup {
    let (all, some) = (entry.covered(true), entry.covered(false));
    html! {
        section aria-labelledby="clauses" {
            h2 #clauses { "Clauses" }
            ol.clauses {
                @for (k, clause) in (1..).zip(&entry.clauses) {
                    @let how = match (all.contains(&k), some.contains(&k)) {
                        (true, _) => ("all", "for all parameters"),
                        (_, true) => ("instances", "on instances"),
                        _ => ("none", "no evidence of its own"),
                    };
                    li id={ "clause-" (k) } {
                        (site.names.rich(clause, links)) " "
                        @if let Some(Some(verdict)) = entry.clause_verdicts.get(k - 1) { (word(*verdict)) " " }
                        span.reach.(how.0) { (how.1) (covering(entry, k)) }
                    }
                }
            }
        }
    }
}

/// The grades that cover a clause.
fn covering(entry: &Entry, clause: usize) -> Markup {
    let mut grades: Vec<(Grade, bool)> = entry
        .evidence
        .iter()
        .filter(|e| e.clauses.contains(&clause))
        .map(|e| (e.grade, e.scope == Some(Scope::All)))
        .collect();
    grades.sort();
    grades.dedup_by_key(|(grade, _)| *grade);
    html! { @for (grade, _) in grades { " · " (grade.word()) } }
}

fn evidence(site: &Site, entry: &Entry, links: Links) -> Markup {
    let several = entry.clauses.len() > 1;
    let of = |e: &Evidence| e.clauses.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
    html! {
        section aria-labelledby="evidence" {
            h2 #evidence { "Evidence" }
            table.stack {
                thead { tr {
                    th scope="col" { "Grade" }
                    @if several { th scope="col" { "Clauses" } }
                    th scope="col" { "Reaches" } th scope="col" { "What was done" }
                } }
                tbody {
                    @for e in &entry.evidence { tr {
                        td.short data-label="Grade" { abbr title=(e.grade.meaning()) { (e.grade.word()) } }
                        @if several { td data-label="Clauses" { (of(e)) } }
                        td.short data-label="Reaches" { (reach(e.scope)) }
                        td {
                            @if !e.part.is_empty() { (site.names.rich(&e.part, links)) ": " }
                            (site.names.rich(&e.detail, links))
                            @if let Some(cases) = e.cases { " (" (cases) " cases)" }
                            @if let Some(bound) = &e.error_bound {
                                "; a wrong identity would pass with probability at most " (notation::set(bound))
                            }
                        }
                    } }
                }
            }
        }
    }
}

/// The proofs on paper, as the notes have them.
fn proofs(site: &Site, entry: &Entry, links: Links) -> Markup {
    let proofs = written_proofs(entry, site.texts);
    html! {
        @if !proofs.is_empty() {
            section aria-labelledby="proofs" {
                h2 #proofs { "Proof on paper" }
                @for proof in &proofs {
                    details { summary { (proof.file) } div.note { (markdown(proof.text, &site.names, links)) } }
                }
            }
        }
    }
}

fn controls(site: &Site, entry: &Entry, links: Links) -> Markup {
    let all = entry.controls.refuted == entry.controls.total;
    html! {
        section aria-labelledby="controls" {
            h2 #controls { "Negative controls" }
            p { (entry.controls.refuted) " of " (entry.controls.total) " altered variants are refuted by the same check"
                @if !all { strong { ": the verdict cannot be relied on" } } "." }
            table.stack {
                thead { tr { th scope="col" { "What is altered" } th scope="col" { "Where it fails" } } }
                tbody {
                    @for (what, failed) in entry.controls.what.iter().zip(&entry.controls.failed) {
                        tr { td data-label="Altered" { (site.names.rich(what, links)) } td data-label="Fails" { (site.names.rich(failed, links)) } }
                    }
                }
            }
        }
    }
}

fn theorems(entry: &Entry, links: Links) -> Markup {
    let mut proofs = proofs_of(&entry.id).filter_map(|(theorem, _)| Some((theorem, theorem.audited()?))).peekable();
    if proofs.peek().is_none() {
        return html! {};
    }
    html! {
        section aria-labelledby="coq" {
            h2 #coq { "In Coq" }
            @for (theorem, (audit, statement)) in proofs {
                @let path = format!("coq/{}.html#{}", theorem.file, theorem.name);
                details {
                    summary { code { (theorem.path()) } ", axioms: " (theorem.axioms.words()) }
                    pre tabindex="0" { code { (statement) } }
                    p.small {
                        "Proved in " (links.link(&path, html! { "proofs_checks/coq/" (theorem.file) ".v" }))
                        ", stated again in " (links.link(&format!("coq/{}.html", audit.name), html! { (audit.name) ".v" })) "."
                    }
                }
            }
        }
    }
}

fn related(site: &Site, entry: &Entry) -> Markup {
    let Some(ties) = site.ties.get(&entry.id) else { return html! {} };
    html! {
        section aria-labelledby="related" {
            h2 #related { "Related claims" }
            ul.related {
                @for (tie, other) in ties {
                    @if let Some(e) = site.entry(other) {
                        li { (tie.words()) " " a href={ (other) ".html" } { (other) } " " (chip(e)) " " span.small { (e.place) } }
                    }
                }
            }
        }
    }
}

/// The verdict of a claim, with those of its clauses that hold although it does not.
pub(super) fn chip(entry: &Entry) -> Markup {
    html! {
        (word(entry.verdict))
        @for k in entry.clauses_that_hold() { " " span.small { "clause " (k) " holds" } }
    }
}

/// The word of a verdict.
fn word(verdict: Verdict) -> Markup {
    html! { span.chip.(verdict.word()) { span aria-hidden="true" { (mark(verdict)) } " " (spoken(verdict)) } }
}

fn check(site: &Site, entry: &Entry, links: Links) -> Markup {
    let version = &site.document.version;
    let source = paper(&entry.paper).map(|paper| format!(" on {}, {}", paper.citation(), entry.place));
    html! {
        section aria-labelledby="check" {
            h2 #check { "Check and cite" }
            pre tabindex="0" { code {
                "flockproof verify --claim " (entry.id) "\n"
                "flockproof explain " (entry.id) "\n"
                "flockproof explain " (entry.id) " --html " (entry.id) ".html"
            } }
            p { "The flockproof developers, flockproof " (version) ", claim " (entry.id)
                @if let Some(source) = source { (source) } ". Verdict: " (spoken(entry.verdict)) "." }
            @if links != Links::Alone {
                p { a href={ "../data/claims/" (entry.id) ".json" } { "This entry as JSON" } }
            }
        }
    }
}
