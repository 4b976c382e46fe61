//! The randomised identity tester: true identities pass with a bound, false ones are refuted at a point.

use arithmetic::identity::{IdentityError, IdentityOutcome, RationalIdentity, test_identity};
use arithmetic::{ArithmeticError, Dual, Field, Rational, Ring, along_flow};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// `(x³ - y³)/(x - y) = x² + c xy + y²`, true for c = 1.
struct DifferenceOfCubes(i64);

impl RationalIdentity for DifferenceOfCubes {
    fn variables(&self) -> usize {
        2
    }
    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let (x, y) = (&at[0], &at[1]);
        let left = (x.power(3) - y.power(3)).over(&(x.clone() - y))?;
        let right = x.square() + x.integer(self.0) * x * y + y.square();
        Ok((vec![left], vec![right]))
    }
}

struct AlwaysAPole;

impl RationalIdentity for AlwaysAPole {
    fn variables(&self) -> usize {
        1
    }
    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let zero = at[0].clone() - &at[0];
        Ok((vec![at[0].over(&zero)?], vec![at[0].one()]))
    }
}

/// A printed rate of change tested against the law itself: along x' = v, v' = -k x - c v the energy (v² + k x²)/2 changes
/// at the rate -factor c v², true for factor = 1.
struct EnergyRate(i64);

impl RationalIdentity for EnergyRate {
    fn variables(&self) -> usize {
        4
    }
    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [x, v, k, c] = at else { return Err(ArithmeticError::Domain("four variables")) };
        let law = [v.clone(), -(k.clone() * x) - c.clone() * v];
        let rate = along_flow(&[x.clone(), v.clone()], &law, |state| {
            let stiffness = Dual::constant(k.clone());
            Ok((state[1].square() + stiffness * state[0].square()) * state[0].ratio(1, 2))
        })?;
        Ok((vec![rate], vec![-(c.integer(self.0) * c * v.square())]))
    }
}

#[test]
fn a_printed_rate_is_tested_against_the_law() {
    let outcome = |factor| test_identity(&EnergyRate(factor), 8, &mut random()).unwrap();
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
    let outcome = test_identity(&DifferenceOfCubes(1), 8, &mut random()).unwrap();
    // Left side: degree 3 over 1; right side: degree 2; difference: max(3, 2 + 1) = 3, two bits; 48 - 2 - 1 per case.
    assert_eq!(outcome, IdentityOutcome::Agreed { cases: 8, degree: 3, error_bits: 8 * 45 });
}

#[test]
fn a_false_identity_is_refuted_at_a_point() {
    let outcome = test_identity(&DifferenceOfCubes(2), 8, &mut random()).unwrap();
    let IdentityOutcome::Differed { at, left, right, .. } = outcome else { panic!("passed: {outcome:?}") };
    let difference = right - left;
    assert_eq!(difference, at[0].clone() * &at[1]);
}

#[test]
fn poles_everywhere_are_reported() {
    assert_eq!(test_identity(&AlwaysAPole, 3, &mut random()), Err(IdentityError::OnlyPoles));
}
