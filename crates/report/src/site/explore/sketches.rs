//! A small picture of what each live page asks about, for the list.

use super::super::Texts;
use super::cases::failed;
use super::runs::RunsError;
use super::starts;
use crate::page::player::Motion;
use crate::shown;
use algebra::graph::Graph;
use arithmetic::Unwatched;
use maud::{Markup, html};
use models::averaging::read::{Model, read_flock};
use models::platoon::{Gains, inverse_square_two_sided};
use reach::{System, decide, tube};
use scenario::Scenario;
use std::f64::consts::TAU;

/// A picture; nothing where there is nothing to be drawn, or the file is not there.
pub(super) type Sketch = Result<Option<Markup>, RunsError>;

/// Points of a curve.
const POINTS: u32 = 150;

/// The response of the last of twelve followers over the frequency, on a logarithmic scale.
pub(super) fn resonance(_: Texts) -> Sketch {
    let gains = Gains { f: -1.0, g: -1.0 };
    let heights = (1..=POINTS).map(|k| {
        let square = inverse_square_two_sided(&gains, &(f64::from(k) * 0.004), 12).map_err(failed)?;
        Ok(vec![-square.log10()])
    });
    curves(heights.collect::<Result<Vec<_>, RunsError>>()?)
}

/// A ring of twelve vertices.
pub(super) fn spectrum(_: Texts) -> Sketch {
    Ok(network(&Graph::ring(12)))
}

/// The birds of the page.
pub(super) fn flock(_: Texts) -> Sketch {
    let Model::D { start, .. } = read_flock(starts::BIRDS).map_err(failed)?.model else { return Ok(None) };
    Ok(Some(Motion::of_flock(&start, 40, "")?.thumbnail()))
}

/// Three clusters on a circle.
pub(super) fn patterns(_: Texts) -> Sketch {
    let on = |turn: f64| [(TAU * turn).cos(), (TAU * turn).sin()];
    let mut motion = Motion { equal: true, ..Motion::new("", ["x", "y"]) };
    for k in 0..=POINTS {
        // The first one goes round once; the others are there.
        motion.points.push([f64::from(k) / f64::from(POINTS), 1.0 / 3.0, 2.0 / 3.0].map(on).to_vec());
    }
    Ok(Some(motion.thumbnail()))
}

/// A path, the connected graph with the smallest gap.
pub(super) fn question(_: Texts) -> Sketch {
    Ok(network(&Graph::path(6)))
}

/// The run of the first example.
pub(super) fn scenario(texts: Texts) -> Sketch {
    run(starts::SWITCHING, texts)
}

/// Boids.
pub(super) fn law(texts: Texts) -> Sketch {
    run("assets/laws/boids.toml", texts)
}

/// The least and the greatest gap of two cars over time.
pub(super) fn worst_cases(texts: Texts) -> Sketch {
    let Some(text) = texts(starts::TWO_CARS) else { return Ok(None) };
    let system = System::read(text).map_err(failed)?;
    let decided = decide(&system, 6, &Unwatched).map_err(failed)?;
    let Some(part) = decided.iter().find_map(|found| found.parts.first()) else { return Ok(None) };
    let drawn = tube(&system, part, POINTS as usize, &Unwatched).map_err(failed)?;
    curves(drawn.sections.iter().map(|[_, _, low, high]| vec![*low, *high]).collect())
}

fn network(graph: &Graph) -> Option<Markup> {
    let drawn = shown::network(graph.order(), &graph.edges(), false, 160.0);
    drawn.map(|(drawn, _)| html! { div aria-hidden="true" { (drawn) } })
}

fn run(path: &str, texts: Texts) -> Sketch {
    let Some(text) = texts(path) else { return Ok(None) };
    let outcome = Scenario::read(text)?.run(&Unwatched);
    Ok(Motion::of_outcome(&outcome, "").map(|motion| motion.thumbnail()))
}

/// Curves from their heights, equally far apart.
fn curves(heights: Vec<Vec<f64>>) -> Sketch {
    let points = heights.into_iter().map(|row| row.into_iter().map(|height| [height, 0.0]).collect()).collect();
    Ok(Some(Motion { points, ..Motion::new("", ["", ""]) }.thumbnail()))
}
