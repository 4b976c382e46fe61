//! Starts that several statements are tried on: the example of the paper, and random ones.

use super::flock::Start;
use super::hysteresis::Hysteresis;
use super::weights::Weights;
use arithmetic::{Rational, rational};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

fn either(first: bool) -> Weights {
    if first { Weights::Lazy } else { Weights::Vicsek }
}

impl Start {
    /// The four birds on the line of the paper (Chazelle, section 3, Soundness of the hysteresis rule), whose network alternates for ever
    /// without hysteresis.
    pub fn four_birds(hysteresis: Hysteresis) -> Self {
        let over = |list: [i64; 4], unit: i64| list.map(|x| rational(x, unit)).to_vec();
        Start::on_the_line(over([0, 8, 21, 29], 16), over([1, -1, 1, -1], 8), Weights::Lazy, hysteresis)
    }

    /// A crowded flock of 2 to 5 birds in dimension 1 to 3, lazy or vicsek.
    pub fn random(hysteresis: Hysteresis, random: &mut ChaCha8Rng) -> Self {
        let mut below = |bound: i64| i64::from(random.next_u32()) % bound;
        let (n, dimension) = (2 + below(4), 1 + below(3));
        let mut vectors = |range: i64, shift: i64, unit: i64| -> Vec<Vec<Rational>> {
            (0..n).map(|_| (0..dimension).map(|_| rational(below(range) - shift, unit)).collect()).collect()
        };
        let (positions, velocities) = (vectors(40, 0, 16), vectors(13, 6, 48));
        Start { positions, velocities, weights: either(below(2) == 0), hysteresis }
    }

    /// A flock of 2 to 5 birds on the line with the hysteresis of the paper, near enough to meet, lazy or vicsek.
    pub fn random_on_the_line(random: &mut ChaCha8Rng) -> Self {
        let mut below = |bound: i64| i64::from(random.next_u32()) % bound;
        let n = 2 + below(4);
        let positions = (0..n).map(|i| rational(12 * i + below(9), 16)).collect();
        let velocities = (0..n).map(|_| rational(below(17) - 8, 16)).collect();
        Start::on_the_line(positions, velocities, either(below(2) == 0), Hysteresis::Paper)
    }
}
