//! The Coq development in `proofs_checks/coq`: which theorems close which claims, and what coqc said of them.
//!
//! The program carries the sources, the table `theorems.tsv` and the transcript that `flockproof prove` writes. A theorem
//! counts as checked only where the transcript holds the digest of its file, of everything that file needs and of the
//! audit that states it again, and where `audited.tsv` says the same of it as the table; a changed file loses its theorems until coqc has seen it,
//! a changed row until somebody has read the statement again.

mod audited;
mod definitions;
mod development;
mod evidence;
mod referee;
mod scan;
mod statements;
mod theorems;
mod transcript;
mod trust;

pub use audited::audited_rows;
pub use definitions::{Definition, definitions_of};
pub use development::{Source, digest_of, files, needed, with_digests};
pub use evidence::proofs_of;
pub use referee::{bundle, statements};
pub use scan::{Forbidden, scan};
pub use theorems::{Covers, Theorem, theorems};
pub use transcript::{AxiomSet, Transcript, recorded};
pub use trust::Development;
