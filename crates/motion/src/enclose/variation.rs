//! The derivative of the flow on a step, as a polynomial in time and start with a bound of what that leaves out.

use super::bound::Bound;
use super::errors::{TINY, UNIT, beyond, rounding, weights};
use super::expansion::Expansion;
use super::linear::IntervalMatrix;
use super::shape::Shape;
use super::tape::Derivatives;
use arithmetic::FloatInterval;

/// `V' = h A V`, `V = 1` at the beginning, where `A` are the derivatives of the right-hand side.
pub(super) struct Variation<'a> {
    shape: &'a Shape,
    order: usize,
    size: usize,
    /// By powers of time, rows, columns, monomials.
    coefficients: Vec<f64>,
    expansion: &'a Expansion<'a>,
    derivatives: &'a Derivatives,
    length: f64,
    slack: Bound,
}

impl<'a> Variation<'a> {
    /// Of a step of this length, which is known up to `slack`.
    pub fn new(
        shape: &'a Shape,
        order: usize,
        (expansion, derivatives): (&'a Expansion<'a>, &'a Derivatives),
        (length, slack): (f64, Bound),
    ) -> Self {
        let size = derivatives.len();
        let block = size * size * shape.size();
        let mut coefficients = vec![0.0; order * block];
        (0..size).for_each(|i| coefficients[(i * size + i) * shape.size()] = 1.0);
        let mut variation = Variation { shape, order, size, coefficients, expansion, derivatives, length, slack };
        for power in 1..order {
            let next = variation.rate(power - 1, length / power as f64);
            variation.coefficients[power * block..(power + 1) * block].copy_from_slice(&next);
        }
        variation
    }

    fn of(&self, power: usize, i: usize, j: usize) -> &[f64] {
        let from = (power * self.size + i) * self.size + j;
        &self.coefficients[from * self.shape.size()..][..self.shape.size()]
    }

    /// A factor times the coefficients of a power of time of `A V`.
    fn rate(&self, power: usize, factor: f64) -> Vec<f64> {
        let monomials = self.shape.size();
        let mut sum = vec![0.0; self.size * self.size * monomials];
        for (i, row) in self.derivatives.iter().enumerate() {
            for &(c, id) in row {
                for (l, a) in (0..=power).map(|l| (l, self.expansion.of(id, l))) {
                    if a.iter().all(|x| *x == 0.0) {
                        continue;
                    }
                    for j in 0..self.size {
                        let out = &mut sum[(i * self.size + j) * monomials..][..monomials];
                        self.shape.multiply_add(a, self.of(power - l, c, j), out);
                    }
                }
            }
        }
        sum.iter_mut().for_each(|x| *x *= factor);
        sum
    }

    /// Encloses the derivative of the flow at the end of the step: `errors` are bounds for the operations, `growth` bounds what `e^(h |A|)` makes of a vector.
    pub fn enclosed(
        &self,
        errors: &[Bound],
        growth: impl Fn(&[Bound]) -> Option<Vec<Bound>>,
    ) -> Option<IntervalMatrix> {
        let left = self.defects(errors);
        let size = self.size;
        let mut matrix: IntervalMatrix = vec![vec![FloatInterval::ZERO; size]; size];
        for j in 0..size {
            let column: Vec<Bound> = (0..size).map(|i| left[i * size + j]).collect();
            let far = growth(&column)?;
            for i in 0..size {
                let parts = (0..self.order).map(|k| self.shape.range(self.of(k, i, j)));
                let value = parts.fold(FloatInterval::ZERO, |sum, x| sum + x);
                matrix[i][j] = value + FloatInterval::between(-far[i].value(), far[i].value());
            }
        }
        Some(matrix)
    }

    /// Bounds of `V' - h A V` on the whole step, by rows and columns: the last power, what is cut off and rounded, and the distance of A.
    fn defects(&self, errors: &[Bound]) -> Vec<Bound> {
        let (size, monomials, degrees) = (self.size, self.shape.size(), self.shape.degree + 1);
        // The sums of the absolute coefficients of V, by entries, powers and degrees.
        let entry = |place: usize| -> Vec<Bound> {
            (0..self.order).flat_map(|k| self.shape.norms(self.of(k, place / size, place % size))).collect()
        };
        let norms: Vec<Vec<Bound>> = (0..size * size).map(entry).collect();
        let tails: Vec<Vec<Bound>> = norms.iter().map(|own| beyond(own, self.order, self.shape.degree)).collect();
        let weighed: Vec<[Bound; 2]> = norms.iter().map(|own| weights(own, degrees)).collect();
        let wholes: Vec<Bound> = norms.iter().map(|own| own.iter().copied().sum()).collect();
        let last = self.rate(self.order - 1, self.length);
        let mut left = vec![Bound::ZERO; size * size];
        for (i, row) in self.derivatives.iter().enumerate() {
            for j in 0..size {
                let mut own = Bound::total(last[(i * size + j) * monomials..][..monomials].iter().copied());
                for &(c, id) in row {
                    let (place, a) = (c * size + j, self.expansion.norms(id));
                    let cut = Bound::dot(a, &tails[place]);
                    // Every coefficient is a sum over the row.
                    let rounded = rounding(weights(a, degrees), weighed[place]) * row.len() as f64;
                    let error = errors[id] * wholes[place];
                    let size_of = (self.expansion.norm(id) + errors[id]) * wholes[place];
                    own = own + (cut + rounded + error) * self.length + self.slack * size_of + TINY;
                }
                // Of k V_k, which was multiplied with the length and divided by k.
                left[i * size + j] = own + wholes[i * size + j] * (4.0 * self.order as f64 * UNIT);
            }
        }
        left
    }
}
