//! chazelle.eq3.8: the powers of the transition matrix.

use super::{FAMILY, Family, Network};
use crate::prelude::*;
use algebra::matrix::RationalMatrix;
use models::averaging::{Mode, equal_rows, rational_modes};
use num_traits::Signed;

/// `P^s = 1 pi^T + sum_{k > first} lambda_k^(multiple s) C^(a/2) u_k u_k^T C^(b/2)`.
#[derive(Clone, Copy)]
pub struct PowersVariant {
    halves: (i32, i32),
    multiple: u64,
    /// Leave out `lambda_1`.
    skip_first: bool,
    /// The half powers of the left and of the right eigenvectors.
    eigenvectors: (i32, i32),
}

/// Powers up to this one are compared on instances.
const LARGEST_POWER: u64 = 6;

impl PowersVariant {
    fn fails_at(&self, network: &Network, modes: &[Mode]) -> Result<Option<String>, CheckError> {
        let limit = equal_rows(&network.pi())?;
        let dyad = |mode: &Mode| -> Result<_, CheckError> {
            Ok(RationalMatrix::from_rows(&mode.dyad(&network.c, self.halves.0, self.halves.1)?)?)
        };
        let dyads: Vec<RationalMatrix> = modes.iter().map(dyad).collect::<Result<_, _>>()?;
        let mut power = network.identity()?;
        for s in 0..=LARGEST_POWER {
            let mut sum = limit.clone();
            for (mode, dyad) in modes.iter().zip(&dyads).skip(usize::from(self.skip_first)) {
                sum = sum.plus(&dyad.scaled(&mode.eigenvalue.pow((s * self.multiple) as i32)))?;
            }
            if sum != power {
                let wrong = (0..network.order()).find_map(|i| {
                    let (found, expected) = (&sum.to_rows()[i], &power.to_rows()[i]);
                    (found != expected).then(|| format!("row {} is ({}), not ({})", i + 1, list(found), list(expected)))
                });
                return Ok(wrong.map(|row| format!("s = {s}: {row}")));
            }
            power = power.times(&network.p)?;
        }
        self.wrong_eigenvectors(network, modes)
    }

    /// `C^(l/2) u_k` and `C^(r/2) u_k`, times the root of `norm`.
    fn wrong_eigenvectors(&self, network: &Network, modes: &[Mode]) -> Result<Option<String>, CheckError> {
        let transposed = network.p.transpose();
        let sides = [("left", &transposed, self.eigenvectors.0), ("right", &network.p, self.eigenvectors.1)];
        for (k, mode) in modes.iter().enumerate() {
            for (side, matrix, half) in sides {
                let vector = mode.scaled(&network.c, half)?;
                let scaled: Vec<Rational> = vector.iter().map(|x| x * &mode.eigenvalue).collect();
                if matrix.apply(&vector)? != scaled {
                    let (k, eigenvalue) = (k + 1, &mode.eigenvalue);
                    return Ok(Some(format!("k = {k}: ({}) is no {side} eigenvector for {eigenvalue}", list(&vector))));
                }
            }
        }
        Ok(None)
    }
}

/// Equation (3.8) for two birds with any weights.
fn two_birds(variant: &PowersVariant) -> Identity<'_> {
    Identity::of(move |[c1, c2]| {
        let (one, c) = (c1.one(), [c1, c2]);
        let entries = [(0, 0), (0, 1), (1, 0), (1, 1)];
        let p = |(i, j): (usize, usize)| if i == j { one.clone() - c[i] } else { c[i].clone() };
        let total = c1.clone() + c2;
        // The spectrum of P: 1 with u_1 = (sqrt c2, sqrt c1)/sqrt(c1+c2), 1 - c1 - c2 with u_2 = (sqrt c1, -sqrt
        // c2)/sqrt(c1+c2).
        let modes = [(one.clone(), [c2, c1], 1), (one.clone() - &total, [c1, c2], -1)];
        let half = |x: &Probe, power: i32| -> Result<Probe, ArithmeticError> {
            match power {
                0 => Ok(x.one()),
                1 => Ok(x.clone()),
                -1 => x.recip(),
                _ => Err(ArithmeticError::Domain("exponents of c from -1 to 1")),
            }
        };
        let (a, b) = variant.halves;
        let (mut left, mut right) = (Vec::new(), Vec::new());
        let mut power: Vec<Probe> = entries.iter().map(|&(i, j)| one.integer(i64::from(i == j))).collect();
        for s in 0..4u64 {
            left.extend(power.iter().cloned());
            for &(i, j) in &entries {
                // 1 pi^T, then C^(a/2) u u^T C^(b/2): sqrt(c_i^a w_i) sqrt(c_j^b w_j) is rational for odd a and b.
                let mut sum = c[1 - j].over(&total)?;
                for (k, (eigenvalue, w, sign)) in modes.iter().enumerate().skip(usize::from(variant.skip_first)) {
                    let sign = if i == j { 1 } else { *sign };
                    // w_i = c_i for the second mode; for the first c_1 c_2/c_i, whose root leaves sqrt(c_1 c_2) twice.
                    let product = if k == 1 {
                        half(c[i], (a + 1) / 2)? * half(c[j], (b + 1) / 2)?
                    } else {
                        half(c[i], (a - 1) / 2)? * half(c[j], (b - 1) / 2)? * w[0] * w[1]
                    };
                    let term = product.over(&total)? * eigenvalue.power(s * variant.multiple);
                    sum = sum + one.integer(sign) * term;
                }
                right.push(sum);
            }
            let next = |(i, j): (usize, usize)| p((i, 0)) * &power[j] + p((i, 1)) * &power[2 + j];
            power = entries.iter().map(|&entry| next(entry)).collect();
        }
        Ok((left, right))
    })
    .within(|at| at.iter().all(|c| c.is_positive() && (c - c.one()).is_negative()))
}

pub fn powers() -> Record<PowersVariant> {
    Record::new(
        "chazelle.eq3.8",
        "P = C^1/2 M C^-1/2 and M = sum lambda_k u_k u_k^T with orthonormal u_k. The first term is 1 pi^T because \
         C^1/2 u_1 = 1/sqrt(tr C^-1). For s = 0 the convention is 0^0 = 1. The sum does not depend on the basis that \
         is chosen where an eigenvalue is repeated.",
        PowersVariant { halves: (1, -1), multiple: 1, skip_first: true, eigenvectors: (-1, 1) },
        check_powers,
    )
    .clauses(&[
        "For all s >= 0: P^s = 1 pi^T + sum_{k>1} lambda_k^s C^{1/2} u_k u_k^T C^{-1/2}.",
        "Left and right eigenvectors for lambda_k are C^{-1/2} u_k and C^{1/2} u_k.",
    ])
    .altered("C^-1/2 u_k u_k^T C^1/2", |v| v.halves = (-1, 1))
    .altered("lambda_k^(2s)", |v| v.multiple = 2)
    .altered("the sum from k = 1", |v| v.skip_first = false)
    .altered("left eigenvectors C^1/2 u_k", |v| v.eigenvectors = (1, 1))
    .altered("right eigenvectors C^-1/2 u_k", |v| v.eigenvectors = (-1, -1))
}

fn check_powers(variant: &PowersVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut instances = Vec::new();
    for network in Family::PRINTED.networks(run.cases(5, 6))? {
        instances.extend(rational_modes(&network.p, &network.c)?.map(|modes| (network, modes)));
    }
    let detail = format!(
        "{FAMILY} on up to 5 birds (6 with --full) and of three kinds of weights whose eigenvalues all are rational"
    );
    Run::all([
        run.instances("P^s for s = 0, .., 6, and the eigenvectors", &detail, &instances, |(network, modes)| {
            Ok(variant.fails_at(network, modes)?.map(|what| format!("{}: {what}", network.show())))
        })
        .on([1, 2]),
        run.identity(&two_birds(variant), &["c_1", "c_2"], "two birds with any weights, s = 0, .., 3").on([1]),
    ])
}
