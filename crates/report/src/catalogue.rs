//! All claims with their recorded verdicts: searched, filtered, and the ids nearest to a wrong one.

use super::Figure;
use ledger::{Ledger, LedgerError, Recorded, is_of_paper};
use question::nearest_ids;
use serde_json::{Value, json};
use std::fmt::Write;

/// What is known of a claim without checking it.
#[derive(Debug, Clone, PartialEq)]
pub struct Listing<'a> {
    /// The id.
    pub id: &'a str,
    /// Where the claim stands.
    pub place: &'a str,
    /// The statement as printed, or for claims of our own as stated.
    pub statement: &'a str,
    /// The recorded verdict, fault, reach and grades.
    pub recorded: Recorded<'a>,
}

/// How far the evidence of a claim reaches, in one word: all clauses for all parameters, some of them, none, or there are no clauses.
pub const SCOPES: [&str; 4] = ["all", "part", "instances", "none"];

impl<'a> Listing<'a> {
    /// The first part of the id.
    pub fn paper(&self) -> &str {
        self.id.split('.').next().unwrap_or_default()
    }

    /// Whether it is a result of our own, or a correction.
    pub fn is_own(&self) -> bool {
        self.paper() == "beyond"
    }

    /// Whether it belongs to one of these papers; every claim does where none is named.
    fn is_of(&self, papers: &[String]) -> bool {
        papers.is_empty() || papers.iter().any(|paper| is_of_paper(self.paper(), paper))
    }

    /// Clauses that are covered for all parameters, of how many.
    fn reach(&self) -> (u64, u64) {
        let (whole, total) = self.recorded.reach.split_once('/').unwrap_or(("0", "0"));
        (whole.parse().unwrap_or(0), total.parse().unwrap_or(0))
    }

    /// One of [`SCOPES`].
    pub fn scope(&self) -> &'static str {
        match self.reach() {
            (_, 0) => "none",
            (0, _) => "instances",
            (whole, total) if whole == total => "all",
            _ => "part",
        }
    }

    /// The grades of the evidence, strongest first.
    pub fn grades(&self) -> impl Iterator<Item = &'a str> {
        self.recorded.grades.split(',').filter(|grade| !grade.is_empty())
    }

    /// What is wrong with a statement that fails.
    pub fn fault(&self) -> Option<&'a str> {
        Some(self.recorded.fault).filter(|fault| *fault != "-")
    }

    /// As JSON.
    pub fn json(&self) -> Value {
        let (whole, total) = self.reach();
        json!({
            "id": self.id,
            "paper": self.paper(),
            "place": self.place,
            "statement": self.statement,
            "verdict": self.recorded.verdict,
            "fault": self.fault(),
            "clauses": {"for_all_parameters": whole, "total": total},
            "scope": self.scope(),
            "grades": self.grades().collect::<Vec<_>>(),
            "figures": Figure::of_claim(self.id).map(|figure| figure.name).collect::<Vec<_>>(),
        })
    }
}

/// All claims of the ledger: the statements of the papers, then our own, each sorted by id.
pub fn catalogue<'a>(ledger: &'a Ledger) -> Vec<Listing<'a>> {
    let listing = |recorded: Recorded<'a>| {
        let source = ledger.source(recorded.id)?;
        Some(Listing { id: recorded.id, place: &source.place, statement: &source.statement, recorded })
    };
    let mut all: Vec<Listing<'a>> = ledger.recorded().filter_map(listing).collect();
    all.sort_by_key(|claim| claim.is_own());
    all
}

/// The claims of these papers (of all where none is named) that stand at a place, such as `Theorem 1`: where the place is that, or begins with it. An equation may be
/// named by its number alone, `(9)`: its claims, or where it has none those that stand next to it.
pub fn of_place<'a>(all: &[Listing<'a>], papers: &[String], place: &str) -> Vec<&'a str> {
    let wanted = place.trim().to_lowercase();
    let of_papers: Vec<_> = all.iter().filter(|claim| claim.is_of(papers)).collect();
    let found = |is_there: &dyn Fn(&str) -> bool| -> Vec<&'a str> {
        let here = of_papers.iter().filter(|claim| is_there(&claim.place.to_lowercase()));
        here.map(|claim| claim.id).collect()
    };
    let begins = |wanted: &str| {
        found(&|place| place.strip_prefix(wanted).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric)))
    };
    let mut ids = begins(&wanted);
    let number = ["equation", "eq."].iter().find_map(|word| wanted.strip_prefix(word)).unwrap_or(&wanted).trim();
    if ids.is_empty() && number.starts_with('(') && number.ends_with(')') {
        ids = begins(&format!("eq {number}"));
        if ids.is_empty() {
            ids = found(&|place| place.contains(number));
        }
    }
    ids
}

/// What is looked for; an empty list asks for nothing, and the others must all be met.
#[derive(Debug, Clone, Default)]
pub struct Query {
    /// Words that all stand in the id, the place or the statement, capital letters or not.
    pub words: Vec<String>,
    /// Papers.
    pub papers: Vec<String>,
    /// Words of verdicts.
    pub verdicts: Vec<String>,
    /// Words of faults.
    pub faults: Vec<String>,
    /// Words of grades, any of which the evidence has.
    pub grades: Vec<String>,
    /// Some of [`SCOPES`].
    pub scopes: Vec<String>,
}

impl Query {
    /// Whether a claim is looked for.
    pub fn matches(&self, claim: &Listing<'_>) -> bool {
        let one_of = |asked: &[String], word: &str| asked.is_empty() || asked.iter().any(|a| a == word);
        let text = format!("{} {} {}", claim.id, claim.place, claim.statement).to_lowercase();
        self.words.iter().all(|word| text.contains(&word.to_lowercase()))
            && claim.is_of(&self.papers)
            && one_of(&self.verdicts, claim.recorded.verdict)
            && one_of(&self.faults, claim.fault().unwrap_or("none"))
            && one_of(&self.scopes, claim.scope())
            && (self.grades.is_empty() || claim.grades().any(|grade| self.grades.iter().any(|g| g == grade)))
    }
}

/// Two lines for each claim, of at most `width` columns: id, verdict, reach and grades; the beginning of the statement.
pub fn catalogue_text(claims: &[&Listing<'_>], width: usize) -> String {
    let mut text = String::new();
    for claim in claims {
        let (whole, total) = claim.reach();
        let fault = claim.fault().filter(|fault| *fault != claim.recorded.verdict);
        let fault = fault.map_or(String::new(), |fault| format!(" ({fault})"));
        let grades = claim.grades().collect::<Vec<_>>().join(", ");
        let head = format!("{}  {}{fault}  {whole}/{total}  {grades}", claim.id, claim.recorded.verdict);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}\n    {}", cut(&head, width), cut(claim.statement, width.saturating_sub(4)));
    }
    text
}

/// A text of at most so many characters.
fn cut(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_string();
    }
    let short: String = text.chars().take(width.saturating_sub(3)).collect();
    format!("{}...", short.trim_end())
}

/// A wrong id or paper in one sentence, with the ids that may be meant, of these papers where some are named.
pub fn not_found(ledger: &Ledger, papers: &[String], error: &LedgerError) -> String {
    const MOST: usize = 8;
    let LedgerError::Unknown(id) = error else { return error.to_string() };
    let of_papers = ledger.select(papers, &[]).unwrap_or_default();
    let close = nearest_ids(of_papers.iter().map(String::as_str), id, MOST);
    match (close.is_empty(), papers.join(" ")) {
        (false, _) => format!("{error}; the nearest are {}", close.join(", ")),
        (true, papers) if papers.is_empty() => error.to_string(),
        (true, papers) => format!("{error} in {papers}; `flockproof list {papers}` shows those that there are"),
    }
}
