//! The randomised identity tester: true identities pass with a bound, false ones are refuted at a point.

use arithmetic::identity::{Identity, IdentityError, IdentityOutcome, test_identity};
use arithmetic::{Dual, Field, Rational, Residue, Ring, along_flow, is_prime, random_prime};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// `(x³ - y³)/(x - y) = x² + c xy + y²`, true for c = 1.
fn difference_of_cubes(c: i64) -> Identity<'static> {
    Identity::of(move |[x, y]| {
        let left = (x.power(3) - y.power(3)).over(&(x.clone() - y))?;
        let right = x.square() + x.integer(c) * x * y + y.square();
        Ok((vec![left], vec![right]))
    })
}

fn always_a_pole() -> Identity<'static> {
    Identity::of(|[x]| Ok((vec![x.over(&(x.clone() - x))?], vec![x.one()])))
}

/// A printed rate of change tested against the law itself: along x' = v, v' = -k x - c v the energy (v² + k x²)/2 changes
/// at the rate -factor c v², true for factor = 1.
fn energy_rate(factor: i64) -> Identity<'static> {
    Identity::of(move |[x, v, k, c]| {
        let law = [v.clone(), -(k.clone() * x) - c.clone() * v];
        let rate = along_flow(&[x.clone(), v.clone()], &law, |state| {
            let stiffness = Dual::constant(k.clone());
            Ok((state[1].square() + stiffness * state[0].square()) * state[0].ratio(1, 2))
        })?;
        Ok((vec![rate], vec![-(c.integer(factor) * c * v.square())]))
    })
}

#[test]
fn a_printed_rate_is_tested_against_the_law() {
    let outcome = |factor| test_identity(&energy_rate(factor), 8, &mut random()).unwrap();
    assert!(matches!(outcome(1), IdentityOutcome::Agreed { error_bits: 300.., .. }));
    // The smallest point at which the altered rate fails.
    let IdentityOutcome::Differed { at, .. } = outcome(2) else { panic!("the altered rate passed") };
    assert_eq!(
        at,
        vec![1.into(), 1.into(), 1.into(), 1.into()].into_iter().map(Rational::from_integer).collect::<Vec<_>>()
    );
}

fn random() -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(1)
}

#[test]
fn a_true_identity_passes_with_a_bound() {
    let outcome = test_identity(&difference_of_cubes(1), 8, &mut random()).unwrap();
    // Left side: degree 3 over 1, (x³ - y³)/(x - y) with one bit each; right side: degree 2, 1 + 1 + 1 with the constant 1 of one bit, three bits;
    // difference: max(3, 2 + 1) = 3 and max(1, 3 + 1) + 1 = 5 bits; 3 + 4·5 = 23 < 2^5; 59 - 5 per case.
    assert_eq!(outcome, IdentityOutcome::Agreed { cases: 8, degree: 3, error_bits: 8 * 54 });
}

#[test]
fn a_false_identity_is_refuted_at_a_point() {
    let outcome = test_identity(&difference_of_cubes(2), 8, &mut random()).unwrap();
    let IdentityOutcome::Differed { at, left, right, .. } = outcome else { panic!("passed: {outcome:?}") };
    let difference = right - left;
    assert_eq!(difference, at[0].clone() * &at[1]);
}

#[test]
fn poles_everywhere_are_reported() {
    assert_eq!(test_identity(&always_a_pole(), 3, &mut random()), Err(IdentityError::OnlyPoles));
}

/// Residues against remainders of integers.
#[test]
fn residues_are_remainders() {
    let mut random = random();
    for _ in 0..50 {
        let p = random_prime(&mut random);
        assert!((1 << 60..1 << 61).contains(&p) && is_prime(p));
        let (a, b) = (random.next_u64(), random.next_u64() >> 1);
        let (x, y) = (Residue::new(a, p).unwrap(), Residue::new(b, p).unwrap());
        let wide = |n: u128| (n % u128::from(p)) as u64;
        assert_eq!((x * y).value(), wide(u128::from(a % p) * u128::from(b % p)));
        assert_eq!((x + y).value(), wide(u128::from(a) + u128::from(b)));
        assert_eq!((x - y) + y, x);
        assert_eq!(y.recip().unwrap() * y, y.one());
        let q = Rational::new((b as i64).into(), (-3).into());
        assert_eq!(x.rational(&q) * x.integer(-3), y);
        assert_eq!(x.ratio(5, -7) * x.integer(7), x.integer(-5));
    }
}

/// Of forty, some in each quarter of the range, and of each remainder that an odd number leaves modulo 8.
#[test]
fn random_primes_are_from_the_whole_range() {
    let mut random = random();
    let drawn: Vec<u64> = (0..40).map(|_| random_prime(&mut random)).collect();
    assert!((4..8).all(|quarter| drawn.iter().any(|p| p >> 58 == quarter)));
    assert!([1, 3, 5, 7].iter().all(|rest| drawn.iter().any(|p| p % 8 == *rest)));
}

#[test]
fn small_primes_and_strong_pseudoprimes_are_told_apart() {
    let naive = |n: u64| n > 1 && (2..n).take_while(|d| d * d <= n).all(|d| !n.is_multiple_of(d));
    assert!((0..2000).all(|n| is_prime(n) == naive(n)));
    for composite in [3_215_031_751, 3_825_123_056_546_413_051] {
        assert!(!is_prime(composite), "{composite}");
    }
    assert!(is_prime((1 << 61) - 1));
}
