//! Roots and absolute values are taken out of an inequality by the conditions that they bring (notes/inequalities.md, rules 6 and 7).

use super::extended::Extended;
use crate::function::Side;
use crate::multivariate::Multivariate;
use crate::symbolic::Meaning;
use arithmetic::{Field, Rational, Ring, rational};

pub(super) type Polynomial = Multivariate<Rational>;

/// `target >= 0` (or `> 0`) wherever all constraints are at least 0, or above 0 where they are strict.
#[derive(Debug, Clone)]
pub(super) struct Goal {
    pub constraints: Vec<(Polynomial, bool)>,
    pub target: Polynomial,
    pub strict: bool,
}

/// The arguments, and after them what stands for roots, absolute values and other functions of them.
pub(super) struct Variables<'a> {
    pub domain: &'a [Side],
    pub meanings: Vec<Meaning>,
    /// The ranges of cosines and sines on the domain.
    pub angles: Vec<Option<Side>>,
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

impl Variables<'_> {
    pub fn len(&self) -> usize {
        self.domain.len() + self.meanings.len()
    }

    /// The range of a variable.
    pub fn side(&self, variable: usize) -> Side {
        let Some(k) = variable.checked_sub(self.domain.len()) else { return self.domain[variable].clone() };
        match &self.meanings[k] {
            Meaning::Cosine | Meaning::Sine => {
                let whole = || Side::between(rational(-1, 1), rational(1, 1));
                self.angles.get(k).cloned().flatten().unwrap_or_else(whole)
            }
            Meaning::Root(over, under) if under.as_constant().is_some() => {
                let least = self.range(over).lo.max(0.0).sqrt().next_down().max(0.0);
                Side { lo: Some(Rational::from_float(least).unwrap_or_default()), ..Side::line() }
            }
            Meaning::Positive | Meaning::Root(..) | Meaning::Absolute(..) => {
                Side { lo: Some(rational(0, 1)), ..Side::line() }
            }
            Meaning::Between(lo, hi) => Side::between(lo.clone(), hi.clone()),
            Meaning::Any | Meaning::Reciprocal(_) => Side::line(),
        }
    }

    /// Whether it is the sine of an argument; the variable before it is the cosine.
    pub fn is_sine(&self, variable: usize) -> bool {
        let meaning = variable.checked_sub(self.domain.len()).and_then(|k| self.meanings.get(k));
        meaning.is_some_and(|meaning| *meaning == Meaning::Sine)
    }

    /// Whether every function that stands behind a variable has a value wherever its argument has one.
    pub fn are_defined(&self) -> bool {
        self.meanings.iter().all(|meaning| match meaning {
            Meaning::Root(over, under) => under.as_constant().is_some() && self.range(over).lo >= 0.0,
            Meaning::Any | Meaning::Reciprocal(_) => false,
            _ => true,
        })
    }

    /// Whether a polynomial that is divided by is above 0 whatever the variables are.
    pub fn is_positive(&self, p: &Polynomial) -> bool {
        let exponential =
            |k: usize| self.meanings[k] == Meaning::Positive && *p == Multivariate::x(self.domain.len() + k);
        self.range(p).lo > 0.0 || (0..self.meanings.len()).any(exponential)
    }

    /// A polynomial without the exponentials that all its terms have as factors: they are above 0.
    pub fn without_positive(&self, p: &Polynomial) -> Polynomial {
        let positive = (0..self.meanings.len()).filter(|&k| self.meanings[k] == Meaning::Positive);
        positive.map(|k| Multivariate::x(self.domain.len() + k)).fold(p.clone(), |mut rest, x| {
            while let Some(divided) = rest.divided_by(&x).filter(|_| !rest.is_zero()) {
                rest = divided;
            }
            rest
        })
    }

    /// Encloses the values of a polynomial, whatever the variables are.
    pub fn range(&self, p: &Polynomial) -> Extended {
        let hull = |k: usize| {
            let side = self.side(k);
            Extended::hull(side.lo.as_ref(), side.hi.as_ref())
        };
        let zero = Extended::between(0.0, 0.0);
        let at: Vec<Extended> = (0..p.arity()).map(hull).collect();
        p.at(&at, &zero, |c| zero.rational(c))
    }

    /// The square of a root of a polynomial.
    pub fn square_of(&self, variable: usize) -> Option<Polynomial> {
        match self.meanings.get(variable.checked_sub(self.domain.len())?)? {
            Meaning::Root(over, under) => Some(over.scaled(&under.as_constant()?.recip())),
            _ => None,
        }
    }

    /// Goals without the last root or absolute value, that together are the goal; `None` where there is none in it. Roots of polynomials stay if that is asked.
    pub fn without_last(&self, goal: &Goal, roots_stay: bool) -> Option<Vec<Goal>> {
        let arity = self.domain.len();
        let used = |variable: usize| {
            goal.target.degree_in(variable) > 0 || goal.constraints.iter().any(|(p, _)| p.degree_in(variable) > 0)
        };
        let place = (0..self.meanings.len())
            .rev()
            .filter(|&k| !(roots_stay && self.square_of(arity + k).is_some()))
            .find(|&k| used(arity + k) && matches!(self.meanings[k], Meaning::Root(..) | Meaning::Absolute(..)))?;
        match &self.meanings[place] {
            Meaning::Absolute(over, under) => {
                Some([1, -1].map(|sign| signed(goal, arity + place, over, under, sign)).into())
            }
            Meaning::Root(over, under) => Some(self.without_root(goal, arity + place, over, under)),
            _ => None,
        }
    }

    /// `a + b r >= 0` with `r² = over/under` and `r >= 0`: where `b >= 0`, nothing is to be shown unless `a <= 0`, and then `b² r² >= a²`; where `b <= 0`,
    /// `a >= 0` and `a² >= b² r²`.
    fn without_root(&self, goal: &Goal, variable: usize, over: &Polynomial, under: &Polynomial) -> Vec<Goal> {
        let radicand = over.clone() * under;
        // (b r)² - a², times the square of the denominator.
        let apart = |a: &Polynomial, b: &Polynomial| b.square() * &radicand - a.square() * under.square();
        let mut constraints = vec![(radicand.clone(), false)];
        for (p, strict) in &goal.constraints {
            let (c, d) = linear(p, variable, over, under);
            if d.is_zero() {
                constraints.push((c, *strict));
            } else if self.range(&d).hi <= 0.0 {
                constraints.extend([(-apart(&c, &d), *strict), (c, *strict)]);
            } else if self.range(&d).lo >= 0.0 && self.range(&c).hi <= 0.0 {
                constraints.push((apart(&c, &d), *strict));
            }
        }
        let with = |more: Vec<Polynomial>, target: Polynomial, strict: bool| {
            let all = constraints.iter().cloned().chain(more.into_iter().map(|p| (p, false)));
            Goal { constraints: all.filter(|(p, _)| p.as_constant().is_none()).collect(), target, strict }
        };
        let (a, b) = linear(&goal.target, variable, over, under);
        if b.is_zero() {
            return vec![with(Vec::new(), a, goal.strict)];
        }
        let (of_a, of_b) = (self.range(&a), self.range(&b));
        let seen = if goal.strict { of_a.lo > 0.0 } else { of_a.lo >= 0.0 };
        let mut list = Vec::new();
        let (negative, positive) = (of_b.hi <= 0.0, of_b.lo >= 0.0);
        // Where it is both, `b` is 0.
        if (positive || !negative) && !seen {
            list.push(with(vec![b.clone(), -a.clone()], apart(&a, &b), goal.strict));
        }
        if !positive {
            if of_a.lo < 0.0 {
                list.push(with(vec![-b.clone()], a.clone(), false));
            }
            list.push(with(vec![-b.clone()], -apart(&a, &b), goal.strict));
        }
        list
    }
}

/// With `|over/under|` replaced by `over/under` where that is at least 0, or by its negative where it is at most 0.
fn signed(goal: &Goal, variable: usize, over: &Polynomial, under: &Polynomial, sign: i64) -> Goal {
    let inside = over.clone() * under * Multivariate::of(rational(sign, 1));
    let put = |p: &Polynomial| {
        let (a, b) = linear(p, variable, &over.square(), &under.square());
        if b.is_zero() { a } else { a * under.square() + b * &inside }
    };
    let mut constraints: Vec<(Polynomial, bool)> =
        goal.constraints.iter().map(|(p, strict)| (put(p), *strict)).collect();
    constraints.push((inside.clone(), false));
    Goal { constraints, target: put(&goal.target), strict: goal.strict }
}
