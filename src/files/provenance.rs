//! How a picture or a file of measurements was made: what is written into it, and what is read back.

use std::collections::BTreeMap;

use relativity_render::Gaze;

use crate::flags::choices::GazeChoice;

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
        format!("{}\n{SCENE_FINGERPRINT} {}", self.parameters, self.scene_fingerprint)
    }
}

/// The flags of `gamow render` that made a picture, as its text records them.
#[derive(Debug, Clone, Default)]
pub struct Recorded(BTreeMap<String, String>);

impl Recorded {
    /// The flags in a text that begins with a command line.
    #[must_use]
    pub fn new(parameters: &str) -> Self {
        let flag = |word: &str| {
            let (name, value) = word.strip_prefix("--")?.split_once('=')?;
            Some((name.to_owned(), value.to_owned()))
        };
        Self(parameters.split_whitespace().filter_map(flag).collect())
    }

    /// The flags in the texts of a PNG file; none if they do not tell.
    #[must_use]
    pub fn in_texts(texts: &[(String, String)]) -> Self {
        let parameters = texts.iter().find(|(keyword, _)| keyword == PARAMETERS);
        parameters.map(|(_, text)| Self::new(text)).unwrap_or_default()
    }

    /// The value of the flag `name`.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(String::as_str)
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
