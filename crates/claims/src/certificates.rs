//! Results of the ledger that are written as certificates.

use algebra::graph::Graph;
use algebra::matrix::{RationalMatrix, StochasticMatrix};
use arithmetic::{Rational, rational};
use models::averaging::{Hysteresis, Start, Weights, transition_matrix};
use models::platoon::Gains;
use proofs::certificates::{Certificate, CertificateError, Inertia, Limit, Peak, Product, Switches};

/// A certificate of the ledger.
pub struct LedgerCertificate {
    /// The claim that it belongs to.
    pub claim: &'static str,
    /// Which result of that claim.
    pub result: &'static str,
    make: fn() -> Result<Certificate, CertificateError>,
}

impl LedgerCertificate {
    /// Computes it.
    ///
    /// # Errors
    /// [`CertificateError`]; the tests rule that out.
    pub fn make(&self) -> Result<Certificate, CertificateError> {
        (self.make)()
    }

    /// `claim.result`, the name of its file.
    pub fn name(&self) -> String {
        format!("{}.{}", self.claim, self.result)
    }
}

type Made = Result<Certificate, CertificateError>;

const fn row(claim: &'static str, result: &'static str, make: fn() -> Made) -> LedgerCertificate {
    LedgerCertificate { claim, result, make }
}

/// All of them, sorted by claim and result.
pub const LEDGER: [LedgerCertificate; 18] = [
    row("chazelle.ex4birds.alt", "to_64", || four_birds(Hysteresis::None, 64)),
    row("chazelle.exAB", "60_factors", worked_product),
    row("chazelle.hyst", "four_birds_to_330", || four_birds(Hysteresis::Paper, 330)),
    row("chazelle.hyst", "held_beyond_1", drifting_birds),
    row("chazelle.lem3.3", "one_edge", || limit(Graph::path(2), Weights::Given(vec![rational(1, 5), rational(2, 3)]))),
    row("chazelle.lem3.3", "path_4_lazy", || limit(Graph::path(4), Weights::Lazy)),
    row("chazelle.lem3.3", "ring_6_uneven", || limit(Graph::ring(6), Weights::uneven(&Graph::ring(6)))),
    row("chazelle.lem3.3", "star_5_vicsek", || limit(Graph::star(5), Weights::Vicsek)),
    row("chazelle.tau1", "four_birds_16_factors", four_birds_product),
    row("paley.thm1.saddle", "four_and_two", || hessian(&[1, 1, 1, 1, -1, -1])),
    row("paley.thm1.saddle", "three_and_one", || hessian(&[1, 1, 1, -1])),
    row("tanner1.L", "ring_5_and_path_3", two_components),
    row("tanner2.L", "path_6", || Ok(Certificate::Inertia(Inertia::new(&Graph::path(6).laplacian()?)?))),
    row("veerman.table1_numeric", "M_16", || peak(16)),
    row("veerman.table1_numeric", "M_32", || peak(32)),
    row("veerman.table1_numeric", "M_4", || peak(4)),
    row("veerman.table1_numeric", "M_64", || peak(64)),
    row("veerman.table1_numeric", "M_8", || peak(8)),
];

/// The flock of section 3, Soundness of Hysteresis Rule.
fn four_birds(hysteresis: Hysteresis, until: u64) -> Made {
    Ok(Certificate::Switches(Switches::new(&Start::four_birds(hysteresis), until)?))
}

/// Two birds in the plane that start at distance 1 and part by less than the threshold, until their speeds agree.
fn drifting_birds() -> Made {
    let start = Start {
        positions: vec![vec![rational(0, 1), rational(0, 1)], vec![rational(3, 5), rational(4, 5)]],
        velocities: vec![vec![rational(0, 1), rational(1, 1)], vec![rational(1, 100), rational(1, 1)]],
        weights: Weights::Given(vec![rational(1, 4), rational(1, 8)]),
        hysteresis: Hysteresis::Constant(rational(1, 150)),
    };
    Ok(Certificate::Switches(Switches::new(&start, 40)?))
}

/// `(AB)^30` of section 2, Numerical Complexity.
fn worked_product() -> Made {
    let a = StochasticMatrix::from_integers(&[[0, 1, 0], [1, 0, 0], [0, 0, 1]], 1)?;
    let b = StochasticMatrix::from_integers(&[[0, 2, 0], [1, 0, 1], [0, 2, 0]], 2)?;
    let factors: Vec<StochasticMatrix> = (0..60).map(|k| if k % 2 == 0 { b.clone() } else { a.clone() }).collect();
    Ok(Certificate::Product(Product::new(&factors)?))
}

/// The four birds from t = 1 to t = 16: two pairs and the path in turn.
fn four_birds_product() -> Made {
    let pairs = Graph::empty(4).with_edges(&[(0, 1), (2, 3)]);
    let factor = |graph: &Graph| StochasticMatrix::try_from(&transition_matrix(graph, &Weights::Lazy)?);
    let (odd, even) = (factor(&pairs)?, factor(&Graph::path(4))?);
    let factors: Vec<StochasticMatrix> =
        (1..=16).map(|t| if t % 2 == 1 { odd.clone() } else { even.clone() }).collect();
    Ok(Certificate::Product(Product::new(&factors)?))
}

fn limit(network: Graph, weights: Weights) -> Made {
    Ok(Certificate::Limit(Limit::new(&network, &weights)?))
}

/// The Laplacian of a ring and a path beside it.
fn two_components() -> Made {
    let edges = [(0, 1), (1, 2), (2, 3), (3, 4), (0, 4), (5, 6), (6, 7)];
    Ok(Certificate::Inertia(Inertia::new(&Graph::empty(8).with_edges(&edges).laplacian()?)?))
}

/// The Hessian of `U_1 = |sum_k e^(i theta_k)|²/(2 N)` where every `e^(i theta_k)` is 1 or -1.
fn hessian(signs: &[i64]) -> Made {
    let (order, sum) = (signs.len() as i64, signs.iter().sum::<i64>());
    let entry = |k: usize, j: usize| if k == j { 1 - signs[k] * sum } else { signs[k] * signs[j] };
    let rows: Vec<Vec<Rational>> =
        (0..signs.len()).map(|k| (0..signs.len()).map(|j| rational(entry(k, j), order)).collect()).collect();
    Ok(Certificate::Inertia(Inertia::new(&RationalMatrix::from_rows(&rows)?)?))
}

/// The platoons of Table 1, whose first column is the number of followers (`notes/veerman.md`).
fn peak(followers: u64) -> Made {
    Ok(Certificate::Peak(Peak::new(&Gains { f: rational(-1, 1), g: rational(-1, 1) }, followers)?))
}
