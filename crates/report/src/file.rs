//! Files as a name with bytes: who calls writes them.

/// A file that is to be written.
#[derive(Debug, Clone)]
pub struct File {
    /// Its name, without a folder.
    pub name: String,
    /// Its contents.
    pub contents: Vec<u8>,
}
