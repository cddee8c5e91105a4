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
    /// By their paths.
    models: RefCell<HashMap<String, Rc<NamedModel>>>,
    /// By the models' forms.
    bodies: RefCell<HashMap<String, ModelBodies>>,
    /// By their names, and the changes to their wheels.
    presets: RefCell<HashMap<String, PresetBodies>>,
    reports: RefCell<Vec<ModelReport>>,
    room: Room,
}

impl Opened {
    /// Returns the bodies of the preset that is called `key` here, which `read` returns unless it is known.
    pub fn preset(&self, key: String, read: impl FnOnce() -> Option<PresetBodies>) -> Option<PresetBodies> {
        let known = self.presets.borrow().get(&key).cloned();
        known.or_else(|| {
            let bodies = read()?;
            self.presets.borrow_mut().insert(key, bodies.clone());
            Some(bodies)
        })
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
        if let Some(model) = self.opened.models.borrow().get(path) {
            return Ok(model.clone());
        }
        let (named, remarks) = read(&self.files, path, &self.opened.room)?;
        if !matches!(self.files, ModelFiles::Preset) {
            self.opened.reports.borrow_mut().push(ModelReport::new(path, &named, remarks));
        }
        let named = Rc::new(named);
        self.opened.models.borrow_mut().insert(path.to_owned(), named.clone());
        Ok(named)
    }

    /// Returns the bodies of a model of this `form`, which `prepare` returns unless they are known.
    pub(super) fn bodies<Problem>(
        &self,
        form: String,
        prepare: impl FnOnce() -> Result<ModelBodies, Problem>,
    ) -> Result<ModelBodies, Problem> {
        if let Some(bodies) = self.opened.bodies.borrow().get(&form) {
            return Ok(bodies.clone());
        }
        let bodies = prepare()?;
        self.opened.bodies.borrow_mut().insert(form, bodies.clone());
        Ok(bodies)
    }

    /// Takes the room of so many triangles in the scene.
    pub(super) fn take_triangles(&self, triangles: usize) -> Result<(), String> {
        self.opened.room.take_triangles(triangles)
    }
}
