//! Errors of the commands as exceptions of Python.

use std::fmt::Display;

use clap::{Args as _, Command};
use gamow::settings::StartArgs;
use gamow_platform::messages;
use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// Returns a `ValueError` whose message is `problem`, in one line.
pub fn value_error(problem: impl Display) -> PyErr {
    PyValueError::new_err(messages::in_short(&messages::shown(&in_python(&problem.to_string()))))
}

/// Returns a `ValueError` with the message of the error that would end a command.
pub fn of_command(error: &anyhow::Error) -> PyErr {
    value_error(format_args!("{error:#}"))
}

/// A message of a command in the words of Python: `--size 8x6` as `size='8x6'`, and `--fit-x0` as the keyword
/// fit_x0.
fn in_python(message: &str) -> String {
    let mut parts = message.split("--");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let begins_a_word = !text.ends_with(|letter: char| letter.is_alphanumeric() || letter == '-');
        if begins_a_word && part.starts_with(|letter: char| letter.is_ascii_lowercase()) {
            text += &flag_in_python(part);
        } else {
            text += "--";
            text += part;
        }
    }
    text
}

/// The text behind the dashes of a flag, with the flag as a keyword.
fn flag_in_python(part: &str) -> String {
    let end = part.find(|letter: char| !letter.is_ascii_alphanumeric() && letter != '-');
    let (name, rest) = part.split_at(end.unwrap_or(part.len()));
    let keyword = keyword(name);
    let value =
        rest.strip_prefix(' ').map(|rest| rest.split([' ', ',', ';', ':', '`']).next().unwrap_or_default());
    match value {
        Some(value) if value.parse::<f64>().is_ok() => format!("{keyword}={}", &rest[1..]),
        Some(value) if is_choice(name, value) => format!("{keyword}='{value}'{}", &rest[1 + value.len()..]),
        _ if rest.starts_with([':', '=']) => format!("{keyword}{rest}"),
        _ => format!("the keyword {keyword}{rest}"),
    }
}

/// The keyword for the flag of this `name`.
pub fn keyword(name: &str) -> String {
    let keyword = name.replace('-', "_");
    if keyword == "from" { "from_".to_owned() } else { keyword }
}

/// Whether `value` is one of the words that the setting of this `name` takes.
fn is_choice(name: &str, value: &str) -> bool {
    let flags = StartArgs::augment_args(Command::new("gamow"));
    let flag = flags.get_arguments().find(|flag| flag.get_long() == Some(name));
    flag.is_some_and(|flag| flag.get_possible_values().iter().any(|choice| choice.matches(value, false)))
}
