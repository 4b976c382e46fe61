//! Exploration: which share of random starts ends in which state, for phases on a ring, symmetric patterns and circular formations.

use super::paley::{START, start};
use super::{Reproduced, csv};
use crate::plot::{Axis, Colour, PALETTE, Panel, Picture, Series};
use arithmetic::threads::side_by_side;
use ledger::CheckError;
use models::oscillator::{CLUSTER, Flight, centre_spread, nearest_twist, ring_differences, winding};
use motion::Share;
use runs::{CyclicFormation, Experiment, OMEGA, PatternPhases, RingPhases};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

/// Numbers of starts, fixed before the runs.
const RING_STARTS: u64 = 4000;
const PATTERN_STARTS: u64 = 400;
const CIRCULAR_STARTS: u64 = 400;
/// `M` of the patterns; `K_m = 0.2` below `M`, and these `-K_M`.
const CLUSTERS: [usize; 5] = [2, 3, 4, 6, 12];
const LAST_GAINS: [f64; 2] = [0.04, 0.2];

/// How often each state was reached; `None` where none was.
type Counts<S> = BTreeMap<Option<S>, usize>;

/// Follows the starts of the name to their ends.
fn count<S: Ord + Send + Sync>(
    name: &str,
    starts: u64,
    end: impl Fn(Flight) -> Result<Option<S>, CheckError> + Sync,
) -> Result<Counts<S>, CheckError> {
    let replicates: Vec<u64> = (0..starts).collect();
    let ends = side_by_side(&replicates, |&replicate| end(start(name, replicate)));
    let mut counts = BTreeMap::new();
    for state in ends.into_iter().collect::<Result<Vec<_>, _>>()? {
        *counts.entry(state).or_insert(0) += 1;
    }
    Ok(counts)
}

/// The winding number, once it cannot change any more: with all differences below a quarter turn the largest does not grow.
fn ring() -> Result<Counts<i64>, CheckError> {
    let settled = |flight: &Flight| {
        let largest = ring_differences(&flight.phases).into_iter().map(f64::abs).fold(0.0, f64::max);
        Ok((largest < FRAC_PI_2).then(|| winding(&flight.phases)))
    };
    let model = RingPhases::default();
    count("paley.basins.ring", RING_STARTS, |flight| Ok(model.until(flight, (5, RingPhases::STEPS), settled)?))
}

/// The state of rest under the negative gradient of (25): `pattern`, or the sizes of the clusters in turn.
fn patterns(clusters: usize, last: f64) -> Result<Counts<String>, CheckError> {
    /// The gradient below which a state counts as at rest.
    const REST: f64 = 1e-6;
    let gains = (1..=clusters).map(|m| if m < clusters { 0.2 } else { -last }).collect();
    let model = PatternPhases { gains };
    let settled = |flight: &Flight| {
        let rest = model.steering(&flight.state())?.iter().all(|slope| slope.abs() < REST);
        Ok(rest.then(|| match flight.forms_pattern(clusters, CLUSTER) {
            true => "pattern".to_string(),
            false => sizes(flight),
        }))
    };
    count("paley.basins.patterns", PATTERN_STARTS, |flight| {
        Ok(model.until(flight, (10, PatternPhases::STEPS), settled)?)
    })
}

/// The sizes of the clusters in turn, from where and in the direction in which they read largest.
fn sizes(flight: &Flight) -> String {
    let sizes: Vec<usize> = flight.clusters(CLUSTER).into_iter().map(|(size, _)| size).collect();
    let turned = |k: usize| sizes[k..].iter().chain(&sizes[..k]).copied().collect::<Vec<usize>>();
    let readings = (0..sizes.len()).map(turned).flat_map(|list| [list.iter().rev().copied().collect(), list]);
    let best = readings.max().unwrap_or_default();
    best.iter().map(usize::to_string).collect::<Vec<_>>().join("-")
}

/// The `m` of a circular formation on `C_12` with the twisted phases `2 pi m k/12`.
fn circular(orientation: f64) -> Result<Counts<i64>, CheckError> {
    /// Differences of phases, in radians, and of centres over the radius, below which the formation is reached.
    const NEAR: f64 = 0.05;
    let settled = |flight: &Flight| {
        let (m, off) = nearest_twist(&flight.phases);
        Ok((off < NEAR && centre_spread(&OMEGA, &flight.state())? * OMEGA < NEAR).then_some(m))
    };
    let formation = CyclicFormation::new(orientation);
    count("paley.basins.circular", CIRCULAR_STARTS, |flight| Ok(formation.until(flight, (5, 3000), settled)?))
}

/// Discs with vertical bars.
fn with_bars(panel: Panel, name: &str, colour: Colour, points: &[(f64, (f64, f64, f64))]) -> Panel {
    let panel = panel.series(Series::points(name, points.iter().map(|(x, (share, ..))| (*x, *share))).colour(colour));
    points.iter().fold(panel, |panel, (x, (_, low, high))| {
        panel.series(Series::line("", [(*x, *low), (*x, *high)]).colour(colour).size(1.6))
    })
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let mut text = format!(
        "EXPLORATION in floating point, not a proof: shares of random starts with 95%\n\
         intervals (Wilson). The numbers of starts were fixed before; none is left out.\n\
         N = 12; steps {}, {} and {} in (i), (ii) and (iii).\n{START}\n\
         state                                     found     share   95% interval\n",
        RingPhases::STEP,
        PatternPhases::STEP,
        CyclicFormation::STEP
    );
    let (mut table, mut panels) = (Vec::new(), Vec::new());
    // Every state is in the table; the text leaves out the rare ones.
    let mut line = |text: &mut String, model: &str, state: &str, (found, of): (usize, u64), shown: bool| {
        let share = Share::new(found, of as usize);
        let (share, (low, high)) = (share.value(), share.interval());
        if shown {
            // Writing to a string cannot fail, here and below.
            let _ = writeln!(text, "  {state:36} {found:>8}  {share:8.4}   [{low:.4}, {high:.4}]");
        }
        let numbers = [share, low, high].map(|x| format!("{x:.5}"));
        let names = [model.to_string(), state.to_string(), found.to_string(), of.to_string()];
        table.push(names.into_iter().chain(numbers).collect::<Vec<_>>());
        (share, low, high)
    };
    let axis = || Axis::linear("share of starts").between(-0.03, 1.03);
    let windings = |panel: &str| Panel::new(panel, Axis::linear("m of the twisted state 2πmk/12"), axis());

    let _ = writeln!(text, "(i) phase model on C_12, K_1 < 0 (its size scales time), {RING_STARTS} starts");
    let mut points = Vec::new();
    for (state, found) in ring()? {
        let name = match state {
            Some(0) => "synchronised, m = 0".to_string(),
            Some(m) => format!("twisted, m = {m}"),
            None => "not decided".to_string(),
        };
        let share = line(&mut text, "ring", &name, (found, RING_STARTS), true);
        points.extend(state.map(|m| (m as f64, share)));
    }
    panels.push(with_bars(windings("(i) phases on C_12, K_1 < 0"), "", PALETTE[0], &points));

    let mut panel =
        Panel::new("(ii) the (M,N)-pattern under (25)", Axis::linear("M").ticks([2.0, 3.0, 4.0, 6.0, 12.0]), axis());
    for (k, last) in LAST_GAINS.into_iter().enumerate() {
        let _ = writeln!(text, "(ii) phase model under (25), K_m = 0.2, K_M = -{last}, {PATTERN_STARTS} starts each");
        let mut points = Vec::new();
        for clusters in CLUSTERS {
            let counts = patterns(clusters, last)?;
            let model = format!("pattern M={clusters} K_M=-{last}");
            let found = counts.get(&Some("pattern".to_string())).copied().unwrap_or(0);
            let name = format!("M = {clusters}: the ({clusters},12)-pattern");
            let share = line(&mut text, &model, &name, (found, PATTERN_STARTS), true);
            points.push((clusters as f64 + 0.12 * k as f64, share));
            let mut others: Vec<_> =
                counts.into_iter().filter(|(state, _)| state.as_deref() != Some("pattern")).collect();
            others.sort_by(|(a, m), (b, n)| n.cmp(m).then(a.cmp(b)));
            for (n, (state, found)) in others.into_iter().enumerate() {
                let name = state.map_or("not at rest".to_string(), |sizes| format!("clusters {sizes}"));
                line(&mut text, &model, &format!("       {name}"), (found, PATTERN_STARTS), n < 2);
            }
        }
        panel = with_bars(panel, &format!("K_M = −{last}"), PALETTE[k], &points);
    }
    panels.push(panel);

    let mut panel = windings("(iii) circular formations on C_12");
    for (k, orientation) in [-CyclicFormation::GAIN, CyclicFormation::GAIN].into_iter().enumerate() {
        let _ = writeln!(
            text,
            "(iii) circular control (22) on C_12, K_0 = 1.2, K_1 = {orientation}, {CIRCULAR_STARTS} starts"
        );
        let mut points = Vec::new();
        for (state, found) in circular(orientation)? {
            let name = match state {
                Some(0) => "synchronised, m = 0".to_string(),
                Some(6) => "(2,12)-pattern, m = 6".to_string(),
                Some(m) => format!("twisted, m = {m}"),
                None => "not reached by t = 6000".to_string(),
            };
            let share = line(&mut text, &format!("circular K_1={orientation}"), &name, (found, CIRCULAR_STARTS), true);
            points.extend(state.map(|m| (m as f64, share)));
        }
        panel = with_bars(panel, &format!("K_1 = {orientation}").replace('-', "−"), PALETTE[k], &points);
    }
    panels.push(panel);
    text += "\nStopping: (i) when all phase differences along the ring are below a quarter\n\
             turn: from then on the largest cannot grow (sin increases there), so that the\n\
             winding number is final and the twisted state with it the only limit; (ii) when\n\
             every component of the gradient is below 1e-6, else at t = 4000; pattern: within\n\
             5 degrees; clusters: 10 degrees; rarer states are in the table; (iii) when all\n\
             differences are within 0.05 of 2 pi m/12 and the centres within 0.05 of the\n\
             radius, else at t = 6000. Exactly stable there: |m| <= 2 for K_1 < 0 and\n\
             4 <= |m| <= 6 for K_1 > 0 (beyond.paley.cyclic_patterns).\n";
    let picture = Picture::new("Exploration: shares of random starts, with 95% intervals").grid(3, (350.0, 350.0));
    let picture = panels.into_iter().fold(picture, Picture::panel);
    Ok(Reproduced::new(text).table("", csv("model,state,found,starts,share,low,high", table)).picture("", picture))
}
