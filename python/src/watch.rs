//! Long work from Python: without the interpreter, stopped by Ctrl-C within a second, with progress.

use flockproof::arithmetic::Progress;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, mpsc};
use std::time::Duration;

/// How often signals are looked for.
const TICK: Duration = Duration::from_millis(50);
/// Work that has not stopped by then is abandoned.
const PATIENCE: Duration = Duration::from_millis(400);

type Told = (String, u64, Option<u64>);

/// What work is given: it is told to stop here, and tells here how far it is.
#[derive(Default)]
pub struct Watch {
    cancelled: AtomicBool,
    told: Mutex<Option<Told>>,
}

impl Progress for Watch {
    fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    fn tell(&self, stage: &str, done: u64, total: Option<u64>) {
        let mut told = self.told.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        *told = Some((stage.to_string(), done, total));
    }
}

fn broken() -> PyErr {
    PyRuntimeError::new_err("internal error: a computation ended in a panic; please report the call that did it")
}

/// Short work: without the interpreter, on this thread. It cannot be interrupted.
pub fn briefly<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    py.detach(|| catch_unwind(AssertUnwindSafe(work))).map_err(|_| broken())
}

/// Long work, on a thread of its own; this one looks for signals and calls `callback(stage, done, total)`. After a signal, or an
/// exception of the callback, the work is told to stop, and abandoned if it does not.
pub fn watched<T: Send + 'static>(
    py: Python<'_>,
    callback: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Arc<Watch>) -> T + Send + 'static,
) -> PyResult<T> {
    let watch = Arc::new(Watch::default());
    let (sender, receiver) = mpsc::channel();
    let shared = watch.clone();
    std::thread::spawn(move || {
        // The receiver is gone where nobody waits any more.
        let _ = sender.send(catch_unwind(AssertUnwindSafe(|| work(&shared))));
    });
    let receiver = Mutex::new(receiver);
    let wait = |time: Duration| {
        py.detach(|| receiver.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).recv_timeout(time))
    };
    loop {
        match wait(TICK) {
            Ok(result) => {
                tell(callback, &watch)?;
                return result.map_err(|_| broken());
            }
            Err(mpsc::RecvTimeoutError::Disconnected) => return Err(broken()),
            Err(mpsc::RecvTimeoutError::Timeout) => {}
        }
        if let Err(error) = py.check_signals().and_then(|()| tell(callback, &watch)) {
            watch.cancelled.store(true, Ordering::Relaxed);
            // What it reached is not wanted any more.
            let _ = wait(PATIENCE);
            return Err(error);
        }
    }
}

fn tell(callback: Option<&Bound<'_, PyAny>>, watch: &Watch) -> PyResult<()> {
    let told = watch.told.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).take();
    match (callback, told) {
        (Some(callback), Some(told)) => callback.call1(told).map(drop),
        _ => Ok(()),
    }
}
