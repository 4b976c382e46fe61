//! A piece of the motion of one agent: a power series in time.

use super::super::{Coordinates, Slope, Vector, pull, sum};
use arithmetic::ArithmeticError;
use motion::{Jet, Lanes, shifted, value_at};
use pulp::Simd;

const PLANE: Coordinates = Coordinates::Cartesian;

/// The order: velocities are series up to this power of time, positions one higher.
pub const ORDER: usize = 6;

/// Coefficients of a position.
pub const LENGTH: usize = ORDER + 2;

/// Coefficients of a squared distance.
pub const SQUARE: usize = 2 * LENGTH - 1;

/// No processor has more lanes.
const MOST_LANES: usize = 16;

/// The coefficients of the position, lowest power first; those of the velocity follow from them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path(pub [[f64; LENGTH]; 2]);

impl Path {
    /// At a point with a velocity, nothing else known.
    pub fn start(position: Vector<f64>, velocity: Vector<f64>) -> Self {
        Path([0, 1].map(|c| {
            let mut all = [0.0; LENGTH];
            (all[0], all[1]) = (position[c], velocity[c]);
            all
        }))
    }

    /// The same motion from a later time on.
    pub fn after(&self, delay: f64) -> Self {
        Path([shifted(&self.0[0], delay), shifted(&self.0[1], delay)])
    }

    /// Position and velocity after a time.
    pub fn at(&self, delay: f64) -> (Vector<f64>, Vector<f64>) {
        let velocity = |c: &[f64; LENGTH]| {
            let rates: [f64; LENGTH - 1] = std::array::from_fn(|k| (k + 1) as f64 * c[k + 1]);
            value_at(&rates, delay)
        };
        ([0, 1].map(|c| value_at(&self.0[c], delay)), [0, 1].map(|c| velocity(&self.0[c])))
    }

    /// The size of a coefficient of the position.
    pub fn size(&self, k: usize) -> f64 {
        (self.0[0][k] * self.0[0][k] + self.0[1][k] * self.0[1][k]).sqrt()
    }

    /// The coefficient `m` of the velocity, the rate of change being known.
    pub fn set_velocity(&mut self, m: usize, acceleration: [f64; 2]) {
        for c in [0, 1] {
            self.0[c][m + 1] = acceleration[c] / (m * (m + 1)) as f64;
        }
    }

    /// How far the agent can get in a time.
    pub fn reach(&self, length: f64) -> f64 {
        (1..LENGTH).rev().fold(0.0, |sum, k| (sum + self.size(k)) * length)
    }

    /// `|r_ij|²` as a polynomial.
    pub fn squared_distance(&self, other: &Path) -> [f64; SQUARE] {
        let mut all = [0.0; SQUARE];
        for c in [0, 1] {
            let r: [f64; LENGTH] = std::array::from_fn(|k| self.0[c][k] - other.0[c][k]);
            for (i, a) in r.iter().enumerate() {
                all[i..].iter_mut().zip(&r).for_each(|(to, b)| *to += a * b);
            }
        }
        all
    }
}

/// The acceleration of an agent by velocity alignment, equation (4) of the second paper, as a series in time: the law over jets, with as many
/// neighbours at a time as a vector of the processor has lanes. What they add comes in their order, whatever the number of lanes.
pub struct Acceleration<'a, const K: usize> {
    pub own: &'a Path,
    pub neighbours: &'a [usize],
    /// Where the series of an agent is.
    pub path: &'a dyn Fn(usize) -> &'a Path,
    pub slope: &'a Slope<f64>,
}

impl<const K: usize> pulp::WithSimd for Acceleration<'_, K> {
    type Output = Result<[[f64; K]; 2], ArithmeticError>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let splat = |x: f64| Lanes::splat(simd, x);
        let slope = self.slope.map(|&c| Jet::<_, K>::constant(splat(c)));
        let mut total = [[0.0; K]; 2];
        let mut lanes = [0.0; MOST_LANES];
        for some in self.neighbours.chunks(Lanes::<S>::WIDTH) {
            // A lane too many holds the first one again.
            let mut others = [self.own; MOST_LANES];
            others.fill((self.path)(some[0]));
            others.iter_mut().zip(some).for_each(|(to, &agent)| *to = (self.path)(agent));
            let (mut separation, mut relative) = ([Jet([splat(0.0); K]); 2], [Jet([splat(0.0); K]); 2]);
            for c in 0..2 {
                for k in 0..=K {
                    let theirs = Lanes::load(simd, &others.map(|path| path.0[c][k]));
                    let apart = splat(self.own.0[c][k]) - theirs;
                    if k < K {
                        separation[c].0[k] = apart;
                    }
                    if k > 0 {
                        relative[c].0[k - 1] = apart * splat(k as f64);
                    }
                }
            }
            let slope = slope.at(&PLANE.square(&separation))?;
            let force = sum(&relative, &pull(&separation, slope));
            for (total, force) in total.iter_mut().zip(&force) {
                for (total, part) in total.iter_mut().zip(&force.0) {
                    part.store(&mut lanes);
                    lanes.iter().take(some.len()).for_each(|part| *total -= part);
                }
            }
        }
        Ok(total)
    }
}
