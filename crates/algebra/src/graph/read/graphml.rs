//! GraphML: nodes, edges, and the weights of edges.

use super::{GraphFile, GraphReadError, MOST_VERTICES, add, weight};
use crate::graph::{ArcList, WeightedGraph};
use arithmetic::{rational, shown};
use roxmltree::{Document, Node};
use std::collections::HashMap;

/// Reads the first graph of a file.
pub(super) fn read(text: &str) -> Result<GraphFile, GraphReadError> {
    let document = Document::parse(text).map_err(|error| {
        let (line, why) = (error.pos().row as usize, error.to_string());
        // The sentence may quote a line break.
        let on_one_line = |c: char| if c.is_control() { c.escape_default().collect() } else { c.to_string() };
        let why = why.split(" at ").next().unwrap_or_default().chars().map(on_one_line).collect();
        GraphReadError::GraphMl { line, why }
    })?;
    let line_of = |node: Node| document.text_pos_at(node.range().start).row as usize;
    let named = |name: &'static str| move |node: &Node| node.tag_name().name() == name;
    let refuse = |line: usize, why: &str| GraphReadError::GraphMl { line, why: why.to_string() };
    let root = document.root_element();
    let graph = root.children().find(named("graph")).ok_or_else(|| refuse(1, "there is no graph in it"))?;
    let weight_key = root
        .children()
        .filter(named("key"))
        .find(|key| key.attribute("attr.name") == Some("weight"))
        .and_then(|key| key.attribute("id"));
    let mut numbers: HashMap<&str, usize> = HashMap::new();
    let mut labels = Vec::new();
    for node in graph.children().filter(named("node")) {
        let line = line_of(node);
        let id = node.attribute("id").ok_or_else(|| refuse(line, "a node has no id"))?;
        if labels.len() == MOST_VERTICES {
            return Err(GraphReadError::TooMany { line, most: MOST_VERTICES });
        }
        if numbers.insert(id, labels.len() + 1).is_some() {
            return Err(refuse(line, &format!("the node `{}` is there twice", shown(id))));
        }
        labels.push(id.to_string());
    }
    let mut entries = ArcList::default();
    let directed_by_default = graph.attribute("edgedefault") == Some("directed");
    let mut any_directed = directed_by_default;
    for edge in graph.children().filter(named("edge")) {
        let line = line_of(edge);
        let end = |name: &str| {
            let id = edge.attribute(name).ok_or_else(|| refuse(line, "an edge needs a source and a target"))?;
            numbers.get(id).copied().ok_or_else(|| GraphReadError::NoNode { line, found: shown(id) })
        };
        let (from, to) = (end("source")?, end("target")?);
        if from == to {
            return Err(GraphReadError::Loop { line, vertex: from });
        }
        let data = edge.children().filter(named("data")).find(|data| data.attribute("key") == weight_key);
        let value = match data.filter(|_| weight_key.is_some()) {
            Some(data) => weight(data.text().unwrap_or_default(), line)?,
            None => rational(1, 1),
        };
        let directed = edge.attribute("directed").map_or(directed_by_default, |word| word == "true");
        any_directed |= directed;
        add(&mut entries, (from, to), value, !directed, line)?;
    }
    let graph = WeightedGraph::from_arcs(labels.len(), entries.into_arcs());
    Ok(GraphFile { graph, directed: any_directed, labels: Some(labels) })
}
