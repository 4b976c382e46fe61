//! A clause as inequalities between polynomials.

use super::elimination::{Goal, Polynomial, Variables};
use super::places::free;
use super::prover::{Prover, is_tautology};
use super::rewritten::range;
use super::{Effort, MANY, Method, Proof};
use crate::function::{Compared, Function, Literal, Side};
use crate::symbolic::{Extension, Meaning, Symbolic};
use arithmetic::{Cancelled, Field, Progress, Ring, Sign, rational};

/// Exponentials and sines of multiples of larger fractions are variables of their own.
const FINEST: i64 = 4;

/// What is proved: a proof, or the degrees that were tried in vain.
pub(super) enum Outcome {
    Proved(Proof),
    Open(Vec<u32>),
}

/// Arguments, numbers where the domain has one only.
pub(super) fn held_at_points(arguments: &[Symbolic], domain: &[Side]) -> Vec<Symbolic> {
    let known = |(x, side): (&Symbolic, &Side)| side.as_point().map_or_else(|| x.clone(), |q| x.rational(q));
    arguments.iter().zip(domain).map(known).collect()
}

/// Proves a clause, where it has that form.
pub(super) fn prove<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Outcome, Cancelled> {
    let many = free(domain).len() > MANY;
    let symbolic = |grid: i64| {
        let extension = Extension::with_grid(domain.len(), grid);
        let arguments = held_at_points(&extension.arguments(), domain);
        let values: Vec<Option<Symbolic>> =
            clause.iter().map(|literal| literal.function.value(&arguments).ok()).collect();
        (extension, values)
    };
    let (mut extension, mut values) = symbolic(1);
    if (2..=FINEST).contains(&extension.finest()) {
        (extension, values) = symbolic(extension.finest());
    }
    if many && !(extension.meanings().is_empty() && extension.divisors().is_empty()) {
        return Ok(Outcome::Open(Vec::new()));
    }
    let meanings = extension.meanings();
    let angle = |(place, meaning): (usize, &Meaning)| match meaning {
        Meaning::Cosine | Meaning::Sine => range(&extension.variable_at(place)?, domain),
        _ => None,
    };
    let angles = meanings.iter().enumerate().map(angle).collect();
    let variables = Variables { domain, meanings, angles };
    let mut prover =
        Prover { variables, effort, progress, proof: Proof::default(), degrees: Vec::new(), roots_stay: false };
    // Numerator times the divisors of odd power: of the sign of the function wherever that is defined.
    let mut cleared: Vec<Option<Polynomial>> = Vec::new();
    for value in &values {
        let Some((mut product, divisors)) = value.as_ref().map(Symbolic::parts) else {
            cleared.push(None);
            continue;
        };
        for (divisor, _) in divisors.into_iter().filter(|(_, power)| power % 2 == 1) {
            product = match prover.sign_of(&divisor)? {
                Some(Sign::Negative) => -product,
                Some(_) => product,
                None => product * divisor,
            };
        }
        cleared.push(Some(product));
    }
    // Where functions need not be defined, that would have to be proved, too.
    let total = prover.variables.are_defined() && extension.divisors().iter().all(|p| prover.variables.is_positive(p));
    if !total && !clause.iter().all(|literal| literal.guarded) {
        return Ok(Outcome::Open(Vec::new()));
    }
    let known: Vec<(&Polynomial, Compared)> =
        cleared.iter().zip(clause).filter_map(|(p, literal)| Some((p.as_ref()?, literal.compared))).collect();
    if is_tautology(&known) {
        prover.proof.methods.push(Method::Tautology);
        return Ok(Outcome::Proved(prover.proof));
    }
    for (place, literal) in clause.iter().enumerate() {
        let Some(target) = cleared[place].as_ref().filter(|p| !many || p.degree() <= 2) else { continue };
        let others = cleared.iter().zip(clause).enumerate().filter(|(k, _)| *k != place && !many);
        let mut constraints: Vec<(Polynomial, bool)> = Vec::new();
        for (p, other) in others.filter_map(|(_, (p, other))| Some((p.clone()?, other))) {
            match other.compared {
                Compared::Positive => constraints.push((-p, false)),
                Compared::NotNegative => constraints.push((-p, true)),
                Compared::NotZero => constraints.extend([(p.clone(), false), (-p, false)]),
                Compared::Zero => {}
            }
        }
        let goal = |target: &Polynomial, strict: bool| Goal {
            constraints: constraints.clone(),
            target: target.clone(),
            strict,
        };
        // Where `p != 0` is known, `f >= c p^(2 k)` says that `f > 0`.
        let above = |target: &Polynomial| -> Vec<Vec<Goal>> {
            let excluded = cleared.iter().zip(clause).filter(|(_, other)| other.compared == Compared::Zero && !many);
            let excluded = excluded.filter_map(|(p, _)| p.as_ref()).filter(|_| !effort.certified);
            let apart = excluded.flat_map(|p| above_power(target, p)).map(|rest| vec![goal(&rest, false)]);
            std::iter::once(vec![goal(target, true)]).chain(apart).collect()
        };
        let ways: Vec<Vec<Goal>> = match literal.compared {
            Compared::Positive => above(target),
            Compared::NotNegative => vec![vec![goal(target, false)]],
            Compared::Zero => vec![vec![goal(target, false), goal(&-target.clone(), false)]],
            Compared::NotZero => [above(target), above(&-target.clone())].concat(),
        };
        for goals in ways {
            if prover.all(goals)? {
                return Ok(Outcome::Proved(prover.proof));
            }
        }
    }
    let mut degrees = prover.degrees;
    degrees.sort_unstable();
    degrees.dedup();
    Ok(Outcome::Open(degrees))
}

/// `f - c p^(2 k)` for a few multiples and powers of a polynomial that is not 0.
fn above_power(f: &Polynomial, p: &Polynomial) -> Vec<Polynomial> {
    const SHARES: [(i64, i64); 3] = [(1, 1), (1, 8), (1, 1000)];
    let most = u64::from(f.degree() / (2 * p.degree()).max(1));
    let powers = (1..=most).filter(|_| p.degree() > 0).map(|k| p.power(2 * k));
    powers.flat_map(|power| SHARES.map(|(c, d)| f.clone() - power.scaled(&rational(c, d)))).collect()
}
