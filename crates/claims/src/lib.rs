//! The claims of the papers and of this project with their checks, one file per group; a claim is found by searching for
//! its id.
//!
//! ```
//! # use ledger as flockproof_ledger;
//! use flockproof_ledger::Options;
//!
//! // One claim: as printed, as corrected where it needs that, and with its negative controls.
//! let ledger = flockproof_claims::ledger().unwrap();
//! let report = ledger.verify(&["veerman.lem2".to_string()], &Options::default(), |_| {});
//! let entry = &report.entries[0];
//! assert!(report.is_as_recorded());
//! assert!(entry.controls.total > 0 && entry.controls.refuted == entry.controls.total);
//! ```

/// The claims of these modules, boxed: `claims! { module: claim, claim; module: claim; }`.
macro_rules! claims {
    ($($module:ident: $($claim:ident),+;)+) => {
        vec![$($(Box::new($module::$claim()) as Box<dyn ledger::Claim>),+),+]
    };
}

mod beyond;
pub mod certificates;
mod chazelle;
mod evidence;
mod paley;
mod prelude;
mod shares;
mod tanner1;
mod tanner2;
mod veerman;

use arithmetic::{Rational, parse_rational, rational};
use ledger::{CheckError, Ledger, LedgerError};
use proofs::kernel::Development;

/// What is true instead of a printed statement that fails is a claim of its own, `beyond.paley.eq21` for `paley.eq21`; but
/// not where only the wording of the paper is corrected, or where it is a matter of long runs.
const WITHOUT_OWN_CLAIM: [&str; 4] =
    ["tanner2.appA.thm4", "tanner2.appA.thm5", "tanner2.sec6.figures", "veerman.sec7.system"];

/// What the five papers claim: id, place and statement, separated by tabs.
pub const LISTED: &str = include_str!("listed.tsv");

/// The verdicts that the ledger is expected to reach, with the grades of their evidence.
pub const RECORDED: &str = include_str!("recorded.tsv");

/// The lines of evidence that the ledger is expected to reach, with their numbers of cases; `verify --record DIR` writes both tables.
pub const EVIDENCE: &str = include_str!("evidence.tsv");

/// The ledger of every claim that is built, and of the corrections of those whose printed form fails.
///
/// # Errors
/// [`LedgerError`] where a claim is registered twice or lacks a source; the tests rule that out.
pub fn ledger() -> Result<Ledger, LedgerError> {
    ledger_with(Development::own())
}

/// The same with what another development proves.
///
/// # Errors
/// Those of [`ledger()`].
pub fn ledger_with(development: &'static Development) -> Result<Ledger, LedgerError> {
    let mut ledger =
        Ledger::new().with_list(LISTED).with_record(RECORDED).with_evidence(EVIDENCE).with_proofs(development);
    let papers = [chazelle::claims(), veerman::claims(), paley::claims(), tanner1::claims(), tanner2::claims()];
    for claim in papers.into_iter().flatten().chain(beyond::claims()) {
        ledger.register_boxed(claim)?;
    }
    ledger.register_corrections(|printed| !WITHOUT_OWN_CLAIM.contains(&printed))?;
    Ok(ledger)
}

/// The value of a printed decimal and one unit of its last place.
fn printed_decimal(printed: &str) -> Result<(Rational, Rational), CheckError> {
    let value = parse_rational(printed).map_err(|error| CheckError::Other(error.to_string()))?;
    let places = printed.split_once('.').map_or(0, |(_, after)| after.len());
    Ok((value, rational(10, 1).pow(-(places as i32))))
}
