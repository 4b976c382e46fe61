//! A counterexample drawn: what the check found, with its numbers.

mod curves;
mod draw;

use super::Site;
use crate::page::Links;
use arithmetic::Rational;
use ledger::{Link, Number, Point, Witness};
use maud::{Markup, html};
use num_traits::One;

/// The drawings of what is in a counterexample; nothing where nothing of it can be drawn.
pub(super) fn drawings(site: &Site, witnesses: &[Witness], links: Links) -> Markup {
    let known: Vec<Witness> = witnesses.iter().filter_map(placed).collect();
    let network = alone(&known);
    let links_of = |places: &[Point]| network.filter(|(order, _)| *order == places.len()).map(|(_, links)| links);
    let on_agents = known.iter().any(|one| matches!(one, Witness::Agents { places, .. } if links_of(places).is_some()));
    // A network that the agents show is not drawn again.
    let drawn = known.iter().filter(|one| !(on_agents && matches!(one, Witness::Networks { .. })));
    let drawn: Vec<(Markup, String)> = (1..)
        .zip(drawn)
        .map(|(k, witness)| match witness {
            Witness::Agents { places, velocities, links } => {
                draw::agents(places, velocities, links_of(places).unwrap_or(links), k)
            }
            other => draw::draw(other, k),
        })
        .collect();
    html! {
        @if !drawn.is_empty() {
            div.drawings {
                @for (drawn, about) in &drawn {
                    figure.shown { (drawn) figcaption { (site.names.rich(about, links)) } }
                }
            }
        }
    }
}

/// The links of the only network.
fn alone(witnesses: &[Witness]) -> Option<(usize, &[Link])> {
    let mut networks = witnesses.iter().filter_map(|witness| match witness {
        Witness::Networks { order, networks, .. } => Some((*order, networks.as_slice())),
        _ => None,
    });
    match (networks.next(), networks.next()) {
        (Some((order, [links])), None) => Some((order, links.as_slice())),
        _ => None,
    }
}

/// Most agents, and points of a curve, that are drawn.
const MOST: usize = 64;

/// Whether its parts fit each other: a ledger may come from a file.
fn is_sound(witness: &Witness) -> bool {
    let among = |links: &[Link], order: usize| links.iter().all(|(i, j)| i.max(j) < &order);
    match witness {
        Witness::Agents { places, velocities, links } => {
            (1..=MOST).contains(&places.len())
                && (velocities.is_empty() || velocities.len() == places.len())
                && among(links, places.len())
        }
        Witness::Networks { order, networks, .. } => {
            (1..=MOST).contains(order) && networks.len() <= MOST && networks.iter().all(|links| among(links, *order))
        }
        Witness::Phases { turns } => (1..=MOST).contains(&turns.len()),
        Witness::Directions { points } => (1..=MOST).contains(&points.len()),
        Witness::Gain { marks, .. } => marks.len() <= MOST,
        Witness::Potential { slope, tangent, radius, .. } => {
            slope.len() <= MOST && tangent.is_some() != radius.is_some()
        }
        Witness::Variables { .. } | Witness::Compared { .. } => true,
    }
}

/// What can be drawn: of variables the agents whose places they are.
fn placed(witness: &Witness) -> Option<Witness> {
    let Witness::Variables { values } = witness else { return is_sound(witness).then(|| witness.clone()) };
    let number = |name: &str, k: usize| {
        let name = name.replace('%', &k.to_string());
        values.iter().find(|(known, _)| *known == name).map(|(_, number)| number.clone())
    };
    let all = |[x, y]: [&str; 2]| (1..).map_while(|k| Some([number(x, k)?, number(y, k)?])).collect::<Vec<Point>>();
    let named = |names: &[[&str; 2]]| names.iter().map(|names| all(*names)).find(|list| !list.is_empty());
    let places = named(&[["x_%", "y_%"], ["x%", "y%"], ["Re x%", "Im x%"]])?;
    let headings = || (1..).map_while(|k| number("tan(th_%/2)", k).map(|t| heading(&t.0))).collect::<Vec<Point>>();
    let velocities = named(&[["vx%", "vy%"]]).unwrap_or_else(headings);
    let velocities = if velocities.len() == places.len() { velocities } else { Vec::new() };
    Some(Witness::Agents { places, velocities, links: Vec::new() }).filter(is_sound)
}

/// The unit vector at an angle of which the half tangent is given.
fn heading(t: &Rational) -> Point {
    let one = Rational::one();
    let (square, length) = (t * t, &one + t * t);
    [Number((&one - square) / &length), Number((t + t) / length)]
}
