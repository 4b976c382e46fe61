//! Spectra of small rational matrices from their exact characteristic polynomials.

use super::enclosed::{bits, least_top, order};
use super::smith::complex_roots;
use super::{Eigenvalue, Polynomial, RealRoot};
use crate::matrix::{CharacteristicPolynomial, MatrixError, RationalMatrix, transfer_function};
use arithmetic::{Complex, Interval, Rational, rational};
use num_traits::Signed;

/// The different eigenvalues of a rational matrix with their multiplicities, to `digits` significant digits, if all are
/// real; `None` if some are not. Rational eigenvalues are exact.
///
/// # Errors
/// [`MatrixError::NotSquare`].
pub fn real_spectrum(matrix: &RationalMatrix, digits: u32) -> Result<Option<Vec<Eigenvalue>>, MatrixError> {
    let mut factors = Factors::default();
    factors.multiply(&matrix.characteristic_polynomial()?, 1);
    Ok(factors.real_roots(digits))
}

/// Order from which residues modulo many primes are quicker than rational arithmetic.
const BY_RESIDUES: usize = 12;

impl RationalMatrix {
    /// The primitive multiple of the characteristic polynomial `det(xI - A)`.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`].
    pub fn primitive_characteristic(&self) -> Result<Polynomial, MatrixError> {
        let n = self.rows();
        if n < BY_RESIDUES {
            return Ok(Polynomial::from_rationals(&self.characteristic_polynomial()?.coefficients()));
        }
        // Without inputs the transfer function is its denominator.
        let found = transfer_function(&self.to_rows(), &vec![Vec::new(); n], &vec![Rational::ZERO; n], &[])?;
        Ok(Polynomial::new(found.denominator))
    }
}

/// A product of characteristic polynomials, kept as powers of polynomials without multiple roots and without common
/// roots.
#[derive(Debug, Clone, Default)]
pub(super) struct Factors {
    list: Vec<(Polynomial, usize)>,
}

impl Factors {
    /// Multiplies by so many of these.
    pub fn multiply(&mut self, polynomial: &CharacteristicPolynomial, count: usize) {
        for (mut factor, times) in Polynomial::from_rationals(&polynomial.coefficients()).square_free_factors() {
            let times = times * count;
            let mut refined = Vec::with_capacity(self.list.len() + 2);
            for (known, multiplicity) in self.list.drain(..) {
                let common = known.gcd(&factor);
                if common.degree() == 0 {
                    refined.push((known, multiplicity));
                    continue;
                }
                factor = factor.divided_by(&common);
                refined.push((known.divided_by(&common), multiplicity));
                refined.push((common, multiplicity + times));
            }
            refined.push((factor, times));
            refined.retain(|(part, _)| part.degree() > 0);
            self.list = refined;
        }
    }

    /// All roots, if they are real: as many as Sturm's theorem counts.
    pub fn real_roots(&self, digits: u32) -> Option<Vec<Eigenvalue>> {
        let mut found = Vec::new();
        for (factor, multiplicity) in &self.list {
            let roots = real_roots_of(factor);
            if roots.len() < factor.degree() {
                return None;
            }
            found.extend(roots.into_iter().map(|root| enclose(factor, root, *multiplicity, digits)));
        }
        found.sort_by(order);
        Some(found)
    }

    /// All roots; `None` where the complex ones could not be isolated.
    pub fn roots(&self, digits: u32) -> Option<Vec<Eigenvalue>> {
        let mut found = Vec::new();
        for (factor, multiplicity) in &self.list {
            let roots = real_roots_of(factor);
            if roots.len() < factor.degree() {
                let pairs = complex_roots(factor, &roots, digits)?;
                let both = pairs.into_iter().flat_map(|z| [z.conj(), z]);
                let part =
                    |z: Complex<Interval>| Eigenvalue { re: z.re, im: z.im, multiplicity: *multiplicity, exact: None };
                found.extend(both.map(part));
            }
            found.extend(roots.into_iter().map(|root| enclose(factor, root, *multiplicity, digits)));
        }
        found.sort_by(order);
        Some(found)
    }
}

/// The real roots of a polynomial without multiple roots, inside the bound `1 + max |c_k/c_n|` of Cauchy.
fn real_roots_of(factor: &Polynomial) -> Vec<RealRoot> {
    let coefficients = factor.coefficients();
    let size = |c: &num_bigint::BigInt| c.bits() as i64;
    let (Some(lead), Some(largest)) = (coefficients.last().map(size), coefficients.iter().map(size).max()) else {
        return Vec::new();
    };
    // A power of two, so that halving keeps the ends short.
    let bound = rational(2, 1).pow((largest - lead + 2) as i32);
    factor.roots_in(&-bound.clone(), &bound)
}

fn enclose(factor: &Polynomial, mut root: RealRoot, multiplicity: usize, digits: u32) -> Eigenvalue {
    let precision = bits(digits) + 8;
    if let Some(exact) = factor.rational_root(&mut root) {
        return Eigenvalue::rational(exact, multiplicity, precision);
    }
    // Zero is rational, so this root can be told from it.
    let mut fine = 32;
    while !root.lo().is_positive() && !root.hi().is_negative() {
        factor.refine(&mut root, fine);
        fine *= 2;
    }
    let top = least_top(&Interval::hull_of_rationals(root.lo(), root.hi(), 64));
    factor.refine(&mut root, (i64::from(bits(digits)) + 2 - top).max(1) as u32);
    Eigenvalue::real(root.enclosure(precision), multiplicity)
}

#[cfg(test)]
mod tests;
