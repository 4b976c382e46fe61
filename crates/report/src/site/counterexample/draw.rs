//! Pictures of what is in a counterexample, each with a sentence of what is to be seen.

use super::curves::float;
use crate::plot::{Axis, Panel, Picture, Series};
use crate::shown::{drawing, network};
use arithmetic::Rational;
use ledger::{Link, Number, Point, Witness};
use maud::{Markup, html};
use num_traits::{Signed, ToPrimitive, Zero};

/// How wide pictures are, so that a phone shows them whole.
const WIDTH: f64 = 320.0;

/// The picture and what is said below it; `k` tells it from others on the page.
pub(super) fn draw(witness: &Witness, k: usize) -> (Markup, String) {
    const TAU: f64 = std::f64::consts::TAU;
    let around = |phases: Vec<f64>| (circle(&phases), format!("The {} phases on the circle.", phases.len()));
    match witness {
        Witness::Agents { places, velocities, links } => agents(places, velocities, links, k),
        Witness::Networks { order, networks, directed } => in_turn(*order, networks, *directed),
        Witness::Phases { turns } => around(turns.iter().map(|turn| TAU * float(turn)).collect()),
        Witness::Directions { points } => around(points.iter().map(|[x, y]| float(y).atan2(float(x))).collect()),
        Witness::Compared { subject, found: Number(found), says, claimed: Number(claimed) } => {
            (line(found, says, claimed), format!("{subject}: computed {found}, {says} {claimed}."))
        }
        Witness::Gain { f, g, marks } => curve(super::curves::gain(float(f), float(g), marks), k),
        Witness::Potential { .. } => curve(super::curves::potential(witness), k),
        Witness::Variables { values } => {
            let all: Vec<String> = values.iter().map(|(name, Number(x))| format!("{name} = {x}")).collect();
            (html! {}, format!("{}.", all.join(", ")))
        }
    }
}

fn curve((panel, about): (Panel, String), k: usize) -> (Markup, String) {
    let drawn = Picture::new("").grid(1, (WIDTH, 240.0)).panel(panel);
    (drawing(&drawn, &format!("counterexample-{k}"), &about), about)
}

fn point([x, y]: &Point) -> (f64, f64) {
    (float(x), float(y))
}

/// Agents with their velocities, all to one scale, and links.
pub(super) fn agents(places: &[Point], velocities: &[Point], links: &[Link], k: usize) -> (Markup, String) {
    let at: Vec<(f64, f64)> = places.iter().map(point).collect();
    let flow: Vec<(f64, f64)> = velocities.iter().map(point).collect();
    let flat = at.iter().chain(&flow).all(|(_, y)| *y == at[0].1 || *y == 0.0);
    let panel = Panel::new("", Axis::linear("x"), Axis::linear("y")).equal_scales();
    let mut panel =
        links.iter().fold(panel, |panel, (i, j)| panel.series(Series::line("", [at[*i], at[*j]]).colour("#6b6b6b")));
    // The longest arrow is shorter than half the way between two agents.
    let longest = flow.iter().map(|(u, v)| u.hypot(*v)).fold(0.0, f64::max);
    let apart = at.iter().enumerate().flat_map(|(i, p)| at[..i].iter().map(move |q| (p.0 - q.0).hypot(p.1 - q.1)));
    let nearest = apart.filter(|d| *d > 0.0).fold(f64::INFINITY, f64::min);
    let unit = if nearest.is_finite() && longest > 0.0 { (0.45 * nearest / longest).min(1.0) } else { 1.0 };
    let arrows = at.iter().zip(&flow).map(|((x, y), (u, v))| ((*x, *y), (x + unit * u, y + unit * v)));
    panel = panel.series(Series::arrows("", arrows).colour("#222222").size(1.6));
    for (agent, place) in places.iter().enumerate() {
        let mut name = format!("{} at ({}, {})", agent + 1, place[0].0, place[1].0);
        if let Some([Number(u), Number(v)]) = velocities.get(agent) {
            name.push_str(&format!(", velocity ({u}, {v})"));
        }
        // One below the other, where two are in one place.
        let above = places[agent + 1..].iter().filter(|other| *other == place).count();
        let size = 4.5 + 3.5 * above as f64;
        panel = panel.series(Series::points(name, [at[agent]]).size(size));
    }
    let height = if flat { 150.0 } else { 250.0 };
    let mut about = if places.len() == 1 { "The point".to_string() } else { format!("The {} points", places.len()) };
    match (velocities.is_empty(), longest > 0.0) {
        (false, true) => about.push_str(", with arrows for velocities"),
        (false, false) => about.push_str(", at rest"),
        _ => {}
    }
    about.push_str(if links.is_empty() { "." } else { "; lines are links." });
    let drawn = Picture::new("").grid(1, (WIDTH, height)).panel(panel);
    (drawing(&drawn, &format!("counterexample-{k}"), &about), about)
}

fn in_turn(order: usize, networks: &[Vec<Link>], directed: bool) -> (Markup, String) {
    let size = if order > 8 { 260.0 } else { 150.0 };
    let drawn: Vec<(Markup, String)> =
        networks.iter().filter_map(|links| network(order, links, directed, size)).collect();
    let about = match drawn.as_slice() {
        [(_, about)] => format!("{about}."),
        many => format!("The {} networks in turn, on the same {order} nodes.", many.len()),
    };
    (html! { div.several { @for (one, _) in &drawn { (one) } } }, about)
}

/// Phases on the unit circle; those in one place share a disc.
fn circle(phases: &[f64]) -> Markup {
    const SIZE: f64 = 200.0;
    let (middle, radius) = (SIZE / 2.0, SIZE / 2.0 - 26.0);
    let mut discs: Vec<((f64, f64), Vec<usize>)> = Vec::new();
    for (k, phase) in (1..).zip(phases) {
        let at = (middle + radius * phase.cos(), middle - radius * phase.sin());
        match discs.iter_mut().find(|((x, y), _)| (x - at.0).hypot(y - at.1) < 1.0) {
            Some((_, here)) => here.push(k),
            None => discs.push((at, vec![k])),
        }
    }
    html! {
        div.network role="img" aria-label="Phases on the circle" {
            svg width=(SIZE) height=(SIZE) viewBox=(format!("0 0 {SIZE} {SIZE}")) {
                circle.ring cx=(middle) cy=(middle) r=(radius) {}
                @for ((x, y), here) in &discs {
                    @let name = here.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
                    circle cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r=(5.0 + 4.0 * name.len() as f64) {}
                    text x=(format!("{x:.1}")) y=(format!("{:.1}", y + 3.8)) { (name) }
                }
            }
        }
    }
}

/// What was found above a line of numbers, what is claimed below it, and 0.
fn line(found: &Rational, says: &str, claimed: &Rational) -> Markup {
    let zero = Rational::zero();
    let exact = |q: &Rational| q.to_f64().unwrap_or(f64::NAN);
    let all = [found, claimed, &zero].map(exact);
    let (low, high) = all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
    let place = |q: &Rational| 72.0 + (WIDTH - 144.0) * if high > low { (exact(q) - low) / (high - low) } else { 0.5 };
    let (a, b, origin) = (place(found), place(claimed), place(&zero));
    let shown = |x: f64| format!("{x:.1}");
    html! {
        div.numberline role="img" aria-label=(format!("computed {found}, {says} {claimed}")) {
            svg width=(WIDTH) height="104" viewBox=(format!("0 0 {WIDTH} 104")) {
                line.axis x1="12" y1="52" x2=(WIDTH - 12.0) y2="52" {}
                line.axis x1=(shown(origin)) y1="46" x2=(shown(origin)) y2="58" {}
                @if !found.is_zero() && !claimed.is_zero() { text.zero x=(shown(origin)) y="74" { "0" } }
                circle.found cx=(shown(a)) cy="52" r="6" {}
                text.found x=(shown(a)) y="34" { "computed " (signed(found)) }
                path.claimed d=(format!("M{:.1} 44l8 8l-8 8l-8-8z", b)) {}
                text.claimed x=(shown(b)) y="92" { (says) " " (signed(claimed)) }
            }
        }
    }
}

/// With the sign of typography.
fn signed(q: &Rational) -> String {
    if q.is_negative() { format!("−{}", -q) } else { q.to_string() }
}
