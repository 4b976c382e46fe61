//! A flock that was settled.

use super::{played, table, verdict};
use crate::page::player::Motion;
use maud::{Markup, html};
use models::averaging::settle::{Ending, Settlement};
use models::averaging::{Start, Switch};
use num_traits::ToPrimitive;

/// Steps that are shown after the last switch, and at most.
const AFTER: u64 = 12;
const MOST: u64 = 300;
/// Most switches in the table.
const ROWS: usize = 200;

/// The verdict, every switch, and the first steps as they are.
pub fn flock(start: &Start, switches: &[Switch], settled: &Settlement) -> String {
    let pairs = |list: &[(usize, usize)]| {
        list.iter().map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect::<Vec<_>>().join(" ")
    };
    let row = |switch: &Switch| vec![switch.time.to_string(), pairs(&switch.gained), pairs(&switch.lost)];
    let rows: Vec<Vec<String>> = switches.iter().take(ROWS).map(row).collect();
    let flocks: Vec<String> = settled.network.components().iter().map(|flock| named(flock)).collect();
    let shown = html! {
        (ending(settled))
        p { "Flocks: " (flocks.join(" ")) }
        @if !rows.is_empty() { (table("Switches", &["t", "links that come", "links that go"], &rows)) }
        @if switches.len() > ROWS { p.small { "The first " (ROWS) " of " (switches.len()) " switches." } }
        (motion(start, &settled.last_switch.to_u64().unwrap_or(MOST)))
    };
    shown.into_string()
}

fn named(flock: &[usize]) -> String {
    format!("{{{}}}", flock.iter().map(|bird| (bird + 1).to_string()).collect::<Vec<_>>().join(", "))
}

fn ending(settled: &Settlement) -> Markup {
    let last = &settled.last_switch;
    match &settled.ending {
        Ending::Steady => verdict("holds", "✓", &format!("steady from t = {last} on"), &settled.why),
        Ending::Alternating { period } => {
            verdict("misprint", "≠", &format!("alternates for ever with period {period}"), &settled.why)
        }
        Ending::Beyond { .. } => {
            verdict("misprint", "≠", "changes again, after more steps than can be written", &settled.why)
        }
        Ending::Undecided(_) | Ending::Interrupted => verdict("undecided", "?", "undecided", &settled.why),
    }
}

/// The steps up to the last switch, as far as they can be shown.
pub(super) fn motion(start: &Start, last: &u64) -> Markup {
    let steps = last.saturating_add(AFTER).min(MOST) as usize;
    match Motion::of_flock(start, steps, "the first steps") {
        Ok(motion) => played(&motion, &format!("The first {steps} steps, exact and rounded for drawing.")),
        // It was settled, and only its picture is missing.
        Err(error) => html! { p.small { "The steps cannot be shown: " (error) "." } },
    }
}
