//! The ledger: claims with executable checks, verdicts, graded evidence and negative controls. It knows no model and no claim.
//!
//! A claim is data (the statement as printed, altered variants that must fail, a corrected variant where there is one)
//! plus one check, that is run on every variant alike. The verdict is computed from what the check
//! says, never written down: see [`Ledger::verify`].

mod claim;
mod clauses;
mod document;
mod entry;
mod evidence;
mod judge;
mod lines;
mod outcome;
mod proofs;
mod record;
mod run;
mod runner;
mod tables;
mod verdict;
mod witness;

pub use claim::{Claim, Correction, Form, Source};
pub use document::{Document, DocumentError, to_json, to_json_with};
pub use entry::{Controls, Entry, exact_value, interval_value};
pub use evidence::{Evidence, Grade, Scope};
pub use judge::correction_id;
pub use outcome::{CheckError, Outcome};
pub use proofs::Proofs;
pub use record::Record;
pub use run::Run;
pub use runner::{Ledger, LedgerError, Options, Report, is_of_paper, recorded_row};
pub use tables::{Listed, Recorded, listed, recorded};
pub use verdict::{Fault, Verdict};
pub use witness::{Counterexample, Link, Number, Point, Witness};

/// The generator of [`Run::random`] stands in its signature.
pub use rand_chacha;
