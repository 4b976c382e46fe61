//! A clause as inequalities between polynomials: roots and absolute values are taken away by the conditions that they bring, and what is left is proved by
//! exact roots, Bernstein coefficients, sums of squares, or boxes.

use super::{Effort, Method, Proof, bernstein, points, roots, subdivision};
use crate::function::{Compared, Function, Literal, Side};
use crate::multivariate::Multivariate;
use crate::sums::{Problem, Relation, Search};
use crate::symbolic::{Extension, Meaning, Symbolic};
use arithmetic::{ArithmeticError, Cancelled, Number, Progress, Rational, Ring, rational};
use num_traits::{Signed, Zero};

type Polynomial = Multivariate<Rational>;

/// `target >= 0` (or `> 0`) wherever all constraints are at least 0, or above 0 where they are strict.
#[derive(Debug, Clone)]
struct Goal {
    constraints: Vec<(Polynomial, bool)>,
    target: Polynomial,
    strict: bool,
}

/// More goals are not followed.
const MOST_GOALS: usize = 40;

/// Most variables.
const MOST_VARIABLES: usize = 10;

/// Boxes for a goal that has no sum of squares.
const BOXES: u64 = 4000;

/// A polynomial as a function.
struct Plain<'a> {
    polynomial: &'a Polynomial,
    arity: usize,
}

impl Function for Plain<'_> {
    fn arity(&self) -> usize {
        self.arity
    }

    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        Ok(self.polynomial.at(at, like, |c| like.rational(c)))
    }
}

/// What is proved: a proof, or the degrees that were tried in vain.
pub(super) enum Outcome {
    Proved(Proof),
    Open(Vec<u32>),
}

struct Prover<'a> {
    domain: &'a [Side],
    meanings: Vec<Meaning>,
    effort: Effort,
    progress: &'a dyn Progress,
    proof: Proof,
    degrees: Vec<u32>,
}

/// Proves a clause, where it has that form.
pub(super) fn prove<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Outcome, Cancelled> {
    if domain.len() > MOST_VARIABLES {
        return Ok(Outcome::Open(Vec::new()));
    }
    let extension = Extension::new(domain.len());
    let values: Vec<Option<Symbolic>> =
        clause.iter().map(|literal| literal.function.value(&extension.arguments()).ok()).collect();
    let meanings = extension.meanings();
    let mut prover = Prover { domain, meanings, effort, progress, proof: Proof::default(), degrees: Vec::new() };
    // Numerator times the divisors of odd power: of the sign of the function wherever that is defined.
    let cleared: Vec<Option<Polynomial>> = values
        .iter()
        .map(|value| {
            let (numerator, divisors) = value.as_ref()?.parts();
            let odd = divisors.into_iter().filter(|(_, power)| power % 2 == 1);
            Some(odd.fold(numerator, |product, (divisor, _)| match prover.sign_of(&divisor) {
                Some(false) => product,
                Some(true) => -product,
                None => product * divisor,
            }))
        })
        .collect();
    // Where functions need not be defined, that would have to be proved, too.
    let partial = |meaning: &Meaning| matches!(meaning, Meaning::Root(..) | Meaning::Any);
    let total = extension.divisors().is_empty() && !prover.meanings.iter().any(partial);
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
        let Some(target) = &cleared[place] else { continue };
        let others = cleared.iter().zip(clause).enumerate().filter(|(k, _)| *k != place);
        let constraints: Vec<(Polynomial, bool)> = others
            .flat_map(|(_, (p, other))| match (p, other.compared) {
                (Some(p), Compared::Positive) => vec![(-p.clone(), false)],
                (Some(p), Compared::NotNegative) => vec![(-p.clone(), true)],
                // Only where it is 0 the others have to be true.
                (Some(p), Compared::NotZero) => vec![(p.clone(), false), (-p.clone(), false)],
                (_, Compared::Zero) | (None, _) => Vec::new(),
            })
            .collect();
        let goal = |target: &Polynomial, strict: bool| Goal {
            constraints: constraints.clone(),
            target: target.clone(),
            strict,
        };
        let ways: Vec<Vec<Goal>> = match literal.compared {
            Compared::Positive => vec![vec![goal(target, true)]],
            Compared::NotNegative => vec![vec![goal(target, false)]],
            Compared::Zero => vec![vec![goal(target, false), goal(&-target.clone(), false)]],
            Compared::NotZero => vec![vec![goal(target, true)], vec![goal(&-target.clone(), true)]],
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

/// Whether two literals leave no point out: `p >= 0` or `-p > 0`, `p >= 0` or `p != 0`, and the like.
fn is_tautology(clause: &[(&Polynomial, Compared)]) -> bool {
    let multiple = |p: &Polynomial, q: &Polynomial| {
        let (a, b) = (p.terms().next()?, q.terms().next()?);
        let factor = b.1 / a.1;
        (p.scaled(&factor) == *q).then_some(factor)
    };
    clause.iter().enumerate().any(|(k, (p, first))| {
        p.is_zero() && matches!(first, Compared::NotNegative | Compared::Zero)
            || clause[k + 1..].iter().any(|(q, second)| {
                let Some(factor) = multiple(p, q) else { return false };
                use Compared::{NotNegative, NotZero, Positive, Zero};
                match (first, second) {
                    (NotNegative, NotNegative | Positive) | (Positive, NotNegative) => factor.is_negative(),
                    (NotNegative | Zero, NotZero) | (NotZero, NotNegative | Zero) => true,
                    _ => false,
                }
            })
    })
}

/// Of degree at most 1 in a variable whose square is `over/under`: the constant and the linear part, times a positive number.
fn linear(p: &Polynomial, variable: usize, over: &Polynomial, under: &Polynomial) -> (Polynomial, Polynomial) {
    let parts = p.in_variable(variable);
    let most = (parts.len() as u64 - 1) / 2;
    let zero = Multivariate::of(rational(0, 1));
    let mut sums = (zero.clone(), zero);
    for (k, part) in parts.into_iter().enumerate() {
        let half = k as u64 / 2;
        // Times an even power of what is divided by.
        let own = part * over.power(half) * under.power(2 * most - half);
        if k % 2 == 0 { sums.0 = sums.0 + own } else { sums.1 = sums.1 + own }
    }
    sums
}

impl Prover<'_> {
    /// Whether a polynomial in the arguments is negative (`true`) or positive (`false`) on the whole domain.
    fn sign_of(&self, p: &Polynomial) -> Option<bool> {
        const BOXES: u64 = 64;
        let arity = self.domain.len();
        // A root or an absolute value that is divided by is positive.
        let positive = |k: usize| match self.meanings[k] {
            Meaning::Root(..) | Meaning::Absolute(..) | Meaning::Positive => *p == Multivariate::x(arity + k),
            _ => false,
        };
        if (0..self.meanings.len()).any(positive) {
            return Some(false);
        }
        if p.arity() > arity {
            return None;
        }
        let one = |polynomial: &Polynomial| {
            let function = Plain { polynomial, arity: self.domain.len() };
            let literal = Literal { function, compared: Compared::Positive, guarded: false };
            let effort = Effort { boxes: BOXES, squares: false };
            matches!(subdivision::divide(&[literal], self.domain, effort, self.progress), Ok(super::Decision::Holds(_)))
        };
        if one(p) {
            Some(false)
        } else if one(&-p.clone()) {
            Some(true)
        } else {
            None
        }
    }

    fn all(&mut self, goals: Vec<Goal>) -> Result<bool, Cancelled> {
        let mut queue = goals;
        let mut done = 0;
        while let Some(goal) = queue.pop() {
            self.progress.checkpoint()?;
            done += 1;
            if done + queue.len() > MOST_GOALS {
                return Ok(false);
            }
            match self.without_last(&goal) {
                Some(parts) => queue.extend(parts),
                None if self.polynomial(&goal)? => {}
                None => return Ok(false),
            }
        }
        Ok(true)
    }

    /// Goals without the last root or absolute value, that together are the goal; `None` where there is none in it.
    fn without_last(&self, goal: &Goal) -> Option<Vec<Goal>> {
        let arity = self.domain.len();
        let used = |variable: usize| {
            goal.target.degree_in(variable) > 0 || goal.constraints.iter().any(|(p, _)| p.degree_in(variable) > 0)
        };
        let place = (0..self.meanings.len())
            .rev()
            .find(|&k| used(arity + k) && matches!(self.meanings[k], Meaning::Root(..) | Meaning::Absolute(..)))?;
        let variable = arity + place;
        match &self.meanings[place] {
            Meaning::Absolute(over, under) => {
                let branch = |sign: i64| {
                    let inside = over.clone() * under * Multivariate::of(rational(sign, 1));
                    let put = |p: &Polynomial| {
                        let (a, b) = linear(p, variable, &over.square(), &under.square());
                        if b.is_zero() { a } else { a * under.square() + b * &inside }
                    };
                    let mut constraints: Vec<(Polynomial, bool)> =
                        goal.constraints.iter().map(|(p, strict)| (put(p), *strict)).collect();
                    constraints.push((inside.clone(), false));
                    Goal { constraints, target: put(&goal.target), strict: goal.strict }
                };
                Some(vec![branch(1), branch(-1)])
            }
            Meaning::Root(over, under) => {
                let mut constraints: Vec<(Polynomial, bool)> =
                    goal.constraints.iter().filter(|(p, _)| p.degree_in(variable) == 0).cloned().collect();
                let radicand = over.clone() * under;
                if radicand.as_constant().is_none() {
                    constraints.push((radicand.clone(), false));
                }
                let (a, b) = linear(&goal.target, variable, over, under);
                let with = |more: Vec<Polynomial>, target: Polynomial, strict: bool| {
                    let more = more.into_iter().filter(|p| p.as_constant().is_none()).map(|p| (p, false));
                    Goal { constraints: constraints.iter().cloned().chain(more).collect(), target, strict }
                };
                if b.is_zero() {
                    return Some(vec![with(Vec::new(), a, goal.strict)]);
                }
                // b² over/under - a², times the square of the denominator.
                let apart = b.square() * &radicand - a.square() * under.square();
                let mut list = Vec::new();
                if !b.as_constant().is_some_and(|b| b.is_negative()) {
                    list.push(with(vec![b.clone(), -a.clone()], apart.clone(), goal.strict));
                }
                if !b.as_constant().is_some_and(|b| b.is_positive()) {
                    list.push(with(vec![-b.clone()], a, false));
                    list.push(with(vec![-b], -apart, goal.strict));
                }
                Some(list)
            }
            _ => None,
        }
    }

    /// The range of a variable.
    fn side(&self, variable: usize) -> Side {
        let arity = self.domain.len();
        if variable < arity {
            return self.domain[variable].clone();
        }
        match &self.meanings[variable - arity] {
            Meaning::Cosine | Meaning::Sine => Side::between(rational(-1, 1), rational(1, 1)),
            Meaning::Positive | Meaning::Root(..) | Meaning::Absolute(..) => {
                Side { lo: Some(rational(0, 1)), hi: None }
            }
            Meaning::Between(lo, hi) => Side::between(lo.clone(), hi.clone()),
            Meaning::Any => Side::line(),
        }
    }

    /// A goal of polynomials.
    fn polynomial(&mut self, goal: &Goal) -> Result<bool, Cancelled> {
        let fits = |c: &Rational| if goal.strict { c.is_positive() } else { !c.is_negative() };
        if goal.target.as_constant().is_some_and(|c| fits(&c)) {
            return Ok(true);
        }
        // Literally a constraint, or the negation of one.
        for (p, strict) in &goal.constraints {
            if is_tautology(&[
                (&goal.target, if goal.strict { Compared::Positive } else { Compared::NotNegative }),
                (&-p.clone(), if *strict { Compared::NotNegative } else { Compared::Positive }),
            ]) {
                self.proof.methods.push(Method::Tautology);
                return Ok(true);
            }
        }
        let arity = self.domain.len() + self.meanings.len();
        let mut used: Vec<usize> = (0..arity).filter(|&k| goal.target.degree_in(k) > 0).collect();
        // Constraints bring their variables with them.
        loop {
            let before = used.len();
            for (p, _) in &goal.constraints {
                let own: Vec<usize> = (0..arity).filter(|&k| p.degree_in(k) > 0).collect();
                if own.iter().any(|k| used.contains(k)) {
                    used.extend(own);
                }
            }
            used.sort_unstable();
            used.dedup();
            if used.len() == before {
                break;
            }
        }
        let constraints: Vec<(Polynomial, bool)> = goal
            .constraints
            .iter()
            .filter(|(p, _)| p.as_constant().is_none() && (0..arity).any(|k| p.degree_in(k) > 0 && used.contains(&k)))
            .cloned()
            .collect();
        let closed: Vec<Polynomial> = constraints.iter().map(|(p, _)| p.clone()).collect();
        if let [only] = used[..] {
            let side = self.side(only);
            match roots::holds(&goal.target, goal.strict, &closed, (only, &side), self.progress)? {
                Some(true) => {
                    self.proof.methods.push(Method::Roots);
                    return Ok(true);
                }
                // A relaxation may fail where the property does not; what fails in the arguments themselves has a point.
                Some(false) if constraints.iter().all(|(_, strict)| !strict) => return Ok(false),
                _ => {}
            }
        }
        let sides: Vec<(usize, Side)> = used.iter().map(|&k| (k, self.side(k))).collect();
        let relations: Vec<Relation> = used
            .iter()
            .filter(|&&k| k >= self.domain.len() && self.meanings[k - self.domain.len()] == Meaning::Sine)
            .map(|&k| Relation {
                variable: k,
                square: Multivariate::of(rational(1, 1)) - Multivariate::x(k - 1).square(),
            })
            .collect();
        if sides.len() <= 4
            && relations.is_empty()
            && bernstein::holds(&goal.target, goal.strict, &sides, self.progress)?
        {
            self.proof.methods.push(Method::Bernstein);
            return Ok(true);
        }
        self.by_squares(goal, &constraints, &sides, relations)
    }

    fn by_squares(
        &mut self,
        goal: &Goal,
        constraints: &[(Polynomial, bool)],
        sides: &[(usize, Side)],
        relations: Vec<Relation>,
    ) -> Result<bool, Cancelled> {
        // As a problem of its own variables only.
        let arity = goal.target.arity().max(sides.iter().map(|(k, _)| k + 1).max().unwrap_or(0));
        let domain: Vec<Side> = (0..arity)
            .map(|k| {
                sides
                    .iter()
                    .find(|(own, _)| *own == k)
                    .map_or_else(|| Side::point(rational(0, 1)), |(_, side)| side.clone())
            })
            .collect();
        let mut zeros = Vec::new();
        if relations.is_empty() {
            let literal =
                |polynomial, compared| Literal { function: Plain { polynomial, arity }, compared, guarded: false };
            let turned: Vec<(Polynomial, bool)> = constraints.iter().map(|(p, strict)| (-p.clone(), *strict)).collect();
            let own = if goal.strict { Compared::Positive } else { Compared::NotNegative };
            let clause: Vec<_> =
                std::iter::once(literal(&goal.target, own))
                    .chain(turned.iter().map(|(p, strict)| {
                        literal(p, if *strict { Compared::NotNegative } else { Compared::Positive })
                    }))
                    .collect();
            let seen = points::search(&clause, &domain, self.progress)?;
            if seen.counterexample.is_some() {
                return Ok(false);
            }
            zeros = seen.zeros;
            zeros.retain(|zero| {
                goal.target.value(zero).is_zero() && constraints.iter().all(|(p, _)| !p.value(zero).is_negative())
            });
            let effort = Effort { boxes: BOXES.min(self.effort.boxes), squares: false };
            let few = Effort { boxes: 128, squares: false };
            let order = if self.effort.squares { few } else { effort };
            if let super::Decision::Holds(proof) = subdivision::divide(&clause, &domain, order, self.progress)? {
                self.proof.boxes += proof.boxes;
                self.proof.methods.extend(proof.methods);
                return Ok(true);
            }
        }
        if !self.effort.squares {
            return Ok(false);
        }
        let mut all: Vec<Polynomial> = Vec::new();
        // The circle says as much as the bounds of its coordinates.
        let round = |k: usize| relations.iter().any(|relation| relation.variable == k || relation.variable == k + 1);
        for (variable, side) in sides.iter().filter(|(variable, _)| !round(*variable)) {
            let x = Multivariate::x(*variable);
            all.extend(side.lo.iter().map(|lo| x.clone() - Multivariate::of(lo.clone())));
            all.extend(side.hi.iter().map(|hi| Multivariate::of(hi.clone()) - x.clone()));
        }
        let own = constraints.iter().map(|(p, _)| p.clone());
        all = own.chain(all).collect();
        let problem = Problem {
            names: Vec::new(),
            goal: goal.target.clone(),
            strict: goal.strict,
            constraints: all,
            relations,
            zeros,
        };
        match problem.search(self.progress)? {
            Search::Found(found) => {
                self.proof.methods.push(Method::Squares);
                self.proof.certificates.push(*found);
                Ok(true)
            }
            Search::Nothing(degrees) => {
                self.degrees.extend(degrees);
                Ok(false)
            }
        }
    }
}
