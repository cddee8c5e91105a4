//! The function `fit`: speed and distance from readings.

use std::io::Cursor;
use std::path::PathBuf;

use csv::ByteRecord;
use gamow::columns::Input;
use gamow::commands::fit::FitArgs;
use gamow::estimate::FitReport;
use gamow::files::csv_out::CsvWriter;
use gamow::files::{csv_in, whole};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::arrays::Columns;
use crate::errors::{of_command, value_error};
use crate::flags::parsed;
use crate::threads::detached;

/// Fits speed and distance of a point to the disparities that two eyes measured: what `gamow fit --json`
/// writes, as a dict.
///
/// data is the path of a CSV file, or a dict (or a table such as a pandas DataFrame) of arrays with the
/// columns of one: T; dphi, dtheta or both (left minus right, radians; NaN where there is no reading);
/// optionally sigma_dphi, sigma_dtheta, d, roll, turn. The keywords are the command's flags: d, roll and turn
/// (degrees), model, use, bootstrap (replicates), seed, x0, fit_x0, loss ('linear', 'soft-l1', 'huber' or
/// 'cauchy'), loss_scale, riding, wheel_radius, rho, angle.
///
/// The interpreter's lock is released; Ctrl-C ends it with a KeyboardInterrupt. What the data cannot tell is
/// a ValueError.
#[pyfunction]
#[pyo3(signature = (data, /, **flags))]
pub fn fit<'py>(
    py: Python<'py>,
    data: &Bound<'py, PyAny>,
    flags: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let args: FitArgs = parsed(flags, Vec::new(), &["out", "json"])?;
    let mut interrupt = None;
    let is_wanted = |_| {
        interrupt = Python::attach(|py| py.check_signals().err());
        interrupt.is_none()
    };
    let report = if let Ok(path) = data.extract::<PathBuf>() {
        detached(py, || {
            let (name, input) = csv_in::open(Some(&path))?;
            args.fitted_while(&name, input, is_wanted)
        })?
    } else {
        let csv = csv_of(data)?;
        detached(py, || args.fitted_while("data", Cursor::new(csv), is_wanted))?
    };
    if let Some(interrupt) = interrupt {
        return Err(interrupt);
    }
    let report: FitReport = report.map_err(|error| of_command(&error))?;
    let mut json = Vec::new();
    whole::write_json(&report, &mut json).map_err(|error| of_command(&error))?;
    py.import("json")?.call_method1("loads", (PyString::new(py, &String::from_utf8_lossy(&json)),))
}

/// The columns that a fit reads.
const READ: [&str; 9] = ["T", "clock", "dphi", "dtheta", "sigma_dphi", "sigma_dtheta", "d", "roll", "turn"];

/// The columns in `data` as a CSV file: its first row has the names, so that row n of an array, from 0, is
/// line n + 2.
fn csv_of(data: &Bound<'_, PyAny>) -> PyResult<Vec<u8>> {
    let no_table = |_| value_error("data: must be the path of a CSV file, or a dict of arrays by column");
    let names = data.call_method0("keys").and_then(|keys| keys.try_iter()).map_err(no_table)?;
    let given = PyDict::new(data.py());
    for name in names {
        let name = name?;
        if name.extract::<String>().is_ok_and(|name| READ.contains(&name.as_str())) {
            let column = data.get_item(&name)?;
            // A table's own columns are arrays that know NumPy's.
            let is_table = column.hasattr("to_numpy")?;
            let column = if is_table { column.call_method0("to_numpy")? } else { column };
            given.set_item(name, column)?;
        }
    }
    let columns = Columns::new(&given)?;
    let inputs = columns.inputs()?;
    let mut rows = CsvWriter::new(Vec::new());
    let in_memory = |_| value_error("data: there is no memory for it");
    rows.write(&mut columns.names.iter().collect(), &[]).map_err(in_memory)?;
    for row in 0..columns.rows() {
        let values: Vec<f64> = inputs.iter().map(|input: &Input<'_>| input.at(row)).collect();
        if let Some(place) = values.iter().position(|value| value.is_infinite()) {
            let (place, name) = (columns.place(row), &columns.names[place]);
            return Err(value_error(format_args!("data: {place}column {name}: a number must be finite")));
        }
        rows.write(&mut ByteRecord::new(), &values).map_err(in_memory)?;
    }
    Ok(rows.into_text().into_bytes())
}
