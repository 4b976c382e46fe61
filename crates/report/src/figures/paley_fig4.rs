//! Figure 4 of Paley and others: the six symmetric circular formations of twelve particles.

use super::paley::{COLUMNS, START, end, largest_lower_moment, rows, scene, start, turning_error};
use super::{Reproduced, csv};
use crate::plot::Picture;
use arithmetic::Complex;
use arithmetic::threads::side_by_side;
use ledger::CheckError;
use models::oscillator::{CLUSTER, centre_spread, order};
use runs::{Experiment, OMEGA, PatternFormation};
use std::fmt::Write;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let (below, last) = PatternFormation::GAINS;
    let mut text = format!(
        "(5) with (20) and minus the gradient of (25), all-to-all, N = 12,\n\
         w0 = K_0 = {OMEGA}. The paper gives the signs of the K_m only. Chosen: K_m = {below}\n\
         for m < M and K_M = -{last}, step {}, to t = {}, start 0 of paley.fig4.\n{START}\n\
         \x20 M   pattern  M|p_M|    max m|p_m|, m<M  max|u-w0|  centres/radius\n",
        PatternFormation::STEP,
        PatternFormation::STEP * PatternFormation::STEPS as f64,
    );
    let mut picture = Picture::new("Figure 4: symmetric circular formations, N = 12, ω_0 = K_0 = 0.1")
        .caption(super::paley::SIGNS)
        .grid(3, (340.0, 330.0));
    let mut table = Vec::new();
    let made = side_by_side(&[1usize, 2, 3, 4, 6, 12], |&clusters| {
        Ok((clusters, PatternFormation::of_clusters(clusters).trajectory(start("paley.fig4", 0), 1)?))
    });
    for (clusters, trajectory) in made.into_iter().collect::<Result<Vec<_>, CheckError>>()? {
        let formation = PatternFormation::of_clusters(clusters);
        let flight = end(&trajectory)?;
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{clusters:3}   {:7}  {:.6}  {:15.1e}  {:9.1e}  {:14.1e}",
            if flight.forms_pattern(clusters, CLUSTER) { "yes" } else { "NO" },
            order(flight, clusters as u32)?,
            largest_lower_moment(flight, clusters)?,
            turning_error(OMEGA, &formation.steering(&flight.state())?),
            centre_spread(&OMEGA, &flight.state())? * OMEGA,
        );
        // A turn takes 62.8.
        let turn = &trajectory[trajectory.len() - 33..];
        picture = picture.panel(scene(format!("M = {clusters}"), turn, &Complex::new(0.0, 0.0))?);
        table.extend(rows(&clusters.to_string(), turn));
    }
    text += "\nPattern: M equal clusters, evenly spaced within 5 degrees. In an (M,N)-pattern\n\
             M|p_M| = 1 and p_m = 0 for m < M (paley.eq23). Exponentially stable for all\n\
             gains of these signs (paley.thm3.stab); but with larger |K_M| other states are\n\
             stable as well, and starts miss the pattern (paley.basins).\n";
    Ok(Reproduced::new(text).table("", csv(COLUMNS, table)).picture("", picture))
}
