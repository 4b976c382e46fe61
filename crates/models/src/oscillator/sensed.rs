//! Who senses whom, as a table of all pairs: a network that is quick to make anew at every step of a small group.

use super::network::Interaction;
use arithmetic::{Complex, Field};

/// Which of `N` particles, numbered from 0, each one senses; never itself. Memory and the Laplacian cost `N^2`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sensed {
    particles: usize,
    /// Row `k` tells whom `k` senses.
    table: Vec<bool>,
}

impl Sensed {
    /// `k` senses `j` where `senses(k, j)`; never itself.
    #[inline]
    pub fn from_fn(particles: usize, senses: impl Fn(usize, usize) -> bool) -> Self {
        let mut table = vec![false; particles * particles];
        for (k, row) in table.chunks_mut(particles.max(1)).enumerate() {
            for (j, sensed) in row.iter_mut().enumerate() {
                *sensed = k != j && senses(k, j);
            }
        }
        Sensed { particles, table }
    }

    /// Those of these arcs for which `senses(k, j)`.
    #[inline]
    pub fn among(&self, senses: impl Fn(usize, usize) -> bool) -> Self {
        Sensed::from_fn(self.particles, |k, j| self.table[k * self.particles + j] && senses(k, j))
    }

    /// The arcs `(k, j)`, in order.
    pub fn arcs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let place = |at: usize| (at / self.particles, at % self.particles);
        self.table.iter().enumerate().filter(|(_, sensed)| **sensed).map(move |(at, _)| place(at))
    }
}

impl Interaction for Sensed {
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>> {
        let row = |(own, sensed): (&Complex<T>, &[bool])| {
            let others = x.iter().zip(sensed).filter(|(_, sensed)| **sensed);
            others.fold(Complex::real(own.re.zero()), |sum, (other, _)| sum + own - other)
        };
        x.iter().zip(self.table.chunks(self.particles.max(1))).map(row).collect()
    }
}
