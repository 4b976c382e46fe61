//! beyond.chazelle.switches: a flocking network switches at most n^O(n²) times.

use crate::chazelle::switching::{SwitchesVariant, examine_switches};
use ledger::Record;

pub fn fewer_switches() -> Record<SwitchesVariant> {
    Record::new(
        "beyond.chazelle.switches",
        "The proof of Lemma 3.1, completed, with the entries n^(-a(n-1)) of beyond.chazelle.entries in place of \
         n^(-O(n²)): k = nu^(a(nu-1)+c+6) stabilisers are enough for edges to last, and N(n) + 2 <= 3 k nu (N(n-1) + \
         2). Proof in notes/chazelle_switches.md; the Coq proof takes windows with connected unions in place of stabilisers.",
        SwitchesVariant::QUADRATIC,
        examine_switches,
    )
    .stated(
        "sharpens chazelle, Lemma 3.1 and Theorem 1.1",
        "Let a and c be non-negative integers. In model D with the printed hysteresis rule, positive entries of every \
         P(t) at least n^-a and Euclidean speeds at most n^c, the network of n >= 2 birds has at most n^{a(n-1)^2 + \
         (c+9)(n-1) + 1} times u >= 2 with G_u != G_{u-1}: n^{O(n^2)}, not only n^{O(n^3)}.",
    )
    .altered("at most n - 1 switches", |v| v.count = Some(|n| n - 1))
    .altered("at most n^4 switches", |v| v.count = Some(|n| n.pow(4)))
    .altered("step 3 of the proof: with c + 5 in place of c + 9", |v| {
        v.exponent = |n, a, c| a * (n - 1).pow(2) + (c + 5) * (n - 1) + 1
    })
    .altered("step 1 of the proof: with k smaller by a factor nu^3", |v| v.room = |c| c + 3)
}
