//! How a picture or a file of measurements was made: what is written into it, and what is read back.

use std::collections::BTreeMap;

use relativity_render::Gaze;

use crate::flags::choices::GazeChoice;
use crate::flags::words::words;

/// Program and version.
pub const SOFTWARE: &str = concat!("gamow ", env!("CARGO_PKG_VERSION"));

/// The keyword of the text in a PNG file that holds [`Provenance::parameters`].
const PARAMETERS: &str = "Parameters";
/// The keyword of the one that holds [`Provenance::scene_fingerprint`].
const SCENE_FINGERPRINT: &str = "Scene-Fingerprint";

/// Where a picture comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    /// Name of the scene.
    pub title: String,
    /// A command line that makes the picture again.
    pub parameters: String,
    /// Fingerprint of the scene's content: whether the scene file is still the same.
    pub scene_fingerprint: String,
}

impl Provenance {
    /// Keywords and texts for a PNG file.
    #[must_use]
    pub fn texts(&self) -> [(&'static str, &str); 3] {
        [("Title", &self.title), (PARAMETERS, &self.parameters), (SCENE_FINGERPRINT, &self.scene_fingerprint)]
    }

    /// The comments of an EXR file.
    #[must_use]
    pub fn comments(&self) -> String {
        [&self.parameters, FINGERPRINT_LINE, &self.scene_fingerprint].concat()
    }
}

/// What parts the command from the fingerprint in the comments of an EXR file.
const FINGERPRINT_LINE: &str = "\nScene-Fingerprint ";

/// How a file was made, as it records it.
#[derive(Debug, Clone, Default)]
pub struct Recorded {
    /// The command line.
    pub command: String,
    flags: BTreeMap<String, String>,
}

impl Recorded {
    fn new(command: &str) -> Self {
        let flag = |word: String| {
            let (name, value) = word.strip_prefix("--")?.split_once('=')?;
            Some((name.to_owned(), value.to_owned()))
        };
        Self { command: command.to_owned(), flags: words(command).into_iter().filter_map(flag).collect() }
    }

    /// What the comments of an EXR file tell.
    #[must_use]
    pub fn in_comments(comments: &str) -> Self {
        Self::new(comments.rsplit_once(FINGERPRINT_LINE).map_or(comments, |(command, _)| command))
    }

    /// What the texts of a PNG file tell; nothing if there are none of ours.
    #[must_use]
    pub fn in_texts(texts: &[(String, String)]) -> Self {
        let parameters = texts.iter().find(|(keyword, _)| keyword == PARAMETERS);
        parameters.map(|(_, text)| Self::new(text)).unwrap_or_default()
    }

    /// The value of the flag `name`.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        self.flags.get(name).map(String::as_str)
    }

    /// The number that the flag `name` has as its value.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.text(name)?.parse().ok()
    }

    /// Where both eyes looked.
    #[must_use]
    pub fn gaze(&self) -> Option<Gaze> {
        self.text("gaze")?.parse::<GazeChoice>().ok()?.fixed()
    }
}
