//! Equations that hold at every state, by random primes; roots and other functions count as numbers of which nothing is known.

use super::instance::{Instance, Links, filled, trail_of, value_of};
use arithmetic::identity::{Identity, IdentityOutcome, Sides, test_identity};
use arithmetic::random::generator;
use arithmetic::{ArithmeticError, Field, Probe, Rational, Ring, rational, simplest_between};
use expressions::Comparison;
use num_traits::Signed;

/// Points of a test.
const CASES: u64 = 8;

/// Fewer bits are not enough.
const LEAST_BITS: u64 = 64;

/// Whether two lists of functions of so many numbers agree identically: the bits by which a wrong identity is less likely than 1.
///
/// Besides the bound of the test, arguments of functions that differ may agree at a random point. Of `functions` there are less than `functions²/2` pairs,
/// and the bound of the whole is at least half of that of a difference of two arguments; so each case is missed at most `1 + functions²` times as often.
pub(super) fn agree(
    numbers: usize,
    functions: u64,
    sides: impl Fn(&[Probe]) -> Result<Sides<Probe>, ArithmeticError>,
) -> Option<u64> {
    if numbers == 0 {
        return None;
    }
    let identity = Identity::new(numbers, sides);
    match test_identity(&identity, CASES as usize, &mut generator("question", "states", 0)) {
        Ok(IdentityOutcome::Agreed { error_bits, .. }) => {
            let lost = CASES * (1 + 2 * u64::from(u64::BITS - functions.leading_zeros()));
            error_bits.checked_sub(lost).filter(|bits| *bits >= LEAST_BITS)
        }
        _ => None,
    }
}

/// Whether a number is 0 at every state.
pub(super) fn vanishes(instance: &Instance, comparison: &Comparison) -> Option<u64> {
    let (free, functions) = (instance.free(), comparison.functions(instance.of_agent.len()));
    agree(free.len(), functions, |numbers| {
        let value = value_of(comparison, &instance.links, &filled(&instance.sides, &free, numbers))?;
        let zero = value.zero();
        Ok((vec![value], vec![zero]))
    })
}

/// Whether a number stays as it is, and has a value as before, where these numbers of the state are moved by one and the same amount.
pub(super) fn is_invariant(
    instance: &Instance,
    comparison: &Comparison,
    links: &Links,
    column: &[usize],
) -> Option<u64> {
    let (free, functions) = (instance.free(), comparison.functions(instance.of_agent.len()));
    agree(free.len() + 1, 2 * functions, |numbers| {
        let (by, numbers) = numbers.split_last().ok_or(ArithmeticError::Domain("a number"))?;
        let state = filled(&instance.sides, &free, numbers);
        let mut moved = state.clone();
        column.iter().for_each(|&place| moved[place] = moved[place].clone() + by);
        Ok((trail_of(comparison, links, &state)?, trail_of(comparison, links, &moved)?))
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
    let free = instance.free();
    let others = agents.saturating_sub(1).max(1) as i64;
    let usual = || vec![rational(1, 1), rational(1, others)];
    factor(instance, comparison, pairs).map_or_else(usual, |own| vec![own]).into_iter().find_map(|factor| {
        let bits = agree(free.len(), functions, |numbers| {
            let state = filled(&instance.sides, &free, numbers);
            let known = trail_of(comparison, &instance.links, &state)?;
            let whole = known[0].clone();
            let (mut left, mut right) = (Vec::new(), Vec::new());
            let mut sum = whole.zero();
            for ((i, j), links) in pairs {
                let found = trail_of(comparison, links, &state)?;
                // Where the whole has a value, its parts have one, too.
                if !found[1..].iter().all(|own| known[1..].contains(own)) {
                    return Err(ArithmeticError::Domain("parts with values"));
                }
                let part = found[0].clone();
                sum = sum + &part;
                // The others might be anywhere.
                let mut alone = state.clone();
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

/// The simplest positive number near the factor in floats, which only propose; sums inside sums run over those whom an agent hears, so that it may be any number of
/// that many agents.
fn factor(instance: &Instance, comparison: &Comparison, pairs: &[((usize, usize), Links)]) -> Option<Rational> {
    const NEAR: f64 = 1e-9;
    let state = instance.somewhere();
    let value = |links: &Links| value_of(comparison, links, &state).ok();
    let parts: Vec<f64> = pairs.iter().map(|(_, links)| value(links)).collect::<Option<_>>()?;
    let ratio = value(&instance.links)? / parts.iter().sum::<f64>();
    if ratio.is_nan() || ratio <= 0.0 {
        return None;
    }
    let end = |x: f64| Rational::from_float(x);
    let factor = simplest_between(&end(ratio * (1.0 - NEAR))?, &end(ratio * (1.0 + NEAR))?);
    factor.is_positive().then_some(factor)
}
