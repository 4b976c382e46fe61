//! Power series of a fixed length as one scalar, so that a law written once gives its own derivatives in time.

use arithmetic::{ArithmeticError, Field, Rational, Ring};

/// `c_0 + c_1 x + ... + c_{K-1} x^{K-1} + O(x^K)`: `arithmetic::Series` for small scalars, without memory of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet<T, const K: usize>(pub [T; K]);

impl<T: Ring + Copy, const K: usize> Jet<T, K> {
    /// A number that does not depend on `x`.
    #[inline(always)]
    pub fn constant(value: T) -> Self {
        let mut all = [value.zero(); K];
        all[0] = value;
        Jet(all)
    }

    #[inline(always)]
    fn product(&self, other: &Self) -> Self {
        let mut all = self.0;
        for (n, to) in all.iter_mut().enumerate() {
            let mut sum = self.0[0] * other.0[n];
            for k in 1..=n {
                sum = sum + self.0[k] * other.0[n - k];
            }
            *to = sum;
        }
        Jet(all)
    }

    #[inline(always)]
    fn each(mut self, other: &Self, operation: impl Fn(T, T) -> T) -> Self {
        for n in 0..K {
            self.0[n] = operation(self.0[n], other.0[n]);
        }
        self
    }
}

macro_rules! operation {
    ($trait:ident, $method:ident, |$a:ident, $b:ident| $value:expr) => {
        impl<T: Ring + Copy, const K: usize> std::ops::$trait<&Jet<T, K>> for Jet<T, K> {
            type Output = Jet<T, K>;
            #[inline(always)]
            fn $method(self, right: &Jet<T, K>) -> Jet<T, K> {
                let ($a, $b) = (self, right);
                $value
            }
        }
        impl<T: Ring + Copy, const K: usize> std::ops::$trait for Jet<T, K> {
            type Output = Jet<T, K>;
            #[inline(always)]
            fn $method(self, right: Jet<T, K>) -> Jet<T, K> {
                std::ops::$trait::$method(self, &right)
            }
        }
    };
}

operation!(Add, add, |a, b| a.each(
    b,
    #[inline(always)]
    |x, y| x + y
));
operation!(Sub, sub, |a, b| a.each(
    b,
    #[inline(always)]
    |x, y| x - y
));
operation!(Mul, mul, |a, b| a.product(b));

impl<T: Ring + Copy, const K: usize> std::ops::Neg for Jet<T, K> {
    type Output = Jet<T, K>;
    #[inline(always)]
    fn neg(mut self) -> Jet<T, K> {
        for n in 0..K {
            self.0[n] = -self.0[n];
        }
        self
    }
}

impl<T: Ring + Copy, const K: usize> Ring for Jet<T, K> {
    #[inline(always)]
    fn integer(&self, n: i64) -> Self {
        Jet::constant(self.0[0].integer(n))
    }

    #[inline(always)]
    fn square(&self) -> Self {
        self.product(self)
    }
}

impl<T: Field + Copy, const K: usize> Field for Jet<T, K> {
    fn rational(&self, q: &Rational) -> Self {
        Jet::constant(self.0[0].rational(q))
    }

    /// Needs a constant term that is not zero.
    #[inline(always)]
    fn recip(&self) -> Result<Self, ArithmeticError> {
        let first = self.0[0].recip()?;
        let mut inverse = [first; K];
        for n in 1..K {
            let mut sum = self.0[1] * inverse[n - 1];
            for k in 2..=n {
                sum = sum + self.0[k] * inverse[n - k];
            }
            inverse[n] = -(sum * first);
        }
        Ok(Jet(inverse))
    }
}
