//! Messages to the user about the last thing that was done, or could not be.

use gamow_platform::{files, messages};

use std::path::Path;

/// A message. It stays until it is closed or another takes its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    /// A sentence or a few.
    pub text: String,
    /// Whether something could not be done.
    pub is_error: bool,
    /// The file that it is about, with its folder, which the text leaves out.
    pub path: Option<String>,
}

impl Notice {
    /// Returns a message that something was done.
    pub fn done(text: impl Into<String>) -> Self {
        Self { text: messages::in_short(&messages::shown(&text.into())), is_error: false, path: None }
    }

    /// Returns a message that something could not be done, with the reason.
    #[expect(clippy::needless_pass_by_value, reason = "errors are given away as they are")]
    pub fn error(error: impl ToString) -> Self {
        Self { is_error: true, ..Self::done(error.to_string()) }
    }

    /// Returns the message with the file at `path` as its subject: files beside that are called by their
    /// names alone.
    #[must_use]
    pub fn about(self, path: &Path) -> Self {
        let folder = path.parent().filter(|folder| folder.file_name().is_some());
        let Some(folder) = folder.and_then(Path::to_str) else { return self };
        let text = self.text.replace(&format!("{folder}{}", std::path::MAIN_SEPARATOR), "");
        Self { text, path: Some(files::shown(path)), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_calls_files_by_their_names() {
        let path = Path::new("/home/somebody/scenes/balls.toml");
        let notice =
            Notice::error("/home/somebody/scenes/balls.toml:7: radius = -1 must be above 0").about(path);
        assert_eq!(notice.text, "balls.toml:7: radius = -1 must be above 0");
        assert_eq!(notice.path.as_deref(), path.to_str());
        for path in ["balls.toml", "/balls.toml", ""] {
            let notice = Notice::error("1 / 2 of /balls.toml").about(Path::new(path));
            assert_eq!(notice.text, "1 / 2 of /balls.toml");
        }
    }
}
