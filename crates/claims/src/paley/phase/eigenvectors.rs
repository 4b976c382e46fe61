//! paley.eig.sym, paley.fig2.caption: which eigenvectors with entries of modulus one a circulant Laplacian has.

use super::common::{all_zero, laplacian, turns};
use crate::prelude::*;
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::{SparseMatrix, inertia};
use arithmetic::{CosineField, RealCyclotomic, Sign, Signed};
use models::oscillator::{
    clusters_of_pattern, exact_phasors, fourier_column, in_turns, is_eigenvector, laplacian_rows, misalignment, phasor,
    up_to_rotation,
};
use num_integer::Integer;

/// How many clusters the column `m`, counted from 0, has.
pub fn clusters_of_column(nodes: usize, m: usize) -> usize {
    nodes / nodes.gcd(&m)
}

/// All eigenvectors with entries of modulus one, or the columns of `F` only, and how many clusters column `m` has.
#[derive(Clone, Copy)]
pub struct SymmetryVariant {
    columns_only: bool,
    clusters: fn(nodes: usize, m: usize) -> usize,
}

pub fn circulant_eigenvectors() -> Record<SymmetryVariant> {
    Record::new(
        "paley.eig.sym",
        "The columns of F are eigenvectors, but not the only ones: an eigenvalue of an undirected circulant is repeated unless it belongs to column 1 or \
         N/2 + 1. On C_4 every rhombus (u, v, -u, -v) with |u| = |v| = 1 is an eigenvector with eigenvalue 2; on K_N every balanced arrangement is one with eigenvalue N; on a \
         graph without edges every arrangement is one (there already for N = 2). Connected circulants of 2 and 3 nodes have no counterexample: balanced \
         arrangements of 2 or 3 phases are symmetric.",
        SymmetryVariant { columns_only: false, clusters: clusters_of_column },
        examine_symmetry,
    )
    .repaired_by(Fault::False, "", |v| v.columns_only = true)
    .repaired_clauses(&[
        "On an undirected circulant graph on N >= 2 nodes, if e^{i theta} is, up to a common rotation and a positive factor, a column m of \
         the Fourier matrix F other than the first, then the phasors form the symmetric pattern of N/gcd(N, m - 1) clusters.",
        "Other eigenvectors e^{i theta}, for a repeated eigenvalue, need not be symmetric patterns.",
    ])
    .altered("N clusters in every column", |v| v.clusters = |nodes, _| nodes)
    .altered("gcd(N, m - 1) clusters", |v| v.clusters = |nodes, m| nodes.gcd(&m))
}

fn examine_symmetry(variant: &SymmetryVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const ASYMMETRIC: &str = "an eigenvector that is not symmetric";
    let asymmetric = asymmetric_eigenvector(run)?;
    if !variant.columns_only {
        let evidence = exact(ASYMMETRIC, "exact products");
        return Ok(match asymmetric {
            Some((place, seen)) => {
                let text = format!("{place}: an eigenvector, but no symmetric pattern");
                Outcome::fails(Counterexample::new(text, [seen]), evidence)
            }
            None => Outcome::Undecided("no eigenvector among few phases decides".to_string()),
        });
    }
    let most = run.cases(6, 8);
    let cases = (2..=most)
        .flat_map(|order| WeightedGraph::circulants(order, true))
        .flat_map(|(offsets, graph)| (1..graph.order()).map(move |m| (offsets.clone(), graph.clone(), m)));
    let detail = format!("all columns on all undirected circulants of 2 to {most} nodes");
    let evidence = exhaustive("columns of F are symmetric patterns", detail).on([1]);
    let columns = run.every(evidence, cases, |(offsets, graph, m)| {
        let z = fourier_column(&CosineField::new(graph.order() as u32), graph.order(), m);
        let (found, expected) = (clusters_of_pattern(&z), Some((variant.clusters)(graph.order(), m) as u32));
        let wrong = !is_eigenvector(&laplacian(&graph)?, &z) || found != expected;
        let place = || format!("N = {}, offsets {offsets:?}, column {}", graph.order(), m + 1);
        Ok(wrong.then(|| format!("{}: clusters {found:?}, claimed {expected:?}", place())))
    });
    let Some((place, _)) = asymmetric else {
        return Ok(Outcome::Undecided("no asymmetric eigenvector was found".to_string()));
    };
    let asymmetric = exact(ASYMMETRIC, place).on([2]).for_all();
    Run::all([columns, holds(asymmetric)])
}

/// An eigenvector of a connected circulant Laplacian with entries of modulus one that is no symmetric pattern, among phases at multiples of 1/12
/// turn on up to four nodes.
fn asymmetric_eigenvector(run: &Run) -> Result<Option<(String, Witness)>, CheckError> {
    const PARTS: usize = 12;
    let field = CosineField::new(PARTS as u32);
    for order in 2..=4 {
        for (offsets, graph) in WeightedGraph::circulants(order, true).filter(|(_, g)| g.is_strongly_connected()) {
            let laplacian = laplacian(&graph)?;
            for exponents in up_to_rotation(order, PARTS) {
                run.checkpoint()?;
                let z = exact_phasors(&field, &exponents);
                if is_eigenvector(&laplacian, &z) && clusters_of_pattern(&z).is_none() {
                    let place = in_turns(&exponents, PARTS);
                    let place = format!("circulant with N = {order} and offsets {offsets:?}, {place}");
                    return Ok(Some((place, turns(&exponents, PARTS))));
                }
            }
        }
    }
    Ok(None)
}

/// The rank of the conditions on `c = a conj(b)` and `r` under which `a w^(mk) + b w^(-mk)` has the same modulus for all `k`:
/// `2 Re(c w^(2mk)) = r`. Exact; the rank of the Gram matrix.
fn rank_of_conditions(field: &CosineField, nodes: usize, m: usize) -> Result<usize, CheckError> {
    let one = field.cos(0);
    let rows: Vec<[RealCyclotomic; 3]> = (0..nodes)
        .map(|k| {
            let z = field.phasor((2 * m * k % nodes) as i64);
            [z.re, -z.im, -one.clone()]
        })
        .collect();
    let entry = |i: usize, j: usize| rows.iter().fold(one.zero(), |sum, row| sum + row[i].clone() * &row[j]);
    let gram: Vec<Vec<RealCyclotomic>> = (0..3).map(|i| (0..3).map(|j| entry(i, j)).collect()).collect();
    Ok(inertia(&gram)?.positive)
}

/// `(u, v, -u, -v)` repeated.
fn rhombi(nodes: usize) -> Result<Vec<Vec<Complex<Rational>>>, CheckError> {
    let parameters = [(1, 2), (-3, 1), (2, 7), (1, 1), (5, 3)];
    let vector = |&(p, q): &(i64, i64)| {
        let (u, v) = (phasor(&rational(0, 1))?, phasor(&rational(p, q))?);
        let four = [u.clone(), v.clone(), -u, -v];
        Ok((0..nodes).map(|k| four[k % 4].clone()).collect())
    };
    parameters.iter().map(vector).collect()
}

/// The eigenvectors with entries of modulus one on `C_N`, up to rotation: the columns of `F`, and rhombi where it says so.
#[derive(Clone, Copy)]
pub struct CyclicVariant {
    /// Columns `m < N/2`, counted from 0, whose eigenvalue is claimed to have more eigenvectors of modulus one: rhombi.
    pub rhombi: fn(nodes: usize, m: usize) -> bool,
    /// How many clusters column `m` has.
    pub clusters: fn(nodes: usize, m: usize) -> usize,
}

impl CyclicVariant {
    /// Where `4 m = N`, and nowhere else.
    pub const CLASSIFICATION: Self = CyclicVariant { rhombi: |nodes, m| 4 * m == nodes, clusters: clusters_of_column };

    /// Where the classification fails on `C_N`, if it does.
    pub fn fails_on(&self, nodes: usize) -> Result<Option<String>, CheckError> {
        let field = CosineField::new(nodes as u32);
        let graph = WeightedGraph::from(&Graph::ring(nodes));
        let laplacian = laplacian(&graph)?;
        for m in 0..nodes {
            let z = fourier_column(&field, nodes, m);
            if !is_eigenvector(&laplacian, &z) || !all_zero(&misalignment(&laplacian, &z)) {
                return Ok(Some(format!("column {} is no stationary eigenvector", m + 1)));
            }
            if clusters_of_pattern(&z) != Some((self.clusters)(nodes, m) as u32) {
                return Ok(Some(format!("column {} has {:?} clusters", m + 1, clusters_of_pattern(&z))));
            }
        }
        // Eigenvalues 2 - 2 cos(2 pi m/N) increase with m <= N/2: the eigenspaces are those of the pairs m, N - m.
        if (0..nodes / 2).any(|m| (field.cos(m as i64) - field.cos(m as i64 + 1)).sign() != Some(Sign::Positive)) {
            return Ok(Some("two eigenvalues are equal".to_string()));
        }
        for m in (1..nodes).filter(|m| 2 * m < nodes) {
            // Rank 3: c = 0, one of the two columns. Rank 2: a line of c, two free phases.
            let more = rank_of_conditions(&field, nodes, m)? < 3;
            if more == (self.rhombi)(nodes, m) {
                continue;
            }
            if !more {
                return Ok(Some(format!("the eigenvalue of column {} has the columns only", m + 1)));
            }
            for z in rhombi(nodes)? {
                if is_doubled(&laplacian, &z) && clusters_of_pattern(&z).is_none() {
                    let (u, v) = (&z[0], &z[1]);
                    return Ok(Some(format!(
                        "(u, v, -u, -v, ...) with u = {} + {} i, v = {} + {} i is an eigenvector with eigenvalue 2 and no symmetric pattern",
                        u.re, u.im, v.re, v.im
                    )));
                }
            }
            return Ok(Some(format!("the eigenvalue of column {} has other eigenvectors", m + 1)));
        }
        self.rhombi_fail_on(nodes, &laplacian)
    }

    /// Whether the claimed rhombi are eigenvectors, all of them because of two that span them, and stationary.
    fn rhombi_fail_on(&self, nodes: usize, laplacian: &SparseMatrix) -> Result<Option<String>, CheckError> {
        if !(1..nodes.div_ceil(2)).any(|m| (self.rhombi)(nodes, m)) {
            return Ok(None);
        }
        let basis =
            |place: usize| (0..nodes).map(|k| Complex::real(rational([1, 0, -1, 0][(k + place) % 4], 1))).collect();
        let spanned: [Vec<Complex<Rational>>; 2] = [basis(0), basis(3)];
        if !spanned.iter().all(|x| is_doubled(laplacian, x)) {
            return Ok(Some("a rhombus is no eigenvector with eigenvalue 2".to_string()));
        }
        let rhombi = rhombi(nodes)?;
        let is_spanned = |z: &Vec<Complex<Rational>>| {
            let combined = |k: usize| z[0].scale(&spanned[0][k].re) + z[1].scale(&spanned[1][k].re);
            (0..nodes).all(|k| z[k] == combined(k))
        };
        if !rhombi.iter().all(is_spanned) {
            return Ok(Some("two rhombi do not span all of them".to_string()));
        }
        if rhombi.iter().all(|z| clusters_of_pattern(z).is_some()) {
            return Ok(Some("every rhombus is a symmetric pattern".to_string()));
        }
        let moving = rhombi.iter().any(|z| !all_zero(&misalignment(laplacian, z)));
        Ok(moving.then(|| "a rhombus is not stationary".to_string()))
    }
}

/// Whether `L x = 2 x`.
fn is_doubled(laplacian: &SparseMatrix, x: &[Complex<Rational>]) -> bool {
    laplacian_rows(laplacian, x).into_iter().zip(x).all(|(lx, x)| lx == x.scale(&rational(2, 1)))
}

pub fn cyclic_eigenvectors() -> Record<CyclicVariant> {
    let right = CyclicVariant::CLASSIFICATION;
    Record::new(
        "paley.fig2.caption",
        "Stationary: yes (paley.eq16.eigvec). The eigenvalues 2 - 2 cos(2 pi m/12), 0 < m < 6, are double, with eigenvectors a w^(mk) + b w^(-mk). Their moduli \
         squared are |a|^2 + |b|^2 + 2 Re(a conj(b) w^(2mk)), the same for all k exactly if a = 0 or b = 0, or if w^(2m) = -1 and a conj(b) is imaginary: m = 3, \
         eigenvalue 2, the rhombi (u, v, -u, -v) three times over, with any phases of u and v. They are symmetric patterns only if v = ±u or v = ±iu.",
        CyclicVariant { rhombi: |_, _| false, ..right },
        |variant, run| {
            run.checkpoint()?;
            let part = "all eigenvectors of C_12 with entries of modulus one";
            if let Some(what) = variant.fails_on(12)? {
                return Ok(Outcome::fails(format!("C_12: {what}"), exact(part, "exact products").on([2])));
            }
            let detail = "exact rank of the conditions of equal modulus in each of the five double eigenspaces; all twelve columns; two rhombi that \
                          span all of them";
            let found = exact(part, detail).on([1, 2, 3, 4]).cases(12);
            Run::all([
                holds(found).checks("steps E1 and E3 to E5"),
                argued(&[2, 3, 4], part, "notes/paley_phases.md, steps E1-E5"),
            ])
        },
    )
    .clauses(&[
        "For C_12, if e^{i theta} is an eigenvector of L, then theta is a stationary point of the Laplacian phase potential (12).",
        "Then theta forms a symmetric pattern on the unit circle.",
    ])
    .repaired(Fault::False, "", right)
    .repaired_clauses(&[
        "On C_12, if e^{i theta}, theta real, is an eigenvector of the Laplacian L, then theta is a stationary point of W_1.",
        "Then e^{i theta} is, up to rotation and a positive factor, a column of the Fourier matrix F or (u, v, -u, -v) three times over \
         with u, v of modulus one.",
        "Each column of F is, up to a positive factor, a symmetric pattern.",
        "Each (u, v, -u, -v) three times over with any u, v of modulus one is an eigenvector with eigenvalue 2.",
    ])
    .altered("more eigenvectors at eigenvalue 1 too", |v| v.rhombi = |n, m| 4 * m == n || 6 * m == n)
    .altered("twelve clusters in every column", |v| v.clusters = |n, m| if m == 0 { 1 } else { n })
}
