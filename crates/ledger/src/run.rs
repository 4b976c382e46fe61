//! What a check is given: seeded randomness, a limit of work, a place for values.

use super::{CheckError, Counterexample, Evidence, Grade, Number, Outcome, Scope, Witness};
use arithmetic::Progress;
use arithmetic::identity::{Identity, IdentityOutcome, test_identity};
use arithmetic::random::generator;
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};

/// The surroundings of the check of one form of a claim.
#[derive(Debug)]
pub struct Run {
    id: String,
    seed: String,
    full: bool,
    most_work: u64,
    work: AtomicU64,
    identities: AtomicU64,
    values: BTreeMap<String, String>,
}

/// Points at which an identity is tested.
const IDENTITY_CASES: usize = 16;

impl Run {
    /// The surroundings of a check of `id`. With `full`, checks try more cases. The check may pass `most_work` checkpoints.
    pub fn new(id: &str, seed: &str, full: bool, most_work: u64) -> Self {
        Run {
            id: id.to_string(),
            seed: seed.to_string(),
            full,
            most_work,
            work: AtomicU64::new(0),
            identities: AtomicU64::new(0),
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

    /// To be called inside long loops: it counts the work, so that the limit does not depend on the machine.
    ///
    /// # Errors
    /// [`CheckError::Limit`].
    pub fn checkpoint(&self) -> Result<(), CheckError> {
        if self.is_cancelled() { Err(CheckError::Limit) } else { Ok(()) }
    }

    /// Records a named number: `p/q`, `[lo, hi]` or `~` and a float.
    pub fn value(&mut self, name: &str, number: impl Into<String>) {
        self.values.insert(name.to_string(), number.into());
    }

    pub(super) fn into_values(self) -> BTreeMap<String, String> {
        self.values
    }

    /// Tests an identity and turns the result into an outcome with evidence for `part`; `names` are the variables.
    ///
    /// # Errors
    /// An identity that cannot be tested; [`CheckError::Limit`].
    pub fn identity<S: AsRef<str>>(
        &self,
        identity: &Identity<'_>,
        names: &[S],
        part: &str,
    ) -> Result<Outcome, CheckError> {
        let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
        self.checkpoint()?;
        let cases = self.cases(IDENTITY_CASES, 4 * IDENTITY_CASES);
        // Each identity of a check has points of its own.
        let replicate = IDENTITY_POINTS + self.identities.fetch_add(1, Ordering::Relaxed);
        Ok(match test_identity(identity, cases, &mut self.random(replicate))? {
            IdentityOutcome::Agreed { cases, degree, error_bits } => {
                let variables = if names.is_empty() { String::new() } else { format!(" in {}", names.join(", ")) };
                let detail = format!("equal at random points modulo random primes{variables}; degree at most {degree}");
                Outcome::Holds(vec![Evidence::new(Grade::Identity, part, detail).cases(cases).error_bits(error_bits)])
            }
            IdentityOutcome::Differed { at, component, left, right } => {
                let name = |k: usize| names.get(k).map_or_else(|| format!("x{}", k + 1), |name| name.to_string());
                let point: Vec<String> = (0..).zip(&at).map(|(k, x)| format!("{} = {x}", name(k))).collect();
                let named = identity.components().get(component).cloned();
                let what = named.unwrap_or_else(|| format!("component {}", component + 1));
                let values = (0..).zip(&at).map(|(k, x)| (name(k), Number::from(x))).collect();
                let witnesses = [Witness::Variables { values }, Witness::compared(&what, &left, "claimed", &right)];
                let text = format!("{part}: at {}, {what} is {left}, but {right} is claimed", point.join(", "));
                Outcome::fails(
                    Counterexample::new(text, witnesses),
                    Evidence::new(Grade::Exact, part, "the two sides differ at a rational point"),
                )
            }
        })
    }

    /// Looks at every case of a finite family: evidence of grade `exhaustive` for all of it, or the first case of which `wrong`
    /// says what is wrong.
    ///
    /// # Errors
    /// Whatever `wrong` returns; [`CheckError::Limit`].
    pub fn exhaustive<T, C: Into<Counterexample>>(
        &self,
        part: &str,
        detail: &str,
        cases: impl IntoIterator<Item = T>,
        wrong: impl FnMut(T) -> Result<Option<C>, CheckError>,
    ) -> Result<Outcome, CheckError> {
        self.every(Evidence::new(Grade::Exhaustive, part, detail).for_all(), cases, wrong)
    }

    /// Looks at instances by exact arithmetic: evidence of grade `exact`, or the first instance of which `wrong` says what is wrong.
    ///
    /// # Errors
    /// Whatever `wrong` returns; [`CheckError::Limit`].
    pub fn instances<T, C: Into<Counterexample>>(
        &self,
        part: &str,
        detail: &str,
        cases: impl IntoIterator<Item = T>,
        wrong: impl FnMut(T) -> Result<Option<C>, CheckError>,
    ) -> Result<Outcome, CheckError> {
        self.every(Evidence::new(Grade::Exact, part, detail), cases, wrong)
    }

    /// Looks at cases one by one: the evidence with their number, or the first case of which `wrong` says what is wrong.
    ///
    /// # Errors
    /// Whatever `wrong` returns; [`CheckError::Limit`].
    pub fn every<T, C: Into<Counterexample>>(
        &self,
        evidence: Evidence,
        cases: impl IntoIterator<Item = T>,
        mut wrong: impl FnMut(T) -> Result<Option<C>, CheckError>,
    ) -> Result<Outcome, CheckError> {
        let mut cases = cases.into_iter();
        let mut judged = |case: T| Ok(wrong(case)?.map(Into::into));
        count_judged(evidence, &mut || cases.next().map(|case| self.checkpoint().and_then(|()| judged(case))))
    }

    /// Runs parts in order; the evidence of all, or the first one that does not hold. After a failure the others are run all the same: those that
    /// fail too are told with it, so that it is known of each part which controls it refutes.
    ///
    /// # Errors
    /// Whatever a part returns.
    pub fn all(parts: impl IntoIterator<Item = Result<Outcome, CheckError>>) -> Result<Outcome, CheckError> {
        all_parts(&mut parts.into_iter())
    }
}

/// What `wrong` says of a case.
type Judged = Result<Option<Counterexample>, CheckError>;

/// [`Run::every`], compiled once for cases of all kinds: `next` judges one more, where there is one.
fn count_judged(evidence: Evidence, next: &mut dyn FnMut() -> Option<Judged>) -> Result<Outcome, CheckError> {
    let mut count = 0;
    while let Some(judged) = next() {
        if let Some(counterexample) = judged? {
            let grade = if evidence.grade == Grade::Exhaustive { Grade::Exact } else { evidence.grade };
            let scope = evidence.scope.map(|_| Scope::Instances);
            return Ok(Outcome::fails(counterexample, Evidence { grade, scope, ..evidence }));
        }
        count += 1;
    }
    match count {
        0 => Err(CheckError::NoCases(evidence.part)),
        _ => Ok(Outcome::Holds(vec![evidence.cases(count)])),
    }
}

/// [`Run::all`], compiled once.
fn all_parts(parts: &mut dyn Iterator<Item = Result<Outcome, CheckError>>) -> Result<Outcome, CheckError> {
    let mut evidence = Vec::new();
    while let Some(part) = parts.next() {
        match part? {
            Outcome::Holds(more) => evidence.extend(more),
            Outcome::Fails { counterexample, evidence, mut later } => {
                // What is not decided after a failure changes nothing any more.
                later.extend(parts.filter_map(Result::ok).flat_map(|part| part.failing_parts()));
                return Ok(Outcome::Fails { counterexample, evidence, later });
            }
            other => return Ok(other),
        }
    }
    Ok(Outcome::Holds(evidence))
}

/// Replicates from here on are the points of identities; checks that draw themselves use smaller ones.
const IDENTITY_POINTS: u64 = 1 << 32;

/// A check that hands its run to long work of the models stops with them.
impl Progress for Run {
    fn is_cancelled(&self) -> bool {
        self.work.fetch_add(1, Ordering::Relaxed) >= self.most_work
    }
}
