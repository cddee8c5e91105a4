//! Settings as a link: one line of text that a message, a worksheet or, in a browser, an address can carry.
//! It can be read: `gamow:?beta=0.99&scene=globe` names the settings that differ from the defaults, as flags
//! have them.

use std::path::Path;

use gamow_platform::{files, messages};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

use super::all::Settings;
use super::entries::{SCENE, SettingEntry};
use super::error::SettingsError;
use crate::scene::Scene;

const SCHEME: &str = "gamow:";

/// Returns the link with these `pairs` of a setting and its value.
#[must_use]
pub fn link_of_pairs(pairs: &str) -> String {
    format!("{SCHEME}?{pairs}")
}

/// The longest link that is read, bytes: all settings together need a tenth of it.
const MOST_BYTES: usize = 16 << 10;

/// The bytes that are escaped in a value: those that mean something in a link, or may end it in a message.
const ESCAPED: &AsciiSet = &NON_ALPHANUMERIC
    .remove(b'-')
    .remove(b'.')
    .remove(b'_')
    .remove(b',')
    .remove(b';')
    .remove(b'@')
    .remove(b':');

/// The sections that belong to whoever looks, and not to what is shown.
const OF_THE_VIEWER: [&str; 2] = ["window", "screen"];

/// Whether `path` is a link, and no path of a file.
#[must_use]
pub fn is_link(path: &Path) -> bool {
    path.to_str().is_some_and(|text| text.trim_start().starts_with(SCHEME))
}

impl Settings {
    /// The link that opens what these settings show, in the window and on the screen of whoever opens it.
    ///
    /// # Errors
    /// A scene in a file of its own, which a link cannot carry.
    pub fn link(&self) -> Result<String, String> {
        self.link_pairs().map(|pairs| link_of_pairs(&pairs))
    }

    /// Returns the settings of that link that differ from the defaults: `beta=0.99&scene=globe`.
    ///
    /// # Errors
    /// As of [`Self::link`].
    pub fn link_pairs(&self) -> Result<String, String> {
        if Scene::preset(&self.scene).is_some() {
            return Ok(self.pairs());
        }
        Err(format!(
            "The scene is in a file, {}, which a link cannot carry: save the state beside it and send both.",
            messages::excerpt(&self.scene)
        ))
    }

    /// Returns the same for where the scene's file is, too, such as a page's address.
    #[must_use]
    pub fn pairs(&self) -> String {
        let default = Self::default().entries();
        let told = |entry: &SettingEntry| {
            !OF_THE_VIEWER.contains(&entry.section.as_str()) && !default.contains(entry)
        };
        let pairs = self.entries().into_iter().filter(told);
        let pairs = pairs
            .map(|SettingEntry { key, text, .. }| format!("{key}={}", utf8_percent_encode(&text, ESCAPED)));
        pairs.collect::<Vec<_>>().join("&")
    }

    /// Returns these settings, overridden by those in `link` that belong to what is shown. Others are checked
    /// and stay as they are.
    ///
    /// # Errors
    /// One line: a setting that does not exist, a value that it cannot have, or a scene that does not come
    /// with the program, but one that the user of a page gave it.
    pub(super) fn with_link(mut self, link: &str) -> Result<Self, SettingsError> {
        let wrong = |problem: String| SettingsError::Content { place: "the link".to_owned(), problem };
        let link = link.trim();
        if link.len() > MOST_BYTES {
            return Err(wrong(format!("it is longer than {} kB, the limit for a link", MOST_BYTES >> 10)));
        }
        let pairs = link.strip_prefix(SCHEME).unwrap_or(link);
        let pairs = pairs.strip_prefix('?').unwrap_or(pairs).split('&').filter(|pair| !pair.is_empty());
        let flags = pairs.map(|pair| {
            let (key, value) = pair.split_once('=').ok_or_else(|| {
                wrong(format!("{} has no value; it should be as in beta=0.9", messages::excerpt(pair)))
            })?;
            let value = percent_decode_str(value).decode_utf8();
            let value =
                value.map_err(|_| wrong(format!("{} is not text in UTF-8", messages::excerpt(pair))))?;
            Ok(format!("--{key}={value}"))
        });
        let flags = flags.collect::<Result<Vec<_>, _>>()?;
        let viewer = self.clone();
        self.set(flags).map_err(|problem| problem.at("the link".to_owned()))?;
        // A page has no files but those that its user gave it.
        let is_given = || !files::HAS_FOLDERS && files::is_file(Path::new(&self.scene));
        if Scene::preset(&self.scene).is_none() && !is_given() {
            let scene = messages::excerpt(&self.scene);
            let what = if files::HAS_FOLDERS {
                "a link names a scene that comes with the program"
            } else {
                "that file is not here, since its browser has not kept it, or it is another's: open it again (File, Open)"
            };
            return Err(wrong(format!("{SCENE} = {scene}: {what}")));
        }
        Ok(self.as_seen_by(&viewer))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opened(link: &str) -> Result<Settings, String> {
        assert!(is_link(Path::new(link)));
        Settings::default().with_file(Path::new(link)).map_err(|error| error.to_string())
    }

    #[test]
    fn a_link_says_what_differs_from_the_defaults_and_can_be_read() {
        assert_eq!(Settings::default().link().expect("a preset"), "gamow:?");
        assert_eq!(opened("gamow:?").expect("it is a link"), Settings::default());
        let settings = opened("gamow:?scene=globe&beta=0.99&time=-2.5&gaze=10,-3").expect("it is a link");
        assert_eq!((settings.scene.as_str(), settings.time), ("globe", Some(-2.5)));
        assert_eq!(settings.speed().beta(), 0.99);
        let link = settings.link().expect("a preset");
        assert_eq!(link, "gamow:?scene=globe&time=-2.5&beta=0.99&gaze=10,-3");
        // Blanks around it come from a message.
        assert_eq!(opened(&format!("  {link}\n")).expect("it is a link"), settings);
    }

    /// Whoever follows a link keeps their window, screen, comfort and stereo distances.
    #[test]
    fn a_link_carries_no_setting_of_whoever_opens_it() {
        let own = Settings::default();
        let own = own.with_command("gamow --theme=light --viewing-distance=70 --plots=off", "mine");
        let own = own.expect("settings");
        let hostile = "gamow:?beta=0.99&viewing-distance=10&picture-distance=20&theme=dark&vignette=off\
            &controls=off&plots=on";
        let opened = own.clone().with_file(Path::new(hostile)).expect("it is a link");
        assert_eq!((&opened.window, &opened.screen), (&own.window, &own.screen));
        assert_eq!(opened.speed().beta(), 0.99);
        // What nobody could set is refused all the same.
        let refused = own.with_file(Path::new("gamow:?theme=pink"));
        assert!(refused.is_err_and(|error| error.to_string().starts_with("the link: theme")));
    }

    #[test]
    fn a_bad_link_is_refused_in_a_line() {
        let long = format!("gamow:?time={}", "1".repeat(MOST_BYTES));
        for (link, told) in [
            ("gamow:?beta=1", "the link: beta = 1 is out of range"),
            ("gamow:?bet=0.5", "the link: there is no setting `bet`"),
            ("gamow:?beta", "the link: beta has no value; it should be as in beta=0.9"),
            ("gamow:?scene=%ff", "the link: scene=%ff is not text in UTF-8"),
            (
                "gamow:?scene=/etc/passwd",
                "the link: scene = /etc/passwd: a link names a scene that comes with the program",
            ),
            ("gamow:?=", "the link: "),
            ("gamow:?beta=0.5&beta=0.6", "the link: "),
            (&long, "the link: it is longer than 16 kB"),
        ] {
            let error = opened(link).expect_err(link);
            assert!(error.starts_with(told) && !error.contains('\n'), "{link}: {error}");
        }
    }
}
