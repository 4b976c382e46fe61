//! What is seen of a run beside its network, against products of all factors from the given time on.

use algebra::graph::Graph;
use algebra::matrix::{Footprint, Stabiliser, StochasticMatrix, stabilisers, tau_2_squared};
use arithmetic::{Unwatched, rational};
use models::averaging::{Observer, Weights, transition_matrix};

/// Nine networks on four birds, of which the last ones change nothing more.
fn networks() -> Vec<Graph> {
    let of = |edges: &[(usize, usize)]| Graph::from_edges(4, edges).unwrap();
    let (a, b, c) = (of(&[(0, 1)]), of(&[(1, 2), (0, 3)]), of(&[(2, 3), (0, 1)]));
    vec![c.clone(), a.clone(), of(&[]), b.clone(), a.clone(), c.clone(), b, c, a]
}

#[test]
fn what_is_seen_is_that_of_the_products() {
    let weights = Weights::Vicsek;
    for from in [0u64, 1, 2, 4] {
        let start = from.max(1);
        let mut observer = Observer::new(4, from, true);
        let mut without = Observer::new(4, from, false);
        assert_eq!((observer.from(), observer.footprint()), (start, None));
        let (mut product, mut factors): (Option<StochasticMatrix>, Vec<Footprint>) = (None, Vec::new());
        let mut known = Vec::new();
        for (time, network) in (1..).zip(networks()) {
            observer.push(time, &network, &weights, &Unwatched).unwrap();
            without.push(time, &network, &weights, &Unwatched).unwrap();
            if time < start {
                assert_eq!(observer.footprint(), None);
                continue;
            }
            let factor = StochasticMatrix::try_from(&transition_matrix(&network, &weights).unwrap()).unwrap();
            let next = product.as_ref().map_or_else(|| factor.clone(), |before| factor.times(before).unwrap());
            factors.push(network.closed_adjacency());
            assert_eq!(observer.footprint(), Some(&next.footprint()));
            assert_eq!(without.footprint(), Some(&next.footprint()));
            let shifted = |s: Stabiliser| Stabiliser { time: s.time + (start as usize) - 1, ..s };
            let all: Vec<_> = stabilisers(&factors).into_iter().take(8).map(shifted).collect();
            assert_eq!((observer.stabilisers(), without.stabilisers()), (all.clone(), all), "{from} {time}");
            if [1, 2, 4, 8].contains(&(time - start + 1)) {
                let spread = tau_2_squared(&next.to_rational_matrix());
                known.push((time, next.tau_1(), spread, next.denominator().bits()));
            }
            product = Some(next);
        }
        let found = observer.decay().iter();
        let found = found.map(|d| (d.time, d.tau_1.clone(), d.tau_2_squared.clone(), d.denominator_bits));
        let found: Vec<_> = found.collect();
        assert!(found.len() > 2 && without.decay().is_empty());
        assert_eq!(found, known);
    }
    // Weights that do not suit the network.
    let few = Weights::Given(vec![rational(1, 3); 2]);
    assert!(Observer::new(4, 1, true).push(1, &networks()[0], &few, &Unwatched).is_err());
}

/// The first bird without a weight is told; the first and the last bird count where weights are asked whether they suit.
#[test]
fn weights_of_all_birds_count() {
    let path = Graph::path(3);
    let given = |c: [(i64, i64); 3]| Weights::Given(c.map(|(p, q)| rational(p, q)).to_vec());
    let few = Weights::Given(vec![rational(1, 3)]).all(&path);
    assert_eq!(few, Err(algebra::matrix::MatrixError::EntryCount { rows: 3, cols: 1, found: 1 }));
    assert!(given([(1, 2), (1, 3), (1, 2)]).are_admissible(&path));
    assert!(!given([(1, 1), (1, 3), (1, 2)]).are_admissible(&path));
    assert!(!given([(1, 2), (1, 2), (1, 2)]).are_admissible(&path));
    assert!(!given([(1, 2), (1, 3), (0, 1)]).are_admissible(&path));
}

/// The clock of the run may stand at its end.
#[test]
fn stabilisers_of_the_last_time_have_times() {
    let mut observer = Observer::new(3, u64::MAX, false);
    observer.push(u64::MAX, &Graph::path(3), &Weights::Lazy, &Unwatched).unwrap();
    assert!(observer.stabilisers().iter().all(|s| s.time == usize::MAX));
}
