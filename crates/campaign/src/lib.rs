//! Campaigns: many independent cases, in shards that can be killed, resumed and merged; the built-in invariants with their generators.
//!
//! | module | what it answers |
//! |---|---|
//! | [`job`] | what a campaign is: a canonical text and a number of cases, each of which gives one JSON value |
//! | [`store`] | how cases are spread over processes and machines, and put together again |
//! | [`draws`] | where random choices come from, and how a case is made simpler |
//! | [`strategies`] | generators of matrices, graphs, flocks, states and numbers |
//! | [`invariants`] | the table of what must always be true |
//! | [`fuzz`] | campaigns over the invariants and over questions of one's own, and their summary |
//! | [`sweep`] | tables of quantities over the family of a question |
//! | [`ensemble`] | many runs of one scenario, and their statistics |
//!
//! ```
//! use flockproof_campaign::fuzz::one_case;
//! use flockproof_campaign::invariants::{self, Checked, Stop, Tested};
//!
//! // Something that must always be true, in ten random cases; a planted fault is found in one of them.
//! let invariant = invariants::table().next().unwrap();
//! let all = |tested| (0..10).map(|case| one_case(invariant, "my seed", case, tested).0).collect::<Vec<Checked>>();
//! assert!(all(Tested::AsItIs).iter().all(|checked| checked.is_ok()));
//! assert!(all(Tested::Altered).iter().any(|checked| matches!(checked, Err(Stop::Fails { .. }))));
//! ```

pub mod draws;
pub mod ensemble;
pub mod fuzz;
pub mod invariants;
pub mod job;
pub mod store;
pub mod strategies;
pub mod sweep;

/// The version that results belong to.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
