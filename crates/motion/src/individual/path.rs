//! A piece of the motion of one agent: a power series in time.

use super::law::{Moving, Rates};
use crate::{Jet, shifted, value_at};
use arithmetic::Field;

/// The order: velocities and further states are series up to this power of time, positions one higher.
pub const ORDER: usize = 6;

/// Coefficients of a position.
pub const LENGTH: usize = ORDER + 2;

/// Coefficients of a squared distance.
pub const SQUARE: usize = 2 * LENGTH - 1;

/// Coefficients, lowest power first; those of the velocity follow from those of the position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path<const F: usize> {
    pub place: [[f64; LENGTH]; 2],
    /// The last one is zero.
    pub further: [[f64; LENGTH]; F],
}

impl<const F: usize> Path<F> {
    /// At a point with a velocity, nothing else known.
    pub fn start(at: &Moving<f64, F>) -> Self {
        let mut path = Path { place: [[0.0; LENGTH]; 2], further: [[0.0; LENGTH]; F] };
        path.place.iter_mut().zip(&at.position).for_each(|(to, x)| to[0] = *x);
        path.place.iter_mut().zip(&at.velocity).for_each(|(to, v)| to[1] = *v);
        path.further.iter_mut().zip(&at.further).for_each(|(to, x)| to[0] = *x);
        path
    }

    /// Where it begins.
    pub fn point(&self) -> [f64; 2] {
        self.place.map(|c| c[0])
    }

    /// The same motion from a later time on.
    pub fn after(&self, delay: f64) -> Self {
        Path { place: self.place.map(|c| shifted(&c, delay)), further: self.further.map(|c| shifted(&c, delay)) }
    }

    /// Where the agent is after a time.
    pub fn at(&self, delay: f64) -> Moving<f64, F> {
        let velocity = |c: [f64; LENGTH]| {
            let rates: [f64; LENGTH - 1] = std::array::from_fn(|k| (k + 1) as f64 * c[k + 1]);
            value_at(&rates, delay)
        };
        Moving {
            position: self.place.map(|c| value_at(&c, delay)),
            velocity: self.place.map(velocity),
            further: self.further.map(|c| value_at(&c, delay)),
        }
    }

    /// The first coefficients as series over some scalar.
    #[inline(always)]
    pub fn series<T: Field + Copy, const K: usize>(&self, number: impl Fn(f64) -> T) -> Moving<Jet<T, K>, F> {
        let zero = Jet::constant(number(0.0));
        let mut all = Moving { position: [zero; 2], velocity: [zero; 2], further: [zero; F] };
        for k in 0..K {
            for c in 0..2 {
                all.position[c].0[k] = number(self.place[c][k]);
                all.velocity[c].0[k] = number(self.place[c][k + 1] * (k + 1) as f64);
            }
            for c in 0..F {
                all.further[c].0[k] = number(self.further[c][k]);
            }
        }
        all
    }

    /// The coefficients `m` of velocity and further states, the rates of change being known.
    pub fn set<const K: usize>(&mut self, m: usize, rates: &Rates<Jet<f64, K>, F>) {
        for (to, rate) in self.place.iter_mut().zip(&rates.velocity) {
            to[m + 1] = rate.0[m - 1] / (m * (m + 1)) as f64;
        }
        for (to, rate) in self.further.iter_mut().zip(&rates.further) {
            to[m] = rate.0[m - 1] / m as f64;
        }
    }

    /// The size of a coefficient of the position.
    pub fn size(&self, k: usize) -> f64 {
        (self.place[0][k] * self.place[0][k] + self.place[1][k] * self.place[1][k]).sqrt()
    }

    /// How far the agent can get in a time.
    pub fn reach(&self, length: f64) -> f64 {
        (1..LENGTH).rev().fold(0.0, |sum, k| (sum + self.size(k)) * length)
    }

    /// `|r_ij|²` as a polynomial.
    pub fn squared_distance(&self, other: &Self) -> [f64; SQUARE] {
        let mut all = [0.0; SQUARE];
        for c in [0, 1] {
            let r: [f64; LENGTH] = std::array::from_fn(|k| self.place[c][k] - other.place[c][k]);
            for (i, a) in r.iter().enumerate() {
                all[i..].iter_mut().zip(&r).for_each(|(to, b)| *to += a * b);
            }
        }
        all
    }
}
