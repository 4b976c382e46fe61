//! What a check is given: seeded randomness, a deadline, a place for values.

use super::{CheckError, Evidence, Grade, Outcome};
use crate::arithmetic::identity::{IdentityOutcome, RationalIdentity, test_identity};
use crate::simulate::generator;
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// The surroundings of one check.
#[derive(Debug)]
pub struct Run {
    id: String,
    seed: String,
    full: bool,
    deadline: Option<Instant>,
    values: BTreeMap<String, String>,
}

/// Points at which an identity is tested.
const IDENTITY_CASES: usize = 16;

impl Run {
    /// The surroundings of the check of `id`. With `full`, checks try more cases.
    pub fn new(id: &str, seed: &str, full: bool, limit: Option<Duration>) -> Self {
        Run {
            id: id.to_string(),
            seed: seed.to_string(),
            full,
            deadline: limit.map(|limit| Instant::now() + limit),
            values: BTreeMap::new(),
        }
    }

    /// A generator whose seed depends on the seed of the run, the id of the claim and the replicate only.
    pub fn random(&self, replicate: u64) -> ChaCha8Rng {
        generator(&self.seed, &self.id, replicate)
    }

    /// `few` cases in an ordinary run, `many` in a full one.
    pub fn cases(&self, few: usize, many: usize) -> usize {
        if self.full { many } else { few }
    }

    /// To be called inside long loops.
    ///
    /// # Errors
    /// [`CheckError::OutOfTime`].
    pub fn checkpoint(&self) -> Result<(), CheckError> {
        match self.deadline {
            Some(deadline) if Instant::now() > deadline => Err(CheckError::OutOfTime),
            _ => Ok(()),
        }
    }

    /// Records a named number: `p/q`, `[lo, hi]` or `~` and a float.
    pub fn value(&mut self, name: &str, number: impl Into<String>) {
        self.values.insert(name.to_string(), number.into());
    }

    pub(super) fn take_values(&mut self) -> BTreeMap<String, String> {
        std::mem::take(&mut self.values)
    }

    /// Tests an identity and turns the result into an outcome with evidence for `part`; `names` are the variables.
    ///
    /// # Errors
    /// [`CheckError::Identity`] where the identity cannot be tested.
    pub fn identity(
        &self,
        identity: &impl RationalIdentity,
        names: &[&str],
        part: &str,
    ) -> Result<Outcome, CheckError> {
        self.checkpoint()?;
        let cases = self.cases(IDENTITY_CASES, 4 * IDENTITY_CASES);
        // Each part has points of its own.
        let replicate = part.bytes().fold(0u64, |sum, byte| sum.wrapping_mul(131).wrapping_add(u64::from(byte)));
        Ok(match test_identity(identity, cases, &mut self.random(replicate))? {
            IdentityOutcome::Agreed { cases, degree, error_bits } => {
                let detail = format!("equal at random integer points in {}; degree at most {degree}", names.join(", "));
                Outcome::Holds(vec![Evidence::new(Grade::Identity, part, detail).cases(cases).error_bits(error_bits)])
            }
            IdentityOutcome::Differed { at, component, left, right } => {
                let point: Vec<String> = names.iter().zip(&at).map(|(name, x)| format!("{name} = {x}")).collect();
                let named = identity.components().into_iter().nth(component);
                let what = named.unwrap_or_else(|| format!("component {}", component + 1));
                Outcome::fails(
                    format!("{part}: at {}, {what} is {left}, but {right} is claimed", point.join(", ")),
                    Evidence::new(Grade::Exact, part, "the two sides differ at a rational point"),
                )
            }
        })
    }

    /// Runs parts in order; the evidence of all, or the first one that does not hold.
    ///
    /// # Errors
    /// Whatever a part returns.
    pub fn all(parts: impl IntoIterator<Item = Result<Outcome, CheckError>>) -> Result<Outcome, CheckError> {
        let mut evidence = Vec::new();
        for part in parts {
            match part? {
                Outcome::Holds(more) => evidence.extend(more),
                other => return Ok(other),
            }
        }
        Ok(Outcome::Holds(evidence))
    }
}
