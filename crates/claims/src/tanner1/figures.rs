//! tanner1.figs3_6, figs7_10: the simulations of Section V, over many seeds.
//!
//! The paper gives ten agents and a ball of radius 20 for positions and velocities; the readings of what it leaves open are those of
//! [`HeadingReading`], and the runs are those that the figures of `reproduce` draw. A common heading is a largest wrapped
//! difference below 1/10; a potential energy minimum is read as every `|grad V_i|` below 1/10, which a critical point that is no minimum
//! passes too; a tight formation has all agents within 10 m of their mean (far apart, gradients are small too).

use crate::shares::{Seen, report};
use crate::tanner2::fixtures::sloped;
use ledger::{CheckError, Outcome, Record, Run};
use models::double_integrator::{HeadingReading, Setup};
use motion::Share;

/// The runs and what is claimed of them.
#[derive(Clone, Copy)]
pub struct FigureVariant {
    complete: bool,
    readings: &'static [HeadingReading],
    law: Law,
    /// Whether a positive share under one reading is enough.
    can: bool,
}

/// The potential of the runs.
#[derive(Clone, Copy)]
enum Law {
    /// That of the reading.
    Own,
    /// `V = 1/s`, which only repels.
    Repulsive,
    Free,
}

/// Seconds.
const UNTIL: f64 = 200.0;
/// Largest heading difference in radians, largest gradient, largest distance from the mean in metres.
const FORMATION: (f64, f64, f64) = (0.1, 0.1, 10.0);

fn examine(variant: &FigureVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut seen = Vec::new();
    for reading in variant.readings {
        let mut setup = Setup::heading_alignment(variant.complete, *reading);
        let in_place = match variant.law {
            Law::Own => "",
            Law::Repulsive => {
                setup.potential = sloped(&[(-2, -1)], 1);
                ", in its place V = 1/s"
            }
            Law::Free => {
                setup.potential = sloped(&[], 0);
                ", in its place V = 0"
            }
        };
        let (mut formations, mut headings, mut narrowest) = (Share::default(), Share::default(), f64::INFINITY);
        for seed in 0..run.cases(12, 100) as u64 {
            run.checkpoint()?;
            let flock = setup.draw(&mut run.random(seed))?;
            let end = flock.trial(UNTIL, None, &Setup::OPTIONS)?.end;
            formations = formations.with(end.is_formation(FORMATION.0, FORMATION.1, FORMATION.2));
            headings = headings.with(end.heading_spread < FORMATION.0);
            narrowest = narrowest.min(end.radius);
        }
        run.value(&format!("share_{reading:?}").to_lowercase(), formations.enclosure());
        let what = format!(
            "{}{in_place}, after {UNTIL} s: common heading, forces of potentials below 1/10, all within 10 m of the mean in {formations}; common heading in {headings}; least radius of a flock {narrowest:.1} m",
            reading.describe()
        );
        seen.push(Seen { part: format!("end of the run, reading {}", seen.len() + 1), what, share: formations });
    }
    Ok(report(seen, variant.can))
}

/// The readings under which most runs end in a formation.
const FORMING: &[HeadingReading] = &[HeadingReading::Spring, HeadingReading::Slow];

pub fn complete() -> Record<FigureVariant> {
    Record::new(
        "tanner1.figs3_6",
        "With V = s + 1/s - 2 and the printed numbers, and with the printed potential at speeds up to 1 m/s, nearly all runs end as in the figures. With the printed potential and speeds up to 20 m/s none does within 200 s: the alignment forces turn a heading by about pi |theta_i - theta_j|/(v d) \
         where two agents pass at speed v and distance d, and do no work; the kinetic energy of the relative motion, about 90 per agent, must be stored in potentials that grow with the logarithm of the distance, so the flock first grows by \
         a factor of about exp(K/(N(N-1))) = exp(10), to hundreds of kilometres. That refutes no limit: in a run over 3*10^5 s the disagreement of the velocities still decreases (38 m/s after 200 s, 24 after 10^5 s, 22 after 3*10^5 s).",
        FigureVariant { complete: true, readings: &HeadingReading::ALL, law: Law::Own, can: false },
        examine,
    )
    .reading("a report of a run with data that are not printed: typical, more than half of the runs in 200 s, under each reading of the potential and of the unit of the speeds (notes/guarantees.md); a potential energy minimum is read as forces that nearly vanish")
    .altered("with V = 1/s, which only repels", |v| (v.readings, v.law) = (FORMING, Law::Repulsive))
    .altered("without potential", |v| (v.readings, v.law) = (FORMING, Law::Free))
}

pub fn incomplete() -> Record<FigureVariant> {
    Record::new(
        "tanner1.figs7_10",
        "With the printed numbers and V = s + 1/s - 2 nearly all runs end so. With the printed potential no run does within 200 s at these speeds (tanner1.figs3_6), \
         but at speeds up to 1 m/s about seven in ten do.",
        FigureVariant { complete: false, readings: &[HeadingReading::Spring], law: Law::Own, can: true },
        examine,
    )
    .reading("flocking \"can\" be established: a positive share of the runs with the printed numbers and some potential that the paper allows (notes/guarantees.md); a potential energy minimum is read as forces that nearly vanish")
    .altered("with V = 1/s, which only repels", |v| v.law = Law::Repulsive)
    .altered("without potential", |v| v.law = Law::Free)
}
