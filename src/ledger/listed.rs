//! The list of claims of the five papers and the recorded verdicts: two tables kept with the sources.

/// One row of the list of claims.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Listed {
    /// The id.
    pub id: &'static str,
    /// Section, equation, lemma.
    pub place: &'static str,
    /// The statement as printed.
    pub statement: &'static str,
}

/// One row of the recorded verdicts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recorded {
    /// The id.
    pub id: &'static str,
    /// The word of the verdict.
    pub verdict: &'static str,
    /// The words of the grades, strongest first, joined by commas.
    pub grades: &'static str,
}

fn rows(table: &'static str) -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    table.lines().skip(1).filter_map(|line| {
        let mut cells = line.split('\t');
        Some((cells.next()?, cells.next()?, cells.next()?))
    })
}

/// Every checkable claim of the five papers, in the order of the list.
pub fn listed() -> impl Iterator<Item = Listed> {
    rows(include_str!("../claims/listed.tsv")).map(|(id, place, statement)| Listed { id, place, statement })
}

/// The verdicts that the ledger is expected to reach.
pub fn recorded() -> impl Iterator<Item = Recorded> {
    rows(include_str!("../claims/recorded.tsv")).map(|(id, verdict, grades)| Recorded { id, verdict, grades })
}
