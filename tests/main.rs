//! The program as a user meets it, and what its documents say of it.

mod cli;
mod documents;
