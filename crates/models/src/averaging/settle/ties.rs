//! Distances that tend to 1, and networks that alternate forever: signs in the long run from shortest recurrences.

use super::error::SettleError;
use crate::averaging::flock::Flock;
use algebra::graph::Graph;
use algebra::spectrum::Recurrence;
use arithmetic::{Progress, Rational, Ring, Sign, rational};

/// The signs of `|x_i - x_j|² - 1` in the long run, by the number of steps modulo their count.
pub(super) struct LongRun {
    pub signs: Vec<Sign>,
    /// They hold from this many steps on.
    pub from: u64,
}

/// What the sign of `|x_i - x_j|² - 1` becomes at each residue of the number of steps, if the networks follow the cycle
/// (the network after `s` steps is `cycle[(s - 1) mod length]`) and every sequence has real characteristic roots.
///
/// `limit` is where the difference tends, if it tends to something of length 1: then in one dimension the sign is linear.
pub(super) fn eventual_signs(
    flock: &Flock,
    cycle: &[Graph],
    pair: (usize, usize),
    limit: &[Rational],
    progress: &dyn Progress,
) -> Result<LongRun, SettleError> {
    // Twice the cycle, so that the characteristic roots are squares.
    let stride = 2 * cycle.len();
    let unknowns = if limit.len() == 1 { 2 * flock.birds() + 1 } else { quadratic_order(flock) };
    let terms = 2 * unknowns + 2;
    let mut sequences: Vec<Vec<Rational>> = vec![Vec::with_capacity(terms); stride];
    let mut follower = flock.clone();
    for step in 0..stride * terms {
        progress.checkpoint()?;
        let difference = difference(&follower, pair);
        sequences[step % stride].push(match (difference.as_slice(), limit) {
            ([d], [l]) => (d - l) * l,
            (d, _) => d.iter().map(Ring::square).sum::<Rational>() - rational(1, 1),
        });
        follower.step_on(&cycle[step % cycle.len()])?;
    }
    let mut signs = Vec::with_capacity(stride);
    let mut from = 0;
    for sequence in sequences {
        let long_run = Recurrence::new(sequence, progress)?.eventual_sign(progress)?;
        from = from.max(long_run.from);
        signs.push(long_run.sign);
    }
    Ok(LongRun { signs, from: (from + 1).saturating_mul(stride as u64) })
}

/// The order of the recurrence of a squared distance: products of two of the roots of positions.
fn quadratic_order(flock: &Flock) -> usize {
    let linear = flock.birds() + 2;
    linear * (linear + 1) / 2
}

fn difference(flock: &Flock, (i, j): (usize, usize)) -> Vec<Rational> {
    let unit = flock.denominator();
    flock.position_difference(i, j).into_iter().map(|x| Rational::new(x, unit.clone())).collect()
}

/// On the line the status is that of two linear sequences, `x_i - x_j` against 1 and against -1.
pub(super) fn pair_in_cycle(
    flock: &Flock,
    cycle: &[Graph],
    pair: (usize, usize),
    progress: &dyn Progress,
) -> Result<LongRun, SettleError> {
    if flock.dimension() > 1 {
        return eventual_signs(flock, cycle, pair, &vec![rational(0, 1); flock.dimension()], progress);
    }
    let above = eventual_signs(flock, cycle, pair, &[rational(1, 1)], progress)?;
    let below = eventual_signs(flock, cycle, pair, &[rational(-1, 1)], progress)?;
    // (d - 1) 1 > 0 or (d + 1)(-1) > 0: outside.
    let signs = above.signs.iter().zip(&below.signs).map(|(&a, &b)| a.max(b)).collect();
    Ok(LongRun { signs, from: above.from.max(below.from) })
}
