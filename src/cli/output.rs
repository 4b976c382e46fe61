//! Writing to standard output and to files without ever panicking.

use super::CliError;
use std::io::{ErrorKind, Read, Write};
use std::path::Path;

/// Prints a text; a closed pipe ends the program quietly.
pub fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => CliError::ClosedOutput,
        _ => CliError::Use(format!("standard output: {error}")),
    })
}

/// Prints a JSON document.
pub fn print_json(document: &serde_json::Value) -> Result<(), CliError> {
    print(&format!("{document:#}\n"))
}

/// Writes a whole file: first beside it, then in its place, so that an interrupted run leaves no half file.
pub fn write_file(path: &Path, contents: &[u8]) -> Result<(), CliError> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".part");
    // Devices and pipes cannot be replaced.
    if path.exists() && !path.is_file() {
        return std::fs::write(path, contents).map_err(|error| CliError::file(path, error));
    }
    std::fs::write(&beside, contents)
        .and_then(|()| std::fs::rename(&beside, path))
        .map_err(|error| CliError::file(path, error))
}

/// Reads a whole text file of at most 64 MiB.
pub fn read_text(path: &Path) -> Result<String, CliError> {
    const LARGEST: u64 = 64 << 20;
    // Not the size that the file system tells: a device has none and no end.
    let mut bytes = Vec::new();
    std::fs::File::open(path)
        .and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes))
        .map_err(|error| CliError::file(path, error))?;
    if bytes.len() as u64 > LARGEST {
        return Err(CliError::file(path, "files of more than 64 MiB are not read"));
    }
    String::from_utf8(bytes).map_err(|_| CliError::file(path, "it is not a text file (UTF-8)"))
}

/// Width of the terminal, 80 where there is none.
pub fn width() -> usize {
    terminal_size::terminal_size().map_or(80, |(width, _)| usize::from(width.0))
}
