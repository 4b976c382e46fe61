//! Figure 2 of Veerman, Stosic and Olvera: a flock behind a periodic leader, early and close to equilibrium.

use super::veerman::{UNIT, certified, steps};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::ArithmeticError;
use ledger::CheckError;
use models::platoon::observe::{largest, smallest_gap};
use models::platoon::time_domain::{HarmonicStart, Modes};
use std::f64::consts::PI;

const FOLLOWERS: u64 = 32;
const SPACING: f64 = 1.0;
/// In periods: the early stage, and the start of a late stage of the same length.
const LENGTH: f64 = 3.0;
const LATE: f64 = 60.0;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let (w, amplitude) = certified(FOLLOWERS)?;
    let period = 2.0 * PI / w;
    let start = Modes::new(&UNIT, FOLLOWERS)?.behind_harmonic_leader(&w)?;
    let gap = |t: f64| -> Result<f64, ArithmeticError> {
        Ok(smallest_gap((w * t).cos(), &start.followers(&t)?.positions, SPACING))
    };
    let mut picture = Picture::new(format!(
        "Figure 2: {FOLLOWERS} followers behind a leader at the resonance frequency, from rest (f = g = −1)"
    ))
    .grid(2, (560.0, 380.0));
    let mut rows = Vec::new();
    for (name, from) in [("a) early", 0.0), ("b) close to equilibrium", LATE)] {
        let stage: Vec<(f64, Vec<f64>)> = steps(from, from + LENGTH, 360)
            .map(|periods| Ok((periods, cars(&start, w, periods * period)?)))
            .collect::<Result<_, CheckError>>()?;
        let mut panel = Panel::new(
            name,
            Axis::linear("time (periods of the leader)").between(from, from + LENGTH),
            Axis::linear("place on the road"),
        );
        for car in (0..=FOLLOWERS as usize).rev() {
            let colour = if car == 0 {
                "#d1580b"
            } else if car == FOLLOWERS as usize {
                "#0b5fa5"
            } else {
                "#9aa7b0"
            };
            let name = if car == 0 {
                "leader"
            } else if car == FOLLOWERS as usize {
                "last car"
            } else {
                ""
            };
            let line = stage.iter().map(|(t, places)| (*t, places[car]));
            panel = panel.series(Series::line(name, line).colour(colour).size(if name.is_empty() { 0.6 } else { 1.8 }));
        }
        picture = picture.panel(panel);
        for (t, places) in stage {
            rows.push(
                std::iter::once(format!("{t:.6}")).chain(places.iter().map(|x| format!("{x:.8}"))).collect::<Vec<_>>(),
            );
        }
    }
    let reached = |n: u32| -> Result<f64, ArithmeticError> {
        let window = (f64::from(n - 1) * period, f64::from(n) * period);
        Ok(largest(window, 24, |t| Ok::<f64, ArithmeticError>(start.last(&t)?.abs()))?.value)
    };
    let growth = (1..=LATE as u32).map(|n| Ok((f64::from(n), reached(n)?))).collect::<Result<Vec<_>, CheckError>>()?;
    let gaps = steps(0.0, LATE, 1920).map(|n| Ok((n, gap(n * period)?))).collect::<Result<Vec<_>, CheckError>>()?;
    let first = first_collision(|t| Ok(gap(t)?), period)?;
    let deepest = -largest(((LATE - 1.0) * period, LATE * period), 48, |t| Ok::<f64, ArithmeticError>(-gap(t)?))?.value;
    picture = picture
        .panel(
            Panel::new(
                "c) the last car",
                Axis::linear("periods since the start"),
                Axis::linear("largest |x| in the period"),
            )
            .series(Series::points("reached", growth.clone()).size(2.4))
            .series(Series::dashed("certified equilibrium amplitude", [(0.0, amplitude), (LATE, amplitude)])),
        )
        .panel(
            Panel::new(
                "d) collision check",
                Axis::linear("periods since the start"),
                Axis::linear("smallest gap between cars"),
            )
            .series(Series::line("", gaps).size(0.8))
            .series(Series::dashed("", [(0.0, 0.0), (LATE, 0.0)])),
        );
    let share = |n: usize| growth[n - 1].1 / amplitude;
    let text = format!(
        "The paper gives no parameters for this figure. Chosen: f = g = -1 and places\n\
         x_k = -k (Section 7), {FOLLOWERS} followers, leader cos wt at the certified resonance\n\
         w = {w:.8}; motion by the exact sum of its modes.\n\n\
         \x20 equilibrium amplitude of the last car (certified)  {amplitude:.6}\n\
         \x20 share reached in period 1, 4, 16, 60               {:.4}, {:.4}, {:.4}, {:.6}\n\
         \x20 gap between neighbours first 0 after                {}\n\
         \x20 smallest gap close to equilibrium                  {deepest:.4}\n\
         \x20 largest leader amplitude without collision there   {:.4} of the spacing\n\n\
         With the leader's amplitude equal to the spacing the linear law lets cars pass\n\
         through each other: the check is of the law, which knows no collisions.\n",
        share(1),
        share(4),
        share(16),
        share(60),
        first.map_or("never".to_string(), |t| format!("{:.4} periods", t / period)),
        SPACING / (SPACING - deepest),
    );
    let header =
        std::iter::once("periods".to_string()).chain((0..=FOLLOWERS).map(|k| format!("x_{k}"))).collect::<Vec<_>>();
    Ok(Reproduced::new(text)
        .table("", csv(&header.join(","), rows))
        .table(
            "last_car",
            csv("period,largest_amplitude", growth.into_iter().map(|(n, a)| [n.to_string(), format!("{a:.10}")])),
        )
        .picture("", picture))
}

/// The places of all cars.
fn cars(start: &HarmonicStart<f64>, w: f64, t: f64) -> Result<Vec<f64>, CheckError> {
    let positions = start.followers(&t)?.positions;
    let deviations = std::iter::once((w * t).cos()).chain(positions);
    Ok(deviations.enumerate().map(|(k, y)| y - SPACING * k as f64).collect())
}

/// The first time at which the gap is zero, among the first 60 periods, by steps of a 64th of a period and bisection.
fn first_collision(gap: impl Fn(f64) -> Result<f64, CheckError>, period: f64) -> Result<Option<f64>, CheckError> {
    let step = period / 64.0;
    for k in 0..64 * LATE as u32 {
        let (mut low, mut high) = (f64::from(k) * step, f64::from(k + 1) * step);
        if gap(high)? <= 0.0 {
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                if gap(middle)? <= 0.0 { high = middle } else { low = middle }
            }
            return Ok(Some(high));
        }
    }
    Ok(None)
}
