//! The search for the longest sequences against all sequences of a length.

use algebra::graph::Graph;
use algebra::matrix::Footprint;
use models::averaging::{Filling, GroupRule};

/// Switches until the last growth of the footprint, the most over all sequences of `length` networks on three birds in which
/// an isolated pair switches at most `most` times.
fn by_enumeration(most: usize, length: u32) -> u64 {
    let graphs: Vec<Graph> = Graph::all(3).collect();
    let pairs = [(0, 1, 2), (0, 2, 1), (1, 2, 0)];
    let mut best = 0;
    for mut code in 0..graphs.len().pow(length) {
        let word: Vec<&Graph> = (0..length)
            .map(|_| {
                let graph = &graphs[code % graphs.len()];
                code /= graphs.len();
                graph
            })
            .collect();
        let allowed = pairs.iter().all(|&(i, j, k)| {
            let mut used = 0;
            word.windows(2).all(|two| {
                let isolated = two.iter().all(|g| !g.has_edge(i, k) && !g.has_edge(j, k));
                used = if isolated { used + usize::from(two[0].has_edge(i, j) != two[1].has_edge(i, j)) } else { 0 };
                used <= most
            })
        });
        if !allowed {
            continue;
        }
        let (mut product, mut switches) = (word[0].closed_adjacency(), 0);
        for two in word.windows(2) {
            switches += u64::from(two[0] != two[1]);
            let next: Footprint = two[1].closed_adjacency().times(&product);
            if next != product {
                best = best.max(switches);
            }
            product = next;
        }
    }
    best
}

#[test]
fn the_longest_sequences_are_those_of_an_enumeration() {
    for (most, length) in [(0, 5), (1, 6)] {
        let rule = GroupRule { order: 3, most: vec![0, 0, most] };
        let longest = Filling::new(rule, true).and_then(|mut search| search.longest());
        assert_eq!(longest, Some(by_enumeration(most as usize, length)), "N = {most}");
        assert_eq!(longest, Some(2 * most + 3));
    }
    assert!(Filling::new(GroupRule { order: 6, most: Vec::new() }, true).is_none());
}
