//! Checks certificates of flockproof; shares no code with it. `proofs_checks/README.md` in the repository of flockproof states the format and what is checked.
//!
//! All arithmetic is on integers. The work on a file is bounded before it is done, and the sentence of the `claim` line is
//! composed again from the numbers that were checked: a certificate cannot say more than it shows.
//!
//! ```
//! use flockproof_checker::check;
//!
//! let certificate = "flockproof-certificate 1 inertia
//! claim the symmetric matrix A below has 1 positive, 1 negative and 0 zero eigenvalues, counted with multiplicity
//! order 2
//! A over 1
//! 0 1
//! 1 2
//! pivots 2 1
//! L over 2
//! 2 0
//! 1 2
//! D over 2
//! 4 -1
//! end
//! ";
//! assert_eq!(check(certificate.as_bytes()).unwrap().kind, "inertia");
//! // Another sign in D, or another claim, is refused.
//! assert!(check(certificate.replace("4 -1", "4 1").as_bytes()).is_err());
//! assert!(check(certificate.replace("1 positive", "2 positive").as_bytes()).is_err());
//! ```
#![warn(missing_docs)]
#![forbid(unsafe_code)]

mod bound;
mod budget;
mod flock;
mod inertia;
mod kept;
mod limit;
mod matrix;
mod motion;
mod peak;
mod product;
mod read;
mod sos;
mod statement;
mod switching;
mod system;

use read::Reader;

/// A certificate that was checked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certified {
    /// Its kind.
    pub kind: &'static str,
    /// What is certified, in words.
    pub claim: String,
    /// The claim of the ledger that it belongs to, and which result of it; nothing where the file names none.
    pub belongs: Option<(String, String)>,
}

/// Why a certificate is refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The line at fault, from 1.
    pub line: usize,
    /// What is wrong.
    pub reason: String,
}

/// A certificate that is right, with where it stands: the limit of one pair of birds.
pub const EXAMPLE: (&str, &str) = (
    "proofs_checks/checker/corpus/pass/chazelle.lem3.3.one_edge.cert",
    include_str!("../corpus/pass/chazelle.lem3.3.one_edge.cert"),
);

type Check = fn(&mut Reader) -> Result<String, Refusal>;

const KINDS: [(&str, Check); 9] = [
    ("product", product::check),
    ("limit", limit::check),
    ("switches", flock::check),
    ("inertia", inertia::check),
    ("peak", peak::check),
    ("sos", sos::check),
    ("motion", motion::check),
    ("bound", bound::check),
    ("kept", kept::check),
];

/// Checks one certificate.
///
/// # Errors
/// [`Refusal`]: the file is malformed, too large, or what it says is not so.
pub fn check(bytes: &[u8]) -> Result<Certified, Refusal> {
    check_within(bytes, budget::MOST_WORK)
}

/// As [`check`] within so many products of 64-bit words.
///
/// # Errors
/// As there, and where the bound is not enough.
pub fn check_within(bytes: &[u8], work: u64) -> Result<Certified, Refusal> {
    let mut reader = Reader::new(bytes, work)?;
    let header = reader.value("flockproof-certificate")?;
    let Some(name) = header.strip_prefix("1 ") else { return Err(reader.refusal("the version is not 1")) };
    let Some(&(kind, body)) = KINDS.iter().find(|(kind, _)| *kind == name) else {
        return Err(reader.refusal("there is no such kind of certificate"));
    };
    let stated = reader.value("claim")?;
    let belongs = reader.belongs()?;
    let claim = body(&mut reader)?;
    reader.end()?;
    if stated != claim {
        return Err(Refusal { line: 2, reason: format!("what is shown is: {claim}") });
    }
    Ok(Certified { kind, claim, belongs })
}

/// As [`check`], of a certificate that is to belong to this claim of the ledger.
///
/// # Errors
/// As there, and where the file names another claim, or none.
pub fn check_for(bytes: &[u8], claim: &str) -> Result<Certified, Refusal> {
    let certified = check(bytes)?;
    let reason = match &certified.belongs {
        Some((own, _)) if own == claim => return Ok(certified),
        Some((own, _)) => format!("it belongs to {own}, not to {claim}"),
        None => format!("it names no claim that it belongs to, but {claim} is wanted"),
    };
    Err(Refusal { line: 3, reason })
}
