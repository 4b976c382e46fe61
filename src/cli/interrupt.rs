//! Ctrl-C and SIGTERM: the first asks the work to stop and keeps what is finished, a later one ends the program at once.

use flockproof::arithmetic::Progress;
use indicatif::ProgressBar;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static FINISHING: AtomicBool = AtomicBool::new(false);

/// Exit status of an interrupted run.
pub const STATUS: u8 = 130;

/// Work that has not stopped by then is abandoned.
const PATIENCE: Duration = Duration::from_millis(900);

/// Starts listening, for commands that have something to keep. Without a handler a signal simply ends the program.
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
        let _ = FIRST.set(Instant::now());
        eprintln!("stopping; again to quit at once");
        std::thread::spawn(|| {
            std::thread::sleep(PATIENCE);
            if !FINISHING.load(Ordering::Relaxed) {
                eprintln!("stopped in the middle of a computation");
                std::process::exit(i32::from(STATUS));
            }
        });
    });
}

/// Whether a signal has come.
pub fn happened() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// The work is over and what it reached is being written: a signal no longer cuts it short.
pub fn finishing() {
    FINISHING.store(true, Ordering::Relaxed);
}

/// What long work of the command line is given: it stops on a signal and moves a progress bar.
#[derive(Clone)]
pub struct Watch {
    bar: ProgressBar,
}

impl Watch {
    /// With a bar that shows how far the work is.
    pub fn with(bar: ProgressBar) -> Self {
        Watch { bar }
    }

    /// Without a bar.
    pub fn silent() -> Self {
        Watch { bar: ProgressBar::hidden() }
    }

    /// For work that runs on threads of its own.
    pub fn shared(&self) -> Arc<Self> {
        Arc::new(self.clone())
    }
}

impl Progress for Watch {
    fn is_cancelled(&self) -> bool {
        happened()
    }

    fn tell(&self, stage: &str, done: u64, total: Option<u64>) {
        if let Some(total) = total {
            self.bar.set_length(total);
        }
        self.bar.set_message(stage.to_string());
        self.bar.set_position(done);
    }
}
