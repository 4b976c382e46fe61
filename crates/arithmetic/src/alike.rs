//! What may be meant where a name is not known: of the names of formulas, which are short, the one with the fewest other letters; of ids
//! those that begin with it, hold it or are spelled alike.

/// The known name with the least number of letters inserted, left out or changed, the first of several; capitals count for nothing. None
/// where more than a third of the letters and one would have to change.
pub fn nearest_name<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    if name.len() > 64 {
        return None;
    }
    let name = name.to_lowercase();
    let changes = |other: &str| strsim::levenshtein(&name, &other.to_lowercase());
    let (least, near) = known.into_iter().map(|other| (changes(other), other)).min_by_key(|(changes, _)| *changes)?;
    (least <= 1 + name.chars().count() / 3).then(|| near.to_string())
}

/// The ids closest to one that is not there, the closest first, at most `most`: those that begin with it, those that hold it, those
/// that are spelled alike.
pub fn nearest_ids<'a>(ids: impl Iterator<Item = &'a str>, wrong: &str, most: usize) -> Vec<&'a str> {
    /// Spelled less alike than this they are others.
    const ALIKE: f64 = 0.75;
    let wrong = wrong.to_lowercase();
    let likeness = |id: &str| {
        let id = id.to_lowercase();
        let whole = strsim::jaro_winkler(&id, &wrong);
        let short = id.split_once('.').map_or(0.0, |(_, rest)| strsim::jaro_winkler(rest, &wrong));
        match (id.starts_with(&wrong), id.contains(&wrong)) {
            (true, _) => 3.0 + whole,
            (_, true) => 2.0 + whole,
            _ => whole.max(short),
        }
    };
    let mut close: Vec<(f64, &str)> = ids.map(|id| (likeness(id), id)).filter(|(like, _)| *like >= ALIKE).collect();
    close.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    let best = close.first().map_or(0.0, |(like, _)| *like);
    // Beside those that begin with it, or are far closer, the others say nothing.
    close
        .into_iter()
        .filter(|(like, _)| if best < 2.0 { *like >= best - 0.1 } else { *like >= 2.0 })
        .map(|(_, id)| id)
        .take(most)
        .collect()
}
