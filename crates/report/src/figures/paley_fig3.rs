//! Figure 3 of Paley and others: circular formations on the cyclic graph, for K_1 negative, zero and positive.

use super::paley::{COLUMNS, START, Timed, end, first_run, rows, scene, turning_error};
use super::paley_abscissa::{rate, twisted};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::Complex;
use ledger::CheckError;
use models::oscillator::{CLUSTER, Flight, centre_spread, nearest_twist, order, pattern, phase_potential};
use runs::{CyclicFormation, Experiment, OMEGA, PARTICLES};
use std::fmt::Write;

const CLAIM: &str = "paley.fig3";
/// Steps between the states that are kept, starts that are tried, the raised gain of panel (d).
const EVERY: usize = 1;
const MOST: u64 = 40;
const RAISED: f64 = 4.0 * CyclicFormation::GAIN;
/// Centres nearer together than this share of the radius are one circle.
const ONE_CIRCLE: f64 = 0.01;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let find = |sign: f64, wanted: &dyn Fn(&Flight) -> bool| {
        let circular =
            |flight: &Flight| Ok::<bool, CheckError>(centre_spread(&OMEGA, &flight.state())? * OMEGA < ONE_CIRCLE);
        let formation = CyclicFormation::new(sign * CyclicFormation::GAIN);
        first_run(&formation, CLAIM, (EVERY, MOST), |flight| Ok(circular(flight)? && wanted(flight)))
    };
    let synchronised = find(-1.0, &|flight| flight.forms_pattern(1, CLUSTER))?;
    let arbitrary = find(0.0, &|flight| pattern(flight).is_none())?;
    let splay = find(1.0, &|flight| flight.forms_pattern(PARTICLES, CLUSTER))?;
    let pairs = find(1.0, &|flight| flight.forms_pattern(2, CLUSTER))?;
    let raised = CyclicFormation::new(RAISED).trajectory(end(&splay.1)?.clone(), EVERY)?;
    let panels: [(&str, f64, &str, u64, Vec<Timed>); 5] = [
        ("a", -CyclicFormation::GAIN, "synchronised", synchronised.0, synchronised.1),
        ("b", 0.0, "arbitrary", arbitrary.0, arbitrary.1),
        ("c", CyclicFormation::GAIN, "splay", splay.0, splay.1),
        ("d", RAISED, "gain raised on (c): splay as before", splay.0, raised),
        ("e", CyclicFormation::GAIN, "another start: (2,N) pattern", pairs.0, pairs.1),
    ];
    let gain = CyclicFormation::GAIN;
    let mut text = format!(
        "(22) on C_12, w0 = {OMEGA}, K_0 = N w0 = {:.1}. The paper gives the sign of K_1 only.\n\
         Chosen: K_1 = -{gain}, 0, {gain} and in (d) {RAISED}; step {}, to t = {}.\n{START}\
         Each panel has the first of {MOST} starts of {CLAIM} that ends as its caption\n\
         says (column start); how often that is: paley.basins.\n\n\
         \x20    K_1  start  state         |p_theta|  W_1       max|u-w0|  centres/radius\n",
        PARTICLES as f64 * OMEGA,
        CyclicFormation::STEP,
        CyclicFormation::STEP * CyclicFormation::STEPS as f64,
    );
    let mut picture =
        Picture::new("Figure 3: circular formations under (22) on the cyclic graph, N = 12, ω_0 = 0.1, K_0 = Nω_0")
            .caption(super::paley::SIGNS)
            .caption(
                "(d) goes on where (c) ends, with its clock at 0 again: in (f) the two lie on one another at the end.",
            )
            .grid(3, (350.0, 340.0));
    let mut potentials = Panel::new(
        "(f) the phase potential",
        Axis::linear("time (speed 1, lengths as in the panel)"),
        Axis::linear("W_1").between(-0.1, 2.1),
    );
    let (mut table, mut curves) = (Vec::new(), Vec::new());
    for (panel, gain, name, replicate, trajectory) in &panels {
        let formation = CyclicFormation::new(*gain);
        let last = end(trajectory)?;
        let state = last.state();
        let w = |flight: &Flight| phase_potential(formation.network(), &flight.state().phasors, 1);
        let reached = match pattern(last) {
            Some(1) => "synchronised".to_string(),
            Some(clusters) => format!("({clusters},N), m = {}", nearest_twist(&last.phases).0),
            None => "no pattern".to_string(),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "({panel}) {gain:4}  {replicate:5}  {reached:13} {:8.6}  {:8.6}  {:9.1e}  {:9.1e}",
            order(last, 1)?,
            w(last)?,
            turning_error(OMEGA, &formation.steering(&state)?),
            centre_spread(&OMEGA, &last.state())? * OMEGA,
        );
        // A turn takes 62.8.
        let turn = &trajectory[trajectory.len() - 33 / EVERY..];
        let title = format!("({panel}) K_1 = {gain}: {name}").replace('-', "−");
        picture = picture.panel(scene(title, turn, &Complex::new(0.0, 0.0))?);
        let values =
            trajectory.iter().map(|(t, flight)| Ok((*t, w(flight)?))).collect::<Result<Vec<_>, CheckError>>()?;
        table.extend(rows(panel, turn));
        curves.extend(values.iter().map(|(t, w)| [panel.to_string(), t.to_string(), format!("{w:.9}")]));
        potentials = potentials.series(Series::line(format!("({panel}), K_1 = {gain}").replace('-', "−"), values));
    }
    text += "\nLargest real part of the linearisation there, enclosed (paley.abscissa):\n";
    let turning = panels.iter().filter(|(_, gain, ..)| *gain != 0.0);
    let rates = turning.map(|(panel, gain, _, _, trajectory)| {
        let decay = twisted(*gain, nearest_twist(&end(trajectory)?.phases).0)?;
        Ok(format!("({panel}) {}", rate(&decay.abscissa)))
    });
    text += &rates.collect::<Result<Vec<_>, CheckError>>()?.join("   ");
    text.push('\n');
    text += "\nFalse: that more K_1 turns (c) into the (2,N)-pattern. Both are exponentially\n\
             stable for every K_1 > 0; the start decides (paley.fig3.gain; panel d).\n\
             Holds: W_1 is largest, 2, in the alternating (2,N)-pattern (paley.fig3.max).\n\
             m: th_k = 2 pi m k/12 up to a rotation. The panels are not the only outcomes:\n\
             for K_1 < 0 the states m = 1, 2 are stable too (beyond.paley.cyclic_patterns,\n\
             paley.basins).\n";
    Ok(Reproduced::new(text)
        .table("", csv(COLUMNS, table))
        .table("potential", csv("panel,t,W_1", curves))
        .picture("", picture.panel(potentials)))
}
