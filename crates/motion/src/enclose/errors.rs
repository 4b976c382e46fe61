//! Bounds of the distance of an expansion from what it stands for; `notes/validated.md` derives each of them.

use super::bound::Bound;
use super::expansion::{Expansion, expanded, range};
use super::shape::Shape;
use super::tape::{Kind, Op, value_of};
use arithmetic::{ArithmeticError, Field, FloatInterval, Ring};

/// A little more than the largest relative error of one rounding: `n u/(1 - n u)` is below `n` times this up to `n = 10^13`.
pub(super) const UNIT: f64 = f64::EPSILON * 0.51;

/// Products that underflow are wrong by at most `2^-1075`, and there are fewer than `2^53` of them.
pub(super) const TINY: Bound = Bound::UNDERFLOW;

impl Expansion<'_> {
    /// Bounds of the distance of the polynomials of the state from solving the equation, over the whole step of a length that is known up to `slack`, given
    /// [`Self::errors`].
    pub fn defects(&self, errors: &[Bound], length: f64, slack: Bound) -> Vec<Bound> {
        let degrees = self.shape.degree + 1;
        let own = |&output: &usize| {
            let last: Bound = self.norms(output)[(self.order - 1) * degrees..].iter().copied().sum();
            let whole = self.norm(output);
            // What was cut off, the rounding of h f_k/(k + 1), the distance of the right-hand side, and that of the length.
            (last + whole * (4.0 * UNIT) + errors[output]) * length + slack * (whole + errors[output]) + TINY
        };
        self.tape.outputs.iter().map(own).collect()
    }

    /// Bounds of the distance of each operation on states at some distance from theirs, whatever the time of the step and the start, from its own polynomial;
    /// `inputs` are bounds for the numbers of the state and the time.
    pub fn errors(&self, inputs: &[Bound]) -> Result<Vec<Bound>, ArithmeticError> {
        let mut errors: Vec<Bound> = vec![Bound::ZERO; self.tape.ops.len()];
        for (id, op) in self.tape.ops.iter().enumerate() {
            errors[id] = match *op {
                Op::Input(index) => inputs[index],
                Op::Constant(value) => Bound::of((value - FloatInterval::point(value.midpoint())).magnitude()),
                Op::Sum(a, b) | Op::Difference(a, b) => errors[a] + errors[b] + self.norm(id) * UNIT,
                Op::Product(a, b) => {
                    let (p, q, e, f) = (self.norm(a), self.norm(b), errors[a], errors[b]);
                    p * f + q * e + e * f + lost(self.norms(a), self.norms(b), self.order, self.shape.degree)
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
    pub fn whole(&self, id: usize, error: Bound) -> FloatInterval {
        let around = FloatInterval::between(-error.value(), error.value());
        range(self.shape, self.all(id), FloatInterval::between(0.0, 1.0)) + around
    }

    /// The sum of the absolute coefficients of `c - x y`, where `c` has the coefficients of `constant`, with what is cut off and rounded.
    fn residual(&self, constant: &[f64], [x, y]: [&[f64]; 2], norms: [&[Bound]; 2]) -> Bound {
        let size = self.shape.size();
        let (mut left, mut out) = (constant.to_vec(), vec![0.0; size]);
        for power in 0..self.order {
            out.fill(0.0);
            for k in 0..=power {
                self.shape.multiply_add(&x[k * size..][..size], &y[(power - k) * size..][..size], &mut out);
            }
            left[power * size..][..size].iter_mut().zip(&out).for_each(|(c, x)| *c -= x);
        }
        let rounded = Bound::total(constant.iter().copied()) * (4.0 * UNIT);
        Bound::total(left) + rounded + lost(norms[0], norms[1], self.order, self.shape.degree)
    }

    fn function_error(
        &self,
        kind: Kind,
        (id, a, partner): (usize, usize, usize),
        errors: &[Bound],
    ) -> Result<Bound, ArithmeticError> {
        let argument = self.whole(a, errors[a]);
        // The function has a value, and a derivative that is bounded, wherever the argument may be.
        let value = value_of(kind, &argument)?;
        match kind {
            // 1/x - R = (1 - x R)/x.
            Kind::Reciprocal => {
                let mut one = vec![0.0; self.order * self.shape.size()];
                one[0] = 1.0;
                let rest = self.residual(&one, [self.all(a), self.all(id)], [self.norms(a), self.norms(id)]);
                Ok((rest + errors[a] * self.norm(id)).over(argument.lo().max(-argument.hi())))
            }
            // sqrt x - S = (x - S²)/(sqrt x + S).
            Kind::Root => {
                let rest = self.residual(self.all(a), [self.all(id); 2], [self.norms(id); 2]);
                let below = (FloatInterval::point(value.lo()) + self.whole(id, Bound::ZERO)).lo();
                if below <= 0.0 {
                    return Err(ArithmeticError::Argument("sqrt"));
                }
                Ok((rest + errors[a]).over(below))
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
        errors: &[Bound],
    ) -> Result<Bound, ArithmeticError> {
        let rate = |id: usize, sign: f64| derivative(self.all(id), self.order, self.shape.size(), sign);
        let moved = rate(a, if kind == Kind::Cosine { -1.0 } else { 1.0 });
        let degrees = self.shape.degree + 1;
        let mut norms = vec![Bound::ZERO; self.order * degrees];
        for k in 1..self.order {
            (0..degrees).for_each(|i| norms[(k - 1) * degrees + i] = self.norms(a)[k * degrees + i] * k as f64);
        }
        let speed: Bound = norms.iter().copied().sum();
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
        Ok(own + errors[a] * slope_of(kind, argument, value)?)
    }
}

/// What the product of two polynomials in floats is wrong by, in the sum of its coefficients: what is cut off, the terms of too high a power of time or degree,
/// and what is rounded. The sums of their absolute coefficients are given by powers of time and degrees.
pub(super) fn lost(a: &[Bound], b: &[Bound], order: usize, degree: usize) -> Bound {
    Bound::dot(a, &beyond(b, order, degree)) + rounding(weights(a, degree + 1), weights(b, degree + 1))
}

/// For each power of time and degree, the sum of the absolute coefficients of a factor that a term of these cannot be multiplied with.
pub(super) fn beyond(norms: &[Bound], order: usize, degree: usize) -> Vec<Bound> {
    let degrees = degree + 1;
    let row = |k: usize, from: usize| norms[k * degrees + from..(k + 1) * degrees].iter().copied().sum::<Bound>();
    // All terms from a power on, and those below it from a degree on.
    let mut later = vec![Bound::ZERO; order + 1];
    (0..order).rev().for_each(|k| later[k] = later[k + 1] + row(k, 0));
    let mut higher = vec![Bound::ZERO; (order + 1) * degrees];
    for k in 0..order {
        (0..degrees).for_each(|i| higher[(k + 1) * degrees + i] = higher[k * degrees + i] + row(k, degrees - i));
    }
    let of = |k: usize, i: usize| later[order - k] + higher[(order - k) * degrees + i];
    (0..order).flat_map(|k| (0..degrees).map(move |i| (k, i))).map(|(k, i)| of(k, i)).collect()
}

/// The sum of absolute coefficients, weighed with 2 to the degree, and the same weighed with the power of time as well.
pub(super) fn weights(norms: &[Bound], degrees: usize) -> [Bound; 2] {
    let row = |row: &[Bound]| row.iter().rev().fold(Bound::ZERO, |sum, x| sum * 2.0 + *x);
    norms.chunks_exact(degrees).zip(0..).fold([Bound::ZERO; 2], |[all, later], (norms, power)| {
        let own = row(norms);
        [all + own, later + own * f64::from(power)]
    })
}

/// The rounding of a product, from the weights of its factors. A coefficient of the power `k` of time and the degree `i` has at most `(k + 1) 2^i` terms, each
/// of which is rounded at most as often; the third part has room for a factor that was itself rounded.
pub(super) fn rounding([a, a_later]: [Bound; 2], [b, b_later]: [Bound; 2]) -> Bound {
    (a_later * b + a * b_later + a * b * 4.0) * UNIT + TINY
}

/// A bound of `e^speed`.
fn growth(speed: Bound) -> Result<Bound, ArithmeticError> {
    Ok(Bound::of(value_of(Kind::Exponential, &FloatInterval::point(speed.value()))?.hi()))
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

/// A bound of the derivative of a function, where it has these arguments and values.
pub(super) fn slope_of(kind: Kind, argument: FloatInterval, value: FloatInterval) -> Result<f64, ArithmeticError> {
    Ok(match kind {
        Kind::Reciprocal => value.square().magnitude(),
        Kind::Root => (value + value).recip()?.magnitude(),
        Kind::Sine | Kind::Cosine => 1.0,
        Kind::Exponential => value.magnitude(),
        Kind::Logarithm => argument.recip()?.magnitude(),
        Kind::ArcTangent => (argument.square() + argument.one()).recip()?.magnitude(),
        Kind::HyperbolicSine | Kind::HyperbolicCosine => value_of(Kind::HyperbolicCosine, &argument)?.magnitude(),
    })
}

/// A bound of the distance of `f(A)` from a polynomial, both in the start.
pub(super) fn start_error(shape: &Shape, kind: Kind, (a, own): (&[f64], &[f64])) -> Result<Bound, ArithmeticError> {
    let degree = shape.degree;
    let list = expanded(kind, FloatInterval::point(a[0]), degree)?;
    let mut rest = a.to_vec();
    rest[0] = 0.0;
    let size: Vec<Bound> = shape.norms(&rest).collect();
    let total: Bound = size.iter().copied().sum();
    // Horner's scheme with what is cut off and rounded.
    let (mut sum, mut error) = (vec![0.0; shape.size()], Bound::ZERO);
    for c in list.iter().rev() {
        let mut next = vec![0.0; shape.size()];
        shape.multiply_add(&sum, &rest, &mut next);
        let norms: Vec<Bound> = shape.norms(&sum).collect();
        let cut = (1..=degree).map(|i| norms[i] * size[degree + 1 - i..].iter().copied().sum::<Bound>());
        let whole: Bound = norms.iter().copied().sum();
        let rounded = (whole * total + Bound::of(c.magnitude())) * ((shape.most_terms() + 4.0) * UNIT);
        let apart = Bound::of((*c - FloatInterval::point(c.midpoint())).magnitude());
        error = error * total + cut.sum() + rounded + apart + TINY;
        next[0] += c.midpoint();
        sum = next;
    }
    // Taylor's remainder, over all values of the argument.
    if total > Bound::ZERO {
        let last = Bound::of(expanded(kind, shape.range(a), degree + 1)?[degree + 1].magnitude());
        error = error + (0..=degree).fold(last, |product, _| product * total);
    }
    let rounded = Bound::total(sum.iter().chain(own).copied()) * UNIT;
    Ok(error + Bound::total(sum.iter().zip(own).map(|(x, y)| x - y)) + rounded)
}
