//! The ledger: claims with executable checks, verdicts, graded evidence and negative controls.
//!
//! A claim is data (the statement as printed, altered variants that must fail, a corrected variant where there is one)
//! plus one check, [`Claim::examine`], that is run on every variant alike. The verdict is computed from what the check
//! says, never written down: see [`judge()`].

mod claim;
mod correction;
mod entry;
mod judge;
mod listed;
mod proofs;
mod run;
mod runner;

pub use claim::{AnyClaim, CheckError, Claim, Control, Fault, Outcome, Repair, Source};
pub use correction::correction_id;
pub use entry::{Controls, Entry, Evidence, Grade, Verdict, interval_value};
pub use judge::judge;
pub use listed::{Listed, Recorded, listed, recorded};
pub use proofs::proofs_of;
pub use run::Run;
pub use runner::{Ledger, LedgerError, Options, Report, to_json};
