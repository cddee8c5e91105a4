//! The settings to start with: what was left or is usual, what a file says, what flags say.

use std::path::PathBuf;

use clap::builder::PathBufValueParser;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};

use super::all::Settings;
use super::error::Problem;

/// A flag for each setting, and one for a file of them.
#[derive(Debug, Clone)]
pub struct StartArgs {
    file: Option<PathBuf>,
    given: ArgMatches,
}

const FILE: &str = "state";

impl StartArgs {
    /// `left`, or what the file says if one is given; and the flags in their stead. A scene that a flag gives starts at
    /// a T and with a point of its own.
    pub fn settings(&self, left: Settings) -> anyhow::Result<Settings> {
        let mut settings = match &self.file {
            Some(path) => Settings::default().with_file(path)?,
            None => left,
        };
        let Settings { scene, time, point, .. } = settings.clone();
        (settings.time, settings.point) = (None, None);
        let updated = settings.update_from_arg_matches(&self.given);
        updated.map_err(|error| anyhow::anyhow!(Problem::new(&error).text))?;
        if settings.scene == scene {
            settings.time = settings.time.or(time);
            settings.point = settings.point.or(point);
        }
        Ok(settings)
    }
}

impl Args for StartArgs {
    fn augment_args(command: Command) -> Command {
        let file = Arg::new(FILE).long(FILE).value_name("FILE").value_parser(PathBufValueParser::new()).help(
            "Start from the settings in this file (.toml), or with which a picture was made (.png, .exr)",
        );
        let command = Settings::augment_args_for_update(command.arg(file)).next_help_heading(None::<&str>);
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
        Ok(Self { file: matches.get_one(FILE).cloned(), given: matches.clone() })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
