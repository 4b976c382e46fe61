//! The site: a page for each claim, paper and note, as bytes. It writes no files; the command `report` does.

mod by_hand;
mod claim;
mod coq;
mod counterexample;
mod errata;
mod explore;
mod figure;
mod glossary;
mod graph;
mod index;
mod laws;
mod markdown;
mod notation;
mod notes;
mod paper;
mod related;
mod results;
mod texts;
mod words;

use crate::figures::Figure;
use crate::file::File;
use crate::page::player::{Motion, PLAYER};
use crate::page::{Frame, Links, Page, SCRIPT, STYLE};
use crate::papers::papers;
use crate::provenance::Provenance;
use ledger::{Document, Entry, Ledger};
use maud::{Markup, html};
use proofs::kernel::{files, theorems};
use related::Ties;
use serde_json::json;
use std::collections::BTreeMap;
use texts::Names;

/// The command that makes the whole site again.
const COMMAND: &str = "flockproof report --out DIR";

/// A figure with what came of it.
#[derive(Debug, Clone)]
pub struct Made {
    /// Which it is.
    pub figure: &'static Figure,
    /// What it says.
    pub text: String,
    /// Its files.
    pub files: Vec<File>,
}

/// Why a page could not be made.
pub type SiteError = explore::RunsError;

/// The text of a file by its path in the repository, `notes/results.md`; none of another.
pub type Texts = fn(&str) -> Option<&'static str>;

/// What pages are made of.
pub struct Site<'a> {
    document: &'a Document<'a>,
    ledger: &'a Ledger,
    figures: &'a [Made],
    texts: Texts,
    names: Names,
    ties: Ties,
    places: BTreeMap<&'a str, usize>,
}

impl<'a> Site<'a> {
    /// A site of this ledger, with the figures that were made; `ledger` holds the arguments behind the claims, `texts` the files
    /// of [`Site::shown`].
    pub fn new(document: &'a Document<'a>, ledger: &'a Ledger, figures: &'a [Made], texts: Texts) -> Self {
        let entries: &'a [Entry] = &document.claims;
        let names = Names {
            claims: entries.iter().map(|entry| entry.id.clone()).collect(),
            theorems: theorems().iter().filter(|theorem| theorem.is_checked()).collect(),
            figures: figures.iter().map(|made| made.figure).collect(),
        };
        let ties = related::ties(entries, &names, |id| ledger.derivation(id));
        let places = entries.iter().enumerate().map(|(k, entry)| (entry.id.as_str(), k)).collect();
        Site { document, ledger, figures, texts, names, ties, places }
    }

    /// The files whose texts stand on pages, by their paths in the repository.
    pub fn shown() -> impl Iterator<Item = String> {
        let notes = notes::NOTES.iter().map(|name| format!("notes/{name}.md"));
        notes.chain(explore::FILES.iter().map(ToString::to_string)).chain(laws::files().map(ToString::to_string))
    }

    fn entries(&self) -> &[Entry] {
        &self.document.claims
    }

    fn entry(&self, id: &str) -> Option<&Entry> {
        self.places.get(id).and_then(|k| self.entries().get(*k))
    }

    fn derivation(&self, id: &str) -> Option<&str> {
        self.ledger.derivation(id)
    }

    /// Every file of the site.
    ///
    /// # Errors
    /// [`SiteError`] where a motion cannot be computed.
    pub fn pages(&self) -> Result<Vec<Page>, SiteError> {
        let mut pages = vec![Page::new("site.css", STYLE), Page::new("site.js", SCRIPT)];
        pages.push(self.top("index.html", "flockproof", "index", &index::body(self)));
        pages.push(self.top("results.html", "Results", "note", &results::body(self)));
        pages.push(self.top("guarantees.html", "Guarantees", "note", &self.note("guarantees", Links::Top)));
        pages.push(self.top("graph.html", "Graph", "graphs", &graph::body(self)));
        pages.push(self.top("glossary.html", "Symbols", "glossary", &glossary::body()));
        pages.push(self.inner("papers/index.html", "Papers", "papers", &paper::list(self)));
        pages.push(self.inner("errata/index.html", "Errata", "papers", &errata::list(self)));
        for paper in papers() {
            pages.push(self.inner(
                &format!("papers/{}.html", paper.key),
                paper.title,
                "paper",
                &paper::body(self, paper),
            ));
            let title = format!("Errata: {}", paper.title);
            pages.push(self.inner(&format!("errata/{}.html", paper.key), &title, "errata", &errata::body(self, paper)));
        }
        pages.push(Page::new("explore.js", PLAYER));
        pages.push(Page::new("live.js", explore::ASKER));
        for live in explore::LIVE {
            let body = explore::live(live, self.texts)?;
            pages.push(self.inner(&format!("explore/{}.html", live.name), live.title, "live", &body));
        }
        let mut pictures = Vec::new();
        for show in explore::SHOWS {
            let runs = show.motions()?;
            pictures.extend(runs.first().map(Motion::thumbnail));
            let body = explore::body(self, show, &runs);
            pages.push(self.inner(&format!("explore/{}.html", show.name), show.title, "explore", &body));
        }
        pages.push(self.inner("explore/index.html", "Explore", "explore", &explore::list(&pictures, self.texts)?));
        let mut listed = Vec::new();
        for law in laws::LAWS {
            if let Some(shown) = laws::body(law, self.texts)? {
                pages.push(self.inner(&format!("laws/{}.html", law.name), &shown.title, "explore", &shown.body));
                listed.push((law, shown));
            }
        }
        pages.push(self.inner("laws/index.html", "Laws", "explore", &laws::list(&listed)));
        for name in notes::NOTES.iter().filter(|name| !["guarantees", "results"].contains(name)) {
            let (path, title) = (format!("notes/{name}.html"), notes::title(self.text(name)));
            pages.push(self.inner(&path, title, "note", &self.note(name, Links::Folder)));
        }
        for file in files() {
            pages.push(self.inner(&format!("coq/{}.html", file.name), file.name, "coq", &coq::body(file)));
        }
        for entry in self.entries() {
            pages.push(Page::new(format!("claims/{}.html", entry.id), self.claim(entry, Links::Folder)));
            pages.push(Page::new(format!("data/claims/{}.json", entry.id), self.json(entry)));
        }
        pages.push(Page::new("data/ledger.json", self.data()));
        let files = self.figures.iter().flat_map(|made| &made.files);
        pages.extend(files.map(|file| Page::new(format!("figures/{}", file.name), file.contents.clone())));
        Ok(pages)
    }

    /// The page of one claim by itself, with all that it needs in one file.
    pub fn alone(&self, id: &str) -> Option<String> {
        self.entry(id).map(|entry| self.claim(entry, Links::Alone))
    }

    fn claim(&self, entry: &Entry, links: Links) -> String {
        let command = match links {
            Links::Alone => format!("flockproof explain {0} --html {0}.html", entry.id),
            _ => COMMAND.to_string(),
        };
        let (title, version) = (entry.id.as_str(), self.document.version.as_ref());
        Frame { links, title, version, command: &command, class: "claim" }.around(&claim::body(self, entry, links))
    }

    fn note(&self, name: &str, links: Links) -> Markup {
        html! { article.note { (self.written(name, links)) } }
    }

    /// The text of a note, set.
    fn written(&self, name: &str, links: Links) -> Markup {
        markdown::markdown(self.text(name), &self.names, links)
    }

    /// The text of a note as it stands in its file.
    fn text(&self, name: &str) -> &'static str {
        (self.texts)(&format!("notes/{name}.md")).unwrap_or_default()
    }

    fn top(&self, path: &str, title: &str, class: &str, body: &Markup) -> Page {
        self.page(Links::Top, path, title, class, body)
    }

    fn inner(&self, path: &str, title: &str, class: &str, body: &Markup) -> Page {
        self.page(Links::Folder, path, title, class, body)
    }

    fn page(&self, links: Links, path: &str, title: &str, class: &str, body: &Markup) -> Page {
        let version = self.document.version.as_ref();
        Page::new(path, Frame { links, title, version, command: COMMAND, class }.around(body))
    }

    /// One entry as JSON with where it comes from, without its time.
    fn json(&self, entry: &Entry) -> String {
        let full = self.document.more.get("configuration").and_then(|c| c.get("full")).cloned().unwrap_or(false.into());
        let (version, seed) = (self.document.version.as_ref(), self.document.seed.as_ref());
        let configuration = json!({"command": "verify", "paper": [], "claim": [entry.id], "full": full, "seed": seed});
        let provenance = Provenance::new("flockproof.claim/1", Some(seed), configuration);
        let entry = Entry { seconds: 0.0, ..entry.clone() };
        // Strings, numbers and lists only: this cannot fail.
        let mut document = provenance.stamp(serde_json::to_value(&entry).unwrap_or_default());
        document["version"] = version.into();
        format!("{document:#}\n")
    }

    /// The ledger without its times, so that two runs give the same bytes.
    fn data(&self) -> String {
        let mut document = self.document.clone();
        for entry in document.claims.to_mut() {
            entry.seconds = 0.0;
        }
        document.json()
    }
}
