//! A failure as a file that decides exactly this case again.

use super::summary::Failed;
use crate::VERSION;
use crate::draws::Draws;
use crate::invariants::{Checked, Invariant, Stop, Tested, decide, find};
use serde_json::{Value, json};

const SCHEMA: &str = "flockproof.replay/1";

/// One case of an invariant as its draws.
pub struct Replay {
    /// The invariant.
    pub invariant: &'static Invariant,
    /// The draws.
    pub draws: Vec<u64>,
    /// What was wrong when the file was written, and the case in words.
    pub recorded: (String, String),
}

/// How a case that was decided again compares with what its file says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Again {
    /// It fails in the same way.
    Same,
    /// It fails in another way.
    Otherwise,
    /// It does not fail any more.
    NoMore,
    /// It could not be decided.
    Undecided,
}

impl Again {
    /// One word.
    pub fn word(self) -> &'static str {
        match self {
            Again::Same => "same",
            Again::Otherwise => "otherwise",
            Again::NoMore => "no-more",
            Again::Undecided => "undecided",
        }
    }

    /// In words.
    pub fn sentence(self) -> &'static str {
        match self {
            Again::Same => "It fails again as it was recorded.",
            Again::Otherwise => "It fails again, but not as it was recorded.",
            Again::NoMore => "It does not fail any more.",
            Again::Undecided => "It cannot be decided any more whether it fails.",
        }
    }
}

/// Why a file is no replay.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ReplayError {
    /// Another file.
    #[error("it is not a replay of `fuzz`: {0}")]
    Form(&'static str),
    /// No JSON, or a key that stands twice.
    #[error("not valid JSON: {0}")]
    Json(String),
    /// Of another version, whose draws may mean something else.
    #[error("it was written by version {0}; this is {VERSION}")]
    Version(String),
    /// No such invariant.
    #[error("there is no invariant `{0}`")]
    Unknown(String),
}

impl Replay {
    /// The file of a failure.
    pub fn text(invariant: &str, failed: &Failed) -> String {
        let value = json!({
            "schema": SCHEMA, "version": VERSION, "invariant": invariant, "case": failed.case, "draws": failed.draws,
            "why": failed.why, "instance": failed.instance
        });
        format!("{value:#}\n")
    }

    /// Reads such a file.
    ///
    /// # Errors
    /// [`ReplayError`].
    pub fn read(text: &str) -> Result<Self, ReplayError> {
        let value = algebra::json::parse(text).map_err(ReplayError::Json)?;
        if value["schema"] != SCHEMA {
            return Err(ReplayError::Form("its schema is not flockproof.replay/1"));
        }
        let version = value["version"].as_str().ok_or(ReplayError::Form("there is no version"))?;
        if version != VERSION {
            return Err(ReplayError::Version(version.to_string()));
        }
        let name = value["invariant"].as_str().ok_or(ReplayError::Form("there is no invariant"))?;
        let invariant = find(name).ok_or_else(|| ReplayError::Unknown(name.to_string()))?;
        let list = value["draws"].as_array().ok_or(ReplayError::Form("there are no draws"))?;
        let draws: Option<Vec<u64>> = list.iter().map(Value::as_u64).collect();
        let draws = draws.ok_or(ReplayError::Form("a draw is not a natural number"))?;
        let said =
            |key: &str, none: &'static str| value[key].as_str().map(str::to_string).ok_or(ReplayError::Form(none));
        let recorded = (said("why", "it does not say what was wrong")?, said("instance", "there is no instance")?);
        Ok(Replay { invariant, draws, recorded })
    }

    /// Decides the case.
    pub fn decide(&self) -> Checked {
        decide(self.invariant, &mut Draws::given(&self.draws), Tested::AsItIs)
    }

    /// Compares what was found now with what was recorded.
    pub fn compared(&self, checked: &Checked) -> Again {
        match checked {
            Ok(_) => Again::NoMore,
            Err(Stop::Undecided(_)) => Again::Undecided,
            Err(Stop::Fails { why, instance }) if (why, instance) == (&self.recorded.0, &self.recorded.1) => {
                Again::Same
            }
            Err(Stop::Fails { .. }) => Again::Otherwise,
        }
    }
}
