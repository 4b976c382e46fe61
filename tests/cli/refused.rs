//! Wrong input: each gets its sentence. The table is `refused.toml`.

use super::{folder, with_input};
use std::path::Path;
use std::process::Output;
use toml::de::{DeTable, DeValue};

/// One row of the table.
struct Case {
    what: String,
    run: Vec<String>,
    says: String,
    files: Vec<(String, Vec<u8>)>,
    stdin: String,
}

fn text(value: &DeValue) -> String {
    value.as_str().expect("a text").to_string()
}

/// The bytes of a file of the table; two cannot stand in a text.
fn bytes(contents: String) -> Vec<u8> {
    match contents.as_str() {
        "@utf16" => b"\xff\xfe1\x000\x00".to_vec(),
        "@binary" => b"1 \xc3\x28\n".to_vec(),
        _ => contents.into_bytes(),
    }
}

fn cases() -> Vec<Case> {
    let table = DeTable::parse(include_str!("refused.toml")).expect("TOML");
    let rows = table.get_ref().get("case").expect("cases").get_ref().as_array().expect("a list").iter();
    rows.map(|row| {
        let row = row.get_ref().as_table().expect("a table");
        let get = |key: &str| row.get(key).map(|value| value.get_ref());
        let files = get("files").and_then(DeValue::as_table).into_iter().flatten();
        Case {
            what: text(get("what").expect("what")),
            run: text(get("run").expect("run")).split_whitespace().map(str::to_string).collect(),
            says: text(get("says").expect("says")),
            files: files.map(|(name, value)| (name.get_ref().to_string(), bytes(text(value.get_ref())))).collect(),
            stdin: get("stdin").map(text).unwrap_or_default(),
        }
    })
    .collect()
}

fn run(case: &Case, folder: &Path) -> Output {
    for (name, contents) in &case.files {
        std::fs::write(folder.join(name), contents).expect("a file");
    }
    with_input(&case.run, folder, &case.stdin)
}

#[test]
fn every_wrong_input_gets_its_sentence() {
    let mut wrong = Vec::new();
    for (k, case) in cases().iter().enumerate() {
        let folder = folder(&format!("refused/{k}"));
        let output = run(case, &folder);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let refused = output.status.code() == Some(2) && output.stdout.is_empty();
        if !refused || said.trim_end() != format!("error: {}", case.says) {
            let status = output.status.code();
            wrong.push(format!("{}: `{}`, status {status:?}, says\n  {said}", case.what, case.run.join(" ")));
        }
        // Nothing is left of what was refused: only the files that were given, and folders.
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let entry = entry.expect("an entry");
            let name = entry.file_name().to_string_lossy().into_owned();
            let given = case.files.iter().any(|(given, _)| *given == name);
            if !given && entry.path().is_file() {
                wrong.push(format!("{}: {name} was left", case.what));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_table_has_each_case_once() {
    let mut names: Vec<String> = cases().into_iter().map(|case| case.what).collect();
    assert!(names.len() > 80);
    names.sort();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]));
}
