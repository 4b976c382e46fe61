//! Kronecker products.

use super::RationalMatrix;

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
