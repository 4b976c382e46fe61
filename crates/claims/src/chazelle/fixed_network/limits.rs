//! chazelle.lem3.3, chazelle.eq3.12-13, chazelle.lem3.4: where a flock with a fixed network goes.

use super::{FAMILY, Family, Network, exhaustively};
use crate::prelude::*;
use algebra::matrix::{MatrixError, RationalMatrix};
use models::averaging::{State, contraction, deviation_matrix, equal_rows, motion};
use num_traits::Zero;

const STEPS: usize = 6;

/// `(Y | y)`: the last column of `Y` replaced by `y`.
fn with_last_column(y: &RationalMatrix, column: &[Rational]) -> Result<RationalMatrix, CheckError> {
    let replaced = y.to_rows().into_iter().zip(column).map(|(mut row, x)| {
        if let Some(last) = row.last_mut() {
            last.clone_from(x);
        }
        row
    });
    Ok(RationalMatrix::from_rows(&replaced.collect::<Vec<_>>())?)
}

/// `(I - 1 w^T | left) (I - P | right)^-1`; `None` where the second matrix is singular.
fn bracket(
    network: &Network,
    projection: &RationalMatrix,
    left: Option<&[Rational]>,
    right: &[Rational],
) -> Result<Option<RationalMatrix>, CheckError> {
    let left = match left {
        Some(column) => with_last_column(projection, column)?,
        None => projection.clone(),
    };
    let right = with_last_column(&network.identity()?.minus(&network.p)?, right)?;
    match right.inverse() {
        Ok(inverse) => Ok(Some(left.times(&inverse)?.reduced())),
        Err(MatrixError::Singular) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// `Gamma` by the formula of Lemma 3.3.
pub(super) fn limit_of_lemma_3_3(network: &Network) -> Result<Option<RationalMatrix>, CheckError> {
    let n = network.order();
    let projection = network.identity()?.minus(&equal_rows(&network.pi())?)?;
    bracket(network, &projection, Some(&vec![rational(0, 1); n]), &vec![rational(1, 1); n])
}

#[derive(Clone, Copy)]
pub struct LimitOfGammaVariant {
    family: Family<'static>,
    /// The factor of `1 pi^T t` in `Gamma_t`.
    drift: i64,
    /// Whether `1 pi^T` is subtracted on the left.
    projected: bool,
    /// Whether the last column on the left becomes 0.
    zero_column: bool,
    /// Whether the last column on the right becomes 1, or `pi`.
    column_of_ones: bool,
}

impl LimitOfGammaVariant {
    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let (n, pi) = (network.order(), network.pi());
        let (zeros, ones) = (vec![rational(0, 1); n], vec![rational(1, 1); n]);
        let (identity, drift) = (network.identity()?, equal_rows(&pi)?);
        let projection = if self.projected { identity.minus(&drift)? } else { identity.clone() };
        let left = self.zero_column.then_some(zeros.as_slice());
        let Some(limit) = bracket(network, &projection, left, if self.column_of_ones { &ones } else { &pi })? else {
            return Ok(Some("the matrix on the right is singular".into()));
        };
        // If Gamma_1 = X - P X then Gamma_t = X - P^t X for all t by induction, and this tends to X - 1 pi^T X.
        let (mut sum, mut rest) = (identity.clone(), limit.clone());
        for t in 1..=STEPS {
            let gamma_t = sum.plus(&drift.scaled(&rational(self.drift * t as i64, 1)))?;
            rest = network.p.times(&rest)?;
            if gamma_t != limit.minus(&rest)? {
                return Ok(Some(format!("t = {t}: Gamma_t is not Gamma - P^t Gamma")));
            }
            sum = network.p.times(&sum)?.plus(&identity)?;
        }
        if limit.transpose().apply(&pi)? != zeros {
            return Ok(Some("P^t Gamma tends to 1 pi^T Gamma, which is not 0".into()));
        }
        match contraction(&network.p) {
            Err(MatrixError::NotErgodic) => return Ok(Some("P^t does not converge to 1 pi^T".into())),
            other => other?,
        };
        Ok((limit != deviation_matrix(&network.p, &pi)?).then(|| "not (I - P + 1 pi^T)^-1 - 1 pi^T".into()))
    }
}

pub fn limit_of_gamma() -> Record<LimitOfGammaVariant> {
    let printed = LimitOfGammaVariant {
        family: Family::PRINTED,
        drift: -1,
        projected: true,
        zero_column: true,
        column_of_ones: true,
    };
    Record::new(
        "chazelle.lem3.3",
        "Gamma_t (I - P) = I - P^t and Gamma_t 1 = 0, so Gamma_t (I - P | 1) = (I - P^t | 0). The matrix on the left \
         is invertible: its first n - 1 columns span the range of I - P, on which pi^T vanishes, and pi^T 1 = 1. P^t \
         tends to 1 pi^T. The limit is the group inverse of I - P. For one bird it is 0. On an instance the limit X \
         is established by Gamma_1 = X - P X, which gives Gamma_t = X - P^t X, by pi^T X = 0, and by a power that \
         contracts.",
        printed,
        |variant, run| {
            let part = "the limit, which also is (I - P + 1 pi^T)^-1 - 1 pi^T";
            let networks = variant.family.labelled(4, run.cases(5, 6))?;
            let detail = format!(
                "{FAMILY} on 5 birds (and 6 with --full) and every labelled one on up to 4, three kinds of weights"
            );
            exhaustively(&networks, run, part, detail, |network| variant.fails_at(network))
        },
    )
    .altered("+ 1 pi^T t in Gamma_t", |v| v.drift = 1)
    .altered("(I | 0) on the left", |v| v.projected = false)
    .altered("the last column kept on the left", |v| v.zero_column = false)
    .altered("(I - P | pi) on the right", |v| v.column_of_ones = false)
    .altered("not connected", |v| v.family = Family::ANY_GRAPH)
}

#[derive(Clone, Copy)]
pub struct PositionsVariant {
    /// The sum has `t + longer` terms.
    longer: i64,
    /// The power of `P` in the first term.
    first: u32,
    /// The factor of `Gamma_t`.
    sign: i64,
    /// `A (x) I_d`, or `I_d (x) A`.
    birds_outside: bool,
}

impl PositionsVariant {
    fn lift(&self, matrix: &RationalMatrix, d: usize) -> Result<RationalMatrix, CheckError> {
        let identity = RationalMatrix::identity(d)?;
        Ok(if self.birds_outside { matrix.kronecker(&identity) } else { identity.kronecker(matrix) })
    }

    /// `sum P^s` as claimed for time `t`.
    fn sum(&self, network: &Network, t: usize) -> Result<RationalMatrix, CheckError> {
        let mut power = network.identity()?;
        for _ in 0..self.first {
            power = power.times(&network.p)?;
        }
        let mut sum = power.scaled(&rational(0, 1));
        for _ in 0..(t as i64 + self.longer).max(0) {
            sum = sum.plus(&power)?;
            power = power.times(&network.p)?;
        }
        Ok(sum)
    }

    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let drift = equal_rows(&network.pi())?;
        for d in 1..=2 {
            let size = d * network.order();
            let start: Vec<Rational> = (0..size).map(|k| rational(k as i64 * k as i64 + 1, k as i64 + 2)).collect();
            // Both sides are linear in v(1): unit vectors are enough for all of them.
            let runs: Vec<Vec<State>> = (0..size)
                .map(|k| {
                    let velocities = (0..size).map(|l| rational(i64::from(k == l), 1)).collect();
                    motion(State { positions: start.clone(), velocities }, d, &vec![network.p.clone(); STEPS])
                })
                .collect::<Result<_, _>>()?;
            for t in 1..=STEPS {
                let (sum, linear) = (self.sum(network, t)?, drift.scaled(&rational(t as i64, 1)));
                let gamma = sum.minus(&linear)?.scaled(&rational(self.sign, 1));
                let whole = self.lift(&sum, d)?;
                let split = self.lift(&linear, d)?.plus(&self.lift(&gamma, d)?)?;
                for (k, run) in runs.iter().enumerate() {
                    let claimed = |matrix: &RationalMatrix| -> Vec<Rational> {
                        start.iter().enumerate().map(|(row, x)| x + matrix.entry(row, k)).collect()
                    };
                    for (equation, matrix) in [("(3.12)", &whole), ("(3.13)", &split)] {
                        if claimed(matrix) != run[t].positions {
                            return Ok(Some(format!(
                                "d = {d}, v(1) the unit vector {}, t = {t}: x(t) = ({}), by {equation} it is ({})",
                                k + 1,
                                list(&run[t].positions),
                                list(claimed(matrix))
                            )));
                        }
                    }
                }
            }
        }
        Ok(None)
    }
}

pub fn positions() -> Record<PositionsVariant> {
    Record::new(
        "chazelle.eq3.12-13",
        "With a fixed network v(s+1) = (P^s (x) I_d) v(1), because (A (x) I)(B (x) I) = AB (x) I. x(t) = x(0) + v(1) \
         + .. + v(t): t terms, s = 0, .., t - 1. (3.13) is (3.12) with the definition of Gamma_t; it needs no \
         connectivity.",
        PositionsVariant { longer: 0, first: 0, sign: 1, birds_outside: true },
        check_positions,
    )
    .clauses(&[
        "x(t) = x(0) + (sum_{s=0}^{t-1} P^s kron I_d) v(1).",
        "x(t) = x(0) + t ((1 pi^T) kron I_d) v(1) + (Gamma_t kron I_d) v(1).",
    ])
    .altered("the sum to s = t", |v| v.longer = 1)
    .altered("the sum from s = 1 to t", |v| v.first = 1)
    .altered("- Gamma_t in (3.13)", |v| v.sign = -1)
    .altered("I_d (x) P", |v| v.birds_outside = false)
}

fn check_positions(variant: &PositionsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "both equations against steps of (1.2)";
    let networks = Family::PRINTED.networks(run.cases(4, 5))?;
    let detail = format!(
        "{FAMILY} on up to 4 birds (5 with --full), three kinds of weights, d = 1 and 2, every unit vector v(1), t = \
         1, .., {STEPS}"
    );
    exhaustively(&networks, run, part, detail, |network| variant.fails_at(network)).on([1, 2])
}

#[derive(Clone, Copy)]
pub struct RelativeLimitVariant {
    family: Family<'static>,
    /// The factor of the second term.
    sign: i64,
    /// Whether the first term is projected.
    projected: bool,
    /// The power of `C` that weighs the mass center: -1 gives `pi`.
    weights: i32,
}

impl RelativeLimitVariant {
    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let (n, center) = (network.order(), network.normalised_power(self.weights));
        let (zeros, ones) = (vec![rational(0, 1); n], vec![rational(1, 1); n]);
        let projection = network.identity()?.minus(&equal_rows(&center)?)?;
        let Some(gamma) = bracket(network, &projection, Some(&zeros), &ones)? else {
            return Ok(Some("the matrix on the right is singular".into()));
        };
        for d in 1..=2 {
            let lift = RationalMatrix::identity(d)?;
            let relative = projection.kronecker(&lift);
            let of_positions = if self.projected { relative.clone() } else { RationalMatrix::identity(d * n)? };
            let of_velocities = gamma.scaled(&rational(self.sign, 1)).kronecker(&lift);
            let mass = RationalMatrix::from_rows(std::slice::from_ref(&center))?.kronecker(&lift);
            let steps = vec![network.p.clone(); STEPS];
            for k in 0..2 * d * n {
                // Everything is linear in (x(0), v(1)): unit vectors are enough.
                let unit = |l: usize| rational(i64::from(k == l), 1);
                let positions: Vec<Rational> = (0..d * n).map(unit).collect();
                let velocities: Vec<Rational> = (d * n..2 * d * n).map(unit).collect();
                let limit = sum(&of_positions.apply(&positions)?, &of_velocities.apply(&velocities)?);
                let run = motion(State { positions, velocities: velocities.clone() }, d, &steps)?;
                let mut rest: Option<Vec<Rational>> = None;
                for (t, state) in run.iter().enumerate() {
                    let away = difference(&relative.apply(&state.positions)?, &limit);
                    if rest.is_some_and(|rest| rest != away) {
                        return Ok(Some(format!(
                            "d = {d}, unit vector {}: not P^t times the first distance at t = {t}",
                            k + 1
                        )));
                    }
                    if mass.apply(&away)?.iter().any(|x| !x.is_zero()) {
                        return Ok(Some(format!("d = {d}, unit vector {}: the claimed limit is not centered", k + 1)));
                    }
                    rest = Some(network.p.kronecker(&lift).apply(&away)?);
                    let moved = difference(&mass.apply(&state.velocities)?, &mass.apply(&velocities)?);
                    if moved.iter().any(|x| !x.is_zero()) {
                        return Ok(Some(format!(
                            "d = {d}, unit vector {}: the mass center is not steady at t = {t}",
                            k + 1
                        )));
                    }
                }
            }
        }
        // P^t times a vector without mass tends to 0.
        match contraction(&network.p) {
            Err(MatrixError::NotErgodic) => Ok(Some("P^t does not converge".into())),
            other => Ok(other.map(|_| None)?),
        }
    }
}

fn sum(x: &[Rational], y: &[Rational]) -> Vec<Rational> {
    x.iter().zip(y).map(|(x, y)| x + y).collect()
}

fn difference(x: &[Rational], y: &[Rational]) -> Vec<Rational> {
    x.iter().zip(y).map(|(x, y)| x - y).collect()
}

pub fn relative_limit() -> Record<RelativeLimitVariant> {
    Record::new(
        "chazelle.lem3.4",
        "pi^T Gamma_t = 0 and (I - 1 pi^T) 1 pi^T = 0, so x^r(t) = ((I - 1 pi^T) (x) I) x(0) + (Gamma_t (x) I) v(1), \
         and Lemma 3.3 gives the limit. pi^T P = pi^T: the mass center moves by m_pi[v(1)] in every step. On an \
         instance: x^r(t) minus the limit is multiplied by P in each step and has no mass, so it tends to 0.",
        RelativeLimitVariant { family: Family::PRINTED, sign: 1, projected: true, weights: -1 },
        check_relative_limit,
    )
    .reading(
        "\"Constant speed in a fixed direction\" is constant velocity, which may be 0 (the four birds of the \
              paper).",
    )
    .clauses(&[
        "If G is connected, the relative configuration x^r(t) converges to ((I_n - 1 pi^T) kron I_d) x(0) + ((I_n - 1 \
         pi^T | 0)(I_n - P | 1)^{-1} kron I_d) v(1).",
        "The mass center moves at constant speed in a fixed direction.",
    ])
    .altered("minus the second term", |v| v.sign = -1)
    .altered("x(0) without I - 1 pi^T", |v| v.projected = false)
    .altered("the plain mean as mass center", |v| v.weights = 0)
    .altered("not connected", |v| v.family = Family::ANY_GRAPH)
}

fn check_relative_limit(variant: &RelativeLimitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "the limit and the steady mass center";
    let networks = variant.family.networks(run.cases(4, 5))?;
    let detail = format!(
        "{FAMILY} on up to 4 birds (5 with --full), three kinds of weights, d = 1 and 2, every unit vector (x(0), \
         v(1))"
    );
    exhaustively(&networks, run, part, detail, |network| variant.fails_at(network)).on([1, 2])
}
