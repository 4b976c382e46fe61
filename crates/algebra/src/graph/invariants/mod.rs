//! Quantities of graphs that a conjecture may name, exact. Each has a naive twin in the tests, over all graphs of up to six vertices.
//!
//! Those that are decided by search (cliques, colourings, cuts, automorphisms) are for small graphs and can be stopped; the others take polynomial time.

mod automorphisms;
mod cliques;
mod connectivity;
mod cuts;
mod directed;
mod distances;
mod matching;
mod planarity;
mod trees;

pub use cliques::LARGEST_SEARCHED;
pub use cuts::LARGEST_CUT;
pub use directed::{is_rooted, period};
pub use distances::distances;
