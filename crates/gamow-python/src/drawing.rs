//! What settings show: as an array of pixels, as measurements, and as a PNG file.

use std::path::Path;

use gamow::commands::render::fitted;
use gamow::files::exr::Measurements;
use gamow::settings::Settings;
use gamow::studio::Studio;
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyDictMethods};

use crate::errors::of_command;
use crate::threads::detached;

/// The studio of `settings` and the frame that they show, for `work`.
fn drawn<T: Send>(
    py: Python<'_>,
    settings: &Settings,
    work: impl FnOnce(&mut Studio, &gamow::studio::StudioFrame) -> anyhow::Result<T> + Send,
) -> PyResult<T> {
    let result = detached(py, || {
        let mut studio = Studio::new(fitted(settings.clone())?)?;
        let frame = studio.frame(None)?;
        work(&mut studio, &frame)
    })?;
    result.map_err(|error| of_command(&error))
}

/// The picture as an array.
pub fn rgb_of<'py>(py: Python<'py>, settings: &Settings) -> PyResult<Bound<'py, PyAny>> {
    let frames = drawn(py, settings, |studio, frame| Ok(studio.still(frame)?.frames))?;
    let size = frames.first().map_or([0; 2], |frame| frame.size);
    let [width, height] = size.map(|side| side as usize);
    let rgb =
        frames.iter().flat_map(|frame| &frame.rgba).flat_map(|&[red, green, blue, _]| [red, green, blue]);
    let rgb = PyArray1::from_vec(py, rgb.collect());
    Ok(match frames.len() {
        1 => rgb.reshape([height, width, 3])?.into_any(),
        count => rgb.reshape([count, height, width, 3])?.into_any(),
    })
}

/// The measurements as arrays by the names of their channels.
pub fn channels_of<'py>(py: Python<'py>, settings: &Settings) -> PyResult<Bound<'py, PyDict>> {
    let Measurements { size, channels, .. } =
        drawn(py, settings, |studio, frame| studio.measurements(frame, Path::new("")))?;
    let [width, height] = size.map(|side| side as usize);
    let dictionary = PyDict::new(py);
    for (name, values) in channels {
        dictionary.set_item(name, PyArray1::from_vec(py, values).reshape([height, width])?)?;
    }
    Ok(dictionary)
}

/// The contents of a PNG file of the picture.
pub fn png_of<'py>(py: Python<'py>, settings: &Settings) -> PyResult<Bound<'py, PyBytes>> {
    let bytes = drawn(py, settings, |studio, frame| studio.png(frame, Path::new("gamow.png")))?;
    Ok(PyBytes::new(py, &bytes))
}
