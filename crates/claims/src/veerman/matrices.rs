//! veerman.eq1_matrix, veerman.eq2_matrix, veerman.dimL: the equations of motion in vector form.

use crate::prelude::*;
use algebra::matrix::RationalMatrix;
use models::platoon::vector_form::{control_block, geodesic_block, kronecker_apply};
use models::platoon::{Communication, CommunicationGraph, Gains, accelerations};

/// Platoons of up to this many followers contain every kind of row: first, middle, last, and first = last.
const LARGEST: usize = 5;

/// The printed matrices, entry by entry.
#[derive(Clone, Copy)]
pub struct MatrixVariant {
    communication: Communication,
    diagonal: (i64, i64),
    below: (i64, i64),
    above: (i64, i64),
    /// Left of the diagonal in the last row.
    last: (i64, i64),
    /// The sign with which `zeta` enters.
    zeta_sign: i64,
    /// The matrix `A`, or its transpose.
    transposed: bool,
    /// The only eigenvalue of `P`, where one is claimed.
    eigenvalue: Option<i64>,
}

/// Equation (1) as printed.
const FRONT: MatrixVariant = MatrixVariant {
    communication: Communication::Front,
    diagonal: (1, 1),
    below: (-1, 1),
    above: (0, 1),
    last: (-1, 1),
    zeta_sign: -1,
    transposed: false,
    eigenvalue: Some(1),
};

/// Equation (2) as printed.
const FRONT_AND_BACK: MatrixVariant = MatrixVariant {
    communication: Communication::FrontAndBack,
    below: (-1, 2),
    above: (-1, 2),
    eigenvalue: None,
    ..FRONT
};

impl MatrixVariant {
    /// The Laplacian with the printed rows, of all agents: `P` is what is left without the leader's row and column, `L_l` the rest
    /// of its column.
    fn laplacian(&self, followers: usize) -> Vec<Vec<Rational>> {
        let number = |(p, q): (i64, i64)| rational(p, q);
        let mut rows = vec![vec![rational(0, 1); followers + 1]; followers + 1];
        for (k, row) in rows.iter_mut().enumerate().skip(1) {
            row[k] = number(self.diagonal);
            row[k - 1] = number(if k == followers { self.last } else { self.below });
            if k < followers {
                row[k + 1] = number(self.above);
            }
        }
        rows
    }

    fn reduced(&self, followers: usize) -> Vec<Vec<Rational>> {
        self.laplacian(followers).into_iter().skip(1).map(|row| row[1..].to_vec()).collect()
    }

    fn leader_column(&self, followers: usize) -> Vec<Vec<Rational>> {
        self.laplacian(followers).into_iter().skip(1).map(|row| row[..1].to_vec()).collect()
    }
}

/// The vector form gives the velocities and the accelerations of the printed equations, for any state; variables are f, g,
/// position, velocity and desired position of every agent.
fn vector_form(variant: &MatrixVariant, followers: usize) -> Identity<'_> {
    Identity::new(2 + 3 * (followers + 1), move |at| {
        let [f, g, agents @ ..] = at else { return Err(ArithmeticError::Domain("f, g and the numbers of the agents")) };
        let gains = Gains { f: f.clone(), g: g.clone() };
        let state = |k: usize| [agents[3 * k].clone(), agents[3 * k + 1].clone()];
        let desired = |k: usize| [agents[3 * k + 2].clone(), f.zero()];
        let deviation = |k: usize| agents[3 * k].clone() - &agents[3 * k + 2];
        let each = 1..=followers;
        let rates: Vec<Probe> = each.clone().map(|k| state(k)[1].clone()).collect();
        let forces = accelerations(
            variant.communication,
            &gains,
            (&deviation(0), &state(0)[1]),
            &each.clone().map(deviation).collect::<Vec<Probe>>(),
            &rates,
        );
        let sign = f.integer(variant.zeta_sign);
        let relative = |k: usize| {
            let ([x, u], [zeta, rest]) = (state(k), desired(k));
            [x + sign.clone() * zeta, u + sign.clone() * rest]
        };
        let [[a00, a01], [a10, a11]] = geodesic_block(f);
        let geodesic = if variant.transposed { [[a00, a10], [a01, a11]] } else { [[a00, a01], [a10, a11]] };
        let control = control_block(&gains);
        let identity =
            RationalMatrix::identity(followers).map_err(|_| ArithmeticError::Domain("at least one follower"))?;
        let free = kronecker_apply(&identity.to_rows(), &geodesic, &each.clone().map(state).collect::<Vec<_>>());
        let own =
            kronecker_apply(&variant.reduced(followers), &control, &each.clone().map(relative).collect::<Vec<_>>());
        let leader = kronecker_apply(&variant.leader_column(followers), &control, &[relative(0)]);
        let vector_form = free.into_iter().zip(own).zip(leader).flat_map(|((a, b), c)| {
            let ([a0, a1], [b0, b1], [c0, c1]) = (a, b, c);
            [a0 + b0 + c0, a1 + b1 + c1]
        });
        let equations = rates.into_iter().zip(forces).flat_map(|(u, a)| [u, a]);
        Ok((vector_form.collect(), equations.collect()))
    })
    .named((1..=followers).flat_map(|k| [format!("the rate of x_{k}"), format!("the rate of u_{k}")]))
}

/// The vector form and the matrices bear on clause 1, the spectrum of P_1 on the others.
fn examine_matrices(variant: &MatrixVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut results = Vec::new();
    for followers in 1..=LARGEST {
        let names: Vec<String> = (0..=followers).flat_map(|k| ["x", "u", "h"].map(|v| format!("{v}_{k}"))).collect();
        let names: Vec<String> = ["f", "g"].map(String::from).into_iter().chain(names).collect();
        let part = format!("the vector form is the printed equations, {followers} followers, any state and leader");
        results.push(run.identity(&vector_form(variant, followers), &names, &part).on([1]));
    }
    results.push(from_the_graph(variant, run).on([1]));
    if let Some(eigenvalue) = variant.eigenvalue {
        results.push(only_eigenvalue(variant.communication, eigenvalue, run).on([2, 3]).checks("step 2"));
        results.push(argued(&[3], "the multiplicity", "notes/veerman_platoons.md, spectra, steps 1 and 2"));
    }
    Run::all(results)
}

const MOST: usize = 12;

/// The printed matrices are those of the communication graph.
fn from_the_graph(variant: &MatrixVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = format!("L, P and L_l built from the communication graph are the printed ones, 1 to {MOST} followers");
    run.instances("matrices of the graph", &detail, 1..=MOST, |followers| {
        let graph = CommunicationGraph::of(variant.communication, followers)?;
        let printed = RationalMatrix::from_rows(&variant.laplacian(followers))?;
        let wrong = graph.laplacian()? != printed;
        Ok(wrong.then(|| format!("{followers} followers: not the Laplacian of the graph")))
    })
}

/// `P` has this eigenvalue with the multiplicity N + 1.
fn only_eigenvalue(communication: Communication, eigenvalue: i64, run: &Run) -> Result<Outcome, CheckError> {
    let detail = format!("characteristic polynomial (x - 1)^(N+1), 1 to {MOST} followers");
    run.instances("spectrum of P_1", &detail, 1..=MOST, |followers| {
        let reduced = CommunicationGraph::of(communication, followers)?.reduced_laplacian()?;
        let times = reduced.characteristic_polynomial()?.multiplicity(&rational(eigenvalue, 1));
        let what = || format!("{followers} followers: {eigenvalue} is not an eigenvalue of P of multiplicity N + 1");
        Ok((times != followers).then(what))
    })
}

pub fn front() -> Record<MatrixVariant> {
    Record::new(
        "veerman.eq1_matrix",
        "Row k of P_1 and L_l has the entries 1 at k and -1 at k - 1 (in L_l for k = 1). So row k of P_1 ⊗ K (x - zeta) + L_l ⊗ \
         (K (x_l - zeta_l)) is (0, f (y_k - y_{k-1}) + g (u_k - u_{k-1})) with y = x - zeta, and I ⊗ A x adds (u_k, 0): \
         equation (1) with zeta = h. The rows of (L_l, P_1) sum to zero, so zeta may also be h shifted. Every row has one of the shapes first, later or first = last, \
         which platoons of up to five followers show. P_1 is lower triangular with ones on the diagonal: only the eigenvalue 1.",
        FRONT,
        examine_matrices,
    )
    .clauses(&[
        "The equations of motion (1) are equivalent to xdot = I_{N+1} kron A x + P_1 kron K (x - zeta) + L_l kron (K (x_l(t) - zeta_l)) with A = [[0,1],[0,0]], K = [[0,0],[f,g]] and P_1 lower bidiagonal with 1 on the diagonal and -1 below.",
        "The only eigenvalue of P_1 is 1.",
        "Its multiplicity is N+1.",
    ])
    .altered("+1 below the diagonal", |v| v.below = (1, 1))
    .altered("-1/2 above the diagonal", |v| v.above = (-1, 2))
    .altered("x + zeta", |v| v.zeta_sign = 1)
    .altered("the transpose of A", |v| v.transposed = true)
    .altered("the eigenvalue 2", |v| v.eigenvalue = Some(2))
}

pub fn front_and_back() -> Record<MatrixVariant> {
    Record::new(
        "veerman.eq2_matrix",
        "Row k <= N of (L_l, P_2) is 1 at k and -1/2 at k - 1 and k + 1; the last row is 1 at N + 1 and -1 at N. As for system \
         (1), row k of the vector form is then equation (2) with zeta = h. The rows have the shapes first, middle, last and \
         first = last, all of which occur up to five followers.",
        FRONT_AND_BACK,
        examine_matrices,
    )
    .altered("-1/2 in the last row", |v| v.last = (-1, 2))
    .altered("2 on the diagonal", |v| v.diagonal = (2, 1))
    .altered("nothing above the diagonal", |v| v.above = (0, 1))
    .altered("x + zeta", |v| v.zeta_sign = 1)
}

/// Orders minus the number `N + 1` of followers, the agent whose row and column `P` lacks (the leader or the last one), and whether the Laplacian
/// is that of the communication graph or of the one in which everyone tracks the leader.
#[derive(Clone, Copy)]
pub struct DimensionsVariant {
    identity: usize,
    without_last: bool,
    star: bool,
}

pub fn dimensions() -> Record<DimensionsVariant> {
    Record::new(
        "veerman.dimL",
        "The agents are 0 to N + 1, so the directed Laplacian with the printed zero first row (the leader's) has N + 2 rows. That \
         L_l consists of the entries 1 through N + 1 of its first column, numbered from 0, and is an (N+1)-vector says the same. \
         Without the leader's row and column it is the printed P_i, of dimension N + 1 like the identity.",
        DimensionsVariant { identity: 0, without_last: false, star: false },
        examine_dimensions,
    )
    .reading("\"(N+1)-dimensional\" belongs to the identity; read with L_i too it would be wrong, since L_i has N+2 rows.")
    .clauses(&[
        "I_{N+1} is the (N+1)-dimensional identity, of the order of P_i.",
        "L_i is the Directed Laplacian of the communication graph.",
        "P_i is the Reduced Directed Laplacian: L_i without the row and the column of the leader.",
    ])
    .altered("the identity of dimension N + 2", |v| v.identity = 1)
    .altered("L of the graph in which everyone tracks the leader", |v| v.star = true)
    .altered("P is L without the last agent", |v| v.without_last = true)
}

fn examine_dimensions(variant: &DimensionsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let cases = [FRONT, FRONT_AND_BACK].into_iter().flat_map(|system| (1..=MOST).map(move |m| (system, m)));
    let detail = format!("printed matrices against the communication graph, both systems, 1 to {MOST} followers");
    let outcome = run.instances("the three matrices", &detail, cases, |(system, followers)| {
        let graph = if variant.star {
            CommunicationGraph::star(followers)?
        } else {
            CommunicationGraph::of(system.communication, followers)?
        };
        let (rows, printed) = (graph.laplacian()?.to_rows(), system.reduced(followers));
        let without = |agent: usize| {
            let kept = |k: &usize| *k != agent;
            let row = |i: usize| (0..rows.len()).filter(kept).map(|j| rows[i][j].clone()).collect::<Vec<_>>();
            (0..rows.len()).filter(kept).map(row).collect::<Vec<_>>()
        };
        let size = format!("{:?}, N = {}", system.communication, followers - 1);
        Ok(match () {
            () if printed.len() != followers + variant.identity => Some(format!("{size}: P has {followers} rows")),
            () if rows != system.laplacian(followers) => Some(format!("{size}: the Laplacian is not the printed one")),
            () if without(if variant.without_last { followers } else { 0 }) != printed => {
                Some(format!("{size}: P is another matrix"))
            }
            () => None,
        })
    })?;
    let steps = "notes/veerman_platoons.md, the printed matrices, steps 1 to 3";
    Run::all([Ok(outcome.on([1, 2, 3])), argued(&[1, 2, 3], "every N", steps)])
}
