//! The four operations, remainders and the order. Common factors are taken out before products are formed (Knuth, *Seminumerical Algorithms*,
//! 4.5.1), so that small numbers need no division at all where denominators are coprime.

use super::gcd::{gcd, gcd_u64};
use super::{Parts, Rational};
use num_bigint::{BigInt, BigUint};
use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

impl Rational {
    /// Numerator and denominator as long numbers.
    fn long(&self) -> (Cow<'_, BigInt>, Cow<'_, BigInt>) {
        match &self.0 {
            Parts::Small(p, q) => (Cow::Owned(BigInt::from(*p)), Cow::Owned(BigInt::from(*q))),
            Parts::Big(parts) => (Cow::Borrowed(&parts.0), Cow::Borrowed(&parts.1)),
        }
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Parts::Small(p, q), Parts::Small(r, s)) => small_sum((*p, *q), (*r, *s)),
            _ => long_sum(self, other),
        }
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Parts::Small(p, q), Parts::Small(r, s)) => small_sum((*p, *q), (-*r, *s)),
            _ => long_sum(self, &-other),
        }
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        match (&self.0, &other.0) {
            (Parts::Small(p, q), Parts::Small(r, s)) => small_product((*p, *q), (*r, *s)),
            _ => long_product(self, other),
        }
    }

    #[inline]
    fn divided(&self, other: &Self) -> Self {
        self.times(&other.recip())
    }

    /// What is left after the largest integer multiple towards zero.
    fn modulo(&self, other: &Self) -> Self {
        self - &((self / other).trunc() * other)
    }
}

fn small_sum((p, q): (i64, i64), (r, s): (i64, i64)) -> Rational {
    let wide = i128::from;
    if q == 1 && s == 1 {
        return Rational::of_lowest(wide(p) + wide(r), 1);
    }
    let common = gcd_u64(q as u64, s as u64) as i64;
    if common == 1 {
        return Rational::of_lowest(wide(p) * wide(s) + wide(r) * wide(q), wide(q) * wide(s));
    }
    let (own, others) = (q / common, s / common);
    let sum = wide(p) * wide(others) + wide(r) * wide(own);
    let shared = gcd_u64((sum % wide(common)).unsigned_abs() as u64, common as u64);
    Rational::of_lowest(sum / i128::from(shared), wide(own) * (wide(s) / i128::from(shared)))
}

fn small_product((p, q): (i64, i64), (r, s): (i64, i64)) -> Rational {
    // Divisors of positive words, so they are words again.
    let one = gcd_u64(p.unsigned_abs(), s as u64) as i64;
    let two = gcd_u64(r.unsigned_abs(), q as u64) as i64;
    let numerator = i128::from(p / one) * i128::from(r / two);
    Rational::of_lowest(numerator, i128::from(q / two) * i128::from(s / one))
}

fn long_sum(a: &Rational, b: &Rational) -> Rational {
    let ((p, q), (r, s)) = (a.long(), b.long());
    let common = gcd(q.magnitude(), s.magnitude());
    if common == BigUint::from(1u32) {
        return Rational::of_lowest_terms(&*p * &*s + &*r * &*q, &*q * &*s);
    }
    let common = BigInt::from(common);
    let (own, others) = (&*q / &common, &*s / &common);
    let sum = &*p * others + &*r * &own;
    let shared = gcd((&sum % &common).magnitude(), common.magnitude());
    if shared == BigUint::from(1u32) {
        return Rational::of_lowest_terms(sum, own * &*s);
    }
    let shared = BigInt::from(shared);
    Rational::of_lowest_terms(sum / &shared, own * (&*s / shared))
}

fn long_product(a: &Rational, b: &Rational) -> Rational {
    let ((p, q), (r, s)) = (a.long(), b.long());
    let one = gcd(p.magnitude(), s.magnitude());
    let two = gcd(r.magnitude(), q.magnitude());
    let without = |n: &BigInt, factor: &BigUint| match *factor == BigUint::from(1u32) {
        true => n.clone(),
        false => n / BigInt::from(factor.clone()),
    };
    let numerator = without(&p, &one) * without(&r, &two);
    Rational::of_lowest_terms(numerator, without(&q, &two) * without(&s, &one))
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        if let (Parts::Small(p, q), Parts::Small(r, s)) = (&self.0, &other.0) {
            return (i128::from(*p) * i128::from(*s)).cmp(&(i128::from(*r) * i128::from(*q)));
        }
        let ((p, q), (r, s)) = (self.long(), other.long());
        let signs = p.sign().cmp(&r.sign());
        if signs != Ordering::Equal {
            return signs;
        }
        // A product of numbers of m and n bits has m + n bits or one less.
        let (own, others) = (p.bits() + s.bits(), r.bits() + q.bits());
        if own.abs_diff(others) > 1 {
            return if p.sign() == num_bigint::Sign::Minus { others.cmp(&own) } else { own.cmp(&others) };
        }
        (&*p * &*s).cmp(&(&*r * &*q))
    }
}

impl PartialOrd for Rational {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational(match &self.0 {
            Parts::Small(p, q) => Parts::Small(-p, *q),
            Parts::Big(parts) => Parts::Big(Box::new((-&parts.0, parts.1.clone()))),
        })
    }
}

impl Neg for Rational {
    type Output = Rational;
    #[inline]
    fn neg(self) -> Rational {
        Rational(match self.0 {
            Parts::Small(p, q) => Parts::Small(-p, q),
            Parts::Big(parts) => {
                let (p, q) = *parts;
                Parts::Big(Box::new((-p, q)))
            }
        })
    }
}

/// An operation by value and by reference, with rationals and with integers on the right, and its assignment.
macro_rules! operation {
    ($trait:ident, $method:ident, $assign:ident, $assigning:ident, $function:ident) => {
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, right: &Rational) -> Rational {
                self.$function(right)
            }
        }
        impl $trait<Rational> for &Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, right: Rational) -> Rational {
                self.$function(&right)
            }
        }
        impl $trait<&Rational> for Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, right: &Rational) -> Rational {
                self.$function(right)
            }
        }
        impl $trait for Rational {
            type Output = Rational;
            #[inline]
            fn $method(self, right: Rational) -> Rational {
                self.$function(&right)
            }
        }
        operation!(@integer $trait, $method, $function, Rational, BigInt, |n| n);
        operation!(@integer $trait, $method, $function, &Rational, BigInt, |n| n);
        operation!(@integer $trait, $method, $function, Rational, &BigInt, |n| n.clone());
        operation!(@integer $trait, $method, $function, &Rational, &BigInt, |n| n.clone());
        impl $assign<&Rational> for Rational {
            #[inline]
            fn $assigning(&mut self, right: &Rational) {
                *self = self.$function(right);
            }
        }
        impl $assign for Rational {
            #[inline]
            fn $assigning(&mut self, right: Rational) {
                *self = self.$function(&right);
            }
        }
    };
    (@integer $trait:ident, $method:ident, $function:ident, $left:ty, $integer:ty, |$right:ident| $owned:expr) => {
        impl $trait<$integer> for $left {
            type Output = Rational;
            fn $method(self, $right: $integer) -> Rational {
                self.$function(&Rational::from_integer($owned))
            }
        }
    };
}

operation!(Add, add, AddAssign, add_assign, plus);
operation!(Sub, sub, SubAssign, sub_assign, minus);
operation!(Mul, mul, MulAssign, mul_assign, times);
operation!(Div, div, DivAssign, div_assign, divided);
operation!(Rem, rem, RemAssign, rem_assign, modulo);
