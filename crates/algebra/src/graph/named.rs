//! Graphs that have a name: `ring:12`, `circulant:12:1,3`, `platoon2:8`.

use super::WeightedGraph;
use arithmetic::{Rational, nearest_name, parse_rational, rational, shown};
use num_bigint::BigInt;
use num_traits::Signed;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

/// Most vertices of a named graph.
pub const LARGEST_ORDER: usize = 1 << 20;

/// Largest side of a grid, and of a complete bipartite graph.
const LARGEST_SIDE: usize = 1 << 10;

/// Largest dimension of a hypercube.
const LARGEST_DIMENSION: usize = 16;

/// Most arcs of a named graph that is built.
const MOST_ARCS: usize = 1 << 21;

/// A graph known by its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NamedGraph {
    /// `ring:N`, N >= 3: each vertex is joined to the next, the last to the first.
    Ring(usize),
    /// `cycle:N`: one arc from each vertex to the next, from the last to the first.
    Cycle(usize),
    /// `path:N`: each vertex is joined to the next.
    Path(usize),
    /// `complete:N`: all pairs are joined.
    Complete(usize),
    /// `star:N`: the first vertex is joined to the N - 1 others.
    Star(usize),
    /// `circulant:N:a,b,..`: `i` is joined to `i + a`, `i - a`, `i + b`, .. modulo N. The offsets are kept between 1 and N/2.
    Circulant(usize, BTreeSet<usize>),
    /// `platoon1:M`: vertex 1 is the leader, who senses nobody; each of the M followers of the car in front
    /// (Veerman et al., equation (1)).
    PlatoonOne(usize),
    /// `platoon2:M`: each follower senses the cars in front and behind with weights 1/2; the last one only the car in front,
    /// with weight 1 (equation (2)).
    PlatoonTwo(usize),
    /// `wheel:N`, N >= 4: the first vertex is joined to the N - 1 others, which form a ring.
    Wheel(usize),
    /// `empty:N`: no edges.
    Empty(usize),
    /// `bipartite:A,B`: each of the first A vertices is joined to each of the B others.
    Bipartite(usize, usize),
    /// `grid:AxB`: A rows of B vertices, each joined to the next in its row and in its column.
    Grid(usize, usize),
    /// `hypercube:D`: the 2^D words of D bits, joined where they differ in one bit.
    Hypercube(usize),
    /// `petersen`: the pairs of five things, joined where they have nothing in common; as two rings of five, the outer one first.
    Petersen,
    /// `geometric:N:R:SEED`: N points at random in the unit square, joined at distance R or less.
    Geometric {
        /// Number of points.
        order: usize,
        /// The largest distance of points that are joined.
        radius: Rational,
        /// Seed of the points.
        seed: u64,
    },
}

/// Why a text names no graph.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NameError {
    /// Not one of the families.
    #[error("`{text}` names no graph{} {}", .nearest.map_or(": known are".to_string(), |form| format!("; did you mean {form}? Known are")), FORMS.join(", "))]
    Unknown {
        /// What was given.
        text: String,
        /// The form of a name that is spelled much like it.
        nearest: Option<&'static str>,
    },
    /// A parameter is missing, or there is one too many.
    #[error("`{text}` is not of the form {form}")]
    Form {
        /// What was given.
        text: String,
        /// What is expected.
        form: &'static str,
    },
    /// A number that is not between its bounds.
    #[error("`{text}`: {what} must be an integer between {least} and {most}")]
    Range {
        /// What was given.
        text: String,
        /// Which parameter.
        what: &'static str,
        /// Its least value.
        least: usize,
        /// Its largest value.
        most: usize,
    },
    /// A radius that is not a positive number.
    #[error("`{0}`: the radius must be a positive number")]
    Radius(String),
    /// More arcs than are stored.
    #[error("{0} has more than {MOST_ARCS} arcs, which are too many to store")]
    TooManyArcs(String),
}

/// All texts that name a graph.
const FORMS: [&str; 21] = [
    "ring:N",
    "cycle:N",
    "path:N",
    "complete:N",
    "star:N",
    "wheel:N",
    "empty:N",
    "bipartite:A,B",
    "grid:AxB",
    "hypercube:D",
    "petersen",
    "circulant:N:a,b,..",
    "platoon1:M",
    "platoon2:M",
    "geometric:N:R:SEED",
    "edges:N:1-2,2-3",
    "arcs:N:1-2,2-3",
    "graph6:..",
    "sparse6:..",
    "digraph6:..",
    "file:NAME",
];

/// The form of the text that names a graph whose name, which stands before its first `:`, is spelled most like this one; `None` where none is near.
pub fn nearest_form(name: &str) -> Option<&'static str> {
    if name.starts_with("file:") {
        return None;
    }
    let first = |text: &'_ str| text.split(':').next().unwrap_or_default().to_string();
    let names = FORMS.map(first);
    let near = nearest_name(&first(name), names.iter().map(String::as_str))?;
    FORMS.into_iter().find(|form| first(form) == near)
}

impl FromStr for NamedGraph {
    type Err = NameError;

    fn from_str(text: &str) -> Result<Self, NameError> {
        let parts: Vec<&str> = text.split(':').collect();
        let integer = |part: &str, what: &'static str, least: usize, most: usize| {
            let digits = !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
            let number = part.parse::<usize>().ok().filter(|n| digits && (least..=most).contains(n));
            number.ok_or_else(|| NameError::Range { text: shown(text), what, least, most })
        };
        let only = |form: &'static str, what: &'static str, least: usize, most: usize| match parts[..] {
            [_, n] => integer(n, what, least, most),
            _ => Err(NameError::Form { text: shown(text), form }),
        };
        let vertices = "the number of vertices";
        match parts[0] {
            "ring" => only("ring:N", vertices, 3, LARGEST_ORDER).map(NamedGraph::Ring),
            "cycle" => only("cycle:N", vertices, 1, LARGEST_ORDER).map(NamedGraph::Cycle),
            "path" => only("path:N", vertices, 1, LARGEST_ORDER).map(NamedGraph::Path),
            "complete" => only("complete:N", vertices, 1, LARGEST_ORDER).map(NamedGraph::Complete),
            "star" => only("star:N", vertices, 1, LARGEST_ORDER).map(NamedGraph::Star),
            "wheel" => only("wheel:N", vertices, 4, LARGEST_ORDER).map(NamedGraph::Wheel),
            "empty" => only("empty:N", vertices, 1, LARGEST_ORDER).map(NamedGraph::Empty),
            "hypercube" => only("hypercube:D", "the dimension", 0, LARGEST_DIMENSION).map(NamedGraph::Hypercube),
            "petersen" if parts.len() == 1 => Ok(NamedGraph::Petersen),
            "petersen" => Err(NameError::Form { text: shown(text), form: "petersen" }),
            "bipartite" | "grid" => {
                let is_grid = parts[0] == "grid";
                let form = if is_grid { "grid:AxB" } else { "bipartite:A,B" };
                let wrong = || NameError::Form { text: shown(text), form };
                let [_, sizes] = parts[..] else { return Err(wrong()) };
                let (a, b) = sizes.split_once(if is_grid { 'x' } else { ',' }).ok_or_else(wrong)?;
                let what = if is_grid { "a side" } else { "a number of vertices" };
                let (a, b) = (integer(a, what, 1, LARGEST_SIDE)?, integer(b, what, 1, LARGEST_SIDE)?);
                Ok(if is_grid { NamedGraph::Grid(a, b) } else { NamedGraph::Bipartite(a, b) })
            }
            "platoon1" => {
                only("platoon1:M", "the number of followers", 1, LARGEST_ORDER - 1).map(NamedGraph::PlatoonOne)
            }
            "platoon2" => {
                only("platoon2:M", "the number of followers", 1, LARGEST_ORDER - 1).map(NamedGraph::PlatoonTwo)
            }
            "circulant" => {
                let [_, n, offsets] = parts[..] else {
                    return Err(NameError::Form { text: shown(text), form: "circulant:N:a,b,.." });
                };
                let order = integer(n, vertices, 2, LARGEST_ORDER)?;
                let offset = |part: &str| integer(part, "an offset", 1, order - 1).map(|a| a.min(order - a));
                Ok(NamedGraph::Circulant(order, offsets.split(',').map(offset).collect::<Result<_, _>>()?))
            }
            "geometric" => {
                let [_, n, radius, seed] = parts[..] else {
                    return Err(NameError::Form { text: shown(text), form: "geometric:N:R:SEED" });
                };
                let order = integer(n, vertices, 1, 1 << 14)?;
                let seed = integer(seed, "the seed", 0, usize::MAX)? as u64;
                let radius = parse_rational(radius).ok().filter(Signed::is_positive);
                let radius = radius.ok_or_else(|| NameError::Radius(shown(text)))?;
                Ok(NamedGraph::Geometric { order, radius, seed })
            }
            _ => Err(NameError::Unknown { text: shown(text), nearest: nearest_form(text) }),
        }
    }
}

impl fmt::Display for NamedGraph {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NamedGraph::Ring(n) => write!(f, "ring:{n}"),
            NamedGraph::Cycle(n) => write!(f, "cycle:{n}"),
            NamedGraph::Path(n) => write!(f, "path:{n}"),
            NamedGraph::Complete(n) => write!(f, "complete:{n}"),
            NamedGraph::Star(n) => write!(f, "star:{n}"),
            NamedGraph::Circulant(n, offsets) => {
                let offsets: Vec<String> = offsets.iter().map(ToString::to_string).collect();
                write!(f, "circulant:{n}:{}", offsets.join(","))
            }
            NamedGraph::Wheel(n) => write!(f, "wheel:{n}"),
            NamedGraph::Empty(n) => write!(f, "empty:{n}"),
            NamedGraph::Bipartite(a, b) => write!(f, "bipartite:{a},{b}"),
            NamedGraph::Grid(a, b) => write!(f, "grid:{a}x{b}"),
            NamedGraph::Hypercube(d) => write!(f, "hypercube:{d}"),
            NamedGraph::Petersen => write!(f, "petersen"),
            NamedGraph::PlatoonOne(m) => write!(f, "platoon1:{m}"),
            NamedGraph::PlatoonTwo(m) => write!(f, "platoon2:{m}"),
            NamedGraph::Geometric { order, radius, seed } => write!(f, "geometric:{order}:{radius}:{seed}"),
        }
    }
}

impl NamedGraph {
    /// Number of vertices; a platoon has its followers and the leader.
    pub fn order(&self) -> usize {
        match self {
            NamedGraph::Ring(n)
            | NamedGraph::Cycle(n)
            | NamedGraph::Path(n)
            | NamedGraph::Complete(n)
            | NamedGraph::Star(n)
            | NamedGraph::Wheel(n)
            | NamedGraph::Empty(n)
            | NamedGraph::Circulant(n, _)
            | NamedGraph::Geometric { order: n, .. } => *n,
            NamedGraph::Bipartite(a, b) => a.saturating_add(*b),
            NamedGraph::Grid(a, b) => a.saturating_mul(*b),
            NamedGraph::Hypercube(d) => {
                u32::try_from(*d).ok().and_then(|d| 1usize.checked_shl(d)).unwrap_or(usize::MAX)
            }
            NamedGraph::Petersen => 10,
            NamedGraph::PlatoonOne(m) | NamedGraph::PlatoonTwo(m) => m.saturating_add(1),
        }
    }

    /// Whether its numbers are those of a graph: whether the name that it would have can be read.
    ///
    /// # Errors
    /// [`NameError`] where they are not.
    pub fn check(&self) -> Result<(), NameError> {
        self.to_string().parse().map(|_: NamedGraph| ())
    }

    /// Whether it is made of arcs and not of edges, however few there are.
    pub fn is_directed(&self) -> bool {
        matches!(self, NamedGraph::Cycle(_) | NamedGraph::PlatoonOne(_) | NamedGraph::PlatoonTwo(_))
    }

    /// The graph itself.
    ///
    /// # Errors
    /// [`NameError::TooManyArcs`], and those of [`NamedGraph::check`].
    pub fn build(&self) -> Result<WeightedGraph, NameError> {
        self.check()?;
        let n = self.order();
        let arcs = match self {
            NamedGraph::Complete(_) => n.saturating_mul(n),
            NamedGraph::Circulant(_, offsets) => 2 * n * offsets.len(),
            NamedGraph::Bipartite(a, b) => 2 * a * b,
            NamedGraph::Hypercube(d) => n * d,
            _ => n,
        };
        if arcs > MOST_ARCS {
            return Err(NameError::TooManyArcs(self.to_string()));
        }
        let one = || rational(1, 1);
        let undirected = |edges: Vec<(usize, usize)>| {
            let arcs = edges.into_iter().flat_map(|(i, j)| [(i, j, one()), (j, i, one())]);
            WeightedGraph::from_arcs(n, arcs)
        };
        Ok(match self {
            NamedGraph::Ring(_) => undirected((0..n).map(|i| (i, (i + 1) % n)).collect()),
            NamedGraph::Cycle(_) => WeightedGraph::from_arcs(n, (0..n).map(|i| (i, (i + 1) % n, one()))),
            NamedGraph::Path(_) => undirected((1..n).map(|i| (i - 1, i)).collect()),
            NamedGraph::Complete(_) => undirected((0..n).flat_map(|j| (0..j).map(move |i| (i, j))).collect()),
            NamedGraph::Star(_) => undirected((1..n).map(|i| (0, i)).collect()),
            NamedGraph::Wheel(_) => {
                undirected((1..n).flat_map(|i| [(0, i), (i, if i + 1 < n { i + 1 } else { 1 })]).collect())
            }
            NamedGraph::Empty(_) => undirected(Vec::new()),
            NamedGraph::Bipartite(a, _) => undirected((0..*a).flat_map(|i| (*a..n).map(move |j| (i, j))).collect()),
            NamedGraph::Grid(_, b) => {
                let next = |i: usize| {
                    [(i, i + 1), (i, i + b)]
                        .into_iter()
                        .filter(move |&(i, j)| j < n && (j > i + 1 || j == i + b || j % b != 0))
                };
                undirected((0..n).flat_map(next).collect())
            }
            NamedGraph::Hypercube(d) => {
                let flipped = |i: usize| (0..*d).map(move |k| (i, i ^ 1 << k)).filter(|(i, j)| i < j);
                undirected((0..n).flat_map(flipped).collect())
            }
            NamedGraph::Petersen => {
                let spokes = |i: usize| [(i, (i + 1) % 5), (i, i + 5), (i + 5, (i + 2) % 5 + 5)];
                undirected((0..5).flat_map(spokes).collect())
            }
            NamedGraph::Circulant(_, offsets) => {
                // An offset of half the order joins each pair once.
                let both = offsets.iter().flat_map(|&a| BTreeSet::from([a, n - a]));
                let steps: Vec<usize> = both.collect();
                let arcs = (0..n).flat_map(|i| steps.iter().map(move |a| (i, (i + a) % n, one())));
                WeightedGraph::from_arcs(n, arcs)
            }
            NamedGraph::PlatoonOne(_) => WeightedGraph::from_arcs(n, (1..n).map(|i| (i, i - 1, one()))),
            NamedGraph::PlatoonTwo(m) => {
                let half = || rational(1, 2);
                let middle = (1..*m).flat_map(|i| [(i, i - 1, half()), (i, i + 1, half())]);
                WeightedGraph::from_arcs(n, middle.chain([(*m, m - 1, one())]))
            }
            NamedGraph::Geometric { radius, seed, .. } => {
                let edges: Vec<(usize, usize)> = close_pairs(n, radius, *seed).take(MOST_ARCS / 2 + 1).collect();
                if edges.len() > MOST_ARCS / 2 {
                    return Err(NameError::TooManyArcs(self.to_string()));
                }
                undirected(edges)
            }
        })
    }
}

/// The pairs at distance `radius` or less among points whose coordinates are multiples of `2^-32`; decided exactly.
fn close_pairs(order: usize, radius: &Rational, seed: u64) -> impl Iterator<Item = (usize, usize)> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut point = || (i64::from(random.next_u32()), i64::from(random.next_u32()));
    let points: Vec<(i64, i64)> = (0..order).map(|_| point()).collect();
    // floor((2^32 radius)²): squares of distances are integers of at most 65 bits.
    let limit = (radius * radius * Rational::from_integer(BigInt::from(1) << 64)).to_integer();
    let limit = u128::try_from(limit).unwrap_or(u128::MAX);
    let close = move |&(i, j): &(usize, usize)| {
        let square = |a: i64, b: i64| u128::from(a.abs_diff(b)) * u128::from(a.abs_diff(b));
        square(points[i].0, points[j].0) + square(points[i].1, points[j].1) <= limit
    };
    (0..order).flat_map(|j| (0..j).map(move |i| (i, j))).filter(close)
}
