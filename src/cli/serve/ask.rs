//! The questions of the live pages, answered as the command line answers them; none of them opens a file.

use super::super::{CliError, check, flock, help, output, pattern, reach, resonance, simulate, spectrum};
use flockproof::arithmetic::Progress;
use flockproof::question::Question;
use flockproof::reach::System;
use flockproof::report::{digest, shown};
use serde_json::{Map, Value, json};

/// An answer.
pub struct Answered {
    /// The document that the command line prints with `--json`.
    pub document: Value,
    /// The same for people, as a piece of a page.
    pub shown: String,
}

type Ask = fn(&str, &dyn Progress) -> Result<Answered, CliError>;

const QUESTIONS: [(&str, Ask); 8] = [
    ("resonance", of_platoon),
    ("spectrum", of_graph),
    ("flock", of_flock),
    ("pattern", of_pattern),
    ("question", of_question),
    ("scenario", of_scenario),
    ("system", of_system),
    ("certificate", of_certificate),
];

/// Whether there is such a question.
pub fn is_known(what: &str) -> bool {
    QUESTIONS.iter().any(|(name, _)| *name == what)
}

/// The answer.
///
/// # Errors
/// One sentence on what is wrong with the question.
pub fn answer(what: &str, text: &str, progress: &dyn Progress) -> Result<Answered, CliError> {
    let ask = QUESTIONS.iter().find(|(name, _)| *name == what).ok_or_else(|| refused("there is nothing here"))?;
    ask.1(text, progress)
}

fn refused(why: impl Into<String>) -> CliError {
    CliError::Use(why.into())
}

/// The fields of a form, which are texts.
struct Form(Map<String, Value>);

impl Form {
    fn read(text: &str) -> Result<Self, CliError> {
        serde_json::from_str(text)
            .map(Form)
            .map_err(|error| refused(help::plain(&format!("the question is no JSON object: {error}"))))
    }

    /// A field of at most so many bytes; empty where it is left out.
    fn text(&self, name: &str, most: usize) -> Result<&str, CliError> {
        match self.0.get(name) {
            None => Ok(""),
            Some(Value::String(text)) if text.len() <= most => Ok(text),
            Some(Value::String(_)) => Err(refused(format!("{name}: at most {most} bytes"))),
            Some(_) => Err(refused(format!("{name}: a text is expected"))),
        }
    }

    /// A field that must be there.
    fn word(&self, name: &str) -> Result<&str, CliError> {
        match self.text(name, WORD)?.trim() {
            "" => Err(refused(format!("{name} is missing"))),
            word => Ok(word),
        }
    }

    fn count(&self, name: &str, most: u64) -> Result<u64, CliError> {
        let number = self.word(name)?.parse().ok().filter(|n| (1..=most).contains(n));
        number.ok_or_else(|| refused(format!("{name}: an integer from 1 to {most}")))
    }
}

/// Longest fields of one line, and of many.
const WORD: usize = 4000;
const TEXT: usize = 1 << 20;

/// The digits that pages show.
const DIGITS: u32 = 15;

fn of_platoon(text: &str, _: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    let followers = form.count("followers", 1_000_000_000_000)?;
    let gains = resonance::equal_gains(form.word("f")?, form.word("g")?)?;
    let certified = resonance::Certified::find(&gains, followers, DIGITS)?;
    let shown = shown::resonance(&gains, followers, &certified.found).map_err(|error| refused(error.to_string()))?;
    Ok(Answered { document: certified.document(), shown })
}

/// Most vertices, so that the answer has no more lines than a page.
const VERTICES: usize = 400;

fn of_graph(text: &str, _: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    let (name, edges) = (form.text("graph", WORD)?.trim(), form.text("edges", TEXT)?);
    let kind = form.text("kind", WORD)?.trim();
    let kind = if kind.is_empty() { "laplacian" } else { kind };
    let found = spectrum::of_text(name, input(edges), kind, VERTICES)?;
    Ok(Answered { shown: shown::spectrum(&found.graph, found.directed, &found.spectrum), document: found.document })
}

/// Most birds of a page.
const BIRDS: usize = 24;

fn of_flock(text: &str, progress: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    if form.0.get("positions").and_then(Value::as_array).map_or(0, Vec::len) > BIRDS {
        return Err(refused(format!("positions: at most {BIRDS} birds")));
    }
    let settled = flock::settled(&input(text), progress)?;
    let shown = shown::flock(&settled.start, &settled.switches, &settled.settlement);
    Ok(Answered { document: settled.document, shown })
}

fn of_pattern(text: &str, progress: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    let field = |name: &str| Ok::<_, CliError>(form.word(name)?.to_string());
    let asked = pattern::Asked {
        particles: form.count("particles", pattern::LARGEST)? as usize,
        gains: field("gains")?,
        omega0: field("omega0")?,
        spacing: field("K0")?,
    };
    let found = pattern::find(&asked, progress)?;
    let shown = shown::patterns(&found.rows, &found.gains);
    Ok(Answered { document: found.document(), shown })
}

fn of_question(text: &str, progress: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    let (text, beside) = (form.text("question", TEXT)?, form.text("beside", TEXT)?);
    // Whatever name the question has for it, there is one text beside it, and no file.
    let files = |name: &str| match beside.trim() {
        "" => Err(format!("`{name}`: a page opens no files; write what the question names into the second field")),
        _ => Ok(beside.to_string()),
    };
    let question = Question::read(text, &files).map_err(|error| refused(error.to_string()))?;
    let (document, answer) = check::decided(&question, "-", progress)?;
    let shown = shown::question(&question, &answer, progress);
    Ok(Answered { document, shown })
}

fn of_scenario(text: &str, progress: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    let (outcome, document) = simulate::ran(&input(form.text("scenario", TEXT)?), progress)?;
    Ok(Answered { document, shown: shown::simulation(&outcome) })
}

/// Digits of worst cases.
const WORST: u32 = 10;

fn of_system(text: &str, progress: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    let input = input(form.text("system", TEXT)?);
    let system = System::read(&input.text).map_err(|error| refused(help::plain(&error.to_string())))?;
    let found = reach::answered(system, &input, WORST, progress).map_err(|error| refused(help::plain(&error)))?;
    let shown = found.and_then(|found| found.shown(progress));
    let (document, shown) = shown.ok_or_else(|| refused("interrupted"))?;
    Ok(Answered { document, shown })
}

fn of_certificate(text: &str, _: &dyn Progress) -> Result<Answered, CliError> {
    let form = Form::read(text)?;
    let certificate = form.text("certificate", super::LONGEST)?;
    let checked = flockproof_checker::check(certificate.as_bytes());
    let document = match &checked {
        Ok(certified) => json!({"accepted": true, "kind": certified.kind, "claim": certified.claim}),
        Err(refusal) => json!({"accepted": false, "line": refusal.line, "reason": refusal.reason}),
    };
    let said = checked.map(|certified| (certified.kind, certified.claim)).map_err(|no| (no.line, no.reason));
    Ok(Answered { document, shown: shown::certificate(&said) })
}

/// A text as if it came from standard input.
fn input(text: &str) -> output::Input {
    output::Input { text: text.to_string(), origin: json!({"name": "-", "sha256": digest(text.as_bytes())}) }
}
