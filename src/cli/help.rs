//! What clap is told for all commands alike, and its messages as sentences.

use super::output;
use clap::{Command, CommandFactory};
use flockproof::arithmetic::{parse_rational, shown};
use num_traits::ToPrimitive;

/// Widest help text.
const WIDEST: usize = 100;

const NUMBERS: &str = "Numbers are integers, fractions -1/2 or decimals -0.5, read exactly; a file `-` is standard input. All output is at most as wide as the \
terminal, and 80 columns wide where it goes elsewhere.";

/// What is true of every command.
const STATUS: &str = "2 on bad use or input; 130 after Ctrl-C.";

/// What else commands end with.
const STATUSES: [(&str, &str); 7] = [
    ("flockproof", "0; 2 on bad use or input; 130 after Ctrl-C; further numbers stand in the help of a command."),
    ("verify", "0 where all is as recorded; 1 if a verdict is another one or a control was not refuted"),
    ("prove", "0; 1 if Coq finds something else than what is recorded"),
    ("reach", "0 where all hold; 1 if one is false; 3 if one is undecided"),
    ("check", "0 where all hold; 1 if one is false; 3 if one is undecided; 4 where a control was not refuted"),
    ("fuzz", "0; 1 if a case fails; 4 where a control was not refuted"),
    ("serve", "130 after Ctrl-C, which ends it; 2 on bad use or input."),
];

/// Examples of commands that do not bring their own.
const EXAMPLES: [(&str, &str); 5] = [
    ("check", "Examples:\n  flockproof check question.toml\n  flockproof check --names"),
    (
        "fuzz",
        "Examples:\n  flockproof fuzz --list\n  flockproof fuzz --cases 10000 --store out --shard 1/4 --resume\n  \
         flockproof fuzz question.toml --cases 500",
    ),
    (
        "flock",
        "Examples:\n  flockproof flock run assets/four_birds.json --until 64\n  flockproof flock settle assets/four_birds.json",
    ),
    ("report", "Examples:\n  flockproof report --out site\n  flockproof report --ledger ledger.json --out site"),
    ("serve", "Examples:\n  flockproof serve\n  flockproof serve --ledger ledger.json --port 0"),
];

/// The exit statuses of a command in a sentence.
fn statuses(name: &str) -> String {
    match STATUSES.iter().find(|(known, _)| *known == name) {
        Some((_, whole)) if whole.ends_with('.') => format!("Exit status: {whole}"),
        Some((_, first)) => format!("Exit status: {first}; {STATUS}"),
        None => format!("Exit status: 0; {STATUS}"),
    }
}

/// The command line with everything that all of it has in common: width, exit status, numbers below zero.
pub fn command() -> Command {
    let command = super::Arguments::command().term_width(output::width().min(WIDEST));
    let command = command.after_help(format!("{NUMBERS}\n\n{}\n\nExamples:\n  flockproof verify --paper veerman\n  flockproof list resonance\n  flockproof explain veerman.gain_max\n  flockproof COMMAND --help", statuses("flockproof")));
    everywhere(command, true)
}

/// The exit status at the end of every help text; a value such as `-3` is a value of its option everywhere, so that it is refused as such.
fn everywhere(command: Command, top: bool) -> Command {
    let status = statuses(command.get_name());
    let example = EXAMPLES.iter().find(|(name, _)| *name == command.get_name()).map(|(_, example)| example.to_string());
    let command = match command.get_after_help().map(ToString::to_string).or(example) {
        Some(text) if !top => command.after_help(format!("{text}\n\n{status}")),
        None => command.after_help(status),
        Some(_) => command,
    };
    let takes_values =
        |argument: &clap::Arg| argument.get_action().takes_values() && !argument.is_allow_hyphen_values_set();
    let command = command
        .mut_args(|argument| if takes_values(&argument) { argument.allow_negative_numbers(true) } else { argument });
    command.mut_subcommands(|subcommand| everywhere(subcommand, false))
}

/// An integer, a fraction or a decimal as a float.
pub fn finite(text: &str) -> Result<f64, String> {
    let exact = parse_rational(text).map_err(|error| error.to_string())?;
    exact.to_f64().filter(|x| x.is_finite()).ok_or_else(|| format!("{} is too large for a float", shown(text)))
}

/// Words of libraries, and what they mean to people.
const WORDS: [(&str, &str); 8] = [
    ("invalid digit found in string", "a whole number that is not negative is expected"),
    ("number too large to fit in target type", "the number is too large"),
    ("number too small to fit in target type", "the number is too small"),
    ("cannot parse integer from empty string", "a whole number is expected, but there is nothing"),
    ("cannot parse float from empty string", "a number is expected, but there is nothing"),
    ("invalid float literal", "a number such as 0.5 is expected"),
    ("unexpected argument", "there is no argument"),
    ("unrecognized subcommand", "there is no command"),
];

/// Words of the readers of JSON and TOML, and what they mean to people.
const FILE_WORDS: [(&str, &str); 21] = [
    // Of a text as a whole there is no place to tell.
    ("EOF while parsing a value at line 1 column 0", "there is nothing in it"),
    (" at line 1 column 0", ""),
    ("EOF while parsing a value", "the text ends where a value should stand,"),
    ("EOF while parsing an object", "the text ends within an object,"),
    ("EOF while parsing a list", "the text ends within a list,"),
    ("EOF while parsing a string", "the text ends within quotes,"),
    ("expected value", "a value should stand"),
    ("expected struct Document", "expected an object"),
    ("trailing comma", "nothing follows after the comma"),
    ("expected `:`", "a colon should stand"),
    ("expected `,` or `}`", "a comma or } should stand"),
    ("expected `,` or `]`", "a comma or ] should stand"),
    ("key must be a string", "a key should stand in quotes"),
    ("control character (\\u0000-\\u001F) found while parsing a string", "a line ends within quotes"),
    ("invalid escape", "a backslash stands before a letter that means nothing"),
    ("trailing characters", "something follows after the end,"),
    ("missing field", "there is no key"),
    ("invalid type: ", "found "),
    ("string values must be quoted, expected literal string", "texts stand in quotes, and a key has one value"),
    ("invalid basic string, expected `\"`", "a text has no closing quote"),
    (", expected nothing", ""),
];

/// A message about a file in plain words.
pub fn plain(message: &str) -> String {
    FILE_WORDS.iter().fold(message.to_string(), |text, (theirs, ours)| text.replace(theirs, ours))
}

/// The first paragraph of clap's message on one line, with its advice where it has one.
pub fn one_sentence(message: &str) -> String {
    let paragraphs: Vec<String> = message
        .split("\n\n")
        .map(|paragraph| paragraph.lines().map(str::trim).collect::<Vec<_>>().join(" ").trim().to_string())
        .collect();
    let tip = paragraphs.iter().find_map(|paragraph| nearest(paragraph.strip_prefix("tip: ")?));
    let mut sentence = paragraphs.first().cloned().unwrap_or_default();
    for (theirs, ours) in WORDS {
        sentence = sentence.replace(theirs, ours);
    }
    let sentence = with_range(sentence.strip_suffix(" found").unwrap_or(&sentence));
    match tip {
        Some(tip) => format!("{sentence}; {tip}"),
        None => sentence,
    }
}

/// Clap's advice with the nearest name alone: of several the last is the most similar.
fn nearest(tip: &str) -> Option<String> {
    let tip = tip.replace("subcommand", "command");
    let several = tip.strip_prefix("some similar ").and_then(|rest| rest.split_once(" exist: "));
    match several {
        Some((kind, names)) => {
            let name = names.rsplit(", ").next().unwrap_or(names);
            Some(format!("a similar {} exists: {name}", kind.trim_end_matches('s')))
        }
        None => tip.starts_with("a similar ").then_some(tip),
    }
}

/// `-5 is not in 1..=10000` in words.
fn with_range(sentence: &str) -> String {
    let ranges = sentence.split_once(" is not in ").and_then(|(before, range)| {
        let (least, most) = range.split_once("..=")?;
        Some(format!("{before} is not one of the numbers from {least} to {most}"))
    });
    ranges.unwrap_or_else(|| sentence.to_string())
}
