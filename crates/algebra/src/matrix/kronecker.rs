//! Kronecker products.

use super::RationalMatrix;
use arithmetic::Ring;

/// The Kronecker product of matrices over any ring, given by their rows.
pub fn kronecker_of_rows<T: Ring>(left: &[Vec<T>], right: &[Vec<T>]) -> Vec<Vec<T>> {
    let row = |a: &Vec<T>, b: &Vec<T>| a.iter().flat_map(|x| b.iter().map(move |y| x.clone() * y)).collect();
    left.iter().flat_map(|a| right.iter().map(move |b| row(a, b))).collect()
}

impl RationalMatrix {
    /// The Kronecker product: the block `a_ij right` in place of every entry `a_ij` (Chazelle, footnote 2).
    pub fn kronecker(&self, right: &Self) -> Self {
        let (rows, cols) = (self.rows() * right.rows(), self.cols() * right.cols());
        let entry = |k: usize| {
            let (i, j) = (k / cols, k % cols);
            &self.row(i / right.rows())[j / right.cols()] * &right.row(i % right.rows())[j % right.cols()]
        };
        let numerators = (0..rows * cols).map(entry).collect();
        RationalMatrix::of_known_shape(rows, cols, numerators, self.denominator() * right.denominator())
    }
}
