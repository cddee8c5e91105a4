//! Keywords as the flags of a command, so that both have one parser.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, Command};
use gamow::files::syntax::british;
use gamow::settings::problem_in_one_line;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyString};

use crate::errors::{self, value_error};

/// Parses `keywords` as flags of the command whose flags are `A`, followed by `more` of its words. Flags that
/// only a command line needs are `hidden`.
///
/// # Errors
///
/// A keyword that is no flag, or a value that it cannot have.
pub fn parsed<A: Args>(
    keywords: Option<&Bound<'_, PyDict>>,
    more: Vec<OsString>,
    hidden: &[&str],
) -> PyResult<A> {
    let command = A::augment_args(Command::new("gamow").no_binary_name(true).disable_help_flag(true));
    let mut given = Vec::new();
    for (keyword, value) in keywords.into_iter().flatten() {
        let keyword: String = keyword.extract()?;
        let name = flag_name(&keyword);
        let flag = command.get_arguments().find(|flag| flag.get_long() == Some(&name));
        let Some(flag) = flag.filter(|_| !hidden.contains(&name.as_str())) else {
            let known = command.get_arguments().filter_map(|flag| flag.get_long());
            let known: Vec<_> = known.filter(|name| !hidden.contains(name)).map(errors::keyword).collect();
            let unknown = value.py().import("gamow._keywords")?.call_method1("unknown", (keyword, known))?;
            return Err(PyErr::from_value(unknown));
        };
        if value.is_none() {
            continue;
        }
        if flag.get_action().takes_values() {
            given.push(format!("--{name}={}", text(&keyword, &value)?).into());
        } else if value.extract::<bool>().map_err(|_| wrong(&keyword, "True or False"))? {
            given.push(format!("--{name}").into());
        }
    }
    given.extend(more);
    let command_names: Vec<_> =
        command.get_arguments().filter_map(|flag| flag.get_long()).map(str::to_owned).collect();
    let matches = command.try_get_matches_from(given);
    let parsed = matches.and_then(|matches| A::from_arg_matches(&matches));
    parsed.map_err(|error| {
        let flags = command_names.iter().filter(|name| name.contains('-'));
        let problem = problem_in_one_line(&error);
        value_error(flags.fold(problem, |text, name| text.replace(name, &errors::keyword(name))))
    })
}

/// Returns the name of the flag for this keyword.
pub fn flag_name(keyword: &str) -> String {
    british(&keyword.trim_end_matches('_').replace('_', "-")).into_owned()
}

fn wrong(keyword: &str, right: &str) -> PyErr {
    value_error(format_args!("{keyword}: must be {right}"))
}

/// Writes a value in the spelling of a flag: a number by the shortest digits that read back to it, a list
/// with commas.
fn text(keyword: &str, value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Some(text) = word(keyword, value)? {
        return Ok(text);
    }
    if has_unit(value)? {
        let units = value.py().import("gamow._units")?;
        return self::text(keyword, &units.call_method1("setting", (keyword, value))?);
    }
    if value.is_instance_of::<PyBool>() {
        return Ok(if value.is_truthy()? { "on" } else { "off" }.to_owned());
    }
    if value.is_instance_of::<PyInt>() {
        return Ok(value.str()?.to_string());
    }
    if let Ok(number) = value.extract::<f64>() {
        return Ok(number.to_string());
    }
    let is_text = value.is_instance_of::<PyString>();
    let items = (!is_text).then(|| value.try_iter().ok()).flatten();
    let items = items.ok_or_else(|| wrong(keyword, "a number, a word or a list of them"))?;
    let mut texts = Vec::new();
    for item in items {
        let item = item?;
        // Lists in lists, and lists without an end, are no flags.
        let is_list = item.hasattr("__iter__")? && !item.is_instance_of::<PyString>() && !has_unit(&item)?;
        if texts.len() > MOST_ITEMS || is_list {
            return Err(wrong(keyword, "a number, a word or a list of them"));
        }
        texts.push(text(keyword, &item)?);
    }
    // Width and height, as in `640x480`.
    let separator = if keyword == "size" { "x" } else { "," };
    Ok(texts.join(separator))
}

/// Whether a value is a Quantity.
fn has_unit(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    Ok(value.hasattr("unit")? || value.hasattr("units")?)
}

/// Returns the text in `value`, or the path of an object that has one, such as a `Scene` or a `pathlib.Path`.
///
/// # Errors
///
/// The reason why a path cannot be given; a path that is not UTF-8.
pub fn word(keyword: &str, value: &Bound<'_, PyAny>) -> PyResult<Option<String>> {
    if let Ok(text) = value.extract::<String>() {
        return Ok(Some(text));
    }
    if !value.hasattr("__fspath__")? {
        return Ok(None);
    }
    let path = value.extract::<PathBuf>()?.into_os_string().into_string();
    path.map(Some).map_err(|_| wrong(keyword, "text in UTF-8"))
}

/// The most items of a list: observation times of as many files.
const MOST_ITEMS: usize = 1_000_000;
