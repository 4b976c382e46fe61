//! A small solver of semidefinite feasibility problems in floats. It only proposes: whatever it returns is rounded and checked exactly by who asked.
//!
//! Find positive semidefinite blocks `X` with `<A_i, X> = b_i`, near the analytic centre of all solutions: a primal-dual path-following method with the
//! direction of Helmberg, Rendl, Vanderbei and Wolkowicz (1996), Kojima, Shindoh and Hara (1997) and Monteiro (1997), for the objective 0.

use arithmetic::{Cancelled, Progress};
use nalgebra::{Cholesky, DMatrix, DVector};

/// An equation: entries `(block, row, column, value)` with `row <= column`, those off the diagonal standing for both, and the right side.
#[derive(Debug, Clone)]
pub(crate) struct Equation {
    pub entries: Vec<(usize, usize, usize, f64)>,
    pub right: f64,
}

/// What the solver came to.
#[derive(Debug, Clone)]
pub(crate) struct Proposal {
    pub blocks: Vec<DMatrix<f64>>,
    /// Largest deviation of an equation, relative to the right sides.
    pub residual: f64,
}

/// Steps after which nothing better is expected.
const MOST_STEPS: usize = 80;

/// Equations are then as good as the floats allow.
const SMALL_RESIDUAL: f64 = 1e-9;

/// The dual iterate is then small enough for the primal one to stand at its centre.
const SMALL_GAP: f64 = 1e-8;

fn applied(equations: &[Equation], blocks: &[DMatrix<f64>]) -> DVector<f64> {
    let one = |equation: &Equation| {
        let entry = |&(k, i, j, a): &(usize, usize, usize, f64)| {
            if i == j { a * blocks[k][(i, i)] } else { a * (blocks[k][(i, j)] + blocks[k][(j, i)]) }
        };
        equation.entries.iter().map(entry).sum::<f64>()
    };
    DVector::from_iterator(equations.len(), equations.iter().map(one))
}

fn adjoint(equations: &[Equation], y: &DVector<f64>, sizes: &[usize]) -> Vec<DMatrix<f64>> {
    let mut sum: Vec<DMatrix<f64>> = sizes.iter().map(|&n| DMatrix::zeros(n, n)).collect();
    for (equation, &factor) in equations.iter().zip(y.iter()) {
        for &(k, i, j, a) in &equation.entries {
            sum[k][(i, j)] += factor * a;
            if i != j {
                sum[k][(j, i)] += factor * a;
            }
        }
    }
    sum
}

/// The Schur complement `<A_i, X A_j W>`, made symmetric, with `W` the inverse of `Z`.
fn schur(equations: &[Equation], x: &[DMatrix<f64>], w: &[DMatrix<f64>]) -> DMatrix<f64> {
    let m = equations.len();
    let mut matrix = DMatrix::zeros(m, m);
    for (j, equation) in equations.iter().enumerate() {
        let mut product: Vec<Option<DMatrix<f64>>> = vec![None; x.len()];
        for &(k, p, q, a) in &equation.entries {
            let own = product[k].get_or_insert_with(|| DMatrix::zeros(x[k].nrows(), x[k].nrows()));
            own.ger(a, &x[k].column(p), &w[k].column(q), 1.0);
            if p != q {
                own.ger(a, &x[k].column(q), &w[k].column(p), 1.0);
            }
        }
        for (i, other) in equations.iter().enumerate() {
            let entry = |&(k, p, q, a): &(usize, usize, usize, f64)| match &product[k] {
                None => 0.0,
                Some(own) if p == q => a * own[(p, p)],
                Some(own) => a * (own[(p, q)] + own[(q, p)]),
            };
            matrix[(i, j)] = other.entries.iter().map(entry).sum();
        }
    }
    (&matrix + matrix.transpose()) * 0.5
}

/// How far a positive definite matrix can go in a direction, at most 1, and a little less than to the boundary.
fn step(from: &DMatrix<f64>, direction: &DMatrix<f64>) -> f64 {
    const SHARE: f64 = 0.95;
    let Some(root) = Cholesky::new(from.clone()) else { return 0.0 };
    let Some(half) = root.l().solve_lower_triangular(direction) else { return 0.0 };
    let Some(scaled) = root.l().solve_lower_triangular(&half.transpose()) else { return 0.0 };
    let scaled = (&scaled + scaled.transpose()) * 0.5;
    let least = scaled.symmetric_eigenvalues().min();
    if least >= 0.0 { 1.0 } else { (-SHARE / least).min(1.0) }
}

/// A solution near the analytic centre, where one is found; a singular one where none is positive definite. Nothing where it certainly went wrong.
pub(crate) fn solve(
    equations: &[Equation],
    sizes: &[usize],
    progress: &dyn Progress,
) -> Result<Option<Proposal>, Cancelled> {
    let order: usize = sizes.iter().sum();
    let right = DVector::from_iterator(equations.len(), equations.iter().map(|equation| equation.right));
    let size = 1.0 + right.amax();
    let identity =
        |factor: f64| -> Vec<DMatrix<f64>> { sizes.iter().map(|&n| DMatrix::identity(n, n) * factor).collect() };
    let (mut x, mut z) = (identity(size.max(10.0)), identity(10.0));
    let mut y = DVector::zeros(equations.len());
    let mut shrink = 0.3;
    for _ in 0..MOST_STEPS {
        progress.checkpoint()?;
        let residual = (&right - applied(equations, &x)).amax() / size;
        let gap = x.iter().zip(&z).map(|(x, z)| x.dot(z)).sum::<f64>() / order.max(1) as f64;
        if residual < SMALL_RESIDUAL && gap < SMALL_GAP {
            break;
        }
        let inverses =
            z.iter().map(|z| Cholesky::new(z.clone()).map(|root| root.inverse())).collect::<Option<Vec<_>>>();
        let Some(w) = inverses else { break };
        // Dual residual: the objective is 0.
        let sum = adjoint(equations, &y, sizes);
        let dual: Vec<DMatrix<f64>> = z.iter().zip(&sum).map(|(z, a)| -(z + a)).collect();
        let target = shrink * gap;
        let moved: Vec<DMatrix<f64>> = (0..x.len()).map(|k| &x[k] * &dual[k] * &w[k]).collect();
        let symmetric = |list: &[DMatrix<f64>]| list.iter().map(|m| (m + m.transpose()) * 0.5).collect::<Vec<_>>();
        let side = &right - applied(equations, &w) * target + applied(equations, &symmetric(&moved));
        let mut matrix = schur(equations, &x, &w);
        let scale = matrix.diagonal().amax();
        if !scale.is_finite() {
            break;
        }
        (0..matrix.nrows()).for_each(|i| matrix[(i, i)] += 1e-14 * scale);
        let Some(root) = Cholesky::new(matrix) else { break };
        let dy = root.solve(&side);
        let turned = adjoint(equations, &dy, sizes);
        let dz: Vec<DMatrix<f64>> = dual.iter().zip(&turned).map(|(r, a)| r - a).collect();
        let dx: Vec<DMatrix<f64>> = (0..x.len()).map(|k| &w[k] * target - &x[k] - &x[k] * &dz[k] * &w[k]).collect();
        let dx = symmetric(&dx);
        let primal = x.iter().zip(&dx).map(|(x, d)| step(x, d)).fold(1.0, f64::min);
        let own = z.iter().zip(&dz).map(|(z, d)| step(z, d)).fold(1.0, f64::min);
        if primal < 1e-8 && own < 1e-8 {
            break;
        }
        x.iter_mut().zip(&dx).for_each(|(x, d)| *x += d * primal);
        z.iter_mut().zip(&dz).for_each(|(z, d)| *z += d * own);
        y += dy * own;
        shrink = if primal.min(own) > 0.8 { 0.1 } else { 0.5 };
        if x.iter().any(|x| x.amax() > 1e12) {
            return Ok(None);
        }
    }
    let residual = (&right - applied(equations, &x)).amax() / size;
    Ok(residual.is_finite().then_some(Proposal { blocks: x, residual }))
}
