//! Ctrl-C and SIGTERM: the first asks the work to stop and keeps what is finished, a later one ends the program at once.

use flockproof::arithmetic::Progress;
use indicatif::ProgressBar;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError, mpsc};
use std::time::{Duration, Instant};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static WATCHED: AtomicBool = AtomicBool::new(false);
/// Whether what was reached is being written; held by whoever gives the work up, so that nobody else writes the same.
static FINISHING: Mutex<bool> = Mutex::new(false);

/// Exit status of an interrupted run.
pub const STATUS: u8 = 130;

/// Work that has not stopped by then is abandoned.
const PATIENCE: Duration = Duration::from_millis(900);

/// Starts listening. Until the first [`Watch`] is made there is nothing to keep, and a signal ends the program at once.
///
/// The second signal counts only a second after the first: some programs send two at once.
pub fn listen() {
    static FIRST: OnceLock<Instant> = OnceLock::new();
    let _ = ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            if FIRST.get().is_some_and(|first| first.elapsed() > Duration::from_secs(1)) {
                std::process::exit(i32::from(STATUS));
            }
            return;
        }
        if !WATCHED.load(Ordering::Relaxed) {
            std::process::exit(i32::from(STATUS));
        }
        let _ = FIRST.set(Instant::now());
        eprintln!("stopping; again to quit at once");
        std::thread::spawn(|| {
            std::thread::sleep(PATIENCE);
            let finishing = is_finishing();
            if !*finishing {
                eprintln!("stopped in the middle of a computation");
                let last = LAST.lock().ok().and_then(|mut last| last.take());
                if let Some(last) = last {
                    last();
                }
                if let Ok(kept) = KEPT.lock() {
                    let _ = super::output::print(&kept);
                }
                std::process::exit(i32::from(STATUS));
            }
        });
    });
}

fn is_finishing() -> MutexGuard<'static, bool> {
    FINISHING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What is done where work is given up in the middle.
static LAST: Mutex<Option<Box<dyn FnOnce() + Send>>> = Mutex::new(None);

/// What is to be done where work is given up in the middle: to write what others can see of it.
pub fn at_last(write: impl FnOnce() + Send + 'static) {
    if let Ok(mut last) = LAST.lock() {
        *last = Some(Box::new(write));
    }
}

/// What was found and is printed only at the end.
static KEPT: Mutex<String> = Mutex::new(String::new());

/// Keeps a text that is printed at the end, so that it is printed even where work is given up in the middle.
pub fn keep(text: &str) {
    if let Ok(mut kept) = KEPT.lock() {
        kept.push_str(text);
    }
}

/// All that was kept, which is then no longer kept.
pub fn kept() -> String {
    KEPT.lock().map(|mut kept| std::mem::take(&mut *kept)).unwrap_or_default()
}

/// Whether a signal has come.
pub fn happened() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// The work is over and what it reached is being written: a signal no longer cuts it short.
pub fn finishing() {
    *is_finishing() = true;
}

/// What was to be written is there, and work goes on that a signal may cut short again.
pub fn working() {
    *is_finishing() = false;
}

/// What long work of the command line is given: it stops on a signal and moves a progress bar.
#[derive(Clone)]
pub struct Watch {
    bar: ProgressBar,
    stopped: Arc<AtomicBool>,
}

impl Watch {
    /// With a bar that shows how far the work is.
    pub fn with(bar: ProgressBar) -> Self {
        WATCHED.store(true, Ordering::Relaxed);
        Watch { bar, stopped: Arc::default() }
    }

    /// The bar.
    pub fn bar(&self) -> &ProgressBar {
        &self.bar
    }

    /// Stops the work as a signal does: what it finds can no longer be written.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// For work that runs on threads of its own.
    pub fn shared(&self) -> Arc<Self> {
        Arc::new(self.clone())
    }
}

/// How often waiting asks whether a signal has come.
const TICK: Duration = Duration::from_millis(50);

/// What work on a thread of its own sends, one result after the other; after a signal what was sent before it, and no more. For work
/// in pieces that do not ask whether to stop.
pub fn results<T: Send + 'static>(work: impl FnOnce(mpsc::Sender<T>) + Send + 'static) -> impl Iterator<Item = T> {
    WATCHED.store(true, Ordering::Relaxed);
    let (sender, receiver) = mpsc::channel();
    let mut worker = Some(std::thread::spawn(move || work(sender)));
    std::iter::from_fn(move || {
        loop {
            if happened() {
                return receiver.try_recv().ok();
            }
            match receiver.recv_timeout(TICK) {
                Ok(result) => return Some(result),
                Err(mpsc::RecvTimeoutError::Timeout) => {}
                // All is sent, or the work panicked: then so does this thread.
                Err(mpsc::RecvTimeoutError::Disconnected) => {
                    let panicked = worker.take().and_then(|worker| worker.join().err());
                    if let Some(panic) = panicked {
                        std::panic::resume_unwind(panic);
                    }
                    return None;
                }
            }
        }
    })
}

/// The exit status of work that a signal may have cut short.
pub fn status(complete: bool) -> ExitCode {
    if complete { ExitCode::SUCCESS } else { ExitCode::from(STATUS) }
}

impl Progress for Watch {
    fn is_cancelled(&self) -> bool {
        happened() || self.stopped.load(Ordering::Relaxed)
    }

    fn tell(&self, stage: &str, done: u64, total: Option<u64>) {
        if let Some(total) = total {
            self.bar.set_length(total);
        }
        self.bar.set_message(stage.to_string());
        self.bar.set_position(done);
    }
}
