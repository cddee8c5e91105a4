//! Dicts as tables of TOML, so that states and scenes in them have the files' readers.

use pyo3::IntoPyObjectExt as _;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyTuple};
use toml::{Table, Value};

use crate::errors::value_error;
use crate::flags::word;

/// Tables and lists are nested no deeper: a scene's groups have lists of wheels, which have places.
const DEEPEST: usize = 6;

/// Returns the table of a dict, with each key as `written`.
///
/// # Errors
///
/// A key that is not text, a value that TOML does not have, or tables within tables without end.
pub fn table(dict: &Bound<'_, PyDict>, written: fn(&str) -> String) -> PyResult<Table> {
    table_within(dict, written, DEEPEST)
}

fn table_within(dict: &Bound<'_, PyDict>, written: fn(&str) -> String, depth: usize) -> PyResult<Table> {
    let mut table = Table::new();
    for (key, value) in dict {
        let key: String = key.extract().map_err(|_| value_error("the keys of a dict must be text"))?;
        let value = value_within(&key, &value, written, depth)?;
        table.insert(written(&key), value);
    }
    Ok(table)
}

fn value_within(
    key: &str,
    value: &Bound<'_, PyAny>,
    written: fn(&str) -> String,
    depth: usize,
) -> PyResult<Value> {
    if value.is_instance_of::<PyBool>() {
        return Ok(Value::Boolean(value.is_truthy()?));
    }
    if let Some(text) = word(key, value)? {
        return Ok(Value::String(text));
    }
    if value.is_instance_of::<PyInt>()
        && let Ok(integer) = value.extract::<i64>()
    {
        return Ok(Value::Integer(integer));
    }
    if let Ok(number) = value.extract::<f64>() {
        return Ok(Value::Float(number));
    }
    let wrong = || value_error(format_args!("{key}: must be a number, a word or a list of them"));
    let deeper = depth.checked_sub(1).ok_or_else(wrong)?;
    if let Ok(dict) = value.cast::<PyDict>() {
        return Ok(Value::Table(table_within(dict, written, deeper)?));
    }
    let items: Vec<Bound<'_, PyAny>> = value.extract().map_err(|_| wrong())?;
    let items = items.iter().map(|item| value_within(key, item, written, deeper));
    Ok(Value::Array(items.collect::<PyResult<_>>()?))
}

/// Returns a value of TOML as one of Python's, a list as a tuple.
pub fn value_in_python<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Value::Boolean(value) => value.into_bound_py_any(py),
        Value::Integer(value) => value.into_bound_py_any(py),
        Value::Float(value) => value.into_bound_py_any(py),
        Value::String(value) => value.into_bound_py_any(py),
        Value::Array(values) => {
            let values: Vec<_> =
                values.iter().map(|value| value_in_python(py, value)).collect::<PyResult<_>>()?;
            PyTuple::new(py, values)?.into_bound_py_any(py)
        }
        other => other.to_string().into_bound_py_any(py),
    }
}
