//! The equations of motion (1) and (2), written once over any ring.

use arithmetic::Ring;

/// The two gains of the control law, in the scalar they are used in.
#[derive(Debug, Clone, PartialEq)]
pub struct Gains<T> {
    /// Gain of the deviation of positions, 1/s².
    pub f: T,
    /// Gain of the deviation of velocities, 1/s.
    pub g: T,
}

/// Which cars a follower keeps track of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Communication {
    /// Equation (1): the car in front.
    Front,
    /// Equation (2): the cars in front and behind with weights 1/2 each; the last car only the one in front.
    FrontAndBack,
}

/// The accelerations of the followers: `f e_k + g e'_k`, where `e_k` is the deviation of car `k` from the mean of the
/// cars it keeps track of.
///
/// `leader` is `(y_0, u_0)`; `positions` and `velocities` hold `y_1..y_M` and `u_1..u_M` and have the same length.
pub fn accelerations<T: arithmetic::Field>(
    communication: Communication,
    gains: &Gains<T>,
    leader: (&T, &T),
    positions: &[T],
    velocities: &[T],
) -> Vec<T> {
    let deviation = |values: &[T], first: &T, k: usize| {
        let front = if k == 0 { first } else { &values[k - 1] };
        match (communication, values.get(k + 1)) {
            (Communication::FrontAndBack, Some(behind)) => {
                values[k].clone() - values[k].ratio(1, 2) * (front.clone() + behind)
            }
            _ => values[k].clone() - front,
        }
    };
    from_deviations(deviation, gains, leader, positions, velocities)
}

/// `f e_k + g e'_k` for every follower, with `deviation(values, value of the leader, k - 1)` for `e_k`.
pub(super) fn from_deviations<T: arithmetic::Field>(
    deviation: impl Fn(&[T], &T, usize) -> T,
    gains: &Gains<T>,
    leader: (&T, &T),
    positions: &[T],
    velocities: &[T],
) -> Vec<T> {
    let acceleration =
        |k: usize| deviation(positions, leader.0, k) * &gains.f + deviation(velocities, leader.1, k) * &gains.g;
    (0..positions.len().min(velocities.len())).map(acceleration).collect()
}

impl<T: Ring> Gains<T> {
    /// The same gains in another scalar.
    pub fn map<S>(&self, convert: impl Fn(&T) -> S) -> Gains<S> {
        Gains { f: convert(&self.f), g: convert(&self.g) }
    }
}
