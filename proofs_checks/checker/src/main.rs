//! `flockproof-checker [--claim ID] FILE...`: exit status 0 when every certificate is right, 1 when one is refused, 2 on bad use.
#![forbid(unsafe_code)]

use flockproof_checker::{check, check_for};
use std::io::{Read, Write};
use std::path::Path;
use std::process::ExitCode;

/// One byte more than the longest certificate.
const MOST_BYTES: u64 = (4 << 20) + 1;

fn read(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    std::fs::File::open(path)?.take(MOST_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn main() -> ExitCode {
    let mut files: Vec<_> = std::env::args_os().skip(1).collect();
    let mut claim = None;
    if files.first().is_some_and(|word| word == "--claim") {
        claim = files.get(1).and_then(|id| id.to_str()).map(String::from);
        files.drain(..files.len().min(2));
        files.truncate(if claim.is_some() { files.len() } else { 0 });
    }
    if files.is_empty() {
        eprintln!("use: flockproof-checker [--claim ID] FILE...");
        return ExitCode::from(2);
    }
    let decide = |bytes: Vec<u8>| claim.as_deref().map_or_else(|| check(&bytes), |id| check_for(&bytes, id));
    let mut status = 0;
    for file in &files {
        let path = Path::new(file);
        let line = match read(path).map(decide) {
            Err(error) => {
                eprintln!("error: {}: {error}", path.display());
                status = 2;
                continue;
            }
            Ok(Ok(certified)) => format!("ok {}: {}", certified.kind, certified.claim),
            Ok(Err(refusal)) => {
                status = status.max(1);
                format!("REFUSED {}:{}: {}", path.display(), refusal.line, refusal.reason)
            }
        };
        // A reader that left cannot be told anything; the status still says it.
        let _ = writeln!(std::io::stdout(), "{line}");
    }
    ExitCode::from(status)
}
