//! Symmetric patterns: `M` clusters of equal size, evenly spaced around the circle.

use super::moments::powers;
use arithmetic::{Complex, CosineField, RealCyclotomic, Ring};

/// The phasors of the `(M, N)`-pattern with clusters at the multiples of `1/M` of a turn: particle `k` is in cluster `k`
/// modulo `M`. `None` where `M` does not divide `N`.
pub fn symmetric_pattern(clusters: u32, particles: u32) -> Option<Vec<Complex<RealCyclotomic>>> {
    let divides = clusters > 0 && particles.is_multiple_of(clusters);
    let field = CosineField::new(clusters.max(1));
    divides.then(|| (0..particles).map(|k| field.phasor(i64::from(k))).collect())
}

/// The number `M` of clusters where the phasors form a symmetric pattern, otherwise `None`.
///
/// `M` different phasors with the same `M`-th power are all the `M`-th roots of it, and those are evenly spaced.
pub fn clusters_of_pattern<T: Ring + PartialEq>(phasors: &[Complex<T>]) -> Option<u32> {
    let mut clusters: Vec<(&Complex<T>, usize)> = Vec::new();
    for z in phasors {
        match clusters.iter_mut().find(|(known, _)| *known == z) {
            Some((_, size)) => *size += 1,
            None => clusters.push((z, 1)),
        }
    }
    let (first, size) = clusters.first().copied()?;
    let count = clusters.len() as u32;
    let centres: Vec<Complex<T>> = clusters.iter().map(|(z, _)| (*z).clone()).collect();
    let common = first.power(u64::from(count));
    let even = clusters.iter().all(|&(_, other)| other == size) && powers(&centres, count).iter().all(|z| *z == common);
    even.then_some(count)
}
