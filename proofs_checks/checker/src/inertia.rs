//! `inertia`: signs of the eigenvalues of a symmetric matrix, by Sylvester's law of inertia.

use crate::Refusal;
use crate::matrix::Matrix;
use crate::read::Reader;
use num_bigint::{BigInt, Sign};

const LARGEST_ORDER: usize = 128;

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let n = reader.count("order", 1, LARGEST_ORDER)?;
    let a = reader.matrix("A", n, n)?;
    reader.require((0..n).all(|i| (0..i).all(|j| a.at(i, j) == a.at(j, i))), "the matrix is not symmetric")?;
    let pivots = pivots(reader, n)?;
    let l = reader.matrix("L", n, n)?;
    let is_unit = (0..n).all(|i| *l.at(i, i) == l.denominator);
    let is_lower = (0..n).all(|i| (i + 1..n).all(|j| l.at(i, j).sign() == Sign::NoSign));
    reader.require(is_unit && is_lower, "L is not lower triangular with ones on its diagonal")?;
    let d = reader.matrix("D", 1, n)?;
    // L D, then (L D) L^T against A in the order of the pivots.
    reader.pay(n * n, l.bits(), d.bits())?;
    let scaled = Matrix::from_fn(n, n, &l.denominator * &d.denominator, |i, j| l.at(i, j) * d.at(0, j));
    let transposed = Matrix::from_fn(n, n, l.denominator.clone(), |i, j| l.at(j, i).clone());
    let product = reader.times(&scaled, &transposed)?;
    let permuted = Matrix::from_fn(n, n, a.denominator.clone(), |i, j| a.at(pivots[i], pivots[j]).clone());
    reader.pay(2 * n * n, product.bits(), a.bits())?;
    reader.require(product.equals(&permuted), "L D L^T is not A in the order of the pivots")?;
    let count = |sign: Sign| d.entries.iter().filter(|x: &&BigInt| x.sign() == sign).count();
    Ok(format!(
        "the symmetric matrix A below has {} positive, {} negative and {} zero eigenvalues, counted with multiplicity",
        count(Sign::Plus),
        count(Sign::Minus),
        count(Sign::NoSign)
    ))
}

/// A permutation, numbers from 1.
fn pivots(reader: &mut Reader, n: usize) -> Result<Vec<usize>, Refusal> {
    let mut pivots = Vec::new();
    for word in reader.value("pivots")?.split(' ') {
        let pivot = reader.count_of(word, 1, n)? - 1;
        reader.require(!pivots.contains(&pivot), "a pivot comes twice")?;
        pivots.push(pivot);
    }
    reader.require(pivots.len() == n, "the pivots are not as many as the rows")?;
    Ok(pivots)
}
