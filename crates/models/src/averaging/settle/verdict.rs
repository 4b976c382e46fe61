//! The end of a flock in words: why its network never changes again, or that it changes at a time that cannot be written.

use super::ending::Ending;
use super::pairs::Prospects;
use super::trajectory::{Next, Trajectory};
use arithmetic::Interval;

impl Trajectory<'_> {
    /// Why the network never changes again, with the number of pairs that have a relative drift and of steps ahead that were looked at.
    pub(super) fn why_steady(&self, drifting: usize, ahead: u64) -> String {
        let (birds, now) = match &self.balls {
            Some(balls) => (balls.birds(), balls.time()),
            None => (self.flock.birds(), self.flock.time().clone()),
        };
        if birds == 1 {
            return "one bird has no edges".to_string();
        }
        let drifting = match drifting {
            0 => "there is no pair with relative drift".to_string(),
            pairs => format!("the {pairs} pairs with relative drift never come within distance 1"),
        };
        format!(
            "checked step by step for {} steps after the last switch; from then on every pair without relative drift stays joined or \
             apart, because what is left of its motion is too small to change that, and {drifting}",
            now + ahead - &self.last_switch
        )
    }

    /// No switch comes at a time that can be written.
    pub(super) fn end(&self, all: &Prospects) -> Next {
        let log2 = |interval: &Interval| interval.to_rationals();
        let Some(first) = all.slow_approaches.iter().min_by(|a, b| log2(&a.log2_steps).0.cmp(&log2(&b.log2_steps).0))
        else {
            let mut why = self.why_steady(all.approaches.len(), 0);
            if all.parting > 0 {
                why.push_str(&format!(
                    "; {} pairs of which the relative drift is too small to be written as a number move apart",
                    all.parting
                ));
            }
            return Next::End(Ending::Steady, why);
        };
        // All whose time may be as early.
        let latest = log2(&first.log2_steps).1;
        let may_be_first: Vec<_> = all.slow_approaches.iter().filter(|c| log2(&c.log2_steps).0 <= latest).collect();
        let pairs: Vec<(usize, usize)> = may_be_first.iter().map(|c| c.pair).collect();
        let log2_steps = may_be_first.iter().fold(first.log2_steps.clone(), |hull, c| hull.hull(&c.log2_steps));
        let names: Vec<String> = pairs.iter().map(|(i, j)| format!("{} and {}", i + 1, j + 1)).collect();
        let why = format!(
            "birds {} approach at a speed too small to be written as a number; the time of contact is enclosed by its logarithm",
            names.join(", or ")
        );
        Next::End(Ending::Beyond { pairs, log2_steps }, why)
    }
}
