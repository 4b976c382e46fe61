//! From shares of runs to outcomes.

use ledger::{Evidence, Outcome};
use motion::Share;

/// Whether a share is above a number: it fails where no run shows it or the interval lies below, and is undecided where the number lies
/// inside the interval.
pub(crate) fn judged(share: Share, above: f64, what: String, evidence: Evidence) -> Outcome {
    match share.is_above(above) {
        Some(true) if share.found > 0 => Outcome::Holds(vec![evidence]),
        None if share.found > 0 => {
            Outcome::Undecided(format!("{what}: too few runs to tell whether it is above {above}"))
        }
        _ => Outcome::fails(format!("{what}: not above {above}"), evidence),
    }
}
