//! The transfer function of a linear system as a quotient of integer polynomials, by residues modulo many primes.
//!
//! With rows multiplied by integers `m_i` that clear their denominators, and `m_c` for the output, numerator and denominator of
//! `m_c prod m_i (c (s - A)^-1 b(s) + d(s))` are determinants of matrices of integers and `s`, so that no coefficient is larger than the product of the
//! sums of the moduli in each row. As many primes as that takes determine them.
//!
//! Modulo a prime, the characteristic polynomial `D` is the shortest recurrence of `u A^k v` (Wiedemann 1986; Berlekamp and Massey) where that
//! has the full degree, and otherwise comes from Hessenberg's form; the numerator is `sum_j s^j sum_i D_(i+j+1) c A^i b`.

use super::MatrixError;
use arithmetic::threads;
use arithmetic::{Field, Progress, Rational, Residue, Ring, Unwatched, common_denominator, is_prime};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

/// `N/D` with integer coefficients, the constant one first; the last one of `D` is positive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Transfer {
    /// `N`.
    pub numerator: Vec<BigInt>,
    /// A positive multiple of the characteristic polynomial of `A`.
    pub denominator: Vec<BigInt>,
}

/// Primes lie below this power of two.
const PRIME_BITS: u32 = 61;

/// The system with integer rows.
struct Integers {
    /// `m_i a_ij` for the entries that are not zero, by rows.
    a: Vec<Vec<(usize, BigInt)>>,
    /// `m_i b_i`: the row for `1`, `s`, ..
    b: Vec<Vec<BigInt>>,
    /// `m_i`.
    scales: Vec<BigInt>,
    c: Vec<BigInt>,
    d: Vec<BigInt>,
    scale: BigInt,
}

/// The transfer function `c (s - A)^-1 (b_0 + s b_1 + ..) + d_0 + s d_1 + ..` of a square matrix `a`; `b` has as many rows and `c` as many entries, and
/// each row of `b`, and `d`, the same number of entries, one at least.
///
/// # Errors
/// [`MatrixError`] where the shapes do not fit.
pub fn transfer_function(
    a: &[Vec<Rational>],
    b: &[Vec<Rational>],
    c: &[Rational],
    d: &[Rational],
) -> Result<Transfer, MatrixError> {
    transfer_function_watched(a, b, c, d, &Unwatched)
}

/// [`transfer_function`], which can be stopped.
///
/// # Errors
/// [`MatrixError`] where the shapes do not fit, and [`MatrixError::Cancelled`].
pub fn transfer_function_watched(
    a: &[Vec<Rational>],
    b: &[Vec<Rational>],
    c: &[Rational],
    d: &[Rational],
    progress: &dyn Progress,
) -> Result<Transfer, MatrixError> {
    let n = a.len();
    if let Some(row) = a.iter().find(|row| row.len() != n) {
        return Err(MatrixError::NotSquare { rows: n, cols: row.len() });
    }
    if b.len() != n || c.len() != n || b.iter().any(|row| row.len() != d.len()) {
        return Err(MatrixError::Shapes { left_cols: n, right_rows: b.len().min(c.len()) });
    }
    let system = Integers::of(a, b, c, d);
    let primes = system.primes();
    let residues = threads::map(primes.len(), |k| match progress.is_cancelled() {
        true => Vec::new(),
        false => system.modulo(primes[k]),
    });
    progress.checkpoint()?;
    let length = 2 * n + d.len() + 1;
    let mut all = vec![BigInt::ZERO; length];
    let mut modulus = BigInt::from(1);
    for (prime, found) in primes.iter().zip(&residues) {
        lift(&mut all, &modulus, found, *prime);
        modulus *= *prime;
    }
    let half = &modulus / 2;
    all.iter_mut().filter(|c| **c > half).for_each(|c| *c -= &modulus);
    let numerator = all.split_off(n + 1);
    Ok(Transfer { numerator, denominator: all })
}

impl Integers {
    fn of(a: &[Vec<Rational>], b: &[Vec<Rational>], c: &[Rational], d: &[Rational]) -> Self {
        let times = |list: &[Rational], scale: &BigInt| -> Vec<BigInt> {
            list.iter().map(|q| q.numer() * (scale / q.denom())).collect()
        };
        let scales: Vec<BigInt> = a.iter().zip(b).map(|(a, b)| common_denominator(a.iter().chain(b))).collect();
        let scale = common_denominator(c.iter().chain(d));
        let entries = |(row, scale): (&Vec<Rational>, &BigInt)| {
            times(row, scale).into_iter().enumerate().filter(|(_, x)| !x.is_zero()).collect()
        };
        Integers {
            a: a.iter().zip(&scales).map(entries).collect(),
            b: b.iter().zip(&scales).map(|(row, scale)| times(row, scale)).collect(),
            c: times(c, &scale),
            d: times(d, &scale),
            scales,
            scale,
        }
    }

    /// Primes whose product is more than twice the largest coefficient can be, and that divide none of the scales.
    fn primes(&self) -> Vec<u64> {
        let bits = |sum: BigInt| sum.bits();
        let row = |k: usize| {
            let a: BigInt = self.a[k].iter().map(|(_, x)| x.abs()).sum();
            bits(a + self.b[k].iter().map(Signed::abs).sum::<BigInt>() + &self.scales[k])
        };
        let output: BigInt = self.c.iter().chain(&self.d).map(Signed::abs).sum();
        let needed = (0..self.a.len()).map(row).sum::<u64>() + bits(output + &self.scale) + 2;
        let divides = |prime: u64| self.scales.iter().chain([&self.scale]).any(|m| (m % prime).is_zero());
        let all = (0..).map(|k| (1u64 << PRIME_BITS) - 1 - 2 * k).filter(|n| is_prime(*n) && !divides(*n));
        all.take((needed / u64::from(PRIME_BITS - 1) + 1) as usize).collect()
    }

    /// The coefficients of the denominator and of the numerator modulo a prime.
    fn modulo(&self, prime: u64) -> Vec<u64> {
        let Ok(like) = Residue::new(0, prime) else { return Vec::new() };
        let residue = |n: &BigInt| like.rational(&Rational::from_integer(n.clone()));
        let n = self.a.len();
        let inverse: Vec<Residue> = self.scales.iter().map(|m| residue(m).recip().unwrap_or(like)).collect();
        let a: Vec<Vec<(usize, Residue)>> =
            (0..n).map(|i| self.a[i].iter().map(|(j, x)| (*j, residue(x) * inverse[i])).collect()).collect();
        let characteristic = characteristic(&a, &like);
        let inputs = self.d.len();
        let mut numerator = vec![like; n + inputs];
        for input in 0..inputs {
            let mut x: Vec<Residue> = (0..n).map(|i| residue(&self.b[i][input]) * inverse[i]).collect();
            let c: Vec<Residue> = self.c.iter().map(residue).collect();
            for i in 0..n {
                let moment = dot(&c, &x, &like);
                (0..n - i)
                    .for_each(|j| numerator[j + input] = numerator[j + input] + moment * characteristic[i + j + 1]);
                x = apply(&a, &x, &like);
            }
            let direct = residue(&self.d[input]);
            (0..=n).for_each(|j| numerator[j + input] = numerator[j + input] + direct * characteristic[j]);
        }
        // The output has the scale m_c in it.
        let scale = self.scales.iter().fold(like.one(), |product, m| product * residue(m));
        let whole = scale * residue(&self.scale);
        let denominator = characteristic.iter().map(|x| (*x * whole).value());
        denominator.chain(numerator.iter().map(|x| (*x * scale).value())).collect()
    }
}

/// Makes numbers modulo `modulus` numbers modulo `modulus * prime`.
fn lift(all: &mut [BigInt], modulus: &BigInt, found: &[u64], prime: u64) {
    let Ok(like) = Residue::new(0, prime) else { return };
    let residue = |n: &BigInt| n.mod_floor(&BigInt::from(prime)).to_u64().unwrap_or(0);
    let Ok(inverse) = Residue::new(residue(modulus), prime).and_then(|m| m.recip()) else { return };
    for (x, value) in all.iter_mut().zip(found) {
        let difference = like.integer(*value as i64) - like.integer(residue(x) as i64);
        *x += modulus * (difference * inverse).value();
    }
}

fn dot(a: &[Residue], b: &[Residue], like: &Residue) -> Residue {
    a.iter().zip(b).fold(like.zero(), |sum, (a, b)| sum + *a * *b)
}

fn apply(a: &[Vec<(usize, Residue)>], x: &[Residue], like: &Residue) -> Vec<Residue> {
    a.iter().map(|row| row.iter().fold(like.zero(), |sum, (j, a)| sum + *a * x[*j])).collect()
}

/// The monic characteristic polynomial, the constant coefficient first.
fn characteristic(a: &[Vec<(usize, Residue)>], like: &Residue) -> Vec<Residue> {
    let n = a.len();
    // Any two vectors would do; these are like random ones.
    let mixed = |k: usize| like.integer(0x2545_f491_4f6c_dd1d ^ (k as i64)).power(k as u64 + 3);
    let left: Vec<Residue> = (0..n).map(|k| mixed(2 * k)).collect();
    let mut x: Vec<Residue> = (0..n).map(|k| mixed(2 * k + 1)).collect();
    let mut sequence = Vec::with_capacity(2 * n);
    for _ in 0..2 * n {
        sequence.push(dot(&left, &x, like));
        x = apply(a, &x, like);
    }
    let shortest = recurrence(&sequence, like);
    if shortest.len() == n + 1 { shortest } else { by_hessenberg(a, like) }
}

/// The monic polynomial of the shortest recurrence of a sequence, the constant coefficient first (Berlekamp and Massey).
fn recurrence(sequence: &[Residue], like: &Residue) -> Vec<Residue> {
    let one = like.one();
    let (mut current, mut last) = (vec![one], vec![one]);
    let (mut length, mut since, mut discrepancy) = (0, 1, one);
    for k in 0..sequence.len() {
        let terms = current.iter().enumerate().take(length + 1);
        let wrong = terms.fold(like.zero(), |sum, (i, c)| sum + *c * sequence[k - i]);
        if wrong == like.zero() {
            since += 1;
            continue;
        }
        let factor = wrong * discrepancy.recip().unwrap_or(one);
        let before = current.clone();
        current.resize(current.len().max(last.len() + since), like.zero());
        last.iter().enumerate().for_each(|(i, c)| current[i + since] = current[i + since] - factor * *c);
        if 2 * length <= k {
            (length, last, discrepancy, since) = (k + 1 - length, before, wrong, 1);
        } else {
            since += 1;
        }
    }
    current.resize(length + 1, like.zero());
    current.reverse();
    current
}

/// The characteristic polynomial by Hessenberg's form; `order³` products.
fn by_hessenberg(a: &[Vec<(usize, Residue)>], like: &Residue) -> Vec<Residue> {
    let n = a.len();
    let mut h = vec![vec![like.zero(); n]; n];
    for (row, entries) in h.iter_mut().zip(a) {
        entries.iter().for_each(|(j, x)| row[*j] = *x);
    }
    for column in 0..n.saturating_sub(2) {
        let Some(pivot) = (column + 1..n).find(|&i| h[i][column] != like.zero()) else { continue };
        h.swap(pivot, column + 1);
        h.iter_mut().for_each(|row| row.swap(pivot, column + 1));
        let inverse = h[column + 1][column].recip().unwrap_or(*like);
        for i in column + 2..n {
            let factor = h[i][column] * inverse;
            if factor == like.zero() {
                continue;
            }
            let (upper, lower) = h.split_at_mut(i);
            lower[0].iter_mut().zip(&upper[column + 1]).for_each(|(x, y)| *x = *x - factor * *y);
            h.iter_mut().for_each(|row| row[column + 1] = row[column + 1] + factor * row[i]);
        }
    }
    // p_k = (s - h_kk) p_(k-1) - sum_i h_(i k) (product of the entries below the diagonal) p_(i-1).
    let mut all = vec![vec![like.one()]];
    for k in 0..n {
        let mut next = vec![like.zero(); k + 2];
        all[k].iter().enumerate().for_each(|(j, c)| {
            next[j + 1] = next[j + 1] + *c;
            next[j] = next[j] - h[k][k] * *c;
        });
        let mut product = like.one();
        for i in (0..k).rev() {
            product = product * h[i + 1][i];
            let factor = product * h[i][k];
            all[i].iter().enumerate().for_each(|(j, c)| next[j] = next[j] - factor * *c);
        }
        all.push(next);
    }
    all.pop().unwrap_or_default()
}

#[cfg(test)]
mod tests;
