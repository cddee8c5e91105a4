//! The answer of a file dialog.

use std::path::PathBuf;

/// The answer of a dialog.
pub enum DialogAnswer {
    /// A file was chosen.
    Path(PathBuf),
    /// The dialog was closed.
    None,
    /// There is no dialog.
    #[cfg_attr(not(feature = "desktop"), expect(dead_code, reason = "browsers have one"))]
    NoDialog,
}
