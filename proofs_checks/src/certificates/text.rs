//! Pieces that several kinds of certificates write.

use algebra::matrix::RationalMatrix;
use arithmetic::Rational;
use num_bigint::BigInt;

/// Numbers apart by one space.
pub fn row(numbers: &[BigInt]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// `keyword over D`, then a line for each row.
pub fn matrix(keyword: &str, matrix: &RationalMatrix) -> String {
    let rows: String = (0..matrix.rows()).map(|i| row(matrix.row(i)) + "\n").collect();
    format!("{keyword} over {}\n{rows}", matrix.denominator())
}

/// A list as a matrix of one row.
pub fn list(numbers: &[Rational]) -> Result<RationalMatrix, algebra::matrix::MatrixError> {
    RationalMatrix::from_rows(&[numbers.to_vec()])
}
