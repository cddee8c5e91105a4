//! `State`: the settings of a picture.

use std::path::PathBuf;

use gamow::settings::{Settings, StartArgs, is_link};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyType};
use toml::Table;

use crate::errors::{of_command, value_error};
use crate::flags::parsed;
use crate::{drawing, tables};

/// The state of the program: everything that decides what a picture shows. In a notebook it shows its
/// picture.
///
/// source is the name of a preset, the path of a state file (.toml) or of a picture (.png) or measurements
/// (.exr) by `gamow render`, a link (gamow:?...), TOML text, a dict of settings as in TOML, or another State;
/// without it, the defaults. The keywords are the flags of `gamow render`, on top: State('street', beta=0.6,
/// size='640x480'). Lengths share one unit with times (c = 1), angles are degrees.
#[pyclass(frozen, eq, module = "gamow")]
#[derive(Clone, PartialEq)]
pub struct State {
    settings: Settings,
}

#[pymethods]
impl State {
    #[new]
    #[pyo3(signature = (source = None, /, **settings))]
    fn new(source: Option<&Bound<'_, PyAny>>, settings: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let (left, file) = match source {
            None => (Settings::default(), None),
            Some(source) => started(source)?,
        };
        let flags = file.map(|file| {
            let mut flag = std::ffi::OsString::from("--state=");
            flag.push(file);
            flag
        });
        let start: StartArgs = parsed(settings, flags.into_iter().collect(), &["state"])?;
        let settings = start.settings(left).map_err(|error| of_command(&error))?;
        Ok(Self { settings })
    }

    /// Return this state with other settings: the flags of `gamow render`.
    #[pyo3(signature = (**settings))]
    fn replace(&self, settings: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let start: StartArgs = parsed(settings, Vec::new(), &["state"])?;
        let settings = start.settings(self.settings.clone()).map_err(|error| of_command(&error))?;
        Ok(Self { settings })
    }

    /// Writes all settings as the text of a state file, TOML.
    fn toml(&self) -> String {
        self.settings.to_toml()
    }

    /// The link that opens this state in the window. A scene in a file of its own is a ValueError.
    fn link(&self) -> PyResult<String> {
        self.settings.link().map_err(value_error)
    }

    /// The picture, an array of shape (height, width, 3) of 8-bit sRGB; with channels, the measurements: see
    /// `gamow.render`.
    #[pyo3(signature = (*, channels = false))]
    fn render<'py>(&self, py: Python<'py>, channels: bool) -> PyResult<Bound<'py, PyAny>> {
        if channels {
            Ok(drawing::channels_of(py, &self.settings)?.into_any())
        } else {
            drawing::rgb_of(py, &self.settings)
        }
    }

    /// The picture as a PNG file, with a record of its settings: `gamow --state` opens it.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        drawing::png_of(py, &self.settings)
    }

    /// Pickles the state as its TOML text, for workers in other processes.
    fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyType>, (String,)) {
        (py.get_type::<Self>(), (self.toml(),))
    }

    fn __repr__(&self) -> String {
        match self.settings.link() {
            Ok(link) => format!("State('{link}')"),
            Err(_) => format!("State({:?})", self.settings.to_toml()),
        }
    }
}

impl State {
    /// Returns the settings of the state.
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }
}

/// Returns the settings in `source`, or the defaults and the name or path that `--state` takes.
fn started(source: &Bound<'_, PyAny>) -> PyResult<(Settings, Option<PathBuf>)> {
    if let Ok(state) = source.cast::<State>() {
        return Ok((state.get().settings.clone(), None));
    }
    let text = if let Ok(settings) = source.cast::<PyDict>() {
        table(settings)?.to_string()
    } else if let Ok(text) = source.extract::<String>() {
        let is_toml = text.contains('\n') || text.contains('=') && !is_link(text.as_ref());
        if !is_toml {
            return Ok((Settings::default(), Some(text.into())));
        }
        text
    } else if let Ok(path) = source.extract::<PathBuf>() {
        return Ok((Settings::default(), Some(path)));
    } else {
        return Err(value_error("a state is a name, a path, a link, TOML text, a dict or a State"));
    };
    let settings = Settings::default().with_toml(&text, "state");
    Ok((settings.map_err(value_error)?, None))
}

/// The settings in a dict, in sections or not.
fn table(settings: &Bound<'_, PyDict>) -> PyResult<Table> {
    for (key, value) in settings {
        let is_section = |value: &Bound<'_, PyAny>| value.is_instance_of::<PyDict>();
        if value.cast::<PyDict>().is_ok_and(|section| section.values().iter().any(|value| is_section(&value)))
        {
            return Err(value_error(format_args!("{key}: a section holds settings, and no sections")));
        }
    }
    tables::table(settings, |key| key.replace('_', "-"))
}
