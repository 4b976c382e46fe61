//! Graphs up to the names of their vertices.

use super::Graph;

impl Graph {
    /// One connected graph of each isomorphism class, for `1 <= order <= 7` (1, 1, 2, 6, 21, 112, 853 of them).
    ///
    /// The whole orbit of each new graph is marked, so the cost is that of the classes times `order!`, plus one bit for
    /// each labelled graph.
    pub fn connected_up_to_isomorphism(order: usize) -> Vec<Graph> {
        let pairs: Vec<(usize, usize)> = (0..order).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
        let orders = permutations(order);
        let mut seen = vec![false; 1 << pairs.len()];
        let mut found = Vec::new();
        for (code, graph) in Graph::all(order).enumerate() {
            if seen[code] || !graph.is_connected() {
                continue;
            }
            let edges = graph.edges();
            for names in &orders {
                seen[edges.iter().map(|&(i, j)| pair_bit(names[i], names[j])).sum::<usize>()] = true;
            }
            found.push(graph);
        }
        found
    }

    /// A number that isomorphic graphs of the same order share and others do not: the least code among all renamings, for
    /// `order <= 7`.
    pub fn isomorphism_code(&self) -> usize {
        let edges = self.edges();
        let code = |names: &Vec<usize>| edges.iter().map(|&(i, j)| pair_bit(names[i], names[j])).sum();
        permutations(self.order()).iter().map(code).min().unwrap_or(0)
    }
}

/// The bit of a pair in the numbering of [`Graph::all`].
fn pair_bit(i: usize, j: usize) -> usize {
    1 << (i.max(j) * (i.max(j) - 1) / 2 + i.min(j))
}

/// All orders of `0..count`.
fn permutations(count: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for next in 0..count {
        // Insert the next number at every place.
        let inserted = |p: &Vec<usize>| {
            let p = p.clone();
            (0..=next).map(move |place| {
                let mut longer = p.clone();
                longer.insert(place, next);
                longer
            })
        };
        all = all.iter().flat_map(inserted).collect();
    }
    all
}
