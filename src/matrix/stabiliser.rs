//! The stabilisers of a finite sequence of matrices (Chazelle, proof of Lemma 3.1).

use super::Footprint;

/// One stabiliser of a finite sequence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stabiliser {
    /// `T_k`: the number of factors after which the footprint, restricted to the previous stabiliser and started after
    /// `T_{k-1}`, no longer changes within the sequence.
    pub time: usize,
    /// `V_k`: the vertices (from 0) with a one in the first column of that footprint.
    pub members: Vec<usize>,
}

/// The sequence `V_1 ⊇ V_2 ⊇ ...` with its times, for square footprints of the same order.
///
/// In the paper `T_k` is the last change over all future time; for a finite sequence it is the last change that the
/// sequence shows, so `V_k` is what the sequence supports and a longer one may move it. The sequence of stabilisers
/// ends when the factors are used up.
pub fn stabilisers(factors: &[Footprint]) -> Vec<Stabiliser> {
    let mut found = Vec::new();
    let mut members: Vec<usize> = (0..factors.first().map_or(0, Footprint::rows)).collect();
    let mut start = 0;
    while start < factors.len() && !members.is_empty() {
        let restrict =
            |f: &Footprint| Footprint::from_fn(members.len(), members.len(), |i, j| f.get(members[i], members[j]));
        let mut product = restrict(&factors[start]);
        let mut last_change = start + 1;
        for (t, factor) in factors.iter().enumerate().skip(start + 1) {
            let next = restrict(factor).times(&product);
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
