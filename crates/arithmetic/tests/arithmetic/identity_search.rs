//! What the identity tester counts, draws and looks for.

use arithmetic::identity::{Identity, IdentityError, IdentityOutcome, test_identity};
use arithmetic::{ArithmeticError, Field, Probe, Rational, Residue, Ring, rational};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use std::cell::{Cell, RefCell};

fn random() -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(2)
}

/// Degree and bits of an identity that passes 2 cases.
fn bound(identity: &Identity) -> (u64, u64) {
    let outcome = test_identity(identity, 2, &mut random());
    let Ok(IdentityOutcome::Agreed { cases: 2, degree, error_bits }) = outcome else { panic!("{outcome:?}") };
    (degree, error_bits)
}

/// `x^(2^squarings)` times `x` so often, on both sides.
fn power(squarings: u32, factors: u32) -> Identity<'static> {
    Identity::of(move |[x]| {
        let squared = (0..squarings).fold(x.clone(), |power, _| power.clone() * power);
        let side = (0..factors).fold(squared, |product, _| product * x);
        Ok((vec![side.clone()], vec![side]))
    })
}

#[test]
fn bounds_of_powers_quotients_and_constants() {
    // Degree k and one bit: k + 4 zeros at most, rounded up to a power of two, of 2^59 primes and points.
    assert_eq!(bound(&power(2, 0)), (4, 2 * 56));
    assert_eq!(bound(&power(2, 1)), (5, 2 * 55));
    assert_eq!(bound(&power(57, 0)), (1 << 57, 2));
    assert_eq!(test_identity(&power(58, 0), 2, &mut random()), Err(IdentityError::Degree(1 << 58)));
    let quotient = Identity::of(|[x]| {
        let side = (x.clone() * x * x).recip()?;
        Ok((vec![side.clone()], vec![side]))
    });
    assert_eq!(bound(&quotient).0, 6);
    let constant = Identity::of(|[x]| Ok((vec![x.integer(3)], vec![x.integer(3)])));
    assert_eq!(bound(&constant).0, 0);
    // The largest of all components, wherever it stands.
    for (first, second) in [(5, 1), (1, 5)] {
        let two = Identity::of(move |[x]| {
            let both = [first, second].map(|k| (1..k).fold(x.clone(), |product, _| product * x)).to_vec();
            Ok((both.clone(), both))
        });
        assert_eq!(bound(&two), (5, 2 * 55));
    }
}

#[test]
fn sides_of_different_lengths_are_refused() {
    let uneven = Identity::of(|[x]| Ok((vec![x.clone(), x.clone()], vec![x.clone()])));
    for cases in [0, 3] {
        let refused = Err(IdentityError::Shape { left: 2, right: 1 });
        assert_eq!(test_identity(&uneven, cases, &mut random()), refused);
    }
}

/// As many residues as asked for, poles apart: the first `poles` calls, and as many after the first case.
fn with_poles(poles: usize) -> (Result<IdentityOutcome, IdentityError>, usize) {
    let (run, good) = (Cell::new(0), Cell::new(0));
    let identity = Identity::of(|[x]| {
        if matches!(x, Probe::Residue(_)) {
            run.set(run.get() + 1);
            if run.get() <= poles {
                return Err(ArithmeticError::DivisionByZero);
            }
            run.set(0);
            good.set(good.get() + 1);
        }
        Ok((vec![x.clone()], vec![x.clone()]))
    });
    let outcome = test_identity(&identity, 5, &mut random());
    (outcome, good.get())
}

#[test]
fn cases_and_runs_of_poles_are_counted() {
    for poles in [0, 1, 64] {
        let (outcome, good) = with_poles(poles);
        assert!(outcome.is_ok() && good == 5, "{poles}: {outcome:?}, {good}");
    }
    assert_eq!(with_poles(65), (Err(IdentityError::OnlyPoles), 0));
}

fn point(outcome: Result<IdentityOutcome, IdentityError>) -> (Vec<Rational>, usize) {
    let Ok(IdentityOutcome::Differed { at, component, left, right }) = outcome else { panic!("{outcome:?}") };
    assert_ne!(left, right);
    (at, component)
}

fn integers(list: &[i64]) -> Vec<Rational> {
    list.iter().map(|&n| rational(n, 1)).collect()
}

#[test]
fn the_first_small_point_that_differs_is_found() {
    let product = Identity::of(|[x, y]| {
        let one = x.one();
        Ok((vec![(x.square() - &one) * (y.clone() - one)], vec![x.integer(0)]))
    });
    assert_eq!(point(test_identity(&product, 3, &mut random())), (integers(&[2, -1]), 0));
    // Points in the domain only, each coordinate up to 3 in absolute value.
    let sum = || Identity::of(|[x, y]| Ok((vec![x.clone(), x.clone() + y], vec![x.clone(), x.clone()])));
    let at = |domain| point(test_identity(&sum().within(domain), 3, &mut random()));
    assert_eq!(at(|at| at[0] == rational(3, 1)), (integers(&[3, 1]), 1));
    assert_eq!(at(|at| at[1] == rational(-3, 1)), (integers(&[1, -3]), 1));
    assert_eq!(at(|at| at[0] == rational(-2, 1) && at[1] == rational(2, 1)), (integers(&[-2, 2]), 1));
    // Of two components that differ the first is named.
    let both = Identity::of(|[x]| Ok((vec![x.clone(), x.clone()], vec![x.integer(7), x.integer(8)])));
    assert_eq!(point(test_identity(&both, 3, &mut random())).1, 0);
}

/// The residues that are drawn are as often above half of the prime as below, and of all remainders modulo 8.
#[test]
fn residues_are_drawn_evenly() {
    let drawn = RefCell::new(Vec::<Residue>::new());
    let identity = Identity::new(200, |at: &[Probe]| {
        drawn.borrow_mut().extend(at.iter().filter_map(|x| match x {
            Probe::Residue(x) => Some(*x),
            _ => None,
        }));
        Ok((vec![at[0].clone()], vec![at[0].clone()]))
    });
    assert!(test_identity(&identity, 50, &mut random()).is_ok());
    drop(identity);
    let drawn = drawn.into_inner();
    assert_eq!(drawn.len(), 10_000);
    // Above half: 2x wraps around, so that it is odd as an integer (the prime is odd).
    let above = drawn.iter().filter(|x| (**x + **x).value() % 2 == 1).count();
    assert!((4800..5200).contains(&above), "{above}");
    let mut remainders = [0; 8];
    drawn.iter().for_each(|x| remainders[(x.value() % 8) as usize] += 1);
    assert!(remainders.iter().all(|count| (1100..1400).contains(count)), "{remainders:?}");
}

#[test]
fn ratios_are_of_the_kind_of_the_probe() {
    let residue = Residue::new(5, 101).unwrap();
    assert_eq!(Probe::Residue(residue).ratio(3, 7), Probe::Residue(residue.rational(&rational(3, 7))));
    let exact = Probe::Exact(rational(1, 2));
    assert_eq!((exact.ratio(3, 7), exact.exact()), (Probe::Exact(rational(3, 7)), Some(&rational(1, 2))));
    assert_eq!(Probe::Residue(residue).exact(), None);
}

#[test]
fn residues_need_a_prime() {
    for modulus in [0, 1, 4, 91, u64::MAX] {
        assert_eq!(Residue::new(3, modulus), Err(ArithmeticError::Domain("a prime modulus")), "{modulus}");
    }
}

#[test]
fn the_residue_zero_has_no_inverse() {
    let zero = Residue::new(0, (1 << 61) - 1).unwrap();
    assert!(zero.recip().is_err() && -zero == zero && zero.integer(0) == zero);
}
