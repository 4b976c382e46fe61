//! `limit`: where the powers of a stochastic matrix go, and the deviation matrix Gamma.
//!
//! With `E = 1 pi^T`, what is checked gives `Gamma_t = sum_(s<t) P^s - t E = (I - P^t) Gamma`, and `P^t -> E` because
//! `tau_1(P^k) < 1`; so `Gamma_t -> Gamma - E Gamma = Gamma`.

use crate::Refusal;
use crate::matrix::Matrix;
use crate::product::{LARGEST_ORDER, require_tau_1};
use crate::read::{Fraction, Reader};

const LARGEST_POWER: usize = 1 << 16;

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let order = reader.count("order", 1, LARGEST_ORDER)?;
    let p = reader.stochastic("P", order, order)?;
    let pi = reader.stochastic("pi", 1, order)?;
    let pi_p = reader.times(&pi, &p)?;
    reader.require(pi_p.equals(&pi), "pi P is not pi")?;
    let gamma = reader.matrix("Gamma", order, order)?;
    require_gamma(reader, &p, &pi, &gamma)?;
    let power = reader.count("power", 1, LARGEST_POWER)?;
    let tau = reader.fraction("tau_1")?;
    reader.require(tau.numerator < tau.denominator, "tau_1 is not below 1")?;
    require_power(reader, &p, power, &tau)?;
    Ok(format!(
        "the powers of the stochastic matrix P below converge to the matrix whose rows all are pi, tau_1(P^{power}) = {}, and \
         I + P + .. + P^(t-1) - t 1 pi^T converges to Gamma",
        tau.text
    ))
}

/// `(I - P) Gamma = I - 1 pi^T` and `pi Gamma = 0`.
fn require_gamma(reader: &mut Reader, p: &Matrix, pi: &Matrix, gamma: &Matrix) -> Result<(), Refusal> {
    let identity = Matrix::identity(p.rows);
    let ones = Matrix::from_fn(p.rows, 1, 1.into(), |_, _| 1.into());
    let (generator, deviation) = (identity.minus(p), identity.minus(&reader.times(&ones, pi)?));
    let found = reader.times(&generator, gamma)?;
    reader.pay(2 * p.rows * p.rows, found.bits(), deviation.bits())?;
    reader.require(found.equals(&deviation), "(I - P) Gamma is not I - 1 pi^T")?;
    let pi_gamma = reader.times(pi, gamma)?;
    reader.require(pi_gamma.is_zero(), "pi Gamma is not zero")
}

fn require_power(reader: &mut Reader, p: &Matrix, power: usize, tau: &Fraction) -> Result<(), Refusal> {
    let mut product = Matrix::identity(p.rows);
    for bit in (0..usize::BITS - power.leading_zeros()).rev() {
        product = reader.times(&product, &product)?;
        if power >> bit & 1 == 1 {
            product = reader.times(p, &product)?;
        }
    }
    require_tau_1(reader, &product, tau)
}
