//! The randomised identity tester: true identities pass with a bound, false ones are refuted at a point.

use flockproof::arithmetic::identity::{IdentityError, IdentityOutcome, RationalIdentity, test_identity};
use flockproof::arithmetic::{ArithmeticError, Field};
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
