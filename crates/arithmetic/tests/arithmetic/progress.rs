//! Work that is watched and work that is not.

use arithmetic::{Cancelled, Progress, Unwatched};

struct Stop(bool);

impl Progress for Stop {
    fn is_cancelled(&self) -> bool {
        self.0
    }
}

#[test]
fn checkpoints_stop_what_is_cancelled() {
    assert_eq!(Stop(true).checkpoint(), Err(Cancelled));
    assert_eq!(Stop(false).checkpoint(), Ok(()));
    assert_eq!(Unwatched.checkpoint(), Ok(()));
}
