//! Choices by their names, as the command line and Python give them.

/// A name that no choice has; who asks says which name it was.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there are {known}")]
pub struct UnknownName {
    /// All names.
    pub known: String,
}

/// The choice of a name and how it is spelled, of a table such as [`super::Smoothing::ALL`].
///
/// # Errors
/// [`UnknownName`], with all names.
pub fn named<T: Copy>(all: &[(&'static str, T)], name: &str) -> Result<(&'static str, T), UnknownName> {
    let known = || all.iter().map(|(known, _)| *known).collect::<Vec<_>>().join(", ");
    let found = all.iter().copied().find(|(known, _)| *known == name);
    found.ok_or_else(|| UnknownName { known: known() })
}
