//! Random networks as a scenario has them, and the arcs that they stand for.

use super::naive::{Arc, Links};
use crate::draws::Draws;

/// What a model allows.
#[derive(Clone, Copy)]
pub(super) struct Allowed {
    pub directed: bool,
    pub positions: bool,
    pub timed: bool,
}

/// When the links of a network with a timetable are replaced.
const AT: f64 = 0.25;

/// A section `[graph]`, and who senses whom.
#[derive(Debug)]
pub(super) struct Drawn {
    pub text: String,
    pub links: Links,
    pub directed: bool,
}

/// Arcs of agents from 1 as a list of TOML.
fn listed(arcs: &[Arc]) -> String {
    let pairs: Vec<String> = arcs.iter().map(|(k, j)| format!("[{}, {}]", k + 1, j + 1)).collect();
    format!("[{}]", pairs.join(", "))
}

fn both_ways(edges: &[Arc]) -> Vec<Arc> {
    edges.iter().flat_map(|&(k, j)| [(k, j), (j, k)]).collect()
}

/// Some of a list; in half the cases as many as there are pairs, or all, whatever the arcs are.
fn some(draws: &mut Draws, mut all: Vec<Arc>, pairs: usize) -> Vec<Arc> {
    if draws.once_in(2) {
        while all.len() > pairs {
            let place = draws.below(all.len() as u64) as usize;
            all.remove(place);
        }
        return all;
    }
    all.retain(|_| draws.once_in(2));
    all
}

/// A network of one of the kinds that are allowed.
pub(super) fn network(draws: &mut Draws, agents: usize, allowed: Allowed) -> Drawn {
    let pairs: Vec<Arc> = (0..agents).flat_map(|k| (k + 1..agents).map(move |j| (k, j))).collect();
    let fixed = |text: String, edges: Vec<Arc>| {
        let links = Links::Timed(vec![(0.0, both_ways(&edges))]);
        Drawn { text: format!("[graph]\n{text}\n"), links, directed: false }
    };
    let apart =
        |offset: usize| pairs.iter().copied().filter(move |&(k, j)| [offset, agents - offset].contains(&(j - k)));
    let switching =
        |text: String, links: Links, directed: bool| Drawn { text: format!("[graph]\n{text}\n"), links, directed };
    match draws.below(9) {
        1 => fixed("kind = \"path\"".to_string(), pairs.iter().copied().filter(|(k, j)| j - k == 1).collect()),
        2 if agents > 2 => fixed("kind = \"ring\"".to_string(), apart(1).collect()),
        3 if agents > 1 => {
            let offset = draws.between(1, agents - 1);
            fixed(format!("kind = \"circulant\"\noffsets = [{offset}]"), apart(offset).collect())
        }
        4 if allowed.positions => {
            let eighths = draws.between(6, 20);
            let radius = eighths as f64 / 8.0;
            switching(format!("kind = \"within\"\nradius = \"{eighths}/8\""), Links::Within(radius), false)
        }
        5 if allowed.positions && allowed.directed && agents > 1 => {
            let count = draws.between(1, agents - 1);
            switching(format!("kind = \"nearest\"\nnearest = {count}"), Links::Nearest(count), true)
        }
        6..9 => edges(draws, agents, pairs, allowed),
        _ => fixed("kind = \"complete\"".to_string(), pairs),
    }
}

/// A list of edges or arcs, which may be replaced by another one.
fn edges(draws: &mut Draws, agents: usize, pairs: Vec<Arc>, allowed: Allowed) -> Drawn {
    let directed = allowed.directed && !draws.once_in(3);
    let all = if directed { both_ways(&pairs) } else { pairs.clone() };
    let first = some(draws, all.clone(), pairs.len());
    let mut text = format!("[graph]\nkind = \"edges\"\ndirected = {directed}\nedges = {}\n", listed(&first));
    let arcs = |list: Vec<Arc>| if directed { list } else { both_ways(&list) };
    let mut links = vec![(0.0, arcs(first))];
    if allowed.timed && agents > 1 && draws.once_in(4) {
        let second = some(draws, all, pairs.len());
        text += &format!("switches = [{{ at = {AT}, edges = {} }}]\n", listed(&second));
        links.push((AT, arcs(second)));
    }
    Drawn { text, links: Links::Timed(links), directed }
}
