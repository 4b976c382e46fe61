//! `list`: claims by words, paper, verdict, fault, grade and scope, from what is recorded.

use super::{CliError, output, verify};
use flockproof::ledger::{Grade, Verdict, is_of_paper};
use flockproof::report::{Listing, Provenance, Query, SCOPES, catalogue, catalogue_text};
use serde_json::json;
use std::collections::BTreeSet;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "Every option may be repeated and takes lists: --verdict false,misprint. Nothing is checked: the verdicts are those that are \
recorded; `verify` checks them.\n\n\
Examples:\n  flockproof list resonance amplitude\n  flockproof list --paper veerman --verdict false,misprint\n  flockproof list --grade argued --scope instances --json"
)]
pub struct Arguments {
    /// Words that all stand in the id, the place or the statement
    #[arg(value_name = "WORD")]
    words: Vec<String>,
    /// Only claims of these papers: chazelle, veerman, paley, tanner (tanner1 and tanner2), beyond [default: all]
    #[arg(long, value_name = "P", value_delimiter = ',')]
    paper: Vec<String>,
    /// Only these verdicts: holds, needs_hypothesis, misprint, false, undecided, not_checkable [default: all]
    #[arg(long, value_name = "V", value_delimiter = ',')]
    verdict: Vec<String>,
    /// Only these faults: hypothesis, typo, slip, false, none [default: all]
    #[arg(long, value_name = "F", value_delimiter = ',')]
    fault: Vec<String>,
    /// Only claims with evidence of one of these grades, such as kernel, certified, argued or exact [default: all]
    #[arg(long, value_name = "G", value_delimiter = ',')]
    grade: Vec<String>,
    /// Only these scopes: all clauses are proved for all parameters (all), some are (part), none is (instances), there are no clauses (none) [default: any]
    #[arg(long, value_name = "S", value_delimiter = ',')]
    scope: Vec<String>,
    /// Print one JSON document, flockproof.list/1
    #[arg(long)]
    json: bool,
}

/// Refuses words that are not in a list.
fn known<'a>(option: &str, asked: &[String], known: impl IntoIterator<Item = &'a str>) -> Result<(), CliError> {
    let known: BTreeSet<&str> = known.into_iter().collect();
    match asked.iter().find(|word| !known.contains(word.as_str())) {
        None => Ok(()),
        Some(word) => {
            let known: Vec<&str> = known.into_iter().collect();
            Err(CliError::Use(format!("--{option}: `{word}` is none of {}", known.join(", "))))
        }
    }
}

fn query(arguments: &Arguments, all: &[Listing<'_>]) -> Result<Query, CliError> {
    let papers: BTreeSet<&str> = all.iter().map(|claim| claim.paper()).collect();
    let several = arguments.paper.iter().filter(|asked| papers.iter().any(|paper| is_of_paper(paper, asked)));
    known("paper", &arguments.paper, papers.iter().copied().chain(several.map(String::as_str)))?;
    known("verdict", &arguments.verdict, Verdict::ALL.map(Verdict::word))?;
    known("fault", &arguments.fault, all.iter().filter_map(Listing::fault).chain(["none"]))?;
    known("grade", &arguments.grade, Grade::ALL.map(Grade::word))?;
    known("scope", &arguments.scope, SCOPES)?;
    Ok(Query {
        words: arguments.words.clone(),
        papers: arguments.paper.clone(),
        verdicts: arguments.verdict.clone(),
        faults: arguments.fault.clone(),
        grades: arguments.grade.clone(),
        scopes: arguments.scope.clone(),
    })
}

/// How many there are, what stands in a line, and what its grades mean.
fn legend(found: &[&Listing<'_>], all: &[Listing<'_>]) -> String {
    let own = all.iter().filter(|claim| claim.is_own()).count();
    let text = format!(
        "{} of {} claims: {} statements of the papers, and {own} corrections and results of our own (beyond). A line has the id, the verdict, how many of \
         the claim's clauses are covered for all parameters (1/2: one of two), and the grades of its evidence, strongest first. `flockproof explain ID` \
         tells all about one.",
        found.len(),
        all.len(),
        all.len() - own
    );
    let shown: BTreeSet<&str> = found.iter().flat_map(|claim| claim.grades()).collect();
    let grades = Grade::ALL.into_iter().filter(|grade| shown.contains(grade.word()));
    let grades: Vec<String> = grades.map(|grade| format!("{}: {}", grade.word(), grade.meaning())).collect();
    let filled = |text: &str| textwrap::fill(text, output::width()) + "\n";
    filled(&text) + &if grades.is_empty() { String::new() } else { filled(&grades.join(". ")) }
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let ledger = verify::ledger()?;
    let all = catalogue(&ledger);
    let query = query(arguments, &all)?;
    let found: Vec<&Listing<'_>> = all.iter().filter(|claim| query.matches(claim)).collect();
    if arguments.json {
        let configuration = json!({
            "command": "list", "words": query.words, "paper": query.papers, "verdict": query.verdicts,
            "fault": query.faults, "grade": query.grades, "scope": query.scopes,
        });
        let claims: Vec<_> = found.iter().map(|claim| claim.json()).collect();
        let provenance = Provenance::new("flockproof.list/1", None, configuration);
        output::print_json(&provenance.stamp(json!({"claims": claims})))?;
    } else {
        output::print(&(catalogue_text(&found, output::width()) + &legend(&found, &all)))?;
    }
    Ok(ExitCode::SUCCESS)
}
