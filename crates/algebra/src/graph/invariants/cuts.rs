//! The best cuts of a graph, by looking at all of them.

use crate::graph::Graph;
use arithmetic::{Cancelled, Progress, Rational, rational};

/// Largest order of a graph all of whose cuts are looked at.
pub const LARGEST_CUT: usize = 24;

impl Graph {
    /// The least of `|cut(S)| / min(vol S, vol S')` over all sets `S` that leave volume on both sides, `vol` being a sum of degrees: Cheeger's constant
    /// (Chung, Spectral Graph Theory, section 2.2). `None` where no cut has volume on both sides, and above [`LARGEST_CUT`] vertices.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn cheeger_constant(&self, progress: &dyn Progress) -> Result<Option<Rational>, Cancelled> {
        self.least_cut(|i| self.degree(i), progress)
    }

    /// The least of `|cut(S)| / |S|` over all sets `S` of at least one and at most half of the vertices: the isoperimetric number (Mohar 1989). `None` of
    /// a single vertex, and above [`LARGEST_CUT`] vertices.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn isoperimetric_number(&self, progress: &dyn Progress) -> Result<Option<Rational>, Cancelled> {
        self.least_cut(|_| 1, progress)
    }

    /// The least quotient of a cut and the smaller weight of its two sides.
    fn least_cut(
        &self,
        weight: impl Fn(usize) -> usize,
        progress: &dyn Progress,
    ) -> Result<Option<Rational>, Cancelled> {
        let order = self.order();
        if order > LARGEST_CUT {
            return Ok(None);
        }
        let total: usize = (0..order).map(&weight).sum();
        // Sets without the last vertex, each from the one before by one vertex: Gray's code.
        let (mut inside, mut cut, mut own) = (0u64, 0usize, 0usize);
        let mut least: Option<(usize, usize)> = None;
        for step in 1..1u64 << order.saturating_sub(1) {
            if step.is_multiple_of(1 << 12) {
                progress.checkpoint()?;
            }
            let v = step.trailing_zeros() as usize;
            let common = self.neighbours(v).iter().filter(|&&j| inside >> j & 1 == 1).count();
            let other = self.degree(v) - common;
            inside ^= 1 << v;
            (cut, own) = if inside >> v & 1 == 1 {
                (cut + other - common, own + weight(v))
            } else {
                (cut + common - other, own - weight(v))
            };
            let smaller = own.min(total - own);
            if smaller > 0 && least.is_none_or(|(c, s)| cut * s < c * smaller) {
                least = Some((cut, smaller));
            }
        }
        Ok(least.map(|(cut, size)| rational(cut as i64, size as i64)))
    }
}
