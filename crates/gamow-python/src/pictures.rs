//! Pictures: `render` and `measure`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use gamow::commands::measure::MeasureArgs;
use gamow::commands::render::fitted;
use gamow::flags::choices::FileKind;
use gamow::studio::Studio;
use gamow::studio::film::frame_path;
use numpy::PyArray1;
use pyo3::exceptions::{PyTypeError, PyUserWarning};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyDictMethods};

use crate::errors::{of_command, value_error};
use crate::flags::parsed;
use crate::state::State;
use crate::threads::detached;

/// The picture of a state, as `gamow render` draws it.
///
/// state and the further keywords are those of `gamow.State`. Returns an array of shape (height, width, 3) of
/// 8-bit sRGB: the pixels of the command's PNG file; of pictures that alternate, (count, height, width, 3).
/// With channels=True, what every pixel shows, a dict of arrays of shape (height, width) of 32-bit floats by
/// the names of the command's EXR channels: left.id, right.id, left.distance, left.emission_time,
/// left.doppler and so on.
///
/// The interpreter's lock is released. renderer='reference' draws the same on every machine.
#[pyfunction]
#[pyo3(signature = (state = None, /, *, channels = false, **settings))]
pub fn render<'py>(
    py: Python<'py>,
    state: Option<&Bound<'py, PyAny>>,
    channels: bool,
    settings: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let keywords = PyDict::new(py);
    keywords.set_item("channels", channels)?;
    let state = py.get_type::<State>().call((state,), settings)?;
    state.call_method("render", (), Some(&keywords))
}

/// Angles of a point or a body, measured in pictures as `gamow measure` does: a dict of arrays that
/// `gamow.fit` takes.
///
/// source is a file by `gamow render` (.exr; .png for a marker), a folder of such files, or a list of these;
/// or a State, which is drawn at each T in times. The keywords are the command's flags: one of point=(x, y,
/// z), object=name and marker='ff0000'; of photographs times, d, fov, gaze, projection, layout, roll and
/// turn. Returns T, d, phi_left and so on, radians.
///
/// Remarks of the command are warnings.
#[pyfunction]
#[pyo3(signature = (source, /, **flags))]
pub fn measure<'py>(
    py: Python<'py>,
    source: &Bound<'py, PyAny>,
    flags: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
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
) -> PyResult<Bound<'py, PyDict>> {
    let words = std::iter::once(OsString::from("--")).chain(files.iter().map(|file| file.clone().into()));
    let args: MeasureArgs = parsed(flags, words.collect(), &["out"])?;
    let table = detached(py, || args.measured())?.map_err(|error| of_command(&error))?;
    for remark in &table.remarks {
        let remark = std::ffi::CString::new(remark.replace('\0', " "))?;
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), &remark, 1)?;
    }
    let columns = PyDict::new(py);
    for (index, name) in table.columns.iter().enumerate() {
        let column = table.rows.iter().map(|row| row[index]).collect();
        columns.set_item(name, PyArray1::from_vec(py, column))?;
    }
    Ok(columns)
}

/// Measures angles in files of a state that are drawn for it.
fn measured_in_state<'py>(
    py: Python<'py>,
    state: &State,
    flags: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let times = flags.get_item("times")?;
    let times: Vec<f64> = match times {
        Some(times) => times.extract()?,
        None => return Err(value_error("times: the T at which the state is drawn are needed")),
    };
    flags.del_item("times")?;
    let kind = if flags.contains("marker")? { FileKind::Png } else { FileKind::Exr };
    let folder = py.import("tempfile")?.call_method0("TemporaryDirectory")?;
    let place: PathBuf = folder.getattr("name")?.extract()?;
    let mut settings = state.settings().clone();
    let scene = Path::new(&settings.scene);
    if let Some(name) = scene.file_name().filter(|_| gamow_platform::files::is_file(scene)) {
        // Files name the scene beside them.
        let copy = place.join(name);
        py.import("shutil")?.call_method1("copyfile", (scene, &copy))?;
        settings.scene = copy.to_string_lossy().into_owned();
    }
    let drawn = detached(py, || {
        let mut studio = Studio::new(fitted(settings)?)?;
        let draw = |(number, &time): (usize, &f64)| {
            let path = frame_path(&place, u32::try_from(number)?, kind);
            let frame = studio.frame(Some(time))?;
            studio.make_file(&frame, kind, &path)
        };
        times.iter().enumerate().try_for_each(draw)
    });
    let drawn = drawn.and_then(|drawn: anyhow::Result<()>| drawn.map_err(|error| of_command(&error)));
    let measured = drawn.and_then(|()| measured_in_files(py, &[place], Some(flags)));
    folder.call_method0("cleanup")?;
    measured
}
