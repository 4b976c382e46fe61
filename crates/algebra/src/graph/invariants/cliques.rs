//! Cliques, independent sets and colourings, by search.

use crate::graph::Graph;
use arithmetic::{Cancelled, Progress};

/// Largest order of a graph whose cliques, colourings and automorphisms are searched: its vertices are bits of a word.
pub const LARGEST_SEARCHED: usize = 64;

/// The vertices of a set of bits.
pub(super) fn members(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let first = (set != 0).then(|| set.trailing_zeros() as usize)?;
        set &= set - 1;
        Some(first)
    })
}

/// All of so many vertices, at most 64.
fn all(order: usize) -> u64 {
    if order == 0 { 0 } else { u64::MAX >> (64 - order) }
}

impl Graph {
    /// The neighbours as sets of bits; `None` above [`LARGEST_SEARCHED`] vertices.
    pub(super) fn rows(&self) -> Option<Vec<u64>> {
        let row = |list: &Vec<u32>| list.iter().map(|&j| 1u64 << j).sum();
        (self.order() <= LARGEST_SEARCHED).then(|| self.near.iter().map(row).collect())
    }

    /// Number of vertices of a largest clique; `None` above [`LARGEST_SEARCHED`] vertices.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn clique_number(&self, progress: &dyn Progress) -> Result<Option<usize>, Cancelled> {
        self.rows().map(|near| largest_clique(&near, progress)).transpose()
    }

    /// Largest number of vertices of which no two are joined; `None` above [`LARGEST_SEARCHED`] vertices.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn independence_number(&self, progress: &dyn Progress) -> Result<Option<usize>, Cancelled> {
        let Some(near) = self.rows() else { return Ok(None) };
        let other = |(i, row): (usize, &u64)| !row & all(near.len()) & !(1 << i);
        let apart: Vec<u64> = near.iter().enumerate().map(other).collect();
        largest_clique(&apart, progress).map(Some)
    }

    /// Least number of colours such that joined vertices have different ones; `None` above [`LARGEST_SEARCHED`] vertices.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn chromatic_number(&self, progress: &dyn Progress) -> Result<Option<usize>, Cancelled> {
        let Some(near) = self.rows() else { return Ok(None) };
        let mut colours = largest_clique(&near, progress)?;
        while !is_coloured(&near, &mut Vec::new(), all(near.len()), colours, progress)? {
            colours += 1;
        }
        Ok(Some(colours))
    }
}

/// Branch and bound: a set of vertices that can be coloured with `c` colours has no clique above `c`.
fn largest_clique(near: &[u64], progress: &dyn Progress) -> Result<usize, Cancelled> {
    fn extend(
        near: &[u64],
        mut candidates: u64,
        size: usize,
        best: &mut usize,
        progress: &dyn Progress,
    ) -> Result<(), Cancelled> {
        progress.checkpoint()?;
        *best = (*best).max(size);
        // Greedy colours, in which later vertices have at least those of earlier ones.
        let (mut order, mut left, mut colour) = (Vec::new(), candidates, 0);
        while left != 0 {
            colour += 1;
            let mut free = left;
            while free != 0 {
                let v = free.trailing_zeros() as usize;
                free &= !(1 << v) & !near[v];
                left &= !(1 << v);
                order.push((v, colour));
            }
        }
        for &(v, bound) in order.iter().rev() {
            if size + bound <= *best {
                return Ok(());
            }
            extend(near, candidates & near[v], size + 1, best, progress)?;
            candidates &= !(1 << v);
        }
        Ok(())
    }
    let mut best = 0;
    extend(near, all(near.len()), 0, &mut best, progress)?;
    Ok(best)
}

/// Whether the vertices that are left can be coloured with so many colours in all; `classes` are the sets coloured so far.
fn is_coloured(
    near: &[u64],
    classes: &mut Vec<u64>,
    left: u64,
    colours: usize,
    progress: &dyn Progress,
) -> Result<bool, Cancelled> {
    progress.checkpoint()?;
    // The vertex that sees most colours comes next, then the one with most neighbours left.
    let seen = |v: usize| classes.iter().filter(|class| *class & near[v] != 0).count();
    let Some(v) = members(left).max_by_key(|&v| (seen(v), (near[v] & left).count_ones())) else { return Ok(true) };
    for k in 0..classes.len() {
        if classes[k] & near[v] == 0 {
            classes[k] |= 1 << v;
            if is_coloured(near, classes, left & !(1 << v), colours, progress)? {
                return Ok(true);
            }
            classes[k] &= !(1 << v);
        }
    }
    // All colours that are not used yet are alike.
    if classes.len() < colours {
        classes.push(1 << v);
        if is_coloured(near, classes, left & !(1 << v), colours, progress)? {
            return Ok(true);
        }
        classes.pop();
    }
    Ok(false)
}
