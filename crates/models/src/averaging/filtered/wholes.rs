//! The connected parts of a network, and certified bounds of where each of them goes while the network stays.
//!
//! The steps of the argument are those of `notes/exact_flocks.md`.

use crate::averaging::weights::Weights;
use algebra::graph::Graph;
use algebra::matrix::SparseLdl;
use num_traits::ToPrimitive;

/// Relative rounding, generously.
pub(super) const SLACK: f64 = 1e-12;

/// A connected part of the network and where it goes.
pub(super) struct Whole {
    pub members: Vec<usize>,
    /// The stationary mean of the velocities less the velocity of the first member, by coordinate.
    pub mean: Vec<f64>,
    pub mean_error: f64,
    /// No velocity is farther from the mean than this, ever.
    pub range: f64,
    /// About what `Gamma u` is, by member and coordinate, up to a constant, about the mean: what is left of the way to where the bird tends to.
    pub rest: Vec<f64>,
    /// The true one differs from it, but for a constant, by no more than this.
    pub rest_error: f64,
    /// No bird is ever farther than this from where it tends to, nor is any difference of two.
    pub stray: f64,
    /// The part by itself, where there is more than one.
    pub part: Part,
}

/// The length of a vector.
pub(super) fn norm(x: &[f64]) -> f64 {
    x.iter().map(|a| a * a).sum::<f64>().sqrt()
}

/// The velocities of a flock in so many dimensions, each coordinate known up to an error.
pub(super) struct Velocities<D> {
    pub dimension: usize,
    pub error: f64,
    /// Coordinate `k` of `v_i - v_j`, given `(i, j, k)`.
    pub difference: D,
}

/// The connected parts of a network.
pub(super) fn wholes<D>(network: &Graph, weights: &Weights, velocities: &Velocities<D>) -> Vec<Whole>
where
    D: Fn(usize, usize, usize) -> f64,
{
    let (component_of, components) = network.component_numbers();
    let mut members = vec![Vec::new(); components];
    for (i, &component) in component_of.iter().enumerate() {
        members[component as usize].push(i);
    }
    members.into_iter().map(|members| whole(network, weights, velocities, members)).collect()
}

fn whole<D>(network: &Graph, weights: &Weights, velocities: &Velocities<D>, members: Vec<usize>) -> Whole
where
    D: Fn(usize, usize, usize) -> f64,
{
    let dimension = velocities.dimension;
    let velocity_error = velocities.error * (dimension as f64).sqrt() * 2.0;
    if members.len() == 1 {
        let mean = vec![0.0; dimension];
        let rest = mean.clone();
        return Whole {
            members,
            mean,
            mean_error: velocity_error,
            range: 0.0,
            rest,
            rest_error: 0.0,
            stray: 0.0,
            part: Part::default(),
        };
    }
    let reciprocal = |&i: &usize| {
        let c = weights.of(network.degree(i), i).and_then(|c| c.to_f64()).unwrap_or(f64::NAN);
        1.0 / c
    };
    let reciprocals: Vec<f64> = members.iter().map(reciprocal).collect();
    let total: f64 = reciprocals.iter().sum();
    let first = members[0];
    // Rounding of sums over all members.
    let slack = SLACK + 4.0 * f64::EPSILON * members.len() as f64;
    let (mut mean, mut largest) = (vec![0.0; dimension], 0.0f64);
    let mut rates = vec![0.0; members.len() * dimension];
    for ((&i, r), difference) in members.iter().zip(&reciprocals).zip(rates.chunks_mut(dimension)) {
        for k in 0..dimension {
            difference[k] = (velocities.difference)(i, first, k);
            mean[k] += difference[k] * (r / total);
        }
        largest = largest.max(norm(difference));
    }
    for rate in rates.chunks_mut(dimension) {
        rate.iter_mut().zip(&mean).for_each(|(v, mean)| *v -= mean);
    }
    // Step 5: no velocity is farther from the first one than this, the mean neither.
    let range = 2.0 * largest * (1.0 + SLACK) + 2.0 * velocity_error;
    let mean_error = velocity_error + slack * largest;
    // Steps 11 and 12: `Gamma u` is at most so many times the largest `u`.
    let slowness = longest_path(network, &members) as f64 * total * total.sqrt() * 0.5 * (1.0 + 2.0 * slack);
    let own = Part::new(network, &members, reciprocals);
    let (rest, left) = match own.rest(&rates, dimension) {
        Some(rest) => {
            let left = own.residual(&rates, &rest, dimension) + 2.0 * velocity_error;
            (rest, left)
        }
        None => (vec![0.0; rates.len()], range),
    };
    let rest_error = slowness * left.min(range);
    let rest = if left < range { rest } else { vec![0.0; rates.len()] };
    let stray = diameter(&rest, dimension) * (1.0 + SLACK) + 2.0 * rest_error;
    Whole { members, mean, mean_error, range, rest, rest_error, stray, part: own }
}

/// The length of the diagonal of the box around vectors.
pub(super) fn diameter(vectors: &[f64], dimension: usize) -> f64 {
    let width = |k: usize| {
        let coordinate = || vectors.iter().skip(k).step_by(dimension);
        coordinate().fold(f64::NEG_INFINITY, |a, &x| a.max(x)) - coordinate().fold(f64::INFINITY, |a, &x| a.min(x))
    };
    norm(&(0..dimension).map(width).collect::<Vec<_>>())
}

/// A connected part of a network with numbers of its own.
#[derive(Default)]
pub(super) struct Part {
    /// The neighbours of each member.
    pub near: Vec<Vec<u32>>,
    /// `1/c_i`.
    pub reciprocals: Vec<f64>,
}

/// Products for each member up to which the equations of a part are solved.
const PRODUCTS: usize = 4000;

impl Part {
    fn new(network: &Graph, members: &[usize], reciprocals: Vec<f64>) -> Self {
        // The members are sorted, as the neighbours are.
        let place = |j: &u32| members.binary_search(&(*j as usize)).ok().map(|place| place as u32);
        let near = members.iter().map(|&i| network.neighbours(i).iter().filter_map(place).collect()).collect();
        Part { near, reciprocals }
    }

    /// About the solution `y` of `(I - P) y = u`, that is of `L y = C^-1 u`, about their mean; none where that takes too long.
    fn rest(&self, rates: &[f64], dimension: usize) -> Option<Vec<f64>> {
        // Without the row and column of the first member.
        let row = |near: &Vec<u32>| near.iter().filter(|&&j| j > 0).map(|&j| (j - 1, -1.0)).collect();
        let diagonal = self.near[1..].iter().map(|near| near.len() as f64).collect();
        let factored = SparseLdl::new(diagonal, self.near[1..].iter().map(row).collect(), PRODUCTS * self.near.len())?;
        let mut rest = vec![0.0; rates.len()];
        for k in 0..dimension {
            let mut side: Vec<f64> = self
                .reciprocals
                .iter()
                .zip(rates.iter().skip(k).step_by(dimension))
                .map(|(r, u)| r * u)
                .skip(1)
                .collect();
            factored.solve(&mut side)?;
            // About the mean, so that little is left of it in the end.
            let total: f64 = self.reciprocals.iter().sum();
            let mean = side.iter().zip(&self.reciprocals[1..]).map(|(y, r)| y * r).sum::<f64>() / total;
            rest.iter_mut()
                .skip(k)
                .step_by(dimension)
                .zip([0.0].into_iter().chain(side))
                .for_each(|(y, x)| *y = x - mean);
        }
        rest.iter().all(|y| y.is_finite()).then_some(rest)
    }

    /// At least the largest `|u - (I - P) y|`, whatever constant `u` is off by: the stationary mean of the true one is zero.
    fn residual(&self, rates: &[f64], rest: &[f64], dimension: usize) -> f64 {
        let (mut largest, mut off) = (0.0f64, Vec::with_capacity(rates.len()));
        for (i, (u, own)) in rates.chunks(dimension).zip(rest.chunks(dimension)).enumerate() {
            let mut squared = 0.0;
            let count = self.near[i].len() as f64;
            for k in 0..dimension {
                let (mut pull, mut size) = (0.0, 0.0);
                for &j in &self.near[i] {
                    let other = rest[j as usize * dimension + k];
                    pull += own[k] - other;
                    size += own[k].abs() + other.abs();
                }
                // Each of the operations errs by half an ulp of what is summed up.
                let rounding = f64::EPSILON * (count + 8.0) * (u[k].abs() + size / self.reciprocals[i]);
                squared += rounding * rounding;
                off.push(u[k] - pull / self.reciprocals[i]);
            }
            largest = largest.max(squared.sqrt());
        }
        (diameter(&off, dimension) + 2.0 * largest) * (1.0 + SLACK)
    }
}

/// At least the length of the longest shortest path: twice the distance of the farthest from the first.
fn longest_path(network: &Graph, members: &[usize]) -> usize {
    let mut seen = vec![false; network.order()];
    let (mut layer, mut depth) = (vec![members[0]], 0);
    seen[members[0]] = true;
    loop {
        let mut next = Vec::new();
        for &i in &layer {
            for &j in network.neighbours(i) {
                if !std::mem::replace(&mut seen[j as usize], true) {
                    next.push(j as usize);
                }
            }
        }
        if next.is_empty() {
            return (2 * depth).min(members.len() - 1);
        }
        depth += 1;
        layer = next;
    }
}

#[cfg(test)]
mod tests;
