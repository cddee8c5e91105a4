//! Settings as a list of names and values, which files, flags and records of pictures have in common.

use std::path::Path;
use std::sync::LazyLock;

use clap::{Arg, Args as _, Command, FromArgMatches as _};
use gamow_platform::files;
use toml::{Table, Value};

use super::all::Settings;
use super::error::{SettingProblem, SettingsError};
use crate::flags::choices::ProjectionChoice;
use crate::flags::words::{Shell, words};

/// The flags of all settings.
pub(super) static FLAGS: LazyLock<Command> = LazyLock::new(|| {
    let flags = Command::new("settings").no_binary_name(true).disable_help_flag(true);
    Settings::augment_args_for_update(flags)
});

/// The setting that names a scene.
pub(super) const SCENE: &str = "scene";
/// Command that draws a picture of settings.
const RENDER: &str = "gamow render";
/// Command that opens a window with settings.
const WINDOW: &str = "gamow";
/// The sections that decide what the eyes are shown.
const OF_VIEWS: [&str; 5] = ["", "motion", "look", "light", "quality"];
/// The section that decides how a picture is made of it.
const OF_PICTURES: &str = "picture";

/// A setting with its value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct SettingEntry {
    /// The section the entry is in; none at the top.
    pub section: String,
    /// Name of the setting.
    pub key: String,
    /// Value of the setting, in the spelling of a flag.
    pub text: String,
}

/// The section of every setting and its name, in their order.
pub(super) fn names() -> impl Iterator<Item = (String, &'static str)> {
    let section = |flag: &Arg| flag.get_help_heading().unwrap_or_default().to_lowercase();
    FLAGS.get_arguments().filter_map(move |flag| Some((section(flag), flag.get_long()?)))
}

impl Settings {
    /// Every setting that has a value, in order.
    pub(super) fn entries(&self) -> Vec<SettingEntry> {
        let top = Table::try_from(self).expect("settings are numbers, words and lists of them");
        let entry = |(section, key): (String, &str)| {
            let table = if section.is_empty() { &top } else { top.get(&section)?.as_table()? };
            let text = text(table.get(key)?);
            Some(SettingEntry { section, key: key.to_owned(), text })
        };
        names().filter_map(entry).collect()
    }

    /// The command that draws a picture with these settings: all that decide what it shows, and of the others
    /// those that are not as usual.
    #[must_use]
    pub fn command(&self, shell: Shell) -> String {
        self.command_line(shell, RENDER, |section| OF_VIEWS.contains(&section) || section == OF_PICTURES)
    }

    /// The command that opens a window with these settings.
    #[must_use]
    pub fn window_command(&self, shell: Shell) -> String {
        self.command_line(shell, WINDOW, |section| OF_VIEWS.contains(&section))
    }

    fn command_line(&self, shell: Shell, command: &str, is_written: impl Fn(&str) -> bool) -> String {
        let default = Self::default().entries();
        let told =
            self.entries().into_iter().filter(|entry| is_written(&entry.section) || !default.contains(entry));
        told.fold(command.to_owned(), |line, SettingEntry { key, text, .. }| {
            line + " --" + &key + "=" + &shell.quoted(&text)
        })
    }

    /// Returns these settings with those of `command`, one of the commands above recorded at `place`, on top.
    ///
    /// # Errors
    /// Another command, a flag that does not exist, or a value that it cannot have.
    pub fn with_command(self, command: &str, place: &str) -> Result<Self, SettingsError> {
        self.with_command_of(&[RENDER, WINDOW], command, place)
    }

    /// The settings with which `gamow render` made what is at `place`, where this `command` was recorded,
    /// with the scene by the name that is recorded.
    ///
    /// # Errors
    /// As [`Self::with_command`].
    pub fn of_picture(command: &str, place: &str) -> Result<Self, SettingsError> {
        Self::default().with_command_of(&[RENDER], command, place)
    }

    /// Returns the settings that the file at `path` records in `command`, with the scene where it is; `None`
    /// where `command` is not one of `gamow render`, as in a file without a record.
    ///
    /// # Errors
    /// A flag that does not exist, or a value that it cannot have.
    pub fn recorded_in(command: &str, path: &Path) -> Result<Option<Self>, SettingsError> {
        if !command.starts_with(RENDER) {
            return Ok(None);
        }
        let place = files::shown(path);
        let mut settings = Self::of_picture(command, &place)?;
        let found = settings.find_scene_beside(path);
        found.map_err(|problem| SettingsError::Content { place, problem })?;
        Ok(Some(settings))
    }

    fn with_command_of(mut self, known: &[&str], command: &str, place: &str) -> Result<Self, SettingsError> {
        let flags = known.iter().find_map(|known| command.strip_prefix(known)).unwrap_or_default();
        if !flags.trim_start().starts_with("--") {
            let problem = "it does not record the settings with which it was made".to_owned();
            return Err(SettingsError::Content { place: place.to_owned(), problem });
        }
        // What was recorded before there was another projection does not name it.
        self.look.projection = ProjectionChoice::Gaze;
        self.set(words(flags)).map_err(|problem| problem.at(place.to_owned()))?;
        Ok(self)
    }

    /// Sets what `flags` say.
    pub(super) fn set(&mut self, flags: Vec<String>) -> Result<(), SettingProblem> {
        let matches = FLAGS.clone().try_get_matches_from(flags);
        let updated = matches.and_then(|matches| self.update_from_arg_matches(&matches));
        updated.map_err(|error| SettingProblem::new(&error))
    }
}

/// Writes a value in the spelling of a flag.
fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Boolean(is_on) => if *is_on { "on" } else { "off" }.to_owned(),
        Value::Array(items) => items.iter().map(text).collect::<Vec<_>>().join(","),
        Value::Float(number) => number.to_string(), // not as TOML writes it, which adds `.0`
        other => other.to_string(),
    }
}
