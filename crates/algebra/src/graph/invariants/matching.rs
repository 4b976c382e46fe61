//! Largest matchings: Edmonds' algorithm, in which odd cycles are shrunk.

use crate::graph::Graph;
use std::collections::VecDeque;

const NONE: usize = usize::MAX;

impl Graph {
    /// Number of edges of a largest matching: of edges without common ends. Cost: the cube of the order.
    pub fn matching_number(&self) -> usize {
        let mut search = Search::new(self);
        (0..self.order()).for_each(|root| {
            if search.mate[root] == NONE {
                search.augment(root);
            }
        });
        search.mate.iter().filter(|&&mate| mate != NONE).count() / 2
    }
}

/// One search for an alternating path, with the vertex that stands for the blossom of each.
struct Search<'g> {
    graph: &'g Graph,
    mate: Vec<usize>,
    parent: Vec<usize>,
    base: Vec<usize>,
    is_even: Vec<bool>,
}

impl<'g> Search<'g> {
    fn new(graph: &'g Graph) -> Self {
        let order = graph.order();
        Search {
            graph,
            mate: vec![NONE; order],
            parent: vec![NONE; order],
            base: (0..order).collect(),
            is_even: vec![false; order],
        }
    }

    /// Makes the matching larger by a path from a vertex that is not matched, where there is one.
    fn augment(&mut self, root: usize) {
        let order = self.graph.order();
        self.parent.fill(NONE);
        self.is_even.fill(false);
        self.base = (0..order).collect();
        self.is_even[root] = true;
        let mut queue = VecDeque::from([root]);
        while let Some(v) = queue.pop_front() {
            for to in self.graph.neighbours(v).iter().map(|&to| to as usize) {
                if self.base[v] == self.base[to] || self.mate[v] == to {
                    continue;
                }
                let is_inside = to == root || (self.mate[to] != NONE && self.parent[self.mate[to]] != NONE);
                if is_inside {
                    self.shrink(v, to, &mut queue);
                } else if self.parent[to] == NONE {
                    self.parent[to] = v;
                    match self.mate[to] {
                        NONE => return self.flip(to),
                        mate => {
                            self.is_even[mate] = true;
                            queue.push_back(mate);
                        }
                    }
                }
            }
        }
    }

    /// Exchanges what is matched along the path that ends in a vertex.
    fn flip(&mut self, mut end: usize) {
        while end != NONE {
            let before = self.parent[end];
            let next = self.mate[before];
            (self.mate[end], self.mate[before]) = (before, end);
            end = next;
        }
    }

    /// The edge from `v` to `to` closes an odd cycle: all its vertices get one base.
    fn shrink(&mut self, v: usize, to: usize, queue: &mut VecDeque<usize>) {
        let base = self.common_base(v, to);
        let mut inside = vec![false; self.graph.order()];
        self.mark(v, base, to, &mut inside);
        self.mark(to, base, v, &mut inside);
        for i in 0..self.graph.order() {
            if inside[self.base[i]] {
                self.base[i] = base;
                if !self.is_even[i] {
                    self.is_even[i] = true;
                    queue.push_back(i);
                }
            }
        }
    }

    fn common_base(&self, mut a: usize, mut b: usize) -> usize {
        let mut passed = vec![false; self.graph.order()];
        loop {
            a = self.base[a];
            passed[a] = true;
            if self.mate[a] == NONE {
                break;
            }
            a = self.parent[self.mate[a]];
        }
        loop {
            b = self.base[b];
            if passed[b] {
                return b;
            }
            b = self.parent[self.mate[b]];
        }
    }

    fn mark(&mut self, mut v: usize, base: usize, mut child: usize, inside: &mut [bool]) {
        while self.base[v] != base {
            inside[self.base[v]] = true;
            inside[self.base[self.mate[v]]] = true;
            self.parent[v] = child;
            child = self.mate[v];
            v = self.parent[self.mate[v]];
        }
    }
}
