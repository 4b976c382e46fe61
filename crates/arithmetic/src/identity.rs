//! Randomised exact testing of rational identities, with an error bound.
//!
//! Two rational expressions are written once over [`Field`]. They are run over [`DegreeBound`] to bound the degree `d`
//! of the polynomial that vanishes exactly when they agree (the difference, over a common denominator), and over exact
//! rationals at random integer points from a set of `2^SET_BITS` values per variable. By the lemma of Schwartz and
//! Zippel a wrong identity survives one point with probability at most `d / 2^SET_BITS`; points where a denominator
//! vanishes are drawn again, which at most doubles that.

use super::{ArithmeticError, DegreeBound, Field, Rational};
use num_bigint::BigInt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// Each variable is drawn from the integers of absolute value below `2^(SET_BITS - 1)`.
pub const SET_BITS: u32 = 48;

/// Draws in a row that may hit a pole before the test gives up.
const LONGEST_RUN_OF_POLES: usize = 64;

/// Two sides of an identity between rational functions, written over any field.
pub trait RationalIdentity {
    /// Number of variables.
    fn variables(&self) -> usize;

    /// Both sides at a point of `variables()` coordinates, as lists of equal length (components of vectors, real and
    /// imaginary parts).
    ///
    /// # Errors
    /// [`ArithmeticError`] where the point is a pole.
    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError>;

    /// Names of the components, for messages; an empty list where there is nothing to name.
    fn components(&self) -> Vec<String> {
        Vec::new()
    }

    /// Whether a counterexample may lie at this point. It does not restrict where the identity is tested: one that holds
    /// on an open set holds everywhere.
    fn in_domain(&self, _at: &[Rational]) -> bool {
        true
    }
}

/// A [`RationalIdentity`] as the test sees it: over the two scalars that it needs. One test serves all identities.
pub trait AnyIdentity {
    /// [`RationalIdentity::variables`].
    fn variables(&self) -> usize;
    /// [`RationalIdentity::sides`] at a rational point.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the point is a pole.
    fn sides_at(&self, at: &[Rational]) -> Result<(Vec<Rational>, Vec<Rational>), ArithmeticError>;
    /// [`RationalIdentity::sides`] over degrees.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the identity has a pole everywhere.
    fn degrees(&self) -> Result<(Vec<DegreeBound>, Vec<DegreeBound>), ArithmeticError>;
    /// [`RationalIdentity::components`].
    fn components(&self) -> Vec<String>;
    /// [`RationalIdentity::in_domain`].
    fn in_domain(&self, at: &[Rational]) -> bool;
}

impl<I: RationalIdentity> AnyIdentity for I {
    fn variables(&self) -> usize {
        RationalIdentity::variables(self)
    }
    fn sides_at(&self, at: &[Rational]) -> Result<(Vec<Rational>, Vec<Rational>), ArithmeticError> {
        self.sides(at)
    }
    fn degrees(&self) -> Result<(Vec<DegreeBound>, Vec<DegreeBound>), ArithmeticError> {
        self.sides(&vec![DegreeBound::VARIABLE; RationalIdentity::variables(self)])
    }
    fn components(&self) -> Vec<String> {
        RationalIdentity::components(self)
    }
    fn in_domain(&self, at: &[Rational]) -> bool {
        RationalIdentity::in_domain(self, at)
    }
}

/// What a test of an identity found.
#[derive(Debug, Clone, PartialEq)]
pub enum IdentityOutcome {
    /// Both sides agreed at every point.
    Agreed {
        /// Number of points.
        cases: usize,
        /// Bound of the degree of the cleared difference.
        degree: u64,
        /// A wrong identity would have passed with probability at most `2^-error_bits`.
        error_bits: u64,
    },
    /// A point at which the sides differ: a proof that the identity is false.
    Differed {
        /// The point.
        at: Vec<Rational>,
        /// Index of the component that differs.
        component: usize,
        /// The component of the left side.
        left: Rational,
        /// The component of the right side.
        right: Rational,
    },
}

/// Why an identity could not be tested.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum IdentityError {
    /// Every point that was drawn is a pole.
    #[error("every random point is a pole of one of the two sides")]
    OnlyPoles,
    /// The two sides have different numbers of components.
    #[error("the two sides have {left} and {right} components")]
    Shape {
        /// Components of the left side.
        left: usize,
        /// Components of the right side.
        right: usize,
    },
    /// The degree is too large for the set the points are drawn from.
    #[error("the degree bound {0} is too large for the set of points")]
    Degree(u64),
}

/// Tests an identity at `cases` random points.
///
/// # Errors
/// [`IdentityError`] where there is nothing to test or no bound to give.
pub fn test_identity(
    identity: &dyn AnyIdentity,
    cases: usize,
    random: &mut ChaCha8Rng,
) -> Result<IdentityOutcome, IdentityError> {
    let degree = degree_of_difference(identity)?;
    let mut done = 0;
    let mut poles = 0;
    while done < cases {
        let at: Vec<Rational> = (0..identity.variables()).map(|_| random_integer(random)).collect();
        let Ok((left, right)) = identity.sides_at(&at) else {
            poles += 1;
            if poles > LONGEST_RUN_OF_POLES {
                return Err(IdentityError::OnlyPoles);
            }
            continue;
        };
        if let Some(difference) = difference(at, left, right)? {
            return Ok(small_counterexample(identity).unwrap_or(difference));
        }
        poles = 0;
        done += 1;
    }
    Ok(IdentityOutcome::Agreed { cases, degree, error_bits: error_bits(degree, cases)? })
}

fn difference(
    at: Vec<Rational>,
    left: Vec<Rational>,
    right: Vec<Rational>,
) -> Result<Option<IdentityOutcome>, IdentityError> {
    if left.len() != right.len() {
        return Err(IdentityError::Shape { left: left.len(), right: right.len() });
    }
    let component = left.iter().zip(&right).position(|(l, r)| l != r);
    Ok(component.map(|component| IdentityOutcome::Differed {
        at,
        component,
        left: left[component].clone(),
        right: right[component].clone(),
    }))
}

/// Looks for a counterexample with coordinates 1, -1, 2, -2, 3, -3, smaller ones first, in the domain of the identity.
fn small_counterexample(identity: &dyn AnyIdentity) -> Option<IdentityOutcome> {
    const VALUES: [i64; 6] = [1, -1, 2, -2, 3, -3];
    const MOST_POINTS: usize = 20_000;
    let variables = identity.variables();
    let mut tried = 0;
    for level in 1..=VALUES.len() {
        // All index vectors below `level` with `level - 1` among them.
        let mut indices = vec![0; variables];
        loop {
            if indices.contains(&(level - 1)) {
                tried += 1;
                if tried > MOST_POINTS {
                    return None;
                }
                let at: Vec<Rational> = indices.iter().map(|&k| Rational::from_integer(VALUES[k].into())).collect();
                if identity.in_domain(&at)
                    && let Ok((left, right)) = identity.sides_at(&at)
                    && let Ok(Some(found)) = difference(at, left, right)
                {
                    return Some(found);
                }
            }
            // The next index vector, the last coordinate fastest.
            let Some(position) = indices.iter().rposition(|&k| k + 1 < level) else { break };
            indices[position] += 1;
            indices[position + 1..].fill(0);
        }
    }
    None
}

/// The largest degree over all components, numerators and denominators alike: it bounds the zeros of the difference
/// and the poles.
fn degree_of_difference(identity: &dyn AnyIdentity) -> Result<u64, IdentityError> {
    let (left, right) = identity.degrees().map_err(|_| IdentityError::OnlyPoles)?;
    if left.len() != right.len() {
        return Err(IdentityError::Shape { left: left.len(), right: right.len() });
    }
    let differences = left.into_iter().zip(right).map(|(l, r)| l - r);
    Ok(differences.map(|d| d.numerator.max(d.denominator)).max().unwrap_or(0))
}

/// `floor(log2((2^SET_BITS / 2d)^cases))`, whole bits per case; the 2 pays for the points drawn again at poles.
///
/// The denominators that can vanish have at most the same degree, so with `d < 2^(SET_BITS - 1)` at least half of all
/// points are usable.
fn error_bits(degree: u64, cases: usize) -> Result<u64, IdentityError> {
    let degree_bits = u64::from(u64::BITS - degree.max(1).leading_zeros());
    let bits_per_case = u64::from(SET_BITS).checked_sub(degree_bits + 1).filter(|&bits| bits > 0);
    Ok(bits_per_case.ok_or(IdentityError::Degree(degree))? * cases as u64)
}

/// A random integer of absolute value below `2^(SET_BITS - 1)`.
fn random_integer(random: &mut ChaCha8Rng) -> Rational {
    let offset = 1i64 << (SET_BITS - 1);
    let drawn = (random.next_u64() >> (u64::BITS - SET_BITS)) as i64;
    Rational::from_integer(BigInt::from(drawn - offset))
}
