//! Characteristic polynomials and exact counts of real eigenvalues.

use super::{MatrixError, RationalMatrix};
use arithmetic::{Field, Rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use std::convert::Infallible;

/// `det(xI - A)` of a rational matrix.
///
/// The counts are for matrices **whose eigenvalues are all real** (symmetric ones, and the transition matrices of
/// averaging, which are similar to symmetric ones). For these Descartes' rule of signs is exact: the positive roots are as many as
/// the changes of sign among the coefficients.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CharacteristicPolynomial {
    /// Coefficients of `det(xI - N)`, lowest first, where `A = N/denominator`.
    coefficients: Vec<BigInt>,
    denominator: BigInt,
}

impl RationalMatrix {
    /// The characteristic polynomial, by the method of Faddeev and LeVerrier: `order` products of matrices.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`].
    pub fn characteristic_polynomial(&self) -> Result<CharacteristicPolynomial, MatrixError> {
        let order = self.square_order()?;
        let integers = self.scaled(&Rational::from_integer(self.denominator().clone())).reduced();
        let identity = RationalMatrix::identity(order)?;
        let step = |auxiliary: &RationalMatrix, k: usize| {
            let product = integers.times(auxiliary)?;
            let trace: BigInt = (0..order).map(|i| &product.row(i)[i]).sum();
            let next = -trace / BigInt::from(k);
            let auxiliary = product.plus(&identity.scaled(&Rational::from_integer(next.clone())))?;
            Ok::<_, MatrixError>((auxiliary, next))
        };
        let coefficients = faddeev_leverrier(order, identity.clone(), BigInt::one(), step)?;
        Ok(CharacteristicPolynomial { coefficients, denominator: self.denominator().clone() })
    }
}

/// The coefficients of `det(xI - A)` for a square matrix over any field, lowest first.
pub fn characteristic_coefficients<T: Field>(matrix: &[Vec<T>], like: &T) -> Vec<T> {
    let order = matrix.len();
    let identity = (0..order).map(|i| (0..order).map(|j| like.integer(i64::from(i == j))).collect()).collect();
    let step = |auxiliary: &Vec<Vec<T>>, k: usize| {
        let entry = |i: usize, j: usize| {
            matrix[i].iter().zip(auxiliary).fold(like.zero(), |sum, (a, row)| sum + a.clone() * &row[j])
        };
        let mut product: Vec<Vec<T>> = (0..order).map(|i| (0..order).map(|j| entry(i, j)).collect()).collect();
        let trace = (0..order).fold(like.zero(), |sum, i| sum + &product[i][i]);
        let next = trace * like.ratio(-1, k as i64);
        for (i, row) in product.iter_mut().enumerate() {
            row[i] = row[i].clone() + &next;
        }
        Ok::<_, Infallible>((product, next))
    };
    let Ok(coefficients) = faddeev_leverrier(order, identity, like.one(), step);
    coefficients
}

/// The method of Faddeev and LeVerrier: `step(B, k)` gives `A B + c I` and `c = -tr(A B)/k`. Coefficients lowest first.
fn faddeev_leverrier<M, T, E>(
    order: usize,
    mut auxiliary: M,
    one: T,
    step: impl Fn(&M, usize) -> Result<(M, T), E>,
) -> Result<Vec<T>, E> {
    let mut coefficients = vec![one];
    for k in 1..=order {
        let (next, coefficient) = step(&auxiliary, k)?;
        auxiliary = next;
        coefficients.push(coefficient);
    }
    coefficients.reverse();
    Ok(coefficients)
}

impl CharacteristicPolynomial {
    /// The degree, which is the order of the matrix.
    pub fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// The coefficients of `det(xI - A)`, lowest first; the last is 1.
    pub fn coefficients(&self) -> Vec<Rational> {
        let scale = |k: usize| num_traits::pow(self.denominator.clone(), self.degree() - k);
        self.coefficients.iter().enumerate().map(|(k, c)| Rational::new(c.clone(), scale(k))).collect()
    }

    /// The coefficients, lowest first and up to positive factors, of the polynomial whose roots are `root - x`, where
    /// `root` runs through the eigenvalues.
    fn shifted(&self, x: &Rational) -> Vec<BigInt> {
        let (numerator, denominator) = (x.numer() * &self.denominator, x.denom());
        // The roots become integers over one denominator: q^n f(y/q) in y = q times the root of N, then y = z + p.
        let degree = self.degree();
        let mut shifted: Vec<BigInt> =
            (0..=degree).map(|k| &self.coefficients[k] * num_traits::pow(denominator.clone(), degree - k)).collect();
        for start in 0..degree {
            for k in (start..degree).rev() {
                let carried = &shifted[k + 1] * &numerator;
                shifted[k] += carried;
            }
        }
        shifted
    }

    /// How often `x` is an eigenvalue.
    pub fn multiplicity(&self, x: &Rational) -> usize {
        self.shifted(x).iter().take_while(|c| c.is_zero()).count()
    }

    /// The number of eigenvalues greater than `x`, with multiplicity, if all eigenvalues are real.
    pub fn count_above(&self, x: &Rational) -> usize {
        let shifted = self.shifted(x);
        let signs: Vec<bool> = shifted.iter().filter(|c| !c.is_zero()).map(Signed::is_positive).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    /// The number of eigenvalues less than `x`, with multiplicity, if all eigenvalues are real.
    pub fn count_below(&self, x: &Rational) -> usize {
        self.degree() - self.count_above(x) - self.multiplicity(x)
    }

    /// All eigenvalues from the smallest on, each as often as it occurs; `None` where one of them is not rational.
    pub fn rational_spectrum(&self) -> Option<Vec<Rational>> {
        let found = self.rational_eigenvalues().into_iter().rev();
        let all: Vec<Rational> = found.flat_map(|(x, times)| vec![x; times]).collect();
        (all.len() == self.degree()).then_some(all)
    }

    /// The rational eigenvalues with their multiplicities, largest first, if all eigenvalues are real.
    pub fn rational_eigenvalues(&self) -> Vec<(Rational, usize)> {
        // Rational roots of a monic integer polynomial are integers; no root exceeds the sum of the coefficients.
        let bound: BigInt = self.coefficients.iter().map(Signed::abs).sum();
        let mut found = Vec::new();
        // Half-open ranges (low, high] of roots of N, largest on top.
        let mut open = vec![(-bound.clone() - 1, bound)];
        while let Some((low, high)) = open.pop() {
            let value = |x: &BigInt| Rational::new(x.clone(), self.denominator.clone());
            let (top, multiplicity) = (value(&high), self.multiplicity(&value(&high)));
            if self.count_above(&value(&low)) == self.count_above(&top) {
                continue;
            }
            if &high - &low <= BigInt::one() {
                if multiplicity > 0 {
                    found.push((top, multiplicity));
                }
                continue;
            }
            let middle = (&low + &high).div_floor(&BigInt::from(2));
            open.push((low, middle.clone()));
            open.push((middle, high));
        }
        found
    }
}
