//! In the altered copy only: which alteration is switched on, by the environment variable `ALTERED`: a number, or `record`, which
//! writes the number of each alteration that is reached, once, to the file `ALTERED_LOG`.

use std::io::Write;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};

const RECORD: u32 = u32::MAX - 1;
const UNKNOWN: u32 = u32::MAX;

static ACTIVE: AtomicU32 = AtomicU32::new(UNKNOWN);
static SEEN: [AtomicBool; 1 << 16] = [const { AtomicBool::new(false) }; 1 << 16];
static LOG: Mutex<()> = Mutex::new(());

/// Whether alteration `k` is switched on.
#[inline]
pub fn at(k: u32) -> bool {
    let active = ACTIVE.load(Relaxed);
    if active < RECORD { active == k } else { slow(k) }
}

#[cold]
#[inline(never)]
fn slow(k: u32) -> bool {
    if ACTIVE.load(Relaxed) == UNKNOWN {
        let active = match std::env::var("ALTERED") {
            Ok(word) if word == "record" => RECORD,
            Ok(word) => word.parse().unwrap_or(0),
            Err(_) => 0,
        };
        ACTIVE.store(active, Relaxed);
        return at(k);
    }
    if !SEEN[k as usize].load(Relaxed) && !SEEN[k as usize].swap(true, Relaxed) {
        let _one_at_a_time = LOG.lock();
        if let Some(path) = std::env::var_os("ALTERED_LOG") {
            let file = std::fs::OpenOptions::new().create(true).append(true).open(path);
            let _ = file.and_then(|mut file| writeln!(file, "{k}"));
        }
    }
    false
}
