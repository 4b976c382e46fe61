//! Random numbers depend on the seed, the name and the replicate, and have the distribution they are said to have.

use arithmetic::random::{generator, normal, uniform};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};

#[test]
fn the_seed_is_the_digest_of_the_names() {
    let bytes = b"seed\0name\0\x07\0\0\0\0\0\0\0";
    let mut twin = ChaCha8Rng::from_seed(Sha256::digest(bytes).into());
    let drawn = twin.next_u64();
    assert_eq!(generator("seed", "name", 7).next_u64(), drawn);
    let share = uniform(&mut generator("seed", "name", 7));
    assert!(share < 1.0 && share * 2f64.powi(53) == (drawn / 2048) as f64);
}

#[test]
fn normal_numbers_have_the_moments_of_the_normal_distribution() {
    let mut random = generator("seed", "normal", 0);
    const COUNT: usize = 40_000;
    let drawn: Vec<f64> = (0..COUNT).map(|_| normal(&mut random)).collect();
    let moment = |k: i32| drawn.iter().map(|x| x.powi(k)).sum::<f64>() / COUNT as f64;
    for (k, expected, error) in [(1, 0.0, 0.02), (2, 1.0, 0.03), (3, 0.0, 0.08), (4, 3.0, 0.2)] {
        assert!((moment(k) - expected).abs() < error, "moment {k}: {}", moment(k));
    }
}
