//! How a number depends on how many agents there are.
//!
//! A number is of *order* k where it is a sum of terms of at most k agents each: sums add one, products add up. Its coefficients are quotients of polynomials in the
//! number N of agents, over powers of N (means over all) and N - 1 (means over those whom an agent of a complete network hears). A number of order k whose
//! coefficients have a numerator of degree d is 0 for all N >= 2, whatever the states, if it is for N = 2, .., k + d + 2 (`notes/laws.md`).

use crate::program::{Gather, Id, Op, Program};
use arithmetic::{Rational, rational};
use num_traits::Zero;

/// The order of a number, and of its coefficients over `N^all (N - 1)^others` the degree in N.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Bodies {
    /// Agents in a term.
    pub order: u32,
    /// Degree of the numerators in N.
    pub degree: u32,
    /// Powers of N below them.
    pub all: u32,
    /// Powers of N - 1 below them.
    pub others: u32,
    /// Whether a mean or a count of those whom an agent hears occurs: its meaning depends on the network.
    pub complete_only: bool,
}

impl Bodies {
    fn is_plain(self) -> bool {
        (self.order, self.degree, self.all, self.others) == (0, 0, 0, 0)
    }

    /// That of a sum of two.
    pub fn sum(self, other: Self) -> Self {
        let (all, others) = (self.all.max(other.all), self.others.max(other.others));
        let raised = |one: Self| one.degree + (all - one.all) + (others - one.others);
        Bodies {
            order: self.order.max(other.order),
            degree: raised(self).max(raised(other)),
            all,
            others,
            complete_only: self.complete_only || other.complete_only,
        }
    }

    fn product(self, other: Self) -> Self {
        Bodies {
            order: self.order + other.order,
            degree: self.degree + other.degree,
            all: self.all + other.all,
            others: self.others + other.others,
            complete_only: self.complete_only || other.complete_only,
        }
    }

    /// Everything that it needs is of this size at most, or nothing is claimed.
    fn bounded(self) -> Option<Self> {
        const MOST: u32 = 24;
        [self.order, self.degree, self.all, self.others].iter().all(|size| *size <= MOST).then_some(self)
    }
}

/// Of what is a function of the agents that are bound, without the number of agents.
fn plain<const N: usize>(all: [Bodies; N]) -> Option<Bodies> {
    let complete_only = all.iter().any(|own| own.complete_only);
    all.iter().all(|own| own.is_plain()).then_some(Bodies { complete_only, ..Bodies::default() })
}

/// A number `a N + b`.
type Linear = (Rational, Rational);

impl Program {
    /// The order and degree of the first result, where they are known.
    pub(crate) fn bodies(&self) -> Option<Bodies> {
        let mut known: Vec<Option<Bodies>> = Vec::with_capacity(self.ops.len());
        let mut linear: Vec<Option<Linear>> = Vec::with_capacity(self.ops.len());
        // What a thing needs has a smaller number.
        for op in &self.ops {
            let found = self.bodies_of(op, &known, &linear).and_then(Bodies::bounded);
            known.push(found);
            linear.push(self.linear(op, &linear));
        }
        known[*self.outputs.first()?]
    }

    fn bodies_of(&self, op: &Op, known: &[Option<Bodies>], linear: &[Option<Linear>]) -> Option<Bodies> {
        let of = |id: &Id| known[*id];
        match op {
            Op::Number(_) | Op::Pi | Op::Time => Some(Bodies::default()),
            Op::Agents => Some(Bodies { degree: 1, ..Bodies::default() }),
            // Of one that is bound outside; one that is named is not treated like the others.
            Op::State { of: crate::program::Of::Slot(_), .. } => Some(Bodies::default()),
            Op::State { .. } | Op::Parameter(..) => None,
            Op::Negated(a) => of(a),
            Op::Sum(a, b) | Op::Difference(a, b) => Some(of(a)?.sum(of(b)?)),
            Op::Product(a, b) => Some(of(a)?.product(of(b)?)),
            Op::Power(a, exponent) => {
                let base = of(a)?;
                let times = |size: u32| size.checked_mul(*exponent);
                Some(Bodies {
                    order: times(base.order)?,
                    degree: times(base.degree)?,
                    all: times(base.all)?,
                    others: times(base.others)?,
                    ..base
                })
            }
            Op::Quotient(a, b) => {
                let (above, below) = (of(a)?, of(b)?);
                let complete_only = above.complete_only || below.complete_only;
                if below.is_plain() {
                    return Some(Bodies { complete_only, ..above });
                }
                // Powers of c N and c (N - 1).
                let (base, times) = match &self.ops[*b] {
                    Op::Power(base, times) => (*base, *times),
                    _ => (*b, 1),
                };
                let (slope, constant) = linear[base].clone()?;
                if slope.is_zero() {
                    return (!constant.is_zero()).then_some(Bodies { complete_only, ..above });
                }
                if constant.is_zero() {
                    return Some(Bodies { all: above.all.checked_add(times)?, complete_only, ..above });
                }
                let others = above.others.checked_add(times)?;
                (constant == -slope).then_some(Bodies { others, complete_only, ..above })
            }
            Op::Function(_, a) | Op::Absolute(a) => plain([of(a)?]),
            // Of one term; whatever they are functions of its agents.
            Op::Angle(a, b) | Op::Larger(a, b) | Op::Smaller(a, b) | Op::Compared(_, a, b) | Op::Both(a, b) => {
                plain([of(a)?, of(b)?])
            }
            Op::Not(a) => plain([of(a)?]),
            Op::Choice(condition, a, b) => {
                let (condition, a, b) = (plain([of(condition)?])?, of(a)?, of(b)?);
                Some(Bodies {
                    complete_only: condition.complete_only || a.complete_only || b.complete_only,
                    ..a.sum(b)
                })
            }
            Op::Gathered(number, place) => {
                let this = &self.loops[*number];
                let (gather, body) = this.bodies[*place];
                let condition = this.condition.map_or(Some(Bodies::default()), |id| plain([known[id]?]))?;
                let inner = known[body]?;
                let complete_only = condition.complete_only || inner.complete_only;
                let inner = Bodies { complete_only, ..inner };
                let heard = self.slots[this.slot].hears.is_some();
                let more = Bodies { order: inner.order + 1, ..inner };
                Some(match gather {
                    Gather::Sum => more,
                    // How many there are that fulfil a condition is a sum, too; a mean over them is none.
                    Gather::Count if this.condition.is_some() => more,
                    _ if this.condition.is_some() => return None,
                    Gather::Mean if heard => Bodies { others: more.others + 1, complete_only: true, ..more },
                    Gather::Mean => Bodies { all: more.all + 1, ..more },
                    Gather::Count => Bodies { degree: 1, complete_only: heard, ..Bodies::default() },
                    Gather::Largest | Gather::Smallest => return None,
                })
            }
        }
    }

    /// A number that depends on nothing but N, and that linearly, on a complete network.
    fn linear(&self, op: &Op, known: &[Option<Linear>]) -> Option<Linear> {
        let of = |id: &Id| known[*id].clone();
        let number = |n: i64| rational(n, 1);
        match op {
            Op::Number(q) => Some((number(0), q.clone())),
            Op::Agents => Some((number(1), number(0))),
            Op::Negated(a) => of(a).map(|(slope, constant)| (-slope, -constant)),
            Op::Sum(a, b) => Some((of(a)?.0 + of(b)?.0, of(a)?.1 + of(b)?.1)),
            Op::Difference(a, b) => Some((of(a)?.0 - of(b)?.0, of(a)?.1 - of(b)?.1)),
            Op::Product(a, b) => match (of(a)?, of(b)?) {
                ((slope, c), (other, d)) if slope.is_zero() => Some((&c * other, c * d)),
                ((slope, c), (other, d)) if other.is_zero() => Some((slope * &d, c * d)),
                _ => None,
            },
            Op::Gathered(number_of, place) => {
                let this = &self.loops[*number_of];
                let heard = self.slots[this.slot].hears.is_some();
                let counts = this.bodies[*place].0 == Gather::Count && this.condition.is_none();
                counts.then(|| (number(1), number(if heard { -1 } else { 0 })))
            }
            _ => None,
        }
    }
}
