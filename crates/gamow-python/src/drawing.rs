//! What settings show: as an array of pixels, as measurements, and as a PNG file.

use std::path::Path;

use gamow::commands::render::fitted;
use gamow::files::exr::Measurements;
use gamow::scene::Scene;
use gamow::settings::Settings;
use gamow::studio::Studio;
use numpy::{PyArray1, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyDictMethods};

use crate::errors::of_command;
use crate::threads::interruptible;

/// Settings to draw, and their scene if that is in no file.
#[derive(Clone, Copy)]
pub struct Shown<'a> {
    /// Settings of the picture.
    pub settings: &'a Settings,
    /// The scene, in place of that which the settings name.
    pub own_scene: Option<&'a Scene>,
}

/// The studio of `shown` and its frame, for `work`.
fn drawn<T: Send>(
    py: Python<'_>,
    shown: Shown<'_>,
    work: impl FnOnce(&mut Studio, &gamow::studio::StudioFrame) -> anyhow::Result<T> + Send,
) -> PyResult<T> {
    let result = interruptible(py, || {
        let settings = fitted(shown.settings.clone())?;
        let mut studio = match shown.own_scene {
            Some(scene) => Studio::showing(settings, scene.clone())?,
            None => Studio::new(settings)?,
        };
        let frame = studio.frame(None)?;
        work(&mut studio, &frame)
    })?;
    result.map_err(|error| of_command(&error))
}

/// The picture as an array.
pub fn rgb_of<'py>(py: Python<'py>, shown: Shown<'_>) -> PyResult<Bound<'py, PyAny>> {
    let frames = drawn(py, shown, |studio, frame| Ok(studio.still(frame)?.frames))?;
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
pub fn channels_of<'py>(py: Python<'py>, shown: Shown<'_>) -> PyResult<Bound<'py, PyDict>> {
    let Measurements { size, channels, .. } =
        drawn(py, shown, |studio, frame| studio.measurements(frame, Path::new("")))?;
    let [width, height] = size.map(|side| side as usize);
    let dictionary = PyDict::new(py);
    for (name, values) in channels {
        dictionary.set_item(name, PyArray1::from_vec(py, values).reshape([height, width])?)?;
    }
    Ok(dictionary)
}

/// The contents of a PNG file of the picture.
pub fn png_of<'py>(py: Python<'py>, shown: Shown<'_>) -> PyResult<Bound<'py, PyBytes>> {
    let bytes = drawn(py, shown, |studio, frame| studio.png(frame, Path::new("gamow.png")))?;
    Ok(PyBytes::new(py, &bytes))
}
