//! `inertia`: the signs of the eigenvalues of a symmetric matrix from `L D L^T`.

use super::{CertificateError, LARGEST_ORDER, at_most, text};
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{Rational, Ring};
use num_traits::{Signed, Zero};

/// `L D L^T` of a symmetric matrix in some order of its rows and columns.
#[derive(Debug, Clone)]
pub struct Inertia {
    pub(super) a: RationalMatrix,
    /// The row of `a` that is eliminated first, second, ...
    pub(super) pivots: Vec<usize>,
    pub(super) l: RationalMatrix,
    pub(super) d: Vec<Rational>,
}

impl Inertia {
    /// Factors a symmetric matrix; each pivot is the first that is left and not zero.
    ///
    /// # Errors
    /// [`CertificateError::NoPivot`], and a matrix that is not square, not symmetric or too large.
    pub fn new(a: &RationalMatrix) -> Result<Self, CertificateError> {
        let n = a.rows();
        at_most("rows", LARGEST_ORDER, n)?;
        if a.cols() != n {
            return Err(MatrixError::NotSquare { rows: n, cols: a.cols() }.into());
        }
        if *a != a.transpose() {
            return Err(CertificateError::NotSymmetric);
        }
        // `rest` is what is left of A; the columns of L are found for the rows in their old order.
        let (mut rest, mut pivots, mut columns, mut d) = (a.to_rows(), Vec::new(), Vec::new(), Vec::new());
        while pivots.len() < n {
            let left: Vec<usize> = (0..n).filter(|i| !pivots.contains(i)).collect();
            let Some(&pivot) = left.iter().find(|&&i| !rest[i][i].is_zero()) else {
                if left.iter().any(|&i| left.iter().any(|&j| !rest[i][j].is_zero())) {
                    return Err(CertificateError::NoPivot);
                }
                d.resize(n, a.entry(0, 0).zero());
                pivots.extend(left);
                break;
            };
            let value = rest[pivot][pivot].clone();
            let column: Vec<Rational> = (0..n).map(|i| &rest[i][pivot] / &value).collect();
            for &i in &left {
                for &j in &left {
                    let lost = &column[i] * &column[j] * &value;
                    rest[i][j] -= lost;
                }
            }
            pivots.push(pivot);
            columns.push(column);
            d.push(value);
        }
        let entry = |i: usize, k: usize| match (k.cmp(&i), columns.get(k)) {
            (std::cmp::Ordering::Equal, _) => d[0].one(),
            (std::cmp::Ordering::Less, Some(column)) => column[pivots[i]].clone(),
            _ => d[0].zero(),
        };
        let rows: Vec<Vec<Rational>> = (0..n).map(|i| (0..n).map(|k| entry(i, k)).collect()).collect();
        let l = RationalMatrix::from_rows(&rows)?;
        Ok(Inertia { a: a.reduced(), pivots, l, d })
    }

    /// The numbers of positive, negative and zero eigenvalues.
    pub fn counts(&self) -> (usize, usize, usize) {
        let count = |is: fn(&Rational) -> bool| self.d.iter().filter(|x| is(x)).count();
        (count(Rational::is_positive), count(Rational::is_negative), count(Zero::is_zero))
    }

    pub(super) fn claim(&self) -> String {
        let (positive, negative, zero) = self.counts();
        format!(
            "the symmetric matrix A below has {positive} positive, {negative} negative and {zero} zero eigenvalues, counted with \
             multiplicity"
        )
    }

    pub(super) fn body(&self) -> String {
        let pivots: Vec<String> = self.pivots.iter().map(|i| (i + 1).to_string()).collect();
        format!(
            "order {}\n{}pivots {}\n{}{}",
            self.a.rows(),
            text::matrix("A", &self.a),
            pivots.join(" "),
            text::matrix("L", &self.l),
            text::list(&self.d).map(|d| text::matrix("D", &d)).unwrap_or_default()
        )
    }
}
