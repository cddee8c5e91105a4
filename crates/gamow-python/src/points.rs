//! Points: `sightings`, `disparity`, `stereo` and `curve`.

use std::fmt::Display;

use csv::ByteRecord;
use gamow::columns::{Batch, BatchRowError, GivenInputs, Header, ModelArgs, WantedColumns};
use gamow::commands::curve::CurveArgs;
use numpy::PyArray1;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict as _, PyDict, PyString};
use relativity_core::Model;
use relativity_core::threads::goes_on;

use crate::arrays::{Columns, dictionary, results};
use crate::errors::{of_command, value_error};
use crate::flags::parsed;
use crate::threads::{detached, interruptible};

/// Computes what both eyes see of points: the columns of `gamow eval`.
#[pyfunction]
#[pyo3(signature = (*, model = "exact", intensity_exponent = None, conformal = false, out = None, **columns))]
pub fn sightings<'py>(
    py: Python<'py>,
    model: &str,
    intensity_exponent: Option<&Bound<'py, PyAny>>,
    conformal: bool,
    out: Option<&Bound<'py, PyDict>>,
    columns: Option<Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
    let model = ModelArgs { conformal, ..model_of(model, intensity_exponent)? };
    filled(py, WantedColumns::All, model, out, columns)
}

/// Computes the disparities of points.
#[pyfunction]
#[pyo3(signature = (*, model = "exact", out = None, **columns))]
pub fn disparity<'py>(
    py: Python<'py>,
    model: &str,
    out: Option<&Bound<'py, PyDict>>,
    columns: Option<Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
    filled(py, WantedColumns::Disparity, model_of(model, None)?, out, columns)
}

/// Computes where two eyes take points to be.
#[pyfunction]
#[pyo3(signature = (*, model = "exact", out = None, **columns))]
pub fn stereo<'py>(
    py: Python<'py>,
    model: &str,
    out: Option<&Bound<'py, PyDict>>,
    columns: Option<Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
    filled(py, WantedColumns::Stereo, model_of(model, None)?, out, columns)
}

/// Computes what both eyes see of one point over a range of times.
#[pyfunction]
#[pyo3(signature = (**flags))]
pub fn curve<'py>(py: Python<'py>, flags: Option<&Bound<'py, PyDict>>) -> PyResult<Bound<'py, PyDict>> {
    let args: CurveArgs = parsed(flags, Vec::new(), &["out"])?;
    if args.samples() > MOST_SAMPLES {
        return Err(value_error(format_args!(
            "samples = {}: must be at most {MOST_SAMPLES}, which fit into memory",
            args.samples()
        )));
    }
    let table = interruptible(py, || {
        let goes_on = goes_on();
        let curve = args.curve()?;
        let names = curve.columns()?;
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); names.len()];
        for row in curve.rows().take_while(|_| goes_on()) {
            columns.iter_mut().zip(row?).for_each(|(column, value)| column.push(value));
        }
        Ok((names, columns))
    })?;
    let (names, columns) = table.map_err(|error: anyhow::Error| of_command(&error))?;
    let arrays = columns.into_iter().map(|column| PyArray1::from_vec(py, column));
    names.into_iter().zip(arrays).into_py_dict(py)
}

/// The most samples of a curve: some gigabytes.
const MOST_SAMPLES: u64 = 10_000_000;

/// Keywords that are columns of `gamow eval`, apart from the observer's.
const INPUTS: [&str; 13] =
    ["beta", "gamma", "rapidity", "d", "y", "z", "T", "x0", "roll", "turn", "wheel_radius", "rho", "angle"];

/// The binocular model of this name, with this intensity exponent.
fn model_of(name: &str, exponent: Option<&Bound<'_, PyAny>>) -> PyResult<ModelArgs> {
    let Some(model) = Model::ALL.into_iter().find(|model| model.name() == name) else {
        let known = Model::ALL.map(Model::name).join(", ");
        return Err(value_error(format_args!("model = {name}: must be one of {known}")));
    };
    let text = match exponent {
        None => "surface".to_owned(),
        Some(word) if word.is_instance_of::<PyString>() => word.extract()?,
        Some(number) => number.extract::<f64>()?.to_string(),
    };
    let intensity_exponent = gamow::flags::column_exponent(&text);
    let wrong = |problem| value_error(format_args!("intensity_exponent = {text}: {problem}"));
    let intensity_exponent = intensity_exponent.map_err(wrong)?;
    Ok(ModelArgs { model, intensity_exponent, stereo: false, conformal: false })
}

/// Fills the `wanted` columns of the points that `columns` describe.
fn filled<'py>(
    py: Python<'py>,
    wanted: WantedColumns,
    model: ModelArgs,
    out: Option<&Bound<'py, PyDict>>,
    columns: Option<Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
    let columns = Columns::new(&columns.unwrap_or_else(|| PyDict::new(py)))?;
    if let Some(name) =
        columns.names.iter().find(|name| !INPUTS.contains(&name.as_str()) && !name.starts_with("observer_"))
    {
        return Err(PyTypeError::new_err(format!(
            "there is no keyword `{name}`: there are {}",
            INPUTS.join(", ")
        )));
    }
    let names: ByteRecord = columns.names.iter().collect();
    let header = Header::new(names, |_: GivenInputs| Ok(Vec::new()));
    let header = header.map_err(|error| value_error(of_input(&error)))?;
    let written = wanted.columns(&model, header.given()).map_err(value_error)?;
    let mut arrays = results(py, &written, &columns.shape, out)?;
    let (rows, inputs) = (columns.rows(), columns.inputs()?);
    let batch = Batch { header: &header, inputs: &inputs, rows };
    let mut slices =
        arrays.iter_mut().map(|array| Ok(array.as_slice_mut()?)).collect::<PyResult<Vec<_>>>()?;
    let filled = if rows <= PART {
        detached(py, || batch.fill(wanted, &model, slices))
    } else {
        interruptible(py, || fill_in_parts(&batch, wanted, &model, &mut slices))
    };
    filled?.map_err(|error| value_error(format_args!("{}{}", columns.place(error.row), of_input(&error))))?;
    dictionary(py, &written, arrays, out)
}

/// The message of an error in the columns, which are keywords here.
fn of_input(error: &dyn Display) -> String {
    let error = error.to_string();
    let Some(text) = error.strip_prefix("column ").or_else(|| error.strip_prefix("columns ")) else {
        return error;
    };
    let twice = text.split_once(": ").filter(|(name, rest)| rest.starts_with(&format!("{name} = ")));
    twice.map_or(text, |(_, rest)| rest).to_owned()
}

/// Greatest number of rows that are filled between two looks at whether the others are wanted.
const PART: usize = 1 << 17;

/// Fills one part of the rows after the other.
fn fill_in_parts(
    batch: &Batch<'_>,
    wanted: WantedColumns,
    model: &ModelArgs,
    out: &mut [&mut [f64]],
) -> Result<(), BatchRowError> {
    let goes_on = goes_on();
    for first in (0..batch.rows).step_by(PART).take_while(|_| goes_on()) {
        let rows = PART.min(batch.rows - first);
        let inputs: Vec<_> = batch.inputs.iter().map(|input| input.rows(first..first + rows)).collect();
        let out = out.iter_mut().map(|column| &mut column[first..first + rows]).collect();
        let filled = Batch { header: batch.header, inputs: &inputs, rows }.fill(wanted, model, out);
        filled.map_err(|error| BatchRowError { row: first + error.row, ..error })?;
    }
    Ok(())
}
