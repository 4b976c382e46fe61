//! The expansion of a motion in time and start, in floats, and a proved bound of what it leaves out.
//!
//! In floats, coefficient after coefficient, each operation of the right-hand side gets a polynomial in the time, from 0 to 1 on the step, and in the
//! variables of the start, from -1 to 1. Afterwards each gets a bound of its distance from the operation on the polynomials of the state: what was cut off,
//! what was rounded, and what came from its operands. So nothing is computed twice, and nothing is computed in intervals.

use super::bound::Bound;
use super::shape::Shape;
use super::tape::{Kind, Op, Tape, value_of};
use arithmetic::{ArithmeticError, FloatInterval, Series};

/// Polynomials in time and start, for all operations of a right-hand side.
pub(super) struct Expansion<'a> {
    pub tape: &'a Tape,
    pub shape: &'a Shape,
    /// Powers of the time: 0 to `order - 1`.
    pub order: usize,
    /// Those of the operations, one after the other: by powers of time, then by monomials.
    coefficients: Vec<f64>,
    /// The state, in the same way.
    pub state: Vec<Vec<f64>>,
    /// The sums of the absolute coefficients: by operations, powers of time, degrees.
    norms: Vec<Bound>,
    /// Zeros, and room for what is computed.
    scratch: Vec<f64>,
}

impl<'a> Expansion<'a> {
    /// The expansion from polynomials in the start, over a step of this length from this time.
    pub fn new(
        tape: &'a Tape,
        shape: &'a Shape,
        order: usize,
        start: &[Vec<f64>],
        (time, length): (f64, f64),
    ) -> Result<Self, ArithmeticError> {
        let size = shape.size();
        let lift = |polynomial: &Vec<f64>| {
            let mut series = vec![0.0; order * size];
            series[..size].copy_from_slice(polynomial);
            series
        };
        let mut state: Vec<Vec<f64>> = start.iter().map(lift).collect();
        let mut clock = vec![0.0; order * size];
        clock[0] = time;
        clock[size] = length;
        state.push(clock);
        let mut expansion = Expansion {
            coefficients: vec![0.0; tape.ops.len() * order * size],
            norms: vec![Bound::ZERO; tape.ops.len() * order * (shape.degree + 1)],
            scratch: vec![0.0; 3 * size],
            tape,
            shape,
            order,
            state,
        };
        for power in 0..order {
            expansion.advance(power)?;
            expansion.integrate(power, length);
        }
        Ok(expansion)
    }

    pub fn of(&self, id: usize, power: usize) -> &[f64] {
        let (size, from) = (self.shape.size(), id * self.order + power);
        &self.coefficients[from * size..][..size]
    }

    /// The polynomials of an operation, by powers of time.
    pub fn all(&self, id: usize) -> &[f64] {
        let size = self.order * self.shape.size();
        &self.coefficients[id * size..][..size]
    }

    /// The coefficients of one power of time of all operations.
    fn advance(&mut self, power: usize) -> Result<(), ArithmeticError> {
        let size = self.shape.size();
        let mut result = std::mem::take(&mut self.scratch);
        for (id, op) in self.tape.ops.iter().enumerate() {
            let out = &mut result[..size];
            out.fill(0.0);
            match *op {
                Op::Input(index) => out.copy_from_slice(&self.state[index][power * size..][..size]),
                Op::Constant(value) if power == 0 => out[0] = value.midpoint(),
                Op::Constant(_) => {}
                Op::Sum(a, b) => pairwise(out, self.of(a, power), self.of(b, power), |x, y| x + y),
                Op::Difference(a, b) => pairwise(out, self.of(a, power), self.of(b, power), |x, y| x - y),
                Op::Product(a, b) => self.product(a, b, power, out),
                Op::Function(kind, a, partner) => self.function(kind, (id, a, partner), power, &mut result)?,
            }
            let from = (id * self.order + power) * size;
            self.coefficients[from..from + size].copy_from_slice(&result[..size]);
            let degrees = self.shape.degree + 1;
            let place = &mut self.norms[(id * self.order + power) * degrees..][..degrees];
            place.iter_mut().zip(self.shape.norms(&result[..size])).for_each(|(slot, norm)| *slot = norm);
        }
        self.scratch = result;
        Ok(())
    }

    fn product(&self, a: usize, b: usize, power: usize, out: &mut [f64]) {
        let constant = |id: usize| match self.tape.ops[id] {
            Op::Constant(value) => Some(value.midpoint()),
            _ => None,
        };
        match (constant(a), constant(b)) {
            (Some(x), _) => out.iter_mut().zip(self.of(b, power)).for_each(|(out, y)| *out = x * y),
            (_, Some(x)) => out.iter_mut().zip(self.of(a, power)).for_each(|(out, y)| *out = x * y),
            _ => (0..=power).for_each(|k| self.shape.multiply_add(self.of(a, k), self.of(b, power - k), out)),
        }
    }

    /// A coefficient of a function; the first `size` numbers of `room` take it.
    fn function(
        &self,
        kind: Kind,
        (id, a, partner): (usize, usize, usize),
        power: usize,
        room: &mut [f64],
    ) -> Result<(), ArithmeticError> {
        let (out, room) = room.split_at_mut(self.shape.size());
        if power == 0 {
            out.copy_from_slice(&composed(self.shape, kind, self.of(a, 0))?);
            return Ok(());
        }
        let (sum, rest) = room.split_at_mut(self.shape.size());
        sum.fill(0.0);
        match kind {
            // r a = 1: r_n = -r_0 (a_1 r_(n-1) + ..).
            Kind::Reciprocal => {
                (1..=power).for_each(|k| self.shape.multiply_add(self.of(a, k), self.of(id, power - k), sum));
                sum.iter_mut().for_each(|x| *x = -*x);
                self.shape.multiply_add(sum, self.of(id, 0), out);
            }
            // r r = a: r_n = (a_n - r_1 r_(n-1) - ..)/(2 r_0).
            Kind::Root => {
                (1..power).for_each(|k| self.shape.multiply_add(self.of(id, k), self.of(id, power - k), sum));
                sum.iter_mut().zip(self.of(a, power)).for_each(|(x, own)| *x = 0.5 * (own - *x));
                rest[..self.shape.size()].copy_from_slice(&composed(self.shape, Kind::Reciprocal, self.of(id, 0))?);
                self.shape.multiply_add(sum, &rest[..self.shape.size()], out);
            }
            // n f_n = sum k a_k g_(n-k) with the derivative g.
            _ => {
                for k in 1..=power {
                    let factor = k as f64 / power as f64 * if kind == Kind::Cosine { -1.0 } else { 1.0 };
                    sum.iter_mut().zip(self.of(a, k)).for_each(|(x, own)| *x = factor * own);
                    self.shape.multiply_add(sum, self.of(partner, power - k), out);
                }
            }
        }
        Ok(())
    }

    /// The coefficients of the next power of time of the state.
    fn integrate(&mut self, power: usize, length: f64) {
        let size = self.shape.size();
        if power + 1 == self.order {
            return;
        }
        let factor = length / (power + 1) as f64;
        for (index, &output) in self.tape.outputs.iter().enumerate() {
            let from = (output * self.order + power) * size;
            let rate = &self.coefficients[from..from + size];
            let next = &mut self.state[index][(power + 1) * size..][..size];
            next.iter_mut().zip(rate).for_each(|(x, rate)| *x = factor * rate);
        }
    }

    /// Sums of the absolute coefficients of an operation: by powers of time, then degrees.
    pub fn norms(&self, id: usize) -> &[Bound] {
        let size = self.order * (self.shape.degree + 1);
        &self.norms[id * size..][..size]
    }

    pub fn norm(&self, id: usize) -> Bound {
        self.norms(id).iter().copied().sum()
    }

    /// The sum of the absolute coefficients of the last power of time of the state: the size of what is cut off.
    pub fn last(&self) -> f64 {
        let size = self.shape.size();
        let own = |series: &Vec<f64>| series[(self.order - 1) * size..].iter().fold(0.0, |sum, x| sum + x.abs());
        self.state.iter().map(own).fold(0.0, f64::max)
    }

    /// A bound of the distance of a number of the state from the one that another expansion has, of a lower order and degree.
    pub fn distance_of(&self, other: &Expansion, index: usize) -> Bound {
        let (size, theirs) = (self.shape.size(), other.shape.size());
        let apart = self.state[index].chunks_exact(size).enumerate().flat_map(|(power, own)| {
            let lower = other.state[index].get(power * theirs..(power + 1) * theirs).unwrap_or(&[]);
            own.iter().enumerate().map(|(k, x)| x - lower.get(k).copied().unwrap_or(0.0))
        });
        Bound::total(apart)
    }

    /// Encloses the values of a number of the state (the time after all others) during a part of the step, `during` from 0 to 1.
    pub fn range(&self, index: usize, during: FloatInterval) -> FloatInterval {
        range(self.shape, &self.state[index], during)
    }
}

fn pairwise(out: &mut [f64], a: &[f64], b: &[f64], f: impl Fn(f64, f64) -> f64) {
    out.iter_mut().zip(a.iter().zip(b)).for_each(|(out, (x, y))| *out = f(*x, *y));
}

/// Encloses the values of a polynomial in time and start during a part of the step.
pub(super) fn range(shape: &Shape, series: &[f64], during: FloatInterval) -> FloatInterval {
    let zero = FloatInterval::point(0.0);
    series.rchunks_exact(shape.size()).fold(zero, |sum, c| sum * during + shape.range(c))
}

/// The coefficients `f^(j)(c)/j!`, `j` up to `degree`.
pub(super) fn expanded<T: arithmetic::Real>(kind: Kind, at: T, degree: usize) -> Result<Vec<T>, ArithmeticError> {
    let zero = at.zero();
    let rest = (1..=degree).map(|j| if j == 1 { at.one() } else { zero.clone() });
    Ok(value_of(kind, &Series::from_coefficients(at.clone(), rest))?.coefficients().to_vec())
}

/// A function of a polynomial in the start, in floats.
pub(super) fn composed(shape: &Shape, kind: Kind, a: &[f64]) -> Result<Vec<f64>, ArithmeticError> {
    let list = expanded(kind, a[0], shape.degree)?;
    let mut rest = a.to_vec();
    rest[0] = 0.0;
    let mut sum = vec![0.0; shape.size()];
    for c in list.iter().rev() {
        let mut next = vec![0.0; shape.size()];
        shape.multiply_add(&sum, &rest, &mut next);
        next[0] += c;
        sum = next;
    }
    Ok(sum)
}
