//! What clap is told for all commands alike, and its messages as sentences.

use super::output;
use clap::{Command, CommandFactory};
use flockproof::arithmetic::{parse_rational, shown};
use num_traits::ToPrimitive;

/// Widest help text.
const WIDEST: usize = 100;

const NUMBERS: &str = "Numbers are integers, fractions -1/2 or decimals -0.5, read exactly; a file `-` is standard input. All output is at most as wide as the \
terminal, and 80 columns wide where it goes elsewhere.";

const STATUS: &str = "Exit status: 0; 1 if `verify` or `prove` find something else than what is recorded; 2 on bad use or input; 130 after Ctrl-C.";

/// The command line with everything that all of it has in common: width, exit status, numbers below zero.
pub fn command() -> Command {
    let command = super::Arguments::command().term_width(output::width().min(WIDEST));
    let command = command.after_help(format!("{NUMBERS}\n\n{STATUS}\n\nExamples:\n  flockproof verify --paper veerman\n  flockproof list resonance\n  flockproof explain veerman.gain_max\n  flockproof COMMAND --help"));
    everywhere(command, true)
}

/// The exit status at the end of every help text; a value such as `-3` is a value of its option everywhere, so that it is refused as such.
fn everywhere(command: Command, top: bool) -> Command {
    let command = match command.get_after_help().map(ToString::to_string) {
        Some(text) if !top => command.after_help(format!("{text}\n\n{STATUS}")),
        None => command.after_help(STATUS),
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

/// The first paragraph of clap's message on one line, with its advice where it has one.
pub fn one_sentence(message: &str) -> String {
    let paragraphs: Vec<String> = message
        .split("\n\n")
        .map(|paragraph| paragraph.lines().map(str::trim).collect::<Vec<_>>().join(" ").trim().to_string())
        .collect();
    let tip = paragraphs.iter().find(|paragraph| paragraph.starts_with("tip: a similar"));
    let mut sentence = paragraphs.first().cloned().unwrap_or_default();
    for (theirs, ours) in WORDS {
        sentence = sentence.replace(theirs, ours);
    }
    if let Some(tip) = tip {
        sentence = format!("{sentence}; {}", tip.trim_start_matches("tip: "));
    }
    sentence.strip_suffix(" found").map(str::to_string).unwrap_or(sentence)
}
