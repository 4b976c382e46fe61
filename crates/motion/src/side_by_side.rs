//! Independent pieces of work on all threads.

use rayon::prelude::*;
use std::sync::OnceLock;

/// What `of` gives for each item, in their order, whatever the number of threads. The threads are started and joined by code that is compiled once,
/// not for each kind of item.
pub fn side_by_side<T: Sync, R: Send + Sync>(items: &[T], of: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let places: Vec<OnceLock<R>> = items.iter().map(|_| OnceLock::new()).collect();
    each(items.len(), &|k| {
        places[k].get_or_init(|| of(&items[k]));
    });
    places.into_iter().filter_map(OnceLock::into_inner).collect()
}

fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}
