//! The sentences about settings and their values, in one place: their doc comments. They are the help of the
//! flags, the tooltips of the window, the help's page of settings and the entries of the palette.

use std::sync::LazyLock;

use clap::{Arg, ValueEnum};

use super::all::Settings;
use super::entries::FLAGS;

/// A setting, as it is spoken of.
#[derive(Debug, PartialEq, Eq)]
pub struct About {
    /// Name of the setting: its flag without the dashes, and its key in files.
    pub name: &'static str,
    /// Heading of the section that it is in; empty for what is in none.
    pub section: &'static str,
    /// The sentence about it.
    pub sentence: String,
    /// Values that are words.
    pub words: Vec<Word>,
    /// Whether it has other values than words: numbers, places, names.
    pub is_open: bool,
}

/// A value that is a word.
#[derive(Debug, PartialEq, Eq)]
pub struct Word {
    /// Spelling of the word.
    pub name: String,
    /// The sentence about the value; empty where the setting's own sentence covers it.
    pub sentence: String,
}

/// The settings, in the order of the flags.
static ALL: LazyLock<Vec<About>> =
    LazyLock::new(|| FLAGS.get_arguments().filter_map(About::from_flag).collect());

/// Returns all settings, in the order of the flags.
#[must_use]
pub fn about_all() -> &'static [About] {
    &ALL
}

/// Returns the sentence about the setting of this name.
#[must_use]
pub fn about(name: &str) -> &'static str {
    let about = ALL.iter().find(|about| about.name == name);
    debug_assert!(about.is_some(), "there is no setting {name}");
    about.map_or("", |about| &about.sentence)
}

/// Returns the sentence about a value of a setting.
#[must_use]
pub fn meaning<T: ValueEnum>(value: &T) -> String {
    let help = value.to_possible_value().and_then(|value| value.get_help().map(ToString::to_string));
    sentence(&help.unwrap_or_default())
}

impl About {
    fn from_flag(flag: &'static Arg) -> Option<Self> {
        let told = flag.get_help().map(ToString::to_string).unwrap_or_default();
        let values = flag.get_possible_values();
        let named = values.iter().filter(|value| !value.is_hide_set()).map(|value| Word {
            name: value.get_name().to_owned(),
            sentence: sentence(&value.get_help().map(ToString::to_string).unwrap_or_default()),
        });
        // What a flag takes is told by its value's name: words as they are typed, all else with capitals. Its
        // own name stands for numbers.
        let taken = flag.get_value_names().unwrap_or_default().iter().flat_map(|name| name.split('|'));
        let (typed, others): (Vec<_>, Vec<_>) =
            taken.partition(|name| name.chars().all(|letter| letter.is_ascii_lowercase()));
        let typed = typed.into_iter().map(|name| Word { name: name.to_owned(), sentence: String::new() });
        let is_open = values.is_empty() && (typed.len() == 0 || !others.is_empty());
        Some(Self {
            name: flag.get_long()?,
            section: flag.get_help_heading().unwrap_or_default(),
            sentence: sentence(&told),
            words: if values.is_empty() { typed.collect() } else { named.collect() },
            is_open,
        })
    }
}

impl Settings {
    /// Returns these settings with another value of the one of this name, in the spelling of its flag.
    ///
    /// # Errors
    /// A value that it cannot have, in one line.
    pub fn with_value(mut self, name: &str, value: &str) -> Result<Self, String> {
        self.set(vec![format!("--{name}={value}")]).map_err(|problem| problem.text)?;
        Ok(self)
    }
}

/// A help's text as a sentence: with its full stop, and without the marks of code and what the flag's default
/// is.
fn sentence(help: &str) -> String {
    let mut text = help.split(" [default").next().unwrap_or_default().replace('`', "");
    if text.ends_with(|end: char| end.is_alphanumeric() || end == ')') {
        text.push('.');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::{Daylight, MAX_LENGTH};

    fn named(name: &str) -> &'static About {
        ALL.iter().find(|about| about.name == name).expect("it is a setting")
    }

    #[test]
    fn every_setting_has_a_sentence() {
        for About { name, sentence, words, .. } in about_all() {
            assert!(
                sentence.starts_with(char::is_uppercase) && sentence.ends_with('.'),
                "{name}: {sentence}"
            );
            for word in words.iter().filter(|word| !word.sentence.is_empty()) {
                assert!(word.sentence.ends_with('.'), "{name} {}: {}", word.name, word.sentence);
            }
        }
    }

    #[test]
    fn values_are_told_as_the_flags_take_them() {
        let words = |name| named(name).words.iter().map(|word| word.name.as_str()).collect::<Vec<_>>();
        assert_eq!((words("sky"), named("sky").is_open), (vec!["on", "off"], false));
        assert_eq!((words("light"), named("light").is_open), (vec!["theme", "on", "off"], false));
        assert_eq!((words("fov"), named("fov").is_open), (vec!["auto"], true));
        assert_eq!((words("beta"), named("beta").is_open), (vec![], true));
        assert_eq!(meaning(&Daylight::On), "Light, like a page.");
    }

    /// A word that is listed is taken, whatever else is set.
    #[test]
    fn every_listed_value_can_be_set() {
        for about in about_all().iter().filter(|about| about.name != "scene") {
            for word in &about.words {
                let set = Settings::default().with_value(about.name, &word.name);
                assert!(set.is_ok(), "{} {}: {set:?}", about.name, word.name);
            }
        }
    }

    #[test]
    fn a_value_that_cannot_be_had_is_refused_in_one_line() {
        let set = Settings::default().with_value("depth-shift", &(2.0 * MAX_LENGTH).to_string());
        let problem = set.expect_err("it is too far");
        assert!(problem.contains("depth-shift") && problem.lines().count() == 1, "{problem}");
    }
}
