//! One computed case for each live page, so that the static site shows what the page would answer.

use super::super::Texts;
use super::runs::RunsError;
use super::starts;
use crate::shown::{self, PatternRow};
use algebra::graph::{LaplacianKind, NamedGraph};
use algebra::spectrum::named_spectrum;
use arithmetic::{Unwatched, rational};
use models::averaging::Flock;
use models::averaging::read::{Model, read_flock};
use models::averaging::settle::{Limits, settle};
use models::platoon::{Gains, resonance as enclose};
use question::{Question, decide};
use scenario::Scenario;

/// A piece of a page.
pub(super) type Case = Result<String, RunsError>;

pub(super) fn failed(error: impl std::fmt::Display) -> RunsError {
    RunsError::Case(error.to_string())
}

fn file(path: &str, texts: Texts) -> Result<&'static str, RunsError> {
    texts(path).ok_or_else(|| failed(format!("there is no text of {path}")))
}

pub(super) fn resonance(_: Texts) -> Case {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let found = enclose(&gains, 128, 15).map_err(failed)?;
    shown::resonance(&gains, 128, &found).map_err(failed)
}

pub(super) fn spectrum(_: Texts) -> Case {
    let graph = NamedGraph::Ring(12);
    let spectrum = named_spectrum(&graph, LaplacianKind::Combinatorial, None).map_err(failed)?;
    Ok(shown::spectrum(&graph.build().map_err(failed)?, graph.is_directed(), &spectrum))
}

pub(super) fn flock(_: Texts) -> Case {
    let Model::D { start, .. } = read_flock(starts::BIRDS).map_err(failed)?.model else { return Ok(String::new()) };
    let mut switches = Vec::new();
    let mut found = |switch: &models::averaging::Switch| switches.push(switch.clone());
    let settled = settle(Flock::new(&start)?, &Limits::default(), &mut found, &Unwatched)?;
    Ok(shown::flock(&start, &switches, &settled))
}

pub(super) fn patterns(_: Texts) -> Case {
    let gains = [rational(1, 5), rational(1, 5), rational(-1, 25)];
    let tenth = rational(1, 10);
    let rows = PatternRow::all(12, (&tenth, &tenth), &gains, &Unwatched).map_err(failed)?;
    Ok(shown::patterns(&rows, &gains))
}

pub(super) fn question(texts: Texts) -> Case {
    let question =
        Question::read(file(starts::GAP, texts)?, &|name| Err(format!("there is no {name}"))).map_err(failed)?;
    let answer = decide(&question, &Unwatched).map_err(failed)?;
    Ok(shown::question(&question, &answer, &Unwatched))
}

pub(super) fn scenario(texts: Texts) -> Case {
    Ok(shown::simulation(&Scenario::read(file(starts::SWITCHING, texts)?)?.run(&Unwatched)))
}
