//! `State`: the settings of a picture.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args as _, Command};
use gamow::settings::{Settings, StartArgs, is_link};
use pyo3::exceptions::{PyAttributeError, PyKeyError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyDictMethods};
use toml::Table;

use crate::errors::{keyword, of_command, value_error};
use crate::flags::{flag_name, parsed};
use crate::scene::{OwnScene, Scene};
use crate::{drawing, tables};

/// The state of the program: everything that decides what a picture shows. A notebook shows its picture.
///
/// Args:
///     source: name of a preset (`gamow.presets`); path of a state file (.toml), or of a picture (.png) or
///         measurements (.exr) by `gamow render`; a link (gamow:?...); TOML text; a dict of settings in
///         sections as in TOML; a Scene; another State. The defaults without it.
///     **settings: the flags of `gamow render`, on top: State('street', beta=0.6, size=(640, 480),
///         gaze=(60, 0)). Their names are the keys of the state. Lengths and times share one unit, that of
///         the scene (c = 1); angles are degrees, or Quantities.
///
/// A setting is read as state.beta or by its name in brackets, all of them as dict(state); None stands for
/// one that is found out from the others. States can be compared, hashed, pickled and copied.
///
/// Raises:
///     ValueError: a setting that is out of range, a preset or a file that does not exist.
///     TypeError: a setting that does not exist.
#[pyclass(frozen, eq, module = "gamow")]
#[derive(Clone, Default, PartialEq)]
pub struct State {
    /// The settings of the picture.
    pub settings: Settings,
    /// The scene, if it is in no file.
    pub own: Option<Arc<OwnScene>>,
}

/// The function that makes a state again, and the texts of its settings and its scene.
type Pickled<'py> = (Bound<'py, PyAny>, (String, Option<String>));

/// Name of a scene that is in no file, in settings.
const NO_FILE: &str = "./unsaved.toml";

#[pymethods]
impl State {
    #[new]
    #[pyo3(signature = (source = None, /, **settings))]
    fn new(source: Option<&Bound<'_, PyAny>>, settings: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let Some(source) = source else { return Self::default().with(settings, None) };
        if source.is_instance_of::<Scene>() {
            let with_scene = PyDict::new(source.py());
            with_scene.set_item("scene", source)?;
            return Self::default().with(Some(&with_scene), None)?.with(settings, None);
        }
        let (left, file) = started(source)?;
        left.with(settings, file)
    }

    /// Returns the state with other settings. A new scene ends a ride and drops the observation time, unless
    /// these are given with it.
    #[pyo3(signature = (**settings))]
    fn replace(&self, settings: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        self.clone().with(settings, None)
    }

    /// All settings as the text of a state file; a ValueError where the scene is in no file.
    fn toml(&self) -> PyResult<String> {
        if self.own.is_some() {
            return Err(value_error(
                "its scene is in no file: save it, and give the State what `save` returns",
            ));
        }
        Ok(self.settings.to_toml())
    }

    /// The link that opens this state in the window; a ValueError where its scene is a file, or in none.
    fn link(&self) -> PyResult<String> {
        self.settings.link().map_err(value_error)
    }

    /// The picture, or what its pixels show: see `gamow.render`.
    #[pyo3(signature = (*, channels = false))]
    fn render<'py>(&self, py: Python<'py>, channels: bool) -> PyResult<Bound<'py, PyAny>> {
        if channels {
            Ok(drawing::channels_of(py, self.shown())?.into_any())
        } else {
            drawing::rgb_of(py, self.shown())
        }
    }

    /// The picture as a PNG file, with a record of its settings: `gamow --state` opens it.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        drawing::png_of(py, self.shown())
    }

    /// The names of all settings.
    #[expect(clippy::unused_self, reason = "a method of Python's mappings")]
    fn keys(&self) -> Vec<String> {
        let flags = StartArgs::augment_args(Command::new("gamow"));
        let names = flags.get_arguments().filter_map(|flag| flag.get_long());
        names.filter(|name| *name != "state").map(keyword).collect()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let known = self.keys();
        if !known.iter().any(|key| key == name) {
            return Err(PyKeyError::new_err(name.to_owned()));
        }
        if let (Some(own), "scene") = (&self.own, name) {
            return Ok(Bound::new(py, Scene::from(Arc::clone(own)))?.into_any());
        }
        let all = Table::try_from(&self.settings).map_err(value_error)?;
        let key = flag_name(name);
        let sections = all.values().filter_map(toml::Value::as_table);
        let top = all.get(&key).filter(|value| !value.is_table());
        let value = top.or_else(|| sections.into_iter().find_map(|section| section.get(&key)));
        value.map_or_else(|| Ok(py.None().into_bound(py)), |value| tables::value_in_python(py, value))
    }

    fn __getattr__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.__getitem__(py, name)
            .map_err(|_| PyAttributeError::new_err(format!("a State has no setting `{name}`")))
    }

    fn __dir__<'py>(state: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let py = state.py();
        let names = py.import("builtins")?.getattr("object")?.call_method1("__dir__", (state,))?;
        names.call_method1("__add__", (state.get().keys(),))
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        // 0 and -0 are equal.
        self.settings.to_toml().replace("-0.0", "0.0").hash(&mut hasher);
        self.own.as_ref().map(|own| &own.text).hash(&mut hasher);
        hasher.finish()
    }

    /// Pickles the state as its TOML text, for workers in other processes.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Pickled<'py>> {
        let text = self.own.as_ref().map(|own| own.text.clone());
        Ok((py.get_type::<Self>().getattr("_restored")?, (self.settings.to_toml(), text)))
    }

    /// The state of these texts of settings and of a scene.
    #[staticmethod]
    fn _restored(settings: &str, scene: Option<String>) -> PyResult<Self> {
        let settings = Settings::default().with_toml(settings, "state").map_err(value_error)?;
        let own = scene.map(|text| OwnScene::parsed(text).map(Arc::new)).transpose()?;
        Ok(Self { settings, own })
    }

    /// The state itself, which never changes.
    fn __copy__(state: Bound<'_, Self>) -> Bound<'_, Self> {
        state
    }

    /// As `copy.copy`.
    fn __deepcopy__<'py>(state: Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        state
    }

    fn __repr__(&self) -> String {
        let settings = self.settings.to_toml();
        match (&self.own, self.settings.link()) {
            (Some(own), _) => format!("State({settings:?}, scene=Scene({:?}))", own.text),
            (None, Ok(link)) => format!("State('{link}')"),
            (None, Err(_)) => format!("State({settings:?})"),
        }
    }
}

impl State {
    fn shown(&self) -> drawing::Shown<'_> {
        drawing::Shown { settings: &self.settings, own_scene: self.own.as_deref().map(|own| &own.scene) }
    }

    /// This state with these settings on top of it, or of the file that `--state` takes.
    fn with(self, settings: Option<&Bound<'_, PyDict>>, file: Option<PathBuf>) -> PyResult<Self> {
        let settings = settings.map(PyDictMethods::copy).transpose()?;
        let mut own = self.own;
        if let Some(settings) = &settings
            && let Some(scene) = settings.get_item("scene")?.filter(|scene| !scene.is_none())
        {
            own = own_scene_in(&scene);
            if own.is_some() {
                settings.set_item("scene", NO_FILE)?;
            }
        }
        let flags = file.map(|file| {
            let mut flag = std::ffi::OsString::from("--state=");
            flag.push(file);
            flag
        });
        let start: StartArgs = parsed(settings.as_ref(), flags.into_iter().collect(), &["state"])?;
        let settings = start.settings(self.settings).map_err(|error| of_command(&error))?;
        Ok(Self { settings, own })
    }
}

/// Returns the state in `source`, or the default one and the name or path that `--state` takes.
fn started(source: &Bound<'_, PyAny>) -> PyResult<(State, Option<PathBuf>)> {
    if let Ok(state) = source.cast::<State>() {
        return Ok((state.get().clone(), None));
    }
    let (mut text, mut own) = (None, None);
    if let Ok(settings) = source.cast::<PyDict>() {
        let settings = settings.copy()?;
        let scene = settings.get_item("scene")?;
        own = scene.as_ref().and_then(own_scene_in);
        if own.is_some() {
            settings.set_item("scene", NO_FILE)?;
        }
        text = Some(table(&settings)?.to_string());
    } else if let Ok(word) = source.extract::<String>() {
        let is_toml = word.contains('\n') || word.contains('=') && !is_link(word.as_ref());
        if !is_toml {
            return Ok((State::default(), Some(word.into())));
        }
        text = Some(word);
    } else if let Ok(path) = source.extract::<PathBuf>() {
        return Ok((State::default(), Some(path)));
    }
    let text = text.ok_or_else(|| {
        value_error("a state is a name, a path, a link, TOML text, a dict, a Scene or a State")
    })?;
    let settings = Settings::default().with_toml(&text, "state");
    Ok((State { settings: settings.map_err(value_error)?, own }, None))
}

/// The scene in a value, if that is one that is in no file.
fn own_scene_in(value: &Bound<'_, PyAny>) -> Option<Arc<OwnScene>> {
    value.cast::<Scene>().ok().and_then(|scene| scene.get().own())
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
