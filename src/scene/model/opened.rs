//! The models that are opened with a scene: each file is read once, and what differs by its place alone is
//! prepared once.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use relativity_render::Body;

use super::files::ModelFiles;
use super::limits::Room;
use super::parts::NamedModel;
use super::report::ModelReport;

/// The bodies of a model, with the names of those that are wheels.
pub(super) type ModelBodies = Rc<[(Option<String>, Body)]>;

/// The bodies of a preset with their names, as other scenes include them.
pub(in crate::scene) type PresetBodies = Rc<[(Body, String)]>;

/// The models of a scene that is being read.
#[derive(Clone, Copy)]
pub(in crate::scene) struct Models<'a> {
    pub files: ModelFiles<'a>,
    pub opened: &'a Opened,
}

/// The models and the presets so far.
#[derive(Default)]
pub(in crate::scene) struct Opened {
    /// Models by their paths.
    models: RefCell<HashMap<String, Rc<NamedModel>>>,
    /// Prepared bodies by the forms of their models.
    bodies: RefCell<HashMap<String, ModelBodies>>,
    /// Presets by their names with the changes to their wheels.
    presets: RefCell<HashMap<String, PresetBodies>>,
    reports: RefCell<Vec<ModelReport>>,
    room: Room,
}

impl Opened {
    /// Returns the bodies of the preset that is called `key` here, which `read` returns unless it is known.
    pub fn preset(&self, key: String, read: impl FnOnce() -> Option<PresetBodies>) -> Option<PresetBodies> {
        kept(&self.presets, key, || read().ok_or(())).ok()
    }

    /// Returns the reports on the models.
    pub fn into_reports(self) -> Vec<ModelReport> {
        self.reports.into_inner()
    }
}

impl Models<'_> {
    /// Returns the model in the file at `path`, which `read` returns with remarks unless it is known.
    pub(super) fn open(
        &self,
        path: &str,
        read: impl FnOnce(&ModelFiles<'_>, &str, &Room) -> Result<(NamedModel, Vec<String>), String>,
    ) -> Result<Rc<NamedModel>, String> {
        kept(&self.opened.models, path.to_owned(), || {
            let (named, remarks) = read(&self.files, path, &self.opened.room)?;
            if !matches!(self.files, ModelFiles::Preset) {
                self.opened.reports.borrow_mut().push(ModelReport::new(path, &named, remarks));
            }
            Ok(Rc::new(named))
        })
    }

    /// Returns the bodies of a model of this `form`, which `prepare` returns unless they are known.
    pub(super) fn bodies<Problem>(
        &self,
        form: String,
        prepare: impl FnOnce() -> Result<ModelBodies, Problem>,
    ) -> Result<ModelBodies, Problem> {
        kept(&self.opened.bodies, form, prepare)
    }

    /// Takes the room of this number of triangles from what is left for the scene.
    pub(super) fn take_triangles(&self, triangles: usize) -> Result<(), String> {
        self.opened.room.take_triangles(triangles)
    }
}

/// Returns what is known by this `key`, or what `made` returns, which is known from then on.
fn kept<Value: Clone, Problem>(
    known: &RefCell<HashMap<String, Value>>,
    key: String,
    made: impl FnOnce() -> Result<Value, Problem>,
) -> Result<Value, Problem> {
    if let Some(value) = known.borrow().get(&key) {
        return Ok(value.clone());
    }
    let value = made()?;
    known.borrow_mut().insert(key, value.clone());
    Ok(value)
}
