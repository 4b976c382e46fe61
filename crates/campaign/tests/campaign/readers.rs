//! The files of the folder `fuzz/`: what the targets begin with is read, and what they once found is refused in one line.

use campaign::invariants::READERS;
use std::path::{Path, PathBuf};

fn files(folder: &str, reader: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz").join(folder).join(reader);
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.sort();
    files
}

#[test]
fn seeds_are_read() {
    for (name, read) in READERS {
        let seeds = files("seeds", name);
        assert!(!seeds.is_empty(), "there is nothing to begin with for {name}");
        for path in seeds {
            let text = std::fs::read_to_string(&path).expect("text");
            assert_eq!(read(&text), Ok(()), "{}", path.display());
        }
    }
}

#[test]
fn what_was_found_stays_mended() {
    let mut count = 0;
    for (name, read) in READERS {
        for path in files("regressions", name) {
            let bytes = std::fs::read(&path).expect("a file");
            let Ok(text) = std::str::from_utf8(&bytes) else { continue };
            let said = read(text).err().unwrap_or_default();
            assert!(!said.contains('\n') && said.len() < 2000, "{}: {said}", path.display());
            count += 1;
        }
    }
    assert!(count > 1);
}
