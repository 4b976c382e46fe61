//! Statements of our own say all of their hypotheses: nobody has to look a reading up.

use ledger::{Entry, correction_id};
use std::collections::BTreeMap;

/// What the readings of printed statements say, and with which words the corrected statements say it: `-` where it is about words of the
/// printed statement that the correction does not have.
const RESTRICTIONS: &str = include_str!("restrictions.tsv");

/// Names of claims in a text.
fn named(text: &str) -> impl Iterator<Item = &str> {
    let part_of_name = |c: char| c.is_ascii_alphanumeric() || c == '.' || c == '_';
    text.split(move |c: char| !part_of_name(c)).map(|word| word.trim_end_matches('.'))
}

/// What in the statement of an own result leans on a reading: one of its own, or that of a claim that it names.
fn leans(entry: &Entry, readings: &BTreeMap<&str, &str>) -> Vec<String> {
    let texts = || entry.clauses.iter().chain([&entry.statement]);
    let own = entry.reading.iter().map(|reading| format!("{}: has a reading: {reading}", entry.id));
    let others = texts().flat_map(|text| named(text)).filter(|name| readings.contains_key(name));
    let words = texts().flat_map(|text| named(text)).filter(|word| ["read", "reading"].contains(word));
    own.chain(others.chain(words).map(|word| format!("{}: says {word}", entry.id))).collect()
}

/// The lines of the table that the statements do not bear out, and the readings that have no line.
fn unsaid(entries: &[Entry], readings: &BTreeMap<&str, &str>, table: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split('\t').collect()).collect();
    for row in &rows {
        let &[id, restriction, words] = &row[..] else {
            wrong.push(format!("{row:?}: three columns"));
            continue;
        };
        let own = entries.iter().find(|entry| entry.id == correction_id(id));
        let said = own.is_some_and(|own| words == "-" || own.clauses.iter().any(|clause| clause.contains(words)));
        if !said {
            wrong.push(format!("{id}: the statement does not say `{words}`"));
        }
        if !readings.get(id).is_some_and(|reading| reading.contains(restriction)) {
            wrong.push(format!("{id}: the reading does not say `{restriction}`"));
        }
    }
    let corrected = |id: &&str| entries.iter().any(|entry| entry.id == correction_id(id));
    let without = readings.keys().filter(|id| corrected(id) && !rows.iter().any(|row| row[0] == **id));
    wrong.extend(without.map(|id| format!("{id}: its reading has no line")));
    wrong
}

fn readings(entries: &[Entry]) -> BTreeMap<&str, &str> {
    entries.iter().filter_map(|entry| Some((entry.id.as_str(), entry.reading.as_deref()?))).collect()
}

/// All that is wrong with the statements of the own results among these entries.
pub fn incomplete(entries: &[Entry]) -> Vec<String> {
    let readings = readings(entries);
    let own = entries.iter().filter(|entry| entry.id.starts_with("beyond."));
    own.flat_map(|entry| leans(entry, &readings)).chain(unsaid(entries, &readings, RESTRICTIONS)).collect()
}

#[test]
fn what_leans_on_a_reading_is_seen() {
    let ledger = claims::ledger().unwrap();
    let ids: Vec<String> = ["tanner1.Vmono", "beyond.tanner1.Vmono"].map(String::from).to_vec();
    let mut entries = ledger.verify(&ids, &ledger::Options::default(), |_| {}).entries;
    let table = "id\treading\tstatement\ntanner1.Vmono\tFigure 2\tlog |r_ij|²\n";
    let found = |entries: &[Entry], table: &str| {
        let readings = readings(entries);
        let own = entries.iter().find(|entry| entry.id.starts_with("beyond.")).map(|own| leans(own, &readings));
        (own.unwrap_or_default().len(), unsaid(entries, &readings, table).len())
    };
    assert_eq!(found(&entries, table), (0, 0));
    assert_eq!(found(&entries, "id\treading\tstatement\n"), (0, 1), "a reading without a line");
    assert_eq!(found(&entries, &table.replace("log", "exp")), (0, 1), "words that are not there");
    assert_eq!(found(&entries, &table.replace("Figure 2", "Figure 3")), (0, 1), "a reading that is not there");
    assert_eq!(found(&entries, &table.replace("\tlog |r_ij|²", "")), (0, 1), "two columns");
    let own = entries.iter_mut().find(|entry| entry.id.starts_with("beyond.")).unwrap();
    own.reading = Some("the potential of Figure 2".to_string());
    own.clauses[0] = "V, as in tanner1.Vmono, read so.".to_string();
    // The reading, the claim that has one, and a word; and the line of the table that the clause no longer bears out.
    assert_eq!(found(&entries, table), (3, 1));
}
