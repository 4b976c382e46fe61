//! The expansion of a motion in time and start, in floats, and a proved bound of what it leaves out.
//!
//! In floats, coefficient after coefficient, each operation of the right-hand side gets a polynomial in the time, from 0 to 1 on the step, and in the
//! variables of the start, from -1 to 1. Afterwards each gets a bound of its distance from the operation on the polynomials of the state: what was cut off,
//! what was rounded, and what came from its operands. So nothing is computed twice, and nothing is computed in intervals.

use super::shape::Shape;
use super::tape::{Kind, Op, Tape, value_of};
use arithmetic::{ArithmeticError, Field, FloatInterval, Ring, Series};

/// Half a unit in the last place of 1, with room for the sums of bounds themselves.
pub(super) const UNIT: f64 = f64::EPSILON * 0.51;

/// Products below the smallest normal float are wrong by less than this, all of them together.
pub(super) const TINY: f64 = 1e-290;

/// Makes up for the rounding of a sum or product of bounds of some thousand operations.
pub(super) const UP: f64 = 1.0 + 1e-12;

/// Polynomials in time and start, for all operations of a right-hand side.
pub(super) struct Expansion<'a> {
    tape: &'a Tape,
    shape: &'a Shape,
    /// Powers of the time: 0 to `order - 1`.
    order: usize,
    /// Those of the operations, one after the other: by powers of time, then by monomials.
    coefficients: Vec<f64>,
    /// The state, in the same way.
    pub state: Vec<Vec<f64>>,
    /// The sums of the absolute coefficients: by operations, powers of time, degrees.
    norms: Vec<f64>,
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
            norms: vec![0.0; tape.ops.len() * order * (shape.degree + 1)],
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
    fn all(&self, id: usize) -> &[f64] {
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
            place.iter_mut().zip(self.shape.norms(&result[..size])).for_each(|(slot, norm)| *slot = norm * UP);
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
    pub fn norms(&self, id: usize) -> &[f64] {
        let size = self.order * (self.shape.degree + 1);
        &self.norms[id * size..][..size]
    }

    fn norm(&self, id: usize) -> f64 {
        self.norms(id).iter().sum::<f64>() * UP
    }

    /// The sum of the absolute coefficients of the last power of time of the state: the size of what is cut off.
    pub fn last(&self) -> f64 {
        let size = self.shape.size();
        let own = |series: &Vec<f64>| series[(self.order - 1) * size..].iter().fold(0.0, |sum, x| sum + x.abs());
        self.state.iter().map(own).fold(0.0, f64::max)
    }

    /// Bounds of the distance of the polynomials of the state from solving the equation, over the whole step of a length that is known up to `slack`, given
    /// [`Self::errors`].
    pub fn defects(&self, errors: &[f64], length: f64, slack: f64) -> Vec<f64> {
        let degrees = self.shape.degree + 1;
        let own = |&output: &usize| {
            let norms = self.norms(output);
            // What was cut off, the rounding of h f_k/(k + 1), the distance of the right-hand side, and that of the length.
            let last = norms[(self.order - 1) * degrees..].iter().sum::<f64>();
            let whole = self.norm(output);
            (length * (last + 4.0 * UNIT * whole + errors[output]) + slack * (whole + errors[output])) * UP + TINY
        };
        self.tape.outputs.iter().map(own).collect()
    }

    /// A bound of the distance of a number of the state from the one that another expansion has, of a lower order and degree.
    pub fn distance_of(&self, other: &Expansion, index: usize) -> f64 {
        let (size, theirs) = (self.shape.size(), other.shape.size());
        let mut sum = 0.0;
        for (power, own) in self.state[index].chunks_exact(size).enumerate() {
            let lower = other.state[index].get(power * theirs..(power + 1) * theirs).unwrap_or(&[]);
            for (k, x) in own.iter().enumerate() {
                sum += (x - lower.get(k).copied().unwrap_or(0.0)).abs();
            }
        }
        sum * UP
    }

    /// Encloses the values of a number of the state (the time after all others) during a part of the step, `during` from 0 to 1.
    pub fn range(&self, index: usize, during: FloatInterval) -> FloatInterval {
        range(self.shape, &self.state[index], during)
    }

    /// A bound of what is cut off from the product of two operations: the terms of too high a power of time or degree.
    fn cut(&self, a: &[f64], b: &[f64]) -> f64 {
        let beyond = beyond(b, self.order, self.shape.degree);
        a.iter().zip(&beyond).fold(0.0, |sum, (x, y)| sum + x * y) * UP
    }

    /// What a product in floats is wrong by, at most, in the sum of its coefficients. A coefficient of the power `k` of time and the degree `i` has at most
    /// `(k + 1) 2^i` terms, each of which is rounded as often as it is added, and `4` is for what else is done with it.
    fn rounding(&self, a: &[f64], b: &[f64]) -> f64 {
        let degrees = self.shape.degree + 1;
        rounding(weights(a, degrees), weights(b, degrees))
    }

    /// Bounds of the distance of each operation on states at some distance from theirs, whatever the time of the step and the start, from its own polynomial;
    /// `inputs` are bounds for the numbers of the state and the time.
    pub fn errors(&self, inputs: &[f64]) -> Result<Vec<f64>, ArithmeticError> {
        let mut errors: Vec<f64> = vec![0.0; self.tape.ops.len()];
        for (id, op) in self.tape.ops.iter().enumerate() {
            errors[id] = match *op {
                Op::Input(index) => inputs[index],
                Op::Constant(value) => {
                    let middle = FloatInterval::point(value.midpoint());
                    (value - middle).magnitude()
                }
                Op::Sum(a, b) | Op::Difference(a, b) => (errors[a] + errors[b] + self.norm(id) * UNIT) * UP + TINY,
                Op::Product(a, b) => {
                    let (p, q, e, f) = (self.norm(a), self.norm(b), errors[a], errors[b]);
                    let inherited = p * f + q * e + e * f;
                    (inherited + self.cut(self.norms(a), self.norms(b)) + self.rounding(self.norms(a), self.norms(b)))
                        * UP
                        + TINY
                }
                Op::Function(kind, a, partner) => {
                    let error = self.function_error(kind, (id, a, partner), &errors)?;
                    // Sine and cosine are known together.
                    if partner > id && partner < errors.len() {
                        errors[partner] = error;
                    }
                    error
                }
            };
            if !errors[id].is_finite() {
                return Err(ArithmeticError::Domain("a number within the range of floats"));
            }
        }
        Ok(errors)
    }

    /// The values of an operation on the whole step.
    pub fn whole(&self, id: usize, error: f64) -> FloatInterval {
        range(self.shape, self.all(id), FloatInterval::between(0.0, 1.0)) + FloatInterval::between(-error, error)
    }

    /// The sum of the absolute coefficients of `c - x y`, where `c` has the coefficients of `constant`, with what is cut off and rounded.
    fn residual(&self, constant: &[f64], [x, y]: [&[f64]; 2], norms: [&[f64]; 2]) -> f64 {
        let size = self.shape.size();
        let (mut sum, mut out) = (0.0, vec![0.0; size]);
        for power in 0..self.order {
            out.fill(0.0);
            for k in 0..=power {
                self.shape.multiply_add(&x[k * size..][..size], &y[(power - k) * size..][..size], &mut out);
            }
            let own = &constant[power * size..][..size];
            sum += out.iter().zip(own).fold(0.0, |sum, (x, c)| sum + (c - x).abs());
        }
        let rounded = constant.iter().fold(0.0, |sum, c| sum + c.abs()) * UNIT * 4.0;
        (sum + rounded + self.cut(norms[0], norms[1]) + self.rounding(norms[0], norms[1])) * UP + TINY
    }

    fn function_error(
        &self,
        kind: Kind,
        (id, a, partner): (usize, usize, usize),
        errors: &[f64],
    ) -> Result<f64, ArithmeticError> {
        let argument = self.whole(a, errors[a]);
        // The function has a value, and a derivative that is bounded, wherever the argument may be.
        let value = value_of(kind, &argument)?;
        let least = argument.lo().max(-argument.hi());
        match kind {
            // 1/x - R = (1 - x R)/x.
            Kind::Reciprocal => {
                let mut one = vec![0.0; self.order * self.shape.size()];
                one[0] = 1.0;
                let rest = self.residual(&one, [self.all(a), self.all(id)], [self.norms(a), self.norms(id)]);
                Ok((rest + errors[a] * self.norm(id)) / least * UP + TINY)
            }
            // sqrt x - S = (x - S²)/(sqrt x + S).
            Kind::Root => {
                let rest = self.residual(self.all(a), [self.all(id); 2], [self.norms(id); 2]);
                let below = value.lo() + self.whole(id, 0.0).lo();
                if below <= 0.0 {
                    return Err(ArithmeticError::Argument("sqrt"));
                }
                Ok((rest + errors[a]) / below * UP + TINY)
            }
            _ => self.solved_error(kind, (id, a, partner), (argument, value), errors),
        }
    }

    /// A function F of the polynomial A by its differential equation `F' = A' G` in the time: `F' - A' G` is what the polynomials leave, and the distance
    /// grows from that at the beginning by it and by the distance of G.
    fn solved_error(
        &self,
        kind: Kind,
        (id, a, partner): (usize, usize, usize),
        (argument, value): (FloatInterval, FloatInterval),
        errors: &[f64],
    ) -> Result<f64, ArithmeticError> {
        let rate = |id: usize, sign: f64| derivative(self.all(id), self.order, self.shape.size(), sign);
        let moved = rate(a, if kind == Kind::Cosine { -1.0 } else { 1.0 });
        let degrees = self.shape.degree + 1;
        let mut norms = vec![0.0; self.order * degrees];
        for k in 1..self.order {
            (0..degrees).for_each(|i| norms[(k - 1) * degrees + i] = k as f64 * self.norms(a)[k * degrees + i] * UP);
        }
        let speed = norms.iter().sum::<f64>() * UP;
        let rest = |own: usize, slope: usize, moved: &[f64]| {
            self.residual(&rate(own, 1.0), [moved, self.all(slope)], [&norms, self.norms(slope)])
        };
        let first = |kind: Kind, own: usize| start_error(self.shape, kind, (self.of(a, 0), self.of(own, 0)));
        let own = match kind {
            Kind::Sine | Kind::Cosine => {
                let other = if kind == Kind::Sine { Kind::Cosine } else { Kind::Sine };
                let turned = rate(a, if other == Kind::Cosine { -1.0 } else { 1.0 });
                // The two distances turn into each other, and their length grows by what is left alone.
                first(kind, id)? + first(other, partner)? + rest(id, partner, &moved) + rest(partner, id, &turned)
            }
            Kind::HyperbolicSine | Kind::HyperbolicCosine => {
                let other = if kind == Kind::HyperbolicSine { Kind::HyperbolicCosine } else { Kind::HyperbolicSine };
                let both = first(kind, id)? + first(other, partner)? + rest(id, partner, &moved);
                (both + rest(partner, id, &moved)) * growth(speed)?
            }
            Kind::Exponential => (first(kind, id)? + rest(id, id, &moved)) * growth(speed)?,
            _ => first(kind, id)? + rest(id, partner, &moved) + speed * errors[partner],
        };
        let slope = match kind {
            Kind::Sine | Kind::Cosine => 1.0,
            Kind::Exponential => value.magnitude(),
            Kind::Logarithm => argument.recip()?.magnitude(),
            Kind::ArcTangent => (argument.square() + argument.one()).recip()?.magnitude(),
            _ => value_of(Kind::HyperbolicCosine, &argument)?.magnitude(),
        };
        Ok((own + slope * errors[a]) * UP + TINY)
    }
}

/// For each power of time and degree, the sum of the absolute coefficients of a factor that a term of these cannot be multiplied with.
pub(super) fn beyond(norms: &[f64], order: usize, degree: usize) -> Vec<f64> {
    let degrees = degree + 1;
    let row = |k: usize, from: usize| norms[k * degrees + from..(k + 1) * degrees].iter().sum::<f64>();
    // All terms from a power on, and those below it from a degree on.
    let mut later = vec![0.0; order + 1];
    (0..order).rev().for_each(|k| later[k] = later[k + 1] + row(k, 0));
    let mut higher = vec![0.0; (order + 1) * degrees];
    for k in 0..order {
        (0..degrees).for_each(|i| higher[(k + 1) * degrees + i] = higher[k * degrees + i] + row(k, degrees - i));
    }
    let of = |k: usize, i: usize| (later[order - k] + higher[(order - k) * degrees + i]) * UP;
    (0..order).flat_map(|k| (0..degrees).map(move |i| (k, i))).map(|(k, i)| of(k, i)).collect()
}

/// The sum of absolute coefficients, weighed with 2 to the degree, and the same weighed with the power of time as well.
pub(super) fn weights(norms: &[f64], degrees: usize) -> [f64; 2] {
    let row = |row: &[f64]| row.iter().rev().fold(0.0, |sum, x| 2.0 * sum + x);
    norms.chunks_exact(degrees).zip(0..).fold([0.0, 0.0], |[all, later], (norms, power)| {
        let own = row(norms);
        [all + own, later + f64::from(power) * own]
    })
}

/// The rounding of a product, from the weights of its factors.
pub(super) fn rounding([a, a_later]: [f64; 2], [b, b_later]: [f64; 2]) -> f64 {
    (a_later * b + a * b_later + 4.0 * a * b) * UNIT * UP + TINY
}

/// A bound of `e^speed`.
fn growth(speed: f64) -> Result<f64, ArithmeticError> {
    Ok(value_of(Kind::Exponential, &FloatInterval::point(speed))?.hi())
}

fn pairwise(out: &mut [f64], a: &[f64], b: &[f64], f: impl Fn(f64, f64) -> f64) {
    out.iter_mut().zip(a.iter().zip(b)).for_each(|(out, (x, y))| *out = f(*x, *y));
}

/// The derivative by the time.
fn derivative(series: &[f64], order: usize, size: usize, sign: f64) -> Vec<f64> {
    let mut rate = vec![0.0; order * size];
    for k in 1..order {
        let (from, to) = (&series[k * size..][..size], &mut rate[(k - 1) * size..k * size]);
        to.iter_mut().zip(from).for_each(|(x, c)| *x = sign * k as f64 * c);
    }
    rate
}

/// Encloses the values of a polynomial in time and start during a part of the step.
pub(super) fn range(shape: &Shape, series: &[f64], during: FloatInterval) -> FloatInterval {
    let zero = FloatInterval::point(0.0);
    series.rchunks_exact(shape.size()).fold(zero, |sum, c| sum * during + shape.range(c))
}

/// The coefficients `f^(j)(c)/j!`, `j` up to `degree`.
fn expanded<T: arithmetic::Real>(kind: Kind, at: T, degree: usize) -> Result<Vec<T>, ArithmeticError> {
    let zero = at.zero();
    let rest = (1..=degree).map(|j| if j == 1 { at.one() } else { zero.clone() });
    Ok(value_of(kind, &Series::from_coefficients(at.clone(), rest))?.coefficients().to_vec())
}

/// A function of a polynomial in the start, in floats.
fn composed(shape: &Shape, kind: Kind, a: &[f64]) -> Result<Vec<f64>, ArithmeticError> {
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

/// A bound of the distance of `f(A)` from a polynomial, both in the start.
fn start_error(shape: &Shape, kind: Kind, (a, own): (&[f64], &[f64])) -> Result<f64, ArithmeticError> {
    let degree = shape.degree;
    let list = expanded(kind, FloatInterval::point(a[0]), degree)?;
    let mut rest = a.to_vec();
    rest[0] = 0.0;
    let size: Vec<f64> = shape.norms(&rest).map(|x| x * UP).collect();
    let total = size.iter().sum::<f64>() * UP;
    // Horner's scheme with what is cut off and rounded.
    let (mut sum, mut error) = (vec![0.0; shape.size()], 0.0);
    for c in list.iter().rev() {
        let mut next = vec![0.0; shape.size()];
        shape.multiply_add(&sum, &rest, &mut next);
        let norms: Vec<f64> = shape.norms(&sum).map(|x| x * UP).collect();
        let cut = |i: usize| norms[i] * size[degree + 1 - i.max(1).min(degree + 1)..].iter().sum::<f64>();
        let cut: f64 = (0..=degree).map(|i| if i == 0 { 0.0 } else { cut(i) }).sum();
        let whole = norms.iter().sum::<f64>() * UP;
        error = (error * total + cut + (shape.most_terms() + 4.0) * UNIT * (whole * total + c.magnitude())) * UP + TINY;
        error += (*c - FloatInterval::point(c.midpoint())).magnitude();
        next[0] += c.midpoint();
        sum = next;
    }
    // Taylor's remainder, over all values of the argument.
    if total > 0.0 {
        let last = expanded(kind, shape.range(a), degree + 1)?[degree + 1].magnitude();
        error += last * total.powi(degree as i32 + 1) * UP;
    }
    let apart = sum.iter().zip(own).fold(0.0, |sum, (x, y)| sum + (x - y).abs() + UNIT * (x.abs() + y.abs()));
    Ok((error + apart) * UP + TINY)
}
