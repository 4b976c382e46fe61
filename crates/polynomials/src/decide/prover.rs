//! Inequalities between polynomials, proved by exact roots, Bernstein coefficients, sums of squares, or boxes.

use super::elimination::{Goal, Polynomial, Variables};
use super::{Effort, Method, Proof, bernstein, points, roots, subdivision};
use crate::function::{Compared, Function, Literal, Side};
use crate::multivariate::Multivariate;
use crate::sums::{Problem, Relation, Search};
use arithmetic::{ArithmeticError, Cancelled, Number, Progress, Rational, Ring, Sign, rational};
use num_traits::{Signed, Zero};

/// More goals are not followed.
const MOST_GOALS: usize = 40;

/// Boxes for a goal that has no sum of squares.
const BOXES: u64 = 4000;

/// A polynomial as a function.
struct Plain<'a> {
    polynomial: &'a Polynomial,
}

impl Function for Plain<'_> {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        Ok(self.polynomial.at(at, like, |c| like.rational(c)))
    }
}

/// What has been proved so far.
pub(super) struct Prover<'a> {
    pub variables: Variables<'a>,
    pub effort: Effort,
    pub progress: &'a dyn Progress,
    pub proof: Proof,
    pub degrees: Vec<u32>,
    /// Whether roots of polynomials are numbers with a known square, in sums of squares.
    pub roots_stay: bool,
}

/// Whether two literals leave no point out: `p >= 0` or `-p > 0`, `p >= 0` or `p != 0`, and the like.
pub(super) fn is_tautology(clause: &[(&Polynomial, Compared)]) -> bool {
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

impl Prover<'_> {
    /// The sign, other than zero, of a polynomial that is divided by: where it is 0 there is nothing to be decided.
    pub fn sign_of(&mut self, p: &Polynomial) -> Result<Option<Sign>, Cancelled> {
        let range = self.variables.range(p);
        if range.lo >= 0.0 {
            return Ok(Some(Sign::Positive));
        }
        if range.hi <= 0.0 {
            return Ok(Some(Sign::Negative));
        }
        for (sign, target) in [(Sign::Positive, p.clone()), (Sign::Negative, -p.clone())] {
            if self.all(vec![Goal { constraints: Vec::new(), target, strict: false }])? {
                return Ok(Some(sign));
            }
        }
        Ok(None)
    }

    /// Proves all of them; where that does not succeed, nothing is kept but the degrees.
    pub fn all(&mut self, goals: Vec<Goal>) -> Result<bool, Cancelled> {
        let before = self.proof.clone();
        let arity = self.variables.len();
        let mut proved = self.each(goals.clone())?;
        if !proved && self.effort.squares && (0..arity).any(|k| self.variables.square_of(k).is_some()) {
            self.roots_stay = true;
            proved = self.each(goals)?;
            self.roots_stay = false;
        }
        if !proved {
            self.proof = Proof { boxes: self.proof.boxes, ..before };
        }
        Ok(proved)
    }

    fn each(&mut self, goals: Vec<Goal>) -> Result<bool, Cancelled> {
        let mut queue = goals;
        let mut done = 0;
        while let Some(goal) = queue.pop() {
            self.progress.checkpoint()?;
            done += 1;
            if done + queue.len() > MOST_GOALS {
                return Ok(false);
            }
            match self.variables.without_last(&goal, self.roots_stay) {
                Some(parts) => queue.extend(parts),
                None if self.polynomial(&goal)? => {}
                None => return Ok(false),
            }
        }
        Ok(true)
    }

    /// A goal of polynomials.
    fn polynomial(&mut self, goal: &Goal) -> Result<bool, Cancelled> {
        let goal = &Goal { target: self.variables.without_positive(&goal.target), ..goal.clone() };
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
        // Divided by what is not negative there. A certificate would not say the goal itself.
        let divides = !self.effort.certified && !goal.target.is_zero();
        for (p, strict) in goal.constraints.iter().filter(|_| divides) {
            let fits = p.as_constant().is_none() && (*strict || !goal.strict);
            if let Some(target) = goal.target.divided_by(p).filter(|_| fits)
                && self.polynomial(&Goal { target, ..goal.clone() })?
            {
                return Ok(true);
            }
        }
        let arity = self.variables.len();
        let mut used: Vec<usize> = (0..arity).filter(|&k| goal.target.degree_in(k) > 0).collect();
        // Constraints bring their variables with them, and so do roots.
        loop {
            let before = used.len();
            for square in used.clone().into_iter().filter_map(|k| self.variables.square_of(k)) {
                used.extend((0..arity).filter(|&k| square.degree_in(k) > 0));
            }
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
        let sides: Vec<(usize, Side)> = used.iter().map(|&k| (k, self.variables.side(k))).collect();
        // With a certificate, if there is one.
        if self.effort.certified && self.by_squares(goal, &constraints, &sides)? {
            return Ok(true);
        }
        if let [(only, side)] = &sides[..] {
            let closed: Vec<Polynomial> = constraints.iter().map(|(p, _)| p.clone()).collect();
            match roots::holds(&goal.target, goal.strict, &closed, (*only, side), self.progress)? {
                Some(true) => {
                    self.proof.methods.push(Method::Roots);
                    return Ok(true);
                }
                // A relaxation may fail where the property does not; what fails in the arguments themselves has a point.
                Some(false) if constraints.iter().all(|(_, strict)| !strict) => return Ok(false),
                _ => {}
            }
        }
        let few = sides.len() <= 4 && !used.iter().any(|&k| self.variables.is_sine(k));
        if few && bernstein::holds(&goal.target, goal.strict, &sides, self.progress)? {
            self.proof.methods.push(Method::Bernstein);
            return Ok(true);
        }
        Ok(!self.effort.certified && self.by_squares(goal, &constraints, &sides)?)
    }

    fn by_squares(
        &mut self,
        goal: &Goal,
        constraints: &[(Polynomial, bool)],
        sides: &[(usize, Side)],
    ) -> Result<bool, Cancelled> {
        let one = || Multivariate::of(rational(1, 1));
        let square = |k: usize| match self.variables.is_sine(k) {
            true => Some(one() - Multivariate::x(k - 1).square()),
            false => self.variables.square_of(k),
        };
        let relations: Vec<Relation> =
            sides.iter().filter_map(|(k, _)| square(*k).map(|square| Relation { variable: *k, square })).collect();
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
        // Of many numbers only polynomials of degree 2 come here, which need no zeros.
        if relations.is_empty() && sides.len() <= super::MANY {
            let literal = |polynomial, compared| Literal { function: Plain { polynomial }, compared, guarded: false };
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
            let effort =
                Effort { boxes: BOXES.min(self.effort.boxes), squares: false, certified: false, conditions: false };
            let few = Effort { boxes: 128, ..effort };
            let order = if self.effort.squares { few } else { effort };
            if !self.effort.certified
                && let super::Decision::Holds(proof) = subdivision::divide(&clause, &domain, &[], order, self.progress)?
            {
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
        let round = |k: usize| self.variables.is_sine(k) || self.variables.is_sine(k + 1);
        for (variable, side) in sides {
            let x = Multivariate::x(*variable);
            let says = |end: &&Rational| !round(*variable) || end.abs() < rational(1, 1);
            all.extend(side.lo.iter().filter(says).map(|lo| x.clone() - Multivariate::of(lo.clone())));
            all.extend(side.hi.iter().filter(says).map(|hi| Multivariate::of(hi.clone()) - x.clone()));
        }
        let own = constraints.iter().map(|(p, _)| p.clone());
        all = own.chain(all).collect();
        let problem = Problem { goal: goal.target.clone(), strict: goal.strict, constraints: all, relations, zeros };
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
