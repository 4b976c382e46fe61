//! Figure 5 of Veerman, Stosic and Olvera: how far the resonance is from Theorem 1, and the regression lines.

use super::veerman::{certified, leading};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::regression_line;
use ledger::CheckError;
use runs::table1::ROWS;
use std::fmt::Write;

/// A series of differences with its regression line in the logarithms.
struct Differences {
    name: &'static str,
    points: Vec<(f64, f64)>,
    slope: f64,
    intercept: f64,
}

impl Differences {
    fn new(name: &'static str, points: Vec<(f64, f64)>) -> Result<Self, CheckError> {
        let logarithms: Vec<(f64, f64)> = points.iter().map(|(n, d)| (n.ln(), d.abs().ln())).collect();
        let (slope, intercept) = regression_line(&logarithms)?;
        Ok(Differences { name, points, slope, intercept })
    }
}

fn printed(cell: &str) -> f64 {
    cell.parse().unwrap_or(f64::NAN)
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let mut sets: [[Vec<(f64, f64)>; 2]; 2] = Default::default();
    for row in &ROWS {
        let (truth, theorem) = (certified(row.n)?, leading(row.n)?);
        let n = row.n as f64;
        sets[0][0].push((n, theorem.1 - truth.1));
        sets[0][1].push((n, printed(row.namp) - printed(row.tamp)));
        sets[1][0].push((n, theorem.0 - truth.0));
        sets[1][1].push((n, printed(row.nfreq) - printed(row.tfreq)));
    }
    let mut picture =
        Picture::new("Figure 5: difference between the resonance and Theorem 1 (f = g = −1)").grid(2, (520.0, 420.0));
    let mut text = String::from(
        "Size of the difference from Theorem 1 for N followers, N = 4, 8, ..., 128, with\n\
         the least-squares line in the logarithms. The paper: \"slope close to -3\".\n\n",
    );
    let mut rows = Vec::new();
    for (quantity, title, [true_set, printed_set]) in
        [("amplitude", "a) amplitude", sets[0].clone()), ("frequency", "b) frequency", sets[1].clone())]
    {
        let ticks: Vec<f64> = ROWS.iter().map(|row| row.n as f64).collect();
        let mut panel = Panel::new(
            title,
            Axis::log("N (followers)").ticks(ticks),
            Axis::log(format!("|difference of the {quantity}|")),
        );
        for set in [Differences::new("certified", true_set)?, Differences::new("printed columns", printed_set)?] {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {quantity}, {:16} slope {:+.4}", set.name, set.slope);
            let line = [3.5f64, 150.0].map(|n| (n, (set.intercept + set.slope * n.ln()).exp()));
            let colour = if set.name == "certified" { "#0b5fa5" } else { "#d1580b" };
            let named = format!("{}, slope {:.3}", set.name, set.slope).replace('-', "−");
            let points = set.points.iter().map(|(n, d)| (*n, d.abs()));
            panel = panel
                .series(Series::points(named, points).colour(colour))
                .series(Series::dashed("", line).colour(colour).size(1.0));
            rows.extend(set.points.iter().map(|(n, d)| {
                let fitted = (set.intercept + set.slope * n.ln()).exp();
                [
                    quantity.to_string(),
                    set.name.to_string(),
                    n.to_string(),
                    format!("{d:.10e}"),
                    format!("{fitted:.6e}"),
                ]
            }));
        }
        picture = picture.panel(panel);
    }
    text.push_str(
        "\nThe next order says w_0 - w = 0.28548/M^3 and A - A_0 = 0.26709/M for f = g = -1\n\
         (beyond.veerman.resonance_frequency, resonance_amplitude). The printed\n\
         amplitudes differ from Theorem 1 in the other direction: NAMP - TAMP > 0.\n",
    );
    Ok(Reproduced::new(text)
        .table("", csv("quantity,set,N,theorem1_minus_other,regression", rows))
        .picture("", picture))
}
