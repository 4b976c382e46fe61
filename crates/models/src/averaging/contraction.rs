//! How many steps halve the diameter of a flock: a rigorous bound at a cost that grows like the logarithm of the number.

use algebra::matrix::{Footprint, MatrixError, RationalMatrix, StochasticMatrix};
use arithmetic::{Progress, Rational, Unwatched};
use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_traits::One;

/// A number of steps after which the distances between the rows of a power of a matrix are at most halved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Contraction {
    /// The number of steps `k`, a power of two.
    pub steps: BigUint,
    /// An upper bound of `tau_1(P^k)`, at most 1/2.
    pub tau: Rational,
}

/// A power of two `k` with `tau_1(P^k) <= 1/2`, for a stochastic matrix.
///
/// It is the smallest such power of two while the entries of `P^k` fit 256 bits. Beyond, the squares are rounded to
/// stochastic matrices of fixed length, and the bound of the error is added to `tau`; `k` may then be twice as large as
/// the smallest. Cost: `log2 k` products, times a power of `log k` where the length must grow.
///
/// # Errors
/// [`MatrixError`] where the matrix is not stochastic or not square, and [`MatrixError::NotErgodic`] where no power
/// contracts.
pub fn contraction(p: &RationalMatrix) -> Result<Contraction, MatrixError> {
    contraction_watched(p, &Unwatched)
}

/// As [`contraction`], until `progress` stops it.
///
/// # Errors
/// As there, and [`MatrixError::Cancelled`].
pub fn contraction_watched(p: &RationalMatrix, progress: &dyn Progress) -> Result<Contraction, MatrixError> {
    let p = StochasticMatrix::try_from(p)?;
    if p.rows() != p.cols() {
        return Err(MatrixError::NotSquare { rows: p.rows(), cols: p.cols() });
    }
    if !some_power_is_scrambling(&p.footprint()) {
        return Err(MatrixError::NotErgodic);
    }
    let mut bits = 256;
    loop {
        if let Some(contraction) = contraction_at(&p, bits, progress)? {
            return Ok(contraction);
        }
        bits *= 2;
    }
}

/// Whether in some power any two rows share a column, which is when `tau_1 < 1`.
fn some_power_is_scrambling(footprint: &Footprint) -> bool {
    let order = footprint.rows();
    let shares = |f: &Footprint, i: usize, j: usize| (0..order).any(|k| f.get(i, k) && f.get(j, k));
    let mut power = footprint.clone();
    // Two walks that can meet meet within order^2 steps (the pairs of states), and once met they can stay together.
    let mut steps: u128 = 1;
    loop {
        if (0..order).all(|i| (0..i).all(|j| shares(&power, i, j))) {
            return true;
        }
        if steps >= (order as u128).pow(2) {
            return false;
        }
        power = power.times(&power);
        steps *= 2;
    }
}

/// The bound from squares rounded to `bits` bits; `None` where the error grows too large before the powers contract.
fn contraction_at(
    p: &StochasticMatrix,
    bits: u64,
    progress: &dyn Progress,
) -> Result<Option<Contraction>, MatrixError> {
    let unit = Rational::new(BigInt::one(), BigInt::one() << bits);
    let half = Rational::new(BigInt::one(), BigInt::from(2));
    // Invariant: the rows of `power` and of P^steps differ by at most `error` in the l1-norm. Both are stochastic, so
    // P^2k - A^2 = P^k (P^k - A) + (P^k - A) A doubles it, and tau_1, half an l1-diameter, moves by at most `error`.
    let (mut power, mut steps, mut error) = (p.clone(), BigUint::one(), unit.clone() - &unit);
    loop {
        let tau = power.tau_1_watched(progress)? + &error;
        if tau <= half {
            return Ok(Some(Contraction { steps, tau }));
        }
        if &error * BigInt::from(8) > half {
            return Ok(None);
        }
        power = power.times_watched(&power, progress)?;
        steps *= 2u8;
        error = &error * BigInt::from(2);
        if power.denominator().bits() > bits + 1 {
            power = rounded(&power, bits)?;
            error += &unit * BigInt::from(2 * power.cols());
        }
    }
}

/// The stochastic matrix over the denominator `2^bits` whose rows differ from those given by less than
/// `2 cols / 2^bits` in the l1-norm: entries rounded down, and what is lost given to the first entry of the row.
fn rounded(matrix: &StochasticMatrix, bits: u64) -> Result<StochasticMatrix, MatrixError> {
    let one = BigUint::one() << bits;
    let mut numerators: Vec<BigInt> =
        matrix.numerators().map(|x| BigInt::from((x << bits).div_floor(matrix.denominator()))).collect();
    for row in numerators.chunks_mut(matrix.cols()) {
        let sum: BigInt = row.iter().sum();
        row[0] += BigInt::from(one.clone()) - sum;
    }
    StochasticMatrix::try_from(&RationalMatrix::new(matrix.rows(), matrix.cols(), numerators, BigInt::from(one))?)
}
