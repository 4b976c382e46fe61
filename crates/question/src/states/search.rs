//! States at which a clause is false: floats propose, exact arithmetic or enclosures confirm.

use super::instance::{Instance, admits};
use arithmetic::random::{generator, uniform};
use arithmetic::{Cancelled, Progress, Rational, Sign, rational, simplest_between};
use expressions::{Comparison, Evaluator};
use num_traits::{Signed, ToPrimitive};
use polynomials::Side;
use rand_chacha::ChaCha8Rng;

/// States that are tried.
pub(super) const TRIED: usize = 4000;

/// Sizes of numbers that are drawn: what falls with the distance is small only far away.
const SIZES: [i64; 8] = [1, 2, 4, 16, 100, 10_000, 1_000_000, 1_000_000_000];

/// What states that are tried tell of a clause.
pub(super) enum Tried {
    /// It is false at this one.
    False(Vec<Rational>),
    /// Nothing, though each comparison has a value at some of them.
    Nothing,
    /// A comparison has no value at any of them: that it holds wherever it has one would say nothing.
    NoValue,
}

/// A state at which the clause is false, among so many that are tried.
pub(super) fn counterexample(
    instance: &Instance,
    clause: &[Comparison],
    tried: usize,
    progress: &dyn Progress,
) -> Result<Tried, Cancelled> {
    let mut random = generator("question", "counterexamples of states", 0);
    let mut has_value = vec![false; clause.len()];
    let mut machines: Vec<Evaluator<f64>> = clause.iter().map(|comparison| comparison.evaluator(&0.0)).collect();
    for k in 0..tried {
        progress.checkpoint()?;
        let state = drawn(instance, k, &mut random);
        let floats: Vec<f64> = state.iter().map(|q| q.to_f64().unwrap_or(f64::NAN)).collect();
        let Some((time, numbers)) = floats.split_last() else { return Ok(Tried::Nothing) };
        let mut fails = true;
        for ((comparison, machine), has_value) in clause.iter().zip(&mut machines).zip(&mut has_value) {
            let value = machine.flock(time, numbers, &instance.links).ok().and_then(|list| list.first().copied());
            let value = value.filter(|x| x.is_finite());
            *has_value |= value.is_some();
            fails &= value.is_some_and(|x| !admits(comparison.relation, sign_of(x)));
        }
        if fails && instance.clause_holds(clause, &state) == Some(false) {
            return Ok(Tried::False(simpler(instance, clause, state, progress)?));
        }
    }
    Ok(if has_value.contains(&false) { Tried::NoValue } else { Tried::Nothing })
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

/// Small whole numbers first, then fractions of several sizes, the same for all numbers of a state or one for each number that an agent has; then agents are put
/// where laws change or have extremes.
fn drawn(instance: &Instance, k: usize, random: &mut ChaCha8Rng) -> Vec<Rational> {
    let parts = if k.is_multiple_of(3) { 1 } else { 8 };
    let mut sizes = vec![SIZES[k % SIZES.len()]; instance.sides.len()];
    if k % 2 == 1 {
        for column in &instance.columns {
            let size = SIZES[below(SIZES.len(), random)];
            column.iter().for_each(|&place| sizes[place] = size);
        }
    }
    let mut number = |lo: &Rational, hi: &Rational, size: i64| {
        let steps = size.min(10_000) * parts * 2;
        let step = (uniform(random) * (steps as f64 + 1.0)).floor().min(steps as f64) as i64;
        lo + (hi - lo) * rational(step, steps)
    };
    let mut state: Vec<Rational> = instance
        .sides
        .iter()
        .zip(sizes)
        .map(|(side, size)| match (&side.lo, &side.hi) {
            _ if side.as_point().is_some() => side.middle(),
            (Some(lo), Some(hi)) => number(lo, hi, size),
            (Some(lo), None) => number(lo, &(lo + rational(size, 1)), size),
            (None, Some(hi)) => number(&(hi - rational(size, 1)), hi, size),
            (None, None) => number(&rational(-size, 1), &rational(size, 1), size),
        })
        .collect();
    arrange(instance, k, &mut state, random);
    state
}

fn below(bound: usize, random: &mut ChaCha8Rng) -> usize {
    ((uniform(random) * bound as f64) as usize).min(bound.saturating_sub(1))
}

/// Agents at one place, close together, opposite to each other, with one velocity, at rest, at the ends of what they range over.
fn arrange(instance: &Instance, k: usize, state: &mut [Rational], random: &mut ChaCha8Rng) {
    let agents = instance.of_agent.len();
    let set = |state: &mut [Rational], place: usize, x: Rational| {
        if instance.sides[place].contains(&x) {
            state[place] = x;
        }
    };
    let (a, b) = (below(agents, random), below(agents, random));
    let pairs: Vec<(usize, usize)> =
        instance.of_agent[a].iter().copied().zip(instance.of_agent[b].iter().copied()).collect();
    match k % 8 {
        1 | 2 => {
            // The same, or nearly so, in every number or in those of some parts.
            let apart = if k.is_multiple_of(2) { rational(0, 1) } else { rational(1, 1 << (2 * below(8, random))) };
            let all = uniform(random) < 0.5;
            for (from, to) in pairs {
                if all || uniform(random) < 0.5 {
                    let x = state[from].clone() + &apart;
                    set(state, to, x);
                }
            }
        }
        3 => {
            for (from, to) in pairs {
                let x = -state[from].clone();
                set(state, to, x);
            }
        }
        4 => {
            for column in instance.columns.iter().filter(|_| uniform(random) < 0.5) {
                let x = state[column[0]].clone();
                column.iter().for_each(|&place| set(state, place, x.clone()));
            }
        }
        5 => {
            for place in 0..instance.sides.len() {
                if instance.sides[place] == Side::line() && uniform(random) < 0.5 {
                    set(state, place, rational(0, 1));
                }
            }
        }
        6 => {
            for (place, side) in instance.sides.iter().enumerate() {
                let end = if uniform(random) < 0.5 { &side.lo } else { &side.hi };
                if let Some(end) = end.clone().filter(|_| uniform(random) < 0.5) {
                    set(state, place, end);
                }
            }
        }
        _ => {}
    }
}

/// The same with simpler numbers, as long as the clause is false: small whole ones, else simpler ones nearby, again and again, so that a size that is not needed goes.
fn simpler(
    instance: &Instance,
    clause: &[Comparison],
    mut state: Vec<Rational>,
    progress: &dyn Progress,
) -> Result<Vec<Rational>, Cancelled> {
    for place in 0..state.len() {
        let side = &instance.sides[place];
        if side.as_point().is_some() {
            continue;
        }
        loop {
            let current = state[place].clone();
            let mut taken = false;
            for tried in simpler_numbers(&current).take_while(|tried| *tried != current) {
                progress.checkpoint()?;
                if !side.contains(&tried) {
                    continue;
                }
                state[place] = tried;
                taken = instance.clause_holds(clause, &state) == Some(false);
                if taken {
                    break;
                }
                state[place] = current.clone();
            }
            if !taken {
                break;
            }
        }
    }
    Ok(state)
}

/// Numbers that are simpler than one: small whole ones, then the simplest within a half, a quarter, .. of it.
fn simpler_numbers(x: &Rational) -> impl Iterator<Item = Rational> {
    let small = [0, 1, -1, 2, -2, 3, -3].map(|n| rational(n, 1));
    let near = (1..12).map(move |k| {
        let reach = x.abs() * rational(1, 1 << k);
        simplest_between(&(x - &reach), &(x + reach))
    });
    small.into_iter().chain(near)
}
