//! What breadth-first search tells: distances, cycles, the two sides of a bipartite graph.

use crate::graph::Graph;

/// The distances from a vertex along arcs, `out[i]` being the ends of those from `i`; `None` where there is no way.
pub fn distances(out: &[Vec<u32>], start: usize) -> Vec<Option<usize>> {
    let mut distance = vec![None; out.len()];
    let mut queue = Vec::with_capacity(out.len());
    if start < out.len() {
        distance[start] = Some(0);
        queue.push(start);
    }
    let mut next = 0;
    while let Some(&i) = queue.get(next) {
        next += 1;
        for &j in &out[i] {
            if distance[j as usize].is_none() {
                distance[j as usize] = distance[i].map(|d: usize| d + 1);
                queue.push(j as usize);
            }
        }
    }
    distance
}

impl Graph {
    /// The neighbours of every vertex.
    pub fn lists(&self) -> &[Vec<u32>] {
        &self.near
    }

    /// The length of a shortest cycle; `None` in a forest. Cost: vertices times edges.
    pub fn girth(&self) -> Option<usize> {
        // Seen from any of its vertices, a shortest cycle closes where two vertices at most one step apart in distance are joined outside the tree.
        let from = |start: usize| {
            let (mut distance, mut parent) = (vec![usize::MAX; self.order()], vec![usize::MAX; self.order()]);
            distance[start] = 0;
            let (mut queue, mut next, mut least) = (vec![start], 0, usize::MAX);
            while let Some(&i) = queue.get(next) {
                next += 1;
                for j in self.neighbours(i).iter().map(|&j| j as usize) {
                    if distance[j] == usize::MAX {
                        (distance[j], parent[j]) = (distance[i] + 1, i);
                        queue.push(j);
                    } else if parent[i] != j {
                        least = least.min(distance[i] + distance[j] + 1);
                    }
                }
            }
            least
        };
        (0..self.order()).map(from).min().filter(|&length| length < usize::MAX)
    }

    /// Whether the vertices fall into two sets without edges inside them: whether there is no odd cycle.
    pub fn is_bipartite(&self) -> bool {
        let mut side: Vec<Option<usize>> = vec![None; self.order()];
        for start in 0..self.order() {
            if side[start].is_none() {
                let reached = distances(self.lists(), start);
                side.iter_mut().zip(reached).for_each(|(own, distance)| *own = own.or(distance.map(|d| d % 2)));
            }
        }
        self.edges().iter().all(|&(i, j)| side[i] != side[j])
    }

    /// Whether all vertices have the same number of neighbours.
    pub fn is_regular(&self) -> bool {
        (1..self.order()).all(|i| self.degree(i) == self.degree(0))
    }
}
