//! Complex numbers over any scalar. `Complex<Rational>` are the Gaussian rationals.

use super::operators::operators;
use super::{ArithmeticError, Field, Rational, Ring};

/// `re + i im`.
#[derive(Debug, Clone, PartialEq)]
pub struct Complex<T> {
    /// Real part.
    pub re: T,
    /// Imaginary part.
    pub im: T,
}

impl<T: Ring> Complex<T> {
    /// `re + i im`.
    #[inline]
    pub fn new(re: T, im: T) -> Self {
        Complex { re, im }
    }

    /// A real number as a complex one.
    #[inline]
    pub fn real(re: T) -> Self {
        let im = re.zero();
        Complex { re, im }
    }

    /// The complex conjugate.
    #[inline]
    pub fn conj(&self) -> Self {
        Complex { re: self.re.clone(), im: -self.im.clone() }
    }

    /// The squared modulus, a scalar of `T`.
    #[inline]
    pub fn norm_squared(&self) -> T {
        self.re.square() + self.im.square()
    }

    /// `self` times a real factor.
    #[inline]
    pub fn scale(&self, factor: &T) -> Self {
        Complex { re: self.re.clone() * factor, im: self.im.clone() * factor }
    }

    /// `Re(conj(self) other)`: the planar scalar product.
    #[inline]
    pub fn dot(&self, other: &Self) -> T {
        self.re.clone() * &other.re + self.im.clone() * &other.im
    }
}

operators!(
    [T: Ring] Complex<T>,
    |a, b| Complex { re: a.re.clone() + &b.re, im: a.im.clone() + &b.im },
    |a, b| Complex { re: a.re.clone() - &b.re, im: a.im.clone() - &b.im },
    |a, b| Complex {
        re: a.re.clone() * &b.re - a.im.clone() * &b.im,
        im: a.re.clone() * &b.im + a.im.clone() * &b.re,
    },
    |a| Complex { re: -a.re.clone(), im: -a.im.clone() }
);

impl<T: Ring> Ring for Complex<T> {
    #[inline]
    fn integer(&self, n: i64) -> Self {
        Complex { re: self.re.integer(n), im: self.re.zero() }
    }

    #[inline]
    fn square(&self) -> Self {
        let product = self.re.clone() * &self.im;
        Complex { re: self.re.square() - self.im.square(), im: product.clone() + product }
    }
}

impl<T: Field> Field for Complex<T> {
    #[inline]
    fn rational(&self, q: &Rational) -> Self {
        Complex { re: self.re.rational(q), im: self.re.zero() }
    }

    #[inline]
    fn recip(&self) -> Result<Self, ArithmeticError> {
        Ok(self.conj().scale(&self.norm_squared().recip()?))
    }
}
