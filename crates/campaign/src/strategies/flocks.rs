//! Flocks of model D.

use super::list;
use super::numbers::fraction;
use crate::draws::Draws;
use arithmetic::{Rational, rational};
use models::averaging::{Hysteresis, Start, Weights};

/// A start near enough for links to come and go within a few steps: 1 to 5 birds in 1 or 2 dimensions.
pub fn start(draws: &mut Draws) -> Start {
    let (birds, dimension) = (draws.between(1, 5), draws.between(1, 2));
    flock(draws, birds, dimension, 16)
}

/// A start of birds with slow differences of velocity, whose contacts may come after long times.
pub fn long_flock(draws: &mut Draws) -> Start {
    let birds = draws.between(1, 4);
    flock(draws, birds, 1, 400)
}

/// A start of so many birds; velocities are about `1/slowness`.
pub fn flock(draws: &mut Draws, birds: usize, dimension: usize, slowness: i64) -> Start {
    let weights = match draws.below(3) {
        0 => Weights::Lazy,
        1 => Weights::Vicsek,
        // `0 < c d < 1` for every degree below the number of birds.
        _ => {
            let weight = |draws: &mut Draws| rational(1 + draws.below(3) as i64, 4 * birds.max(1) as i64);
            Weights::Given(list(draws, birds, weight))
        }
    };
    let hysteresis = match draws.below(3) {
        0 => Hysteresis::None,
        1 => Hysteresis::Constant(rational(draws.below(5) as i64, 64)),
        _ => Hysteresis::Paper,
    };
    let point = |draws: &mut Draws| list(draws, dimension, |draws| fraction(draws, 3 * birds as u64, 4));
    let positions = list(draws, birds, point);
    let velocity = |draws: &mut Draws| -> Vec<Rational> {
        list(draws, dimension, |draws| fraction(draws, 8, 2) / rational(slowness, 1))
    };
    let velocities = list(draws, birds, velocity);
    Start { positions, velocities, weights, hysteresis }
}
