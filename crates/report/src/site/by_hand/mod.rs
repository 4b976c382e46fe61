//! What the pages of errata say beside the claims: which statements are one item, of what kind it is, and how it is seen without the program:
//! a few lines of Python, with what they print. `python/tests/test_by_hand.py` runs them.

/// A file for each paper, named by its key. A section is one item; it begins with `# ID ID ..: what is computed` and lines `# key: text`; what a
/// line prints stands behind it. Sections without a program say what is to be looked at.
const FILES: [(&str, &str); 5] = [
    ("chazelle", include_str!("chazelle.py")),
    ("veerman", include_str!("veerman.py")),
    ("paley", include_str!("paley.py")),
    ("tanner1", include_str!("tanner1.py")),
    ("tanner2", include_str!("tanner2.py")),
];

/// One item of a page of errata. What it does not say is that of its first claim.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Item<'a> {
    /// Ids of the claims that share one error; the first one leads.
    pub ids: Vec<&'a str>,
    /// What the program computes, or what is to be looked at.
    pub what: &'a str,
    /// The kind of error.
    pub kind: Option<&'a str>,
    /// What is correct.
    pub correct: Option<&'a str>,
    /// Where it fails as printed.
    pub fails: Option<&'a str>,
    /// Why.
    pub why: Option<&'a str>,
    /// The program; empty if there is nothing to compute.
    pub code: &'a str,
}

fn item(section: &str) -> Option<Item<'_>> {
    let (first, mut code) = section.split_once('\n').unwrap_or((section, ""));
    let (ids, what) = first.strip_prefix("# ")?.split_once(": ")?;
    let mut item = Item { ids: ids.split(' ').collect(), what, ..Item::default() };
    while let Some((key, text)) = code.strip_prefix("# ").and_then(|rest| rest.lines().next()?.split_once(": ")) {
        *match key {
            "kind" => &mut item.kind,
            "correct" => &mut item.correct,
            "fails" => &mut item.fails,
            "why" => &mut item.why,
            _ => return None,
        } = Some(text);
        code = code.split_once('\n').map_or("", |(_, rest)| rest);
    }
    item.code = code;
    Some(item)
}

/// The items of a paper, in the order of its file.
pub(super) fn items(paper: &str) -> impl Iterator<Item = Item<'static>> {
    let text = FILES.into_iter().find(|(key, _)| *key == paper).map_or("", |(_, text)| text);
    text.trim().split("\n\n").filter_map(item)
}

#[cfg(test)]
mod tests {
    use super::{FILES, Item, items};
    use crate::site::errata::KINDS;
    use ledger::recorded;

    /// Every statement that fails is in one item, nothing else but what is open is named, and each page can be read by itself.
    #[test]
    fn errata_are_whole_and_stand_alone() {
        let sections: usize = FILES.iter().map(|(_, text)| text.trim().split("\n\n").count()).sum();
        let all: Vec<Item> = FILES.iter().flat_map(|(key, _)| items(key)).collect();
        assert_eq!(all.len(), sections, "a section cannot be read");
        let claims = claims::ledger().expect("the claims");
        let mut named: Vec<&str> = all.iter().flat_map(|item| &item.ids).copied().collect();
        named.sort_unstable();
        let rows: Vec<_> = recorded(claims::RECORDED).collect();
        let failing = rows.iter().filter(|row| row.fault != "-").map(|row| row.id);
        let open = all.iter().filter(|item| item.kind == Some("open")).flat_map(|item| item.ids.clone());
        let mut expected: Vec<&str> = failing.chain(open).collect();
        expected.sort_unstable();
        assert_eq!(named, expected);
        for item in &all {
            let id = item.ids[0];
            assert!(item.kind.is_none_or(|kind| KINDS.iter().any(|known| known.key == kind)), "{id}");
            let why = item.why.or_else(|| claims.derivation(id)).unwrap_or_default();
            assert!(!why.is_empty() && !item.what.is_empty(), "{id}");
            for text in [Some(why), item.correct, item.fails, Some(item.what)].into_iter().flatten() {
                assert!(
                    ["notes/", "beyond.", "flockproof", "`"].iter().all(|word| !text.contains(word)),
                    "{id}: {text}"
                );
            }
            let printed = item.code.lines().any(|line| line.starts_with("print(") && line.contains("  # "));
            assert!(item.code.is_empty() || printed, "{id}");
        }
    }
}
