//! Proofs on paper: the parts of the notes that evidence of grade `argued` names.

use ledger::{Entry, Grade};

/// A part of a note.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WrittenProof {
    /// The file, such as `notes/tanner2.md`.
    pub file: String,
    /// Its section with the heading; the whole note where it is not told which one.
    pub text: &'static str,
}

/// The proofs on paper that the evidence of a claim rests on, each section once; `texts` gives notes by their paths.
pub fn written_proofs(entry: &Entry, texts: impl Fn(&str) -> Option<&'static str>) -> Vec<WrittenProof> {
    let mut found: Vec<WrittenProof> = Vec::new();
    for evidence in entry.evidence.iter().filter(|evidence| evidence.grade == Grade::Argued) {
        for (at, _) in evidence.detail.match_indices("notes/") {
            let named = &evidence.detail[at..];
            let end = named.find(".md").map_or(named.len(), |end| end + 3);
            let file = &named[..end];
            let Some(text) = texts(file) else { continue };
            let rest = &named[end..];
            let rest = rest.find("notes/").map_or(rest, |next| &rest[..next]);
            let told = sections(text, rest);
            let leaned_on = leaned_on(text, &told, entry);
            for text in told.into_iter().chain(leaned_on) {
                let proof = WrittenProof { file: file.to_string(), text };
                if !found.contains(&proof) {
                    found.push(proof);
                }
            }
        }
    }
    found
}

/// Further sections of the page that these sections or the evidence name: `Identities, step 3`, or `the bounds above`.
fn leaned_on<'a>(text: &'a str, told: &[&'a str], entry: &Entry) -> Vec<&'a str> {
    let named = |section: &&&str| {
        let heading = heading(section);
        let (with_step, above) = (format!("{heading}, step"), format!("{} above", heading.to_lowercase()));
        let names = |words: &str| words.contains(&with_step) || words.to_lowercase().contains(&above);
        !told.contains(section)
            && (told.iter().any(|words| names(words)) || entry.evidence.iter().any(|one| names(&one.detail)))
    };
    parts(text).iter().filter(named).copied().collect()
}

/// The sections of a page.
fn parts(text: &str) -> Vec<&str> {
    let starts: Vec<usize> = text.match_indices("\n## ").map(|(at, _)| at + 1).collect();
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    starts.iter().zip(ends).map(|(&from, to)| text[from..to].trim_end()).collect()
}

/// The heading of a section without its number and what stands in brackets or after a comma.
fn heading(section: &str) -> &str {
    let heading = section[3..].lines().next().unwrap_or_default();
    let heading = heading.split(" (").next().unwrap_or(heading);
    let numbered = heading.split_once(". ").filter(|(number, _)| number.parse::<u32>().is_ok());
    numbered.map_or(heading, |(_, words)| words).split([',', ':']).next().unwrap_or(heading).trim()
}

/// The sections whose headings stand in `named`; else those with steps of the names that stand there (`steps T4-T6`); else the whole.
fn sections<'a>(text: &'a str, named: &str) -> Vec<&'a str> {
    let all = parts(text);
    let lower = named.to_lowercase();
    let by_heading = |section: &&&str| lower.contains(&heading(section).to_lowercase());
    let found: Vec<&str> = all.iter().filter(by_heading).copied().collect();
    if !found.is_empty() {
        return found;
    }
    let labels: Vec<&str> = named.split(|c: char| !c.is_alphanumeric()).filter(|word| is_label(word)).collect();
    let has = |section: &&&str| labels.iter().any(|label| section.contains(&format!("**{label}.**")));
    let found: Vec<&str> = all.iter().filter(has).copied().collect();
    if found.is_empty() { vec![text.trim_end()] } else { found }
}

/// A letter or two with a number: the name of a step.
fn is_label(word: &str) -> bool {
    let number = word.trim_start_matches(|c: char| c.is_ascii_uppercase());
    number.len() < word.len() && number.starts_with(|c: char| c.is_ascii_digit())
}
