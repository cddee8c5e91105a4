//! Output files in a browser: downloads, and texts that it keeps.

use std::io::Cursor;
use std::path::Path;

use anyhow::Context as _;
use gamow_platform::files;

use crate::files::watched::{Named, write_named};

/// Hands `write` a buffer that becomes the file at `path` once all is written.
///
/// # Errors
///
/// Those of `write`, and of the browser; the file is then as it was.
pub fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut Named<Cursor<Vec<u8>>>) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let name = || files::shown(path);
    let bytes = write_named(Cursor::new(Vec::new()), name, write)?.into_inner();
    files::deliver(path, bytes).with_context(name)
}
