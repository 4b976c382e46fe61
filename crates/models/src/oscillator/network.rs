//! Who is a neighbour of whom: the Laplacian of an interaction network as an operator, fixed or made from positions.

use algebra::graph::Graph;
use algebra::matrix::SparseMatrix;
use arithmetic::{Complex, Field, Ring, Sign, Signed};
use std::cmp::Ordering;

/// A network that has a Laplacian `L = D - A`, where `a_kj = 1` if `j` is a neighbour of `k`.
pub trait Interaction {
    /// `L_k x` for every particle `k`; `x` has an entry for each particle, and particles without one are left out.
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>>;
}

/// `L_k x` for every row `k`; entries of `x` without a row, and of rows without an entry of `x`, are left out.
pub fn laplacian_rows<T: Field>(laplacian: &SparseMatrix, x: &[Complex<T>]) -> Vec<Complex<T>> {
    let row = |(k, own): (usize, &Complex<T>)| {
        let there = laplacian.row(k).iter().filter_map(|(j, entry)| Some((x.get(*j)?, entry)));
        there.fold(own.zero(), |sum, (other, entry)| sum + other.scale(&own.re.rational(entry)))
    };
    x.iter().enumerate().take(laplacian.order()).map(row).collect()
}

impl Interaction for SparseMatrix {
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>> {
        laplacian_rows(self, x)
    }
}

/// All-to-all interaction, whose Laplacian costs O(N): `L_k x = N x_k - sum_j x_j`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Everyone;

impl Interaction for Everyone {
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>> {
        let Some(first) = x.first() else { return Vec::new() };
        let sum = x.iter().fold(first.zero(), |sum, x| sum + x);
        let count = first.re.integer(x.len() as i64);
        x.iter().map(|x| x.scale(&count) - &sum).collect()
    }
}

/// The neighbours `N_k` of each particle, numbered from 0: the unweighted digraph of a network.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Neighbours {
    /// All lists, one after the other, and where each begins; the last one ends where the next would begin.
    all: Vec<usize>,
    starts: Vec<usize>,
}

impl Neighbours {
    /// `j` is a neighbour of `k` where `senses(k, j)`; never of itself.
    pub fn from_fn(particles: usize, senses: impl Fn(usize, usize) -> bool) -> Self {
        let list = |k: usize| (0..particles).filter(|&j| j != k && senses(k, j)).collect();
        Neighbours::from_lists((0..particles).map(list))
    }

    fn from_lists(lists: impl Iterator<Item = Vec<usize>>) -> Self {
        let (mut all, mut starts) = (Vec::new(), vec![0]);
        for list in lists {
            all.extend(list);
            starts.push(all.len());
        }
        Neighbours { all, starts }
    }

    /// The neighbours `j` of `k` for the arcs `(k, j)`, in order; arcs to particles that are not there are left out.
    pub fn from_arcs<I: Iterator<Item = (usize, usize)> + Clone>(
        particles: usize,
        arcs: impl IntoIterator<IntoIter = I>,
    ) -> Self {
        let arcs = arcs.into_iter().filter(|&(k, j)| k != j && k.max(j) < particles);
        // Counting sort: no list has memory of its own.
        let mut starts = vec![0; particles + 1];
        arcs.clone().for_each(|(k, _)| starts[k + 1] += 1);
        (0..particles).for_each(|k| starts[k + 1] += starts[k]);
        let (mut all, mut next) = (vec![0; starts[particles]], starts.clone());
        for (k, j) in arcs {
            all[next[k]] = j;
            next[k] += 1;
        }
        // In order, and each once.
        let mut kept = 0;
        for k in 0..particles {
            let list = starts[k]..starts[k + 1];
            starts[k] = kept;
            all[list.clone()].sort_unstable();
            for place in list {
                if kept == starts[k] || all[kept - 1] != all[place] {
                    all[kept] = all[place];
                    kept += 1;
                }
            }
        }
        starts[particles] = kept;
        all.truncate(kept);
        Neighbours { all, starts }
    }

    /// The neighbours in an undirected graph.
    pub fn of(graph: &Graph) -> Self {
        Neighbours::from_fn(graph.order(), |k, j| graph.has_edge(k, j))
    }

    /// All-to-all interaction.
    pub fn complete(particles: usize) -> Self {
        Neighbours::from_fn(particles, |_, _| true)
    }

    /// The one-way ring: everyone senses the next.
    pub fn one_way_ring(particles: usize) -> Self {
        Neighbours::from_fn(particles, |k, j| j == (k + 1) % particles)
    }

    /// The circulant graph: `k` and `j` are neighbours where `k - j` modulo `N` is one of the offsets or its negative; `[1]`
    /// gives the cyclic graph `C_N`. Offsets count modulo `N`; nobody is its own neighbour.
    pub fn circulant(particles: usize, offsets: &[usize]) -> Self {
        let offsets: Vec<usize> = offsets.iter().filter_map(|offset| offset.checked_rem(particles)).collect();
        let joined = |k: usize, j: usize| {
            let difference = (k + particles - j) % particles;
            offsets.iter().any(|&offset| offset == difference || offset == particles - difference)
        };
        Neighbours::from_fn(particles, joined)
    }

    /// Those at distance `radius` or less, `radius` not negative.
    pub fn within<T: Field + Signed>(positions: &[Complex<T>], radius: &T) -> Self {
        let near = |k: usize, j: usize| {
            let distance = (positions[j].clone() - &positions[k]).norm_squared();
            !(distance - radius.square()).is_certainly_positive()
        };
        Neighbours::from_fn(positions.len(), near)
    }

    /// The `count` nearest of each particle; of two at the same distance, the one with the smaller number.
    pub fn nearest<T: Field + Signed>(positions: &[Complex<T>], count: usize) -> Self {
        let list = |k: usize| {
            let distance = |j: usize| (positions[j].clone() - &positions[k]).norm_squared();
            let mut others: Vec<(usize, T)> =
                (0..positions.len()).filter(|&j| j != k).map(|j| (j, distance(j))).collect();
            others.sort_by(|(_, a), (_, b)| match (a.clone() - b).sign() {
                Some(Sign::Negative) => Ordering::Less,
                Some(Sign::Positive) => Ordering::Greater,
                _ => Ordering::Equal,
            });
            let mut nearest: Vec<usize> = others.into_iter().take(count).map(|(j, _)| j).collect();
            nearest.sort_unstable();
            nearest
        };
        Neighbours::from_lists((0..positions.len()).map(list))
    }

    /// As [`Neighbours::nearest`]; `None` where it is not certain who they are, as where two are at the same distance.
    pub fn nearest_without_ties<T: Field + Signed>(positions: &[Complex<T>], count: usize) -> Option<Self> {
        let network = Neighbours::nearest(positions, count);
        let squared = |k: usize, j: usize| (positions[j].clone() - &positions[k]).norm_squared();
        let apart = |k: usize| {
            let near = network.of_particle(k);
            let farther = |far: usize| near.iter().all(|&j| (squared(k, far) - squared(k, j)).is_certainly_positive());
            (0..positions.len()).filter(|j| *j != k && !near.contains(j)).all(farther)
        };
        (0..positions.len()).all(apart).then_some(network)
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.starts.len() - 1
    }

    /// The arcs `(k, j)`, in order.
    pub fn arcs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        (0..self.particles()).flat_map(|k| self.of_particle(k).iter().map(move |&j| (k, j)))
    }

    /// The neighbours of `k`, in order; of a particle that is not there, none.
    pub fn of_particle(&self, k: usize) -> &[usize] {
        self.starts.get(k..k.saturating_add(2)).map_or(&[], |ends| &self.all[ends[0]..ends[1]])
    }
}

impl Interaction for Neighbours {
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>> {
        let row = |(k, own): (usize, &Complex<T>)| {
            let there = self.of_particle(k).iter().filter_map(|&j| x.get(j));
            there.fold(Complex::real(own.re.zero()), |sum, other| sum + own - other)
        };
        x.iter().enumerate().take(self.particles()).map(row).collect()
    }
}
