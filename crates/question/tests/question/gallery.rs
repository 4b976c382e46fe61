//! The laws of the gallery: each has a question whose answer is known from the literature.

use arithmetic::Unwatched;
use question::{Question, Verdict, decide};
use std::path::Path;

/// Each law with the verdict about its question.
const RECORDED: [(&str, Verdict); 21] = [
    ("boids", Verdict::Holds),
    ("circling", Verdict::Holds),
    ("couzin", Verdict::Holds),
    ("cucker_smale", Verdict::Holds),
    ("dorsogna", Verdict::Holds),
    ("fish", Verdict::Holds),
    ("heading_alignment", Verdict::Holds),
    ("hegselmann_krause", Verdict::Holds),
    ("intelligent_driver", Verdict::Undecided),
    ("jadbabaie", Verdict::Holds),
    ("kuramoto", Verdict::Holds),
    ("lazy_averaging", Verdict::Holds),
    ("moreau", Verdict::Holds),
    ("motsch_tadmor", Verdict::False),
    ("olfati_saber", Verdict::Holds),
    ("phase_model", Verdict::Holds),
    ("platoon_behind", Verdict::Holds),
    ("platoon_both_sides", Verdict::Holds),
    ("sakaguchi", Verdict::False),
    ("velocity_alignment", Verdict::Holds),
    ("vicsek", Verdict::Holds),
];

#[test]
fn every_law_has_a_question_with_its_recorded_verdict() {
    let laws = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/laws");
    let folder = laws.join("questions");
    let files = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
    let mut wrong = Vec::new();
    for (name, verdict) in RECORDED {
        let question = match Question::read(&files(&format!("{name}.toml")).expect("a question"), &files) {
            Ok(question) => question,
            Err(error) => {
                wrong.push(format!("{name}: {error}"));
                continue;
            }
        };
        let answer = match decide(&question, &Unwatched) {
            Ok(answer) => answer,
            Err(error) => {
                wrong.push(format!("{name}: {error}"));
                continue;
            }
        };
        if answer.verdict != verdict || answer.controls.is_empty() || answer.controls.contains(&false) {
            wrong.push(format!("{name}: {:?} {:?}: {}", answer.verdict, answer.controls, answer.why));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    let count = |folder: &Path| {
        let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
        entries.filter(|path| path.extension().is_some_and(|end| end == "toml")).count()
    };
    assert_eq!((count(&laws), count(&folder)), (RECORDED.len(), RECORDED.len()));
}

/// A sign, or a factor, changed in each law, and the property that is false then, where it is not the recorded one.
const FAULTS: [(&str, &str, &str); 19] = [
    ("boids", "(x - x[j])/norm2", "(x + x[j])/norm2"),
    ("circling", "1 + K0/agents", "1 - K0/agents"),
    ("couzin", "x + speed*tau", "x - speed*tau"),
    ("cucker_smale", "(v[j] - v)", "(v[j] + v)"),
    ("dorsogna", "*v - sum(j", "*v + sum(j"),
    ("fish", "x + T*along", "x - T*along"),
    ("heading_alignment", "- 2*sum(j, slope", "+ 2*sum(j, slope"),
    ("hegselmann_krause", "(x + sum(j, x[j]))", "(x - sum(j, x[j]))"),
    ("intelligent_driver", "- (v/v0)^4", "+ (v/v0)^4"),
    ("jadbabaie", "(h + sum(j, h[j]))", "(h - sum(j, h[j]))"),
    ("kuramoto", "theta[j] - theta", "theta[j] + theta"),
    ("lazy_averaging", "v[j] - v[i]", "v[j] + v[i]"),
    ("moreau", "x[j] - x", "x[j] + x"),
    ("olfati_saber", "(v[j] - v)", "(v[j] + v)"),
    ("phase_model", "omega0 - K1", "omega0 + K1"),
    ("platoon_behind", "x[j] + spacing", "x[j] - spacing"),
    ("platoon_both_sides", "g*(v - v[j])", "g*(v + v[j])"),
    ("velocity_alignment", "- 2*sum(j, slope", "+ 2*sum(j, slope"),
    ("vicsek", "x + speed*along", "x - speed*along"),
];

/// What `fuzz` and `check` look for in a law with a fault is there; the two laws of which the recorded statement is false have none.
#[test]
fn a_fault_in_a_law_is_found() {
    let laws = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/laws");
    let text = |name: &str| std::fs::read_to_string(laws.join(name)).expect("a file");
    let mut missed = Vec::new();
    for (name, from, to) in FAULTS {
        let law = text(&format!("{name}.toml"));
        assert!(law.contains(from), "{name}");
        let faulty = law.replace(from, to);
        let question = Question::read(&text(&format!("questions/{name}.toml")), &|_: &str| Ok(faulty.clone()));
        let answer = decide(&question.expect("a question"), &Unwatched).expect("an answer");
        if answer.verdict != Verdict::False || answer.counterexample.is_none() {
            missed.push(format!("{name}: {:?} {}", answer.verdict, answer.why));
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
}
