//! The answer to a question, with its counterexample drawn.

use super::{decided, flock, graph, picture, played};
use crate::page::player::Motion;
use crate::plot::{Axis, Panel, Picture, Series};
use algebra::matrix::StochasticMatrix;
use arithmetic::{Progress, Rational};
use maud::{Markup, html};
use models::platoon::{Communication, Gains, amplitude_one_sided, inverse_square_two_sided};
use num_traits::ToPrimitive;
use question::{Answer, Bindings, Instance, Margin, Question, Value, Verdict};
use scenario::{Scenario, Source};

/// The statement, the verdict and its reason, the counterexample in numbers and drawn, and the question that decides it alone.
pub fn question(question: &Question, answer: &Answer, progress: &dyn Progress) -> String {
    let (refuted, total) = (answer.controls.iter().filter(|refuted| **refuted).count(), answer.controls.len());
    let shown = html! {
        @if let Some(statement) = question.statement() { blockquote.statement { p { (statement) } } }
        (decided(answer.verdict, &answer.why))
        dl.facts {
            @if !answer.grades.is_empty() { dt { "Evidence" } dd { (answer.grades.join(", ")) } }
            dt { "Cases looked at" } dd { (answer.cases) @if answer.undecided > 0 { ", " (answer.undecided) " of them undecided" } }
            @if let Some((lo, hi)) = answer.margin.as_ref().and_then(Margin::decimals) {
                dt { @if answer.verdict == Verdict::False { "Margin there" } @else { "Smallest margin" } } dd { @if lo == hi { (lo) } @else { "[" (lo) ", " (hi) "]" } }
            }
            dt { "Controls refuted" } dd { (refuted) " of " (total) @if answer.made.is_some() { ", made by the program" } }
            @if let Some(made) = &answer.made {
                @for control in &made.controls { dd { code { (control.property) } " fails at " code { (control.fails_at) } } }
                @if let Some(why) = &made.why_none { dd { (why) } }
            }
        }
        @if let Some(bindings) = &answer.counterexample {
            h2 { "Counterexample" }
            (numbers(bindings))
            (drawn(question, bindings, progress))
            @if let Some(replay) = &answer.replay {
                details { summary { "The question of this one case, which " code { "flockproof check" } " decides alone" } pre tabindex="0" { code { (replay) } } }
            }
        }
        (over_time(question, answer, progress))
        details { summary { "The question" } pre tabindex="0" { code { (question.text()) } } }
    };
    shown.into_string()
}

/// The quantities of a motion over time, where its starts are boxes.
fn over_time(question: &Question, answer: &Answer, progress: &dyn Progress) -> Markup {
    match question.tubes(answer.counterexample.as_ref(), progress) {
        Ok(found) if !found.runs.is_empty() && !found.tubes.is_empty() => {
            let about = "What is enclosed for all starts at once, with the motions of single ones in it.";
            html! { h2 { "Over time" } (picture(&super::tubes(question, &found), "tube", about)) }
        }
        _ => html! {},
    }
}

/// What the names stand for.
fn numbers(bindings: &Bindings) -> Markup {
    html! {
        div.wide tabindex="0" role="region" aria-label="Counterexample" { table.named { tbody {
            @for (name, value) in bindings.iter() { tr { th scope="row" { code { (name) } } td { @match value {
                Value::Matrices(list) => { @for matrix in list.iter() { (entries(matrix)) } }
                value => { (value.text()) }
            } } } }
        } } }
    }
}

fn entries(matrix: &StochasticMatrix) -> Markup {
    html! {
        math display="block" { mrow { mo { "(" } mtable {
            @for row in matrix.to_rational_matrix().to_rows() { mtr { @for x in row { mtd { mn { (x) } } } } }
        } mo { ")" } } }
    }
}

/// Pictures of the graphs, the flock, the motion or the platoon.
fn drawn(question: &Question, bindings: &Bindings, progress: &dyn Progress) -> Markup {
    let graphs = bindings.iter().filter_map(|(_, value)| match value {
        Value::Graph(graph) => Some(graph),
        _ => None,
    });
    html! {
        @for graph in graphs { (graph::drawn(graph.order(), &graph.arcs(), graph.is_directed())) }
        @match question.moving(bindings, progress) {
            Some(Instance::Flock(start)) => (flock::motion(&start, &FLOCK_STEPS)),
            Some(Instance::Motion(source)) => (run(&source, progress)),
            None => (platoon(question, bindings)),
        }
    }
}

/// Steps of a flock that are shown.
const FLOCK_STEPS: u64 = 120;

/// A run in floating point of what is false exactly.
fn run(source: &Source, progress: &dyn Progress) -> Markup {
    let Ok(scenario) = Scenario::of(source) else { return html! {} };
    match Motion::of_outcome(&scenario.run(progress), "a run of the counterexample") {
        Some(motion) => {
            played(&motion, "The counterexample as it moves, in floating point; it is decided by enclosures.")
        }
        None => html! {},
    }
}

/// The response of the last car, where followers and gains are bound.
fn platoon(question: &Question, bindings: &Bindings) -> Markup {
    let number = |name: &str| match bindings.get(name) {
        Some(Value::Number(q)) => Some(q),
        _ => None,
    };
    let float = |name: &str| number(name).and_then(Rational::to_f64);
    let followers = number("followers").and_then(Rational::to_u64);
    let (Some(followers), Some(f), Some(g)) = (followers, float("f"), float("g")) else { return html! {} };
    let gains = Gains { f, g };
    let amplitude = |w: f64| {
        let square = match question.communication() {
            Communication::Front => amplitude_one_sided(&gains, &w, followers).map(|a| a.norm_squared()),
            _ => inverse_square_two_sided(&gains, &w, followers).map(f64::recip),
        };
        square.map_or(f64::NAN, f64::sqrt)
    };
    // Up to several times the frequency of Theorem 1, and past the one-sided one.
    let last = 4.0 * (-f).max(0.0).sqrt() / (followers as f64).sqrt().max(1.0);
    let line = (1..=1200u32).map(|k| last * f64::from(k) / 1200.0).map(|w| (w, amplitude(w)));
    let panel = Panel::new("", Axis::linear("frequency (rad/s)"), Axis::log("amplitude of the last car"));
    let plot = Picture::new("").grid(1, (720.0, 360.0)).panel(panel.series(Series::line("", line)));
    picture(
        &plot,
        "response",
        &format!(
            "Response of follower {followers} of {followers} to a leader that swings, f = {f}, g = {g}, in floating point."
        ),
    )
}
