//! Standard output, and files in and out, without ever panicking.

use super::CliError;
use flockproof::campaign::store::aside;
use flockproof::report::{digest, folded};
use serde_json::{Value, json};
use std::fmt::Display;
use std::io::{self, ErrorKind, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// Prints a text for people, at most as wide as the terminal; a closed pipe ends the program quietly.
pub fn print(text: &str) -> Result<(), CliError> {
    if io::stdout().is_terminal() { print_raw(&folded(text, width())) } else { print_raw(text) }
}

/// Prints a text for people that has numbers of any length: as wide as a terminal, or 80 columns, wherever it goes.
pub fn print_folded(text: &str) -> Result<(), CliError> {
    print_raw(&folded(text, width()))
}

/// Prints a sentence to standard error, at most as wide as the terminal there.
pub fn complain(sentence: &str) {
    let sentence = &without_long_words(sentence);
    let stderr = io::stderr();
    let terminal = if stderr.is_terminal() { terminal_size::terminal_size_of(&stderr) } else { None };
    match terminal {
        Some((width, _)) => eprintln!("{}", folded(sentence, usize::from(width.0).max(LEAST))),
        None => eprintln!("{sentence}"),
    }
}

/// Words of more letters and digits are cut: nobody reads a number of thousands of digits in a sentence.
const LONGEST_WORD: usize = 100;

/// A sentence in which long words are cut.
fn without_long_words(sentence: &str) -> String {
    let letters: Vec<char> = sentence.chars().collect();
    let words = letters.chunk_by(|a, b| a.is_alphanumeric() == b.is_alphanumeric());
    let shortened = |word: &[char]| match word.len() > LONGEST_WORD && word[0].is_alphanumeric() {
        true => word[..60].iter().chain(&['.'; 3]).collect(),
        false => word.iter().collect::<String>(),
    };
    words.map(shortened).collect()
}

/// Prints a text that programs read, as it is. Where standard output was closed before the program began (`>&-`), Rust's runtime has put /dev/null
/// in its place, which cannot be told from one that somebody gave: the text is lost without a word, as in all programs of Rust.
pub fn print_raw(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => CliError::ClosedOutput,
        _ => CliError::Use(format!("standard output: {}", sentence(&error))),
    })
}

/// Prints a JSON document.
pub fn print_json(document: &serde_json::Value) -> Result<(), CliError> {
    print_raw(&format!("{document:#}\n"))
}

/// What went wrong with a file, without the words and numbers of the operating system where there are better ones.
pub fn sentence(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "there is no such file or folder".to_string(),
        ErrorKind::PermissionDenied => "access is denied".to_string(),
        ErrorKind::AlreadyExists => "a file of that name is in the way".to_string(),
        ErrorKind::IsADirectory => "it is a folder, not a file".to_string(),
        ErrorKind::NotADirectory => "a part of the path is a file, not a folder".to_string(),
        ErrorKind::StorageFull => "there is no space left".to_string(),
        ErrorKind::ReadOnlyFilesystem => "nothing can be written there: it is read-only".to_string(),
        ErrorKind::InvalidFilename => {
            "the name is not possible: too long, or with letters that are not allowed".to_string()
        }
        _ => error.to_string().split(" (os error").next().unwrap_or_default().to_lowercase(),
    }
}

/// A message of a library in which the words of the operating system become a sentence.
pub fn without_system_words(message: &str) -> String {
    let mut text = message.to_string();
    while let Some((_, rest)) = text.split_once(" (os error ") {
        let Some(error) = rest.split(')').next().and_then(|code| code.parse().ok()).map(io::Error::from_raw_os_error)
        else {
            break;
        };
        let changed = text.replace(&error.to_string(), &sentence(&error));
        if changed == text {
            break;
        }
        text = changed;
    }
    text
}

/// Refuses a file about which the operating system complains.
fn refused(path: &Path) -> impl Fn(io::Error) -> CliError + '_ {
    move |error| CliError::file(path, sentence(&error))
}

/// Writes a new file of a name of its own beside another, which it leaves there.
fn written_aside(path: &Path, contents: &[u8]) -> io::Result<PathBuf> {
    let aside = aside(path);
    let written = std::fs::File::create_new(&aside).and_then(|mut file| file.write_all(contents));
    if written.is_err() {
        let _ = std::fs::remove_file(&aside);
    }
    written.map(|()| aside)
}

/// Whether a file can be written there, without leaving one.
fn probe(path: &Path) -> io::Result<()> {
    written_aside(path, b"").and_then(std::fs::remove_file)
}

/// Refuses a file that cannot be written, before any work is done for it; nothing is left there.
pub fn check_writable(path: &Path) -> Result<(), CliError> {
    if path == Path::new("-") {
        return Err(CliError::file(path, "standard output is no file here; a file of that name would be ./-"));
    }
    if path.is_dir() {
        return Err(CliError::file(path, "it is a folder, not a file"));
    }
    // Devices and pipes are written in place.
    if path.exists() && !path.is_file() {
        return Ok(());
    }
    if path.is_file() {
        std::fs::OpenOptions::new().append(true).open(path).map_err(refused(path))?;
    }
    probe(path).map_err(refused(path))
}

/// Makes a folder for files, where it is missing, and refuses one in which none can be written.
pub fn make_folder(path: &Path) -> Result<(), CliError> {
    std::fs::create_dir_all(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => CliError::file(path, "the folder cannot be made there"),
        _ => refused(path)(error),
    })?;
    probe(&path.join(".flockproof")).map_err(refused(path))
}

/// Writes a whole file: first beside it, then in its place, so that an interrupted run leaves no half file.
pub fn write_file(path: &Path, contents: &[u8]) -> Result<(), CliError> {
    // Devices and pipes cannot be replaced.
    if path.exists() && !path.is_file() {
        return std::fs::write(path, contents).map_err(refused(path));
    }
    let aside = written_aside(path, contents).map_err(refused(path))?;
    std::fs::rename(&aside, path).map_err(|error| {
        let _ = std::fs::remove_file(&aside);
        refused(path)(error)
    })
}

/// A file that was read.
pub struct Input {
    /// What stands in it, without a byte-order mark.
    pub text: String,
    /// The name without the folder, so that the same file gives the same output wherever it is, and SHA-256 of its bytes.
    pub origin: Value,
}

/// Reads a whole text file of at most 64 MiB, `-` from standard input.
pub fn read_input(path: &Path) -> Result<Input, CliError> {
    text(path, read_bytes(path)?)
}

/// The bytes of a file, and its name with their digest.
pub fn read_bytes(path: &Path) -> Result<(Vec<u8>, Value), CliError> {
    static READ: AtomicBool = AtomicBool::new(false);
    let is_stdin = path == Path::new("-");
    if is_stdin && READ.swap(true, Ordering::Relaxed) {
        return Err(CliError::file(path, "standard input can be read only once"));
    }
    let bytes = if is_stdin { limited(io::stdin()) } else { std::fs::File::open(path).and_then(limited) };
    let bytes = bytes.map_err(refused(path))?;
    if bytes.len() as u64 > LARGEST {
        return Err(CliError::file(path, "files of more than 64 MiB are not read"));
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let origin = json!({"name": name, "sha256": digest(&bytes)});
    Ok((bytes, origin))
}

/// The text of a file that was read.
pub fn text(path: &Path, (bytes, origin): (Vec<u8>, Value)) -> Result<Input, CliError> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(CliError::file(path, "it is not a text file in UTF-8 but in UTF-16"));
    }
    let text = String::from_utf8(bytes).map_err(|_| CliError::file(path, "it is not a text file (UTF-8)"))?;
    let text = text.strip_prefix('\u{feff}').map(str::to_string).unwrap_or(text);
    Ok(Input { text, origin })
}

/// The texts of files that lie beside a file.
pub fn beside(path: &Path) -> impl Fn(&str) -> Result<String, String> {
    let folder = path.parent().map_or_else(PathBuf::new, Path::to_path_buf);
    move |name| read_input(&folder.join(name)).map(|input| input.text).map_err(|error| error.to_string())
}

const LARGEST: u64 = 64 << 20;

/// At most one byte more than the limit. Not the size that the file system tells: a device has none and no end.
fn limited(input: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(LARGEST + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Where a terminal is narrower, no table can be read.
const LEAST: usize = 40;

/// Width of the terminal; 80 where standard output is none.
pub fn width() -> usize {
    let stdout = io::stdout();
    let terminal = if stdout.is_terminal() { terminal_size::terminal_size_of(stdout) } else { None };
    terminal.map_or(80, |(width, _)| usize::from(width.0).max(LEAST))
}

/// A number of things: `1 follower`, `2 followers`; with `es` for those that end in `ch`.
pub fn counted(count: impl TryInto<u128> + Display + Copy, thing: &str) -> String {
    let plural = match count.try_into() {
        Ok(1) => "",
        _ if thing.ends_with("ch") => "es",
        _ => "s",
    };
    format!("{count} {thing}{plural}")
}
