//! What a flock on a fixed network tends to: drift, limit configuration and how fast the rest dies out.

use super::error::SettleError;
use crate::averaging::contraction::contraction_watched;
use crate::averaging::flock::IntegerState;
use crate::averaging::stationary::{deviation_matrix_watched, stationary_distribution};
use crate::averaging::weights::{Weights, transition_matrix};
use algebra::graph::Graph;
use algebra::matrix::{RationalMatrix, StochasticMatrix};
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

/// Numerators, one row per bird and one column per dimension.
pub(super) type Rows = Vec<Vec<BigInt>>;

/// What depends on the network only.
pub(super) struct FixedNetwork {
    /// The network.
    pub network: Graph,
    /// The number of the flock of each bird.
    pub flock_of: Vec<usize>,
    /// The birds of each flock.
    pub flocks: Vec<Vec<usize>>,
    /// `tau_1(P^steps) <= 1/2` within every flock.
    pub halving_steps: u64,
    /// The transition matrix of all birds.
    pub transition: RationalMatrix,
    /// Rows `pi^T` of the own flock: where the powers of the transition matrix go.
    pub limit: RationalMatrix,
    /// The deviation matrices Gamma of the flocks in blocks, over the same denominator as `limit`.
    pub gamma: RationalMatrix,
    weights: Weights,
}

impl FixedNetwork {
    /// The limits of a network.
    ///
    /// # Errors
    /// [`SettleError`] for weights that do not suit the network, or where it is stopped.
    pub fn new(network: &Graph, weights: &Weights, progress: &dyn Progress) -> Result<Self, SettleError> {
        let birds = network.order();
        let mut flock_of = vec![0; birds];
        let flocks = network.components();
        let mut halving_steps = 1;
        let mut limit = vec![vec![rational(0, 1); birds]; birds];
        let mut gamma = limit.clone();
        for (number, members) in flocks.iter().enumerate() {
            let (graph, weights) = (network.induced(members), weights.restricted(members));
            let transition = transition_matrix(&graph, &weights)?;
            let pi = stationary_distribution(&graph, &weights)?;
            let deviation = deviation_matrix_watched(&transition, &pi, progress)?;
            let steps = contraction_watched(&transition, progress)?.steps.to_u64().ok_or(SettleError::TooSlow)?;
            halving_steps = halving_steps.max(steps);
            for (a, &i) in members.iter().enumerate() {
                flock_of[i] = number;
                progress.checkpoint()?;
                for (b, &j) in members.iter().enumerate() {
                    limit[i][j] = pi[b].clone();
                    gamma[i][j] = deviation.entry(a, b);
                }
            }
        }
        let transition = transition_matrix(network, weights)?;
        // One denominator for both.
        let both = RationalMatrix::from_rows_watched(&[limit, gamma].concat(), progress)?;
        let half = |from: usize| -> Result<RationalMatrix, SettleError> {
            let numerators = (from..from + birds).flat_map(|i| both.row(i).to_vec()).collect();
            Ok(RationalMatrix::new(birds, birds, numerators, both.denominator().clone())?)
        };
        Ok(FixedNetwork {
            limit: half(0)?,
            gamma: half(birds)?,
            network: network.clone(),
            flock_of,
            flocks,
            halving_steps,
            transition,
            weights: weights.clone(),
        })
    }

    /// The powers `P^exponent` of the flocks, in the order of `flocks`.
    pub fn powers(&self, exponent: u64, progress: &dyn Progress) -> Result<Vec<StochasticMatrix>, SettleError> {
        let power = |members: &Vec<usize>| -> Result<StochasticMatrix, SettleError> {
            let (graph, weights) = (self.network.induced(members), self.weights.restricted(members));
            let base = StochasticMatrix::try_from(&transition_matrix(&graph, &weights)?)?;
            let one = StochasticMatrix::try_from(&RationalMatrix::identity(members.len())?)?;
            let mut result = one;
            for bit in (0..u64::BITS - exponent.leading_zeros()).rev() {
                result = result.times_watched(&result, progress)?;
                if exponent >> bit & 1 == 1 {
                    result = result.times_watched(&base, progress)?;
                }
            }
            Ok(result)
        };
        self.flocks.iter().map(power).collect()
    }
}

/// The motion of a flock that keeps its network: with `s` steps from now,
/// `x_i(s) = place_i + s drift_i - (P^s rest)_i`. All numerators are over `unit`.
pub(super) struct Motion {
    /// The common denominator.
    pub unit: BigInt,
    /// `x + Gamma v`.
    pub place: Rows,
    /// The limit of the velocity of each bird.
    pub drift: Rows,
    /// `Gamma v`; its stationary mean is zero in every flock.
    pub rest: Rows,
    /// Velocities less the drift.
    pub velocity_rest: Rows,
    /// Sums over the coordinates of the ranges of `rest` and of the velocities, by flock.
    rest_range: Vec<BigInt>,
    velocity_range: Vec<BigInt>,
}

impl Motion {
    /// The motion from a state on.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn new(fixed: &FixedNetwork, state: &IntegerState, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let factor = fixed.limit.denominator();
        let drift = apply(&fixed.limit, &state.velocities, progress)?;
        let rest = apply(&fixed.gamma, &state.velocities, progress)?;
        let zip = |a: &Rows, b: &Rows, f: &dyn Fn(&BigInt, &BigInt) -> BigInt| -> Rows {
            a.iter().zip(b).map(|(p, q)| p.iter().zip(q).map(|(x, y)| f(x, y)).collect()).collect()
        };
        let place = zip(&state.positions, &rest, &|x, r| x * factor + r);
        let velocity_rest = zip(&state.velocities, &drift, &|v, y| v * factor - y);
        let ranges = |rows: &Rows| fixed.flocks.iter().map(|members| range(members, rows)).collect();
        Ok(Motion {
            unit: &state.unit * factor,
            rest_range: ranges(&rest),
            velocity_range: ranges(&velocity_rest),
            place,
            drift,
            rest,
            velocity_rest,
        })
    }

    /// Whether every velocity has its limit already.
    pub fn is_straight(&self) -> bool {
        self.velocity_rest.iter().chain(&self.rest).flatten().all(Zero::is_zero)
    }

    /// `(A, B)` with `x_i - x_j = A + B s - (transients)`.
    pub fn difference(&self, i: usize, j: usize) -> (Vec<BigInt>, Vec<BigInt>) {
        let minus = |a: &[BigInt], b: &[BigInt]| a.iter().zip(b).map(|(p, q)| p - q).collect();
        (minus(&self.place[i], &self.place[j]), minus(&self.drift[i], &self.drift[j]))
    }

    /// An integer that is at least `log2` of the norm of the transient part of `x_i - x_j` now, which is halved every
    /// `halving_steps`; `None` where there is none.
    pub fn log2_transient(&self, fixed: &FixedNetwork, i: usize, j: usize) -> Option<i64> {
        let (f, g) = (fixed.flock_of[i], fixed.flock_of[j]);
        // Each entry of `rest` lies within the range of its flock, whose mean is zero.
        let size = if f == g { self.rest_range[f].clone() } else { &self.rest_range[f] + &self.rest_range[g] };
        (!size.is_zero()).then(|| log2_above(&size, &self.unit))
    }

    /// The same for the difference of the velocities of two birds of one flock.
    pub fn log2_velocity(&self, fixed: &FixedNetwork, i: usize) -> Option<i64> {
        let size = &self.velocity_range[fixed.flock_of[i]];
        (!size.is_zero()).then(|| log2_above(size, &self.unit))
    }

    /// A limit difference as rationals.
    pub fn rationals(&self, numerators: &[BigInt]) -> Vec<Rational> {
        numerators.iter().map(|x| Rational::new(x.clone(), self.unit.clone())).collect()
    }

    /// The exact state after some steps, by the powers of the transition matrix.
    pub fn state_after(
        &self,
        fixed: &FixedNetwork,
        steps: u64,
        progress: &dyn Progress,
    ) -> Result<IntegerState, SettleError> {
        let powers = fixed.powers(steps, progress)?;
        let birds = self.place.len();
        let mut state = IntegerState {
            positions: vec![Vec::new(); birds],
            velocities: vec![Vec::new(); birds],
            unit: BigInt::from(1),
        };
        let power_unit = powers.iter().fold(BigInt::from(1), |d, p| common_multiple(d, p.denominator().clone().into()));
        for (members, power) in fixed.flocks.iter().zip(&powers) {
            let numerators: Vec<BigInt> = power.numerators().map(BigInt::from).collect();
            let scale = &power_unit / BigInt::from(power.denominator().clone());
            for (a, &i) in members.iter().enumerate() {
                for k in 0..self.place[i].len() {
                    progress.checkpoint()?;
                    let through = |rows: &Rows| -> BigInt {
                        let row = numerators[a * members.len()..].iter();
                        members.iter().zip(row).map(|(&j, p)| p * &rows[j][k]).sum::<BigInt>() * &scale
                    };
                    let place = &self.place[i][k] + &self.drift[i][k] * steps;
                    state.positions[i].push(place * &power_unit - through(&self.rest));
                    state.velocities[i].push(&self.drift[i][k] * &power_unit + through(&self.velocity_rest));
                }
            }
        }
        state.unit = &self.unit * power_unit;
        Ok(state)
    }
}

/// A common multiple: the larger where it is one (powers of the same number), otherwise the product. Greatest common
/// divisors of long numbers take too long.
fn common_multiple(a: BigInt, b: BigInt) -> BigInt {
    let (small, large) = if a <= b { (a, b) } else { (b, a) };
    if large.is_multiple_of(&small) { large } else { small * large }
}

/// `matrix rows`, without the denominator of the matrix.
fn apply(matrix: &RationalMatrix, rows: &Rows, progress: &dyn Progress) -> Result<Rows, Cancelled> {
    let entry = |i: usize, k: usize| {
        matrix.row(i).iter().zip(rows).filter(|(m, _)| !m.is_zero()).map(|(m, row)| m * &row[k]).sum()
    };
    let row = |i: usize| {
        progress.checkpoint()?;
        Ok((0..rows[0].len()).map(|k| entry(i, k)).collect())
    };
    (0..matrix.rows()).map(row).collect()
}

/// The sum over the coordinates of largest minus smallest.
fn range(members: &[usize], rows: &Rows) -> BigInt {
    let width = |k: usize| {
        let column = || members.iter().map(|&i| &rows[i][k]);
        match (column().max(), column().min()) {
            (Some(most), Some(least)) => most - least,
            _ => BigInt::ZERO,
        }
    };
    (0..rows[0].len()).map(width).sum()
}

/// An integer that is at least `log2 |p/q|`, for numbers that are not zero.
pub(super) fn log2_above(p: &BigInt, q: &BigInt) -> i64 {
    p.bits() as i64 - q.bits() as i64 + 1
}

/// An integer that is at most `log2 |p/q|`, for numbers that are not zero.
pub(super) fn log2_below(p: &BigInt, q: &BigInt) -> i64 {
    p.bits() as i64 - q.bits() as i64 - 1
}

/// The dot product.
pub(super) fn dot(a: &[BigInt], b: &[BigInt]) -> BigInt {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The largest absolute value.
pub(super) fn largest(rows: &Rows) -> BigInt {
    rows.iter().flatten().map(Signed::abs).max().unwrap_or_default()
}
