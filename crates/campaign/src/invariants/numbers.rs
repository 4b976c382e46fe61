//! To come.

use super::Invariant;

pub(super) const TABLE: &[Invariant] = &[];
