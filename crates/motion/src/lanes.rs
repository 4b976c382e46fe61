//! Several floats side by side as one scalar, so that a law written once is computed for as many pairs at a time.

use arithmetic::{ArithmeticError, Field, Rational, Ring};
use pulp::Simd;

/// One vector of floats of a processor. Every lane is computed alone and rounded to nearest without fused products, so that
/// its result does not depend on how many lanes there are.
///
/// All operations are inlined: they belong inside a function that [`pulp`] compiles for the processor.
#[derive(Debug, Clone, Copy)]
pub struct Lanes<S: Simd> {
    simd: S,
    /// The lanes.
    pub values: S::f64s,
}

impl<S: Simd> Lanes<S> {
    /// How many.
    pub const WIDTH: usize = S::F64_LANES;

    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(simd: S, x: f64) -> Self {
        Lanes { simd, values: simd.splat_f64s(x) }
    }

    /// The first numbers of a list; zeros where there are too few.
    #[inline(always)]
    pub fn load(simd: S, numbers: &[f64]) -> Self {
        let mut values = simd.splat_f64s(0.0);
        let lanes = pulp::bytemuck::cast_slice_mut(std::slice::from_mut(&mut values));
        match numbers.get(..Self::WIDTH) {
            Some(all) => lanes.copy_from_slice(all),
            None => lanes.iter_mut().zip(numbers).for_each(|(lane, x)| *lane = *x),
        }
        Lanes { simd, values }
    }

    /// The numbers 0, 1, ... of the lanes.
    #[inline(always)]
    pub fn numbers(simd: S) -> Self {
        let mut values = simd.splat_f64s(0.0);
        let lanes: &mut [f64] = pulp::bytemuck::cast_slice_mut(std::slice::from_mut(&mut values));
        lanes.iter_mut().enumerate().for_each(|(k, lane)| *lane = k as f64);
        Lanes { simd, values }
    }

    /// Writes the first lanes, as many as there is room for.
    #[inline(always)]
    pub fn store(self, numbers: &mut [f64]) {
        let count = numbers.len().min(Self::WIDTH);
        self.simd.partial_store_f64s(&mut numbers[..count], self.values);
    }

    /// Where these are less than others.
    #[inline(always)]
    pub fn less(self, other: Self) -> S::m64s {
        self.simd.less_than_f64s(self.values, other.values)
    }

    /// Whether one of these is less than the other in its lane.
    #[inline(always)]
    pub fn any_less(self, other: Self) -> bool {
        self.simd.first_true_m64s(self.less(other)) < Self::WIDTH
    }

    /// These numbers where the mask is set, others elsewhere.
    #[inline(always)]
    pub fn select(self, mask: S::m64s, other: Self) -> Self {
        Lanes { values: self.simd.select_f64s(mask, self.values, other.values), ..self }
    }
}

macro_rules! lanewise {
    ($trait:ident, $method:ident, $function:ident) => {
        impl<S: Simd> std::ops::$trait<&Lanes<S>> for Lanes<S> {
            type Output = Lanes<S>;
            #[inline(always)]
            fn $method(self, right: &Lanes<S>) -> Lanes<S> {
                Lanes { values: self.simd.$function(self.values, right.values), ..self }
            }
        }
        impl<S: Simd> std::ops::$trait for Lanes<S> {
            type Output = Lanes<S>;
            #[inline(always)]
            fn $method(self, right: Lanes<S>) -> Lanes<S> {
                Lanes { values: self.simd.$function(self.values, right.values), ..self }
            }
        }
    };
}

lanewise!(Add, add, add_f64s);
lanewise!(Sub, sub, sub_f64s);
lanewise!(Mul, mul, mul_f64s);

impl<S: Simd> std::ops::Neg for Lanes<S> {
    type Output = Lanes<S>;
    #[inline(always)]
    fn neg(self) -> Lanes<S> {
        Lanes { values: self.simd.neg_f64s(self.values), ..self }
    }
}

impl<S: Simd> Ring for Lanes<S> {
    #[inline(always)]
    fn integer(&self, n: i64) -> Self {
        Lanes::splat(self.simd, n as f64)
    }

    #[inline(always)]
    fn square(&self) -> Self {
        *self * self
    }
}

impl<S: Simd> Field for Lanes<S> {
    fn rational(&self, q: &Rational) -> Self {
        Lanes::splat(self.simd, 0.0f64.rational(q))
    }

    /// Never an error, because one lane must not stop the others: it is infinite where a lane is zero, and who divides must look
    /// at the result.
    #[inline(always)]
    fn recip(&self) -> Result<Self, ArithmeticError> {
        Ok(Lanes { values: self.simd.div_f64s(self.simd.splat_f64s(1.0), self.values), ..*self })
    }
}
