//! Loops on all threads of the caller's pool. What starts and joins the threads is compiled once, not for each loop.

use rayon::prelude::*;
use std::sync::OnceLock;

/// What `of` gives for `0..count`, in this order, whatever the number of threads.
pub(crate) fn map<R: Send + Sync>(count: usize, of: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let places: Vec<OnceLock<R>> = (0..count).map(|_| OnceLock::new()).collect();
    each(count, &|k| {
        places[k].get_or_init(|| of(k));
    });
    places.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// What `of` gives for parts of `size` items, the last of which may be shorter.
pub(crate) fn map_chunks<T: Sync, R: Send + Sync>(items: &[T], size: usize, of: impl Fn(&[T]) -> R + Sync) -> Vec<R> {
    map(items.len().div_ceil(size), |k| of(&items[k * size..items.len().min((k + 1) * size)]))
}

fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}
