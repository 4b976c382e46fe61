//! Networks that alternate for ever: where every distance goes at each phase of a cycle.
//!
//! One round of the cycle multiplies the velocities by `M`, a product of transition matrices, and adds `N v` to the positions. From
//! a phase on, after `k` rounds, `x_i - x_j = A + B k - z(k)`, and `z` is halved every so many rounds as on a fixed network;
//! birds that are connected by some network of the cycle take the place of a flock.

use super::error::SettleError;
use super::limits::{log2_above, log2_below};
use super::ties::pair_in_cycle;
use crate::averaging::contraction::contraction_watched;
use crate::averaging::flock::{Flock, Start};
use crate::averaging::stationary::deviation_matrix_watched;
use crate::averaging::weights::transition_matrix;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::{Progress, Rational, Ring, Sign, rational};
use num_traits::{Signed, ToPrimitive, Zero};

/// What becomes of a cycle of networks.
pub(super) enum Future {
    /// It goes on for ever, if it does for so many steps.
    Keeps(u64),
    /// These two approach, and may end it when they come within distance 1: that is not followed, since it is far away.
    Until((usize, usize)),
    /// Some approach, but if it goes on for `from` steps then it goes on for `to` steps.
    For {
        /// Steps to be followed one by one.
        from: u64,
        /// Steps before anybody can come within distance 1.
        to: u64,
    },
    /// It ends, or that is not known.
    Ends,
}

/// Whether the networks follow the cycle forever; meetings after more steps than `most` are not waited for.
pub(super) fn future(
    flock: &Flock,
    cycle: &[Graph],
    most: u64,
    progress: &dyn Progress,
) -> Result<Future, SettleError> {
    let birds = flock.birds();
    let union = Graph::from_fn(birds, |i, j| cycle.iter().any(|network| network.has_edge(i, j)));
    let parts = union.components();
    let mut follower = flock.clone();
    let (mut horizon, mut ties, mut meeting, mut contact) = (0, Vec::new(), None, None::<u64>);
    let length = cycle.len() as u64;
    for phase in 0..cycle.len() {
        let from_here: Vec<&Graph> = (0..cycle.len()).map(|k| &cycle[(phase + k) % cycle.len()]).collect();
        let rounds = Rounds::new(&follower, &from_here, &parts, progress)?;
        let network = from_here[cycle.len() - 1];
        let steps = |rounds: u64| rounds.saturating_mul(length).saturating_add(phase as u64);
        for (i, j) in (0..birds).flat_map(|j| (0..j).map(move |i| (i, j))) {
            match rounds.long_run(i, j, most) {
                Run::Tie => ties.push((i, j)),
                Run::MeetLater if !network.has_edge(i, j) => meeting = Some((i, j)),
                Run::Keeps { near, rounds } if near == network.has_edge(i, j) => {
                    horizon = horizon.max(steps(rounds));
                }
                Run::Approach { from, to } if !network.has_edge(i, j) => {
                    horizon = horizon.max(steps(from));
                    contact = Some(contact.map_or(steps(to), |known| known.min(steps(to))));
                }
                _ => return Ok(Future::Ends),
            }
        }
        follower.step_on(&cycle[phase])?;
    }
    ties.sort_unstable();
    ties.dedup();
    for pair in ties {
        match tie_in_cycle(flock, cycle, &parts, pair, progress)? {
            Some(from) => horizon = horizon.max(from),
            None => return Ok(Future::Ends),
        }
    }
    Ok(match (contact, meeting) {
        (Some(to), _) => Future::For { from: horizon, to },
        (None, Some(pair)) => Future::Until(pair),
        (None, None) => Future::Keeps(horizon),
    })
}

/// A distance that tends to 1: by the leading terms of its recurrence, among the birds that matter to the two.
fn tie_in_cycle(
    flock: &Flock,
    cycle: &[Graph],
    parts: &[Vec<usize>],
    (i, j): (usize, usize),
    progress: &dyn Progress,
) -> Result<Option<u64>, SettleError> {
    let members: Vec<usize> =
        parts.iter().filter(|part| part.contains(&i) || part.contains(&j)).flatten().copied().collect();
    let rows = |all: Vec<Vec<Rational>>| members.iter().map(|&b| all[b].clone()).collect();
    let start = Start {
        positions: rows(flock.positions()),
        velocities: rows(flock.velocities()),
        weights: flock.weights().restricted(&members),
        hysteresis: flock.hysteresis().clone(),
    };
    let few = Flock::resume(&start, flock.network().induced(&members), flock.time().clone())?;
    let cycle: Vec<Graph> = cycle.iter().map(|network| network.induced(&members)).collect();
    let place = |bird| members.iter().position(|&b| b == bird).unwrap_or(0);
    let pair = (place(i).min(place(j)), place(i).max(place(j)));
    let long_run = pair_in_cycle(&few, &cycle, pair, progress)?;
    let keeps = long_run.signs.iter().enumerate().all(|(residue, &sign)| {
        // After `residue` steps (modulo the count) the network is that of step `residue - 1`.
        let network = &cycle[(residue + cycle.len() - 1) % cycle.len()];
        (sign != Sign::Positive) == network.has_edge(pair.0, pair.1)
    });
    Ok(keeps.then_some(long_run.from))
}

/// What becomes of a pair at one phase.
enum Run {
    /// Its status is this after so many rounds.
    Keeps {
        /// Within distance 1.
        near: bool,
        /// From so many on.
        rounds: u64,
    },
    /// The distance tends to 1.
    Tie,
    /// The two may come within distance 1 on their way.
    Meet,
    /// They may, but once the transients are small not for more rounds than were allowed.
    MeetLater,
    /// They may, but not in these rounds.
    Approach {
        /// The first round from which the transients are small.
        from: u64,
        /// The last round before they may meet.
        to: u64,
    },
}

/// `|A + B k|² - 1` while two that approach are left to go round: small, so that few steps are left when they come near.
const NEAR: (i64, i64) = (1, 1 << 10);

/// The motion at one phase of the cycle.
struct Rounds {
    part_of: Vec<usize>,
    /// By bird: `x + N Gamma v`.
    place: Vec<Vec<Rational>>,
    /// By bird: how far it goes in one round in the long run.
    drift: Vec<Vec<Rational>>,
    /// By part: a bound of its share of the transients.
    size: Vec<Rational>,
    /// By part: the rounds that halve it.
    halving: Vec<u64>,
}

impl Rounds {
    /// The motion of a flock that follows the networks, one after the other and again; the parts are what their union connects.
    ///
    /// # Errors
    /// [`SettleError`].
    fn new(
        flock: &Flock,
        cycle: &[&Graph],
        parts: &[Vec<usize>],
        progress: &dyn Progress,
    ) -> Result<Self, SettleError> {
        let (mut place, velocities) = (flock.positions(), flock.velocities());
        let mut rounds = Rounds {
            part_of: vec![0; flock.birds()],
            drift: velocities.clone(),
            place: Vec::new(),
            size: Vec::new(),
            halving: Vec::new(),
        };
        let length = rational(cycle.len() as i64, 1);
        for (number, members) in parts.iter().enumerate() {
            let weights = flock.weights().restricted(members);
            let one = RationalMatrix::identity(members.len())?;
            let (mut product, mut sum) = (one.clone(), one.scaled(&rational(0, 1)));
            for network in cycle {
                sum = sum.plus(&product)?;
                let step = transition_matrix(&network.induced(members), &weights)?;
                product = step.times_watched(&product, progress)?.reduced_watched(progress)?;
            }
            let fixed = product.transpose().minus(&one)?.kernel();
            let [fixed] = fixed.as_slice() else { return Err(SettleError::Unresolved) };
            let total: Rational = fixed.iter().sum();
            let pi: Vec<Rational> = fixed.iter().map(|x| x / &total).collect();
            let gamma = deviation_matrix_watched(&product, &pi, progress)?;
            let velocity =
                RationalMatrix::from_rows(&members.iter().map(|&i| velocities[i].clone()).collect::<Vec<_>>())?;
            let rest = gamma.times_watched(&velocity, progress)?;
            let way = sum.times_watched(&rest, progress)?;
            let mut size = rational(0, 1);
            for k in 0..rest.cols() {
                let column = || (0..rest.rows()).map(|a| rest.entry(a, k));
                if let (Some(most), Some(least)) = (column().max(), column().min()) {
                    size += (most - least) * &length;
                }
            }
            for (a, &i) in members.iter().enumerate() {
                rounds.part_of[i] = number;
                for k in 0..rest.cols() {
                    place[i][k] += way.entry(a, k);
                    let mean: Rational = members.iter().zip(&pi).map(|(&m, p)| p * &velocities[m][k]).sum();
                    rounds.drift[i][k] = mean * &length;
                }
            }
            rounds.size.push(size);
            rounds.halving.push(contraction_watched(&product, progress)?.steps.to_u64().ok_or(SettleError::TooSlow)?);
        }
        rounds.place = place;
        Ok(rounds)
    }

    /// What becomes of the distance of two birds after each round.
    fn long_run(&self, i: usize, j: usize, most: u64) -> Run {
        let minus =
            |rows: &[Vec<Rational>]| -> Vec<Rational> { rows[i].iter().zip(&rows[j]).map(|(p, q)| p - q).collect() };
        let dot = |a: &[Rational], b: &[Rational]| -> Rational { a.iter().zip(b).map(|(p, q)| p * q).sum() };
        let (f, g) = (self.part_of[i], self.part_of[j]);
        let size = if f == g { self.size[f].clone() } else { &self.size[f] + &self.size[g] };
        let halving = self.halving[f].max(self.halving[g]);
        // Rounds until the transients are below a positive number.
        let until = |limit: &Rational| {
            if size.is_zero() {
                return 0;
            }
            let halvings = log2_above(&size.numer(), &size.denom()) - log2_below(&limit.numer(), &limit.denom());
            u64::try_from(halvings).unwrap_or(0).saturating_mul(halving)
        };
        let (a, b) = (minus(&self.place), minus(&self.drift));
        let excess = dot(&a, &a) - rational(1, 1);
        if b.iter().any(|x| !x.is_zero()) {
            let (along, speed) = (dot(&a, &b) * rational(2, 1), dot(&b, &b));
            // The least of |A + B k|² - 1 for k >= 0.
            let least =
                if along.is_negative() { &excess - along.square() / (&speed * rational(4, 1)) } else { excess.clone() };
            if !least.is_positive() {
                let k = Rational::from_integer(most.into());
                // Falling until then, and far from zero.
                let falling = (&speed * &k * rational(2, 1) + &along).is_negative();
                let later = falling && (&speed * &k + &along) * &k + &excess > rational(1, 1);
                if later && until(&rational(1, 4)) <= most {
                    return Run::MeetLater;
                }
                // Falling until the round k, and not below `near` there, where 2 z sqrt(q + 1) + z² < q for z < near/4 and q >= near.
                let near = rational(NEAR.0, NEAR.1);
                let apart = |k: u64| {
                    let k = Rational::from_integer(k.into());
                    let falling = !(&speed * &k * rational(2, 1) + &along).is_positive();
                    falling && (&speed * &k + &along) * &k + &excess >= near
                };
                let (from, to) = (until(&(&near * rational(1, 4))), last_with(most, apart));
                return to.filter(|to| from < *to).map_or(Run::Meet, |to| Run::Approach { from, to });
            }
            // 2 z sqrt(q + 1) + z² < q for z < min(1, q)/4.
            let limit = least.min(rational(1, 1)) * rational(1, 4);
            return Run::Keeps { near: false, rounds: until(&limit) };
        }
        if excess.is_zero() {
            return Run::Tie;
        }
        // | |A| - 1 |, from below.
        let gap =
            if excess.is_negative() { -excess.clone() * rational(1, 2) } else { &excess / (&excess + rational(3, 1)) };
        Run::Keeps { near: excess.is_negative(), rounds: until(&gap) }
    }
}

/// The last number up to `most` with a property that all smaller ones have; none where 0 does not have it.
fn last_with(most: u64, property: impl Fn(u64) -> bool) -> Option<u64> {
    if property(most) {
        return Some(most);
    }
    let (mut with, mut without) = (0, most);
    while without - with > 1 {
        let middle = with + (without - with) / 2;
        if property(middle) { with = middle } else { without = middle }
    }
    property(with).then_some(with)
}

#[cfg(test)]
mod tests;
