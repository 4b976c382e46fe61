//! Two tables that are kept beside the claims of a project: what is claimed, and the verdicts that are expected.

/// One row of a list of claims.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Listed<'a> {
    /// The id.
    pub id: &'a str,
    /// Section, equation, lemma.
    pub place: &'a str,
    /// The statement as printed.
    pub statement: &'a str,
}

/// One row of recorded verdicts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recorded<'a> {
    /// The id.
    pub id: &'a str,
    /// The word of the verdict.
    pub verdict: &'a str,
    /// The word of the fault, `-` where there is none.
    pub fault: &'a str,
    /// How many clauses are covered for all parameters, of how many: `2/3`.
    pub reach: &'a str,
    /// The words of the grades, strongest first, joined by commas.
    pub grades: &'a str,
}

fn rows<const N: usize>(table: &str) -> impl Iterator<Item = [&str; N]> {
    table.lines().skip(1).filter_map(|line| line.split('\t').collect::<Vec<_>>().try_into().ok())
}

/// The rows of a table of claims: a header, then id, place and statement separated by tabs.
pub fn listed(table: &str) -> impl Iterator<Item = Listed<'_>> {
    rows(table).map(|[id, place, statement]| Listed { id, place, statement })
}

/// The rows of a table of verdicts: a header, then id, verdict, fault, reach and grades separated by tabs.
pub fn recorded(table: &str) -> impl Iterator<Item = Recorded<'_>> {
    rows(table).map(|[id, verdict, fault, reach, grades]| Recorded { id, verdict, fault, reach, grades })
}
