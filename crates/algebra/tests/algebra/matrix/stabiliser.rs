//! The streaming stabilisers against the definition on finite sequences.

use algebra::matrix::{Footprint, Stabiliser, StabiliserStream, stabilisers};
use proptest::prelude::*;

/// The definition, with all factors at hand: run to the last change, restrict, start again after it.
fn by_definition(factors: &[Footprint]) -> Vec<Stabiliser> {
    let mut found = Vec::new();
    let mut members: Vec<usize> = (0..factors.first().map_or(0, Footprint::rows)).collect();
    let mut start = 0;
    while start < factors.len() && !members.is_empty() {
        let mut product = factors[start].restricted(&members);
        let mut last_change = start + 1;
        for (t, factor) in factors.iter().enumerate().skip(start + 1) {
            let next = factor.restricted(&members).times(&product);
            if next != product {
                last_change = t + 1;
                product = next;
            }
        }
        members = product.column(0).into_iter().map(|i| members[i]).collect();
        start = last_change;
        found.push(Stabiliser { time: last_change, members: members.clone() });
    }
    found
}

/// Sequences of sparse footprints, half of them with a full diagonal, some symmetric.
fn sequences() -> impl Strategy<Value = Vec<Footprint>> {
    let entry = prop_oneof![3 => Just(false), 1 => Just(true)];
    (1usize..7, any::<bool>(), any::<bool>()).prop_flat_map(move |(order, diagonal, symmetric)| {
        let factor = prop::collection::vec(entry.clone(), order * order).prop_map(move |bits| {
            let at = |i: usize, j: usize| bits[i * order + j];
            Footprint::from_fn(order, order, |i, j| {
                if i == j { diagonal || at(i, j) } else { at(i, j) || (symmetric && at(j, i)) }
            })
        });
        prop::collection::vec(factor, 0..24)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn the_stream_agrees_with_the_definition_after_every_factor(factors in sequences(), cap in 0usize..5) {
        prop_assert_eq!(stabilisers(&factors), by_definition(&factors));
        let mut stream = StabiliserStream::new(factors.first().map_or(0, Footprint::rows), cap);
        for (t, factor) in factors.iter().enumerate() {
            stream.push(factor);
            let mut expected = by_definition(&factors[..=t]);
            expected.truncate(cap);
            prop_assert_eq!(stream.stabilisers().cloned().collect::<Vec<_>>(), expected);
        }
    }
}

proptest! {
    #[test]
    fn restrictions_unions_and_roots_are_those_of_the_entries(
        (n, bits, to) in (1usize..9).prop_flat_map(|n| {
            (Just(n), prop::collection::vec(any::<bool>(), n * n), prop::collection::vec(0..n + 1, 0..n + 1))
        })
    ) {
        let footprint = Footprint::from_fn(n, n, |i, j| bits[i * n + j]);
        let entries = Footprint::from_fn(to.len(), to.len(), |i, j| footprint.get(to[i], to[j]));
        prop_assert_eq!(footprint.restricted(&to), entries);
        let turned = Footprint::from_fn(n, n, |i, j| footprint.get(j, i));
        let either = Footprint::from_fn(n, n, |i, j| footprint.get(i, j) || footprint.get(j, i));
        prop_assert_eq!(footprint.or(&turned), either);
        let heard_by = |root: usize| {
            let mut by = vec![false; n];
            by[root] = true;
            for _ in 0..n {
                by = (0..n).map(|i| by[i] || (0..n).any(|j| footprint.get(i, j) && by[j])).collect();
            }
            by
        };
        prop_assert_eq!(footprint.is_rooted(), (0..n).any(|root| heard_by(root).iter().all(|x| *x)));
    }
}
