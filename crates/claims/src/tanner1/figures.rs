//! tanner1.figs3_6, figs7_10: the simulations of Section V, over many seeds.
//!
//! The paper gives ten agents and a ball of radius 20 for positions and velocities; the readings of what it leaves open are those of
//! [`HeadingReading`], and the runs are those that the figures of `reproduce` draw. A common heading is a largest wrapped
//! difference below 1/10; a potential energy minimum shows in every `|grad V_i|` below 1/10, a tight formation in all agents
//! within 10 m of their mean (far apart, gradients are small too).

use crate::shares::judged;
use crate::tanner2::figures::other;
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{HeadingReading, Setup};
use motion::Share;

/// The runs and what is claimed of them.
#[derive(Clone, Copy)]
pub struct FigureVariant {
    complete: bool,
    /// In each of these the share has to be large enough.
    readings: &'static [HeadingReading],
    until: f64,
    heading: f64,
    gradient: f64,
    /// The interval of the share has to lie above this.
    above: f64,
}

/// Within this distance of their mean, in metres, the agents are in a tight formation.
const TIGHT: f64 = 10.0;

fn examine_reading(variant: &FigureVariant, reading: HeadingReading, run: &mut Run) -> Result<Outcome, CheckError> {
    let setup = Setup::heading_alignment(variant.complete, reading);
    let (mut formations, mut headings, mut narrowest) = (Share::default(), Share::default(), f64::INFINITY);
    for seed in 0..run.cases(12, 100) as u64 {
        run.checkpoint()?;
        let flock = setup.draw(&mut run.random(seed)).map_err(other)?;
        let end = flock.trial(variant.until, None, &Setup::OPTIONS).map_err(other)?.end;
        formations = formations.with(end.is_formation(variant.heading, variant.gradient, TIGHT));
        headings = headings.with(end.heading_spread < variant.heading);
        narrowest = narrowest.min(end.radius);
    }
    let what = format!(
        "{}, after {} s: common heading and potential minimum in {formations}; common heading in {headings}; least radius of a flock {narrowest:.1} m",
        reading.describe(),
        variant.until
    );
    run.value(&format!("share_{reading:?}").to_lowercase(), formations.enclosure());
    let evidence = Evidence::new(Grade::Simulated, "end of the run", what.clone()).cases(formations.of);
    Ok(judged(formations, variant.above, what, evidence))
}

fn examine(variant: &FigureVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let parts: Vec<_> = variant.readings.iter().map(|reading| examine_reading(variant, *reading, run)).collect();
    Run::all(parts)
}

const TYPICAL: FigureVariant = FigureVariant {
    complete: true,
    readings: &[HeadingReading::Slow, HeadingReading::Spring],
    until: 200.0,
    heading: 0.1,
    gradient: 0.1,
    above: 0.5,
};

pub fn complete() -> Record<FigureVariant> {
    Record::new(
        "tanner1.figs3_6",
        "Reading: the numbers as printed, with the only potential that the paper prints; typical if more than half of all runs end in a formation after 200 s. None does: speeds up to 20 m/s are too much for V = 1/s + log s. The alignment forces turn a heading by about pi |theta_i - theta_j|/(v d) \
         where two agents pass at speed v and distance d, and do no work; the kinetic energy of the relative motion, about 90 per agent, must be stored in potentials that grow with the logarithm of the distance, so the flock first grows by \
         a factor of about exp(K/(N(N-1))) = exp(10), to hundreds of kilometres (exploratory runs over 100000 s had not returned). The paper allows any potential: with V = s + 1/s - 2 and the printed numbers, and with the printed potential at speeds up to 1 m/s, nearly all runs end as in the figures (reproduce tanner1.figs3_6).",
        FigureVariant { readings: &[HeadingReading::Printed], ..TYPICAL },
        examine,
    )
    .repaired(
        Fault::False,
        "With V_ij = |r_ij|² + 1/|r_ij|² - 2 and the printed numbers, or with the printed potential and speeds up to 1 m/s, more than half of all runs reach a common heading and a potential minimum within 200 s.",
        TYPICAL,
    )
    .control("after 5 s", FigureVariant { until: 5.0, ..TYPICAL })
    .control("gradients below 1e-12 after 20 s", FigureVariant { until: 20.0, gradient: 1e-12, ..TYPICAL })
}

pub fn incomplete() -> Record<FigureVariant> {
    let printed = FigureVariant { complete: false, readings: &[HeadingReading::Spring], above: 0.0, ..TYPICAL };
    Record::new(
        "tanner1.figs7_10",
        "Flocking \"can still be established\" is read as a positive share of the runs with the printed numbers and some potential that the paper allows, here V = s + 1/s - 2. With the printed potential no run ends so at these speeds (a control; tanner1.figs3_6), \
         but at speeds up to 1 m/s about seven in ten do within 200 s.",
        printed,
        examine,
    )
    .control("with the printed potential", FigureVariant { readings: &[HeadingReading::Printed], ..printed })
    .control("after 1 s", FigureVariant { until: 1.0, ..printed })
}
