//! chazelle.pi and chazelle.eq3.7: eigenvalues and first eigenvectors of the transition matrix.

use super::{FAMILY, Family, Kind, Network, exhaustively};
use crate::prelude::*;
use algebra::matrix::RationalMatrix;
use arithmetic::RadicalSum;
use num_traits::{One, Signed};

/// Which networks, and the power of `C` in `pi = (tr C^k)^-1 C^k 1`.
#[derive(Clone, Copy)]
pub struct StationaryVariant {
    family: Family<'static>,
    power: i32,
    /// Whether 1 is the right and `pi` the left eigenvector, or the other way round.
    right_is_one: bool,
}

impl StationaryVariant {
    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let (ones, pi) = (vec![rational(1, 1); network.order()], network.normalised_power(self.power));
        let (right, left) = if self.right_is_one { (&ones, &pi) } else { (&pi, &ones) };
        if network.p.apply(right)? != *right {
            return Ok(Some(format!("({}) is no right eigenvector for 1", list(right))));
        }
        if network.p.transpose().apply(left)? != *left {
            return Ok(Some(format!("({}) is no left eigenvector for 1", list(left))));
        }
        let spectrum = network.p.characteristic_polynomial()?;
        let one = rational(1, 1);
        let simple = spectrum.multiplicity(&one) == 1;
        let inside = spectrum.count_above(&-one.clone()) == network.order() && spectrum.count_above(&one) == 0;
        Ok((!simple || !inside).then(|| {
            let (ones, minus) = (spectrum.multiplicity(&one), spectrum.multiplicity(&-one.clone()));
            format!("the eigenvalue 1 occurs {ones} times, -1 {minus} times")
        }))
    }
}

pub fn stationary() -> Record<StationaryVariant> {
    Record::new(
        "chazelle.pi",
        "P is taken for a connected G with c_i > 0 and c_i d_i < 1 (a single bird: P = [1]). L 1 = 0 = 1^T L gives \
         both eigenvectors, and pi^T C = const 1^T. CLf = 0 only for constant f, and P is similar to a symmetric \
         matrix, so 1 is simple. Dominant: every other eigenvalue lies in (-1, 1), because P >= a I with a = min p_ii \
         > 0 leaves a stochastic rest (notes/chazelle_fixed_network.md).",
        StationaryVariant { family: Family::PRINTED, power: -1, right_is_one: true },
        |variant, run| {
            let part = "1 is a simple dominant eigenvalue with these eigenvectors";
            let networks = variant.family.networks(run.cases(6, 7))?;
            let detail = format!(
                "{FAMILY} on up to 6 birds (7 with --full), three kinds of weights; eigenvalues counted exactly"
            );
            exhaustively(&networks, run, part, detail, |network| variant.fails_at(network)).on([1, 2, 3])
        },
    )
    .clauses(&[
        "For fixed connected G, 1 is a simple eigenvalue of P = I_n - CL.",
        "It is dominant: every other eigenvalue has a smaller modulus.",
        "It has the right and left eigenvectors 1 and pi = (tr C^{-1})^{-1} C^{-1} 1.",
    ])
    .altered("C in place of its inverse", |v| v.power = 1)
    .altered("left and right exchanged", |v| v.right_is_one = false)
    .altered("graphs that are not connected", |v| v.family = Family::ANY_GRAPH)
    .altered("c_i d_i = 1", |v| v.family = Family::WHOLE)
}

/// The half powers in `M = C^(a/2) P C^(b/2) = I - C^(e/2) L C^(e/2)`, and what is said of its eigenvalues.
#[derive(Clone, Copy)]
pub struct SymmetrisedVariant {
    family: Family<'static>,
    /// `(a, b)`.
    of_p: (i32, i32),
    /// `e`.
    of_l: i32,
    /// The lower bound of the eigenvalues.
    least: (i64, i64),
    /// Whether the entries of `u_1` are square roots of those of `pi`.
    rooted: bool,
}

/// `sign * sqrt(square)`.
type SignedRoot = (Rational, Rational);

impl SymmetrisedVariant {
    /// The entries of `C^(a/2) P C^(b/2)`.
    fn root_entry(&self, network: &Network, i: usize, j: usize) -> SignedRoot {
        let (a, b) = self.of_p;
        (network.p.entry(i, j), network.c[i].pow(a) * network.c[j].pow(b))
    }

    /// Whether `C^(a/2) P C^(b/2)` and `I - C^(e/2) L C^(e/2)` are the same symmetric matrix, entry by entry.
    fn is_symmetric_form(&self, network: &Network) -> Result<bool, CheckError> {
        let laplacian = network.graph.laplacian()?;
        let mut same = true;
        for i in 0..network.order() {
            for j in 0..network.order() {
                let root = network.c[i].pow(self.of_l) * network.c[j].pow(self.of_l);
                let diagonal = if i == j { rational(1, 1) } else { rational(0, 1) };
                same &= sum_of_roots([self.root_entry(network, i, j)])
                    == sum_of_roots([(diagonal, rational(1, 1)), (-laplacian.entry(i, j), root)]);
                same &=
                    sum_of_roots([self.root_entry(network, i, j)]) == sum_of_roots([self.root_entry(network, j, i)]);
            }
        }
        Ok(same)
    }

    /// Whether `M u_1 = u_1`, and `u_1` has length 1.
    fn fixes_u1(&self, network: &Network) -> bool {
        let pi = network.pi();
        let u = |i: usize| -> SignedRoot {
            if self.rooted { (rational(1, 1), pi[i].clone()) } else { (pi[i].clone(), rational(1, 1)) }
        };
        let term = |i: usize, j: usize| {
            let ((a, r), (b, s)) = (self.root_entry(network, i, j), u(j));
            (a * b, r * s)
        };
        let length: Rational = (0..network.order()).map(u).map(|(a, r)| &a * &a * r).sum();
        length.is_one()
            && (0..network.order())
                .all(|i| sum_of_roots((0..network.order()).map(|j| term(i, j))) == sum_of_roots([u(i)]))
    }

    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        if !self.is_symmetric_form(network)? {
            return Ok(Some("the two forms of M are not the same symmetric matrix".into()));
        }
        if !self.fixes_u1(network) {
            return Ok(Some("u_1 is no unit eigenvector of M for 1".into()));
        }
        // M has the eigenvalues of P because the half powers are inverse to each other (checked above by symmetry for
        // the printed form, and below on rational M).
        let spectrum = network.p.characteristic_polynomial()?;
        let (one, least) = (rational(1, 1), rational(self.least.0, self.least.1));
        let (largest, below) = (spectrum.multiplicity(&one), spectrum.count_below(&least));
        Ok((largest != 1 || spectrum.count_above(&one) > 0 || below > 0)
            .then(|| format!("1 is an eigenvalue {largest} times, {below} eigenvalues lie below {least}")))
    }

    /// For weights that are squares `M` is rational, and its characteristic polynomial can be compared.
    fn differs_on_squares(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let roots: Vec<Rational> = (0..network.order()).map(|i| rational(1, i as i64 + 3)).collect();
        let c: Vec<Rational> = roots.iter().map(|r| r * r).collect();
        let p = models::averaging::transition_matrix(&network.graph, &models::averaging::Weights::Given(c))?;
        let laplacian = network.graph.laplacian()?;
        let entry = |i: usize, j: usize| {
            let scaled = roots[i].pow(self.of_l) * roots[j].pow(self.of_l) * laplacian.entry(i, j);
            if i == j { rational(1, 1) - scaled } else { -scaled }
        };
        let order = network.order();
        let rows: Vec<Vec<Rational>> = (0..order).map(|i| (0..order).map(|j| entry(i, j)).collect()).collect();
        let of_m = RationalMatrix::from_rows(&rows)?.characteristic_polynomial()?;
        Ok((of_m.coefficients() != p.characteristic_polynomial()?.coefficients())
            .then(|| "with c_i = 1/(i+2)² M and P have different characteristic polynomials".to_string()))
    }
}

fn sum_of_roots(terms: impl IntoIterator<Item = SignedRoot>) -> RadicalSum {
    let mut sum = RadicalSum::default();
    for (coefficient, radicand) in terms {
        // Products of weights, which are positive.
        sum.add_root(&coefficient, &radicand.abs());
    }
    sum
}

pub fn symmetrised() -> Record<SymmetrisedVariant> {
    Record::new(
        "chazelle.eq3.7",
        "Off the diagonal c_i^-1/2 p_ij c_j^1/2 = sqrt(c_i c_j) on edges; the diagonal is that of P. M is similar to \
         P. I - M = C^1/2 L C^1/2 is positive semidefinite with kernel C^-1/2 1, of dimension 1 for a connected \
         graph: u_1. Gershgorin's discs of P lie to the right of 2 min p_ii - 1 > -1, so the printed lower bound is \
         even strict (notes/chazelle_fixed_network.md).",
        SymmetrisedVariant { family: Family::PRINTED, of_p: (-1, 1), of_l: 1, least: (-1, 1), rooted: true },
        check_symmetrised,
    )
    .clauses(&[
        "M = C^{-1/2} P C^{1/2} = I_n - C^{1/2} L C^{1/2} is symmetric.",
        "Its eigenvalues are 1 = lambda_1 > lambda_2 >= ... >= lambda_n >= -1.",
        "u_1 = (sqrt(pi_1),...,sqrt(pi_n))^T is its unit eigenvector for 1.",
        "P has the same eigenvalues.",
    ])
    .altered("M = C^1/2 P C^-1/2", |v| v.of_p = (1, -1))
    .altered("M = I - C^-1/2 L C^-1/2", |v| v.of_l = -1)
    .altered("u_1 = pi", |v| v.rooted = false)
    .altered("eigenvalues at least -1/4", |v| v.least = (-1, 4))
    .altered("graphs that are not connected", |v| v.family = Family::ANY_GRAPH)
}

fn check_symmetrised(variant: &SymmetrisedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "both forms, symmetry, u_1 and the order of the eigenvalues";
    let networks = variant.family.networks(run.cases(6, 7))?;
    let lazy: Vec<Network> = networks.iter().filter(|n| n.kind == Kind::Lazy).cloned().collect();
    let detail = format!(
        "{FAMILY} on up to 6 birds (7 with --full), three kinds of weights; square roots exact, eigenvalues counted \
         exactly"
    );
    let squares = "characteristic polynomials compared on the same graphs with weights that are squares".to_string();
    Run::all([
        exhaustively(&networks, run, part, detail, |network| variant.fails_at(network))
            .on([1, 2, 3])
            .checks("steps 1 and 2, and the bound -1 of step 3"),
        exhaustively(&lazy, run, "M and P have the same eigenvalues", squares, |network| {
            variant.differs_on_squares(network)
        })
        .on([4]),
        argued(&[2], "the order of the eigenvalues", "notes/chazelle_fixed_network.md, Spectrum, steps 1-3"),
    ])
}
