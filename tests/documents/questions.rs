//! The questions that come with the program, and the page that tells of them.

use super::page::root;
use flockproof::arithmetic::Unwatched;
use flockproof::question::{Question, Verdict, decide, names};

const RECORDED: [(&str, Verdict); 16] = [
    ("algebraic_connectivity", Verdict::Holds),
    ("gap_and_diameter", Verdict::False),
    ("more_links_are_faster", Verdict::False),
    ("peak_per_car", Verdict::Holds),
    ("gains_for_256", Verdict::Holds),
    ("never_meets", Verdict::Holds),
    ("agreement_time", Verdict::Holds),
    ("no_collision", Verdict::Holds),
    ("altered_sign", Verdict::Holds),
    ("order_grows", Verdict::Holds),
    ("products_contract", Verdict::Holds),
    ("open_question", Verdict::Undecided),
    ("motzkin", Verdict::Holds),
    ("momentum_is_conserved", Verdict::Holds),
    ("momentum_of_normalised_weights", Verdict::False),
    ("fluctuation_at_a_rate", Verdict::False),
];

#[test]
fn every_question_has_its_recorded_verdict() {
    let folder = root().join("assets/questions");
    let files = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
    for (name, verdict) in RECORDED {
        let text = files(&format!("{name}.toml")).expect("a question");
        let question = Question::read(&text, &files).expect("a question");
        let answer = decide(&question, &Unwatched).expect("an answer");
        assert_eq!((answer.verdict, question.id()), (verdict, name), "{}", answer.why);
        assert!(!answer.controls.is_empty() && answer.controls.iter().all(|refuted| *refuted));
        // What refutes it is a question that is false by itself.
        if let Some(replay) = &answer.replay {
            let again = decide(&Question::read(replay, &files).expect("a question"), &Unwatched).expect("an answer");
            assert_eq!((again.verdict, again.replay), (Verdict::False, None), "{name}");
        }
    }
    let entries = std::fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let questions = entries.filter(|path| std::fs::read_to_string(path).is_ok_and(|text| text.contains("[question]")));
    assert_eq!(questions.count(), RECORDED.len());
}

#[test]
fn the_page_has_the_table_of_names() {
    let page = include_str!("../../notes/questions.md");
    let missing = names::as_markdown();
    let missing = missing.lines().find(|line| !line.is_empty() && !page.contains(*line));
    assert_eq!(missing, None);
}

#[test]
fn the_page_has_the_table_of_observables() {
    let page = include_str!("../../notes/simulate.md");
    assert!(page.contains(&flockproof::scenario::observables_as_markdown()));
}
