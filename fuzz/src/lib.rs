//! What every target does: the reader of its name reads the bytes, and a refusal is one line.

use campaign::invariants::READERS;

/// Reads bytes with a reader of [`READERS`].
///
/// # Panics
/// Where the reader does, where it refuses in several lines, and for a name that there is not: these are what is looked for.
pub fn read(name: &str, bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let reader = READERS.iter().find(|(known, _)| *known == name);
    let (_, read) = reader.expect("a reader of this name");
    if let Err(said) = read(text) {
        assert!(!said.contains('\n'), "refused in several lines: {said}");
    }
}
