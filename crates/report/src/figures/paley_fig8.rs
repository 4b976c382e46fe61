//! Figure 8 of Paley and others: circular formations for growing zones of orientation.

use super::paley::{COLUMNS, START, end, rows, scene, start, zone_outline};
use super::{Reproduced, csv};
use crate::plot::{Picture, Series};
use arithmetic::Complex;
use arithmetic::threads::side_by_side;
use ledger::CheckError;
use models::oscillator::{CLUSTER, Flight, centre_spread, shape_rate};
use runs::{Experiment, OMEGA, ZoneFormation, ZoneLaw};
use std::fmt::Write;

/// The claim whose starts are used, and how many of them.
const CLAIM: &str = "paley.fig8.pos";
const STARTS: u64 = 8;
/// `K_0`, and the size of `K_1`, which the paper does not give.
const GAIN: f64 = 0.1;
/// A shape that changes more slowly is at rest; centres nearer together, as a share of the radius, are one circle.
const REST: f64 = 0.01;
const ONE_CIRCLE: f64 = 0.02;

/// What one run came to.
struct Ended {
    clusters: Vec<(usize, f64)>,
    spread: f64,
    rate: f64,
}

fn ended(formation: &ZoneFormation, flight: &Flight) -> Result<Ended, CheckError> {
    let state = flight.state();
    Ok(Ended {
        clusters: flight.clusters(CLUSTER),
        spread: centre_spread(&OMEGA, &flight.state())? * OMEGA,
        rate: shape_rate(&state, &formation.steering(&state)?),
    })
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let mut text = format!(
        "N = 12, w0 = K_0 = {OMEGA}, blind spot 60 degrees. Chosen: attraction at any distance,\n\
         K_1 = -{GAIN} and {GAIN}, step {}, to t = {}, starts 0 to {} of {CLAIM}\n\
         (pictures: start 0); the steps are of circle centres and phases.\n{START}\
         (29) as printed puts -K_0 on the wrong network (paley.eq29, false): (a), (b)\n\
         have the printed law, (c) the corrected one. Clusters and gaps: means.\n\n\
         \x20    K_1  (29)        M  clusters  gap   on one circle  shape at rest\n",
        ZoneFormation::STEP,
        ZoneFormation::STEP * ZoneFormation::STEPS as f64,
        STARTS - 1,
    );
    let columns = [
        ("a", ZoneLaw::Printed, -GAIN, "K_1 < 0, (29) as printed"),
        ("b", ZoneLaw::Printed, GAIN, "K_1 > 0, (29) as printed"),
        ("c", ZoneLaw::Corrected, GAIN, "K_1 > 0, (29) corrected"),
    ];
    // As in the paper: M = 2, 8, 12 from top to bottom.
    let panels: Vec<_> = ZoneFormation::CLUSTERS
        .into_iter()
        .rev()
        .flat_map(|clusters| {
            columns.map(|(column, law, orientation, name)| {
                (column, name, ZoneFormation::new(law, (GAIN, orientation), clusters))
            })
        })
        .collect();
    let runs = side_by_side(&panels, |(_, _, formation)| {
        let shown = formation.trajectory(start(CLAIM, 0), 2)?;
        let first = ended(formation, end(&shown)?);
        let replicates: Vec<u64> = (1..STARTS).collect();
        let others = side_by_side(&replicates, |&replicate| ended(formation, &formation.end(start(CLAIM, replicate))?));
        let others = others.into_iter().collect::<Result<Vec<_>, CheckError>>()?;
        Ok((shown, std::iter::once(first).chain(others.into_iter().map(Ok)).collect::<Result<Vec<_>, CheckError>>()?))
    });
    let runs = runs.into_iter().collect::<Result<Vec<_>, CheckError>>()?;
    let mut picture = Picture::new("Figure 8: circular formations and zones of orientation (patches), N = 12")
        .caption(super::paley::SIGNS)
        .grid(3, (350.0, 340.0));
    let (mut table, mut summary) = (Vec::new(), Vec::new());
    for ((column, name, formation), (shown, all)) in panels.iter().zip(&runs) {
        let count = all.len() as f64;
        let mean = |of: &dyn Fn(&Ended) -> f64| all.iter().map(of).sum::<f64>() / count;
        let gap = |run: &Ended| run.clusters.iter().map(|(_, gap)| gap).sum::<f64>() / run.clusters.len() as f64;
        let share = |of: &dyn Fn(&Ended) -> bool| all.iter().filter(|run| of(run)).count();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "({column})  {}  {:9} {:3}  {:8.2}  {:3.0}°  {:8} of {STARTS}  {:8} of {STARTS}",
            if formation.orientation < 0.0 { "< 0" } else { "> 0" },
            formation.law.word(),
            formation.clusters,
            mean(&|run| run.clusters.len() as f64),
            mean(&gap).to_degrees(),
            share(&|run| run.spread < ONE_CIRCLE),
            share(&|run| run.rate < REST),
        );
        // A turn takes 62.8.
        let turn = &shown[shown.len() - 33..];
        let last = end(shown)?;
        let first = all.first().map_or(0, |run| run.clusters.len());
        let plural = if first == 1 { "" } else { "s" };
        let title = format!("({column}) M = {}, {name}: {first} cluster{plural}", formation.clusters);
        let mut scene = scene(title, turn, &Complex::new(0.0, 0.0))?;
        for (r, theta) in last.positions.iter().zip(&last.phases) {
            let outline = zone_outline(&formation.zone(), (0.0, formation.radius()), r, *theta);
            scene = scene.below(Series::area("", outline).colour("#d9d9d9"));
        }
        picture = picture.panel(scene);
        let label = format!("{column}-{}", formation.clusters);
        table.extend(rows(&label, turn).collect::<Vec<_>>());
        for (replicate, run) in all.iter().enumerate() {
            let sizes: Vec<String> = run.clusters.iter().map(|(size, _)| size.to_string()).collect();
            summary.push([
                label.clone(),
                replicate.to_string(),
                run.clusters.len().to_string(),
                sizes.join("-"),
                format!("{:.6}", run.spread),
                format!("{:.6}", run.rate),
            ]);
        }
    }
    let _ = writeln!(
        text,
        "\nOn one circle: centres within {ONE_CIRCLE} of the radius of their mean. At rest: no\n\
         relative position changes faster than {REST}.\n\
         (a) fewer, larger clusters in larger zones: paley.fig8.neg.\n\
         (b) False: clusters that suit the zone. At K_1 = K_0 the printed law does not\n\
         contain the zone, and all three runs of a start are the same (paley.fig8.pos).\n\
         (c) The corrected law gives about M clusters for M = 12 and 8, but the particles\n\
         do not settle on one circle there. With K_1 = 5 K_0 they do not under the\n\
         printed law either (paley.fig8.circ)."
    );
    Ok(Reproduced::new(text)
        .table("", csv(COLUMNS, table))
        .table("runs", csv("panel,start,clusters,sizes,centre_spread_over_radius,shape_rate", summary))
        .picture("", picture))
}
