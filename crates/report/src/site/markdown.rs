//! Notes as HTML, with links to what they name.

use super::notes::{NOTES, path};
use super::texts::Names;
use crate::page::{Links, escape};
use maud::{Markup, PreEscaped};
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html::push_html};

/// A note as HTML: headings have addresses, code that names a claim, a figure or a note is a link, and cells of tables
/// have the names of their columns, which narrow windows show beside them.
pub(super) fn markdown(text: &str, names: &Names, links: Links) -> Markup {
    let mut events: Vec<Event> = Vec::new();
    // Where the heading began that is being read, and its words.
    let mut heading: Option<(usize, String)> = None;
    // How the links end that are open.
    let mut open: Vec<Event> = Vec::new();
    let mut columns = Columns::default();
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        if let (Some((_, words)), Event::Text(text) | Event::Code(text)) = (&mut heading, &event) {
            words.push_str(text);
        }
        columns.read(&event);
        match event {
            Event::Code(code) => events.push(code_span(&code, names, links)),
            Event::Start(Tag::Heading { .. }) => {
                heading = Some((events.len(), String::new()));
                events.push(event);
            }
            Event::End(TagEnd::Heading(_)) => {
                if let Some((at, words)) = heading.take()
                    && let Some(Event::Start(Tag::Heading { id, .. })) = events.get_mut(at)
                {
                    *id = Some(CowStr::from(address(&words)));
                }
                events.push(event);
            }
            Event::Start(Tag::Table(_)) => {
                events.push(Event::Html("<div class=\"wide rows\" tabindex=\"0\">".into()));
                events.push(event);
            }
            Event::Start(Tag::TableCell) if !columns.in_head => {
                events.push(Event::Html(format!("<td data-label=\"{}\">", escape(columns.following())).into()));
            }
            Event::End(TagEnd::TableCell) if !columns.in_head => events.push(Event::Html("</td>".into())),
            Event::End(TagEnd::Table) => {
                events.push(event);
                events.push(Event::Html("</div>".into()));
            }
            Event::Start(Tag::Link { dest_url, .. }) => {
                let (before, after) = link(&dest_url, links);
                open.push(after);
                events.push(before);
            }
            Event::End(TagEnd::Link) => events.extend(open.pop()),
            Event::Start(Tag::CodeBlock(_)) => {
                events.push(Event::Html("<div class=\"wide\" tabindex=\"0\">".into()));
                events.push(event);
            }
            Event::End(TagEnd::CodeBlock) => {
                events.push(event);
                events.push(Event::Html("</div>".into()));
            }
            other => events.push(other),
        }
    }
    let mut out = String::new();
    push_html(&mut out, events.into_iter());
    PreEscaped(out)
}

/// The names of the columns of a table, as its head is read and its rows follow.
#[derive(Default)]
struct Columns {
    names: Vec<String>,
    in_head: bool,
    /// Of the cell that comes next.
    at: usize,
}

impl Columns {
    fn read(&mut self, event: &Event) {
        match event {
            Event::Start(Tag::TableHead) => (self.names, self.in_head) = (Vec::new(), true),
            Event::End(TagEnd::TableHead) => self.in_head = false,
            Event::Start(Tag::TableRow) => self.at = 0,
            Event::Start(Tag::TableCell) if self.in_head => self.names.push(String::new()),
            Event::Text(words) | Event::Code(words) if self.in_head => {
                if let Some(name) = self.names.last_mut() {
                    name.push_str(words);
                }
            }
            _ => (),
        }
    }

    /// The name of the column of the next cell of a row.
    fn following(&mut self) -> &str {
        self.at += 1;
        self.names.get(self.at - 1).map_or("", String::as_str)
    }
}

/// How a link begins and ends: to the page of a note; what else looks like one, `K[f](x)`, is text.
fn link<'a>(address: &str, links: Links) -> (Event<'a>, Event<'a>) {
    let note = address.trim_start_matches("../").trim_start_matches("notes/").strip_suffix(".md");
    let page = note.filter(|note| NOTES.contains(note)).and_then(|note| links.to(&path(note)));
    match page {
        Some(page) => (Event::InlineHtml(format!("<a href=\"{page}\">").into()), Event::InlineHtml("</a>".into())),
        None if address.contains('/') => (Event::Text("".into()), Event::Text("".into())),
        None => (Event::Text("[".into()), Event::Text(format!("]({address})").into())),
    }
}

fn code_span<'a>(code: &str, names: &Names, links: Links) -> Event<'a> {
    let with_folder = format!("notes/{code}");
    let known = |word: &str| {
        names.claims.contains(word)
            || names.figures.iter().any(|figure| figure.name == word)
            || word.starts_with("notes/")
    };
    let linked = if NOTES.iter().any(|name| with_folder == format!("notes/{name}.md")) {
        names.rich(&with_folder, links).into_string()
    } else if code.split([' ', ',']).any(known) {
        names.linked(code, links).into_string()
    } else {
        escape(code)
    };
    Event::InlineHtml(format!("<code>{linked}</code>").into())
}

/// The address of a heading: its words in small letters joined by hyphens.
fn address(heading: &str) -> String {
    let words = heading.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-").to_lowercase()
}
