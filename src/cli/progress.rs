//! The progress bar: on standard error, and only on a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// A bar that shows how many steps are done; how many there are is told with the first.
pub fn bar() -> ProgressBar {
    styled("{bar:30} {pos}/{len} {msg}")
}

/// A bar in a template of indicatif.
pub fn styled(template: &str) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar
}
