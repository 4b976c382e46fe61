//! Who senses whom: the graph of a scenario, fixed or made from positions, with its switches.

use super::error::{ConfigError, Problem};
use super::source::{Section, Source};
use super::view::{Links, Sensing};
use algebra::graph::{AnyGraph, ArcList, NamedGraph, nearest_form};
use arithmetic::{Complex, Field, Rational, nearest_name, shown};
use models::oscillator::{Everyone, Interaction, Neighbours};
use num_traits::{One, Signed};
use std::borrow::Cow;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// A pair of agents from 0.
pub(super) type Pair = (usize, usize);

/// Most edges that are stored.
const MOST_EDGES: usize = 1 << 23;

/// Why a motion is not enclosed.
pub(super) const TIMED: &str = "links that are replaced at given times are not enclosed";

/// Which networks a model can use.
#[derive(Clone, Copy)]
pub(super) struct Abilities {
    /// For messages.
    pub model: &'static str,
    /// The model has positions in the plane.
    pub positions: bool,
    /// Arcs need no way back.
    pub directed: bool,
    /// The law sums over a list of edges; otherwise all-to-all costs O(N).
    pub edges: bool,
    /// Edges may have weights.
    pub weighted: bool,
    /// Links can be replaced at given times.
    pub timed: bool,
    /// What is used where the section is missing.
    pub default: Option<Kind>,
}

/// The kinds of the contract.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    AllToAll,
    Path,
    Ring,
    Circulant,
    Edges,
    Within,
    Nearest,
}

const KINDS: [(&str, Kind); 8] = [
    ("complete", Kind::AllToAll),
    ("path", Kind::Path),
    ("ring", Kind::Ring),
    ("circulant", Kind::Circulant),
    ("edges", Kind::Edges),
    ("within", Kind::Within),
    ("nearest", Kind::Nearest),
    ("all-to-all", Kind::AllToAll),
];

/// What makes the links.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Rule {
    Fixed,
    /// `|r_ij| < radius`.
    Within(f64),
    /// The so many nearest.
    Nearest(usize),
}

/// A link that comes or goes; the pair from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Change {
    pub gained: bool,
    pub pair: Pair,
}

/// A network, held between its switches.
#[derive(Debug, Clone)]
pub(super) struct Network {
    order: usize,
    /// Coordinates of a place, with which the state begins.
    width: usize,
    rule: Rule,
    directed: bool,
    /// Edges `i < j`, or arcs, in order; empty for an implicit all-to-all network.
    pairs: Vec<Pair>,
    /// None for an implicit all-to-all network.
    lists: Option<Neighbours>,
    /// Exact, where links are those within a radius.
    radius: Option<Rational>,
    /// When other links come into force, and which; the next one last.
    coming: Vec<(f64, Vec<Pair>)>,
    /// Arcs with weights, both ways of an edge, where any was given.
    weights: Option<BTreeMap<Pair, Rational>>,
    declaration: String,
}

impl Interaction for Network {
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>> {
        match &self.lists {
            Some(lists) => lists.laplacian_of(x),
            None => Everyone.laplacian_of(x),
        }
    }
}

impl Network {
    /// Reads the section `[graph]`; a network that depends on positions is still without links, see [`Self::settle`].
    pub fn read(source: &Source, order: usize, can: Abilities) -> Result<Self, ConfigError> {
        let Some(section) = source.section("graph")? else {
            return match can.default {
                Some(Kind::AllToAll) => {
                    Network::all_to_all(order, can.edges).map_err(|problem| source.top().problem(problem))
                }
                _ => Err(ConfigError::MissingSection("graph")),
            };
        };
        let entry = section.need("kind", &format!("{}, or a graph", KINDS.map(|(name, _)| name).join(", ")))?;
        let word = entry.word()?;
        if word.contains(':') || word.parse::<NamedGraph>().is_ok() {
            section.allow(&["kind"], " whose kind names the graph")?;
            return Network::of_text(order, &entry, can);
        }
        let Some((_, kind)) = KINDS.into_iter().find(|(name, _)| *name == word) else {
            return Err(entry.problem(unknown(word)));
        };
        let needs = |needs| entry.problem(Problem::Network { model: can.model, needs });
        if !can.positions && matches!(kind, Kind::Within | Kind::Nearest) {
            return Err(needs("a fixed graph: it has no positions"));
        }
        if !can.directed && kind == Kind::Nearest {
            return Err(needs("an undirected graph: that of the nearest is not"));
        }
        let keys: &[&str] = match kind {
            Kind::Circulant => &["kind", "offsets"],
            Kind::Edges if can.timed => &["kind", "edges", "directed", "switches"],
            Kind::Edges => &["kind", "edges", "directed"],
            Kind::Within => &["kind", "radius"],
            Kind::Nearest => &["kind", "nearest"],
            _ => &["kind"],
        };
        section.allow(keys, &format!(" of kind \"{}\"", entry.word()?))?;
        match kind {
            Kind::AllToAll => Network::all_to_all(order, can.edges).map_err(|problem| entry.problem(problem)),
            Kind::Path => Network::named(order, &NamedGraph::Path(order), &section),
            Kind::Ring if order < 3 => Err(needs("at least 3 agents for a ring")),
            Kind::Ring => Network::named(order, &NamedGraph::Ring(order), &section),
            Kind::Circulant => {
                let entry = section.need("offsets", "a list of integers")?;
                let mut offsets = BTreeSet::new();
                for item in entry.items("a list of integers")? {
                    let offset = item.count(1, order - 1)?;
                    if !offsets.insert(offset.min(order - offset)) {
                        return Err(item.range("an offset that is not there yet, up to its sign modulo N"));
                    }
                }
                Network::named(order, &NamedGraph::Circulant(order, offsets), &section)
            }
            Kind::Edges => Network::listed(order, &section, can),
            Kind::Within => {
                let entry = section.need("radius", "a number above 0")?;
                let (radius, exact) = (entry.positive()?, entry.exact()?);
                let declaration = format!(
                    "links i-j where |r_i - r_j| < {radius}; they come and go where a distance crosses {radius}"
                );
                let network = Network::switching(order, Rule::Within(radius), false, declaration);
                Ok(Network { radius: Some(exact), ..network })
            }
            Kind::Nearest => {
                let count = section.need("nearest", "a number of neighbours")?.count(1, order - 1)?;
                let declaration = format!(
                    "agent k senses its {count} nearest agents; at equal distance of the one with the smaller number; events are arcs [k, j]"
                );
                Ok(Network::switching(order, Rule::Nearest(count), true, declaration))
            }
        }
    }

    /// All pairs.
    pub fn all_to_all(order: usize, edges: bool) -> Result<Self, Problem> {
        let declaration = "all-to-all network".to_string();
        if !edges {
            let (pairs, lists) = (Vec::new(), None);
            let (rule, directed, radius, coming, weights) = (Rule::Fixed, false, None, Vec::new(), None);
            return Ok(Network { order, width: 2, rule, directed, pairs, lists, radius, coming, weights, declaration });
        }
        if order.saturating_mul(order) / 2 > MOST_EDGES {
            return Err(Problem::Range(format!("a graph of at most {MOST_EDGES} edges")));
        }
        let pairs = (0..order).flat_map(|i| (i + 1..order).map(move |j| (i, j))).collect();
        Ok(Network::fixed(order, pairs, false, declaration))
    }

    /// A graph as all commands read it: `hypercube:3`, `edges:4:1-2,2-3`, `graph6:..`.
    fn of_text(order: usize, entry: &super::source::Entry, can: Abilities) -> Result<Self, ConfigError> {
        let refused = |why: String| entry.problem(Problem::Range(why));
        let graph: AnyGraph = entry.word()?.parse().map_err(|error| entry.problem(Problem::Graph(error)))?;
        if graph.order() != order {
            return Err(refused(format!(
                "a graph on {order} vertices, one for each agent, and not on {}",
                graph.order()
            )));
        }
        if graph.is_directed() && !can.directed {
            return Err(entry.problem(Problem::Network { model: can.model, needs: "an undirected graph" }));
        }
        let arcs = graph.weighted();
        let arcs = || arcs.adjacency().entries();
        if arcs().any(|(i, j, weight)| i == j || !weight.is_positive()) {
            return Err(refused("a graph without loops whose edges have weights above 0".to_string()));
        }
        let is_weighted = arcs().any(|(_, _, weight)| !weight.is_one());
        if is_weighted && !can.weighted {
            return Err(entry.problem(Problem::Network { model: can.model, needs: "edges without weights" }));
        }
        let weights = is_weighted.then(|| arcs().map(|(i, j, weight)| ((i, j), weight.clone())).collect());
        let directed = graph.is_directed();
        let mut pairs: Vec<Pair> = graph.arcs().into_iter().filter(|(i, j)| directed || i < j).collect();
        pairs.sort_unstable();
        let text = graph.to_string();
        let declaration = match text.len() {
            0..=LONGEST_DECLARED => format!("fixed network {text}"),
            _ => counted(pairs.len(), directed, is_weighted),
        };
        Ok(Network { weights, ..Network::fixed(order, pairs, directed, declaration) })
    }

    fn named(order: usize, graph: &NamedGraph, section: &Section) -> Result<Self, ConfigError> {
        let built = graph.build().map_err(|error| section.problem(Problem::Range(error.to_string())))?;
        let row = |i: usize| built.adjacency().row(i).iter().map(move |(j, _)| (i, *j)).collect::<Vec<_>>();
        let pairs = (0..order).flat_map(row).filter(|(i, j)| i < j).collect();
        Ok(Network::fixed(order, pairs, false, format!("fixed network {graph}")))
    }

    fn listed(order: usize, section: &Section, can: Abilities) -> Result<Self, ConfigError> {
        let directed = match section.get("directed") {
            None => false,
            Some(entry) => {
                let directed = entry.flag()?;
                if directed && !can.directed {
                    return Err(entry.problem(Problem::Network { model: can.model, needs: "an undirected graph" }));
                }
                directed
            }
        };
        let arcs = arc_list(order, section, directed, can)?;
        let weights = arcs
            .iter()
            .any(|(.., weight)| !weight.is_one())
            .then(|| arcs.iter().map(|(i, j, weight)| ((*i, *j), weight.clone())).collect());
        let pairs = pairs_of(arcs, directed);
        let coming = timetable(order, section, directed, can)?;
        let kind = if directed { DIRECTED } else { "edges" };
        let mut declaration = counted(pairs.len(), directed, weights.is_some());
        if let (Some((last, _)), Some((first, _))) = (coming.first(), coming.last()) {
            declaration = format!(
                "network of {} {kind}, replaced {} times, first at t = {first}, last at t = {last}; each is in force from its time on",
                pairs.len(),
                coming.len()
            );
        }
        Ok(Network { coming, weights, ..Network::fixed(order, pairs, directed, declaration) })
    }

    fn fixed(order: usize, pairs: Vec<Pair>, directed: bool, declaration: String) -> Self {
        let mut network = Network { pairs, ..Network::switching(order, Rule::Fixed, directed, declaration) };
        network.relist();
        network
    }

    /// The same where places have so many coordinates, 1 to 3.
    pub fn of_width(self, width: usize) -> Self {
        Network { width, ..self }
    }

    /// The number of coordinates of a place.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Links by a rule, none as yet.
    pub fn switching(order: usize, rule: Rule, directed: bool, declaration: String) -> Self {
        let lists = Some(Neighbours::from_arcs(order, []));
        let (pairs, radius, coming, weights) = (Vec::new(), None, Vec::new(), None);
        Network { order, width: 2, rule, directed, pairs, lists, radius, coming, weights, declaration }
    }

    /// The lists of neighbours from the pairs.
    fn relist(&mut self) {
        let back = |&(i, j): &Pair| if self.directed { None } else { Some((j, i)) };
        let arcs = self.pairs.iter().copied().chain(self.pairs.iter().filter_map(back));
        self.lists = Some(Neighbours::from_arcs(self.order, arcs));
    }

    /// The number of agents.
    pub fn order(&self) -> usize {
        self.order
    }

    /// What is linked, in words.
    pub fn declaration(&self) -> &str {
        &self.declaration
    }

    /// What makes the links.
    pub fn rule(&self) -> Rule {
        self.rule
    }

    /// Whether the links depend on the positions.
    pub fn switches(&self) -> bool {
        self.rule != Rule::Fixed
    }

    /// Whether everyone senses everyone for ever: by the lists that move the agents, since a number of arcs tells nothing of who has them.
    pub fn is_all_to_all(&self) -> bool {
        let Some(lists) = &self.lists else { return true };
        let everyone = (0..self.order).all(|k| lists.of_particle(k).len() + 1 == self.order);
        everyone && !self.switches() && self.coming.is_empty()
    }

    /// The distance below which agents are linked.
    pub fn radius(&self) -> Option<f64> {
        match self.rule {
            Rule::Within(radius) => Some(radius),
            _ => None,
        }
    }

    /// The same number as it was given.
    pub fn exact_radius(&self) -> Option<&Rational> {
        self.radius.as_ref()
    }

    /// The edges, or the arcs of a directed network; empty for an implicit all-to-all network.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// The neighbours of an agent; empty for an implicit all-to-all network.
    pub fn neighbours(&self, k: usize) -> &[usize] {
        self.lists.as_ref().map_or(&[], |lists| lists.of_particle(k))
    }

    /// Whether edges have weights of their own.
    pub fn is_weighted(&self) -> bool {
        self.weights.is_some()
    }

    /// The neighbours of an agent with their weights, which are 1 where none is given.
    pub fn weighted(&self, k: usize) -> impl Iterator<Item = (usize, Rational)> + '_ {
        let known = move |j: usize| self.weights.as_ref().and_then(|weights| weights.get(&(k, j)));
        let weight = move |j: usize| known(j).cloned().unwrap_or_else(Rational::one);
        self.neighbours(k).iter().map(move |&j| (j, weight(j)))
    }

    /// Who senses whom in a network that stays as it is, or why it does not.
    pub fn unchanging(&self) -> Result<Neighbours, &'static str> {
        if self.next_time().is_some() {
            return Err(TIMED);
        }
        if self.switches() {
            return Err("links to the nearest are not enclosed");
        }
        Ok(self.lists.clone().unwrap_or_else(|| Neighbours::complete(self.order)))
    }

    /// Sets the links of a network that switches: edges `i < j`, or arcs.
    pub fn set_pairs(&mut self, mut pairs: Vec<Pair>) {
        pairs.sort_unstable();
        self.pairs = pairs;
        self.relist();
    }

    /// When other links come into force, if ever.
    pub fn next_time(&self) -> Option<f64> {
        self.coming.last().map(|(time, _)| *time)
    }

    /// Puts the next links into force.
    pub fn replace(&mut self) -> Vec<Change> {
        let Some((_, pairs)) = self.coming.pop() else { return Vec::new() };
        self.exchange(pairs)
    }

    /// Puts other links into the place of those that there are; what has changed.
    pub fn exchange(&mut self, mut pairs: Vec<Pair>) -> Vec<Change> {
        pairs.sort_unstable();
        // Both are sorted, and most stands in both.
        let (mut old, mut new) = (self.pairs.iter().peekable(), pairs.iter().peekable());
        let mut changes = Vec::new();
        loop {
            let (pair, gained) = match (old.peek(), new.peek()) {
                (None, None) => break,
                (Some(&&pair), None) => (pair, false),
                (None, Some(&&pair)) => (pair, true),
                (Some(a), Some(b)) => match a.cmp(b) {
                    Ordering::Equal => {
                        old.next();
                        new.next();
                        continue;
                    }
                    Ordering::Less => (**a, false),
                    Ordering::Greater => (**b, true),
                },
            };
            if gained {
                new.next()
            } else {
                old.next()
            };
            changes.push(Change { gained, pair });
        }
        if !changes.is_empty() {
            self.set_pairs(pairs);
        }
        changes
    }

    /// All links, arcs taken as edges.
    pub fn links(&self) -> Vec<Pair> {
        match self.lists {
            Some(_) => self.pairs.clone(),
            None => (0..self.order).flat_map(|i| (i + 1..self.order).map(move |j| (i, j))).collect(),
        }
    }

    /// The links, for what is measured on them.
    pub fn shown(&self) -> Links<'_> {
        match self.lists {
            Some(_) => Links::These(self.order, Cow::Borrowed(&self.pairs)),
            None => Links::Everyone(self.order),
        }
    }

    /// Who senses whom.
    pub fn sensing(&self) -> Sensing<'_> {
        self.lists.as_ref().map_or(Sensing::Everyone, |lists| Sensing::These(Cow::Borrowed(lists)))
    }
}

/// Longest text of a graph that a declaration repeats.
const LONGEST_DECLARED: usize = 200;

const DIRECTED: &str = "arcs i -> j (i senses j)";

fn counted(pairs: usize, directed: bool, weighted: bool) -> String {
    let (weighted, kind) = (if weighted { "weighted " } else { "" }, if directed { DIRECTED } else { "edges" });
    format!("fixed network of {pairs} {weighted}{kind}")
}

/// A kind that is none of those that there are.
fn unknown(word: &str) -> Problem {
    let kinds = KINDS.map(|(name, _)| name);
    let near = nearest_name(word, kinds).or_else(|| nearest_form(word).map(ToString::to_string));
    let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
    let graphs = "a graph such as edges:4:1-2,2-3, hypercube:3 or graph6:DQc, file:NAME";
    Problem::Name { found: shown(word), allowed: format!("{}, {graphs}{near}", kinds.join(", ")) }
}

const EDGES: &str = "a list of pairs such as [1, 2]";
const WEIGHTED: &str = "a list of pairs such as [1, 2], or with a weight, [1, 2, \"3/5\"]";

/// The key `edges` as arcs with weights, both ways of an edge.
fn arc_list(
    order: usize,
    section: &Section,
    directed: bool,
    can: Abilities,
) -> Result<Vec<(usize, usize, Rational)>, ConfigError> {
    let expected = if can.weighted { WEIGHTED } else { EDGES };
    let mut arcs = ArcList::default();
    for (item, number) in section.need("edges", expected)?.items(expected)?.into_iter().zip(1..) {
        let ends = item.items(expected)?;
        let (first, second, weight) = match &ends[..] {
            [first, second] => (first, second, Rational::one()),
            [first, second, weight] if can.weighted => {
                let value = weight.finite()?;
                if !value.is_positive() {
                    return Err(weight.range("a number above 0"));
                }
                (first, second, value)
            }
            [_, _, weight] => {
                return Err(weight.problem(Problem::Network { model: can.model, needs: "edges without weights" }));
            }
            _ => return Err(item.problem(Problem::Shape(expected.to_string()))),
        };
        let (i, j) = (first.count(0, usize::MAX)?, second.count(0, usize::MAX)?);
        if i.min(j) < 1 || i.max(j) > order {
            return Err(item.problem(Problem::EdgeRange(i, j, order)));
        }
        if i == j {
            return Err(item.problem(Problem::Loop(i)));
        }
        arcs.add((i - 1, j - 1), weight, !directed, number)
            .map_err(|first| item.problem(Problem::Duplicate { pair: (i, j), first, second: number }))?;
    }
    Ok(arcs.into_arcs())
}

/// Pairs `i < j`, or arcs, in order.
fn pairs_of(arcs: Vec<(usize, usize, Rational)>, directed: bool) -> Vec<Pair> {
    let arcs = arcs.into_iter().map(|(i, j, _)| (i, j));
    let mut pairs: Vec<Pair> = arcs.filter(|(i, j)| directed || i < j).collect();
    pairs.sort_unstable();
    pairs
}

/// The key `switches`: the times from which on other edges are in force, and these; the first one last.
fn timetable(
    order: usize,
    section: &Section,
    directed: bool,
    can: Abilities,
) -> Result<Vec<(f64, Vec<Pair>)>, ConfigError> {
    let Some(entry) = section.get("switches") else { return Ok(Vec::new()) };
    let mut coming: Vec<(f64, Vec<Pair>)> = Vec::new();
    for item in entry.items("a list such as [{ at = 5, edges = [[1, 2]] }]")? {
        let table = item.table("graph.switches")?;
        table.allow(&["at", "edges"], "")?;
        let at = table.need("at", "the time from which on these edges are in force")?;
        let time = at.positive()?;
        if let Some((before, _)) = coming.last().filter(|(before, _)| *before >= time) {
            return Err(at.problem(Problem::Order { before: *before, after: time }));
        }
        coming
            .push((time, pairs_of(arc_list(order, &table, directed, Abilities { weighted: false, ..can })?, directed)));
    }
    coming.reverse();
    Ok(coming)
}
