//! The members of what the names of `[for]` range over, one after the other.

use crate::bindings::{Bindings, Value};
use crate::case::Case;
use crate::domain::{Domain, Members};
use crate::error::Problem;
use crate::evaluate::Evaluator;
use crate::failure::Failure;
use crate::names::FAMILIES;
use crate::question::Question;
use crate::subject::graph::changed_by_one_link;
use crate::syntax::{Kind, Node};
use algebra::graph::classes::{
    LARGEST_CLASSES, LARGEST_DIGRAPH_CLASSES, LARGEST_SPARSE_CLASSES, bipartite_graphs, connected_graphs, digraphs,
    graphs, planar_graphs, regular_graphs, trees,
};
use algebra::graph::{AnyGraph, Graph};
use algebra::matrix::StochasticMatrix;
use arithmetic::RealNumber as Number;
use arithmetic::{Progress, Rational, random, rational, shown};
use motion::sets::Range;
use num_traits::{One, Signed, ToPrimitive};
use rand_chacha::rand_core::Rng;
use std::sync::Arc;

/// Which classes of graphs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Class {
    Connected,
    All,
    Trees,
    Digraphs,
    Bipartite,
    Planar,
    /// Of this degree.
    Regular,
}

/// Trees of larger orders take longer than a question should.
const LARGEST_TREES: usize = 16;

const CLASSES: [(&str, Class, usize); 7] = [
    ("connected", Class::Connected, LARGEST_CLASSES),
    ("all", Class::All, LARGEST_CLASSES),
    ("trees", Class::Trees, LARGEST_TREES),
    ("digraphs", Class::Digraphs, LARGEST_DIGRAPH_CLASSES),
    ("bipartite", Class::Bipartite, LARGEST_SPARSE_CLASSES),
    ("planar", Class::Planar, LARGEST_CLASSES),
    ("regular", Class::Regular, LARGEST_SPARSE_CLASSES),
];

/// Graphs of which all labellings are looked at.
const MOST_LABELLED: usize = 6;

impl Class {
    /// Known numbers of classes, for orders from 1 (OEIS A001349, A000088, A000055, A000273,
    /// A033995, A005470); nothing of regular graphs, whose number depends on the degree.
    fn counts(self) -> &'static [u64] {
        match self {
            Class::Connected => &[1, 1, 2, 6, 21, 112, 853, 11117, 261_080, 11_716_571, 1_006_700_565, 164_059_830_476],
            Class::All => &[1, 2, 4, 11, 34, 156, 1044, 12346, 274_668, 12_005_168, 1_018_997_864, 165_091_172_592],
            Class::Trees => &[
                1, 1, 1, 2, 3, 6, 11, 23, 47, 106, 235, 551, 1301, 3159, 7741, 19320, 48629, 123_867, 317_955, 823_065,
                2_144_505, 5_623_756,
            ],
            Class::Digraphs => &[1, 3, 16, 218, 9608, 1_540_944, 882_033_440, 1_793_359_192_848],
            Class::Bipartite => &[1, 2, 3, 7, 13, 35, 88, 303, 1119, 5479, 32303, 251_135, 2_527_712],
            Class::Planar => &[1, 2, 4, 11, 33, 142, 822, 6966, 79853, 1_140_916, 18_681_008],
            Class::Regular => &[],
        }
    }

    fn size(self, order: usize) -> String {
        match self.counts().get(order - 1) {
            Some(count) => count.to_string(),
            None => self.counts().last().map_or("too many".to_string(), |most| format!("more than {most}")),
        }
    }
}

/// Makes members from the names bound so far.
pub(crate) struct Maker<'a> {
    pub question: &'a Question,
    pub bindings: &'a Bindings,
    pub progress: &'a dyn Progress,
}

type Made<T> = Result<T, Failure>;

impl Maker<'_> {
    /// The members of a domain.
    pub fn members(&self, domain: &Domain) -> Made<Members> {
        match domain {
            Domain::Given(value) => Ok(Members::Listed(vec![value.clone()])),
            Domain::List(list) => {
                let mut all = Vec::new();
                for (_, domain) in list {
                    let members = self.members(domain)?;
                    all.extend((0..members.len()).filter_map(|k| members.get(k)));
                }
                Ok(Members::Listed(all))
            }
            Domain::Written(node) => self.written(node),
        }
    }

    fn written(&self, node: &Node) -> Made<Members> {
        match &node.kind {
            Kind::Range(from, to) => {
                let (from, to) =
                    (self.integer(from, "the start of the range")?, self.integer(to, "the end of the range")?);
                Ok(Members::Integers(from, to))
            }
            Kind::Interval(from, to) => {
                let (lo, hi) = (self.exact(from)?, self.exact(to)?);
                if lo > hi {
                    let why = format!("the interval [{lo}, {hi}] ends before it begins");
                    return Err(Failure::Refused(node.at, Problem::Empty(why)));
                }
                Ok(Members::Listed(vec![if lo == hi { Value::Number(lo) } else { Value::Box(Range { lo, hi }) }]))
            }
            Kind::Name { name, arguments, called: true } if FAMILIES.iter().any(|family| family.name == name) => {
                self.family(name, arguments, node)
            }
            Kind::Name { name, called: false, .. }
                if matches!(self.bindings.get(name), Some(Value::Graph(_) | Value::Matrices(_))) =>
            {
                Ok(Members::Listed(self.bindings.get(name).cloned().into_iter().collect()))
            }
            _ => Ok(Members::Listed(vec![Value::Number(self.exact(node)?)])),
        }
    }

    /// An expression that must be a rational number.
    fn exact(&self, node: &Node) -> Made<Rational> {
        let case = Case::new(self.question, self.bindings.clone(), self.progress);
        match (Evaluator { case: &case, precision: 64, moment: None, piece: None }).number(node)? {
            Number::Exact(q) => Ok(q),
            other => Err(Failure::Refused(node.at, Problem::expected("a rational number", other.text()))),
        }
    }

    fn integer(&self, node: &Node, what: &str) -> Made<i64> {
        let q = self.exact(node)?;
        let refuse = |problem| Failure::Refused(node.at, problem);
        if !q.is_integer() {
            return Err(refuse(Problem::NotInteger { what: what.to_string(), found: shown(&q.to_string()) }));
        }
        const LARGEST: u64 = 1 << 60;
        let range = || Problem::Range {
            what: what.to_string(),
            expected: "at most 2^60 in size".to_string(),
            found: shown(&q.to_string()),
        };
        q.to_i64().filter(|n| n.unsigned_abs() <= LARGEST).ok_or_else(|| refuse(range()))
    }

    /// An integer between two.
    fn count(&self, node: &Node, what: &str, least: usize, most: usize) -> Made<usize> {
        let n = self.integer(node, what)?;
        let range = || Problem::Range {
            what: what.to_string(),
            expected: format!("between {least} and {most}"),
            found: n.to_string(),
        };
        let found = usize::try_from(n).ok().filter(|n| (least..=most).contains(n));
        found.ok_or_else(|| Failure::Refused(node.at, range()))
    }

    fn family(&self, name: &str, arguments: &[Node], node: &Node) -> Made<Members> {
        let vertices = "the number of vertices";
        let refuse = |message: String| Failure::Refused(node.at, Problem::Other(message));
        if let Some((_, class, most)) = CLASSES.into_iter().find(|(known, ..)| *known == name) {
            let order = self.count(&arguments[0], vertices, 1, 1000)?;
            if order > most {
                let problem = Problem::TooLarge { what: format!("{name}({order})"), size: class.size(order), most };
                return Err(Failure::Refused(node.at, problem));
            }
            let degree = arguments.get(1).map_or(Ok(0), |node| self.count(node, "the degree", 0, 1000))?;
            return Ok(Members::Graphs(self.class(class, order, degree)?));
        }
        match name {
            "integers" => {
                let from = self.integer(&arguments[0], "the first argument of `integers`")?;
                let to = self.integer(&arguments[1], "the second argument of `integers`")?;
                if from > to {
                    let why = format!("there is no integer from {from} to {to}");
                    return Err(Failure::Refused(node.at, Problem::Empty(why)));
                }
                Ok(Members::Listed(vec![Value::integers(from, to)]))
            }
            "random" => {
                let order = self.count(&arguments[0], vertices, 1, 1000)?;
                let p = self.exact(&arguments[1])?;
                if p.is_negative() || p > rational(1, 1) {
                    let found = shown(&p.to_string());
                    let problem = Problem::Range {
                        what: "a probability".to_string(),
                        expected: "between 0 and 1".to_string(),
                        found,
                    };
                    return Err(Failure::Refused(arguments[1].at, problem));
                }
                Ok(Members::Listed(vec![Value::Graph(Arc::new(AnyGraph::Simple(self.random(order, &p, node)?)))]))
            }
            "with_link" | "without_link" => {
                let given = match &arguments[0].kind {
                    Kind::Name { name, called: false, .. } => self.bindings.get(name),
                    _ => None,
                };
                let Some(Value::Graph(graph)) = given else {
                    return Err(refuse(format!("`{name}` takes the name of a graph that is bound before")));
                };
                let simple = graph.simple().filter(|_| graph.is_unweighted() && graph.first_loop().is_none());
                let Some(simple) = simple else {
                    let needed = "an undirected graph without loops whose links all have weight 1";
                    return Err(refuse(format!("`{name}` takes {needed}")));
                };
                let changed = changed_by_one_link(&simple, name == "with_link").into_iter();
                Ok(Members::Listed(changed.map(|g| Value::Graph(Arc::new(AnyGraph::Simple(g)))).collect()))
            }
            "joined" => {
                let named = |node: &Node| match &node.kind {
                    Kind::Name { name, called: false, .. } => self.bindings.get(name),
                    _ => None,
                };
                let (Some(Value::Matrices(first)), Some(Value::Matrices(second))) =
                    (named(&arguments[0]), named(&arguments[1]))
                else {
                    let needed = "`joined` takes the names of two sequences of matrices that are bound before";
                    return Err(refuse(needed.to_string()));
                };
                let both = [first.as_slice(), second.as_slice()].concat();
                Ok(Members::Listed(vec![Value::Matrices(Arc::new(both))]))
            }
            "stochastic" | "products" => {
                let size = self.count(&arguments[0], "the order", 1, 8)?;
                let denominator = self.count(&arguments[1], "the denominator", 1, 1000)?;
                let length = match arguments.get(2) {
                    Some(node) => self.count(node, "the number of matrices", 1, 64)?,
                    None => 1,
                };
                all_products(size, denominator, length, self.question.budget(), self.progress)
                    .map_err(|problem| problem.map_or(Failure::Cancelled, |p| Failure::Refused(node.at, p)))
            }
            "random_products" => {
                let size = self.count(&arguments[0], "the order", 1, 64)?;
                let length = self.count(&arguments[1], "the number of matrices", 1, 4096)?;
                let seed = self.seed(node)?;
                let mut stream = random::generator("question", &format!("random products {size} {length}"), seed);
                let list = (0..length).map(|_| random_stochastic(size, &mut stream)).collect::<Option<Vec<_>>>();
                let list = list.ok_or_else(|| refuse("no stochastic matrix could be drawn".to_string()))?;
                Ok(Members::Listed(vec![Value::Matrices(Arc::new(list))]))
            }
            // The graphs that have names.
            _ => {
                let order = self.count(&arguments[0], "its number", 0, 1 << 20)?;
                let found: AnyGraph = format!("{name}:{order}").parse().map_err(|e| refuse(format!("{e}")))?;
                Ok(Members::Listed(vec![Value::Graph(Arc::new(found))]))
            }
        }
    }

    /// The seed that was bound before.
    fn seed(&self, node: &Node) -> Made<u64> {
        let missing = "a random family needs `seed` in [for] before it, such as seed = \"1..1000\"";
        match self.bindings.get("seed") {
            Some(Value::Number(q)) if q.is_integer() => q
                .to_u64()
                .ok_or_else(|| Failure::Refused(node.at, Problem::Other("`seed` must not be negative".to_string()))),
            _ => Err(Failure::Refused(node.at, Problem::Other(missing.to_string()))),
        }
    }

    fn random(&self, order: usize, p: &Rational, node: &Node) -> Made<Graph> {
        let seed = self.seed(node)?;
        // The stream depends on the seed and the order, not on the property, so that a replay draws the same.
        let mut stream = random::generator("question", &format!("random graph {order} {p}"), seed);
        let threshold = (p * Rational::from_integer(num_bigint::BigInt::one() << 64)).to_integer();
        let threshold = threshold.to_u128().unwrap_or(0);
        let mut joined = vec![false; order * order.saturating_sub(1) / 2];
        joined.iter_mut().for_each(|bit| *bit = u128::from(stream.next_u64()) < threshold);
        Ok(Graph::from_fn(order, |i, j| joined[j * (j - 1) / 2 + i]))
    }

    fn class(&self, class: Class, order: usize, degree: usize) -> Made<Arc<Vec<Arc<AnyGraph>>>> {
        let key = (class as u8, order, degree);
        let mut made = self.question.classes().lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(known) = made.get(&key) {
            return Ok(known.clone());
        }
        let simple = |list: Vec<Graph>| list.into_iter().map(|g| Arc::new(AnyGraph::Simple(g))).collect::<Vec<_>>();
        let list = match class {
            Class::Connected => simple(connected_graphs(order, self.progress)?),
            Class::All => simple(graphs(order, self.progress)?),
            Class::Trees => simple(trees(order, self.progress)?),
            Class::Bipartite => simple(bipartite_graphs(order, self.progress)?),
            Class::Planar => simple(planar_graphs(order, self.progress)?),
            Class::Regular => simple(regular_graphs(order, degree, self.progress)?),
            Class::Digraphs => {
                digraphs(order, self.progress)?.into_iter().map(|g| Arc::new(AnyGraph::Directed(g))).collect()
            }
        };
        // One of each class stands for all only where agents are alike.
        let list = match self.question.names_agents() {
            true if order > MOST_LABELLED => {
                let why = format!(
                    "agents are named, so that each labelling of a graph is a case of its own: up to {MOST_LABELLED} vertices"
                );
                return Err(Failure::Refused(0, Problem::Other(why)));
            }
            true => list.iter().flat_map(|graph| graph.labellings()).map(Arc::new).collect(),
            false => list,
        };
        let list = Arc::new(list);
        made.insert(key, list.clone());
        Ok(list)
    }
}

/// All sequences of stochastic matrices of an order with entries that are multiples of `1/denominator`; `Err(None)` where it was stopped.
fn all_products(
    size: usize,
    denominator: usize,
    length: usize,
    budget: u64,
    progress: &dyn Progress,
) -> Result<Members, Option<Problem>> {
    let mut rows = vec![vec![denominator as i64]];
    for _ in 1..size {
        // The last entry is split in two.
        let split = |row: Vec<i64>| {
            let (last, others) = row.split_last().map_or((0, Vec::new()), |(last, others)| (*last, others.to_vec()));
            (0..=last).rev().map(move |first| [others.clone(), vec![first, last - first]].concat())
        };
        rows = rows.into_iter().flat_map(split).collect();
        if rows.len() as u64 > budget {
            break;
        }
    }
    let power = u32::try_from(size * length).unwrap_or(u32::MAX);
    let count = num_bigint::BigInt::from(rows.len()).pow(power);
    if count > num_bigint::BigInt::from(budget) {
        return Err(Some(Problem::TooMany { size: shown(&count.to_string()), budget }));
    }
    let total = count.to_u64().unwrap_or(0);
    let sequence = |k: u64| -> Result<Value, Option<Problem>> {
        progress.checkpoint().map_err(|_| None)?;
        let mut rest = k;
        let mut matrices = Vec::with_capacity(length);
        for _ in 0..length {
            let mut chosen = Vec::with_capacity(size);
            for _ in 0..size {
                chosen.push(rows[(rest % rows.len() as u64) as usize].clone());
                rest /= rows.len() as u64;
            }
            let matrix = StochasticMatrix::from_integers(&chosen, denominator as i64);
            matrices.push(matrix.map_err(|error| Some(Problem::Other(error.to_string())))?);
        }
        Ok(Value::Matrices(Arc::new(matrices)))
    };
    Ok(Members::Listed((0..total).map(sequence).collect::<Result<_, _>>()?))
}

/// A matrix whose rows are random shares in 64ths, about half of them zero.
fn random_stochastic(size: usize, stream: &mut impl Rng) -> Option<StochasticMatrix> {
    const WHOLE: i64 = 64;
    let mut row = || {
        let mut shares = vec![0i64; size];
        let places = 1 + stream.next_u64() % size as u64;
        for _ in 0..WHOLE {
            shares[(stream.next_u64() % places) as usize] += 1;
        }
        let turn = (stream.next_u64() % size as u64) as usize;
        shares.rotate_right(turn);
        shares
    };
    let rows: Vec<Vec<i64>> = (0..size).map(|_| row()).collect();
    StochasticMatrix::from_integers(&rows, WHOLE).ok()
}
