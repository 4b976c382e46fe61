//! Generators as strategies of proptest, which then shrinks the list of draws.

use crate::draws::Draws;
use proptest::strategy::Strategy;
use std::fmt::Debug;

/// What a generator makes of at most `most` random draws.
///
/// ```
/// # use flockproof_campaign::strategies::{proptest::strategy, stochastic};
/// let matrices = strategy(60, |draws| stochastic(draws, 3, 3, 8));
/// # fn is_a_strategy(_: impl ::proptest::strategy::Strategy) {}
/// # is_a_strategy(matrices);
/// ```
pub fn strategy<T: Debug>(most: usize, make: impl Fn(&mut Draws) -> T) -> impl Strategy<Value = T> {
    proptest::collection::vec(proptest::num::u64::ANY, most).prop_map(move |list| make(&mut Draws::given(&list)))
}
