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
                // Without a branch, which would be guessed wrongly too often.
                *sensed = (k != j) & senses(k, j);
            }
        }
        Sensed { particles, table }
    }

    /// Those of these arcs for which `senses(k, j)`.
    #[inline]
    pub fn among(&self, senses: impl Fn(usize, usize) -> bool) -> Self {
        let mut among = self.clone();
        for (k, row) in among.table.chunks_mut(self.particles.max(1)).enumerate() {
            row.iter_mut().enumerate().for_each(|(j, sensed)| *sensed &= senses(k, j));
        }
        among
    }

    /// The arcs `(k, j)`, in order.
    pub fn arcs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let place = |at: usize| (at / self.particles, at % self.particles);
        self.table.iter().enumerate().filter(|(_, sensed)| **sensed).map(move |(at, _)| place(at))
    }
}

impl Interaction for Sensed {
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>> {
        // Every difference is formed and half of them are chosen: that has no branch over floats.
        let row = |(own, sensed): (&Complex<T>, &[bool])| {
            x.iter().zip(sensed).fold(Complex::real(own.re.zero()), |sum, (other, sensed)| {
                let further = sum.clone() + own - other;
                if *sensed { further } else { sum }
            })
        };
        x.iter().zip(self.table.chunks(self.particles.max(1))).map(row).collect()
    }
}
