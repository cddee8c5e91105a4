//! The settings to start with: the last ones or the defaults, then a file's, then the flags'.

use std::path::{Path, PathBuf};

use clap::{Arg, ArgMatches, Args, Command, FromArgMatches, value_parser};

use super::all::Settings;
use super::entries::SCENE;
use super::error::{SettingProblem, SettingsError};
use super::link::is_link;
use super::presets::Preset;
use crate::flags::choices::FileKind;
use crate::scene::looks_like_a_name;

/// A flag for each setting, and one for a preset or a file of them.
#[derive(Debug, Clone)]
pub struct StartArgs {
    state: Option<PathBuf>,
    given: ArgMatches,
}

const STATE: &str = "state";

impl StartArgs {
    /// Whether they say what is shown: a scene, or a state.
    #[must_use]
    pub fn name_what_is_shown(&self) -> bool {
        self.state.is_some() || self.scene().is_some()
    }

    /// The file of settings in TOML that they start from, if it is one.
    #[must_use]
    pub fn file(&self) -> Option<&Path> {
        let path = self.state.as_deref().filter(|state| preset(state).is_none())?;
        (FileKind::from_path(path).is_none() && !is_link(path)).then_some(path)
    }

    /// The scene that a flag gives.
    fn scene(&self) -> Option<&String> {
        self.given.get_one(SCENE)
    }

    /// Returns `left`, or the settings of the preset or the file if one is given; and the flags on top.
    /// Settings that belong to a scene do not go over to another that a flag gives.
    pub fn settings(&self, left: Settings) -> anyhow::Result<Settings> {
        let base = match &self.state {
            Some(state) => named(state, &left)?,
            None => left,
        };
        let mut settings = match self.scene() {
            Some(scene) if *scene != base.scene => base.with_scene(scene.clone()),
            _ => base,
        };
        let updated = settings.update_from_arg_matches(&self.given);
        updated.map_err(|error| anyhow::anyhow!(SettingProblem::new(&error).text))?;
        Ok(settings)
    }
}

/// The settings of the preset of this name, or in the file there, in the window that was `left`.
fn named(preset_or_path: &Path, left: &Settings) -> Result<Settings, SettingsError> {
    if let Some(preset) = preset(preset_or_path) {
        return Ok(preset.settings.clone().in_place_of(left));
    }
    match preset_or_path.to_str() {
        Some(name) if looks_like_a_name(name) && !is_link(preset_or_path) => {
            Err(SettingsError::UnknownPreset { name: name.to_owned(), known: Preset::names() })
        }
        _ => Settings::default().in_place_of(left).with_file(preset_or_path),
    }
}

/// Returns the preset of this name; `None` for the path of a file.
fn preset(name: &Path) -> Option<&'static Preset> {
    Preset::named(name.to_str()?)
}

impl Args for StartArgs {
    fn augment_args(command: Command) -> Command {
        let state = Arg::new(STATE).long(STATE).value_name("PRESET|FILE|LINK").value_parser(value_parser!(PathBuf)).help(format!(
            "Start from a preset ({}), from the settings in a file (.toml), or from those with which a picture was made \
             (.png, .exr), or from a link (gamow:?beta=0.99&scene=globe)",
            Preset::names(),
        ));
        let command = Settings::augment_args_for_update(command.arg(state)).next_help_heading(None::<&str>);
        Settings::default().entries().into_iter().fold(command, |command, entry| {
            command.mut_arg(entry.key.replace('-', "_"), |flag| {
                let help = flag.get_help().map(ToString::to_string).unwrap_or_default();
                flag.help(format!("{help} [default: {}]", entry.text))
            })
        })
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for StartArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self { state: matches.get_one(STATE).cloned(), given: matches.clone() })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
