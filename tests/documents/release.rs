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

/// What a release tries in fresh places is run here as it is written there: the wheel, the container, the conda package.
#[test]
fn commands_of_a_release_succeed() {
    let folder = super::workplace("documents-release");
    let mut count = 0;
    for file in [".github/workflows/wheels.yml", "packaging/conda/recipe.yaml", "Containerfile"] {
        for line in text(file).lines() {
            let begins = ["- flockproof ", "--rm flockproof ", "venv/bin/flockproof ", "-m flockproof "];
            let rests = begins.iter().flat_map(|begin| line.split(begin).skip(1));
            for rest in rests {
                let words: Vec<&str> = rest.split(['&', '"']).next().unwrap_or("").split_whitespace().collect();
                let output = super::run(&folder, &words);
                let error = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{file}: flockproof {}: {error}", words.join(" "));
                count += 1;
            }
        }
    }
    assert!(count >= 6, "{count}");
}

/// The recipe, the wheel and the container ask for the same as the sources do.
#[test]
fn packages_ask_for_what_the_sources_ask_for() {
    let (wheel, recipe) = (text("python/pyproject.toml"), text("packaging/conda/recipe.yaml"));
    let numpy = named(&wheel, "dependencies = [\"", "\"");
    assert!(recipe.contains(&format!("- {}", numpy.replace(">=", " >="))), "{numpy}");
    let maturin = named(&wheel, "requires = [\"", "\"");
    assert!(recipe.matches(&format!("- {}", maturin.replace("maturin", "maturin "))).count() == 2, "{maturin}");
    let license = named(&wheel, "license = \"", "\"");
    assert_eq!(named(&recipe, "license: ", "\n"), license);
    assert_eq!(named(&text("Cargo.toml"), "license = \"", "\""), license);
    for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
        assert!(recipe.contains(file) && text("Containerfile").contains(file) && !text(file).is_empty(), "{file}");
    }
    // One wheel for every Python from the oldest on, and every Python is tried.
    let oldest = named(&wheel, "requires-python = \">=", "\"");
    assert!(text("python/Cargo.toml").contains(&format!("abi3-py{}", oldest.replace('.', ""))));
    let workflow = text(".github/workflows/wheels.yml");
    assert!(workflow.contains(&format!("CIBW_BUILD: \"cp{}-*\"", oldest.replace('.', ""))));
    let variants = text("packaging/conda/variants.yaml");
    let tried = named(&workflow, "python: [", "]");
    for version in tried.split(", ").map(|version| version.trim_matches('"')) {
        assert!(variants.contains(&format!("- {version}.*")), "{version}");
    }
    assert!(tried.starts_with(&format!("\"{oldest}\"")));
    // The compiler in the container is the oldest that is promised.
    let rust = named(&text("Cargo.toml"), "rust-version = \"", "\"").to_string();
    assert!(text("Containerfile").contains(&format!("rust:{rust}-")), "{rust}");
}
