//! A model of a scene file: triangles from a file beside it, scaled, turned and placed.

mod accessor;
mod companions;
mod files;
mod gltf;
mod limits;
mod lines;
mod materials;
mod obj;
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
use self::parts::NamedModel;
pub use self::report::ModelReport;
pub(super) use self::report::Models;
use super::error::{Located, SceneProblem};
use super::light::brightness;
use super::object::Object;
use super::table::Table;
use super::wheel::Changes;

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
    let path = table.needed_string("path")?;
    let name = table.string("name")?.unwrap_or_else(|| stem(path)).to_owned();
    let (scale, place) = (table.size("scale")?.unwrap_or(1.0), table.point("place")?.unwrap_or_default());
    let axes = scale * DMat3::from_quat(table.turn("the model")?) * upright(table)?;
    let is_two_sided = table.truth("two_sided")?.unwrap_or(true);
    let brightness = brightness(table)?;
    let refused = |reason: String| {
        table.problem_at("path", |path| SceneProblem::Model { path, reason: one_line(&reason) })
    };
    let wheels = table.strings("wheels")?.unwrap_or_default();
    let turning = turning(table, &wheels, changes)?;
    let mut named = table.models.open(path).map_err(refused)?;
    for corner in &mut named.model.corners {
        *corner = (axes * DVec3::from(*corner) + DVec3::from(place)).to_array();
    }
    named.model.is_two_sided = is_two_sided;
    let no_wheel = |reason: String| {
        table.problem_at("wheels", |value| SceneProblem::ModelWheel { value, reason: one_line(&reason) })
    };
    let split = named.split(&wheels).map_err(no_wheel)?;
    let object = |name: &str, body| Object {
        body: Body { brightness, ..body },
        name: Some(name.to_owned()),
        include: None,
        span: table.span.clone(),
    };
    let mut objects = Vec::new();
    if let Some(rest) = split.rest {
        let triangles = rest.prepared().map_err(|error| refused(error.to_string()))?;
        objects.push(object(&name, Body::of_triangles(triangles)));
    }
    for (name, part) in wheels.iter().zip(split.parts) {
        let wheel = rolling::wheel(part, turning);
        let refused = |reason| no_wheel(format!("`{}`: {reason}", messages::excerpt(name)));
        objects.push(object(name, wheel.map_err(refused)?));
    }
    Ok(objects)
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

/// Reads the model in the file at `path`, by its ending, with remarks on it.
fn read(files: &ModelFiles<'_>, path: &str) -> Result<(NamedModel, Vec<String>), String> {
    let ending = path.rsplit_once('.').map_or(String::new(), |(_, ending)| ending.to_ascii_lowercase());
    if !ENDINGS.contains(&ending.as_str()) {
        return Err("it must end in .glb, .gltf or .obj".to_owned());
    }
    let folder = path.rfind('/').map_or("", |end| &path[..=end]);
    let read = |name: &str| files.read(&format!("{folder}{name}"));
    let spelt = |name: &str| Some(files.spelt(&format!("{folder}{name}"))?.strip_prefix(folder)?.to_owned());
    let companions = Companions::new(&read, &spelt);
    let named = parsed(&ending, &files.read(path)?, &companions)?;
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
