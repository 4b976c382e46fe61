//! The ledger as a JSON document: what `verify --json` writes, and what is read back from it.

use super::{Entry, Options, Report};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The form of the document.
const SCHEMA: &str = "flockproof.ledger/2";

/// A ledger with its entries sorted by id.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Document<'a> {
    /// The name of the form.
    schema: Cow<'a, str>,
    /// The version of the program that ran it.
    pub version: Cow<'a, str>,
    /// The seed of everything random.
    pub seed: Cow<'a, str>,
    /// Further keys, such as the configuration that it came from; not read back.
    #[serde(flatten, skip_deserializing)]
    pub more: BTreeMap<String, serde_json::Value>,
    /// Whether the run was stopped before its end.
    #[serde(default)]
    pub interrupted: bool,
    /// The claims that were asked for and are not there.
    #[serde(default)]
    pub missing: Cow<'a, [String]>,
    /// The entries.
    pub claims: Cow<'a, [Entry]>,
}

/// Why a text is not a ledger.
#[derive(Debug, thiserror::Error)]
pub enum DocumentError {
    /// Not JSON, or a key is missing or of another type.
    #[error("it is not a ledger: {0}")]
    Json(#[from] serde_json::Error),
    /// Another form, or none of this program.
    #[error("its schema is {0}, but {SCHEMA} is wanted")]
    Schema(String),
    /// Ids name files and addresses.
    #[error("`{0}` is not the id of a claim: letters, digits, `_`, `-` and inner points only")]
    Id(String),
    /// Ids are addresses.
    #[error("the claim {0} is there twice")]
    Twice(String),
}

impl<'a> Document<'a> {
    /// The document of a run.
    pub fn new(report: &'a Report, options: &'a Options) -> Self {
        Document {
            schema: SCHEMA.into(),
            version: env!("CARGO_PKG_VERSION").into(),
            seed: options.seed.as_str().into(),
            more: BTreeMap::new(),
            interrupted: !report.missing.is_empty(),
            missing: report.missing.as_slice().into(),
            claims: report.entries.as_slice().into(),
        }
    }

    /// Reads a document; entries are sorted by id, and each id is fit for the name of a file.
    ///
    /// # Errors
    /// [`DocumentError`].
    pub fn read(text: &str) -> Result<Document<'static>, DocumentError> {
        let mut document: Document<'static> = serde_json::from_str(text)?;
        if document.schema != SCHEMA {
            return Err(DocumentError::Schema(document.schema.into_owned()));
        }
        let claims = document.claims.to_mut();
        claims.sort_by(|a, b| a.id.cmp(&b.id));
        if let Some(entry) = claims.iter().find(|entry| !is_id(&entry.id) || !is_id(&entry.paper)) {
            return Err(DocumentError::Id(entry.id.clone()));
        }
        if let Some(pair) = claims.windows(2).find(|pair| pair[0].id == pair[1].id) {
            return Err(DocumentError::Twice(pair[0].id.clone()));
        }
        Ok(document)
    }

    /// As text.
    pub fn json(&self) -> String {
        // Strings, numbers and lists only: this cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}

/// Whether an id is fit for the name of a file.
fn is_id(id: &str) -> bool {
    let good = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric() || "_-".contains(c));
    id.len() <= 120 && id.split('.').all(good)
}

/// The JSON document of a run.
pub fn to_json(report: &Report, options: &Options) -> String {
    Document::new(report, options).json()
}

/// The same with further keys beside its own, such as the configuration that it came from.
pub fn to_json_with(report: &Report, options: &Options, more: BTreeMap<String, serde_json::Value>) -> String {
    Document { more, ..Document::new(report, options) }.json()
}
