//! How far a command has come, on a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of so many `steps`, called `things`: on standard error, and only if that is a terminal.
#[must_use]
pub fn bar(steps: u64, things: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {things}, {{eta}} left"));
    ProgressBar::new(steps).with_style(style.expect("the template is well formed"))
}
