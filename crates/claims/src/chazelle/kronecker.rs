//! chazelle.kron and chazelle.chi: the Kronecker product, and differences of velocities as rows of a product.

use super::sequences::{in_turn, show_all};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::{kronecker_of_rows as blocks, product_of_rows as times};
use models::averaging::{Weights, random_network, transition_matrix};
use rand_chacha::rand_core::Rng;

type Dense<T> = Vec<Vec<T>>;

/// How the index rule is read, and which product the mixed one is compared with.
#[derive(Clone, Copy)]
pub struct KroneckerVariant {
    /// Indices of all matrices start here.
    first_index: usize,
    /// `c_{ip+j, kq+l}`, or `c_{jm+i, ln+k}`.
    blocks_of_b: bool,
    mixed: Mixed,
}

#[derive(Clone, Copy)]
enum Mixed {
    AcBd,
    BdAc,
    AdBc,
    CaDb,
}

impl KroneckerVariant {
    /// The matrix that the index rule gives, or `None` where it leaves the shape or does not fill it.
    fn by_rule<T: Ring>(&self, a: &Dense<T>, b: &Dense<T>) -> Option<Dense<T>> {
        let (m, n, p, q) = (a.len(), a[0].len(), b.len(), b[0].len());
        let mut filled: Vec<Vec<Option<T>>> = vec![vec![None; n * q]; m * p];
        let f = self.first_index;
        for (i, k) in (0..m).flat_map(|i| (0..n).map(move |k| (i, k))) {
            for (j, l) in (0..p).flat_map(|j| (0..q).map(move |l| (j, l))) {
                let (row, col) = if self.blocks_of_b {
                    ((i + f) * p + j + f, (k + f) * q + l + f)
                } else {
                    ((j + f) * m + i + f, (l + f) * n + k + f)
                };
                *filled.get_mut(row - f)?.get_mut(col - f)? = Some(a[i][k].clone() * &b[j][l]);
            }
        }
        filled.into_iter().map(|row| row.into_iter().collect()).collect()
    }
}

/// Shapes: A is m x n, B is p x q, C is n x r, D is q x s.
#[derive(Clone, Copy)]
struct Shapes {
    m: usize,
    n: usize,
    r: usize,
    p: usize,
    q: usize,
    s: usize,
}

/// One of the two halves of the footnote for matrices of variables.
fn footnote(shapes: Shapes, variant: &KroneckerVariant, mixed: bool) -> Identity<'_> {
    let Shapes { m, n, r, p, q, s } = shapes;
    Identity::new(m * n + p * q + n * r + q * s, move |at| {
        let mut entries = at.iter().cloned();
        let mut matrix = |rows: usize, cols: usize| -> Dense<Probe> {
            (0..rows).map(|_| entries.by_ref().take(cols).collect()).collect()
        };
        let (a, b, c, d) = (matrix(m, n), matrix(p, q), matrix(n, r), matrix(q, s));
        let (left, right) = if mixed {
            let right = match variant.mixed {
                Mixed::AcBd => blocks(&times(&a, &c), &times(&b, &d)),
                Mixed::BdAc => blocks(&times(&b, &d), &times(&a, &c)),
                Mixed::AdBc => blocks(&times(&a, &d), &times(&b, &c)),
                Mixed::CaDb => blocks(&times(&c, &a), &times(&d, &b)),
            };
            (times(&blocks(&a, &b), &blocks(&c, &d)), right)
        } else {
            let ruled = variant.by_rule(&a, &b).ok_or(ArithmeticError::Domain("indices inside the product"))?;
            (ruled, blocks(&a, &b))
        };
        Ok((left.into_iter().flatten().collect(), right.into_iter().flatten().collect()))
    })
}

pub fn kronecker() -> Record<KroneckerVariant> {
    Record::new(
        "chazelle.kron",
        "Read with indices that start at 0, the only start with which c_{ip+j, kq+l} fills an mp x nq matrix: row ip \
         + j is row j of block row i. With indices from 1, as the paper counts birds, the rule leaves the matrix (row \
         mp + p) and must read c_{(i-1)p+j, (k-1)q+l}; that is a control. Mixed product: entry (ip + j, kq + l) of \
         the left side is sum_{u,w} a_iu b_jw c_uk d_wl = (AC)_ik (BD)_jl, for all shapes for which AC and BD exist.",
        KroneckerVariant { first_index: 0, blocks_of_b: true, mixed: Mixed::AcBd },
        check_kronecker,
    )
    .reading(
        "The indices of the footnote start at 0, the only start with which the rule fills the matrix. The paper, \
         which counts birds from 1, does not say; with indices from 1 it reads c_{(i-1)p+j, (k-1)q+l}.",
    )
    .clauses(&[
        "For A m-by-n and B p-by-q, A kron B has entries c_{ip+j, kq+l} = a_{i,k} b_{j,l}.",
        "(A kron B)(C kron D) = AC kron BD.",
    ])
    .altered("indices from 1", |v| v.first_index = 1)
    .altered("c_{jm+i, ln+k}", |v| v.blocks_of_b = false)
    .altered("BD kron AC", |v| v.mixed = Mixed::BdAc)
    .altered("AD kron BC", |v| v.mixed = Mixed::AdBc)
    .altered("CA kron DB", |v| v.mixed = Mixed::CaDb)
}

fn check_kronecker(variant: &KroneckerVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // The second and the third fit one of the altered products each.
    let (ad_bc, ca_db) = ([1, 2, 1, 1, 2, 1], [2, 1, 2, 1, 2, 1]);
    let shapes = [
        [1, 1, 1, 1, 1, 1],
        ad_bc,
        ca_db,
        [2, 2, 2, 2, 2, 2],
        [2, 3, 1, 3, 2, 2],
        [3, 1, 2, 1, 4, 2],
        [1, 4, 3, 2, 1, 3],
    ];
    let mut parts = Vec::new();
    for [m, n, r, p, q, s] in shapes {
        let shapes = Shapes { m, n, r, p, q, s };
        let fits = match variant.mixed {
            Mixed::AcBd | Mixed::BdAc => true,
            Mixed::AdBc => n == q,
            Mixed::CaDb => (m, p) == (r, s) && m * p == n * q,
        };
        let names: Vec<String> = (1..=m * n + p * q + n * r + q * s).map(|k| format!("x{k}")).collect();
        let ones = |rows, cols| vec![vec![rational(1, 1); cols]; rows];
        if variant.by_rule::<Rational>(&ones(m, n), &ones(p, q)).is_none() {
            let what = format!("the index rule does not fill {} x {} from A {m} x {n} and B {p} x {q}", m * p, n * q);
            return Ok(Outcome::fails(what, exact("the index rule", "all indices")));
        }
        let part = format!("entries, A {m} x {n}, B {p} x {q}");
        parts.push(run.identity(&footnote(shapes, variant, false), &names, &part).on([1]));
        if fits {
            let part = format!("mixed product, A {m} x {n}, B {p} x {q}, C {n} x {r}, D {q} x {s}");
            parts.push(run.identity(&footnote(shapes, variant, true), &names, &part).on([2]));
        }
    }
    Run::all(parts)
}

/// The assignments that define `chi(i, j)`, in order, and the product it meets.
#[derive(Clone)]
pub struct DifferenceVariant {
    /// `(whether the index is j, value)`.
    assignments: Vec<(bool, i64)>,
    /// The last factor of the product is `P(t - 1 + shift)`.
    shift: isize,
}

impl DifferenceVariant {
    fn chi(&self, n: usize, i: usize, j: usize) -> Vec<Rational> {
        let mut chi = vec![rational(0, 1); n];
        for &(second, value) in &self.assignments {
            chi[if second { j } else { i }] = rational(value, 1);
        }
        chi
    }

    fn fails_at(
        &self,
        n: usize,
        d: usize,
        graphs: &[Graph],
        start: &Dense<Rational>,
    ) -> Result<Option<Counterexample>, CheckError> {
        let lazy = |graph| Ok(transition_matrix(graph, &Weights::Lazy)?.to_rows());
        let matrices: Vec<Dense<Rational>> = graphs.iter().map(lazy).collect::<Result<_, CheckError>>()?;
        let unit = |order: usize| -> Dense<Rational> {
            (0..order).map(|i| (0..order).map(|j| rational(i64::from(i == j), 1)).collect()).collect()
        };
        let mut velocities = start.clone();
        for t in 1..=graphs.len() {
            let last = (t as isize - 1 + self.shift).max(0) as usize;
            let product = matrices[..last].iter().fold(unit(n), |product, p| times(p, &product));
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|(i, j)| i != j) {
                let right = times(&blocks(&times(&[self.chi(n, i, j)], &product), &unit(d)), start);
                let left: Vec<Rational> =
                    (0..d).map(|k| velocities[i * d + k][0].clone() - &velocities[j * d + k][0]).collect();
                let (left, right): (Vec<_>, Vec<_>) = (left.iter().collect(), right.iter().flatten().collect());
                if left != right {
                    let names = format!("v_{}({t}) - v_{}({t})", i + 1, j + 1);
                    let (start, networks) = (start.iter().flatten().collect::<Vec<_>>(), show_all(&graphs[..t]));
                    let mut witnesses = vec![in_turn(&graphs[..t])];
                    if let ([found], [claimed]) = (left.as_slice(), right.as_slice()) {
                        witnesses.push(Witness::compared(&names, found, "the right side", claimed));
                    }
                    let (start, left, right) = (list(start), list(left), list(right));
                    let text = format!(
                        "{n} birds, d = {d}, v(1) = ({start}), {networks}: {names} = ({left}), the right side is ({right})"
                    );
                    return Ok(Some(Counterexample::new(text, witnesses)));
                }
            }
            velocities = times(&blocks(&matrices[t - 1], &unit(d)), &velocities);
        }
        Ok(None)
    }
}

pub fn difference() -> Record<DifferenceVariant> {
    Record::new(
        "chazelle.chi",
        "v(t) = (P(t-1,1) kron I_d) v(1), with the empty product I for t = 1. The row chi P(t-1,1) is row i minus row \
         j of the product. The second printed index must be j: with i twice the vector would have one nonzero \
         coordinate, of two values.",
        DifferenceVariant { assignments: vec![(false, 1), (false, -1)], shift: 0 },
        check_difference,
    )
    .repaired(
        Fault::Typo,
        "In model D with n birds in R^d, t >= 1, P(t-1,1) = P(t-1) ... P(1) (the identity for t = 1), i != j and chi(i,j) the row vector of \
         length n whose coordinates are 0 except chi(i,j)_i = 1 and chi(i,j)_j = -1: v_i(t) - v_j(t) = ((chi(i,j) P(t-1,1)) kron I_d) v(1).",
        DifferenceVariant { assignments: vec![(false, 1), (true, -1)], shift: 0 },
    )
    .altered("chi_i = 1 alone", |v| v.assignments = vec![(false, 1)])
    .altered("chi_j = 1", |v| v.assignments = vec![(false, 1), (true, 1)])
    .altered("the product P(t,1)", |v| v.shift = 1)
    .altered("the product P(t-2,1)", |v| v.shift = -1)
}

fn check_difference(variant: &DifferenceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const RUNS: &str = "exact runs";
    let mut random = run.random(0);
    let detail = "2 to 5 birds, d = 1, 2, 3, t = 1, ..., 5, lazy weights, all i != j";
    let runs = run.every(fuzzed(RUNS, detail), 0..run.cases(40, 800), |case| {
        // Small cases first: 2 birds on a line.
        let (n, d) = (2 + (case / 4) % 4, 1 + case % 3);
        // The first two are joined, with velocities for which each altered right side is another number.
        if case == 0 {
            let start = [2, 7].map(|v| vec![rational(v, 1)]).to_vec();
            return variant.fails_at(n, d, &vec![Graph::path(2); 5], &start);
        }
        let graphs: Vec<Graph> = (0..5).map(|_| random_network(n, 2, &mut random)).collect();
        let start: Dense<Rational> =
            (0..n * d).map(|_| vec![rational(i64::from(random.next_u32() % 17) - 8, 4)]).collect();
        variant.fails_at(n, d, &graphs, &start)
    })?;
    let runs = match runs {
        Outcome::Fails { counterexample, .. } => Outcome::fails(counterexample, exact(RUNS, "an exact run")),
        other => other,
    };
    Run::all([Ok(runs), run.identity(&generic(variant), &[""; 0], "two generic factors, three birds in the plane")])
}

/// `v_1(3) - v_2(3)` for three birds in the plane and two matrices of variables.
fn generic(variant: &DifferenceVariant) -> Identity<'_> {
    Identity::new(2 * 9 + 6, move |at| {
        let matrix =
            |from: usize| -> Dense<Probe> { (0..3).map(|i| at[from + 3 * i..from + 3 * i + 3].to_vec()).collect() };
        let one = at[0].one();
        let unit: Dense<Probe> = vec![vec![one.clone(), one.zero()], vec![one.zero(), one.clone()]];
        let (first, second) = (matrix(0), matrix(9));
        let start: Dense<Probe> = at[18..].iter().map(|x| vec![x.clone()]).collect();
        let velocities = times(&blocks(&second, &unit), &times(&blocks(&first, &unit), &start));
        let left = (0..2).map(|k| velocities[k][0].clone() - &velocities[2 + k][0]).collect();
        let chi = variant.chi(3, 0, 1).iter().map(|x| one.rational(x)).collect();
        let row = times(&[chi], &times(&second, &first));
        let right = times(&blocks(&row, &unit), &start).into_iter().flatten().collect();
        Ok((left, right))
    })
}
