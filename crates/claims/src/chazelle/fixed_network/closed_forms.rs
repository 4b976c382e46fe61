//! chazelle.xi.closed, chazelle.eq3.16, chazelle.eq3.17: where a bird is while the network does not change.

use super::FAMILY;
use super::flight::{Flight, Flock, Vector, add, combine, flights};
use crate::prelude::*;
use num_traits::{Signed, Zero};

#[derive(Clone, Copy)]
pub struct ClosedFormVariant {
    /// The first index of the sum.
    first: usize,
    /// The exponent is this multiple of `t - t_1`, and so much more.
    exponent: (i64, i64),
    /// `v(t_1 + 1)`, or 1 step earlier.
    earlier: usize,
    /// The half powers in `Phi_k`.
    halves: (i32, i32),
    /// The factor of the primed part, for two birds.
    primed: i64,
    /// The network changes this many steps too early.
    broken: usize,
}

const PRINTED: ClosedFormVariant =
    ClosedFormVariant { first: 2, exponent: (1, 0), earlier: 0, halves: (1, -1), primed: 1, broken: 0 };

/// `d` and `t_1` of the flights.
const DIMENSIONS_AND_STARTS: [(usize, usize); 2] = [(1, 1), (2, 3)];

/// One term of a sum of powers: `factor * base^(t - t_1)`.
struct Term {
    base: Rational,
    factor: Vector,
}

struct Expansion {
    /// `x_i(t_1)`.
    start: Vector,
    /// `(chi(i)^T Gamma) v(t_1 + 1)`.
    ahead: Vector,
    /// `y`.
    y: Vector,
    /// `lambda_k` and `Phi_k/(1 - lambda_k)`.
    terms: Vec<Term>,
}

/// A value, or the reason why a formula has none.
type Attempt<T> = Result<Result<T, String>, CheckError>;

impl ClosedFormVariant {
    fn power(&self, base: &Rational, steps: usize) -> Rational {
        base.pow((steps as i64 * self.exponent.0 + self.exponent.1) as i32)
    }

    /// `lambda_k` and `Phi_k/(1 - lambda_k)` for the terms of the sum; the error says which term has no value.
    fn terms(&self, flock: &Flock, bird: usize, velocities: &[Vector]) -> Attempt<Vec<Term>> {
        let mut terms = Vec::new();
        for k in self.first..=flock.modes.len() {
            let Some(mode) = k.checked_sub(1).map(|k| &flock.modes[k]) else {
                return Ok(Err(
                    "the term k = 0 has no value (the eigenvalues are lambda_1, .., lambda_m), and k = 1 would divide \
                     by 1 - lambda_1 = 0"
                        .into(),
                ));
            };
            let gap = rational(1, 1) - &mode.eigenvalue;
            if gap.is_zero() {
                return Ok(Err(format!("the term k = {k} divides by 1 - lambda_{k} = 0")));
            }
            let mut dyad = mode.dyad(&flock.network.c, self.halves.0, self.halves.1)?;
            let row: Vec<Rational> = dyad.swap_remove(bird).into_iter().map(|x| x / &gap).collect();
            terms.push(Term { base: mode.eigenvalue.clone(), factor: combine(&row, velocities) });
        }
        Ok(Ok(terms))
    }

    fn sum(&self, terms: &[Term], steps: usize, start: Vector) -> Vector {
        terms.iter().fold(start, |sum, term| add(&sum, &-self.power(&term.base, steps), &term.factor))
    }

    /// The parts of the formulas for one bird of flock `f`.
    fn expansion(&self, flight: &Flight, f: usize, bird: usize) -> Attempt<Expansion> {
        let (flock, velocities) = (&flight.flocks[f], flight.velocities(f, self.earlier));
        let expansion = |terms| Expansion {
            start: flight.start(f, bird),
            ahead: combine(&flock.gamma_row(bird), &velocities),
            y: combine(&flock.pi, &velocities),
            terms,
        };
        Ok(self.terms(flock, bird, &velocities)?.map(expansion))
    }

    /// The position of one bird: with `gamma` as in the display before equation (3.17), otherwise by the geometric
    /// sums of the first display of the proof of Lemma 3.9.
    fn one_bird(&self, flight: &Flight, bird: usize, gamma: bool) -> Result<Option<String>, CheckError> {
        let parts = match self.expansion(flight, 0, bird)? {
            Ok(parts) => parts,
            Err(what) => return Ok(Some(what)),
        };
        for (steps, position) in flight.positions(0, bird).enumerate() {
            let moved = add(&parts.start, &rational(steps as i64, 1), &parts.y);
            let moved = if gamma {
                add(&moved, &rational(1, 1), &parts.ahead)
            } else {
                parts.terms.iter().fold(moved, |sum, term| add(&sum, &rational(1, 1), &term.factor))
            };
            let claimed = self.sum(&parts.terms, steps, moved);
            if claimed != position {
                let (at, claimed) = (list(&position), list(&claimed));
                return Ok(Some(format!("bird {}, t - t_1 = {steps}: it is at ({at}), not ({claimed})", bird + 1)));
            }
        }
        Ok(None)
    }

    /// Equation (3.17) for bird `i` of flock `f` and bird `j` of flock `g`, which may be the same flock.
    fn two_birds(
        &self,
        flight: &Flight,
        (f, i): (usize, usize),
        (g, j): (usize, usize),
    ) -> Result<Option<String>, CheckError> {
        let (first, second) = match (self.expansion(flight, f, i)?, self.expansion(flight, g, j)?) {
            (Ok(first), Ok(second)) => (first, second),
            (Err(what), _) | (_, Err(what)) => return Ok(Some(what)),
        };
        let (minus, primed) = (rational(-1, 1), rational(-self.primed, 1));
        let zero = vec![rational(0, 1); flight.dimension];
        let a =
            add(&add(&first.start, &minus, &second.start), &rational(1, 1), &add(&first.ahead, &primed, &second.ahead));
        let b = add(&first.y, &primed, &second.y);
        let mut psi = first.terms;
        psi.extend(second.terms.into_iter().map(|term| Term { factor: add(&zero, &primed, &term.factor), ..term }));
        psi.sort_by(|x, y| y.base.cmp(&x.base));
        if let Some(term) = psi.iter().find(|term| term.base.abs() >= rational(1, 1)) {
            return Ok(Some(format!("the value {} of mu is not inside (-1, 1)", term.base)));
        }
        let names = format!("bird {} of flock {} and {} of flock {}", i + 1, f + 1, j + 1, g + 1);
        if f == g && b != zero {
            return Ok(Some(format!("{names}: B is not 0 in the same flock")));
        }
        for (steps, (x, y)) in flight.positions(f, i).zip(flight.positions(g, j)).enumerate() {
            let moved = add(&a, &rational(steps as i64, 1), &b);
            let (claimed, found) = (self.sum(&psi, steps, moved), add(&x, &minus, &y));
            if claimed != found {
                let (found, claimed) = (list(&found), list(&claimed));
                return Ok(Some(format!("{names}, t - t_1 = {steps}: they are ({found}) apart, not ({claimed})")));
            }
        }
        Ok(None)
    }

    /// Runs a check on every flight of every pair of flocks.
    fn examine(
        &self,
        run: &Run,
        part: &str,
        check: impl Fn(&Flight) -> Result<Option<String>, CheckError>,
    ) -> Result<Outcome, CheckError> {
        let mut random = run.random(0);
        let pairs = flights(run.cases(5, 7))?;
        let cases = pairs.iter().flat_map(|pair| DIMENSIONS_AND_STARTS.map(|start| (pair, start)));
        let detail = format!(
            "{FAMILY} with rational eigenvalues and three kinds of weights, in pairs of flocks of 5 birds in all (7 \
             with --full); d = 1 and t_1 = 1, d = 2 and t_1 = 3 after another network, t = t_1, .., t_1 + 5, random \
             input"
        );
        run.instances(part, &detail, cases, |(pair, (dimension, first))| {
            let flight = Flight::new(pair, dimension, first, self.broken, &mut random)?;
            Ok(check(&flight)?.map(|what| format!("{}: {what}", flight.show())))
        })
    }
}

/// The first thing that is wrong with any bird of the first flock.
fn any_bird(
    flight: &Flight,
    check: impl Fn(usize) -> Result<Option<String>, CheckError>,
) -> Result<Option<String>, CheckError> {
    for bird in 0..flight.flocks[0].order() {
        if let Some(what) = check(bird)? {
            return Ok(Some(what));
        }
    }
    Ok(None)
}

pub fn geometric_sums() -> Record<ClosedFormVariant> {
    Record::new(
        "chazelle.xi.closed",
        "v(s) = P^(s-t_1-1) v(t_1+1) for t_1 < s <= t, so x_i(t) - x_i(t_1) is row i of I + P + .. + P^(t-t_1-1), t - \
         t_1 terms, times v(t_1+1). Put in (3.8) and sum the geometric series; lambda_k < 1 for k > 1, 0^0 = 1. P, \
         pi, C, u_k belong to the flock of bird i, of m birds; for m = 1 the sum is empty. G at time t_1 itself does \
         not matter: v(t_1+1) has it already.",
        PRINTED,
        |variant, run| {
            variant.examine(run, "x_i(t) by geometric sums, against steps of (1.2)", |flight| {
                any_bird(flight, |bird| variant.one_bird(flight, bird, false))
            })
        },
    )
    .altered("the exponent t - t_1 + 1", |v| v.exponent = (1, 1))
    .altered("the sum from k = 1", |v| v.first = 1)
    .altered("C^-1/2 and C^1/2 exchanged", |v| v.halves = (-1, 1))
    .altered("v(t_1) in place of v(t_1+1)", |v| v.earlier = 1)
    .altered("another network at time t - 1", |v| v.broken = 1)
}

pub fn with_gamma() -> Record<ClosedFormVariant> {
    Record::new(
        "chazelle.eq3.16",
        "The constant parts of chazelle.xi.closed are sum_{k>=2} Phi_k/(1 - lambda_k), which is row i of Gamma times \
         v(t_1+1), because Gamma_t = sum_{k>=2} (1 - lambda_k^t)/(1 - lambda_k) C^1/2 u_k u_k^T C^-1/2 tends to it. \
         The sum that is left runs from k = 2 as well. The printed sum starts at k = 0: there is no lambda_0, and k = \
         1 divides by 1 - lambda_1 = 0.",
        ClosedFormVariant { first: 0, ..PRINTED },
        |variant, run| {
            variant.examine(run, "x_i(t) with Gamma by the formula of Lemma 3.3, against steps of (1.2)", |flight| {
                any_bird(flight, |bird| variant.one_bird(flight, bird, true))
            })
        },
    )
    .repaired(
        Fault::Typo,
        "In model D with birds in R^d let G_t be invariant during [t_1, t-1], t >= t_1. On the flock of bird i let m be the number of \
         birds, P = I - C L the matrix, C the diagonal matrix of the c_j > 0, pi the stationary distribution, u_1, ..., u_m orthonormal \
         eigenvectors of C^{-1/2} P C^{1/2} for its eigenvalues 1 = lambda_1 > lambda_2 >= ... >= lambda_m, chi(i) the unit vector of i, \
         v(s) the velocities of its birds, Gamma = lim_s (I + P + ... + P^{s-1} - s 1 pi^T), y = (pi^T kron I_d) v(t_1+1) and Phi_k = \
         ((chi(i)^T C^{1/2} u_k u_k^T C^{-1/2}) kron I_d) v(t_1+1); an isolated bird has m = 1, P = 1 and Gamma = 0. With 0^0 = 1: x_i(t) = \
         x_i(t_1) + ((chi(i)^T Gamma) kron I_d) v(t_1+1) + (t-t_1) y - sum_{k=2}^m lambda_k^{t-t_1} Phi_k/(1-lambda_k).",
        PRINTED,
    )
    .altered("the sum from k = 1", |v| v.first = 1)
    .altered("the sum from k = 3", |v| v.first = 3)
    .altered("the exponent 2(t - t_1)", |v| v.exponent = (2, 0))
    .altered("v(t_1) in place of v(t_1+1)", |v| v.earlier = 1)
}

pub fn two_birds_apart() -> Record<ClosedFormVariant> {
    Record::new(
        "chazelle.eq3.17",
        "The difference of two copies of the corrected chazelle.eq3.16. A = x_i(t_1) - x_j(t_1) + (chi(i)^T Gamma - \
         chi(j)^T Gamma') v(t_1+1), B = y - y'. The mu_k are the lambda_l and lambda'_l with l > 1, in decreasing \
         order, k = 2, .., m_0 = m + m' - 1; all lie in (-1, 1), some may be 0 or repeated. Psi_k is Phi_l/(1 - \
         lambda_l) or -Phi'_l/(1 - lambda'_l). Birds of the same flock have the same y and B = 0.",
        PRINTED,
        check_two_birds_apart,
    )
    .altered("plus the primed parts", |v| v.primed = -1)
    .altered("mu_k with l >= 1", |v| v.first = 1)
    .altered("mu_k with l > 2", |v| v.first = 3)
    .altered("the exponent 2(t - t_1)", |v| v.exponent = (2, 0))
    .altered("another network at time t - 1", |v| v.broken = 1)
}

fn check_two_birds_apart(variant: &ClosedFormVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    variant.examine(run, "x_i(t) - x_j(t), B and the mu_k, against steps of (1.2)", |flight| {
        let birds = |f: usize| (0..flight.flocks[f].order()).map(move |bird| (f, bird));
        for i in birds(0) {
            for j in birds(0).chain(birds(1)).filter(|j| *j != i) {
                if let Some(what) = variant.two_birds(flight, i, j)? {
                    return Ok(Some(what));
                }
            }
        }
        Ok(None)
    })
}
