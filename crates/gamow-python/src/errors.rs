//! Errors of the commands as exceptions of Python.

use std::fmt::Display;

use gamow::platform::messages;
use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// The `ValueError` that says `problem` in one line.
pub fn value_error(problem: impl Display) -> PyErr {
    PyValueError::new_err(messages::in_short(&messages::shown(&problem.to_string())))
}

/// The `ValueError` of what a command would end with.
pub fn of_command(error: &anyhow::Error) -> PyErr {
    value_error(format_args!("{error:#}"))
}
