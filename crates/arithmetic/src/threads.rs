//! Independent pieces of work on all threads of the caller's pool.

use rayon::prelude::*;
use std::hint::spin_loop;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

/// Looks at whether work is over before other programs are let in.
const LOOKS: usize = 64;

/// What `of` gives for `0..count`, in this order, whatever the number of threads. The threads are started and joined by code that is compiled once,
/// not for each kind of work.
pub fn map<R: Send + Sync>(count: usize, of: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let places: Vec<OnceLock<R>> = (0..count).map(|_| OnceLock::new()).collect();
    each(count, &|k| {
        places[k].get_or_init(|| of(k));
    });
    places.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// What `of` gives for each item, in their order.
pub fn side_by_side<T: Sync, R: Send + Sync>(items: &[T], of: impl Fn(&T) -> R + Sync) -> Vec<R> {
    map(items.len(), |k| of(&items[k]))
}

/// What `of` gives for parts of `size` items, the last of which may be shorter.
pub fn map_chunks<T: Sync, R: Send + Sync>(items: &[T], size: usize, of: impl Fn(&[T]) -> R + Sync) -> Vec<R> {
    map(items.len().div_ceil(size), |k| of(&items[k * size..items.len().min((k + 1) * size)]))
}

/// Does long work with many small parts that are shared out, as a whole on one of the threads: from any other thread, each time that parts are
/// shared out one has to be woken and waited for, which takes as long as a few hundred agents.
pub fn on_a_thread<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    rayon::scope(|_| work())
}

/// Does work that one thread can do and that is over soon, after which parts are shared out. Another thread, if one is free, stays awake
/// meanwhile: to wake it takes as long as a few hundred agents.
pub fn while_one_waits<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    let over = AtomicBool::new(false);
    let watched = || {
        let _end = Over(&over);
        work()
    };
    rayon::join(watched, || wait(&over)).0
}

/// Says that the work is over, even if it ends by a panic.
struct Over<'a>(&'a AtomicBool);

impl Drop for Over<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
    }
}

fn wait(over: &AtomicBool) {
    // Some microseconds at a time, before other programs are let in.
    while !over.load(Ordering::Acquire) {
        (0..LOOKS).take_while(|_| !over.load(Ordering::Acquire)).for_each(|_| spin_loop());
        std::thread::yield_now();
    }
}

fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}
