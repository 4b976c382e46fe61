//! The longest sequences of networks until the footprint of `P(t, s)` is stable, when isolated groups may switch only
//! so often (Chazelle, (3.4)): an exact search over finitely many states.

use algebra::graph::Graph;
use algebra::matrix::Footprint;
use std::collections::BTreeMap;

/// A class of sequences of networks: while a group of `m < order` birds has no edge to another bird, the network on it
/// switches at most `most[m]` times.
#[derive(Debug, Clone)]
pub struct GroupRule {
    /// Number of birds, at most 5.
    pub order: usize,
    /// By size of the group; sizes that are not given have no limit.
    pub most: Vec<u64>,
}

/// Footprints are kept as bits of one word.
const MOST_BIRDS: usize = 5;

/// A group of birds, as bits.
type Group = u32;

/// Switches so far of each isolated group (0 for groups that are not isolated, and where there is no limit).
type Used = Vec<u64>;

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct State {
    footprint: u32,
    graph: usize,
    used: Used,
}

#[derive(Clone, Copy)]
enum Known {
    Open,
    /// The largest number of counted switches from here, `None` where nothing more is counted.
    Done(Option<u64>),
}

/// The search.
pub struct Filling {
    rule: GroupRule,
    /// Whether only switches until the last growth of the footprint count.
    until_stable: bool,
    graphs: Vec<Graph>,
    prints: Vec<Footprint>,
    groups: Vec<Group>,
    /// `isolated[g][k]`: the edges of graph `g` on group `k` as bits, `None` where the group is not isolated.
    inside: Vec<Vec<Option<u32>>>,
    known: BTreeMap<State, Known>,
}

impl Filling {
    /// The search over all sequences of a class; with `until_stable` only switches until the last growth of the
    /// footprint count, otherwise all of them. `None` for more than 5 birds.
    pub fn new(rule: GroupRule, until_stable: bool) -> Option<Self> {
        let order = rule.order;
        if order > MOST_BIRDS {
            return None;
        }
        let graphs: Vec<Graph> = Graph::all(order).collect();
        let groups: Vec<Group> = (1..(1 << order) - 1).filter(|g: &Group| g.count_ones() >= 2).collect();
        let inside = graphs.iter().map(|g| groups.iter().map(|&k| edges_inside(g, k)).collect()).collect();
        let prints = graphs.iter().map(Graph::closed_adjacency).collect();
        Some(Filling { rule, until_stable, graphs, prints, groups, inside, known: BTreeMap::new() })
    }

    /// The largest number of counted switches over all sequences of the class, `None` where there is no largest.
    pub fn longest(&mut self) -> Option<u64> {
        let mut best = 0;
        for graph in 0..self.graphs.len() {
            let start = State { footprint: to_bits(&self.prints[graph]), graph, used: vec![0; self.groups.len()] };
            best = best.max(self.from(start)?.unwrap_or(0));
        }
        Some(best)
    }

    /// `None` for unboundedly many, `Some(None)` where no counted switch can follow.
    fn from(&mut self, state: State) -> Option<Option<u64>> {
        let full = state.footprint.count_ones() as usize == self.rule.order * self.rule.order;
        if self.until_stable && full {
            return Some(None);
        }
        match self.known.get(&state) {
            Some(Known::Done(best)) => return Some(*best),
            // A cycle: every step of it is a switch, and the complete network can still make the footprint grow.
            Some(Known::Open) => return None,
            None => {}
        }
        self.known.insert(state.clone(), Known::Open);
        let mut best: Option<u64> = None;
        for graph in 0..self.graphs.len() {
            let Some(next) = self.step(&state, graph) else { continue };
            if next == state {
                continue;
            }
            let switch = u64::from(graph != state.graph);
            let grown = next.footprint != state.footprint;
            let counted = match self.from(next)? {
                Some(later) => Some(switch + later),
                None if grown || !self.until_stable => Some(switch),
                None => None,
            };
            best = best.max(counted);
        }
        self.known.insert(state, Known::Done(best));
        Some(best)
    }

    /// The state after one more network, or `None` where the class forbids it.
    fn step(&self, state: &State, graph: usize) -> Option<State> {
        let (before, after) = (&self.inside[state.graph], &self.inside[graph]);
        let mut used = Vec::with_capacity(state.used.len());
        for (k, group) in self.groups.iter().enumerate() {
            let limit = self.rule.most.get(group.count_ones() as usize);
            used.push(match (before[k], after[k], limit) {
                (Some(old), Some(new), Some(most)) => {
                    let count = state.used[k] + u64::from(old != new);
                    if count > *most {
                        return None;
                    }
                    count
                }
                // What has no limit is not counted, so that a sequence without end comes back to a state.
                _ => 0,
            });
        }
        let product = self.prints[graph].times(&from_bits(state.footprint, self.rule.order));
        Some(State { footprint: to_bits(&product), graph, used })
    }
}

fn edges_inside(graph: &Graph, group: Group) -> Option<u32> {
    let inside = |i: usize| group >> i & 1 == 1;
    let mut bits = 0;
    for (i, j) in graph.edges() {
        match (inside(i), inside(j)) {
            (true, true) => bits |= 1 << (j * (j - 1) / 2 + i),
            (false, false) => {}
            _ => return None,
        }
    }
    Some(bits)
}

fn to_bits(footprint: &Footprint) -> u32 {
    let n = footprint.rows();
    (0..n * n).filter(|&k| footprint.get(k / n, k % n)).map(|k| 1 << k).sum()
}

fn from_bits(bits: u32, n: usize) -> Footprint {
    Footprint::from_fn(n, n, |i, j| bits >> (i * n + j) & 1 == 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every network on four birds and every group of them: nothing where an edge leaves the group, else a number of its own for each
    /// network on it, and 0 for none.
    #[test]
    fn groups_are_told_apart_by_their_edges() {
        for group in 1..16u32 {
            let members: Vec<usize> = (0..4).filter(|i| group & (1 << i) != 0).collect();
            let mut numbers = BTreeMap::new();
            for graph in Graph::all(4) {
                let leaves = graph.edges().into_iter().any(|(i, j)| members.contains(&i) != members.contains(&j));
                let found = edges_inside(&graph, group);
                assert_eq!(found.is_none(), leaves, "{group:b} of {:?}", graph.edges());
                let Some(bits) = found else { continue };
                let inside = graph.induced(&members).edges();
                assert_eq!(bits == 0, inside.is_empty());
                assert_eq!(numbers.entry(bits).or_insert_with(|| inside.clone()), &inside);
            }
            // As many numbers as there are networks on the group.
            assert_eq!(numbers.len(), 1 << (members.len() * (members.len() - 1) / 2));
        }
    }

    /// Products of two networks are footprints without symmetry; each comes back from its bits, one for each entry.
    #[test]
    fn footprints_are_kept_as_bits() {
        for order in 0..=5 {
            let one = Graph::path(order).closed_adjacency();
            let other = Graph::from_fn(order, |i, j| i + 2 == j || j + 2 == i).closed_adjacency();
            for footprint in [other.times(&one), one.times(&other), one] {
                let bits = to_bits(&footprint);
                let entries = (0..order * order).filter(|k| footprint.get(k / order, k % order)).count();
                assert_eq!((from_bits(bits, order), bits.count_ones() as usize), (footprint, entries));
            }
        }
    }
}
