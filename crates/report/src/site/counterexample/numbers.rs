//! Numbers in the sentence of a counterexample.

use arithmetic::Rational;
use std::collections::BTreeMap;
use std::str::FromStr;

/// A fraction or a decimal number, perhaps in brackets of its own.
pub(super) fn number(text: &str) -> Option<Rational> {
    let text = text.trim();
    let bare = text.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).unwrap_or(text);
    let plain = |c: char| c.is_ascii_digit() || matches!(c, '-' | '/' | '.');
    (bare.len() < 40 && bare.chars().all(plain)).then(|| Rational::from_str(bare).ok()).flatten()
}

/// Every `name = number` between commas, also `name = name = number`.
pub(super) fn assignments(part: &str) -> BTreeMap<&str, Rational> {
    let mut known = BTreeMap::new();
    for piece in part.split([',', ':']) {
        let piece = piece.rsplit_once(" at ").map_or(piece, |(_, rest)| rest);
        let mut names: Vec<&str> = piece.split(" = ").map(str::trim).collect();
        if let Some(value) = names.pop().and_then(number) {
            known.extend(names.into_iter().map(|name| (name, value.clone())));
        }
    }
    known
}
