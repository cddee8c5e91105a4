//! Progress of a command, on a terminal.

pub use indicatif::ProgressBar;
use indicatif::ProgressStyle;

/// Returns a bar of `steps` steps, called `things`: on standard error, and only if that is a terminal.
#[must_use]
#[expect(clippy::missing_panics_doc, reason = "the template is well formed")]
pub fn bar(steps: u64, things: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {prefix}, {eta} left{msg}");
    ProgressBar::new(steps).with_style(style.expect("the template is well formed")).with_prefix(things)
}
