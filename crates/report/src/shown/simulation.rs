//! A simulated scenario.

use super::{picture, played, table};
use crate::page::player::Motion;
use crate::simulation::simulation_pictures;
use maud::html;
use scenario::{End, Event, Outcome};

/// Most events in the table.
const EVENTS: usize = 200;

/// The run as it moves, its samples, events and plots, and what was run.
pub fn simulation(outcome: &Outcome) -> String {
    let about = format!("{}: the run from t = 0 to {}, in floating point.", outcome.model, outcome.reached());
    let motion = Motion::of_outcome(outcome, format!("the run of {}", outcome.model));
    let names: Vec<String> = outcome
        .rows
        .first()
        .map(|row| row.observables.iter().flat_map(|o| o.columns()).map(|(name, _)| name).collect())
        .unwrap_or_default();
    let head: Vec<&str> = std::iter::once("t").chain(names.iter().map(String::as_str)).collect();
    let number = |x: f64| if x.is_finite() { format!("{x}") } else { "–".to_string() };
    let rows: Vec<Vec<String>> = outcome
        .samples()
        .map(|row| {
            let values = row.observables.iter().flat_map(|o| o.columns()).map(|(_, x)| number(x));
            std::iter::once(number(row.time)).chain(values).collect()
        })
        .collect();
    let event = |event: &Event| {
        let kind = if event.gained { "link" } else { "unlink" };
        vec![number(event.time), kind.to_string(), format!("{}-{}", event.pair.0, event.pair.1)]
    };
    let events: Vec<Vec<String>> = outcome.events.iter().take(EVENTS).map(event).collect();
    let shown = html! {
        @match &outcome.end {
            End::Finished => {}
            End::Interrupted => p { "The run was stopped at t = " (outcome.reached()) "." }
            End::Failed(error) => p.verdict.undecided { (error) "; t = " (outcome.reached()) " was reached." }
        }
        @if let Some(motion) = motion { (played(&motion, &about)) }
        @if !rows.is_empty() { h2 { "Samples" } (table("Samples", &head, &rows)) }
        @for remark in &outcome.remarks { p { (remark) } }
        @if !events.is_empty() {
            h2 { "Events" }
            (table("Events", &["t", "event", "pair"], &events))
            @if outcome.events.len() > EVENTS { p.small { "The first " (EVENTS) " of " (outcome.events.len()) "." } }
        }
        h2 { "Plots" }
        @for (name, plot) in simulation_pictures(outcome) { (picture(&plot, name, &format!("{}: {name}", outcome.model))) }
        h2 { "What was run" }
        ul { @for line in &outcome.declaration { li { (line) } } }
    };
    shown.into_string()
}
