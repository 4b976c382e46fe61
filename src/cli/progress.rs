//! The progress bar: on standard error, on a terminal only, and only of work that takes longer than two seconds.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::Duration;

/// Shorter work shows no bar.
const PATIENCE: Duration = Duration::from_secs(2);

/// A bar that shows how many steps are done; how many there are is told with the first.
pub fn bar() -> ProgressBar {
    styled("{wide_bar} {pos}/{len} {msg}, {eta} left")
}

/// What is being done, where nobody knows how long it takes.
pub fn spinner(what: &str) -> ProgressBar {
    let bar = styled("{spinner} {msg}, {elapsed}");
    bar.set_message(what.to_string());
    bar
}

/// A bar in a template of indicatif.
pub fn styled(template: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    if std::io::stderr().is_terminal() {
        let late = bar.clone();
        std::thread::spawn(move || {
            std::thread::sleep(PATIENCE);
            if !late.is_finished() {
                late.set_draw_target(ProgressDrawTarget::stderr());
                late.enable_steady_tick(Duration::from_millis(200));
            }
        });
    }
    bar
}
