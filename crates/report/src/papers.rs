//! The papers: how they are named and cited.

/// A paper whose claims are checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Paper {
    /// The first part of the ids of its claims.
    pub key: &'static str,
    /// Its authors in a word or two.
    pub short: &'static str,
    pub authors: &'static str,
    pub year: &'static str,
    pub title: &'static str,
    /// Where it appeared.
    pub published: &'static str,
}

impl Paper {
    /// Authors, title, place and year.
    pub fn citation(&self) -> String {
        format!("{}. {}. {}, {}.", self.authors, self.title, self.published, self.year)
    }
}

/// All papers in the order of their keys.
pub(crate) fn papers() -> impl Iterator<Item = Paper> {
    include_str!("papers.tsv").lines().skip(1).filter_map(|line| {
        let [key, short, authors, year, title, published] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        Some(Paper { key, short, authors, year, title, published })
    })
}

/// The paper of that key.
pub(crate) fn paper(key: &str) -> Option<Paper> {
    papers().find(|paper| paper.key == key)
}
