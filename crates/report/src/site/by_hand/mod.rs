//! Errata checked without the program: for each a few lines of Python, with what they print. `python/tests/test_by_hand.py` runs them.

/// A file for each paper. A section begins with `# ID: what is computed`; what a line prints stands behind it.
const FILES: [&str; 5] = [
    include_str!("chazelle.py"),
    include_str!("veerman.py"),
    include_str!("paley.py"),
    include_str!("tanner1.py"),
    include_str!("tanner2.py"),
];

/// The few lines that show one erratum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ByHand<'a> {
    /// Id of the claim.
    pub id: &'a str,
    /// What is computed.
    pub what: &'a str,
    /// The program.
    pub code: &'a str,
}

/// All sections of a text.
fn sections(text: &str) -> impl Iterator<Item = ByHand<'_>> {
    text.split("\n\n").filter_map(|section| {
        let (first, code) = section.trim().split_once('\n')?;
        let (id, what) = first.strip_prefix("# ")?.split_once(": ")?;
        Some(ByHand { id, what, code })
    })
}

/// How a statement is checked by hand, if it is.
pub(super) fn by_hand(id: &str) -> Option<ByHand<'static>> {
    FILES.into_iter().flat_map(sections).find(|section| section.id == id)
}

#[cfg(test)]
mod tests {
    use super::{FILES, sections};
    use ledger::recorded;

    /// Every statement that is false, slips or lacks a hypothesis can be checked by hand; nothing else is named, and nothing twice.
    #[test]
    fn errata_are_checked_by_hand() {
        let all: Vec<_> = FILES.into_iter().flat_map(sections).collect();
        let rows: Vec<_> = recorded(claims::RECORDED).collect();
        let fault = |id: &str| rows.iter().find(|row| row.id == id).map_or("-", |row| row.fault);
        for (k, section) in all.iter().enumerate() {
            assert_ne!(fault(section.id), "-", "{}", section.id);
            assert!(all[..k].iter().all(|other| other.id != section.id), "{} twice", section.id);
            assert!(
                section.code.lines().any(|line| line.starts_with("print(") && line.contains("  # ")),
                "{}",
                section.id
            );
            assert!(section.code.lines().all(|line| !line.is_empty()), "{}", section.id);
        }
        for row in rows.iter().filter(|row| ["false", "slip", "hypothesis"].contains(&row.fault)) {
            assert!(all.iter().any(|section| section.id == row.id), "{} is not checked by hand", row.id);
        }
    }
}
