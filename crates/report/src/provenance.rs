//! Where a document comes from: its schema, the version of the program, the seed, the configuration and its digest.

use super::file::File;
use ledger::Options;
use proofs::kernel;
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// The origin of a document. The same configuration gives the same bytes with the same version.
#[derive(Debug, Clone, PartialEq)]
pub struct Provenance {
    schema: &'static str,
    seed: Option<String>,
    configuration: Value,
}

impl Provenance {
    /// `schema` names a file of `assets/schemas/` such as `flockproof.resonance/1`; `seed` is that of what is drawn, where anything is;
    /// `configuration` is all that the document depends on, input files by name and digest.
    pub fn new(schema: &'static str, seed: Option<&str>, configuration: Value) -> Self {
        Provenance { schema, seed: seed.map(str::to_string), configuration }
    }

    /// SHA-256 of the configuration as JSON without spaces, keys in alphabetical order.
    pub fn digest(&self) -> String {
        digest(self.configuration.to_string().as_bytes())
    }

    /// The keys `schema`, `version`, `seed`, `configuration` and `digest`.
    pub fn keys(&self) -> Map<String, Value> {
        let seed = self.seed.clone().map_or(Value::Null, Value::from);
        let texts = [("schema", self.schema.into()), ("version", version().into()), ("seed", seed)];
        let rest = [("configuration", self.configuration.clone()), ("digest", self.digest().into())];
        texts.into_iter().chain(rest).map(|(key, value)| (key.to_string(), value)).collect()
    }

    /// The document with these keys in front of its own; other values than objects stay as they are.
    pub fn stamp(&self, mut document: Value) -> Value {
        if let Value::Object(object) = &mut document {
            object.extend(self.keys());
        }
        document
    }

    /// What stands in `about.txt` beside tables: where they come from, and the columns of each.
    pub fn about(&self, files: &[File]) -> String {
        let mut text = format!("{}\n", Value::Object(self.keys()));
        for file in files.iter().filter(|file| file.name.ends_with(".csv")) {
            let header = file.contents.split(|byte| *byte == b'\n').next().unwrap_or_default();
            text += &format!("{}: columns {}\n", file.name, String::from_utf8_lossy(header));
        }
        text
    }

    /// One line for a text that people read.
    pub fn line(&self) -> String {
        let seed = self.seed.as_ref().map_or(String::new(), |seed| format!(", seed {seed}"));
        format!("flockproof {}{seed}, configuration {}", version(), &self.digest()[..16])
    }
}

/// What a ledger of these papers and claims says beside its entries: the configuration, its digest, and what evidence of grade
/// kernel rests on.
pub fn ledger_origin(papers: &[String], claims: &[String], options: &Options) -> BTreeMap<String, Value> {
    let seed = &options.seed;
    let configuration =
        json!({"command": "verify", "paper": papers, "claim": claims, "full": options.full, "seed": seed});
    let provenance = Provenance::new("flockproof.ledger/2", Some(seed), configuration);
    let kernel = json!({"coq": kernel::recorded().coq, "checked": "transcript"});
    let own = provenance.keys().into_iter().filter(|(key, _)| key == "configuration" || key == "digest");
    own.chain([("kernel".to_string(), kernel)]).collect()
}

/// The version of the program.
pub fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

/// SHA-256 in hexadecimal digits.
pub fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
