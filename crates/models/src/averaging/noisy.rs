//! The model of Vicsek, Czirok, Ben-Jacob, Cohen and Shochet (Phys. Rev. Lett. 75, 1226, 1995), in floating point: birds of equal speed in a
//! periodic square take the mean heading of all birds within a radius, themselves included, with noise.

use motion::{CellError, CellList};
use rand_chacha::ChaCha8Rng;

/// Why birds do not move.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NoisyError {
    /// Not as many headings as positions.
    #[error("there are {birds} positions but {found} headings")]
    Headings {
        /// Number of positions.
        birds: usize,
        /// Number of headings.
        found: usize,
    },
    /// Places that are not finite, or a radius that is not positive.
    #[error(transparent)]
    Cells(#[from] CellError),
}

/// Birds in a periodic square.
#[derive(Debug, Clone)]
pub struct NoisyFlock {
    /// Places, each coordinate in `[0, side)`.
    pub positions: Vec<[f64; 2]>,
    /// Headings in radians, in `(-pi, pi]` plus noise.
    pub headings: Vec<f64>,
    /// Side of the square.
    pub side: f64,
    /// Birds at a distance below this are neighbours; at most half the side.
    pub radius: f64,
    /// Distance that every bird flies in a step.
    pub speed: f64,
    /// Noise is uniform in `[-noise/2, noise/2]`, in radians.
    pub noise: f64,
}

impl NoisyFlock {
    /// A coordinate within the square.
    pub fn wrapped(&self, x: f64) -> f64 {
        let inside = x.rem_euclid(self.side);
        // Just below zero the remainder is rounded to the side.
        if inside < self.side { inside } else { 0.0 }
    }

    /// Copies of the birds near the border, beyond the other side, behind the birds themselves; and whose copies they are.
    fn with_copies(&self) -> (Vec<[f64; 2]>, Vec<usize>) {
        let (mut points, mut whose) = (self.positions.clone(), (0..self.positions.len()).collect::<Vec<_>>());
        for axis in 0..2 {
            for k in 0..points.len() {
                let shift = match points[k][axis] {
                    x if x < self.radius => self.side,
                    x if x >= self.side - self.radius => -self.side,
                    _ => continue,
                };
                let mut copy = points[k];
                copy[axis] += shift;
                points.push(copy);
                whose.push(whose[k]);
            }
        }
        (points, whose)
    }

    /// The pairs of neighbours, each once, the smaller number first.
    ///
    /// # Errors
    /// [`CellError`] for places that are not finite.
    pub fn links(&self) -> Result<Vec<(usize, usize)>, CellError> {
        let (points, whose) = self.with_copies();
        let pairs = CellList::new(&points, self.radius)?.pairs();
        let ends = |(i, j): (usize, usize)| (whose[i].min(whose[j]), whose[i].max(whose[j]));
        let mut links: Vec<(usize, usize)> = pairs.into_iter().map(ends).filter(|(i, j)| i != j).collect();
        links.sort_unstable();
        links.dedup();
        Ok(links)
    }

    /// One step: `r(t + 1) = r(t) + speed (cos theta(t), sin theta(t))`, and `theta(t + 1)` is the heading of the mean of the neighbours'
    /// unit velocities at `t`, plus noise.
    ///
    /// # Errors
    /// [`NoisyError`].
    pub fn step(&mut self, random: &mut ChaCha8Rng) -> Result<(), NoisyError> {
        let (birds, found) = (self.positions.len(), self.headings.len());
        if birds != found {
            return Err(NoisyError::Headings { birds, found });
        }
        let (points, whose) = self.with_copies();
        let units: Vec<[f64; 2]> = self.headings.iter().map(|theta| [theta.cos(), theta.sin()]).collect();
        let add = |sum: [f64; 2], _: usize, j: usize, _: [f64; 2], _: f64| {
            let unit = units[whose[j]];
            [sum[0] + unit[0], sum[1] + unit[1]]
        };
        let sums = CellList::new(&points, self.radius)?.fold_neighbours(self.positions.len(), [0.0, 0.0], add);
        for (k, own) in units.iter().enumerate() {
            let [x, y] = self.positions[k];
            self.positions[k] = [self.wrapped(x + self.speed * own[0]), self.wrapped(y + self.speed * own[1])];
            let mean = (sums[k][1] + own[1]).atan2(sums[k][0] + own[0]);
            self.headings[k] = mean + self.noise * (arithmetic::random::uniform(random) - 0.5);
        }
        Ok(())
    }
}
