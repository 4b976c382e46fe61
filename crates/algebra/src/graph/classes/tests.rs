//! Classes against all labelled graphs.

use super::*;
use arithmetic::Unwatched;

struct Stopped;

impl Progress for Stopped {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn each_class_of_graphs_comes_once() {
    for order in 0..=5 {
        let found = graphs(order, &Unwatched).expect("not stopped");
        let mut codes: Vec<_> = found.iter().map(Graph::isomorphism_code).collect();
        codes.sort();
        let mut all: Vec<_> = Graph::all(order).map(|graph| graph.isomorphism_code()).collect();
        all.sort();
        all.dedup();
        assert_eq!(codes, all, "{order}");
        assert!(found.iter().all(|graph| graph.order() == order));
        assert!(found.windows(2).all(|pair| pair[0].edges().len() <= pair[1].edges().len()));
        let connected = connected_graphs(order, &Unwatched).expect("not stopped");
        assert_eq!(connected.len(), found.iter().filter(|graph| graph.is_connected()).count());
        assert_eq!(connected.len(), if order == 0 { 0 } else { Graph::connected_up_to_isomorphism(order).len() });
    }
    assert_eq!(graphs(6, &Unwatched).map(|found| found.len()), Ok(156));
    assert_eq!(graphs(7, &Unwatched).map(|found| found.len()), Ok(1044));
    assert_eq!(graphs(10, &Unwatched), Ok(Vec::new()));
    assert_eq!(graphs(3, &Stopped), Err(Cancelled));
}

/// The least renaming of a digraph.
fn least(order: usize, arcs: &[(usize, usize)]) -> Vec<(usize, usize)> {
    let renamed = |names: &Vec<usize>| {
        let mut list: Vec<(usize, usize)> = arcs.iter().map(|&(i, j)| (names[i], names[j])).collect();
        list.sort();
        list
    };
    orders(order).iter().map(renamed).min().unwrap_or_default()
}

fn orders(count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let put = |order: Vec<usize>| {
        (0..count).map(move |at| [&order[..at], &[count - 1], &order[at..]].concat()).collect::<Vec<_>>()
    };
    orders(count - 1).into_iter().flat_map(put).collect()
}

#[test]
fn each_class_of_digraphs_comes_once() {
    for order in 1..=3 {
        let arcs = |graph: &WeightedGraph| graph.adjacency().entries().map(|(i, j, _)| (i, j)).collect::<Vec<_>>();
        let found = digraphs(order, &Unwatched).expect("not stopped");
        assert!(found.iter().all(|graph| graph.adjacency().entries().all(|(_, _, x)| *x == rational(1, 1))));
        let mut names: Vec<_> = found.iter().map(|graph| least(order, &arcs(graph))).collect();
        names.sort();
        let places: Vec<(usize, usize)> =
            (0..order).flat_map(|i| (0..order).map(move |j| (i, j))).filter(|(i, j)| i != j).collect();
        let chosen = |code: usize| {
            let kept = places.iter().enumerate().filter(|(k, _)| code >> k & 1 == 1);
            least(order, &kept.map(|(_, &arc)| arc).collect::<Vec<_>>())
        };
        let mut all: Vec<_> = (0..1usize << places.len()).map(chosen).collect();
        all.sort();
        all.dedup();
        assert_eq!(names, all, "{order}");
    }
    assert_eq!(digraphs(4, &Unwatched).map(|found| found.len()), Ok(218));
    assert_eq!(digraphs(6, &Unwatched), Ok(Vec::new()));
    assert_eq!(digraphs(3, &Stopped), Err(Cancelled));
}

#[test]
fn each_class_of_trees_comes_once() {
    for order in 1..=6 {
        let found = trees(order, &Unwatched).expect("not stopped");
        assert!(
            found.iter().all(|tree| tree.order() == order && tree.is_connected() && tree.edges().len() + 1 == order)
        );
        let mut codes: Vec<_> = found.iter().map(Graph::isomorphism_code).collect();
        codes.sort();
        codes.dedup();
        assert_eq!(codes.len(), found.len());
    }
    let counts = [0, 1, 1, 1, 2, 3, 6, 11, 23, 47, 106];
    for (order, count) in counts.into_iter().enumerate() {
        assert_eq!(trees(order, &Unwatched).map(|found| found.len()), Ok(count));
    }
    assert_eq!(trees(19, &Unwatched), Ok(Vec::new()));
    assert_eq!(trees(4, &Stopped), Err(Cancelled));
}

/// From every vertex that could be the first: depths of a walk, and the parents that they give.
#[test]
fn depths_of_trees_do_not_depend_on_the_names() {
    assert_eq!(parents(&[0, 1, 2, 2, 1, 2]), [0, 0, 1, 1, 0, 4]);
    // A path of four from an end and from the middle, and a star.
    assert_eq!(canonical_depths(&[0, 0, 1, 2]), [0, 1, 2, 1]);
    assert_eq!(canonical_depths(&[0, 0, 0, 1]), [0, 1, 2, 1]);
    assert_eq!(canonical_depths(&[0, 0, 1, 1, 1]), [0, 1, 1, 1, 1]);
    assert_eq!(canonical_depths(&[0]), [0]);
    assert_eq!(canonical_depths(&[0, 0]), [0, 1]);
    // Two centres, of which one has three neighbours: the larger list of the two.
    assert_eq!(canonical_depths(&[0, 0, 0, 0, 1]), [0, 1, 2, 2, 1]);
}

/// Codes of renamed digraphs are equal, and those of digraphs that are not isomorphic are not.
#[test]
fn codes_are_those_of_the_class() {
    let order = 4;
    let mut known = std::collections::BTreeMap::new();
    for code in (0..1usize << 16).step_by(37) {
        // Without loops.
        let out: Vec<u16> = (0..order).map(|i| (code >> (4 * i) & 15 & !(1 << i)) as u16).collect();
        let arcs: Vec<(usize, usize)> = (0..order).flat_map(|i| bits(out[i]).map(move |j| (i, j))).collect();
        let found = Arcs::new(out).code();
        assert_eq!(*known.entry(least(order, &arcs)).or_insert(found), found);
        let again = Arcs::from_code(order, found);
        let again: Vec<(usize, usize)> =
            (0..order).flat_map(|i| bits(again.out[i]).map(move |j| (i, j)).collect::<Vec<_>>()).collect();
        assert_eq!(least(order, &again), least(order, &arcs));
    }
    let different: BTreeSet<u128> = known.values().copied().collect();
    assert_eq!(different.len(), known.len());
}

#[test]
fn twins_keys_and_joins() {
    // 0 -> 1, 0 -> 2, 1 -> 2: and 3, joined from 0 and 1, to 2.
    let small = Arcs::new(vec![0b110, 0b100, 0]);
    assert_eq!(small.into, [0, 0b001, 0b011]);
    let joined = small.joined(0b100, 0b011);
    assert_eq!((joined.out, joined.into), (vec![0b1110, 0b1100, 0, 0b0100], vec![0, 0b0001, 0b1011, 0b0011]));
    assert_eq!((small.count(), [0, 1, 2].map(|v| small.degree(v))), (3, [2, 2, 2]));
    assert_eq!([0, 1, 2].map(|v| small.key(v)), [(2, 2, 4), (2, 1, 4), (2, 0, 4)]);
    assert!(!small.last_is_largest() && Arcs::new(vec![0b100, 0b100, 0b011]).last_is_largest());
    let star = Arcs::new(vec![0b1110, 0, 0b0010, 0b0010]);
    assert!(star.are_twins(2, 3) && !star.are_twins(1, 2) && !star.are_twins(0, 1));
    // Joined to each other both ways, and one way.
    assert!(Arcs::new(vec![0b10, 0b01]).are_twins(0, 1) && !Arcs::new(vec![0b10, 0]).are_twins(0, 1));
    assert_eq!(bits(0b1010_0001).collect::<Vec<_>>(), [0, 5, 7]);
}
