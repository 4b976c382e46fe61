//! Exact matrices, graphs, and spectra with enclosures.
//!
//! The spectrum of the Laplacian of a ring of four vertices, 0, 2, 2, 4:
//!
//! ```
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_algebra::graph::{LaplacianKind, NamedGraph};
//! use flockproof_algebra::spectrum::named_spectrum;
//! use flockproof_arithmetic::rational;
//!
//! let ring: NamedGraph = "ring:4".parse().unwrap();
//! let found = named_spectrum(&ring, LaplacianKind::Combinatorial, None).unwrap();
//! let parts: Vec<_> = found.eigenvalues.iter().map(|part| (part.exact.clone(), part.multiplicity)).collect();
//! assert_eq!(parts, [(0, 1), (2, 2), (4, 1)].map(|(value, times)| (Some(rational(value, 1)), times)));
//! assert!("ring:four".parse::<NamedGraph>().is_err());
//! ```

/// Crates that stand in signatures.
pub use dense::faer;
pub use num_bigint;

pub mod graph;
pub mod json;
pub mod matrix;
pub mod spectrum;
