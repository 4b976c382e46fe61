//! What `flock run` says about products: footprint, stabilisers, ergodicity coefficients, lengths of numbers.

use super::stepped::SteppedFlock;
use flockproof::arithmetic::{Progress, Rational};
use flockproof::averaging::{Decay, Observer, deviation_matrix_watched, stationary_distribution, transition_matrix};
use flockproof::matrix::Footprint;
use num_traits::ToPrimitive;
use serde_json::{Value, json};

/// Bits of the numbers of a run beside what Chazelle's lemmas measure them by.
pub struct Lengths {
    state: u64,
    /// Over `t n log2 n` (Lemma 2.3), where that is not 0.
    state_share: Option<f64>,
    /// Of Gamma for the largest flock of the last network, and Lemma 3.5's `n log2 n`, its number of birds `n`.
    gamma: Option<(u64, f64)>,
}

impl Lengths {
    pub fn new(flock: &SteppedFlock, t: u64, progress: &dyn Progress) -> Self {
        let n = flock.network().order() as f64;
        let (state, unit) = (flock.denominator_bits(), t as f64 * n * n.log2());
        Lengths { state, state_share: (unit > 0.0).then(|| state as f64 / unit), gamma: gamma_bits(flock, progress) }
    }
}

fn gamma_bits(flock: &SteppedFlock, progress: &dyn Progress) -> Option<(u64, f64)> {
    /// Exact inverses of larger flocks take long.
    const LARGEST: usize = 32;
    let members = flock.network().components().into_iter().max_by_key(Vec::len)?;
    if members.len() > LARGEST || members.len() < 2 {
        return None;
    }
    let (graph, weights) = (flock.network().induced(&members), flock.weights().restricted(&members));
    let pi = stationary_distribution(&graph, &weights).ok()?;
    let gamma = deviation_matrix_watched(&transition_matrix(&graph, &weights).ok()?, &pi, progress).ok()?;
    let n = members.len() as f64;
    Some((gamma.denominator().bits(), n * n.log2()))
}

fn members(list: &[usize]) -> Vec<usize> {
    list.iter().map(|i| i + 1).collect()
}

/// The birds (from 1) in the order of (3.5): those of the last stabiliser first, then those of the one before, and so on. In this
/// order the products after `T_k` have the blocks of the stabilisers on their diagonal.
fn block_order(observer: &Observer, birds: usize) -> Vec<usize> {
    let stabilisers = observer.stabilisers();
    let depth = |i: &usize| stabilisers.iter().filter(|s| s.members.contains(i)).count();
    let mut order: Vec<usize> = (0..birds).collect();
    order.sort_by_key(|i| std::cmp::Reverse(depth(i)));
    members(&order)
}

fn decay_json(decay: &Decay) -> Value {
    json!({
        "t": decay.time,
        "tau_1": decay.tau_1.to_string(),
        "tau_2_squared": decay.tau_2_squared.to_string(),
        "denominator_bits": decay.denominator_bits,
    })
}

/// Adds what was observed to the document of a run.
pub fn observed_json(observer: &Observer, lengths: &Lengths, document: &mut Value) {
    document["from"] = json!(observer.from());
    document["footprint"] = json!(observer.footprint().map(ToString::to_string));
    let stabilisers = observer.stabilisers();
    document["stabilisers"] =
        stabilisers.iter().map(|s| json!({"time": s.time, "members": members(&s.members)})).collect();
    let birds = observer.footprint().map_or(0, Footprint::rows);
    document["block_order"] = json!(block_order(observer, birds));
    document["decay"] = observer.decay().iter().map(decay_json).collect();
    document["bits"] = json!({
        "state": lengths.state,
        "state_per_t_n_log2_n": lengths.state_share.map(|share| format!("~{share:.4}")),
        "gamma": lengths.gamma.map(|(bits, _)| bits),
        "gamma_per_n_log2_n": lengths.gamma.map(|(bits, unit)| format!("~{:.4}", bits as f64 / unit)),
    });
}

/// The same as text.
pub fn observed_text(observer: &Observer, lengths: &Lengths) -> String {
    let s = observer.from();
    let mut text = String::new();
    if let Some(footprint) = observer.footprint() {
        let (shown, n) = (footprint.to_string(), footprint.rows());
        let ones = shown.matches('1').count();
        let rows = if n <= 8 { format!(": {shown}") } else { String::new() };
        text.push_str(&format!("footprint of P(t, {s}): {ones} of {} entries are positive{rows}\n", n * n));
    }
    for (k, stabiliser) in observer.stabilisers().iter().enumerate() {
        let list: Vec<String> = members(&stabiliser.members).iter().map(ToString::to_string).collect();
        text.push_str(&format!(
            "V_{} = {{{}}} from T_{} = {} so far\n",
            k + 1,
            list.join(", "),
            k + 1,
            stabiliser.time
        ));
    }
    let birds = observer.footprint().map_or(0, Footprint::rows);
    if observer.stabilisers().iter().any(|s| s.members.len() < birds) {
        text.push_str(&format!("block form (3.5): birds in the order {:?}\n", block_order(observer, birds)));
    }
    let float = |x: &Rational| x.to_f64().unwrap_or(f64::NAN);
    for decay in observer.decay() {
        text.push_str(&format!(
            "t = {}: tau_1 = {:.6e}, tau_2 = {:.6e}, {} bits\n",
            decay.time,
            float(&decay.tau_1),
            float(&decay.tau_2_squared).sqrt(),
            decay.denominator_bits
        ));
    }
    if let Some(share) = lengths.state_share {
        text.push_str(&format!("bits of the state/(t n log2 n): {share:.3} (Lemma 2.3)\n"));
    }
    if let Some((bits, unit)) = lengths.gamma {
        text.push_str(&format!("bits of Gamma/(n log2 n), largest flock: {:.3} (Lemma 3.5)\n", bits as f64 / unit));
    }
    text
}
