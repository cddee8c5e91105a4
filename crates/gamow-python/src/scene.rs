//! `Scene`: what moves, and what it is called.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use gamow::files::whole::write_whole;
use gamow_platform::files;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};

use crate::errors::{of_command, value_error};
use crate::flags::word;
use crate::tables;

/// A scene: the bodies that ride past, their names, and the groups in which they move.
///
/// source is the name of a preset ('cyclist'), the path of a scene file, TOML text, or a dict as in TOML:
/// {'name': 'Ball', 'object': [{'shape': 'sphere', 'centre': (0, 3, 2), 'radius': 0.5}]}. Without it, the
/// street. State(scene=scene) shows it; one from text or a dict must be saved before. Lengths are in the
/// scene's unit, places in the rest frame of their group. assets/scenes/README.md describes the format.
#[pyclass(frozen, eq, module = "gamow")]
#[derive(PartialEq)]
pub struct Scene {
    scene: gamow::scene::Scene,
    source: SceneSource,
}

/// What a scene was made from, which names it in settings and pictures.
#[derive(Debug, Clone, PartialEq, Eq)]
enum SceneSource {
    /// A preset's name or a file's path.
    Named(String),
    /// The text of a file that is not written.
    Text(String),
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (source = None, /))]
    fn new(source: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let source = source.map_or_else(|| Ok(SceneSource::Named("street".to_owned())), sourced)?;
        let scene = match &source {
            SceneSource::Named(name) => gamow::scene::Scene::open(name),
            SceneSource::Text(text) => gamow::scene::Scene::parse(text, "scene"),
        };
        Ok(Self { scene: scene.map_err(value_error)?, source })
    }

    /// The name of the scene, as the window shows it.
    #[getter]
    fn name(&self) -> &str {
        &self.scene.name
    }

    /// The length of a unit in metres; None if the scene leaves it open.
    #[getter]
    const fn metres(&self) -> Option<f64> {
        self.scene.metres
    }

    /// The names of all bodies: the one at index i has the number i in the channels left.id and right.id.
    #[getter]
    fn objects(&self) -> Vec<String> {
        self.scene.names.clone()
    }

    /// The groups in the order of the channels left.group and right.group: the name of each, and the numbers
    /// of its bodies.
    #[getter]
    fn groups(&self) -> Vec<(String, Vec<usize>)> {
        let groups = self.scene.groups.iter();
        groups.map(|group| (group.name.clone(), group.bodies().collect())).collect()
    }

    /// The place (x, y, z) of a point at rest in the frame of its group: the forward-most of the body of this
    /// name or number; the point that is selected at first, without one. On the ground x0 is x/gamma.
    #[pyo3(signature = (object = None, /))]
    fn place(&self, object: Option<&Bound<'_, PyAny>>) -> PyResult<[f64; 3]> {
        let Some(object) = object else { return Ok(self.scene.tracked) };
        let name: String = object.str()?.extract()?;
        let body = self.scene.body_called(&name).map_err(value_error)?;
        Ok(self.scene.bodies[body].shape.forward_most().into())
    }

    /// Writes a scene from text or a dict as a scene file, whole or not at all, and returns the scene in that
    /// file.
    fn save(&self, path: PathBuf) -> PyResult<Self> {
        let SceneSource::Text(text) = &self.source else {
            return Err(value_error(
                "a preset or a file is a scene file already: only text and dicts are saved",
            ));
        };
        write_whole(&path, |file| Ok(file.write_all(text.as_bytes())?))
            .map_err(|error| of_command(&error))?;
        let named =
            path.into_os_string().into_string().map_err(|_| value_error("path: must be text in UTF-8"))?;
        Ok(Self { scene: self.scene.clone(), source: SceneSource::Named(named) })
    }

    /// The preset's name or the file's path, so that a scene can be given wherever a path can.
    fn __fspath__(&self) -> PyResult<&str> {
        match &self.source {
            SceneSource::Named(name) => Ok(name),
            SceneSource::Text(_) => Err(value_error(
                "a scene from text or a dict has no file: scene.save('scene.toml') writes one",
            )),
        }
    }

    /// Pickles the scene as its name, its path or its text, for workers in other processes.
    fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyType>, (&str,)) {
        let (SceneSource::Named(text) | SceneSource::Text(text)) = &self.source;
        (py.get_type::<Self>(), (text,))
    }

    /// The scene itself, which never changes.
    fn __copy__(scene: Bound<'_, Self>) -> Bound<'_, Self> {
        scene
    }

    /// As `copy.copy`.
    fn __deepcopy__<'py>(scene: Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        scene
    }

    fn __repr__(&self) -> String {
        let (SceneSource::Named(text) | SceneSource::Text(text)) = &self.source;
        format!("Scene({text:?})")
    }
}

/// Returns the source that a value of Python names or holds.
fn sourced(source: &Bound<'_, PyAny>) -> PyResult<SceneSource> {
    if let Ok(scene) = source.cast::<Scene>() {
        return Ok(scene.get().source.clone());
    }
    if let Ok(dict) = source.cast::<PyDict>() {
        return Ok(SceneSource::Text(tables::table(dict, str::to_owned)?.to_string()));
    }
    let text = word("scene", source)?
        .ok_or_else(|| value_error("a scene is a name, a path, TOML text, a dict or a Scene"))?;
    let is_toml = text.contains('\n') || text.contains('=') && !files::is_file(Path::new(&text));
    Ok(if is_toml { SceneSource::Text(text) } else { SceneSource::Named(text) })
}
