//! `Scene`: what moves, and what it is called.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use gamow::files::whole::write_whole;
use gamow::scene::PRESETS;
use gamow::settings::Preset;
use gamow_platform::files;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict as _, PyDict, PyType};

use crate::errors::{of_command, value_error};
use crate::flags::word;
use crate::tables;

/// A scene: the bodies that ride past, their names, and the groups in which they move.
///
/// Args:
///     source: name of a preset (`gamow.scenes`); path of a scene file; TOML text; a dict as in TOML, such as
///         {'name': 'Ball', 'object': [{'shape': 'sphere', 'centre': (0, 3, 2), 'radius': 0.5}]}; another
///         Scene. The street without it.
///
/// Lengths are in the scene's unit, places in the rest frame of their group. State(scene) shows it.
/// assets/scenes/README.md describes the format.
///
/// Raises:
///     ValueError: a file that breaks a rule of the format, with its line; a preset that does not exist.
#[pyclass(frozen, eq, module = "gamow")]
#[derive(PartialEq)]
pub struct Scene(SceneSource);

/// What a scene was made from, which names it in settings and pictures.
#[derive(Clone, PartialEq)]
enum SceneSource {
    /// A preset's name or a file's path, and the scene.
    Named(String, Arc<gamow::scene::Scene>),
    /// A scene that is in no file.
    Own(Arc<OwnScene>),
}

/// A scene that is in no file, and the text of such a one.
#[derive(PartialEq)]
pub struct OwnScene {
    /// The scene as a file, TOML.
    pub text: String,
    /// Scene that the text describes.
    pub scene: gamow::scene::Scene,
}

impl OwnScene {
    /// Reads the scene in `text`.
    ///
    /// # Errors
    ///
    /// A text that breaks a rule of the format.
    pub fn parsed(text: String) -> PyResult<Self> {
        let scene = gamow::scene::Scene::parse(&text, "scene").map_err(value_error)?;
        Ok(Self { text, scene })
    }
}

impl From<Arc<OwnScene>> for Scene {
    fn from(own: Arc<OwnScene>) -> Self {
        Self(SceneSource::Own(own))
    }
}

impl Scene {
    /// The scene if it is in no file.
    pub fn own(&self) -> Option<Arc<OwnScene>> {
        match &self.0 {
            SceneSource::Own(own) => Some(Arc::clone(own)),
            SceneSource::Named(..) => None,
        }
    }

    fn scene(&self) -> &gamow::scene::Scene {
        match &self.0 {
            SceneSource::Own(own) => &own.scene,
            SceneSource::Named(_, scene) => scene,
        }
    }

    /// The name, the path or the text from which it was made.
    fn text(&self) -> &str {
        match &self.0 {
            SceneSource::Own(own) => &own.text,
            SceneSource::Named(name, _) => name,
        }
    }

    fn named(name: String) -> PyResult<Self> {
        let scene = gamow::scene::Scene::open(&name).map_err(value_error)?;
        Ok(Self(SceneSource::Named(name, Arc::new(scene))))
    }
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (source = None, /))]
    fn new(source: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        source.map_or_else(|| Self::named("street".to_owned()), made_from)
    }

    /// The name of the scene, as the window shows it.
    #[getter]
    fn name(&self) -> &str {
        &self.scene().name
    }

    /// The length of a unit in metres; None if the scene leaves it open.
    #[getter]
    fn metres(&self) -> Option<f64> {
        self.scene().metres
    }

    /// The names of all bodies: the one at index i has the number i in the channels left.id and right.id.
    #[getter]
    fn objects(&self) -> Vec<String> {
        self.scene().names.clone()
    }

    /// The groups in the order of the channels left.group and right.group: the name of each, and the numbers
    /// of its bodies.
    #[getter]
    fn groups(&self) -> Vec<(String, Vec<usize>)> {
        let groups = self.scene().groups.iter();
        groups.map(|group| (group.name.clone(), group.bodies().collect())).collect()
    }

    /// The place (x, y, z) of a point at rest in the frame of its group: the forward-most of the body of this
    /// name or number; the point that is selected at first, without one. On the ground x0 is x/gamma.
    #[pyo3(signature = (object = None, /))]
    fn place(&self, object: Option<&Bound<'_, PyAny>>) -> PyResult<[f64; 3]> {
        let Some(object) = object else { return Ok(self.scene().tracked) };
        let name: String = object.str()?.extract()?;
        let body = self.scene().body_called(&name).map_err(value_error)?;
        Ok(self.scene().bodies[body].shape.forward_most().into())
    }

    /// Writes a scene from text or a dict as a scene file, whole or not at all, and returns the scene in that
    /// file.
    fn save(&self, path: PathBuf) -> PyResult<Self> {
        let SceneSource::Own(own) = &self.0 else {
            return Err(value_error(
                "a preset or a file is a scene file already: only text and dicts are saved",
            ));
        };
        write_whole(&path, |file| Ok(file.write_all(own.text.as_bytes())?))
            .map_err(|error| of_command(&error))?;
        let named =
            path.into_os_string().into_string().map_err(|_| value_error("path: must be text in UTF-8"))?;
        Ok(Self(SceneSource::Named(named, Arc::new(own.scene.clone()))))
    }

    /// The preset's name or the file's path, so that a scene can be given wherever a path can.
    fn __fspath__(&self) -> PyResult<&str> {
        match &self.0 {
            SceneSource::Named(name, _) => Ok(name),
            SceneSource::Own(_) => Err(value_error(
                "a scene from text or a dict has no file: scene.save('scene.toml') writes one",
            )),
        }
    }

    /// Pickles the scene as its name, its path or its text, for workers in other processes.
    fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyType>, (&str,)) {
        (py.get_type::<Self>(), (self.text(),))
    }

    /// The scene itself, which never changes.
    fn __copy__(scene: Bound<'_, Self>) -> Bound<'_, Self> {
        scene
    }

    /// As `copy.copy`.
    fn __deepcopy__<'py>(scene: Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        scene
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.text().hash(&mut hasher);
        hasher.finish()
    }

    fn __repr__(&self) -> String {
        format!("Scene({:?})", self.text())
    }
}

/// Returns the scene that a value of Python names or holds.
fn made_from(source: &Bound<'_, PyAny>) -> PyResult<Scene> {
    if let Ok(scene) = source.cast::<Scene>() {
        return Ok(Scene(scene.get().0.clone()));
    }
    let own = |text: String| Ok(Scene(SceneSource::Own(Arc::new(OwnScene::parsed(text)?))));
    if let Ok(dict) = source.cast::<PyDict>() {
        return own(tables::table(dict, str::to_owned)?.to_string());
    }
    let text = word("scene", source)?
        .ok_or_else(|| value_error("a scene is a name, a path, TOML text, a dict or a Scene"))?;
    let is_toml = text.contains('\n') || text.contains('=') && !files::is_file(Path::new(&text));
    if is_toml { own(text) } else { Scene::named(text) }
}

/// The scenes that come with the program: the title of each by its name, which `Scene` and the setting scene
/// take.
#[pyfunction]
pub fn scenes(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let title = |name| gamow::scene::Scene::preset(name).map(|scene| scene.name);
    PRESETS.map(|name| (name, title(name))).into_py_dict(py)
}

/// The presets, best first: the title of each by its name, which `State` takes.
#[pyfunction]
pub fn presets(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    Preset::all().iter().map(|preset| (preset.name, &preset.title)).into_py_dict(py)
}
