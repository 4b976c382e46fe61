//! beyond.chazelle.entries: the smallest nonzero entry of products of matrices of the flocking models.

use crate::chazelle::entries::{EntriesVariant, Floor, examine_entries};
use ledger::Record;

pub fn smallest_entries() -> Record<EntriesVariant> {
    let scaled = |p, q| EntriesVariant { floor: Floor::Smallest(p, q), ..EntriesVariant::SHARP };
    Record::new(
        "beyond.chazelle.entries",
        "When the support S of a column grows, a bird with m neighbours in S and at most n - |S| - 1 outside gets at \
         least the share m/(m + n - |S|) >= 1/(n - |S| + 1) of the smallest entry (vicsek), and a bird of S keeps at \
         least as much. For lazy the share is at least min(1/3, 2/(3(n - |S|))). The products over |S| = 1, ..., n - \
         1 are the two values. They are attained: at step k the new bird sees the bird with the smallest entry and \
         all birds outside S (notes/chazelle_switches.md).",
        EntriesVariant::SHARP,
        examine_entries,
    )
    .stated("sharpens chazelle, Lemma 2.2", "")
    .clauses(&[
        "Over all sequences of networks on n >= 2 birds, with P(u) = I - C L of the network at time u, bird i of degree d_i > 0 having the \
         weight c_i and one without neighbours keeping its velocity, and all t >= s, no nonzero entry of P(t,s) = P(t) P(t-1) ... P(s) is \
         less than 1/n! for c_i = 1/(d_i+1), or less than 2^{n-2}/(3^{n-1} (n-1)!) for c_i = 2/(3 d_i).",
        "For every n >= 2 these values occur.",
    ])
    .control("1/100 larger", scaled(101, 100))
    .control("1/100 smaller", scaled(99, 100))
    .altered("edges seen from one side", |v| v.one_sided = true)
}
