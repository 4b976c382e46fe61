//! `check`: decides statements of one's own from files.

use super::{CliError, interrupt, output, progress};
use flockproof::arithmetic::Progress;
use flockproof::question::{Answer, Certificate, Question, QuestionError, Verdict, decide, names};
use flockproof::report::{Provenance, shown};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use textwrap::WordSeparator;
use textwrap::core::Word;

#[derive(clap::Args)]
pub struct Arguments {
    /// Questions: TOML files as notes/questions.md describes them
    #[arg(value_name = "QUESTION.toml", required_unless_present = "names")]
    files: Vec<PathBuf>,
    /// Print one JSON document for each question, flockproof.check/1, a list where there are several
    #[arg(long)]
    json: bool,
    /// Print all names that a question may use, with what they mean
    #[arg(long)]
    names: bool,
    /// List so many counterexamples, in the order of the family, each with both sides and its margin
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    all: Option<u64>,
    /// List the members at which an inequality of the property is an equation, so many at most
    #[arg(long, value_name = "K", num_args = 0..=1, require_equals = true, default_missing_value = "20", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    tight: Option<u64>,
    /// Write a counterexample as a question of its own into this folder [default: the current one]
    #[arg(long, value_name = "DIR", default_value = ".", hide_default_value = true)]
    replay: PathBuf,
    /// Write the sums of squares that an answer rests on, for flockproof-checker; the second one and later ones get .2, .3, .. at the end of the name
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Write the answers as a page that needs no other file, with counterexamples drawn
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Draw the quantities of a question about a motion over time: enclosed for all its starts, with single runs and the worst of them
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    if arguments.names {
        output::print_raw(&names::as_text(output::width()))?;
        return Ok(ExitCode::SUCCESS);
    }
    if arguments.replay != Path::new(".") {
        output::make_folder(&arguments.replay)?;
    }
    arguments.html.as_deref().map_or(Ok(()), output::check_writable)?;
    arguments.certificate.as_deref().map_or(Ok(()), output::check_writable)?;
    arguments.plot.as_deref().map_or(Ok(()), output::check_writable)?;
    if arguments.plot.is_some() && arguments.files.len() > 1 {
        return Err(CliError::Use("--plot draws one question; leave the others out".to_string()));
    }
    let (mut documents, mut pages, mut certificates, mut uncertified) = (Vec::new(), Vec::new(), Vec::new(), 0);
    let mut worst = Verdict::Holds;
    let mut interrupted = false;
    for path in &arguments.files {
        let mut question = read(path)?;
        if question.law_name().is_some() && (arguments.all.is_some() || arguments.tight.is_some()) {
            let why = "--all and --tight list members of a family one by one, and this question is about all states";
            return Err(CliError::file(path, why));
        }
        question.certified = arguments.certificate.is_some();
        question.listed_counterexamples = arguments.all.unwrap_or(0);
        question.listed_tight = arguments.tight.unwrap_or(0);
        let watch = interrupt::Watch::with(progress::bar());
        let decided = decide(&question, &watch);
        watch.finish();
        let answer = match decided {
            Ok(answer) => answer,
            // What was decided before stays.
            Err(QuestionError::Cancelled(_)) => {
                interrupted = true;
                break;
            }
            Err(error) => return Err(CliError::file(path, error)),
        };
        let no_tight = arguments.tight.is_some() && question.cannot_be_tight();
        let replay = write_replay(&answer, path, &arguments.replay)?;
        let drawn = arguments.plot.as_ref().map(|_| plot(&question, &answer)).transpose()?;
        worst = worst.max(answer.verdict);
        certificates.extend(answer.certificates.iter().map(certificate));
        uncertified += answer.uncertified;
        if arguments.html.is_some() {
            pages.push((answer.id.clone(), shown::question(&question, &answer, &watch)));
        }
        if arguments.json {
            let mut document = answer.json(replay.as_deref());
            if no_tight {
                document["tight"] = Value::Null;
            }
            documents.push(provenance(path, &question).stamp(document));
        } else {
            let mut text = answer.text(replay.as_deref());
            if no_tight {
                text += "no members with equality: the property has neither `<=` nor `>=`\n";
            }
            let whole_words = textwrap::Options::new(output::width().clamp(40, 100))
                .word_separator(WordSeparator::Custom(breaking_lists))
                .word_splitter(textwrap::WordSplitter::NoHyphenation)
                .break_words(false);
            let indented = whole_words.clone().subsequent_indent("    ");
            let options = |line: &str| if line.starts_with(' ') { &indented } else { &whole_words };
            let lines = text.lines().map(|line| textwrap::fill(line, options(line)) + "\n");
            let gap = if documents.is_empty() && path == &arguments.files[0] { "" } else { "\n" };
            output::print(&(gap.to_string() + &lines.collect::<String>()))?;
        }
        if let (Some(path), Some(drawn)) = (&arguments.plot, drawn) {
            output::write_file(path, drawn.as_bytes())?;
            if !arguments.json {
                output::print(&format!("written: {}\n", path.display()))?;
            }
        }
    }
    if arguments.json && !documents.is_empty() {
        let document = if documents.len() == 1 { documents.remove(0) } else { documents.into() };
        output::print_json(&document)?;
    }
    if let Some(path) = &arguments.certificate {
        write_certificates(path, &certificates, uncertified, arguments.json)?;
    }
    if let Some(path) = arguments.html.as_deref().filter(|_| !pages.is_empty()) {
        output::write_file(path, page(arguments, &pages).as_bytes())?;
        if !arguments.json {
            output::print(&format!("written: {}\n", path.display()))?;
        }
    }
    Ok(if interrupted { interrupt::status(false) } else { ExitCode::from(worst.status()) })
}

/// Longest word that is left whole.
const LONGEST_WORD: usize = 60;

/// The words of a line: between spaces, and of long lists such as `each:3/5,1/2,..` the parts behind the commas.
fn breaking_lists(line: &str) -> Box<dyn Iterator<Item = Word<'_>> + '_> {
    let words = WordSeparator::AsciiSpace.find_words(line);
    Box::new(words.flat_map(|word| {
        if word.word.len() <= LONGEST_WORD {
            return vec![word];
        }
        let mut parts: Vec<Word> = word.word.split_inclusive(',').map(Word::from).collect();
        if let Some(last) = parts.last_mut() {
            last.whitespace = word.whitespace;
        }
        parts
    }))
}

/// A sum of squares that says what was asked, where the checker sees that it does; otherwise what it says of polynomials.
fn certificate(own: &Certificate) -> String {
    let text = own.text();
    let refused = own.statement.is_some() && flockproof_checker::check(text.as_bytes()).is_err();
    if refused { Certificate { statement: None, ..own.clone() }.text() } else { text }
}

/// The quantities of a question about a motion, over time.
fn plot(question: &Question, answer: &Answer) -> Result<String, CliError> {
    let watch = interrupt::Watch::with(progress::bar());
    let tubes = question.tubes(answer.counterexample.as_ref(), &watch);
    watch.finish();
    let tubes = tubes.map_err(|error| CliError::Use(format!("the quantities cannot be drawn: {error}")))?;
    if tubes.tubes.is_empty() {
        return Err(CliError::Use("--plot draws quantities that move, and the property has none".to_string()));
    }
    Ok(shown::tubes(question, &tubes).svg())
}

/// One file for each sum of squares.
fn write_certificates(path: &Path, certificates: &[String], uncertified: u64, quiet: bool) -> Result<(), CliError> {
    let none = "no answer rests on a sum of squares, so that there is no certificate";
    if certificates.is_empty() {
        return Err(CliError::Use(none.to_string()));
    }
    for (number, text) in (1..).zip(certificates) {
        let mut name = path.as_os_str().to_owned();
        if number > 1 {
            name.push(format!(".{number}"));
        }
        output::write_file(Path::new(&name), text.as_bytes())?;
        if !quiet {
            output::print(&format!("written: {}\n", Path::new(&name).display()))?;
        }
    }
    if uncertified > 0 && !quiet {
        output::print(&format!("proved without a certificate: {uncertified} of the parts\n"))?;
    }
    Ok(())
}

/// All answers on one page.
fn page(arguments: &Arguments, pages: &[(String, String)]) -> String {
    let names: Vec<String> = arguments.files.iter().map(|path| file_name(path)).collect();
    let command = format!("flockproof check {} --html FILE", names.join(" "));
    match pages {
        [(id, shown)] => shown::page(id, &command, shown),
        several => {
            let parts: Vec<String> = several.iter().map(|(id, shown)| shown::part(id, shown)).collect();
            shown::page("Questions", &command, &parts.concat())
        }
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// The question in its canonical form is all that an answer depends on.
fn provenance(path: &Path, question: &Question) -> Provenance {
    let name = file_name(path);
    Provenance::new(
        "flockproof.check/1",
        None,
        json!({"command": "check", "file": name, "question": question.canonical()}),
    )
}

/// Decides a question that is no file; its document, and what it says.
pub fn decided(question: &Question, name: &str, progress: &dyn Progress) -> Result<(Value, Answer), CliError> {
    let answer = decide(question, progress).map_err(|error| CliError::Use(error.to_string()))?;
    Ok((provenance(Path::new(name), question).stamp(answer.json(None)), answer))
}

/// Reads a question; the files that it names lie beside it.
pub fn read(path: &Path) -> Result<Question, CliError> {
    let text = output::read_input(path)?.text;
    Question::read(&text, &output::beside(path)).map_err(|error| CliError::file(path, error))
}

/// The text of a question made of the one in a file, for a file that lies elsewhere: the scenario and the law are named by their whole paths.
pub fn from_elsewhere(text: &str, path: &Path) -> String {
    let line = |line: &str| {
        let named = ["scenario", "law"].into_iter().find_map(|key| {
            let name: String = serde_json::from_str(line.strip_prefix(key)?.strip_prefix(" = ")?).ok()?;
            Some((key, name))
        });
        let Some((key, name)) = named else { return format!("{line}\n") };
        let beside = path.parent().unwrap_or_else(|| Path::new("")).join(name);
        let whole = std::fs::canonicalize(&beside).unwrap_or(beside).display().to_string();
        format!("{key} = {}\n", Value::from(whole))
    };
    text.lines().map(line).collect()
}

/// Writes the question of the counterexample; a question that is its own is not written again.
fn write_replay(answer: &Answer, path: &Path, folder: &Path) -> Result<Option<String>, CliError> {
    let Some(text) = &answer.replay else {
        return Ok(answer.counterexample.as_ref().map(|_| path.display().to_string()));
    };
    let text = from_elsewhere(text, path);
    let file = folder.join(format!("{}.counterexample.toml", answer.id));
    output::write_file(&file, text.as_bytes())?;
    Ok(Some(file.display().to_string()))
}
