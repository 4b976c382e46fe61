//! What idtracker.ai writes beside its tables: `attributes.json`, or `attributes_tidy.json`.

use super::Form;
use serde_json::Value;

/// What such a file says of a recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attributes {
    /// The median body length, in the unit of the positions (pixels).
    pub body_length: Option<f64>,
}

impl Attributes {
    /// The name of the file that lies beside a table of this form; none where there is none.
    pub fn file(form: Form) -> Option<&'static str> {
        match form {
            Form::Wide => Some("attributes.json"),
            Form::Tidy => Some("attributes_tidy.json"),
            _ => None,
        }
    }

    /// Reads it; `None` for what is no object of JSON. A length that is not positive is none.
    pub fn read(text: &str) -> Option<Attributes> {
        let value: Value = serde_json::from_str(text).ok()?;
        let said = value.as_object()?.get("body_length").and_then(Value::as_f64);
        Some(Attributes { body_length: said.filter(|length| *length > 0.0 && length.is_finite()) })
    }
}
