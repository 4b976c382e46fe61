//! How many renamings of the vertices leave a graph as it is.

use super::distances::distances;
use crate::graph::Graph;
use arithmetic::{Cancelled, Progress};
use num_bigint::BigUint;

impl Graph {
    /// The order of the group of automorphisms: the product of the sizes of the orbits of vertices, each under the automorphisms that fix those before it.
    /// Found by search; for graphs of some dozens of vertices.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn automorphism_count(&self, progress: &dyn Progress) -> Result<BigUint, Cancelled> {
        let order = self.order();
        // What an automorphism keeps: how many vertices there are at each distance.
        let profile = |i: usize| {
            let mut found = distances(self.lists(), i);
            found.sort_unstable();
            found
        };
        let profiles: Vec<_> = (0..order).map(profile).collect();
        let sequence = self.walk();
        let mut count = BigUint::from(1u8);
        for place in 0..order {
            let v = sequence[place];
            let mut orbit = 0u64;
            for w in (0..order).filter(|&w| profiles[w] == profiles[v]) {
                let mut image: Vec<usize> = sequence[..place].to_vec();
                if self.fits(&sequence, &image, w) {
                    image.push(w);
                    orbit += u64::from(self.extends(&sequence, &mut image, &profiles, progress)?);
                }
            }
            count *= orbit;
        }
        Ok(count)
    }

    /// The vertices in an order in which each is joined to an earlier one where that can be.
    fn walk(&self) -> Vec<usize> {
        let mut sequence: Vec<usize> = Vec::with_capacity(self.order());
        let (mut known, mut next) = (vec![false; self.order()], 0);
        for start in 0..self.order() {
            if !known[start] {
                known[start] = true;
                sequence.push(start);
            }
            while let Some(&v) = sequence.get(next) {
                next += 1;
                for j in self.neighbours(v).iter().map(|&j| j as usize) {
                    if !known[j] {
                        known[j] = true;
                        sequence.push(j);
                    }
                }
            }
        }
        sequence
    }

    /// Whether `w` may be the image of the next vertex of the sequence.
    fn fits(&self, sequence: &[usize], image: &[usize], w: usize) -> bool {
        let v = sequence[image.len()];
        let alike = |(&i, &j): (&usize, &usize)| self.has_edge(v, i) == self.has_edge(w, j);
        !image.contains(&w) && sequence.iter().zip(image).all(alike)
    }

    /// Whether a part of an automorphism is part of one.
    fn extends<T: PartialEq>(
        &self,
        sequence: &[usize],
        image: &mut Vec<usize>,
        profiles: &[T],
        progress: &dyn Progress,
    ) -> Result<bool, Cancelled> {
        progress.checkpoint()?;
        let Some(&v) = sequence.get(image.len()) else { return Ok(true) };
        for w in 0..self.order() {
            if profiles[w] == profiles[v] && self.fits(sequence, image, w) {
                image.push(w);
                let found = self.extends(sequence, image, profiles, progress)?;
                image.pop();
                if found {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }
}
