//! tanner2.fig4, fig4.close, fig5, fig6: the simulations of Section 6, over many seeds.
//!
//! Declared, since the paper does not give it: the potential `1/s + log s` of the companion paper (desired distance 1 m); random
//! graphs with each edge present with probability 1/2, drawn until connected; positions, speeds and directions evenly
//! distributed. Agreement means a disagreement `sqrt(sum |v_i - mean|²)` of at most one hundredth of the initial one. The runs
//! are those that the figures of `reproduce` draw. How reports of runs are read is said in `notes/guarantees.md`.

use super::fixtures::sloped;
use crate::prelude::*;
use crate::shares::{Seen, report};
use models::double_integrator::{LinkRule, Setup, Trial};
use motion::Share;

/// Fixed random graphs.
const FIXED: LinkRule = LinkRule::Random(0.5);
/// Links within 2 m, from starts that are connected.
const CONNECTED: Reading = plain(LinkRule::Within { radius: Setup::RADIUS, connected: true });
/// Links within 2 m, from any start.
const FROM_ANY: Reading = Reading {
    links: LinkRule::Within { radius: Setup::RADIUS, connected: false },
    weaker: 1,
    words: ", from any start",
};

const fn plain(links: LinkRule) -> Reading {
    Reading { links, weaker: 1, words: "" }
}

/// Links within so many metres, from any start.
const fn within(radius: f64, words: &'static str) -> Reading {
    Reading { links: LinkRule::Within { radius, connected: false }, weaker: 1, words }
}

/// What is looked for at the end of a run, for one clause.
#[derive(Clone, Copy)]
struct Part {
    what: &'static str,
    seen: fn(&Trial) -> bool,
    /// Whether a positive share is enough, or more than half is needed.
    can: bool,
}

/// One way to fill in what the paper leaves open.
#[derive(Clone, Copy)]
struct Reading {
    links: LinkRule,
    /// The potential is `1/s + log s` over this.
    weaker: i64,
    words: &'static str,
}

/// The law of the runs under each reading, and what is looked for.
#[derive(Clone, Copy)]
pub struct FigureVariant {
    readings: &'static [Reading],
    /// With `V = 1/s`, which only repels.
    repulsive: bool,
    parts: &'static [Part],
}

/// No links, whatever the distances.
const NONE: Reading = within(1e-6, ", without links");

/// Seconds.
const UNTIL: f64 = 100.0;

fn examine(variant: &FigureVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let runs = variant.readings.iter().map(|reading| Ok((reading, trials(reading, variant.repulsive, run)?)));
    let runs = runs.collect::<Result<Vec<_>, CheckError>>()?;
    let judged = variant.parts.iter().enumerate().map(|(k, part)| {
        let seen = (1..).zip(&runs).map(|(place, (reading, trials))| {
            let share = Share::count(trials, |trial| (part.seen)(trial));
            let name = format!("end of the run, clause {}, reading {place}", k + 1);
            Seen { part: name, what: format!("{}{}: {share}", part.what, reading.words), share }
        });
        let seen: Vec<Seen> = seen.collect();
        if let Some(first) = seen.first() {
            run.value(&format!("share_{}", k + 1), first.share.enclosure());
        }
        Ok(report(seen, part.can).on([k + 1]))
    });
    Run::all(judged.collect::<Vec<_>>())
}

/// The runs under one reading.
fn trials(reading: &Reading, repulsive: bool, run: &Run) -> Result<Vec<Trial>, CheckError> {
    let mut setup = Setup::velocity_alignment(reading.links);
    setup.potential = setup.potential.times(&rational(1, reading.weaker));
    if repulsive {
        setup.potential = sloped(&[(-2, -1)], 1);
    }
    (0..run.cases(40, 200) as u64)
        .map(|seed| {
            run.checkpoint()?;
            let flock = setup.draw(&mut run.random(seed))?;
            Ok(flock.trial(UNTIL, None, &Setup::OPTIONS)?)
        })
        .collect()
}

pub fn fig4() -> Record<FigureVariant> {
    const PARTS: &[Part] =
        &[Part { what: "velocities agree after 100 s", seen: |trial| trial.agrees(0.01), can: false }];
    const READINGS: &[Reading] = &[
        Reading { links: FIXED, weaker: 1, words: ", fixed graph" },
        Reading { links: FIXED, weaker: 32, words: ", fixed graph, with a potential of a 32nd of the strength" },
    ];
    let printed = FigureVariant { readings: READINGS, repulsive: false, parts: PARTS };
    Record::new(
        "tanner2.fig4",
        "Ten agents, random connected fixed graphs: with V = 1/s + log s nearly all runs agree after 100 s. The paper does not give its potential, and with a weaker one most runs need longer.",
        printed,
        examine,
    )
    .reading("a report of a run: typical, more than half of all runs whatever the potential, which is not given (notes/guarantees.md)")
    .altered("without links", |v| v.readings = &[NONE])
    .altered("links within 1.5 m", |v| v.readings = const { &[within(1.5, ", links within 1.5 m")] })
}

pub fn fig4_close() -> Record<FigureVariant> {
    const PARTS: &[Part] = &[Part {
        what: "two agents that are not linked end within a quarter of the desired distance, but not in one place",
        seen: |trial| trial.end.least_unlinked < 0.25 && trial.end.least_unlinked > 0.0,
        can: true,
    }];
    let printed = FigureVariant { readings: const { &[plain(FIXED)] }, repulsive: false, parts: PARTS };
    Record::new(
        "tanner2.fig4.close",
        "Nothing keeps agents that are not linked apart (tanner2.noninter); two with the same neighbours are drawn to the same place.",
        printed,
        examine,
    )
    .reading("\"may\": a positive share of the runs (notes/guarantees.md)")
    .altered("without links", |v| v.readings = &[NONE])
    .altered("links within 2 m", |v| v.readings = &[FROM_ANY])
}

pub fn fig5() -> Record<FigureVariant> {
    const PARTS: &[Part] = &[
        Part {
            what: "connected after 100 s, velocities agree",
            seen: |trial| trial.end.components == 1 && trial.agrees(0.01),
            can: false,
        },
        Part { what: "at least half of all links", seen: |trial| trial.end.density() >= 0.5, can: false },
        Part { what: "not all links", seen: |trial| trial.end.density() < 1.0, can: true },
    ];
    let printed = FigureVariant { readings: &[CONNECTED, FROM_ANY], repulsive: false, parts: PARTS };
    Record::new(
        "tanner2.fig5",
        "The share is not conditional on staying connected: about four of five runs end so, the others split as in Figure 6; of the runs that end connected, all agree. \
         From any start about half of all runs end so (reproduce tanner2.fig5), as only one start in three or four is connected. The final graph is never complete.",
        printed,
        examine,
    )
    .clauses(&[
        "After 100 s all velocities are synchronized.",
        "In steady state connectivity is high.",
        "The neighboring graph is not necessarily complete.",
    ])
    .reading("a report of a run: typical, more than half of all runs, from connected starts and from any, since the text says neither (notes/guarantees.md)")
    .altered("with V = 1/s, which only repels", |v| v.repulsive = true)
    .altered("links within 1.5 m", |v| v.readings = const { &[within(1.5, ", links within 1.5 m")] })
}

pub fn fig6() -> Record<FigureVariant> {
    const PARTS: &[Part] = &[
        Part {
            what: "connected at the start: more than one component after 100 s",
            seen: |trial| trial.start.components == 1 && trial.end.components > 1,
            can: true,
        },
        Part {
            what: "several components, and velocities agree within each",
            seen: |trial| trial.start.components == 1 && trial.end.components > 1 && trial.components_agree(0.01),
            can: true,
        },
    ];
    let printed = FigureVariant { readings: &[CONNECTED], repulsive: false, parts: PARTS };
    Record::new(
        "tanner2.fig6",
        "About one in five runs from a connected start ends in several components, which agree within themselves (proved for a box of starts in beyond.tanner2.certified_split).",
        printed,
        examine,
    )
    .clauses(&[
        "With distance dependent links connectivity may be lost.",
        "The group then splits into several connected components, which can flock independently.",
    ])
    .reading("\"may\" and \"can\": a positive share of the runs from connected starts, since only what is connected can be lost (notes/guarantees.md)")
    .altered("links within 20 m", |v| v.readings = const {
        &[Reading { links: LinkRule::Within { radius: 20.0, connected: true }, weaker: 1, words: ", links within 20 m" }]
    })
    .altered("on fixed connected graphs", |v| v.readings = const { &[Reading { links: FIXED, weaker: 1, words: ", fixed graph" }] })
}
