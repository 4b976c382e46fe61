//! Certificates: exact results written down so that a separate program, and Coq, can check them.
//!
//! The format is in `proofs_checks/README.md`; `proofs_checks/checker` checks it and shares no code with this module.

mod coq;
mod inertia;
mod limit;
mod peak;
mod product;
mod switches;
mod text;

pub use coq::{CoqTheorem, coq_file};
pub use inertia::Inertia;
pub use limit::Limit;
pub use peak::Peak;
pub use product::Product;
pub use switches::Switches;

use algebra::matrix::MatrixError;
use models::averaging::FlockError;
use models::platoon::ResonanceError;

/// Why there is no certificate.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CertificateError {
    /// More than the checker accepts.
    #[error("a certificate holds at most {most} {what}, not {found}")]
    TooMany {
        /// What there is too much of.
        what: &'static str,
        /// The limit of the checker.
        most: u64,
        /// How many there are.
        found: u64,
    },
    /// A symmetric matrix without an LDL^T: some remainder has a zero diagonal and is not zero.
    #[error("the matrix has no factorisation L D L^T with a diagonal D, in whatever order of the pivots")]
    NoPivot,
    /// A matrix that is not symmetric.
    #[error("the matrix is not symmetric")]
    NotSymmetric,
    /// A matrix that is refused.
    #[error(transparent)]
    Matrix(#[from] MatrixError),
    /// A flock that is refused.
    #[error(transparent)]
    Flock(#[from] FlockError),
    /// Without a resonance.
    #[error(transparent)]
    Resonance(#[from] ResonanceError),
}

/// One exact result.
#[derive(Debug, Clone)]
pub enum Certificate {
    /// The ergodicity coefficient of a product.
    Product(Product),
    /// The limit of the powers of a matrix, and Gamma.
    Limit(Limit),
    /// The switches of a flock of model D.
    Switches(Switches),
    /// The signs of the eigenvalues of a symmetric matrix.
    Inertia(Inertia),
    /// The main resonance of a two-sided platoon.
    Peak(Peak),
}

impl Certificate {
    /// The word in the first line.
    pub fn kind(&self) -> &'static str {
        match self {
            Certificate::Product(_) => "product",
            Certificate::Limit(_) => "limit",
            Certificate::Switches(_) => "switches",
            Certificate::Inertia(_) => "inertia",
            Certificate::Peak(_) => "peak",
        }
    }

    /// What is certified, in words.
    pub fn claim(&self) -> String {
        match self {
            Certificate::Product(product) => product.claim(),
            Certificate::Limit(limit) => limit.claim(),
            Certificate::Switches(switches) => switches.claim(),
            Certificate::Inertia(inertia) => inertia.claim(),
            Certificate::Peak(peak) => peak.claim(),
        }
    }

    /// The file, of a result that belongs to no claim.
    pub fn text(&self) -> String {
        self.text_with("")
    }

    /// The file of this result of a claim of the ledger, which it names.
    pub fn text_for(&self, claim: &str, result: &str) -> String {
        self.text_with(&format!("for {claim} {result}\n"))
    }

    fn text_with(&self, belongs: &str) -> String {
        let body = match self {
            Certificate::Product(product) => product.body(),
            Certificate::Limit(limit) => limit.body(),
            Certificate::Switches(switches) => switches.body(),
            Certificate::Inertia(inertia) => inertia.body(),
            Certificate::Peak(peak) => peak.body(),
        };
        format!("flockproof-certificate 1 {}\nclaim {}\n{belongs}{body}end\n", self.kind(), self.claim())
    }
}

/// Refuses what the checker would refuse for its size.
fn at_most(what: &'static str, most: u64, found: usize) -> Result<(), CertificateError> {
    let found = found as u64;
    if found > most { Err(CertificateError::TooMany { what, most, found }) } else { Ok(()) }
}

/// The largest order of a matrix that the checker accepts.
const LARGEST_ORDER: u64 = 128;
