//! The harmonic response of platoons whose cars track near cars only, in floating point: `O(M)` per frequency.

use super::communication_graph::CommunicationGraph;
use super::law::Gains;
use super::response::gamma_minus_one;
use arithmetic::{ArithmeticError, Complex, Field};
use num_traits::ToPrimitive;

/// The reduced Laplacian `P` of a communication graph, by bands.
#[derive(Debug, Clone)]
pub struct BandedPlatoon {
    /// Entries of `P` by row, `(column, value)`.
    rows: Vec<Vec<(usize, f64)>>,
    /// `-L_l`: the weight of the leader in each row.
    leader: Vec<f64>,
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
        let size = graph.followers();
        let (mut rows, mut leader) = (vec![Vec::new(); size], vec![0.0; size]);
        let (mut lower, mut upper) = (0, 0);
        for i in 0..size {
            let mut own = 0.0;
            for (agent, weight) in graph.tracked_by(i + 1) {
                let weight = weight.to_f64().unwrap_or(f64::NAN);
                own += weight;
                match agent.checked_sub(1) {
                    None => leader[i] += weight,
                    Some(j) => {
                        rows[i].push((j, -weight));
                        lower = lower.max(i.saturating_sub(j));
                        upper = upper.max(j.saturating_sub(i));
                    }
                }
            }
            rows[i].push((i, own));
        }
        BandedPlatoon { rows, leader, lower, upper }
    }

    /// `P + diag(shifts)` factored with partial pivoting.
    fn factored(&self, shift: impl Fn(usize) -> Complex<f64>) -> Result<Factors, ArithmeticError> {
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
                for &(j, value) in entries {
                    row[j - start].re += value;
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

    /// The amplitudes `a_1..a_M` behind the leader `e^{iwt}`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where `P + gamma - 1` is singular.
    pub fn response(&self, gains: &Gains<f64>, w: f64) -> Result<Vec<Complex<f64>>, ArithmeticError> {
        let shift = gamma_minus_one(gains, &w)?;
        self.factored(|_| shift.clone())?.solve(self.leaders_part())
    }

    /// The same where follower `k` has the gains `gains[k - 1]`, of which there are as many as followers.
    ///
    /// # Errors
    /// As [`BandedPlatoon::response`].
    pub fn response_of_cars(&self, gains: &[Gains<f64>], w: f64) -> Result<Vec<Complex<f64>>, ArithmeticError> {
        if gains.len() != self.rows.len() {
            return Err(ArithmeticError::Domain("gains for each follower"));
        }
        let shifts: Vec<Complex<f64>> =
            gains.iter().map(|gains| gamma_minus_one(gains, &w)).collect::<Result<_, _>>()?;
        self.factored(|i| shifts[i].clone())?.solve(self.leaders_part())
    }

    fn leaders_part(&self) -> Vec<Complex<f64>> {
        self.leader.iter().map(|&x| Complex::real(x)).collect()
    }

    /// The largest amplitude of all followers.
    ///
    /// # Errors
    /// As [`BandedPlatoon::response`].
    pub fn largest_amplitude(&self, gains: &Gains<f64>, w: f64) -> Result<f64, ArithmeticError> {
        let amplitudes = self.response(gains, w)?;
        Ok(amplitudes.iter().map(modulus).fold(0.0, f64::max))
    }

    /// The modulus of the eigenvalue of `P` nearest to 0, by inverse iteration; the steps that it still changed by, relatively,
    /// come second: they are small where that eigenvalue is real and simple.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where `P` is singular.
    pub fn smallest_eigenvalue(&self) -> Result<(f64, f64), ArithmeticError> {
        let factors = self.factored(|_| Complex::real(0.0))?;
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
