//! Points on a surface that an equation names, at which all that is left of a clause is false: all numbers but one are rational, and that one is a square root.

use super::local::Signs;
use super::places::{Place, free, simple, truth};
use super::points::slack;
use super::reduction::polynomials;
use crate::function::{Compared, Function, Literal, Side};
use crate::multivariate::Multivariate;
use arithmetic::{Rational, Sign, random};
use num_traits::{Signed, ToPrimitive};

/// Starts of the search.
const STARTS: usize = 24;
/// Times that its steps are halved.
const HALVINGS: usize = 30;
/// Steps of one length along all numbers, at most.
const MOVES: usize = 40;
/// Values below this are looked at exactly.
const NEAR: f64 = 1e-9;

/// `v² = square`, or the clause is true.
struct Surface {
    variable: usize,
    square: Multivariate<Rational>,
    /// The literal that says so.
    literal: usize,
}

fn surface<F: Function>(clause: &[Literal<F>], domain: &[Side], free: &[usize]) -> Option<Surface> {
    let all = polynomials(clause, domain.len(), |compared| compared == Compared::NotZero);
    all.into_iter().enumerate().find_map(|(literal, p)| {
        let p = p?;
        free.iter().rev().find_map(|&variable| {
            let parts = p.in_variable(variable);
            let [rest, linear, lead] = &parts[..] else { return None };
            let lead = lead.as_constant().filter(|_| linear.is_zero() && !domain[variable].integer)?;
            Some(Surface { variable, square: rest.scaled(&-lead.recip()), literal })
        })
    })
}

struct Search<'a, F> {
    clause: &'a [Literal<F>],
    domain: &'a [Side],
    surface: Surface,
    /// The other free numbers.
    others: Vec<usize>,
}

impl<F: Function> Search<'_, F> {
    /// How far the clause is from being false where the last number is a root of this sign, in floats.
    fn slack(&self, x: &[f64], sign: f64) -> Option<f64> {
        let mut x = x.to_vec();
        let square = self.surface.square.at(&x, &0.0, |c| c.to_f64().unwrap_or(f64::NAN));
        let root = sign * square.sqrt();
        let (lo, hi) = self.domain[self.surface.variable].floats();
        if root.is_nan() || root < lo || root > hi {
            return None;
        }
        x[self.surface.variable] = root;
        let others = self.clause.iter().enumerate().filter(|(k, _)| *k != self.surface.literal);
        others
            .map(|(_, literal)| slack(literal, &x))
            .try_fold(f64::NEG_INFINITY, |most, own| own.map(|own| most.max(own)))
    }

    /// Downhill along each number, with smaller and smaller steps.
    fn descend(&self, mut x: Vec<f64>, sign: f64) -> Vec<f64> {
        let Some(mut best) = self.slack(&x, sign) else { return x };
        let mut step = 0.5;
        for _ in 0..HALVINGS {
            for _ in 0..MOVES {
                let before = best;
                for &k in &self.others {
                    let (lo, hi) = self.domain[k].floats();
                    for by in [step, -step] {
                        let mut next = x.clone();
                        next[k] = (next[k] + by).clamp(lo, hi);
                        if let Some(lower) = self.slack(&next, sign).filter(|lower| *lower < best) {
                            (x, best) = (next, lower);
                        }
                    }
                }
                if best == before {
                    break;
                }
            }
            step /= 2.0;
        }
        x
    }

    /// The same point exactly, at rationals near the floats.
    fn exactly(&self, x: &[f64], sign: f64) -> Option<Vec<Place>> {
        [1e-3, 1e-5, 1e-8, 1e-12].into_iter().find_map(|reach| {
            let near = |(k, side): (usize, &Side)| match self.others.contains(&k) {
                true => Some(side.nearest(simple(x[k], reach * x[k].abs().max(1e-3), i64::MAX)?)),
                false => Some(side.middle()),
            };
            let point: Vec<Rational> = self.domain.iter().enumerate().map(near).collect::<Option<_>>()?;
            let square = self.surface.square.value(&point);
            if square.is_negative() {
                return None;
            }
            let mut places: Vec<Place> = point.into_iter().map(Place::of).collect();
            places[self.surface.variable] =
                Place::root(square, if sign > 0.0 { Sign::Positive } else { Sign::Negative });
            let is_in = places[self.surface.variable].is_in(&self.domain[self.surface.variable]);
            (is_in && truth(self.clause, &places) == Signs::Fails).then_some(places)
        })
    }
}

/// A point of the surface at which the clause is false, exactly.
pub(super) fn fails_on<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Option<Vec<Place>> {
    let free = free(domain);
    let surface = surface(clause, domain, &free).filter(|_| clause.len() > 1)?;
    let others: Vec<usize> = free.into_iter().filter(|&k| k != surface.variable).collect();
    if others.iter().any(|&k| domain[k].integer) {
        return None;
    }
    let search = Search { clause, domain, surface, others };
    let mut stream = random::generator("inequality", "surfaces", domain.len() as u64);
    (0..STARTS).find_map(|_| {
        let x: Vec<f64> =
            domain.iter().map(|side| super::attained::at_share(side, random::uniform(&mut stream))).collect();
        // Towards the inside of the surface.
        let shrunk = |by: f64| -> Vec<f64> {
            let own = |k: usize| if search.others.contains(&k) { x[k] * by } else { x[k] };
            (0..x.len()).map(own).collect()
        };
        let starts = [1.0, 0.3, 0.1, 0.01].map(shrunk);
        [1.0, -1.0].into_iter().find_map(|sign| {
            let start = starts.iter().find(|x| search.slack(x, sign).is_some())?;
            let lowest = search.descend(start.clone(), sign);
            search.slack(&lowest, sign).filter(|slack| *slack <= NEAR)?;
            search.exactly(&lowest, sign)
        })
    })
}
