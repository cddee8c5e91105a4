//! Errors of settings, in one line: where, what, and the correction.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use gamow_platform::messages;
use std::error::Error as _;
use thiserror::Error;

/// Settings that cannot be had.
#[derive(Debug, Error)]
pub enum SettingsError {
    /// The file could not be read.
    #[error("{source_name}: cannot read these settings: {reason}")]
    Read {
        /// The file, as it was named.
        source_name: String,
        /// Reason why the settings cannot be read.
        reason: String,
    },
    /// Neither a preset nor a path.
    #[error(
        "no preset is called `{}`: there are {known}; for a file, give its name with its ending",
        messages::excerpt(name)
    )]
    UnknownPreset {
        /// Name that was given.
        name: String,
        /// The names of all presets.
        known: String,
    },
    /// A setting that does not exist, or has a value that it cannot have.
    #[error("{place}: {problem}")]
    Content {
        /// The file, and the line in it where it has lines.
        place: String,
        /// Problem in that line.
        problem: String,
    },
}

/// A problem with a setting.
#[derive(Debug)]
pub(super) struct SettingProblem {
    /// The setting's name, if it has one.
    pub key: Option<String>,
    /// Description of the problem.
    pub text: String,
}

impl SettingProblem {
    /// Returns the problem that `clap` finds, in one line.
    pub fn new(error: &clap::Error) -> Self {
        let key = context(error, ContextKind::InvalidArg).map(name);
        let value = messages::excerpt(context(error, ContextKind::InvalidValue).unwrap_or_default());
        let shown = messages::excerpt(key.as_deref().unwrap_or_default());
        let text = match (error.kind(), error.source()) {
            (ErrorKind::ValueValidation, Some(reason)) => format!("{shown} = {value}: {reason}"),
            (ErrorKind::InvalidValue, _) => format!("{shown} = {value}: must be {}", choices(error)),
            (ErrorKind::UnknownArgument, _) => format!("there is no setting `{shown}`"),
            (ErrorKind::ArgumentConflict, _) => {
                let other = context(error, ContextKind::PriorArg).map(name).unwrap_or_default();
                format!("{shown} and {other} cannot both be set: choose one")
            }
            (ErrorKind::MissingRequiredArgument, _) => match error.get(ContextKind::InvalidArg) {
                Some(ContextValue::Strings(missing)) => {
                    let missing: Vec<_> = missing.iter().map(|flag| names(flag)).collect();
                    format!("{} is missing", missing.join(", "))
                }
                _ => first_line(error),
            },
            _ => first_line(error),
        };
        Self { key, text }
    }

    /// The error of settings that stand at `place`.
    pub fn at(self, place: String) -> SettingsError {
        SettingsError::Content { place, problem: self.text }
    }
}

/// Returns the problem that `clap` finds with flags that were not typed on a command line, in one line.
#[must_use]
pub fn problem_in_one_line(error: &clap::Error) -> String {
    SettingProblem::new(error).text
}

/// `depth-shift` of `--depth-shift <DY>`.
fn name(flag: &str) -> String {
    let name = flag.trim_start_matches("--");
    name.split([' ', '=']).next().unwrap_or(name).to_owned()
}

/// `point or object` of `<--point <X,Y,Z>|--object <NAME>>`.
fn names(flags: &str) -> String {
    flags.split("--").skip(1).map(name).collect::<Vec<_>>().join(" or ")
}

fn context(error: &clap::Error, kind: ContextKind) -> Option<&str> {
    match error.get(kind)? {
        ContextValue::String(text) => Some(text),
        _ => None,
    }
}

/// The values that there are.
fn choices(error: &clap::Error) -> String {
    match error.get(ContextKind::ValidValue) {
        Some(ContextValue::Strings(values)) => format!("one of {}", values.join(", ")),
        _ => "a value".to_owned(),
    }
}

/// The message alone: `clap` goes on with hints for a command line.
fn first_line(error: &clap::Error) -> String {
    let text = error.to_string();
    text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}
