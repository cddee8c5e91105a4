//! A model of a scene file: triangles from a file beside it, scaled, turned and placed.

mod accessor;
mod companions;
mod files;
mod gltf;
mod limits;
mod lines;
mod materials;
mod obj;
mod opened;
mod parts;
mod picture;
mod report;
pub mod ridden;
mod rolling;
#[cfg(test)]
mod tests;
mod text;
mod textures;

use std::path::Path;

use gamow_platform::messages;
use glam::{DMat3, DVec3};
use relativity_core::Turning;
use relativity_render::{Body, RawModel};

use self::companions::Companions;
pub(super) use self::files::ModelFiles;
use self::limits::Room;
use self::opened::ModelBodies;
pub(super) use self::opened::{Models, Opened};
use self::parts::NamedModel;
pub use self::report::ModelReport;
use super::error::{Located, SceneProblem};
use super::light::brightness;
use super::object::Object;
use super::table::Table;
use super::wheel::Changes;

/// The form of a model, wherever it is: models of one form share their triangles.
#[derive(Debug)]
struct Form<'a> {
    path: &'a str,
    axes: DMat3,
    is_two_sided: bool,
    wheels: Vec<&'a str>,
    turning: Option<Turning>,
}

/// Parses a model, and reads its file: the bodies of its wheels come after the rest of it. These changes to
/// wheels are for its own, too.
pub(super) fn model(table: &Table, changes: Changes) -> Result<Vec<Object>, Located> {
    table.check_keys(&[
        "path",
        "name",
        "scale",
        "axis",
        "angle",
        "up",
        "place",
        "two_sided",
        "brightness",
        "wheels",
        "rolls",
        "rim_speed",
    ])?;
    let path = table.needed("path", Table::string)?;
    let name = table.string("name")?.unwrap_or_else(|| stem(path));
    let (scale, place) = (table.size("scale")?.unwrap_or(1.0), table.point("place")?.unwrap_or_default());
    let axes = scale * DMat3::from_quat(table.turn("the model")?) * upright(table)?;
    let is_two_sided = table.truth("two_sided")?.unwrap_or(true);
    let brightness = brightness(table)?;
    let wheels = table.strings("wheels")?.unwrap_or_default();
    let turning = turning(table, &wheels, changes)?;
    let form = Form { path, axes, is_two_sided, wheels, turning };
    let bodies = table.models.bodies(format!("{form:?}"), || form.bodies(table))?;
    let object = |(part, body): &(Option<String>, Body)| Object {
        body: Body { brightness, ..body.clone() }.moved(place),
        name: Some(part.as_deref().unwrap_or(name).to_owned()),
        include: None,
        span: table.span.clone(),
    };
    Ok(bodies.iter().map(object).collect())
}

impl Form<'_> {
    /// Prepares the bodies of a model in `table`.
    fn bodies(&self, table: &Table) -> Result<ModelBodies, Located> {
        let refused = |reason: String| {
            table.problem_at("path", |path| SceneProblem::Model { path, reason: one_line(&reason) })
        };
        let no_wheel = |reason: String| {
            table.problem_at("wheels", |value| SceneProblem::ModelWheel { value, reason: one_line(&reason) })
        };
        let named = table.models.open(self.path, read).map_err(refused)?;
        table.models.take_triangles(named.model.triangles.len()).map_err(refused)?;
        let split = named.split(&self.wheels).map_err(no_wheel)?;
        drop(named);
        let mut bodies = Vec::new();
        if let Some(rest) = split.rest {
            let triangles = self.placed(rest).prepared().map_err(|error| refused(error.to_string()))?;
            bodies.push((None, Body::of_triangles(triangles)));
        }
        for (name, part) in self.wheels.iter().zip(split.parts) {
            let wheel = rolling::wheel(self.placed(part), self.turning);
            let refused = |reason| no_wheel(format!("`{}`: {reason}", messages::excerpt(name)));
            bodies.push((Some((*name).to_owned()), wheel.map_err(refused)?));
        }
        Ok(bodies.into())
    }

    /// Returns `model` in the axes of the scene.
    fn placed(&self, mut model: RawModel) -> RawModel {
        for corner in &mut model.corners {
            *corner = (self.axes * DVec3::from(*corner)).to_array();
        }
        model.is_two_sided = self.is_two_sided;
        model
    }
}

/// The turning of the `wheels` of a model: rolling by default.
fn turning(table: &Table, wheels: &[&str], changes: Changes) -> Result<Option<Turning>, Located> {
    if let Some(key) = ["rolls", "rim_speed"].into_iter().find(|key| wheels.is_empty() && table.has(key)) {
        return Err(table.wrong(key, "left out where there are no `wheels`"));
    }
    changes.turning_of(table, Turning::Rolling)
}

/// The turn from the axes of the file to those of scenes, whose z axis points upwards.
fn upright(table: &Table) -> Result<DMat3, Located> {
    match table.string("up")? {
        None | Some("y") => Ok(upright_axes()),
        Some("z") => Ok(DMat3::IDENTITY),
        Some(_) => {
            Err(table.wrong("up", "\"y\", as in glTF, or \"z\": the axis of the file that points upwards"))
        }
    }
}

/// The same where the file's y axis points upwards.
fn upright_axes() -> DMat3 {
    DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y)
}

/// Endings of the files of models.
const ENDINGS: [&str; 3] = ["glb", "gltf", "obj"];

/// Whether the file at `path` is a model, by its ending.
#[must_use]
pub fn is_model(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| ENDINGS.iter().any(|known| known.eq_ignore_ascii_case(ending)))
}

/// Reads the model in the file at `path`, by its ending, with remarks on it, if it has `room`.
fn read(files: &ModelFiles<'_>, path: &str, room: &Room) -> Result<(NamedModel, Vec<String>), String> {
    let ending = path.rsplit_once('.').map_or(String::new(), |(_, ending)| ending.to_ascii_lowercase());
    if !ENDINGS.contains(&ending.as_str()) {
        return Err("it must end in .glb, .gltf or .obj".to_owned());
    }
    let folder = path.rfind('/').map_or("", |end| &path[..=end]);
    let bounded = |path: &str| {
        let bytes = files.read(path)?;
        room.take_bytes(bytes.len() as u64)?;
        Ok(bytes)
    };
    let read = |name: &str| bounded(&format!("{folder}{name}"));
    let spelt = |name: &str| Some(files.spelt(&format!("{folder}{name}"))?.strip_prefix(folder)?.to_owned());
    let companions = Companions::new(&read, &spelt);
    companions.texels.set(room.texels.get());
    let named = parsed(&ending, &bounded(path)?, &companions)?;
    room.texels.set(companions.texels.get());
    Ok((named, companions.into_remarks()))
}

/// Reads a model from the bytes of a file with this ending, `glb`, `gltf` or `obj`, without any file beside
/// it.
///
/// # Errors
///
/// Contents that are none, or need another file, in one line.
pub fn read_model(ending: &str, bytes: &[u8]) -> Result<RawModel, String> {
    let companions = Companions::new(&|name| Err(format!("there is no {name}")), &|_| None);
    parsed(ending, bytes, &companions).map(|named| named.model)
}

fn parsed(ending: &str, bytes: &[u8], companions: &Companions<'_>) -> Result<NamedModel, String> {
    let parse = if ending == "obj" { obj::model } else { gltf::model };
    let mut named = parse(bytes, companions)?;
    if named.model.materials.iter().all(Option::is_none) {
        named.model.materials.clear();
    }
    if !named.model.reversed.contains(&true) {
        named.model.reversed.clear();
    }
    Ok(named)
}

/// The name of a file without its folder and its ending.
fn stem(path: &str) -> &str {
    let file = path.rsplit_once('/').map_or(path, |(_, file)| file);
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

fn one_line(reason: &str) -> String {
    reason.split_whitespace().collect::<Vec<_>>().join(" ")
}
