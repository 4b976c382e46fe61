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

/// Does long work with many small parts that are shared out, as a whole on one of the threads: from any other thread, each time that parts are
/// shared out one has to be woken and waited for, which takes as long as a few hundred agents.
pub fn on_a_thread<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    rayon::scope(|_| work())
}

fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}
