//! What a scenario has in files of their own: its law, `law = "FILE"` in the place of the tables `[law]` and `[law.*]`, and its graph, `kind = "file:FILE"` in
//! the place of a text; also the graph of a platoon, `graph = "file:FILE"`.

use super::document::{line_of, parse_toml};
use super::error::{ConfigError, Problem};
use super::source::{Entry, Section, Source};
use algebra::graph::AnyGraph;

/// A scenario with its law in one text. Lines of the scenario keep their numbers; those of the law come after them.
#[derive(Debug, Clone)]
pub struct WithLaw {
    text: String,
    /// The name of the law's file, and how many lines come before it.
    law: Option<(String, usize)>,
}

/// Puts the law and the graph of files into the scenario that names them; a scenario that names none stays as it is. `read` gives the text of a file. Of the law's
/// file only the tables `[law]` and `[law.*]` count, so that another scenario can serve as one; the graph's is one of those that [`AnyGraph::read_file`] reads.
///
/// # Errors
/// [`ConfigError`], also where a file is not there or has no law or not one graph.
pub fn with_law(text: &str, read: &dyn Fn(&str) -> Result<String, String>) -> Result<WithLaw, ConfigError> {
    let text = &with_graph(text, read)?;
    let source = Source::parse(text)?;
    let top = source.top();
    let Some(entry) = law_entry(&source) else {
        return Ok(WithLaw::alone(text));
    };
    let name = entry.word()?.to_string();
    let file = read(&name).map_err(|error| entry.problem(Problem::LawFile(error)))?;
    let tables = tables_of(&file);
    parse_toml(&tables).map_err(|error| {
        let line = line_of(&tables, error.at);
        entry.problem(Problem::LawFile(format!("{name}: line {line}: {error}")))
    })?;
    if tables.trim().is_empty() {
        return Err(entry.problem(Problem::LawFile(format!("{name}: the table [law] is missing"))));
    }
    let span = top.key_and_value("law").unwrap_or_default();
    let (before, after) = (text.get(..span.start).unwrap_or(text), text.get(span.end..).unwrap_or_default());
    let own = format!("{before}{after}\n");
    let lines = own.matches('\n').count();
    Ok(WithLaw { text: own + &tables, law: Some((name, lines)) })
}

fn law_entry(source: &Source) -> Option<Entry<'_>> {
    source.top().get("law").filter(|entry| !entry.is_table())
}

/// Where a file may name a graph: of a scenario, and of a platoon whose worst cases are asked for.
const GRAPHS: [(&str, &str); 2] = [("graph", "kind"), ("platoon", "graph")];

/// The graph of a file: the table and the key where it is named, and the name.
fn graph_file<'s>(source: &'s Source) -> Option<(Section<'s>, &'static str, String)> {
    GRAPHS.into_iter().find_map(|(table, key)| {
        let section = source.section(table).ok()??;
        let name = section.get(key)?.word().ok()?.strip_prefix("file:")?.to_string();
        Some((section, key, name))
    })
}

/// The files that a scenario or a system names, as far as it can be read: of its law, of its graph.
pub fn named_files(text: &str) -> Vec<String> {
    let Ok(source) = Source::parse(text) else { return Vec::new() };
    let law = law_entry(&source).and_then(|entry| entry.word().ok().map(ToString::to_string));
    law.into_iter().chain(graph_file(&source).map(|(.., name)| name)).collect()
}

/// The text of a scenario or a system with its graph as a text in the place of a file; `read` gives the text of a file.
///
/// # Errors
/// [`ConfigError`], also where the file is not there or has not one graph.
pub fn with_graph(text: &str, read: &dyn Fn(&str) -> Result<String, String>) -> Result<String, ConfigError> {
    let source = Source::parse(text)?;
    let Some((section, key, name)) = graph_file(&source) else {
        return Ok(text.to_string());
    };
    let refused =
        |why: String| section.need(key, "").map_or_else(|error| error, |entry| entry.problem(Problem::GraphFile(why)));
    let file = read(&name).map_err(refused)?;
    let mut graphs = AnyGraph::read_file(&file, false).map_err(|error| refused(format!("{name}: {error}")))?;
    let (Some(graph), true) = (graphs.pop(), graphs.is_empty()) else {
        return Err(refused(format!("{name}: there are several graphs in it, where one is expected")));
    };
    let span = section.key_and_value(key).unwrap_or_default();
    let (before, after) = (text.get(..span.start).unwrap_or(text), text.get(span.end..).unwrap_or_default());
    Ok(format!("{before}{key} = \"{graph}\"{after}"))
}

/// The lines of the tables `[law]` and `[law.*]`, the other lines empty.
fn tables_of(text: &str) -> String {
    let mut inside = false;
    let mut kept = String::new();
    for line in text.lines() {
        let head = line.trim_start().strip_prefix('[').map(str::trim_start);
        if let Some(head) = head.filter(|head| head.starts_with(|c: char| c.is_ascii_alphabetic())) {
            let name = head.split([']', '.']).next().unwrap_or_default().trim();
            inside = name == "law";
        }
        if inside {
            kept += line;
        }
        kept.push('\n');
    }
    kept
}

impl WithLaw {
    /// A text without a law elsewhere.
    pub fn alone(text: &str) -> Self {
        WithLaw { text: text.to_string(), law: None }
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// An error of the whole text in words: with the name of the law's file where it is in there.
    pub fn told(&self, error: &ConfigError) -> String {
        let (mut error, mut name) = (error.clone(), None);
        if let (Some((file, lines)), Some(line)) = (&self.law, error.line_mut())
            && *line > *lines
        {
            *line -= lines;
            name = Some(file);
        }
        name.map_or_else(|| error.to_string(), |name| format!("{name}: {error}"))
    }
}
