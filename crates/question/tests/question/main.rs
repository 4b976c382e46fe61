//! Questions: language, families, decisions, bad input.

extern crate flockproof_question as question;

mod bad_input;
mod constants;
mod decisions;
mod digraphs;
mod exact_facts;
mod families;
mod gallery;
mod graphs;
mod language;
mod made;
mod missing;
mod motions;
mod one_number;
mod own;
mod rewritten;
mod sets;
mod sharp;
mod sides;
mod starts;
mod states;
mod touching;
mod traces;

use arithmetic::Unwatched;
use question::{Answer, Question, QuestionError, Verdict, decide};

/// No question of these tests names a file.
fn no_files(name: &str) -> Result<String, String> {
    Err(format!("there is no file {name}"))
}

fn read(text: &str) -> Result<Question, QuestionError> {
    Question::read(text, &no_files)
}

/// A question about a property, with one control.
fn asked(family: &str, property: &str, control: &str) -> String {
    format!(
        "[question]\nid = \"test\"\n[for]\n{family}\n[holds]\nproperty = \"{property}\"\ncontrols = [\"{control}\"]\n"
    )
}

fn answer(text: &str) -> Answer {
    decide(&read(text).expect("a question"), &Unwatched).expect("an answer")
}

/// The verdict on a property with a control that is false whatever happens.
fn verdict(family: &str, property: &str) -> Verdict {
    answer(&asked(family, property, "1 < 0")).verdict
}

/// A property holds with 0 in the place of `EPS`, and is false with each of these numbers there.
fn holds_exactly(family: &str, property: &str, altered: &[&str]) {
    let found = answer(&asked(family, &property.replace("EPS", "0"), "1 < 0"));
    assert_eq!(found.verdict, Verdict::Holds, "{property}: {}", found.why);
    for small in altered {
        assert_eq!(verdict(family, &property.replace("EPS", small)), Verdict::False, "{property} with {small}");
    }
}

/// Why a question is refused, when it is read or when it is decided.
fn refusal(text: &str) -> String {
    refused_by(read(text))
}

/// The same with a file for the scenario.
fn refusal_with(text: &str, scenario: &str) -> String {
    refused_by(Question::read(text, &|_| Ok(scenario.to_string())))
}

fn refused_by(question: Result<Question, QuestionError>) -> String {
    match question.and_then(|question| decide(&question, &Unwatched)) {
        Err(error) => error.to_string(),
        Ok(answer) => panic!("answered {:?}", answer.verdict),
    }
}
