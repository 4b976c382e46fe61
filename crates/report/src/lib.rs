//! What people read: the table of the ledger, the list of claims, the explanation of one claim, tables and figures of the papers,
//! files and pictures of simulated scenarios.
//!
//! ```
//! # use ledger as flockproof_ledger;
//! # use claims as flockproof_claims;
//! use flockproof_ledger::Options;
//!
//! let ledger = flockproof_claims::ledger().unwrap();
//! let report = ledger.verify(&["veerman.lem2".to_string()], &Options::default(), |_| {});
//! let table = flockproof_report::verdict_table(&report.entries);
//! assert!(table.lines().any(|line| line.starts_with("veerman.lem2")));
//! ```

mod animation;
mod bode;
mod catalogue;
mod explain;
mod export;
mod figures;
mod file;
mod fold;
mod page;
mod papers;
pub mod plot;
mod provenance;
pub mod shown;
mod simulation;
mod site;
mod table;
mod tracks;
mod written;

/// Stands in signatures.
pub use serde_json;

pub use animation::animation;
pub use bode::{Curves, bode};
pub use catalogue::{Listing, Query, SCOPES, catalogue, catalogue_text, not_found, of_place};
pub use explain::{explain, explain_proofs, explanation, legend};
pub use export::{NamedArray, NamedMatrix, matrix_files, npz};
pub use figures::{FIGURES, Figure, FigureError};
pub use file::File;
pub use fold::folded;
pub use page::Page;
pub use provenance::{Provenance, digest, ledger_origin, version};
pub use shown::PatternRow;
pub use simulation::{
    events_csv, observables_csv, sample_table, simulation_arrays, simulation_pictures, simulation_summary,
    trajectory_csv,
};
pub use site::{Made, Site, SiteError, Texts};
pub use table::{summary, verdict_table};
pub use tracks::{Known, TracksReport};
pub use written::{WrittenProof, written_proofs};
