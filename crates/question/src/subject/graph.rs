//! Graphs, their quantities and their spectra. What takes long is found when it is asked for, and once.

mod fiedler;
mod spectra;

pub(crate) use spectra::second_modulus;

use crate::error::Problem;
use crate::failure::Failure;
use crate::timeline::Measured;
use algebra::graph::invariants::{LARGEST_CUT, LARGEST_SEARCHED, distances, is_rooted, period};
use algebra::graph::{AnyGraph, Graph, LaplacianKind};
use algebra::matrix::SparseMatrix;
use arithmetic::RealNumber as Number;
use arithmetic::{Progress, Rational};
use num_traits::{Signed, ToPrimitive, Zero};
use spectra::Spectra;
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

/// A graph with what has been found out about it.
pub(crate) struct GraphSubject<'q> {
    graph: Arc<AnyGraph>,
    /// The matrix whose eigenvalues are asked for where no other is named.
    kind: LaplacianKind,
    progress: &'q dyn Progress,
    simple: OnceCell<Option<Graph>>,
    out: OnceCell<Vec<Vec<u32>>>,
    distances: OnceCell<Vec<Vec<Option<usize>>>>,
    resistances: OnceCell<Option<Vec<Vec<Rational>>>>,
    spectra: RefCell<BTreeMap<LaplacianKind, Rc<Spectra>>>,
}

/// The number of a kind of matrix as an argument.
pub(crate) fn kind_number(name: &str) -> Option<i64> {
    let kind = LaplacianKind::from_name(name)?;
    LaplacianKind::NAMES.iter().position(|(_, own)| *own == kind).map(|place| place as i64)
}

type Found = Result<Measured, Failure>;

impl<'q> GraphSubject<'q> {
    pub fn new(graph: Arc<AnyGraph>, kind: LaplacianKind, progress: &'q dyn Progress) -> Self {
        GraphSubject {
            graph,
            kind,
            progress,
            simple: OnceCell::new(),
            out: OnceCell::new(),
            distances: OnceCell::new(),
            resistances: OnceCell::new(),
            spectra: RefCell::default(),
        }
    }

    /// The graph itself.
    pub fn graph(&self) -> &AnyGraph {
        &self.graph
    }

    /// A quantity by its name.
    pub fn measure(&self, name: &str, arguments: &[Number], precision: u32) -> Found {
        match name {
            "n" => count(self.graph.order()),
            "edges" => {
                let arcs = self.graph.arcs();
                count(if self.graph.is_directed() { arcs.len() } else { arcs.iter().filter(|(i, j)| i <= j).count() })
            }
            "min_degree" => count(self.degrees().min().unwrap_or(0)),
            "max_degree" => count(self.degrees().max().unwrap_or(0)),
            "degree" => count(self.out()[self.vertex(name, arguments, 0)?].len()),
            "in_degree" => {
                let own = self.vertex(name, arguments, 0)? as u32;
                count(self.out().iter().filter(|ends| ends.contains(&own)).count())
            }
            "adjacent" => {
                let (i, j) = (self.vertex(name, arguments, 0)?, self.vertex(name, arguments, 1)?);
                truth(self.out()[i].contains(&(j as u32)))
            }
            "distance" | "eccentricity" | "diameter" | "radius" => self.measure_distance(name, arguments),
            "connected" | "strongly_connected" => truth(self.eccentricities().is_some()),
            "rooted" => truth(is_rooted(self.out())),
            "period" => known(
                period(self.out()),
                "the period of a graph in which some vertex cannot be reached from another, or that has no closed walk",
            ),
            "lambda" => self.eigenvalue(arguments, precision),
            "spectral_radius" | "second_modulus" => {
                let weights = self.graph.weighted();
                if weights.adjacency().entries().any(|(_, _, weight)| weight.is_negative()) {
                    return Err(refused(format!("`{name}` is of graphs without negative weights")));
                }
                // Perron and Frobenius: the largest modulus is itself an eigenvalue.
                let number = match name {
                    "spectral_radius" => {
                        self.of_kind(LaplacianKind::Adjacency).eigenvalue(self.graph.order(), precision)
                    }
                    _ => second_modulus(&stochastic(weights.adjacency())?, precision),
                };
                number.map(Measured::Number)
            }
            _ => self.measure_undirected(name, arguments, precision),
        }
    }

    fn measure_distance(&self, name: &str, arguments: &[Number]) -> Found {
        let unreached = "the distances in a graph that is not connected";
        match name {
            "distance" => {
                let (i, j) = (self.vertex(name, arguments, 0)?, self.vertex(name, arguments, 1)?);
                known(self.distances()[i][j], "the distance of two vertices without a way")
            }
            "eccentricity" => {
                let reached = &self.distances()[self.vertex(name, arguments, 0)?];
                known(largest(reached), unreached)
            }
            "radius" => known(self.eccentricities().and_then(|all| all.into_iter().min()), unreached),
            _ => known(
                self.eccentricities().and_then(|all| all.into_iter().max()),
                "the diameter of a graph that is not connected",
            ),
        }
    }

    /// Quantities of graphs without arcs and loops; what depends on weights is of graphs without other ones than 1.
    fn measure_undirected(&self, name: &str, arguments: &[Number], precision: u32) -> Found {
        let graph = self.simple.get_or_init(|| self.graph.simple()).as_ref();
        let graph = graph.ok_or_else(|| refused(format!("`{name}` is of undirected graphs")))?;
        if let Some(vertex) = self.graph.first_loop() {
            let why = format!("`{name}` is of graphs without loops, and vertex {} has one", vertex + 1);
            return Err(refused(why));
        }
        let progress = self.progress;
        match name {
            "girth" => known(graph.girth(), "the girth of a graph without cycles"),
            "bipartite" => truth(graph.is_bipartite()),
            "regular" => truth(graph.is_regular()),
            "planar" => truth(graph.is_planar()),
            "tree" => truth(graph.is_tree()),
            "edge_connectivity" => count(graph.edge_connectivity(progress)?),
            "vertex_connectivity" => count(graph.vertex_connectivity(progress)?),
            "clique_number" => searched(name, graph.clique_number(progress)?, LARGEST_SEARCHED),
            "independence_number" => searched(name, graph.independence_number(progress)?, LARGEST_SEARCHED),
            "chromatic_number" => searched(name, graph.chromatic_number(progress)?, LARGEST_SEARCHED),
            "matching_number" => count(graph.matching_number()),
            _ if self.graph.is_unweighted() => self.measure_unweighted(graph, name, arguments, precision),
            _ => Err(refused(format!("`{name}` is of graphs whose edges all have weight 1"))),
        }
    }

    /// Quantities that depend on weights, of a graph whose edges all have weight 1.
    fn measure_unweighted(&self, graph: &Graph, name: &str, arguments: &[Number], precision: u32) -> Found {
        let progress = self.progress;
        match name {
            "automorphisms" if graph.order() > LARGEST_SEARCHED => searched(name, None, LARGEST_SEARCHED),
            "automorphisms" => exact(Rational::from_integer(graph.automorphism_count(progress)?.into())),
            "cheeger" | "isoperimetric_number" if graph.order() > LARGEST_CUT => searched(name, None, LARGEST_CUT),
            "cheeger" => {
                let missing = "the Cheeger constant of a graph without a cut between vertices that have edges";
                known_exact(graph.cheeger_constant(progress)?, missing)
            }
            "isoperimetric_number" => {
                known_exact(graph.isoperimetric_number(progress)?, "the isoperimetric number of a single vertex")
            }
            "spanning_trees" => exact(Rational::from_integer(graph.spanning_trees())),
            "kirchhoff_index" => {
                known_exact(graph.kirchhoff_index(), "the Kirchhoff index of a graph that is not connected")
            }
            "resistance" => {
                let (i, j) = (self.vertex(name, arguments, 0)?, self.vertex(name, arguments, 1)?);
                let all = self.resistances.get_or_init(|| graph.resistances()).as_ref();
                known_exact(all.map(|all| all[i][j].clone()), "a resistance in a graph that is not connected")
            }
            "fiedler_sign" => {
                let i = self.vertex(name, arguments, 0)?;
                let not_simple =
                    "the second smallest eigenvalue of the Laplacian is not simple, so that it has no one eigenvector";
                if graph.order() < 2 {
                    return Err(refused(not_simple.to_string()));
                }
                let second = self.of_kind(LaplacianKind::Combinatorial).eigenvalue(2, precision)?.enclosure(precision);
                match fiedler::signs(graph, &second, precision)? {
                    Some(signs) => Ok(Measured::Number(Number::integer(signs[i]))),
                    None => Err(refused(not_simple.to_string())),
                }
            }
            _ => Err(refused(format!("`{name}` is no quantity of a graph"))),
        }
    }

    /// The vertex of an argument, from 0.
    fn vertex(&self, name: &str, arguments: &[Number], place: usize) -> Result<usize, Failure> {
        index(&format!("a vertex of `{name}`"), arguments.get(place), self.graph.order()).map(|k| k - 1)
    }

    /// The ends of the arcs from each vertex, loops among them.
    fn out(&self) -> &[Vec<u32>] {
        if let AnyGraph::Simple(graph) = self.graph.as_ref() {
            return graph.lists();
        }
        self.out.get_or_init(|| {
            let mut out = vec![Vec::new(); self.graph.order()];
            self.graph.arcs().into_iter().for_each(|(i, j)| out[i].push(j as u32));
            out
        })
    }

    fn degrees(&self) -> impl Iterator<Item = usize> {
        self.out().iter().map(Vec::len)
    }

    fn distances(&self) -> &[Vec<Option<usize>>] {
        self.distances.get_or_init(|| {
            let out = self.out();
            (0..out.len()).map(|start| distances(out, start)).collect()
        })
    }

    /// The largest distance from each vertex; `None` where some vertex cannot be reached.
    fn eccentricities(&self) -> Option<Vec<usize>> {
        self.distances().iter().map(|reached| largest(reached)).collect()
    }

    fn of_kind(&self, kind: LaplacianKind) -> Rc<Spectra> {
        let mut spectra = self.spectra.borrow_mut();
        spectra.entry(kind).or_insert_with(|| Rc::new(Spectra::new(self.graph.clone(), kind))).clone()
    }

    /// The sum of these powers of all eigenvalues, exactly, where that is the trace of a matrix.
    pub fn power_sum(&self, kind: Option<&Number>, power: u32) -> Option<Rational> {
        self.of_kind(self.kind_of(kind)).power_sum(power)
    }

    fn kind_of(&self, argument: Option<&Number>) -> LaplacianKind {
        let named = argument.and_then(Number::as_integer).and_then(|k| k.to_usize());
        named.and_then(|k| LaplacianKind::NAMES.get(k)).map_or(self.kind, |(_, kind)| *kind)
    }

    fn eigenvalue(&self, arguments: &[Number], precision: u32) -> Found {
        let spectra = self.of_kind(self.kind_of(arguments.get(1)));
        let k = index("the index of `lambda`", arguments.first(), spectra.order())?;
        spectra.eigenvalue(k, precision).map(Measured::Number)
    }
}

/// The matrix with every row divided by its sum.
fn stochastic(weights: &SparseMatrix) -> Result<SparseMatrix, Failure> {
    let sums = weights.row_sums();
    if let Some(vertex) = sums.iter().position(Zero::is_zero) {
        let why = format!("vertex {} has no neighbour, so that its row of D^-1 A does not exist", vertex + 1);
        return Err(refused(why));
    }
    Ok(SparseMatrix::from_entries(weights.order(), weights.entries().map(|(i, j, weight)| (i, j, weight / &sums[i]))))
}

/// An argument between 1 and a most.
fn index(what: &str, argument: Option<&Number>, most: usize) -> Result<usize, Failure> {
    let integer = argument.and_then(Number::as_integer);
    let fitting = integer.as_ref().and_then(ToPrimitive::to_usize).filter(|k| (1..=most).contains(k));
    fitting.ok_or_else(|| {
        let (what, found) = (what.to_string(), argument.map_or("nothing".to_string(), Number::text));
        Failure::Refused(
            0,
            match integer {
                None => Problem::NotInteger { what, found },
                Some(_) => Problem::Range { what, expected: format!("between 1 and {most}"), found },
            },
        )
    })
}

fn largest(reached: &[Option<usize>]) -> Option<usize> {
    reached.iter().copied().try_fold(0, |most, distance| distance.map(|d| most.max(d)))
}

/// A number that is searched for in graphs up to a size.
fn searched(name: &str, number: Option<usize>, most: usize) -> Found {
    let open = || Failure::open(format!("`{name}` is found for graphs of up to {most} vertices"), None);
    number.map_or_else(|| Err(open()), count)
}

fn count(n: usize) -> Found {
    Ok(Measured::Number(Number::integer(n as i64)))
}

fn exact(q: Rational) -> Found {
    Ok(Measured::Number(Number::Exact(q)))
}

fn truth(value: bool) -> Found {
    Ok(Measured::Truth(value))
}

/// A number that does not always exist.
fn known(number: Option<usize>, what: &str) -> Found {
    number.map_or_else(|| Err(refused(format!("{what} does not exist"))), count)
}

fn known_exact(number: Option<Rational>, what: &str) -> Found {
    number.map_or_else(|| Err(refused(format!("{what} does not exist"))), exact)
}

fn refused(message: String) -> Failure {
    Failure::Refused(0, Problem::Other(message))
}

/// The graphs with one link more, or less.
pub(crate) fn changed_by_one_link(graph: &Graph, more: bool) -> Vec<Graph> {
    let order = graph.order();
    let pairs = (0..order).flat_map(|j| (0..j).map(move |i| (i, j)));
    let toggled = |(i, j): (usize, usize)| {
        Graph::from_fn(order, |a, b| if (a, b) == (i, j) { more } else { graph.has_edge(a, b) })
    };
    pairs.filter(|&(i, j)| graph.has_edge(i, j) != more).map(toggled).collect()
}
