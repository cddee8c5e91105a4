//! Points: `sightings`, `disparity`, `stereo` and `curve`.

use csv::ByteRecord;
use gamow::columns::{Batch, GivenInputs, Header, ModelArgs, WantedColumns};
use gamow::commands::curve::CurveArgs;
use numpy::PyArray1;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use relativity_core::Model;

use crate::arrays::{Columns, dictionary, results};
use crate::errors::{of_command, value_error};
use crate::flags::parsed;
use crate::threads::detached;

/// Computes what both eyes see of points: the columns of `gamow eval`.
///
/// Every keyword is a number or an array; they are broadcast together as NumPy does. c = 1, lengths and times
/// share one unit, angles are radians. Speeds: one of beta, gamma, rapidity. d: separation of the eyes. y, z:
/// depth and height. T: when the light arrives. x0: the point's x at t = 0. roll, turn: tilt and turn of the
/// head. wheel_radius, rho, angle: a point on a rolling wheel, whose hub x0, y and z then are. observer_beta
/// (or observer_gamma, observer_rapidity), observer_azimuth, observer_elevation, observer_x, observer_y,
/// observer_z: how the eyes move.
///
/// model is 'exact', 'one-cone', 'published' or 'published-text'; intensity_exponent a number, 'surface',
/// 'photons' or 'paper'. conformal adds u and v. out is a dict of arrays to fill, such as an earlier result.
///
/// Returns a dict of arrays of the common shape: x_left, x_right, t_left and so on. A value out of range is a
/// ValueError that names its column and its index. Source: docs/commands.md; the exact model is that of the
/// crate relativity-core.
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

/// Computes the disparities of points, left minus right: dphi and dtheta, radians.
///
/// The keywords are those of `sightings`. Where nothing but T is an array, the batch form of the core is
/// used.
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

/// Computes where two eyes take points to be: the columns stereo_gain, stereo_x, stereo_y and stereo_z of
/// `gamow eval --stereo`.
///
/// The keywords are those of `sightings`. A tilted or turned head, a wheel or a moving observer adds
/// stereo_miss, the distance at which the lines of sight pass each other. Values are NaN where these do not
/// meet in front of the eyes.
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

/// Computes what both eyes see of one point over a range of times: the columns of `gamow curve`, whose flags
/// are the keywords.
///
/// Such as beta, d, y, z, x0, from_, to, samples, stereo, conformal, model; wheel_radius, rho, angle;
/// observer_beta. As on the command line roll, turn, observer_azimuth and observer_elevation are degrees
/// here. Returns a dict of arrays.
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
    let table = detached(py, || {
        let curve = args.curve()?;
        let names = curve.columns()?;
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); names.len()];
        for row in curve.rows() {
            columns.iter_mut().zip(row?).for_each(|(column, value)| column.push(value));
        }
        Ok((names, columns))
    })?;
    let (names, columns) = table.map_err(|error: anyhow::Error| of_command(&error))?;
    let dictionary = PyDict::new(py);
    for (name, column) in names.into_iter().zip(columns) {
        dictionary.set_item(name, PyArray1::from_vec(py, column))?;
    }
    Ok(dictionary)
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
    let header = Header::new(names, |_: GivenInputs| Ok(Vec::new())).map_err(value_error)?;
    let written = wanted.columns(&model, header.given()).map_err(value_error)?;
    let mut arrays = results(py, &written, &columns.shape, out)?;
    let (rows, inputs) = (columns.rows(), columns.inputs()?);
    let batch = Batch { header: &header, inputs: &inputs, rows };
    let slices = arrays.iter_mut().map(|array| Ok(array.as_slice_mut()?)).collect::<PyResult<Vec<_>>>()?;
    detached(py, || batch.fill(wanted, &model, slices))?
        .map_err(|error| value_error(format_args!("{}{error}", columns.place(error.row))))?;
    dictionary(py, &written, arrays, out)
}
