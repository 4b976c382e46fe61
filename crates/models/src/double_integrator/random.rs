//! Random flocks.

use super::State;
use arithmetic::random::uniform;
use rand_chacha::ChaCha8Rng;

/// A random flock: positions even in the square `|x|, |y| < half`, speeds even in `(0, speed)`, directions even.
pub fn random_flock(count: usize, half: f64, speed: f64, random: &mut ChaCha8Rng) -> State<f64> {
    let mut even = || uniform(random);
    let positions = (0..count).map(|_| [half * (2.0 * even() - 1.0), half * (2.0 * even() - 1.0)]).collect();
    let velocities = (0..count)
        .map(|_| {
            let (size, angle) = (speed * even(), 2.0 * std::f64::consts::PI * even());
            [size * angle.cos(), size * angle.sin()]
        })
        .collect();
    State { positions, velocities }
}
