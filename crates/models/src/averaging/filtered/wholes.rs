//! The connected parts of a network, and certified bounds of where each of them goes while the network stays.
//!
//! The steps of the argument are those of `notes/exact_flocks.md`.

use super::links::Links;
use crate::averaging::Weights;
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
    /// No bird ever strays farther than twice this from a straight way at the mean velocity.
    pub stray: f64,
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
pub(super) fn wholes<D>(links: &Links, weights: &Weights, velocities: &Velocities<D>) -> Vec<Whole>
where
    D: Fn(usize, usize, usize) -> f64,
{
    let (component_of, components) = links.components();
    let mut members = vec![Vec::new(); components];
    for (i, &component) in component_of.iter().enumerate() {
        members[component].push(i);
    }
    members.into_iter().map(|members| whole(links, weights, velocities, members)).collect()
}

fn whole<D>(links: &Links, weights: &Weights, velocities: &Velocities<D>, members: Vec<usize>) -> Whole
where
    D: Fn(usize, usize, usize) -> f64,
{
    let dimension = velocities.dimension;
    let velocity_error = velocities.error * (dimension as f64).sqrt() * 2.0;
    if members.len() == 1 {
        let mean = vec![0.0; dimension];
        return Whole { members, mean, mean_error: velocity_error, range: 0.0, stray: 0.0 };
    }
    let reciprocal = |&i: &usize| {
        let c = weights.of(links.degree(i), i).and_then(|c| c.to_f64()).unwrap_or(f64::NAN);
        1.0 / c
    };
    let reciprocals: Vec<f64> = members.iter().map(reciprocal).collect();
    let total: f64 = reciprocals.iter().sum();
    let first = members[0];
    let (mut mean, mut largest) = (vec![0.0; dimension], 0.0f64);
    let mut difference = vec![0.0; dimension];
    for (&i, r) in members.iter().zip(&reciprocals) {
        for k in 0..dimension {
            difference[k] = (velocities.difference)(i, first, k);
            mean[k] += difference[k] * (r / total);
        }
        largest = largest.max(norm(&difference));
    }
    // Step 5: no velocity is farther from the first one than this, the mean neither.
    let range = 2.0 * largest * (1.0 + SLACK) + 2.0 * velocity_error;
    let paths = longest_path(links, &members) as f64;
    let stray = range * paths * total * total.sqrt() * 0.5 * (1.0 + SLACK);
    let mean_error = velocity_error + SLACK * largest;
    Whole { members, mean, mean_error, range, stray }
}

/// At least the length of the longest shortest path: twice the distance of the farthest from the first.
fn longest_path(links: &Links, members: &[usize]) -> usize {
    let mut seen = vec![false; links.order()];
    let (mut layer, mut depth) = (vec![members[0]], 0);
    seen[members[0]] = true;
    loop {
        let mut next = Vec::new();
        for &i in &layer {
            for &j in links.near(i) {
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
