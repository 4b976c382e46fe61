//! Residues modulo a prime of 61 bits.

use super::operators::operators;
use super::{ArithmeticError, Field, Rational, Ring};
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use rand_chacha::rand_core::Rng;

/// An element of a prime field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Residue {
    value: u64,
    prime: u64,
}

/// A random prime between 2^60 and 2^61, each as likely as any other.
pub fn random_prime(random: &mut impl Rng) -> u64 {
    loop {
        let candidate = 1 << 60 | random.next_u64() >> 4 | 1;
        if is_prime(candidate) {
            return candidate;
        }
    }
}

/// Whether a number is prime, by strong tests to the first twelve primes as bases, which decide below 2^64 (Sorenson and Webster 2015).
pub fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if n < 2 || BASES.iter().any(|p| n.is_multiple_of(*p)) {
        return BASES.contains(&n);
    }
    let twos = (n - 1).trailing_zeros();
    BASES.iter().all(|&base| {
        let mut x = Residue { value: base, prime: n }.power((n - 1) >> twos);
        if x.value == 1 || x.value == n - 1 {
            return true;
        }
        (1..twos).any(|_| {
            x = x.square();
            x.value == n - 1
        })
    })
}

impl Residue {
    /// The residue of a number modulo a prime.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] for a modulus that is not prime.
    pub fn new(value: u64, prime: u64) -> Result<Self, ArithmeticError> {
        if is_prime(prime) {
            Ok(Residue::modulo(value, prime))
        } else {
            Err(ArithmeticError::Domain("a prime modulus"))
        }
    }

    /// The same for a modulus that is known to be prime.
    pub(crate) fn modulo(value: u64, prime: u64) -> Self {
        Residue { value: value % prime, prime }
    }

    /// The prime.
    pub(crate) fn prime(&self) -> u64 {
        self.prime
    }

    /// The representative from 0 to `prime - 1`.
    pub fn value(&self) -> u64 {
        self.value
    }

    fn sum(a: &Self, b: &Self) -> Self {
        let sum = u128::from(a.value) + u128::from(b.value);
        Residue { value: (sum % u128::from(a.prime)) as u64, prime: a.prime }
    }

    fn opposite(&self) -> Self {
        Residue { value: if self.value == 0 { 0 } else { self.prime - self.value }, prime: self.prime }
    }

    fn product(a: &Self, b: &Self) -> Self {
        let product = u128::from(a.value) * u128::from(b.value);
        Residue { value: (product % u128::from(a.prime)) as u64, prime: a.prime }
    }

    fn of_big(&self, n: &BigInt) -> Self {
        let prime = BigInt::from(self.prime);
        // The remainder lies between -prime and prime.
        let remainder = (n % &prime + &prime) % &prime;
        Residue { value: remainder.to_u64().unwrap_or(0), prime: self.prime }
    }
}

operators!([] Residue, Residue::sum, |a, b| Residue::sum(a, &b.opposite()), Residue::product, Residue::opposite);

impl Ring for Residue {
    fn integer(&self, n: i64) -> Self {
        let absolute = Residue::modulo(n.unsigned_abs(), self.prime);
        if n < 0 { absolute.opposite() } else { absolute }
    }
}

impl Field for Residue {
    fn rational(&self, q: &Rational) -> Self {
        // A constant whose denominator the prime divides has no residue; such primes are as rare as those that a wrong identity survives, and
        // are counted with them.
        let below = self.of_big(&q.denom());
        Residue::product(&self.of_big(&q.numer()), &below.power(self.prime - 2))
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        if self.value == 0 { Err(ArithmeticError::DivisionByZero) } else { Ok(self.power(self.prime - 2)) }
    }

    fn ratio(&self, p: i64, q: i64) -> Self {
        Residue::product(&self.integer(p), &self.integer(q).power(self.prime - 2))
    }
}
