//! Edge lists: of one's own, and as networkx writes them.

use super::{GraphFile, GraphReadError, MOST_VERTICES, add, integer, weight};
use crate::graph::{ArcList, WeightedGraph};
use arithmetic::{Rational, rational, shown};
use std::collections::HashMap;

/// How the vertices of a file are called; the first edge decides.
enum Vertices {
    /// Not seen yet.
    Unknown,
    /// Numbers.
    Numbers,
    /// Names, numbered in the order in which they come.
    Names(HashMap<String, usize>),
}

/// Reads an edge list whose numbers start at `first`.
pub(super) fn read(text: &str, first: usize) -> Result<GraphFile, GraphReadError> {
    let mut entries = ArcList::default();
    let (mut directed, mut announced, mut largest) = (false, None, 0);
    let mut vertices = Vertices::Unknown;
    for (k, whole) in text.lines().enumerate() {
        let line = k + 1;
        let (content, data) = split(whole.split('#').next().unwrap_or_default());
        let words: Vec<&str> = content.split([' ', '\t', ',', ';', '\r']).filter(|word| !word.is_empty()).collect();
        match words[..] {
            [] if data.is_none() => {}
            ["directed"] if entries.is_empty() => directed = true,
            ["vertices", number] if entries.is_empty() => {
                announced = Some(integer(number, line, 1, MOST_VERTICES)?);
            }
            [from, to] | [from, to, _] if words.len() == 2 || data.is_none() => {
                let most = announced.unwrap_or(MOST_VERTICES);
                let mut vertex = |word: &str| vertices.number(word, line, first, most);
                let (i, j) = (vertex(from)?, vertex(to)?);
                if i == j {
                    return Err(GraphReadError::Loop { line, vertex: i });
                }
                let value = match (words.get(2), data) {
                    (Some(word), _) => weight(word, line)?,
                    (None, Some(data)) => weight_of(data, line)?,
                    (None, None) => rational(1, 1),
                };
                add(&mut entries, (i, j), value, !directed, line)?;
                largest = largest.max(i).max(j);
            }
            _ => {
                let expected = "an edge `i j [weight]` (`directed` and `vertices N` come before the edges)";
                return Err(GraphReadError::Form { line, expected, found: shown(whole.trim()) });
            }
        }
    }
    let order = announced.unwrap_or(largest);
    let labels = vertices.labels().map(|mut labels| {
        // Vertices of no edge have no name.
        labels.extend((labels.len() + 1..=order).map(|k| k.to_string()));
        labels
    });
    Ok(GraphFile { graph: WeightedGraph::from_arcs(order, entries.into_arcs()), directed, labels })
}

/// A line without the dictionary at its end, and what stands in the dictionary.
fn split(line: &str) -> (&str, Option<&str>) {
    match line.split_once('{') {
        Some((content, data)) => (content, Some(data.trim_end().trim_end_matches('}'))),
        None => (line, None),
    }
}

/// The weight in a dictionary of networkx such as `'weight': 2.5, 'colour': 'red'`; 1 where there is none.
fn weight_of(data: &str, line: usize) -> Result<Rational, GraphReadError> {
    let after = ["'weight':", "\"weight\":"].iter().find_map(|key| data.split_once(key)).map(|(_, after)| after);
    after.map_or(Ok(rational(1, 1)), |after| weight(after.split(',').next().unwrap_or_default(), line))
}

/// Whether a word is meant as a number: it begins like one, in whatever script.
fn is_number(word: &str) -> bool {
    word.trim_start_matches(['-', '+']).starts_with(char::is_numeric)
}

impl Vertices {
    /// The number of a vertex, from 1.
    fn number(&mut self, word: &str, line: usize, first: usize, most: usize) -> Result<usize, GraphReadError> {
        if let Vertices::Unknown = self {
            *self = if is_number(word) { Vertices::Numbers } else { Vertices::Names(HashMap::new()) };
        }
        match self {
            Vertices::Names(_) if is_number(word) => Err(GraphReadError::NumberAmongNames { line, found: shown(word) }),
            Vertices::Names(names) => {
                let next = names.len() + 1;
                if next > most && !names.contains_key(word) {
                    return Err(GraphReadError::TooMany { line, most });
                }
                Ok(*names.entry(word.to_string()).or_insert(next))
            }
            _ if word == "0" && first == 1 => Err(GraphReadError::ZeroBased(line)),
            _ => Ok(integer(word, line, first, most + first - 1)? + 1 - first),
        }
    }

    /// The names in their order.
    fn labels(self) -> Option<Vec<String>> {
        let Vertices::Names(names) = self else { return None };
        let mut labels = vec![String::new(); names.len()];
        names.into_iter().for_each(|(name, k)| labels[k - 1] = name);
        Some(labels)
    }
}
