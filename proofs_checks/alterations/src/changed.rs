//! The lines of the sources that are others than in a revision.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;
use std::process::Command;

/// The crates whose sources compute something; what only shows results is not altered.
const COMPUTING: [&str; 9] =
    ["arithmetic", "polynomials", "dense", "algebra", "motion", "expressions", "models", "reach", "ledger"];

/// The lines of each file, counted from 1.
pub type Lines = BTreeMap<String, Vec<Range<usize>>>;

/// What was changed since a revision, in the sources of the crates that compute and of the checker.
pub fn lines(root: &Path, revision: &str) -> Result<Lines, String> {
    let out = Command::new("git")
        .current_dir(root)
        .args(["diff", "--unified=0", "--no-color", "--diff-filter=d", "--relative", revision, "--", "*.rs"])
        .output()
        .map_err(|error| format!("git: {error}"))?;
    if !out.status.success() {
        return Err(String::from_utf8_lossy(&out.stderr).trim().to_string());
    }
    Ok(of_diff(&String::from_utf8_lossy(&out.stdout)))
}

fn of_diff(text: &str) -> Lines {
    let mut all = Lines::new();
    let mut file = None;
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("+++ ") {
            file = name.strip_prefix("b/").filter(|name| is_altered(name)).map(String::from);
        } else if let (Some(name), Some(head)) = (&file, line.strip_prefix("@@ ")) {
            let Some(range) = head.split(' ').nth(1).and_then(range) else { continue };
            all.entry(name.clone()).or_default().push(range);
        }
    }
    all.retain(|_, ranges| ranges.iter().any(|range| !range.is_empty()));
    all
}

fn is_altered(name: &str) -> bool {
    let crate_of = name.strip_prefix("crates/").and_then(|rest| rest.split_once("/src/"));
    let computes = crate_of.is_some_and(|(name, _)| COMPUTING.contains(&name));
    (computes || name.starts_with("proofs_checks/checker/src/")) && !name.ends_with("/tests.rs")
}

/// `+12,3` as 12..15, `+12` as 12..13.
fn range(text: &str) -> Option<Range<usize>> {
    let text = text.strip_prefix('+')?;
    let (start, count) = text.split_once(',').unwrap_or((text, "1"));
    let (start, count): (usize, usize) = (start.parse().ok()?, count.parse().ok()?);
    Some(start..start + count)
}

/// Whether a line of a file was changed.
pub fn holds(lines: &Lines, file: &str, line: usize) -> bool {
    lines.get(file).is_some_and(|ranges| ranges.iter().any(|range| range.contains(&line)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_lines_are_read_from_a_diff() {
        let text = "--- a/crates/motion/src/a.rs\n+++ b/crates/motion/src/a.rs\n@@ -3,0 +4,2 @@ fn f\n+x\n+y\n@@ -9 +11 @@\n-a\n+b\n\
                    --- a/crates/report/src/b.rs\n+++ b/crates/report/src/b.rs\n@@ -1 +1 @@\n-a\n+b\n\
                    --- a/crates/motion/src/c.rs\n+++ b/crates/motion/src/c.rs\n@@ -1,2 +0,0 @@\n-a\n-b\n";
        let lines = of_diff(text);
        assert_eq!(lines.keys().collect::<Vec<_>>(), ["crates/motion/src/a.rs"]);
        let changed: Vec<usize> = (1..20).filter(|&k| holds(&lines, "crates/motion/src/a.rs", k)).collect();
        assert_eq!(changed, [4, 5, 11]);
    }
}
