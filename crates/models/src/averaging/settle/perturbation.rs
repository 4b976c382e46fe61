//! What an exact jump leaves out: transients too small to be written as numbers, kept as sequences.
//!
//! After a jump over `s` steps the state is an exact rational limit plus `-P^(s-1) P rest` in the positions and
//! `P^(s-1) velocity_rest` in the velocities. A linear functional of that part is a sequence in `s` with a linear recurrence; its
//! sign and size at a huge `s` follow from the leading root. Later stages act linearly, so a functional of the present
//! state is pulled back through them.

use super::error::SettleError;
use super::limits::{FixedNetwork, Motion, largest, log2_above};
use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix};
use algebra::spectrum::{Leading, Recurrence};
use arithmetic::{Field, Interval, Progress, Rational, Ring, Sign, rational};
use num_bigint::BigInt;
use num_integer::Integer;

/// What happened since the last exact state, oldest first.
pub(super) enum Stage {
    /// `steps` times: move, then average by `transition`.
    Steps {
        /// On this network.
        network: Graph,
        /// Its averaging.
        transition: RationalMatrix,
        /// How often.
        steps: u64,
    },
    /// Average the velocities once more.
    Average(RationalMatrix),
    /// A jump to the limit motion.
    Jump(Box<Jump>),
}

impl Stage {
    /// Bits by which it enlarges what was left out before.
    pub fn growth_bits(&self) -> u64 {
        match self {
            Stage::Steps { steps, .. } => u64::from(u64::BITS - steps.leading_zeros()) + 1,
            Stage::Average(_) => 0,
            Stage::Jump(jump) => jump.steps.bits() + largest_bits(&jump.gamma) + 2,
        }
    }
}

/// A jump: all that is needed to know what it left out and what it does to older remainders.
pub(super) struct Jump {
    transition: RationalMatrix,
    /// Rows `pi^T` of the own flock.
    limit: RationalMatrix,
    /// Gamma in blocks.
    gamma: RationalMatrix,
    /// `P Gamma v`, one row per bird.
    rest: RationalMatrix,
    /// Velocities less the drift.
    velocity_rest: RationalMatrix,
    steps: BigInt,
    /// What is left out is below `2^-smallness` in each entry.
    pub smallness: BigInt,
}

/// A number that is zero or known by sign and size.
#[derive(Debug, Clone)]
pub(super) enum Magnitude {
    /// Zero.
    Zero,
    /// Sign and size.
    Known(Leading),
}

/// A linear functional of positions and velocities: one row per dimension, one column per bird.
pub(super) struct Functional {
    /// Of the positions.
    pub positions: RationalMatrix,
    /// Of the velocities.
    pub velocities: RationalMatrix,
}

impl Jump {
    /// The jump of a motion over so many steps, at least one.
    ///
    /// # Errors
    /// [`SettleError`] of the matrices, or where it is stopped.
    pub fn new(
        fixed: &FixedNetwork,
        motion: &Motion,
        steps: BigInt,
        progress: &dyn Progress,
    ) -> Result<Self, SettleError> {
        let matrix = |rows: &[Vec<BigInt>]| {
            RationalMatrix::new(rows.len(), rows[0].len(), rows.concat(), motion.unit.clone())?
                .reduced_watched(progress)
        };
        // Powers of P halve the range of a vector of mean zero every so many steps; entries are within the range.
        let size = (largest(&motion.rest) + largest(&motion.velocity_rest) + &motion.unit) * 2;
        let halvings: BigInt = (&steps - 1) / fixed.halving_steps;
        Ok(Jump {
            limit: fixed.limit.clone(),
            gamma: fixed.gamma.clone(),
            rest: fixed.transition.times_watched(&matrix(&motion.rest)?, progress)?,
            velocity_rest: matrix(&motion.velocity_rest)?,
            transition: fixed.transition.clone(),
            smallness: halvings - log2_above(&size, &motion.unit),
            steps,
        })
    }

    /// The functional of what this jump left out.
    fn value(&self, of: &Functional, progress: &dyn Progress) -> Result<Magnitude, SettleError> {
        let exponent: BigInt = &self.steps - 1;
        let (half, parity) = exponent.div_rem(&BigInt::from(2));
        let mut rest = self.rest.clone();
        let mut velocities = self.velocity_rest.clone();
        // Only every second term: the roots are squares, so not negative.
        let wanted = 2 * self.transition.rows() + 2;
        let mut terms = Vec::with_capacity(wanted);
        let mut index = 0;
        while terms.len() < wanted {
            if (index % 2 == 1) == (parity == BigInt::from(1)) {
                terms.push(
                    trace(&of.velocities.times_watched(&velocities, progress)?)
                        - trace(&of.positions.times_watched(&rest, progress)?),
                );
            }
            rest = self.transition.times_watched(&rest, progress)?;
            velocities = self.transition.times_watched(&velocities, progress)?;
            index += 1;
        }
        Ok(match Recurrence::new(terms, progress)?.leading(&half, progress)? {
            None => Magnitude::Zero,
            Some(leading) => Magnitude::Known(leading),
        })
    }

    /// The functional before the jump that has the value of `of` after it, leaving out what the jump leaves out.
    fn pull_back(&self, of: Functional, progress: &dyn Progress) -> Result<Functional, MatrixError> {
        let steps = Rational::from_integer(self.steps.clone());
        let through_limit = of.positions.scaled(&steps).plus(&of.velocities)?.times_watched(&self.limit, progress)?;
        let velocities = of.positions.times_watched(&self.gamma, progress)?.plus(&through_limit)?;
        Ok(Functional { positions: of.positions, velocities })
    }
}

fn trace(matrix: &RationalMatrix) -> Rational {
    (0..matrix.rows()).map(|k| matrix.entry(k, k)).sum()
}

/// The functional `sum_k weights_k (x_i - x_j)_k` of positions or velocities.
pub(super) fn difference_functional(
    birds: usize,
    (i, j): (usize, usize),
    weights: &[Rational],
) -> Result<RationalMatrix, MatrixError> {
    let row = |w: &Rational| -> Vec<Rational> {
        (0..birds)
            .map(|b| {
                if b == i {
                    w.clone()
                } else if b == j {
                    -w.clone()
                } else {
                    w.zero()
                }
            })
            .collect()
    };
    RationalMatrix::from_rows(&weights.iter().map(row).collect::<Vec<_>>())
}

/// The value of a functional on everything that the stages left out.
///
/// # Errors
/// [`SettleError::Unresolved`] where several contributions cannot be told apart.
pub(super) fn value_of(
    stages: &[Stage],
    mut of: Functional,
    progress: &dyn Progress,
) -> Result<Magnitude, SettleError> {
    let mut known: Vec<Leading> = Vec::new();
    let mut smallness: Vec<BigInt> = Vec::new();
    let mut slack: u64 = 64;
    for stage in stages.iter().rev() {
        match stage {
            Stage::Steps { transition, steps, .. } => {
                for _ in 0..*steps {
                    of.velocities = of.velocities.times_watched(transition, progress)?.plus(&of.positions)?;
                }
                of.velocities = of.velocities.reduced_watched(progress)?;
                slack += 2 * u64::from(u64::BITS - steps.leading_zeros()) + 2;
            }
            Stage::Average(transition) => of.velocities = of.velocities.times_watched(transition, progress)?,
            Stage::Jump(jump) => {
                if let Magnitude::Known(leading) = jump.value(&of, progress)? {
                    known.push(leading);
                }
                smallness.push(jump.smallness.clone());
                slack += jump.steps.bits() + 2 * largest_bits(&jump.gamma) + largest_bits(&of.positions) + 8;
                slack += largest_bits(&of.velocities);
                of = jump.pull_back(of, progress)?;
            }
        }
    }
    combine(known, &smallness, slack)
}

/// Bits above the point of the largest entry, times the number of columns.
fn largest_bits(matrix: &RationalMatrix) -> u64 {
    let bits = |i: usize| matrix.row(i).iter().map(|x| x.bits()).max().unwrap_or(0);
    let top = (0..matrix.rows()).map(bits).max().unwrap_or(0);
    (top + 1 + matrix.cols() as u64).saturating_sub(matrix.denominator().bits() - 1)
}

/// The sum of the contributions, where one outweighs the others and whatever is of second order.
fn combine(known: Vec<Leading>, smallness: &[BigInt], slack: u64) -> Result<Magnitude, SettleError> {
    let highest = |a: &Leading| a.log2.to_rationals().1;
    let lowest = |a: &Leading| a.log2.to_rationals().0;
    let Some(first) = known.iter().max_by_key(|a| highest(a)).cloned() else {
        return if smallness.len() <= 1 { Ok(Magnitude::Zero) } else { Err(SettleError::Unresolved) };
    };
    let beyond = |limit: Rational| lowest(&first) > limit + rational(8, 1);
    let others = known.iter().filter(|a| a.log2.lo() != first.log2.lo() || a.log2.hi() != first.log2.hi());
    let mut outweighs = others.clone().count() + 1 == known.len() && others.into_iter().all(|a| beyond(highest(a)));
    for (k, a) in smallness.iter().enumerate() {
        for b in &smallness[..k] {
            outweighs &= beyond(Rational::from_integer(BigInt::from(slack) - a - b));
        }
    }
    if !outweighs {
        return Err(SettleError::Unresolved);
    }
    // The others together are below 2^-6 of the first.
    let widen = first.log2.ratio(1, 8).hull(&first.log2.ratio(-1, 8));
    let log2: Interval = if smallness.len() > 1 { first.log2.clone() + widen } else { first.log2.clone() };
    Ok(Magnitude::Known(Leading { sign: first.sign, log2 }))
}

impl Magnitude {
    /// Of zero too.
    pub fn sign(&self) -> Sign {
        match self {
            Magnitude::Zero => Sign::Zero,
            Magnitude::Known(leading) => leading.sign,
        }
    }
}

#[cfg(test)]
mod tests;
