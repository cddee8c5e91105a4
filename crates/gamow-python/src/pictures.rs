//! Angles in pictures: `measure`.

use std::ffi::OsString;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use gamow::commands::measure::MeasureArgs;
use gamow::commands::render::fitted;
use gamow::files::whole::write_whole;
use gamow::flags::choices::FileKind;
use gamow::studio::Studio;
use gamow::studio::film::frame_path;
use numpy::PyArray1;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict as _, PyDict, PyDictMethods};

use crate::errors::{of_command, value_error};
use crate::flags::parsed;
use crate::state::State;
use crate::threads::interruptible;

/// Measured columns by their names, and remarks on them.
type Measured<'py> = (Bound<'py, PyDict>, Vec<String>);

/// Measures angles of a point or a body in pictures; gives the columns, and the remarks.
#[pyfunction]
#[pyo3(signature = (source, /, **flags))]
pub fn measure<'py>(
    py: Python<'py>,
    source: &Bound<'py, PyAny>,
    flags: Option<&Bound<'py, PyDict>>,
) -> PyResult<Measured<'py>> {
    if let Ok(state) = source.cast::<State>() {
        let flags = flags.map_or_else(|| Ok(PyDict::new(py)), PyDictMethods::copy)?;
        return measured_in_state(py, state.get(), &flags);
    }
    let files: Vec<PathBuf> = match source.extract::<PathBuf>() {
        Ok(file) => vec![file],
        Err(_) => source
            .extract()
            .map_err(|_| PyTypeError::new_err("what is measured is a path, a list of paths or a State"))?,
    };
    measured_in_files(py, &files, flags)
}

fn measured_in_files<'py>(
    py: Python<'py>,
    files: &[PathBuf],
    flags: Option<&Bound<'py, PyDict>>,
) -> PyResult<Measured<'py>> {
    let words = std::iter::once(OsString::from("--")).chain(files.iter().map(|file| file.clone().into()));
    let args: MeasureArgs = parsed(flags, words.collect(), &["out"])?;
    let table = interruptible(py, || args.measured())?.map_err(|error| of_command(&error))?;
    let columns = table.columns.iter().enumerate().map(|(index, name)| {
        let column = table.rows.iter().map(|row| row[index]).collect();
        (name, PyArray1::from_vec(py, column))
    });
    Ok((columns.into_py_dict(py)?, table.remarks))
}

/// Measures angles in files of a state that are drawn for it.
fn measured_in_state<'py>(
    py: Python<'py>,
    state: &State,
    flags: &Bound<'py, PyDict>,
) -> PyResult<Measured<'py>> {
    let times = flags.get_item("times")?;
    let times: Vec<f64> = match times {
        Some(times) => times.extract()?,
        None => return Err(value_error("times: the T at which the state is drawn are needed")),
    };
    flags.del_item("times")?;
    let kind = if flags.contains("marker")? { FileKind::Png } else { FileKind::Exr };
    let folder = gamow_platform::files::temporary_folder()?;
    let place = folder.path();
    let mut settings = state.settings.clone();
    let scene = Path::new(&settings.scene);
    if let Some(own) = &state.own {
        let file = place.join("scene.toml");
        write_whole(&file, |out| Ok(out.write_all(own.text.as_bytes())?))
            .map_err(|error| of_command(&error))?;
        settings.scene = file.to_string_lossy().into_owned();
    } else if let Some(name) = scene.file_name().filter(|_| gamow_platform::files::is_file(scene)) {
        // Files name the scene beside them.
        let copy = place.join(name);
        py.import("shutil")?.call_method1("copyfile", (scene, &copy))?;
        settings.scene = copy.to_string_lossy().into_owned();
    }
    let drawn = interruptible(py, || {
        let mut studio = Studio::new(fitted(settings)?)?;
        let goes_on = relativity_core::threads::goes_on();
        let draw = |(number, &time): (usize, &f64)| {
            anyhow::ensure!(goes_on(), "given up");
            let path = frame_path(place, u32::try_from(number)?, kind);
            let frame = studio.frame(Some(time))?;
            studio.make_file(&frame, kind, &path)
        };
        times.iter().enumerate().try_for_each(draw)
    });
    drawn?.map_err(|error| of_command(&error))?;
    measured_in_files(py, &[place.to_owned()], Some(flags))
}
