//! What the sentence of a counterexample shows: agents in places, networks, phases, a number beside the claimed one.
//!
//! The sentences are those that the checks write. Whatever is not wholly understood is left out.

use super::curves::{self, Curve};
use super::numbers::{assignments, number};
use arithmetic::Rational;
use num_traits::{One, ToPrimitive};

/// A pair of agents from 0.
pub(super) type Link = (usize, usize);

/// Something that can be drawn.
#[derive(Debug)]
pub(super) enum Scene {
    /// Agents in the plane or on the line, their velocities where all are given, and the links between them.
    Agents { places: Vec<[Rational; 2]>, velocities: Vec<[Rational; 2]>, links: Vec<Link> },
    /// Networks of so many nodes, in the order of time.
    Networks { order: usize, networks: Vec<Vec<Link>>, directed: bool },
    /// Angles on the circle, in radians.
    Phases(Vec<f64>),
    /// A function that the sentence names.
    Curve(Curve),
    /// What a quantity is, and what it is said to be.
    Compared { subject: String, found: Rational, says: String, claimed: Rational },
}

/// What stands between semicolons outside brackets.
pub(super) fn parts(sentence: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0i32;
    sentence
        .split(move |c| {
            depth += match c {
                '(' | '[' | '{' => 1,
                ')' | ']' | '}' => -1,
                _ => 0,
            };
            c == ';' && depth == 0
        })
        .map(str::trim)
}

/// Everything in a part of a sentence that can be drawn.
pub(super) fn scenes(part: &str) -> Vec<Scene> {
    let (order, networks, directed) = networks(part).unwrap_or_default();
    let agents = places(part).map(|places| {
        let links = match networks.as_slice() {
            [one] if order == places.len() => one.clone(),
            _ if linked(part, places.len()) => pairs(places.len()),
            _ => Vec::new(),
        };
        Scene::Agents { velocities: velocities(part, places.len()), places, links }
    });
    let alone = !networks.is_empty()
        && !matches!(&agents, Some(Scene::Agents { links, places, .. }) if networks.len() == 1 && order == places.len() && *links == networks[0]);
    let networks = alone.then_some(Scene::Networks { order, networks, directed });
    let phases = phases(part).map(Scene::Phases);
    let curve = curves::read(part).map(Scene::Curve);
    [networks, agents, phases, curve, compared(part)].into_iter().flatten().collect()
}

/// The lists of numbers `(a, b), (c, d) and (e, f)` with which a text begins.
fn tuples(text: &str) -> Vec<Vec<Rational>> {
    let mut rest = text.trim_start_matches('[');
    let mut found = Vec::new();
    while let Some((inside, after)) = rest.strip_prefix('(').and_then(|rest| rest.split_once(')')) {
        let Some(numbers) = inside.split(',').map(number).collect() else { break };
        found.push(numbers);
        let next = [", ", " and ", " "].iter().find_map(|sign| after.strip_prefix(sign));
        rest = next.unwrap_or_default();
    }
    found
}

/// Tuples that are pairs, all of them.
fn plane(text: &str) -> Option<Vec<[Rational; 2]>> {
    tuples(text).into_iter().map(|list| list.try_into().ok()).collect()
}

fn places(part: &str) -> Option<Vec<[Rational; 2]>> {
    let listed = part
        .match_indices(" at ")
        .find_map(|(at, word)| plane(part.get(at + word.len()..)?).filter(|list| list.len() > 1));
    let row = || {
        let (_, rest) = part.split_once("x(0) = ")?;
        let [row] = <[Vec<Rational>; 1]>::try_from(tuples(rest)).ok()?;
        Some(row.into_iter().map(|x| [x, Rational::default()]).collect())
    };
    listed.or_else(row).or_else(|| named(part, [["x_%", "y_%"], ["x%", "y%"], ["Re x%", "Im x%"]]))
}

fn velocities(part: &str, agents: usize) -> Vec<[Rational; 2]> {
    let after = part.split_once("velocities ").or_else(|| part.split_once("velocity ")).map(|(_, rest)| rest);
    let listed = after.and_then(plane).map(|list| match list.as_slice() {
        [one] if part.contains("both with velocity") => vec![one.clone(); agents],
        _ => list,
    });
    let found = listed.or_else(|| named(part, [["vx%", "vy%"]])).or_else(|| headings(part)).unwrap_or_default();
    if found.len() == agents { found } else { Vec::new() }
}

/// The pairs of numbers that are given to names, `%` for the number of the agent.
fn named<const N: usize>(part: &str, names: [[&str; 2]; N]) -> Option<Vec<[Rational; 2]>> {
    let known = assignments(part);
    let value = |name: &str, k: usize| known.get(name.replace('%', &k.to_string()).as_str()).cloned();
    let all = |[x, y]: [&str; 2]| (1..).map_while(|k| Some([value(x, k)?, value(y, k)?])).collect::<Vec<_>>();
    names.into_iter().map(all).find(|list| !list.is_empty())
}

/// The unit vectors at the angles of which half tangents are given.
fn headings(part: &str) -> Option<Vec<[Rational; 2]>> {
    let known = assignments(part);
    let unit = |t: &Rational| {
        let one = Rational::one();
        let (square, length) = (t * t, &one + &(t * t));
        [&(&one - &square) / &length, &(t + t) / &length]
    };
    let list: Vec<_> = (1..).map_while(|k| known.get(format!("tan(th_{k}/2)").as_str()).map(unit)).collect();
    Some(list).filter(|list| !list.is_empty())
}

fn linked(part: &str, agents: usize) -> bool {
    part.contains("all linked") || (agents == 2 && part.contains("linked"))
}

fn pairs(order: usize) -> Vec<Link> {
    (0..order).flat_map(|j| (0..j).map(move |i| (i, j))).collect()
}

/// The number of nodes, the networks `1-2 2-3`, one after the other, and whether they are directed, `1->2`.
fn networks(part: &str) -> Option<(usize, Vec<Vec<Link>>, bool)> {
    let indexed = || {
        let (_, rest) = part.split_once("edges [")?;
        let (inside, _) = rest.split_once(']')?;
        let pair = |list: Vec<Rational>| match list.as_slice() {
            [i, j] => Some((i.to_usize()?, j.to_usize()?)),
            _ => None,
        };
        Some(vec![tuples(inside).into_iter().map(pair).collect::<Option<Vec<Link>>>()?])
    };
    let found = indexed().or_else(|| circulant(part)).unwrap_or_else(|| chains(part));
    let most = found.iter().flatten().map(|(i, j)| i.max(j) + 1).max().unwrap_or(0);
    let named = ["path ", "links ", "graph "].iter().any(|word| part.contains(word));
    let order = order(part).or_else(|| named.then_some(most)).filter(|order| *order >= most.max(1))?;
    let directed = part.contains("->");
    let sorted = |(i, j): Link| if directed || i < j { (i, j) } else { (j, i) };
    let found: Vec<Vec<Link>> = found.into_iter().map(|links| links.into_iter().map(sorted).collect()).collect();
    (!found.is_empty()).then_some((order, found, directed))
}

/// `3 birds`, `four agents`, `N = 4`.
fn order(part: &str) -> Option<usize> {
    const WORDS: [&str; 7] = ["one", "two", "three", "four", "five", "six", "seven"];
    let count = |word: &str| {
        let spelled = WORDS.iter().position(|known| *known == word).map(|k| k + 1);
        spelled.or_else(|| word.parse().ok()).filter(|order| *order <= 64)
    };
    let words: Vec<&str> = part.split([' ', ',', ':']).filter(|word| !word.is_empty()).collect();
    words.windows(3).find_map(|list| match list {
        [many, "birds" | "vertex" | "vertices" | "agents", _] => count(many),
        ["N" | "n", "=", many] => count(many),
        _ => None,
    })
}

/// A circulant graph, in which links go both ways.
fn circulant(part: &str) -> Option<Vec<Vec<Link>>> {
    let (_, rest) = part.split_once("circulant graph with offsets [")?;
    let (inside, _) = rest.split_once(']')?;
    let (order, offsets) = (order(part)?, inside.split(", ").map(str::parse).collect::<Result<Vec<usize>, _>>().ok()?);
    let joined = |(i, j): &Link| offsets.iter().any(|a| (i + a) % order == *j || (j + a) % order == *i);
    Some(vec![pairs(order).into_iter().filter(joined).collect()])
}

/// Words such as `1-2-3` or `1->2`, and `no edges`; every other word between them ends a network.
fn chains(part: &str) -> Vec<Vec<Link>> {
    let chain = |word: &str| -> Option<Vec<Link>> {
        let nodes: Vec<usize> = word
            .trim_matches(|c| matches!(c, '{' | '}' | ',' | ':'))
            .split('-')
            .map(|node| node.trim_start_matches('>').parse().ok().filter(|k| (1..=64).contains(k)))
            .collect::<Option<_>>()?;
        (nodes.len() > 1).then(|| nodes.windows(2).map(|pair| (pair[0] - 1, pair[1] - 1)).collect())
    };
    let mut found: Vec<Vec<Link>> = Vec::new();
    let (mut open, mut before) = (false, "");
    for word in part.split(' ') {
        let none = before == "no" && word.trim_end_matches([',', ':']) == "edges";
        match chain(word) {
            Some(links) => {
                if !open {
                    found.push(Vec::new());
                }
                found.iter_mut().next_back().into_iter().for_each(|last| last.extend(&links));
                open = true;
            }
            None => {
                if none {
                    found.push(Vec::new());
                }
                open = false;
            }
        }
        before = word;
    }
    found
}

/// `phases (0/12, 7/12) turns`, or sums of `pi` and an angle `a` of which the cosine is given.
fn phases(part: &str) -> Option<Vec<f64>> {
    let (_, rest) = part.split_once("phases (")?;
    let (inside, after) = rest.split_once(')')?;
    if after.starts_with(" turns") {
        return inside.split(", ").map(|text| Some(std::f64::consts::TAU * number(text)?.to_f64()?)).collect();
    }
    let cosine = after.strip_prefix(", cos a = ")?.split([',', ' ']).next().and_then(number)?.to_f64()?;
    let term = |text: &str| match text {
        "0" => Some(0.0),
        "a" => Some(cosine.acos()),
        "pi" => Some(std::f64::consts::PI),
        _ => None,
    };
    inside.split(", ").map(|sum| sum.split(" + ").map(term).sum()).collect()
}

/// `.. is A, but B is claimed`, `.. = A, but the bound is B`, `.. = A, the right side is B`.
fn compared(part: &str) -> Option<Scene> {
    let (left, right) = part.rsplit_once(", but ").or_else(|| part.rsplit_once(", the right side is "))?;
    let (says, claimed) = match (right.strip_suffix(" is claimed"), right.rsplit_once(" is ")) {
        (Some(claimed), _) => ("claimed", claimed),
        (None, Some((says, claimed))) => (says, claimed),
        (None, None) => ("the right side", right),
    };
    let sign = left.rfind(" is ").map(|at| (at, 4)).max(left.rfind(" = ").map(|at| (at, 3)));
    let (subject, found) = sign.and_then(|(at, long)| Some((left.get(..at)?, left.get(at + long..)?)))?;
    let (found, claimed) = (number(found)?, number(claimed)?);
    Some(Scene::Compared { subject: last_phrase(subject).to_string(), found, says: says.to_string(), claimed })
}

/// What stands after the last comma or colon outside brackets.
fn last_phrase(text: &str) -> &str {
    let mut depth = 0i32;
    for (at, c) in text.char_indices().rev() {
        match c {
            ')' | ']' | '}' => depth += 1,
            '(' | '[' | '{' => depth -= 1,
            ',' | ':' if depth == 0 => return text.get(at + 1..).unwrap_or(text).trim_start(),
            _ => {}
        }
    }
    text
}
