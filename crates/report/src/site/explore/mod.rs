//! Motions that can be watched: counterexamples and examples of the papers, computed by the engine and drawn in the page.

mod cases;
mod live;
mod runs;
mod sketches;
mod starts;

use super::{Site, Texts};
use crate::page::Links;
use crate::page::player::Motion;
pub(super) use live::LIVE;
use maud::{Markup, html};
pub use runs::RunsError;
pub(super) use starts::FILES;

/// The program that asks the program which serves the page.
pub(super) const ASKER: &str = include_str!("live.js");

/// A page with motions.
pub(super) struct Show {
    /// The name of the page.
    pub name: &'static str,
    pub title: &'static str,
    /// What is to be seen.
    pub about: &'static str,
    /// What is drawn, and how it was computed.
    pub drawn: &'static str,
    /// The claims it belongs to.
    pub claims: &'static [&'static str],
    runs: fn() -> Result<Vec<Motion>, runs::RunsError>,
}

/// All of them.
pub(super) const SHOWS: &[Show] = &[
    Show {
        name: "four-birds",
        title: "Four birds that change their network for ever",
        about: "Without hysteresis the two birds in the middle meet and part in every step, for ever. With the hysteresis of the paper, \
                a threshold of 4^(-256), they do the same until their distance changes by less than that: from then on the link stays.",
        drawn: "The birds fly on a line: the upper row without hysteresis, the lower row with that of the paper. Positions are exact rational numbers, rounded for drawing.",
        claims: &["chazelle.ex4birds.alt", "chazelle.ex4birds.eq3.14", "chazelle.hyst"],
        runs: runs::four_birds,
    },
    Show {
        name: "two-agents",
        title: "Two agents that swing for ever",
        about: "Heading alignment with two linked agents that have the same heading: nothing takes energy out, and their distance swings for \
                ever. The distances are not stabilised, as the paper says they are.",
        drawn: "Seen from the middle between them; V = 1/s + log s, s the squared distance; classical integration in floating point.",
        claims: &["tanner1.propIV3b", "tanner1.proof_cases", "tanner1.eq7", "beyond.tanner1.two_agents"],
        runs: runs::two_agents,
    },
    Show {
        name: "turning-triangle",
        title: "Three agents that turn for ever",
        about: "Three linked agents on an equilateral triangle that turns about its centre: with heading differences between -pi and pi their \
                headings stay a third of a turn apart and never agree.",
        drawn: "V = 1/s + log s, squared side 2, angular velocity squared 3/2; floating point from the exact start.",
        claims: &["beyond.tanner1.turning_triangle", "tanner1.propIV3a"],
        runs: runs::turning_triangle,
    },
    Show {
        name: "tower",
        title: "Networks that change at towers of exponentials",
        about: "Four groups of four birds, some mirrored, merge at t = 171. Their drifts differ by so little that neighbours meet only at a time of 85 digits. The drifts of the two that meet cancel \
                exactly; what is left lets two flocks of eight meet at a time between 2^(2.116 10^84) and 2^(2.117 10^84).",
        drawn: "The clock is the logarithm of the time, and then the logarithm of that. Up to t = 321 every step is exact; after that each flock moves at its exact mean velocity, the switches are those that are \
                settled exactly, and the last approach is drawn at even speed. Rounded for drawing.",
        claims: &["beyond.chazelle.tower", "chazelle.lower_bound"],
        runs: runs::tower,
    },
    Show {
        name: "saddle",
        title: "Three agents that come to rest at a saddle",
        about: "All pairs linked, in a row, with velocities along the row: by symmetry they stay in it, and come to rest where the potential is not least, but at a saddle. Moved aside by a thousandth, \
                the middle agent leaves, and they come to rest in a triangle.",
        drawn: "V = 1/s + log s, s the squared distance; the saddle has neighbours at distance sqrt(3)/2. Classical integration in floating point; the rest at the saddle is exact for every start in a row.",
        claims: &["tanner2.thm1c", "tanner2.thm2_pot", "tanner2.sec4.flocking"],
        runs: runs::saddle,
    },
    Show {
        name: "certified-split",
        title: "A flock that breaks up for ever, certified",
        about: "Three agents with links within distance 2. The third leaves; its link ends before t = 17/100, and the network never \
                changes again. That is proved for an open set of starts, by enclosures of all their solutions.",
        drawn: "One start of the set, V = s + 1/s - 2, in floating point; the proof is by intervals.",
        claims: &["beyond.tanner2.certified_split", "tanner2.fig6"],
        runs: runs::split,
    },
    Show {
        name: "patterns",
        title: "Patterns of twelve particles",
        about: "Steered particles with all-to-all coupling gather on one circle in M clusters, evenly spaced, for each M that divides 12: \
                the gains K_m are positive below M, and K_M is negative.",
        drawn: "omega0 = K_0 = 0.1; random starts within 10 of the origin; floating point. Arrows show the direction of motion.",
        claims: &["paley.fig4", "paley.thm3.stab", "beyond.paley.abscissa"],
        runs: runs::patterns,
    },
    Show {
        name: "platoon-wave",
        title: "The platoon's wave",
        about: "The leader moves to and fro by 1 at the main resonance; the movement grows along the flock until the last car moves \
                many times as far. It takes many periods to build up.",
        drawn: "Deviation of each car from its place, the leader on the left; system (2), f = g = -1, 20 followers from rest; floating point.",
        claims: &["veerman.sec6_fig2", "veerman.thm1_amp", "veerman.thm1_omega"],
        runs: runs::platoon,
    },
];

impl Show {
    /// Its motions, computed.
    ///
    /// # Errors
    /// The sentence of what could not be computed.
    pub fn motions(&self) -> Result<Vec<Motion>, RunsError> {
        (self.runs)()
    }
}

/// The list of motions, with a small picture of the first one of each show, and of what the live pages ask about.
///
/// # Errors
/// The sentence of what could not be computed.
pub(super) fn list(pictures: &[Markup], texts: Texts) -> Result<Markup, RunsError> {
    let sketch = |live: &live::Live| live.sketch.map_or(Ok(None), |sketch| sketch(texts));
    let sketches = LIVE.iter().map(sketch).collect::<Result<Vec<_>, RunsError>>()?;
    Ok(html! {
        h1 { "Explore" }
        p.lead { "Examples and counterexamples that move. Each was computed by the program; play, step, or drag the slider." }
        ul.shows { @for (show, picture) in SHOWS.iter().zip(pictures) { li { a href={ (show.name) ".html" } { (picture) (show.title) } } } }
        h2 { "Live" }
        p { "Each shows one answer here; under " code { "flockproof serve" } " they ask the program." }
        ul.shows {
            @for (live, sketch) in LIVE.iter().zip(&sketches) {
                li { a href={ (live.name) ".html" } { @if let Some(picture) = sketch { (picture) } (live.title) } }
            }
        }
    })
}

/// The page of a live one.
///
/// # Errors
/// The sentence of what could not be computed.
pub(super) fn live(live: &live::Live, texts: Texts) -> Result<Markup, RunsError> {
    live::body(live, texts)
}

/// The page of one show.
pub(super) fn body(site: &Site, show: &Show, runs: &[Motion]) -> Markup {
    html! {
        h1 { (show.title) }
        p.lead { (site.names.rich(show.about, Links::Folder)) }
        @for run in runs {
            section.live aria-label=(run.title) {
                @if runs.len() > 1 { h2 { (site.names.rich(&run.title, Links::Folder)) } }
                (run.section(&format!("{}: {}", show.title, run.title)))
            }
        }
        p.small { (site.names.rich(show.drawn, Links::Folder)) }
        p { "Claims: " @for (k, id) in show.claims.iter().enumerate() { @if k > 0 { ", " } (site.names.linked(id, Links::Folder)) } "." }
        script src="../explore.js" defer {}
    }
}
