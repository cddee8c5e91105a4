//! Errors of settings, in one line: where, what, and the correction.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use gamow_platform::messages;
use std::error::Error as _;
use thiserror::Error;

use crate::similar::did_you_mean;

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
        "no preset is called `{}`{}: there are {known}; for a file, give its name with its ending",
        messages::excerpt(name),
        did_you_mean(known.split(", "), name)
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
        Self::spelt(error, Spelling::KEY)
    }

    /// Returns the problem with names in the given spelling.
    fn spelt(error: &clap::Error, Spelling { dashes, is, set }: Spelling) -> Self {
        let key = context(error, ContextKind::InvalidArg).map(name);
        let value = messages::excerpt(context(error, ContextKind::InvalidValue).unwrap_or_default());
        let spelt = |name: &str| {
            let dashes = if name.starts_with(|letter: char| letter.is_lowercase()) { dashes } else { "" };
            format!("{dashes}{}", messages::excerpt(name))
        };
        let shown = spelt(key.as_deref().unwrap_or_default());
        let text = match (error.kind(), error.source()) {
            (ErrorKind::ValueValidation, Some(reason)) => format!("{shown}{is}{value}: {reason}"),
            (ErrorKind::InvalidValue, _) if value.is_empty() => format!("{shown} needs {}", choices(error)),
            (ErrorKind::InvalidValue, _) => {
                let near = did_you_mean(valid_values(error).iter().map(String::as_str), &value);
                format!("{shown}{is}{value}{near}: must be {}", choices(error))
            }
            (ErrorKind::TooManyValues, _) => format!("{shown} takes no value, and `{value}` is given"),
            (ErrorKind::UnknownArgument, _) => format!("there is no setting `{shown}`"),
            (ErrorKind::ArgumentConflict, _) if key.is_some() => {
                let other = context(error, ContextKind::PriorArg).map(|flag| spelt(&name(flag)));
                format!("{shown} and {} cannot both be {set}: choose one", other.unwrap_or_default())
            }
            (ErrorKind::MissingRequiredArgument, _) => match error.get(ContextKind::InvalidArg) {
                Some(ContextValue::Strings(missing)) => {
                    let missing: Vec<_> = missing.iter().map(|flag| names(flag, spelt)).collect();
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

/// The words around the names of settings in messages.
struct Spelling {
    /// Beginning of a name.
    dashes: &'static str,
    /// Text between a name and its value.
    is: &'static str,
    /// Word for a setting that is there.
    set: &'static str,
}

impl Spelling {
    /// Settings in a file, or arguments in Python.
    const KEY: Self = Self { dashes: "", is: " = ", set: "set" };
    /// Flags of a command line.
    const FLAG: Self = Self { dashes: "--", is: " ", set: "given" };
}

/// Returns the problem that `clap` finds with flags that were not typed on a command line, in one line.
#[must_use]
pub fn problem_in_one_line(error: &clap::Error) -> String {
    SettingProblem::new(error).text
}

/// Returns the problem that `clap` finds with the flags of a command line, in one line.
#[must_use]
pub fn problem_of_flags(error: &clap::Error) -> String {
    SettingProblem::spelt(error, Spelling::FLAG).text
}

/// `depth-shift` of `--depth-shift <DY>`, and `FILE` of `<FILE>`.
fn name(flag: &str) -> String {
    let name = flag.trim_start_matches("--");
    let name = name.split([' ', '=']).next().unwrap_or(name);
    name.trim_matches(['<', '>', '[', ']', '.']).to_owned()
}

/// `point or object` of `<--point <X,Y,Z>|--object <NAME>>`, each as `spelt`.
fn names(flags: &str, spelt: impl Fn(&str) -> String) -> String {
    let all = if flags.contains("--") { flags.split("--").skip(1).collect() } else { vec![flags] };
    all.into_iter().map(|flag| spelt(&name(flag))).collect::<Vec<_>>().join(" or ")
}

fn context(error: &clap::Error, kind: ContextKind) -> Option<&str> {
    match error.get(kind)? {
        ContextValue::String(text) => Some(text),
        _ => None,
    }
}

/// The values that there are, in words.
fn choices(error: &clap::Error) -> String {
    match valid_values(error) {
        [] => "a value".to_owned(),
        values => format!("one of {}", values.join(", ")),
    }
}

/// The values that there are, where they are words.
fn valid_values(error: &clap::Error) -> &[String] {
    match error.get(ContextKind::ValidValue) {
        Some(ContextValue::Strings(values)) => values,
        _ => &[],
    }
}

/// The message alone: `clap` goes on with hints for a command line.
fn first_line(error: &clap::Error) -> String {
    let text = error.to_string();
    text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}
