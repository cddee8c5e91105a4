//! A file that the window keeps for the next start: read with suspicion, written whole or not at all, and
//! never replaced if it cannot be read.

use std::io::Write as _;
use std::path::PathBuf;

use gamow_platform::files;

use crate::files::whole::write_whole;

/// At most this many old versions are kept aside; then the last one makes room.
const MOST_ASIDE: u32 = 9;

/// A file of a text.
#[derive(Debug)]
pub struct KeptFile {
    path: PathBuf,
    /// The text that is in it, as far as this window knows.
    known: Option<String>,
    /// The reason why it must not be replaced: it cannot be read, and could not be moved aside.
    untouchable: Option<String>,
}

impl KeptFile {
    /// The file at `path`.
    pub const fn new(path: PathBuf) -> Self {
        Self { path, known: None, untouchable: None }
    }

    /// Returns the path of the file, as messages show it.
    pub fn shown(&self) -> String {
        files::shown(&self.path)
    }

    /// Reads its text; `None` if there is no such file.
    ///
    /// # Errors
    /// The reason why it cannot be read.
    pub fn read(&mut self) -> Result<Option<String>, String> {
        use std::io::ErrorKind::{NotADirectory, NotFound};
        self.untouchable = None;
        self.known = match files::read_to_string(&self.path) {
            Ok(text) => Some(text),
            Err(error) if matches!(error.kind(), NotFound | NotADirectory) => None,
            Err(error) => return Err(format!("the file cannot be read ({error})")),
        };
        Ok(self.known.clone())
    }

    /// Moves the file aside, so that another can take its place, and returns a sentence with its new path.
    pub fn set_aside(&mut self) -> String {
        let aside = self.free_name();
        self.known = None;
        match files::rename(&self.path, &aside) {
            Ok(()) => format!("The old file is kept as {}.", files::shown(&aside)),
            Err(error) => {
                let reason = format!("it cannot be moved aside ({error})");
                let text = format!("{} stays as it is: {reason}.", self.shown());
                self.untouchable = Some(reason);
                text
            }
        }
    }

    /// A name under which the file can be kept aside.
    fn free_name(&self) -> PathBuf {
        let ending = self.path.extension().unwrap_or_default().to_string_lossy();
        let named = |number: u32| self.path.with_extension(format!("{ending}.old{number}"));
        (1..MOST_ASIDE).map(named).find(|path| !files::is_there(path)).unwrap_or_else(|| named(MOST_ASIDE))
    }

    /// Returns whether `text` is in it, as far as this window knows.
    pub fn holds(&self, text: &str) -> bool {
        self.known.as_deref() == Some(text)
    }

    /// Returns whether another window or program has written something else than `text` there since this
    /// window read or wrote it.
    pub fn was_changed(&self, text: &str) -> bool {
        let there = files::read_to_string(&self.path).ok();
        files::is_there(&self.path) && there != self.known && there.as_deref() != Some(text)
    }

    /// Writes `text`, unless this window has left it there already.
    ///
    /// # Errors
    /// The path and the reason why it is not written. The file is then as it was.
    pub fn write(&mut self, text: &str) -> Result<(), String> {
        if let Some(reason) = &self.untouchable {
            return Err(format!("{}: {reason}", self.shown()));
        }
        if self.holds(text) {
            return Ok(());
        }
        let folder = files::folder_of(&self.path);
        let written =
            files::create_folder(folder).map_err(|error| format!("{}: {error}", files::shown(folder)));
        written.and_then(|()| {
            write_whole(&self.path, |file| Ok(file.write_all(text.as_bytes())?))
                .map_err(|error| format!("{error:#}"))
        })?;
        self.known = Some(text.to_owned());
        Ok(())
    }
}
