//! Equations that hold at every state, by random primes; roots and other functions count as numbers of which nothing is known.

use super::instance::{Instance, Links, Side, value_of};
use arithmetic::identity::{Identity, IdentityOutcome, test_identity};
use arithmetic::random::generator;
use arithmetic::{ArithmeticError, Field, Probe, Rational, Ring, rational};
use expressions::Comparison;

/// Points of a test.
const CASES: usize = 8;

/// Whether two lists of functions of the free numbers of a state agree identically: the bits by which a wrong identity is less likely than 1.
///
/// Besides the bound of the test, arguments of functions that differ may agree at a random point, one of at most `functions²` pairs.
pub(super) fn agree(
    instance: &Instance,
    functions: u64,
    sides: impl Fn(&[Probe]) -> Result<(Vec<Probe>, Vec<Probe>), ArithmeticError>,
) -> Option<u64> {
    let free: Vec<usize> =
        (0..instance.sides.len()).filter(|&k| !matches!(instance.sides[k], Side::Point(_))).collect();
    if free.is_empty() {
        return None;
    }
    let at = |numbers: &[Probe]| -> Vec<Probe> {
        let like = &numbers[0];
        let number = |side: &Side| match side {
            Side::Point(q) => like.rational(q),
            _ => like.zero(),
        };
        let mut state: Vec<Probe> = instance.sides.iter().map(number).collect();
        free.iter().zip(numbers).for_each(|(&place, number)| state[place] = number.clone());
        state
    };
    let identity = Identity::new(free.len(), |numbers| sides(&at(numbers)));
    match test_identity(&identity, CASES, &mut generator("question", "states", 0)) {
        Ok(IdentityOutcome::Agreed { error_bits, .. }) => {
            let lost = CASES as u64 * (1 + 2 * u64::from(u64::BITS - functions.leading_zeros()));
            error_bits.checked_sub(lost).filter(|bits| *bits >= 64)
        }
        _ => None,
    }
}

/// Whether a number is 0 at every state.
pub(super) fn vanishes(instance: &Instance, comparison: &Comparison) -> Option<u64> {
    let functions = comparison.functions(instance.of_agent.len());
    agree(instance, functions, |state| {
        let value = value_of(comparison, &instance.links, state)?;
        let zero = value.zero();
        Ok((vec![value], vec![zero]))
    })
}

/// A number as a multiple of the sum of its values on networks of one pair each, each of which depends on the states of the two only: the factor and the
/// bits of the test.
pub(super) fn sum_over_pairs(
    instance: &Instance,
    comparison: &Comparison,
    pairs: &[((usize, usize), Links)],
) -> Option<(Rational, u64)> {
    let agents = instance.of_agent.len();
    let functions = comparison.functions(agents).saturating_mul(2 * pairs.len() as u64 + 1);
    let others = agents.saturating_sub(1).max(1) as i64;
    [rational(1, 1), rational(1, others)].into_iter().find_map(|factor| {
        let bits = agree(instance, functions, |state| {
            let whole = value_of(comparison, &instance.links, state)?;
            let (mut left, mut right) = (Vec::new(), Vec::new());
            let mut sum = whole.zero();
            for ((i, j), links) in pairs {
                let part = value_of(comparison, links, state)?;
                sum = sum + &part;
                // The others might be anywhere.
                let mut alone = state.to_vec();
                for (agent, places) in instance.of_agent.iter().enumerate() {
                    if agent != *i && agent != *j {
                        places.iter().for_each(|&place| alone[place] = part.zero());
                    }
                }
                left.push(part);
                right.push(value_of(comparison, links, &alone)?);
            }
            left.push(whole);
            right.push(sum.clone() * sum.rational(&factor));
            Ok((left, right))
        });
        bits.map(|bits| (factor.clone(), bits))
    })
}
