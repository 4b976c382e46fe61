//! How the peak that is measured from rest converges to the certified resonance with the time of observation.

use super::veerman::{UNIT, certified, leading};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::{Interval, rational};
use ledger::CheckError;
use models::platoon::observe::measured_resonance;
use models::platoon::{Gains, slowest_rate};
use runs::table1::ROWS;
use std::f64::consts::PI;
use std::fmt::Write;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let mut rows = Vec::new();
    let mut text = String::from(
        "From rest behind cos wt, f = g = -1: the largest |x_N| in the n-th period,\n\
         maximised over w by golden section, against the certified resonance. The slowest\n\
         mode decreases to 1/e in m periods.\n\n   N        m   periods until within 1e-2, 1e-4, 1e-6 of the certified amplitude\n",
    );
    let [mut left, mut right] = ["periods of observation", "periods over those of the slowest mode"].map(|label| {
        Panel::new("", Axis::log(label), Axis::log("certified amplitude: share that is lacking").between(1e-9, 2.0))
    });
    let unit = Gains { f: rational(-1, 1), g: rational(-1, 1) }.map(|q| Interval::from_rational(q, 64));
    for row in &ROWS {
        let (frequency, amplitude) = certified(row.n)?;
        let relaxation = frequency / (2.0 * PI * slowest_rate(&unit, row.n)?.to_f64());
        let mut lacking = Vec::new();
        for k in 0..=22u32 {
            let periods = (2f64.powf(f64::from(k) / 2.0)).round();
            if lacking.last().is_some_and(|&(n, share): &(f64, f64)| n == periods || share < 1e-8) {
                continue;
            }
            let found = measured_resonance(&UNIT, row.n, leading(row.n)?.0, periods)?;
            let share = (1.0 - found.value / amplitude).abs();
            lacking.push((periods, share));
            rows.push([
                row.n.to_string(),
                periods.to_string(),
                format!("{:.10}", found.at),
                format!("{:.10}", found.value),
                format!("{:.3e}", found.at / frequency - 1.0),
                format!("{share:.3e}"),
            ]);
        }
        let until = |limit: f64| {
            lacking.iter().find(|(_, share)| *share < limit).map_or("-".to_string(), |(n, _)| n.to_string())
        };
        // Writing to a string cannot fail.
        let _ =
            writeln!(text, "{:4} {relaxation:8.2}   {:>5} {:>5} {:>5}", row.n, until(1e-2), until(1e-4), until(1e-6));
        left = left.series(Series::joined(format!("N = {}", row.n), lacking.clone()).size(2.4));
        right = right.series(
            Series::joined(format!("N = {}", row.n), lacking.iter().map(|(n, share)| (n / relaxation, *share)))
                .size(2.4),
        );
    }
    text.push_str("\nPeriods are tried in steps of a factor of sqrt2.\n");
    let picture = Picture::new("Measured peak of the last follower against the certified resonance")
        .grid(2, (560.0, 420.0))
        .panel(left)
        .panel(right);
    Ok(Reproduced::new(text)
        .table("", csv("N,periods,frequency,amplitude,frequency_deviation,amplitude_lacking", rows))
        .picture("", picture))
}
