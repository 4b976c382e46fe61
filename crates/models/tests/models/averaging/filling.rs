//! The search for the longest sequences against all sequences of a length.

use models::averaging::{Filling, GroupRule};

/// The birds that a bird is joined to, and itself, as bits; one entry for each bird.
type Network = Vec<u32>;

fn networks(order: usize) -> Vec<Network> {
    let pairs: Vec<(usize, usize)> = (0..order).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    let network = |code: usize| {
        let mut rows: Network = (0..order).map(|i| 1 << i).collect();
        for (_, &(i, j)) in pairs.iter().enumerate().filter(|(k, _)| code >> k & 1 == 1) {
            rows[i] |= 1 << j;
            rows[j] |= 1 << i;
        }
        rows
    };
    (0..1usize << pairs.len()).map(network).collect()
}

/// Whether no group of fewer birds than all that is isolated from one network of the word to the next switches more often than it may.
fn is_allowed(word: &[&Network], most: &[usize]) -> bool {
    let order = word[0].len();
    (0..(1u32 << order) - 1).all(|group| {
        let Some(most) = most.get(group.count_ones() as usize) else { return true };
        let birds = || (0..order).filter(|i| group >> i & 1 == 1);
        let isolated = |network: &Network| birds().all(|i| network[i] & !group == 0);
        let mut used = 0;
        word.windows(2).all(|two| {
            let together = two.iter().all(|network| isolated(network));
            used = if together { used + usize::from(birds().any(|i| two[0][i] != two[1][i])) } else { 0 };
            used <= *most
        })
    })
}

/// The most switches until the last growth of the footprint, over all allowed words of at most `length` networks that begin with this one.
fn by_enumeration<'a>(
    all: &'a [Network],
    word: &mut Vec<&'a Network>,
    seen: &[u32],
    most: &[usize],
    length: usize,
) -> usize {
    let switches = word.windows(2).filter(|two| two[0] != two[1]).count();
    let mut best = 0;
    // A footprint with all entries grows no more.
    if word.len() == length || seen.iter().all(|row| row.count_ones() as usize == seen.len()) {
        return best;
    }
    for next in all {
        word.push(next);
        if is_allowed(word, most) {
            let after: Vec<u32> = next
                .iter()
                .map(|row| (0..seen.len()).filter(|j| row >> j & 1 == 1).fold(0, |sum, j| sum | seen[j]))
                .collect();
            let grown = if after == seen { 0 } else { switches + usize::from(word[word.len() - 2] != next) };
            best = best.max(grown).max(by_enumeration(all, word, &after, most, length));
        }
        word.pop();
    }
    best
}

fn longest(order: usize, most: &[u64], until_stable: bool) -> Option<u64> {
    let rule = GroupRule { order, most: most.to_vec() };
    Filling::new(rule, until_stable).expect("few birds").longest()
}

#[test]
fn the_longest_sequences_are_those_of_an_enumeration() {
    // Limits of groups of 0, 1, 2, .. birds: those of fewer than two birds and of all birds say nothing.
    for (order, most, length) in
        [(1, vec![], 4), (2, vec![], 5), (2, vec![0, 0, 0], 5), (3, vec![0, 0, 0], 5), (3, vec![7, 0, 1, 0], 6)]
    {
        let all = networks(order);
        let limits: Vec<usize> = most.iter().map(|&m| m as usize).collect();
        let known = all.iter().map(|first| by_enumeration(&all, &mut vec![first], first, &limits, length)).max();
        assert_eq!(longest(order, &most, true).map(|m| m as usize), known, "{order} birds, {most:?}");
    }
}

/// `2 N + 3` on three birds: each of the two others switches to and fro with a bird before it has seen all.
#[test]
fn three_birds_have_sequences_for_every_limit() {
    for most in [0, 1, 2, 3, 260] {
        assert_eq!(longest(3, &[0, 0, most], true), Some(2 * most + 3), "N = {most}");
    }
}
/// Pairs without a limit switch for ever before the third bird is seen, and connected networks take turns for ever after.
#[test]
fn sequences_without_end_have_no_largest_number() {
    assert_eq!([&[][..], &[0], &[0, 0]].map(|most| longest(3, most, true)), [None; 3]);
    assert_eq!([2, 3].map(|order| longest(order, &[0, 0, 0], false)), [None; 2]);
    assert_eq!([0, 1].map(|order| longest(order, &[], false)), [Some(0); 2]);
    assert_eq!([5, 6].map(|order| Filling::new(GroupRule { order, most: Vec::new() }, true).is_some()), [true, false]);
}
