//! Random numbers that depend on names only, not on threads or order.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};
use std::f64::consts::TAU;

/// A generator seeded by SHA-256 of a seed, a name and the number of the replicate.
pub fn generator(seed: &str, name: &str, replicate: u64) -> ChaCha8Rng {
    let mut hash = Sha256::new();
    hash.update(seed.as_bytes());
    hash.update([0]);
    hash.update(name.as_bytes());
    hash.update([0]);
    hash.update(replicate.to_le_bytes());
    ChaCha8Rng::from_seed(hash.finalize().into())
}

/// A number in `[0, 1)` with 53 random bits.
pub fn uniform(random: &mut impl Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// A standard normal number (Box and Muller).
pub fn normal(random: &mut impl Rng) -> f64 {
    // 1 - u is never zero.
    let radius = (-2.0 * (1.0 - uniform(random)).ln()).sqrt();
    radius * (TAU * uniform(random)).cos()
}
