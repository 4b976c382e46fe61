//! Random flocks.

use crate::double_integrator::laws::{State, Vector};
use arithmetic::random::uniform;
use arithmetic::{Rational, rational};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

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

/// Random vectors with coordinates of absolute value at most 5 and denominators 1 to 4.
pub fn random_vectors(count: usize, random: &mut ChaCha8Rng) -> Vec<Vector<Rational>> {
    let mut coordinate = || {
        let denominator = i64::from(random.next_u32() % 4) + 1;
        rational(i64::from(random.next_u32() % (10 * denominator as u32 + 1)) - 5 * denominator, denominator)
    };
    (0..count).map(|_| [coordinate(), coordinate()]).collect()
}
