//! States at which a clause is false: floats propose, exact arithmetic or enclosures confirm.

use super::instance::{Instance, Side, admits};
use arithmetic::random::{generator, uniform};
use arithmetic::{Cancelled, Progress, Rational, Sign, rational};
use expressions::Comparison;
use num_traits::ToPrimitive;
use rand_chacha::ChaCha8Rng;

/// States that are tried.
const TRIED: usize = 4000;

/// Sizes of numbers that are drawn.
const SIZES: [i64; 5] = [1, 2, 4, 16, 100];

/// A state at which the clause is false.
pub(super) fn counterexample(
    instance: &Instance,
    clause: &[Comparison],
    progress: &dyn Progress,
) -> Result<Option<Vec<Rational>>, Cancelled> {
    let mut random = generator("question", "counterexamples of states", 0);
    for k in 0..TRIED {
        progress.checkpoint()?;
        let state = drawn(instance, k, &mut random);
        let floats: Vec<f64> = state.iter().map(|q| q.to_f64().unwrap_or(f64::NAN)).collect();
        let values = instance.floats(clause, &floats);
        let fails = clause
            .iter()
            .zip(&values)
            .all(|(comparison, value)| value.is_some_and(|x| !admits(comparison.relation, sign_of(x))));
        if fails && instance.clause_holds(clause, &state) == Some(false) {
            return Ok(Some(simpler(instance, clause, state, progress)?));
        }
    }
    Ok(None)
}

fn sign_of(x: f64) -> Sign {
    if x > 0.0 {
        Sign::Positive
    } else if x < 0.0 {
        Sign::Negative
    } else {
        Sign::Zero
    }
}

/// Small whole numbers first, then fractions of several sizes; some agents alike.
fn drawn(instance: &Instance, k: usize, random: &mut ChaCha8Rng) -> Vec<Rational> {
    let size = SIZES[k % SIZES.len()];
    let parts = if k.is_multiple_of(3) { 1 } else { 8 };
    let mut number = |lo: &Rational, hi: &Rational| {
        let steps = (size * parts * 2) as f64;
        let step = (uniform(random) * (steps + 1.0)).floor().min(steps) as i64;
        lo + (hi - lo) * rational(step, size * parts * 2)
    };
    let mut state: Vec<Rational> = instance
        .sides
        .iter()
        .map(|side| match side {
            Side::Point(q) => q.clone(),
            Side::Between(lo, hi) => number(lo, hi),
            Side::Line => number(&rational(-size, 1), &rational(size, 1)),
        })
        .collect();
    // Every fourth one with numbers that are 0, where they may be.
    if k % 4 == 3 {
        for (x, side) in state.iter_mut().zip(&instance.sides) {
            if *side == Side::Line && uniform(random) < 0.5 {
                *x = rational(0, 1);
            }
        }
    }
    state
}

/// The same with simpler numbers, as long as the clause is false.
fn simpler(
    instance: &Instance,
    clause: &[Comparison],
    mut state: Vec<Rational>,
    progress: &dyn Progress,
) -> Result<Vec<Rational>, Cancelled> {
    for place in 0..state.len() {
        let (lo, hi) = match &instance.sides[place] {
            Side::Point(_) => continue,
            Side::Between(lo, hi) => (Some(lo), Some(hi)),
            Side::Line => (None, None),
        };
        for tried in [0, 1, -1, 2, -2, 3, -3].map(|n| rational(n, 1)) {
            progress.checkpoint()?;
            if tried == state[place] {
                break;
            }
            if lo.is_some_and(|lo| tried < *lo) || hi.is_some_and(|hi| tried > *hi) {
                continue;
            }
            let before = std::mem::replace(&mut state[place], tried);
            if instance.clause_holds(clause, &state) == Some(false) {
                break;
            }
            state[place] = before;
        }
    }
    Ok(state)
}
