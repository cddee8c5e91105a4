//! The provenance of a picture or a file of measurements: it is written into the file, and read back.

/// Name and version of the program.
pub const SOFTWARE: &str = concat!("gamow ", env!("CARGO_PKG_VERSION"));

/// The keyword of the text in a PNG file that holds [`Provenance::parameters`].
const PARAMETERS: &str = "Parameters";
/// The keyword of the one that holds [`Provenance::scene_fingerprint`].
const SCENE_FINGERPRINT: &str = "Scene-Fingerprint";
/// The keyword of the one that holds [`Provenance::models`].
const MODELS: &str = "Models";

/// The provenance of a picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    /// Name of the scene.
    pub title: String,
    /// A command line that makes the picture again.
    pub parameters: String,
    /// Fingerprint of the scene's content: whether the scene file is still the same.
    pub scene_fingerprint: String,
    /// Reports on the scene's models, a line each; empty without any.
    pub models: String,
}

impl Provenance {
    /// Keywords and texts for a PNG file.
    #[must_use]
    pub fn texts(&self) -> Vec<(&'static str, &str)> {
        let mut texts = vec![
            ("Title", &*self.title),
            (PARAMETERS, &self.parameters),
            (SCENE_FINGERPRINT, &self.scene_fingerprint),
        ];
        texts.extend((!self.models.is_empty()).then_some((MODELS, &*self.models)));
        texts
    }

    /// The comments of an EXR file.
    #[must_use]
    pub fn comments(&self) -> String {
        let comments = [&self.parameters, FINGERPRINT_LINE, &self.scene_fingerprint].concat();
        if self.models.is_empty() { comments } else { [&comments, "\n", &self.models].concat() }
    }
}

/// Separator between the command and the fingerprint in the comments of an EXR file.
const FINGERPRINT_LINE: &str = "\nScene-Fingerprint ";

/// Returns the command in the comments of an EXR file.
#[must_use]
pub fn command_in_comments(comments: &str) -> &str {
    comments.rsplit_once(FINGERPRINT_LINE).map_or(comments, |(command, _)| command)
}

/// Returns the command in the texts of a PNG file; empty if none of them is ours.
#[must_use]
pub fn command_in_texts(texts: &[(String, String)]) -> &str {
    texts.iter().find(|(keyword, _)| keyword == PARAMETERS).map_or("", |(_, command)| command)
}
