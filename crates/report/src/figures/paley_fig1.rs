//! Figure 1 of Paley and others: four types of motion under the all-to-all control (9).

use super::paley::{COLUMNS, START, end, rows, scene, start, turning_error};
use super::{Reproduced, csv};
use crate::plot::Picture;
use arithmetic::Complex;
use ledger::CheckError;
use models::oscillator::{mean, order, shape_rate};
use runs::{Experiment, FourMotions, OMEGA};
use std::fmt::Write;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let mut picture = Picture::new("Figure 1: four types of motion under the control (9), N = 12")
        .caption(super::paley::SIGNS)
        .grid(2, (470.0, 440.0));
    let mut table = Vec::new();
    let mut text = format!(
        "The paper gives the signs only. Chosen: w0 = 0 and {OMEGA}, K_1 = -1 and 1,\n\
         step {}, to t = {}, start 0 of paley.fig1 in all panels.\n{START}\
         Pictures: paths, particles and velocities at the end, centre of mass (cross).\n\n\
         \x20                             |p_theta|  max|u-w0|  R moves by  shape rate\n",
        FourMotions::STEP,
        FourMotions::STEP * FourMotions::STEPS as f64,
    );
    for (panel, omega, gain, name) in [
        ("a", 0.0, -1.0, "parallel formation"),
        ("b", 0.0, 1.0, "balanced, straight lines"),
        ("c", OMEGA, -1.0, "synchronised circles"),
        ("d", OMEGA, 1.0, "balanced circles"),
    ] {
        let motion = FourMotions { omega, gain };
        let trajectory = motion.trajectory(start("paley.fig1", 0), 5)?;
        let last = end(&trajectory)?;
        let state = last.state();
        let steering = motion.steering(&state)?;
        // From t = 90 on.
        let before = &trajectory[trajectory.len() - 11].1;
        let moved = (mean(&state.positions)? - &mean(&before.positions)?).norm_squared().sqrt();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "({panel}) w0 = {omega:<4} K_1 = {gain:>2}  {:<5} {:9.6}  {:9.1e}  {moved:10.6}  {:10.1e}",
            if gain < 0.0 { "sync." } else { "bal." },
            order(last, 1)?,
            turning_error(omega, &steering),
            shape_rate(&state, &steering),
        );
        let title = format!("({panel}) ω_0 = {omega}, K_1 = {gain}: {name}").replace("-1", "−1");
        picture = picture.panel(scene(title, &trajectory, &Complex::new(0.0, 0.0))?);
        table.extend(rows(panel, &trajectory));
    }
    text += "\nR moves by: |R(100) - R(90)|, 0 where the centre of mass is fixed. Shape rate:\n\
             the largest rate of change of a relative position or phase; 0 in a relative\n\
             equilibrium, which of the four only (a) is (paley.fig1, holds).\n";
    Ok(Reproduced::new(text).table("", csv(COLUMNS, table)).picture("", picture))
}
