//! One version in all places that name it, and a changelog that has it.

use super::page::root;

fn text(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// What stands between two texts, the first of which begins a line but for spaces.
fn named<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let rest = text.lines().find_map(|line| line.trim_start().strip_prefix(before));
    rest.and_then(|rest| rest.split(after).next()).unwrap_or_else(|| panic!("there is no `{before}`"))
}

#[test]
fn there_is_one_version() {
    let version = env!("CARGO_PKG_VERSION");
    let quote = "\"";
    for (file, before, after) in [
        ("Cargo.toml", "version = \"", quote),
        ("CITATION.cff", "version: ", "\n"),
        ("codemeta.json", "\"version\": \"", quote),
        (".zenodo.json", "\"version\": \"", quote),
        ("packaging/conda/recipe.yaml", "version: \"", quote),
    ] {
        assert_eq!(named(&text(file), before, after), version, "{file}");
    }
    // What the crates ask of each other.
    let manifest = text("Cargo.toml");
    let own =
        manifest.lines().filter(|line| line.contains("path = \"crates/") || line.contains("path = \"proofs_checks"));
    let asked: Vec<&str> = own.filter(|line| line.contains("version = ")).collect();
    assert!(asked.len() > 10);
    assert!(asked.iter().all(|line| line.contains(&format!("version = \"{version}\""))), "{asked:#?}");
}

#[test]
fn the_changelog_has_the_version() {
    let changelog = text("CHANGELOG.md");
    let heads: Vec<&str> = changelog.lines().filter_map(|line| line.strip_prefix("## ")).collect();
    assert_eq!(heads.first(), Some(&"[Unreleased]"));
    assert!(heads.iter().any(|head| head.starts_with(&format!("[{}] - ", env!("CARGO_PKG_VERSION")))), "{heads:?}");
}

#[test]
fn documents_that_machines_read_can_be_read() {
    for name in ["codemeta.json", ".zenodo.json"] {
        let document: serde_json::Value =
            serde_json::from_str(&text(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(document.is_object(), "{name}");
    }
}
