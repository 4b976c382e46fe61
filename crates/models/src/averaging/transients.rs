//! What is left of the motion on a fixed network once the drift is taken away, mode by mode, and how the distance of
//! two birds approaches its limit (Chazelle, equations (3.17) and (3.18)).

use super::modes::{Mode, rational_modes};
use super::weights::{Weights, transition_matrix};
use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{Rational, Ring, rational};
use num_traits::Signed;
use std::collections::BTreeMap;

/// The transient displacements of all birds of one flock, as sums over the modes `k > 1`.
#[derive(Debug, Clone)]
pub struct Transients {
    /// The transition matrix.
    pub p: RationalMatrix,
    /// `lambda_k` with the displacement of every bird (rows) in every coordinate at the start.
    pub modes: Vec<(Rational, Vec<Vec<Rational>>)>,
}

impl Transients {
    /// Those of a flock whose mode `k > 1` has in each coordinate the amplitude that `amplitudes` gives; `None` where
    /// some eigenvalue is irrational.
    ///
    /// # Errors
    /// As for [`transition_matrix`] and [`rational_modes`].
    pub fn new(
        graph: &Graph,
        weights: &Weights,
        mut amplitudes: impl FnMut(&Mode) -> Vec<Rational>,
    ) -> Result<Option<Self>, MatrixError> {
        let p = transition_matrix(graph, weights)?;
        let Some(modes) = rational_modes(&p, &weights.all(graph)?)? else { return Ok(None) };
        let modes = modes.into_iter().skip(1).map(|mode| {
            let amplitudes = amplitudes(&mode);
            let rows = mode.right.iter().map(|r| amplitudes.iter().map(|a| r * a).collect()).collect();
            (mode.eigenvalue, rows)
        });
        Ok(Some(Transients { modes: modes.collect(), p }))
    }

    /// The displacements of all birds in one coordinate at `s = 0, .., steps`: powers of `P` times those at 0,
    /// without eigenvalues.
    ///
    /// # Errors
    /// [`MatrixError`] where the lengths do not fit.
    pub fn displacements(&self, coordinate: usize, steps: usize) -> Result<Vec<Vec<Rational>>, MatrixError> {
        let mut now = vec![Rational::default(); self.p.rows()];
        for (_, rows) in &self.modes {
            for (x, row) in now.iter_mut().zip(rows) {
                *x += row.get(coordinate).cloned().unwrap_or_default();
            }
        }
        let mut all = Vec::with_capacity(steps + 1);
        for _ in 0..steps {
            let next = self.p.apply(&now)?;
            all.push(std::mem::replace(&mut now, next));
        }
        all.push(now);
        Ok(all)
    }
}

/// The difference of two birds, `x_i - x_j = A - sum_k Psi_k mu_k^s` (equation (3.17) with `B = 0`).
#[derive(Debug, Clone)]
pub struct Separation {
    /// `A`.
    pub limit: Vec<Rational>,
    /// `(mu_k, Psi_k)`.
    pub terms: Vec<(Rational, Vec<Rational>)>,
}

impl Separation {
    /// Of bird `i` of one flock and bird `j` of another, or of the same one.
    pub fn new(limit: Vec<Rational>, (p, i): (&Transients, usize), (q, j): (&Transients, usize)) -> Self {
        let of = |flock: &Transients, bird: usize, sign: i64| {
            let terms = flock.modes.iter().filter_map(|(l, rows)| Some((l.clone(), rows.get(bird)?)));
            terms.map(|(l, row)| (l, row.iter().map(|x| x * rational(sign, 1)).collect())).collect::<Vec<_>>()
        };
        Separation { limit, terms: [of(p, i, 1), of(q, j, -1)].concat() }
    }

    /// For `|A| = 1`: `rho -> (Upsilon^+, Upsilon^-)` of equation (3.18), by expanding `|A - sum_k Psi_k mu_k^s|²`;
    /// `rho` runs over the nonzero `|mu_k|` and `|mu_k mu_l|`.
    pub fn expansion(&self) -> BTreeMap<Rational, (Rational, Rational)> {
        let mut all: BTreeMap<Rational, (Rational, Rational)> = BTreeMap::new();
        let mut add = |mu: Rational, value: Rational| {
            if mu != Rational::default() {
                let slot = all.entry(mu.abs()).or_default();
                if mu.is_positive() { slot.0 += value } else { slot.1 += value }
            }
        };
        let dot = |a: &[Rational], b: &[Rational]| -> Rational { a.iter().zip(b).map(|(x, y)| x * y).sum() };
        for (mu, psi) in &self.terms {
            add(mu.clone(), dot(&self.limit, psi) * rational(-2, 1));
            for (other, phi) in &self.terms {
                add(mu * other, dot(psi, phi));
            }
        }
        all
    }

    /// `(rho_k, Upsilon_k)` of equation (3.18) on even or on odd `s`, where `Upsilon_k` is not zero, in increasing order of `rho_k`.
    pub fn coefficients(&self, odd: bool) -> Vec<(Rational, Rational)> {
        let sum = |(plus, minus): (Rational, Rational)| if odd { plus - minus } else { plus + minus };
        let all = self.expansion().into_iter().map(|(rho, parts)| (rho, sum(parts)));
        all.filter(|(_, upsilon)| *upsilon != Rational::default()).collect()
    }

    /// `|x_i - x_j|² - 1` at `s = 0, .., steps`, by powers of the transition matrices.
    ///
    /// # Errors
    /// [`MatrixError`] where the lengths do not fit.
    pub fn excess(
        &self,
        (p, i): (&Transients, usize),
        (q, j): (&Transients, usize),
        steps: usize,
    ) -> Result<Vec<Rational>, MatrixError> {
        let mut excess = vec![rational(-1, 1); steps + 1];
        for (k, a) in self.limit.iter().enumerate() {
            let (first, second) = (p.displacements(k, steps)?, q.displacements(k, steps)?);
            for ((e, x), y) in excess.iter_mut().zip(&first).zip(&second) {
                if let (Some(x), Some(y)) = (x.get(i), y.get(j)) {
                    *e += (a - x + y).square();
                }
            }
        }
        Ok(excess)
    }
}
