//! Figure 3 of Veerman, Stosic and Olvera: a flock behind a leader that accelerates abruptly.

use super::veerman::{UNIT, certified, steps};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use ledger::CheckError;
use models::platoon::observe::{largest, smallest_gap};
use models::platoon::time_domain::Modes;
use std::f64::consts::PI;

const FOLLOWERS: u64 = 20;
/// Acceleration from time 0 to `UNTIL`, to the velocity one.
const UNTIL: f64 = 10.0;
const END: f64 = 600.0;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let (w, _) = certified(FOLLOWERS)?;
    let acceleration = 1.0 / UNTIL;
    let changes = [(0.0, acceleration), (UNTIL, -acceleration)];
    let start = Modes::new(&UNIT, FOLLOWERS)?.behind_accelerating_leader(&changes)?;
    let last = FOLLOWERS as usize - 1;
    let mut rows = Vec::new();
    let mut lines = vec![(Vec::new(), Vec::new()); FOLLOWERS as usize];
    let mut gaps = Vec::new();
    for t in steps(0.0, END, 1200) {
        let (_, leader_velocity) = start.leader(&t)?;
        let cars = start.deviations(&t)?;
        for (k, (places, velocities)) in lines.iter_mut().enumerate() {
            places.push((t, cars.positions[k]));
            velocities.push((t, cars.velocities[k] + leader_velocity));
        }
        // Without the spacing: how much closer two neighbours come than in formation.
        let closer = smallest_gap(0.0, &cars.positions, 0.0);
        gaps.push((t, closer));
        rows.push(
            [t, leader_velocity, cars.positions[last], cars.velocities[last] + leader_velocity, closer]
                .map(|x| format!("{x:.8}")),
        );
    }
    let needed = largest((0.0, END), 1200, |t| {
        Ok::<f64, CheckError>(-smallest_gap(0.0, &start.deviations(&t)?.positions, 0.0))
    })?;
    let fastest = largest((0.0, END), 1200, |t| {
        let leader = start.leader(&t)?.1;
        Ok::<f64, CheckError>(start.deviations(&t)?.velocities.iter().fold(0f64, |most, u| most.max(u + leader)))
    })?;
    let slowest = largest((fastest.at, END), 1200, |t| {
        Ok::<f64, CheckError>(start.deviations(&t)?.velocities.iter().fold(0f64, |most, u| most.max(-u)))
    })?;
    let passages = passages(|t| Ok(start.last(&t)?))?;
    let half_periods: Vec<f64> = passages.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mean = half_periods.iter().sum::<f64>() / half_periods.len().max(1) as f64;
    let shown = [0usize, 4, 9, 14, 19];
    let mut places = Panel::new(
        "a) deviation from the place behind the leader",
        Axis::linear("time (f = −1 sets the unit)").between(0.0, END),
        Axis::linear("deviation"),
    );
    let mut velocities = Panel::new(
        "b) velocities",
        Axis::linear("time (f = −1 sets the unit)").between(0.0, END),
        Axis::linear("velocity"),
    );
    for car in shown {
        places = places.series(Series::line(format!("car {}", car + 1), lines[car].0.clone()));
        velocities = velocities.series(Series::line(format!("car {}", car + 1), lines[car].1.clone()));
    }
    let picture = Picture::new(format!(
        "Figure 3: {FOLLOWERS} followers, the leader accelerates abruptly to velocity 1 (f = g = −1)"
    ))
    .grid(1, (860.0, 280.0))
    .panel(places)
    .panel(velocities)
    .panel(
        Panel::new(
            "c) collision check",
            Axis::linear("time (f = −1 sets the unit)").between(0.0, END),
            Axis::linear("gap minus spacing, smallest"),
        )
        .series(Series::line("", gaps)),
    );
    let text = format!(
        "The paper gives no parameters for this figure. Chosen: f = g = -1 (Section 7),\n\
         {FOLLOWERS} followers at rest in their places, acceleration {acceleration} from time 0 to {UNTIL}, then\n\
         none; the law is linear, so everything scales with the velocity reached (1).\n\
         Motion by the exact sum of its modes; extremes refined from steps of 0.5.\n\n\
         \x20 collision-free if the spacing is above       {:.4} (per unit of velocity; met at t = {:.2})\n\
         \x20 largest velocity of a follower               {:.4} (at t = {:.2})\n\
         \x20 largest lack of velocity after that          {:.4} (at t = {:.2})\n\
         \x20 mean half period of the last car             {mean:.3} ({} half periods)\n\
         \x20 half period of the certified resonance       {:.3}\n",
        needed.value,
        needed.at,
        fastest.value,
        fastest.at,
        slowest.value,
        slowest.at,
        half_periods.len(),
        PI / w
    );
    let header = "time,leader_velocity,deviation_of_last,velocity_of_last,smallest_gap_minus_spacing";
    Ok(Reproduced::new(text).table("", csv(header, rows)).picture("", picture))
}

/// When the last car passes its place after the acceleration, by bisection.
fn passages(at: impl Fn(f64) -> Result<f64, CheckError>) -> Result<Vec<f64>, CheckError> {
    let mut found = Vec::new();
    let step = 0.5;
    for k in (UNTIL / step) as u32 + 1..(END / step) as u32 {
        let (mut low, mut high) = (f64::from(k) * step, f64::from(k + 1) * step);
        if at(low)? * at(high)? < 0.0 {
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                if at(low)? * at(middle)? < 0.0 { high = middle } else { low = middle }
            }
            found.push(low);
        }
    }
    Ok(found)
}
