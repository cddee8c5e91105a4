//! Errors of the commands as exceptions of Python.

use std::fmt::Display;

use gamow_platform::messages;
use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// Returns a `ValueError` whose message is `problem`, in one line.
pub fn value_error(problem: impl Display) -> PyErr {
    PyValueError::new_err(messages::in_short(&messages::shown(&problem.to_string())))
}

/// Returns a `ValueError` with the message of the error that would end a command.
pub fn of_command(error: &anyhow::Error) -> PyErr {
    value_error(format_args!("{error:#}"))
}
