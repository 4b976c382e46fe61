//! From shares of runs to outcomes.

use ledger::{Evidence, Grade, Outcome};
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

/// How many runs show something, under one reading; `part` names the line of evidence and does not depend on the runs.
pub(crate) struct Seen {
    pub part: String,
    pub what: String,
    pub share: Share,
}

/// A report of a run with data that are not printed: it holds where more than half of the runs show it under every reading, or with
/// `can` where some do under one; it is refuted where that is so under no reading, and undecided where the readings disagree.
pub(crate) fn report(seen: Vec<Seen>, can: bool) -> Outcome {
    let least = if can { 0.0 } else { 0.5 };
    let above = |share: Share| if share.found == 0 { Some(false) } else { share.is_above(least) };
    let count = |wanted: Option<bool>| seen.iter().filter(|seen| above(seen.share) == wanted).count();
    let (shown, refuted) = (count(Some(true)), count(Some(false)));
    let all = seen.iter().map(|seen| seen.what.as_str()).collect::<Vec<_>>().join("; ");
    let evidence = |seen: &Seen| Evidence::new(Grade::Simulated, &seen.part, &seen.what).cases(seen.share.of);
    let evidence: Vec<Evidence> = seen.iter().map(evidence).collect();
    if shown == seen.len() || can && shown > 0 {
        return Outcome::Holds(evidence);
    }
    if refuted == seen.len() {
        return Outcome::failure(format!("{all}: not above {least}"), evidence);
    }
    let why = if shown > 0 { "the readings disagree" } else { "too few runs to tell" };
    Outcome::Undecided(format!("{why}, and a finite run refutes no limit: {all}"))
}
