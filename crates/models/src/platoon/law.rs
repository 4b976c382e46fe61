//! The law of platoons, written once over any field: every follower answers the deviation from the agents that it tracks.

use arithmetic::{Field, Ring};

/// The two gains of the control law, in the scalar they are used in.
#[derive(Debug, Clone, PartialEq)]
pub struct Gains<T> {
    /// Gain of the deviation of positions, 1/s².
    pub f: T,
    /// Gain of the deviation of velocities, 1/s.
    pub g: T,
}

/// Which sign gains have, for those who write `-k`.
pub const SIGNS: &str = "the law is y'' = f e + g e' with the deviation e of a car from its place, so that f = g = -1 pulls it back; for a gain k > 0 of texts \
that write -k e it is -k";

/// Which cars a follower keeps track of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Communication {
    /// Equation (1): the car in front.
    Front,
    /// Equation (2): the cars in front and behind with weights 1/2 each; the last car only the one in front.
    FrontAndBack,
}

impl Communication {
    /// The agents that follower `k` of `followers` cars tracks, each with the same weight.
    pub(super) fn tracked(self, k: usize, followers: usize) -> Vec<usize> {
        match self {
            Communication::FrontAndBack if k < followers => vec![k - 1, k + 1],
            _ => vec![k - 1],
        }
    }
}

/// The accelerations of the followers of systems (1) and (2), `f e_k + g e'_k` with the deviation `e_k` of car `k` from the mean of the
/// agents it tracks. `leader` is `(y_0, u_0)`; there are as many cars as there are positions and velocities of both.
pub fn accelerations<T: Field>(
    communication: Communication,
    gains: &Gains<T>,
    leader: (&T, &T),
    positions: &[T],
    velocities: &[T],
) -> Vec<T> {
    let followers = positions.len().min(velocities.len());
    let mean = |k: usize, value: &dyn Fn(usize) -> T| match communication.tracked(k, followers)[..] {
        [front, behind] => Some((value(front) + value(behind)) * value(front).ratio(1, 2)),
        [front] => Some(value(front)),
        _ => None,
    };
    accelerations_by(followers, [&mean, &mean], |_| gains, leader, (positions, velocities))
}

/// The accelerations of the first `cars` followers: `f e_k + g e'_k`, where `e_k` is the deviation of the position of car `k` from the mean of the
/// positions that it tracks, and zero where it tracks nobody, and `e'_k` likewise of velocities. `means` are `mean(k, value)`, the weighted mean of
/// `value(agent)` over the agents whose positions are tracked, and over those whose velocities are; `gains(k)` are those of car `k`.
///
/// `leader` is `(y_0, u_0)`; `positions` and `velocities` hold `y_1..y_M` and `u_1..u_M`, at least those of all agents that are tracked.
pub(super) fn accelerations_by<'a, T: Field + 'a>(
    cars: usize,
    means: [impl Fn(usize, &dyn Fn(usize) -> T) -> Option<T>; 2],
    gains: impl Fn(usize) -> &'a Gains<T>,
    leader: (&T, &T),
    (positions, velocities): (&[T], &[T]),
) -> Vec<T> {
    let deviation = |which: usize, values: &[T], first: &T, k: usize| {
        let value = |agent: usize| if agent == 0 { first.clone() } else { values[agent - 1].clone() };
        means[which](k, &value).map_or(first.zero(), |mean| value(k) - mean)
    };
    let acceleration = |k: usize| {
        let gains = gains(k);
        deviation(0, positions, leader.0, k) * &gains.f + deviation(1, velocities, leader.1, k) * &gains.g
    };
    (1..=cars).map(acceleration).collect()
}

impl<T: Ring> Gains<T> {
    /// The same gains in another scalar.
    pub fn map<S>(&self, convert: impl Fn(&T) -> S) -> Gains<S> {
        Gains { f: convert(&self.f), g: convert(&self.g) }
    }
}
