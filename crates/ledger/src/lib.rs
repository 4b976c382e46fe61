//! The ledger: claims with executable checks, verdicts, graded evidence and negative controls. It knows no model and no claim.
//!
//! A claim is data (the statement as printed, altered variants that must fail, a corrected variant where there is one)
//! plus one check, that is run on every variant alike. The verdict is computed from what the check
//! says, never written down: see [`Ledger::verify`].
//!
//! ```
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_arithmetic::rational;
//! use flockproof_ledger::{Ledger, Options, Record, Verdict};
//!
//! // "The sum of the first n odd numbers is n^exponent"; a control alters the exponent.
//! let claim = Record::new("mine.odd_numbers", "(n + 1)^2 - n^2 = 2n + 1.", 2, |exponent, run| {
//!     let mut sum = rational(0, 1);
//!     run.exhaustive("the sums", "added up exactly", 1..=20, |n| {
//!         sum += rational(2 * n - 1, 1);
//!         let claimed = rational(n, 1).pow(*exponent);
//!         Ok((sum != claimed).then(|| format!("n = {n}: the sum is {sum}, not {claimed}")))
//!     })
//! })
//! .stated("school", "1 + 3 + ... + (2n - 1) = n^2 for every n up to 20.")
//! .control("the cube", 3);
//!
//! let mut ledger = Ledger::new();
//! ledger.register(claim).unwrap();
//! let report = ledger.verify(&["mine.odd_numbers".to_string()], &Options::default(), |_| {});
//! assert_eq!(report.entries[0].verdict, Verdict::Holds);
//! assert_eq!(report.entries[0].controls.refuted, 1);
//! ```

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
