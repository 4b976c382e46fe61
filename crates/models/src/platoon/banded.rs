//! The harmonic response of platoons whose cars track near cars only, in floating point: `O(M)` per frequency.

use super::cars::{Platoon, Tracked};
use super::communication_graph::CommunicationGraph;
use super::law::Gains;
use super::response::gamma_minus_one;
use arithmetic::{ArithmeticError, Complex, Field, Rational};
use num_traits::ToPrimitive;

/// The reduced Laplacians of positions and velocities of a platoon, by bands.
#[derive(Debug, Clone)]
pub struct BandedPlatoon {
    /// Entries by row: column, value in the Laplacian of the positions and in that of the velocities.
    rows: Vec<Vec<(usize, [f64; 2])>>,
    /// `-L_l`: the weights of the leader in each row.
    leader: Vec<[f64; 2]>,
    /// How far entries lie below and above the diagonal.
    lower: usize,
    upper: usize,
}

/// A factored band matrix; the pivot rows have up to `lower + upper` entries right of the diagonal.
struct Factors {
    /// Row `i` of `U` from the diagonal on.
    rows: Vec<Vec<Complex<f64>>>,
    /// In elimination order: the row that was swapped to the place, and the multipliers of the rows below.
    steps: Vec<(usize, Vec<Complex<f64>>)>,
}

impl BandedPlatoon {
    /// The bands of a graph.
    pub fn new(graph: &CommunicationGraph) -> Self {
        let float = |weight: &Rational| weight.to_f64().unwrap_or(f64::NAN);
        let row = |k: usize| graph.tracked_by(k).iter().map(|(agent, weight)| (*agent, [float(weight); 2])).collect();
        BandedPlatoon::of_rows((1..=graph.followers()).map(row))
    }

    /// The bands of a platoon.
    pub fn of<T>(platoon: &Platoon<T>) -> Self {
        let float = |weight: &Rational| weight.to_f64().unwrap_or(f64::NAN);
        let entry = |other: Tracked| (other.agent, [float(&other.position), float(&other.velocity)]);
        BandedPlatoon::of_rows(
            (1..=platoon.followers()).map(|k| platoon.tracked_by(k).into_iter().map(entry).collect()),
        )
    }

    /// From whom each follower tracks, with weights.
    fn of_rows(tracked: impl Iterator<Item = Vec<(usize, [f64; 2])>>) -> Self {
        let (mut rows, mut leader) = (Vec::new(), Vec::new());
        let (mut lower, mut upper) = (0, 0);
        for (i, tracked) in tracked.enumerate() {
            let (mut row, mut own, mut first) = (Vec::with_capacity(tracked.len() + 1), [0.0; 2], [0.0; 2]);
            for (agent, weights) in tracked {
                own = [own[0] + weights[0], own[1] + weights[1]];
                match agent.checked_sub(1) {
                    None => first = [first[0] + weights[0], first[1] + weights[1]],
                    Some(j) => {
                        row.push((j, weights.map(|weight| -weight)));
                        lower = lower.max(i.saturating_sub(j));
                        upper = upper.max(j.saturating_sub(i));
                    }
                }
            }
            row.push((i, own));
            rows.push(row);
            leader.push(first);
        }
        BandedPlatoon { rows, leader, lower, upper }
    }

    /// `P + diag(shifts)` factored with partial pivoting; `entry` makes one number of those of positions and velocities in a row.
    fn factored(
        &self,
        entry: impl Fn(usize, &[f64; 2]) -> Complex<f64>,
        shift: impl Fn(usize) -> Complex<f64>,
    ) -> Result<Factors, ArithmeticError> {
        let size = self.rows.len();
        let width = self.lower + self.upper + 1;
        let zero = Complex::real(0.0);
        // Row i holds the columns from `start` on: i - lower at first, the pivot column while it is eliminated.
        let mut rows: Vec<Vec<Complex<f64>>> = self
            .rows
            .iter()
            .enumerate()
            .map(|(i, entries)| {
                let start = i.saturating_sub(self.lower);
                let mut row = vec![zero.clone(); width];
                for (j, values) in entries {
                    row[j - start] = row[j - start].clone() + entry(i, values);
                }
                row[i - start] = row[i - start].clone() + shift(i);
                row
            })
            .collect();
        let mut steps = Vec::with_capacity(size);
        for k in 0..size {
            // All rows that reach column k start there: earlier columns have been eliminated and dropped.
            let end = (k + self.lower + 1).min(size);
            let best = (k..end).max_by(|&a, &b| modulus(&rows[a][0]).total_cmp(&modulus(&rows[b][0])));
            let best = best.unwrap_or(k);
            rows.swap(k, best);
            let inverse = inverse(&rows[k][0])?;
            let (upper, below) = rows.split_at_mut(k + 1);
            let pivot = &upper[k];
            let mut multipliers = Vec::with_capacity(end - k - 1);
            for row in &mut below[..end - k - 1] {
                let factor = row[0].clone() * &inverse;
                for n in 1..width {
                    row[n - 1] = row[n].clone() - factor.clone() * &pivot[n];
                }
                row[width - 1] = zero.clone();
                multipliers.push(factor);
            }
            steps.push((best, multipliers));
        }
        Ok(Factors { rows, steps })
    }

    /// The amplitudes `a_1..a_M` behind the leader `e^{iwt}`, with positions and velocities tracked alike.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where `P + gamma - 1` is singular.
    pub fn response(&self, gains: &Gains<f64>, w: f64) -> Result<Vec<Complex<f64>>, ArithmeticError> {
        let shift = gamma_minus_one(gains, &w)?;
        let leader = self.leader.iter().map(|[weight, _]| Complex::real(*weight)).collect();
        self.factored(of_positions, |_| shift.clone())?.solve(leader)
    }

    /// The same where follower `k` has the gains `gains[k - 1]`, of which there are as many as followers, and perhaps other weights of velocities
    /// than of positions.
    ///
    /// # Errors
    /// As [`BandedPlatoon::response`].
    pub fn response_of_cars(&self, gains: &[Gains<f64>], w: f64) -> Result<Vec<Complex<f64>>, ArithmeticError> {
        if gains.len() != self.rows.len() {
            return Err(ArithmeticError::Domain("gains for each follower"));
        }
        // Each row is divided by f + iwg.
        let entry = |k: usize, [position, velocity]: &[f64; 2]| {
            if position == velocity {
                return Ok(Complex::real(*position));
            }
            let Gains { f, g } = &gains[k];
            Complex::new(f * position, g * w * velocity).over(&Complex::new(*f, g * w))
        };
        let shifts: Vec<Complex<f64>> =
            gains.iter().map(|gains| gamma_minus_one(gains, &w)).collect::<Result<_, _>>()?;
        let leader = self.leader.iter().enumerate().map(|(k, weights)| entry(k, weights)).collect::<Result<_, _>>()?;
        // What divides is not zero, or there was no shift.
        let entry = |k: usize, weights: &[f64; 2]| entry(k, weights).unwrap_or_else(|_| Complex::real(f64::NAN));
        self.factored(entry, |i| shifts[i].clone())?.solve(leader)
    }

    /// The largest amplitude of all followers.
    ///
    /// # Errors
    /// As [`BandedPlatoon::response`].
    pub fn largest_amplitude(&self, gains: &Gains<f64>, w: f64) -> Result<f64, ArithmeticError> {
        let amplitudes = self.response(gains, w)?;
        Ok(amplitudes.iter().map(modulus).fold(0.0, f64::max))
    }

    /// The modulus of the eigenvalue of `P`, for the positions, nearest to 0, by inverse iteration; the steps that it still changed by, relatively,
    /// come second: they are small where that eigenvalue is real and simple.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where `P` is singular.
    pub fn smallest_eigenvalue(&self) -> Result<(f64, f64), ArithmeticError> {
        let factors = self.factored(of_positions, |_| Complex::real(0.0))?;
        let mut vector = vec![Complex::real(1.0); self.rows.len()];
        let (mut value, mut change) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..60 {
            let next = factors.solve(vector)?;
            let size = next.iter().map(modulus).fold(0.0, f64::max);
            change = (value * size - 1.0).abs();
            value = 1.0 / size;
            vector = next.iter().map(|z| z.scale(&value)).collect();
        }
        Ok((value, change))
    }
}

/// The entry of the Laplacian of the positions.
fn of_positions(_: usize, [position, _]: &[f64; 2]) -> Complex<f64> {
    Complex::real(*position)
}

/// `|z|`, also where its square is beyond the floats: behind many cars that all swing more than the one in front.
pub(super) fn modulus(z: &Complex<f64>) -> f64 {
    let square = z.norm_squared();
    if square.is_normal() { square.sqrt() } else { z.re.hypot(z.im) }
}

/// `1/z` in the same way.
fn inverse(z: &Complex<f64>) -> Result<Complex<f64>, ArithmeticError> {
    let size = z.re.abs().max(z.im.abs());
    if z.norm_squared().is_normal() || size == 0.0 {
        return z.recip();
    }
    let turned = Complex::new(z.re / size, z.im / size).recip()?;
    Ok(Complex::new(turned.re / size, turned.im / size))
}

impl Factors {
    fn solve(&self, mut right: Vec<Complex<f64>>) -> Result<Vec<Complex<f64>>, ArithmeticError> {
        for (k, (swapped, multipliers)) in self.steps.iter().enumerate() {
            right.swap(k, *swapped);
            for (n, factor) in multipliers.iter().enumerate() {
                right[k + 1 + n] = right[k + 1 + n].clone() - factor.clone() * &right[k];
            }
        }
        for k in (0..right.len()).rev() {
            let known = right.iter().skip(k + 1).zip(&self.rows[k][1..]);
            let sum = known.fold(right[k].clone(), |sum, (x, entry)| sum - entry.clone() * x);
            right[k] = sum * inverse(&self.rows[k][0])?;
        }
        Ok(right)
    }
}
