//! beyond.chazelle.angle and beyond.chazelle.losses: Lemmas 3.7 and 3.8 with better bounds.

use crate::chazelle::geometry::{LossVariant, OriginVariant, about_losses, about_origins};
use ledger::Record;

pub fn angle() -> Record<OriginVariant> {
    about_origins(
        "beyond.chazelle.angle",
        "See chazelle.lem3.7: E_i(t) = x_i(t) - t v_i(t) starts at x(0) and obeys E(t+1) = P(t) E(t) + (I - P(t)) \
         x(t); on a fixed network the last term has stationary mean zero and is mixed away, so it adds at most 4 \
         sum_r tau_1(P^r) in all. A network that comes back may have other weights, as in model D.",
        OriginVariant::SHARPER,
    )
    .stated("sharpens chazelle, Lemma 3.7", "")
    .clauses(&[
        "In model D, for any bird at any time t >= 1, the angle of (x_i(t), t) and (v_i(t), 1), the lifted birds, is at most |v_i(t) - x_i(t)/t| = |E_i(t)|/t with E_i(t) = x_i(t) - t v_i(t).",
        "With a positive integer a, positive entries of every P(t) at least n^-a, weights that change only when the network does, and as \
         long as no edge is longer than 2 (Lemma 3.6), each coordinate of E_i(t), t >= 1, is at most max|x(0)|, the largest absolute \
         coordinate of x(0), + 4 (s(t) + 1) n^(2a+3) in absolute value, s(t) the number of u, 2 <= u < t, with G_u != G_(u-1): no waiting \
         time and no log t.",
    ])
}

pub fn losses() -> Record<LossVariant> {
    about_losses(
        "beyond.chazelle.losses",
        "See chazelle.lem3.8: an edge of G_{t-1} stays once (2 + 2|E|)/(t-1) < n^(-n^4), and |E| <= n^O(n²) by the \
         sharper bound of the number of switches.",
        LossVariant { time: |n| n.pow(4) + 2 * (n - 1).pow(2) + 10 * (n - 1) + 17, hysteresis: true, earlier: 1 },
    )
    .stated(
        "sharpens chazelle, Lemma 3.8",
        "In model D with the hysteresis of the paper and weights that change only when the network does, n >= 4 birds in dimension at most n², positive entries of every P(t) at least \
         n^-a with a = 1 or 2, and Euclidean speeds and absolute coordinates of x(0) up to n, no edge is lost after time n^(n^4 + \
         2(n-1)² + 10(n-1) + 17).",
    )
}
