//! The function `fit`: speed and distance from readings.

use std::io::{Cursor, Read};
use std::path::PathBuf;

use csv::ByteRecord;
use gamow::columns::Column;
use gamow::commands::fit::FitArgs;
use gamow::estimate::FitReport;
use gamow::files::csv_out::CsvWriter;
use gamow::files::{csv_in, whole};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use relativity_core::threads::goes_on;

use crate::arrays::Columns;
use crate::errors::{of_command, value_error};
use crate::flags::parsed;
use crate::threads::interruptible;

/// Fits speed and distance of a point to the disparities that two eyes measured: what `gamow fit --json`
/// writes, the numbers of the rows that are readings, and the residuals of these by curve.
#[pyfunction]
#[pyo3(signature = (data, /, **flags))]
pub fn fit<'py>(
    py: Python<'py>,
    data: &Bound<'py, PyAny>,
    flags: Option<&Bound<'py, PyDict>>,
) -> PyResult<(Bound<'py, PyAny>, Vec<usize>, Bound<'py, PyDict>)> {
    let args: FitArgs = parsed(flags, Vec::new(), &["out", "json"])?;
    let mut columns = None;
    let report = if let Ok(path) = data.extract::<PathBuf>() {
        interruptible(py, || {
            let (name, input) = csv_in::open(Some(&path))?;
            fitted(&args, &name, input)
        })?
    } else {
        let given = columns.insert(Columns::new(data.cast::<PyDict>()?)?);
        let csv = csv_of(given)?;
        interruptible(py, || fitted(&args, "data", Cursor::new(csv)))?
    };
    let report: FitReport = report.map_err(|error| of_fit(&error, columns.as_ref()))?;
    let mut json = Vec::new();
    whole::write_json(&report, &mut json).map_err(|error| of_command(&error))?;
    let json = PyString::new(py, &String::from_utf8_lossy(&json));
    let rows = report.lines.iter().map(|&line| row_of(line).unwrap_or_default()).collect();
    let residuals = PyDict::new(py);
    for (name, values) in ["dphi", "dtheta"].into_iter().zip(report.misses) {
        if values.iter().any(|value| !value.is_nan()) {
            residuals.set_item(name, PyArray1::from_vec(py, values))?;
        }
    }
    Ok((py.import("json")?.call_method1("loads", (json,))?, rows, residuals))
}

/// The fit of the readings in `input`, with the replicates that are drawn until it is given up.
fn fitted(args: &FitArgs, name: &str, input: impl Read) -> anyhow::Result<FitReport> {
    let goes_on = goes_on();
    args.fitted_while(name, input, |_| goes_on())
}

/// The columns as a CSV file: its first row has the names, so that row n of an array, from 0, is line n + 2.
fn csv_of(columns: &Columns<'_>) -> PyResult<Vec<u8>> {
    let inputs = columns.inputs()?;
    let mut rows = CsvWriter::new(Vec::new());
    let in_memory = |_| value_error("data: there is no memory for it");
    rows.write(&mut columns.names.iter().collect(), &[]).map_err(in_memory)?;
    for row in 0..columns.rows() {
        let values: Vec<f64> = inputs.iter().map(|input: &Column<'_, f64>| input.at(row)).collect();
        if let Some(place) = values.iter().position(|value| value.is_infinite()) {
            let (place, name) = (columns.place(row), &columns.names[place]);
            return Err(value_error(format_args!("data: {place}column {name}: a number must be finite")));
        }
        rows.write(&mut ByteRecord::new(), &values).map_err(in_memory)?;
    }
    Ok(rows.into_text().into_bytes())
}

/// The row of an array, from 0, that is this line of a CSV file; `None` for its first, the names.
fn row_of(line: u64) -> Option<usize> {
    usize::try_from(line).ok()?.checked_sub(2)
}

/// The error of a fit, which names rows of `columns` where those are fitted and no file.
fn of_fit(error: &anyhow::Error, columns: Option<&Columns<'_>>) -> PyErr {
    let text = format!("{error:#}")
        .replace("the header should name", "there should be")
        .replace(", and it names ", "; there are ");
    let of_row = columns.and_then(|columns| {
        let (line, rest) = text.strip_prefix("data:")?.split_once(':')?;
        let place = row_of(line.parse().ok()?).map_or_else(String::new, |row| columns.place(row));
        Some(format!("data: {place}{}", rest.trim_start()))
    });
    value_error(of_row.unwrap_or(text))
}
