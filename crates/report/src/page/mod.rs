//! What is around the contents of every page, of the site and alone in a file; `player` shows motions in them.

pub(crate) mod player;

use maud::{DOCTYPE, Markup, PreEscaped, html};

pub(crate) const STYLE: &str = include_str!("site.css");
pub(crate) const SCRIPT: &str = include_str!("site.js");

/// A file of the site.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Page {
    /// Where it goes, with `/` between folders.
    pub path: String,
    /// Its contents.
    pub contents: Vec<u8>,
}

impl Page {
    pub(crate) fn new(path: impl Into<String>, contents: impl Into<Vec<u8>>) -> Self {
        Page { path: path.into(), contents: contents.into() }
    }
}

/// A text in HTML, as it is.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Where links lead.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Links {
    /// To the pages of the site, from a page at its top.
    Top,
    /// From a page in a folder.
    Folder,
    /// Nowhere: the page stands alone in a file.
    Alone,
}

impl Links {
    /// The address of a page of the site.
    pub fn to(self, path: &str) -> Option<String> {
        match self {
            Links::Top => Some(path.to_string()),
            Links::Folder => Some(format!("../{path}")),
            Links::Alone => None,
        }
    }

    /// A link, or its text where there is nowhere to go.
    pub fn link(self, path: &str, text: Markup) -> Markup {
        match self.to(path) {
            Some(address) => html! { a href=(address) { (text) } },
            None => text,
        }
    }
}

/// A page: its title, the links it has, and the commands that make it again.
pub(crate) struct Frame<'a> {
    pub links: Links,
    pub title: &'a str,
    /// The version of the program that made the ledger.
    pub version: &'a str,
    pub command: &'a str,
    /// A word for the style sheet.
    pub class: &'a str,
}

/// The pages that every page leads to.
const MENU: [(&str, &str); 8] = [
    ("index.html", "Claims"),
    ("papers/index.html", "Papers"),
    ("errata/index.html", "Errata"),
    ("results.html", "Results"),
    ("explore/index.html", "Explore"),
    ("laws/index.html", "Laws"),
    ("graph.html", "Graph"),
    ("guarantees.html", "Guarantees"),
];

impl Frame<'_> {
    /// The whole document.
    pub fn around(&self, body: &Markup) -> String {
        let alone = self.links == Links::Alone;
        let title =
            if self.title == "flockproof" { self.title.to_string() } else { format!("{} · flockproof", self.title) };
        let document = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    meta name="generator" content={ "flockproof " (env!("CARGO_PKG_VERSION")) };
                    title { (title) }
                    link rel="icon" href="data:,";
                    @match self.links.to("site.css") {
                        Some(address) => link rel="stylesheet" href=(address);,
                        None => style { (PreEscaped(STYLE)) },
                    }
                    @if let Some(address) = self.links.to("site.js") { script src=(address) defer {} }
                }
                body class=(self.class) {
                    a.skip href="#contents" { "Skip to the contents" }
                    header.top {
                        @if alone { span.brand { "flockproof" } } @else {
                            a.brand href=(self.links.to("index.html").unwrap_or_default()) { "flockproof" }
                            nav aria-label="Pages" {
                                @for (path, name) in MENU { (self.links.link(path, html! { (name) })) }
                            }
                        }
                    }
                    main id="contents" tabindex="-1" { (body) }
                    footer {
                        p {
                            "flockproof " (self.version) ". Made again by " code { (self.command) } "."
                            @if !alone {
                                " " (self.links.link("glossary.html", html! { "Symbols" })) " · "
                                (self.links.link("guarantees.html", html! { "What a verdict promises" })) " · "
                                (self.links.link("data/ledger.json", html! { "The ledger as JSON" }))
                            }
                        }
                    }
                }
            }
        };
        let mut text = document.into_string();
        if alone {
            let player = if text.contains("class=\"live\"") { player::PLAYER } else { "" };
            let script = format!("<script>{SCRIPT}{player}</script></body>");
            text = text.replacen("</body>", &script, 1);
        }
        text + "\n"
    }
}
