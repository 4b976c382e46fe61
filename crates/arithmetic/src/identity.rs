//! Randomised exact testing of rational identities, with an error bound.
//!
//! Two rational expressions are written once over [`Probe`]. They are run over [`DegreeBound`], which bounds the degree `d` and the bits `h` of the
//! coefficients of the polynomial that vanishes exactly when they agree (the numerator of the difference, over the integers), and then modulo
//! random primes at random points.
//!
//! **Error bound.** Let that polynomial not be zero. A prime between 2^60 and 2^61 that divides all its coefficients divides one that is not zero, and at most
//! `h/60` of them do; there are at least `3·2^60/(5 ln 2^60) > 2^53` such primes (Rosser and Schoenfeld 1962), so a random one does so
//! with probability at most `h/(60·2^53) < h·2^-58`. For any other prime a random point is a zero with probability at most `d·2^-60` (Schwartz and
//! Zippel). Points where a denominator vanishes are drawn again with a new prime, which at most doubles the sum. So a wrong identity survives
//! one case with probability at most `(d + 4h)·2^-59`, and all of them with the power of that.

use super::residue::{Residue, random_prime};
use super::{ArithmeticError, DegreeBound, Probe, Rational, Ring};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// `-log2` of the probability that a case misses a polynomial with `d + 4h = 1`.
const CASE_BITS: u32 = 59;

/// Draws in a row that may hit a pole before the test gives up.
const LONGEST_RUN_OF_POLES: usize = 64;

/// Both sides of an identity at a point, as lists of equal length.
pub type Sides<T> = (Vec<T>, Vec<T>);

/// Both sides over the scalars of the test, or why the point is a pole.
pub type Probed = Result<Sides<Probe>, ArithmeticError>;

/// Both sides as a function of the variables.
type SidesAt<'a> = Box<dyn Fn(&[Probe]) -> Probed + 'a>;

/// An identity between rational functions, written as a closure.
///
/// ```
/// use flockproof_arithmetic::identity::{Identity, IdentityOutcome, test_identity};
/// use flockproof_arithmetic::{Ring, random::generator};
/// let square = Identity::of(|[x, y]| {
///     let sum = x.clone() + y;
///     Ok((vec![sum.square()], vec![x.square() + x.integer(2) * x * y + y.square()]))
/// });
/// let found = test_identity(&square, 8, &mut generator("seed", "square", 0)).unwrap();
/// assert!(matches!(found, IdentityOutcome::Agreed { cases: 8, .. }));
/// ```
pub struct Identity<'a> {
    variables: usize,
    sides: SidesAt<'a>,
    components: Vec<String>,
    domain: fn(&[Rational]) -> bool,
}

impl<'a> Identity<'a> {
    /// An identity in so many variables.
    pub fn new(variables: usize, sides: impl Fn(&[Probe]) -> Probed + 'a) -> Self {
        Identity { variables, sides: Box::new(sides), components: Vec::new(), domain: |_| true }
    }

    /// An identity in `N` variables, which are the argument.
    pub fn of<const N: usize>(sides: impl Fn(&[Probe; N]) -> Probed + 'a) -> Self {
        let number = |_| ArithmeticError::Domain("as many numbers as the identity has variables");
        Self::new(N, move |at| sides(at.try_into().map_err(number)?))
    }

    /// The same with names of the components, for messages.
    pub fn named(self, components: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Identity { components: components.into_iter().map(Into::into).collect(), ..self }
    }

    /// The same where a counterexample may lie in this domain only. It does not restrict where the identity is tested: one that holds on an
    /// open set holds everywhere.
    pub fn within(self, domain: fn(&[Rational]) -> bool) -> Self {
        Identity { domain, ..self }
    }

    /// Number of variables.
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Names of the components; an empty list where there is nothing to name.
    pub fn components(&self) -> &[String] {
        &self.components
    }

    /// Both sides at a rational point.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the point is a pole.
    pub fn at(&self, point: &[Rational]) -> Result<Sides<Rational>, ArithmeticError> {
        let exact = |list: Vec<Probe>| list.iter().filter_map(Probe::exact).cloned().collect();
        let (left, right) = (self.sides)(&point.iter().cloned().map(Probe::Exact).collect::<Vec<_>>())?;
        Ok((exact(left), exact(right)))
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
    #[error("the degree bound {0} and the coefficients are too large for the set of points")]
    Degree(u64),
}

/// Tests an identity at `cases` random points.
///
/// # Errors
/// [`IdentityError`] where there is nothing to test or no bound to give.
pub fn test_identity(
    identity: &Identity<'_>,
    cases: usize,
    random: &mut ChaCha8Rng,
) -> Result<IdentityOutcome, IdentityError> {
    let bound = bound_of_difference(identity)?;
    let error_bits = case_bits(bound)? * cases as u64;
    let mut done = 0;
    let mut poles = 0;
    while done < cases {
        let prime = random_prime(random);
        let at: Vec<Residue> = (0..identity.variables).map(|_| random_residue(prime, random)).collect();
        let probes: Vec<Probe> = at.iter().map(|&x| Probe::Residue(x)).collect();
        let Ok(sides) = (identity.sides)(&probes) else {
            poles += 1;
            if poles > LONGEST_RUN_OF_POLES {
                return Err(IdentityError::OnlyPoles);
            }
            continue;
        };
        if differing(&sides)?.is_some() {
            let whole: Vec<Rational> = at.iter().map(|x| Rational::from_integer(x.value().into())).collect();
            let found = small_counterexample(identity, prime).or_else(|| exact_difference(identity, whole));
            // The sides differ modulo the prime, so they differ at these integers, where no denominator vanishes.
            return found.ok_or(IdentityError::OnlyPoles);
        }
        poles = 0;
        done += 1;
    }
    Ok(IdentityOutcome::Agreed { cases, degree: bound.numerator.max(bound.denominator), error_bits })
}

/// The first component that differs.
fn differing(sides: &Sides<Probe>) -> Result<Option<usize>, IdentityError> {
    let (left, right) = (sides.0.len(), sides.1.len());
    if left != right {
        return Err(IdentityError::Shape { left, right });
    }
    Ok(sides.0.iter().zip(&sides.1).position(|(l, r)| l != r))
}

/// The difference at a rational point, if there is one.
fn exact_difference(identity: &Identity<'_>, at: Vec<Rational>) -> Option<IdentityOutcome> {
    let probes: Vec<Probe> = at.iter().cloned().map(Probe::Exact).collect();
    let sides = (identity.sides)(&probes).ok()?;
    let component = differing(&sides).ok()??;
    let (Probe::Exact(left), Probe::Exact(right)) = (&sides.0[component], &sides.1[component]) else { return None };
    Some(IdentityOutcome::Differed { at, component, left: left.clone(), right: right.clone() })
}

/// Looks for a counterexample with coordinates 1, -1, 2, -2, 3, -3, smaller ones first, in the domain of the identity. Points are tried modulo
/// the prime first.
fn small_counterexample(identity: &Identity<'_>, prime: u64) -> Option<IdentityOutcome> {
    const VALUES: [i64; 6] = [1, -1, 2, -2, 3, -3];
    const MOST_POINTS: usize = 20_000;
    let residues = VALUES.map(|x| Probe::Residue(Residue::modulo(0, prime)).integer(x));
    let mut tried = 0;
    for level in 1..=VALUES.len() {
        // All index vectors below `level` with `level - 1` among them.
        let mut indices = vec![0; identity.variables];
        loop {
            if indices.contains(&(level - 1)) {
                tried += 1;
                if tried > MOST_POINTS {
                    return None;
                }
                let probes: Vec<Probe> = indices.iter().map(|&k| residues[k].clone()).collect();
                let differs = (identity.sides)(&probes).is_ok_and(|sides| differing(&sides).is_ok_and(|d| d.is_some()));
                let at: Vec<Rational> = indices.iter().map(|&k| Rational::from_integer(VALUES[k].into())).collect();
                if differs
                    && (identity.domain)(&at)
                    && let Some(found) = exact_difference(identity, at)
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

/// The largest bounds over all components, numerators and denominators alike: they bound the zeros of the difference
/// and the poles.
fn bound_of_difference(identity: &Identity<'_>) -> Result<DegreeBound, IdentityError> {
    let variables = vec![Probe::Degree(DegreeBound::VARIABLE); identity.variables];
    let sides = (identity.sides)(&variables).map_err(|_| IdentityError::OnlyPoles)?;
    differing(&sides)?;
    let mut largest = DegreeBound::constant(0, 0);
    for (left, right) in sides.0.into_iter().zip(sides.1) {
        let Probe::Degree(bound) = left - right else { return Err(IdentityError::Degree(u64::MAX)) };
        largest.numerator = largest.numerator.max(bound.numerator).max(bound.denominator);
        largest.numerator_bits = largest.numerator_bits.max(bound.numerator_bits).max(bound.denominator_bits);
    }
    Ok(largest)
}

/// Whole bits by which one case bounds the probability that a wrong identity passes.
fn case_bits(bound: DegreeBound) -> Result<u64, IdentityError> {
    let sum = bound.numerator_bits.saturating_mul(4).saturating_add(bound.numerator).max(1);
    let lost = u64::BITS - (sum - 1).leading_zeros();
    let bits = CASE_BITS.checked_sub(lost).filter(|&bits| bits > 0);
    Ok(u64::from(bits.ok_or(IdentityError::Degree(bound.numerator))?))
}

/// Uniform modulo the prime.
fn random_residue(prime: u64, random: &mut ChaCha8Rng) -> Residue {
    loop {
        let drawn = random.next_u64() >> 3;
        if drawn < prime {
            return Residue::modulo(drawn, prime);
        }
    }
}
