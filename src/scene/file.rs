//! The scene format: what each table of a scene file means.

use std::collections::HashMap;
use std::ops::Range;
use std::path::Path;
use std::rc::Rc;
use std::sync::OnceLock;

use gamow_platform::{files, sizes};
use relativity_render::{Body, Motion, Velocity};
use toml::de::DeTable;

use super::content::{Scene, SceneGroup};
use super::error::{Located, SceneProblem};
use super::model::{ModelFiles, Models, Opened, model, ridden};
use super::names;
use super::object::{Object, object};
use super::presets::{self, PRESETS};
use super::table::Table;
use super::wheel::{Changes, wheel};

/// Default word for whatever rides past.
const RIDER: &str = "rider";

/// The scene that a file's text describes.
pub(super) fn scene(text: &str) -> Result<Scene, Located> {
    changed_scene(text, Changes::default(), ModelFiles::Nowhere)
}

/// The scene that the text of a file in this folder describes, in which its models are.
pub(super) fn scene_in(text: &str, folder: &Path) -> Result<Scene, Located> {
    changed_scene(text, Changes::default(), ModelFiles::Folder(folder))
}

/// The scene in which the model at `path` rides on Gamow's street.
pub(super) fn scene_of_model(path: &Path) -> Result<Scene, String> {
    let folder = files::folder_of(path);
    scene_in(&ridden::text(path, folder)?, folder).map_err(|located| match located.problem {
        SceneProblem::Model { reason, .. } => reason,
        problem => problem.to_string(),
    })
}

/// The scene that a file's text describes, with these changes to its wheels.
fn changed_scene(text: &str, changes: Changes, files: ModelFiles<'_>) -> Result<Scene, Located> {
    let opened = Opened::default();
    let models = Models { files, opened: &opened };
    let document = DeTable::parse(text).map_err(|error| Located::syntax(text, &error))?;
    let top = Table { text, entries: document.get_ref(), span: 0..0, owner: "a scene", models };
    top.check_keys(&[
        "name", "rider", "metres", "tracked", "ground_z", "street", "sunlit", "include", "wheel", "model",
        "object", "group",
    ])?;
    let name = top.needed("name", Table::string)?.to_owned();
    let rider = top.string("rider")?.unwrap_or(RIDER).to_owned();
    let (metres, ground_z) = (top.size("metres")?, top.coordinate("ground_z")?);
    let (street, sunlit) = (street(&top)?, top.truth("sunlit")?.unwrap_or(false));
    let tracked = top.point("tracked")?;
    let (objects, mut groups) = groups(&top, &name, changes)?;
    let names = names::names(&objects, &groups, &rider)?;
    groups.retain(|group| group.count > 0);
    let bodies: Vec<Body> = objects.into_iter().map(|object| object.body).collect();
    let own = groups.first().map_or(&[][..], |group| &bodies[group.bodies()]);
    let Some(forward_most) = forward_most(own) else {
        return Err(Located { span: top.span, problem: SceneProblem::Empty });
    };
    let tracked = tracked.unwrap_or(forward_most);
    let models = opened.into_reports();
    Ok(Scene { name, bodies, names, groups, tracked, rider, metres, ground_z, street, sunlit, models })
}

/// The kerbs of the road on the ground and the house fronts beyond, from the nearest on.
fn street(top: &Table) -> Result<Option<[f64; 3]>, Located> {
    let street = top.point("street")?;
    if street.is_some_and(|street| !street.is_sorted_by(|nearer, farther| nearer < farther)) {
        return Err(top.problem_at("street", SceneProblem::NoWidth));
    }
    Ok(street)
}

/// The preset of that name, which is read once.
pub(super) fn preset(name: &str) -> Option<Scene> {
    static READ: [OnceLock<Scene>; PRESETS.len()] = [const { OnceLock::new() }; PRESETS.len()];
    let number = PRESETS.iter().position(|preset| *preset == name)?;
    if let Some(scene) = READ[number].get() {
        return Some(scene.clone());
    }
    let scene = changed_preset(name, Changes::default())?;
    Some(READ[number].get_or_init(|| scene).clone())
}

fn changed_preset(name: &str, changes: Changes) -> Option<Scene> {
    let text = presets::text(name)?;
    Some(
        changed_scene(text, changes, ModelFiles::Preset)
            .unwrap_or_else(|_| unreachable!("tests read every preset")),
    )
}

/// The bicycle of who rides, from the middle between the eyes.
pub(super) fn own_bicycle() -> Scene {
    let text = include_str!("../../assets/own-bicycle.toml");
    scene(text).unwrap_or_else(|_| unreachable!("a test reads it"))
}

/// The point with the largest x on any of the bodies; `None` without bodies.
fn forward_most(bodies: &[Body]) -> Option<[f64; 3]> {
    let points = bodies.iter().map(Body::forward_most);
    points.max_by(|a, b| a.x.total_cmp(&b.x)).map(|point| point.to_array())
}

/// Returns all objects, and the groups they belong to: the scene's own, which moves at its speed, comes
/// first.
fn groups(top: &Table, name: &str, changes: Changes) -> Result<(Vec<Object>, Vec<SceneGroup>), Located> {
    let mut all = objects(top, changes)?;
    let mut room = Room::default();
    room.take(&all, top.span.clone())?;
    let name = only_include(&all).unwrap_or(name).to_owned();
    let mut groups = vec![SceneGroup { name, motion: Motion::Scene, first: 0, count: all.len() }];
    let tables = top.tables("group", "a group")?;
    if let Some(excess) = tables.get(sizes::GROUPS) {
        return Err(Located { span: excess.span.clone(), problem: SceneProblem::ManyGroups(tables.len()) });
    }
    for table in tables {
        table.check_keys(&["name", "beta", "include", "wheel", "model", "object"])?;
        let (name, motion) = (table.needed("name", Table::string)?.to_owned(), motion(&table)?);
        let own = objects(&table, changes)?;
        groups.push(SceneGroup { name, motion, first: all.len(), count: own.len() });
        room.take(&own, table.span)?;
        all.extend(own);
    }
    Ok((all, groups))
}

/// Returns the name of the preset that all of `objects` were included with, if it is one: what rides on a
/// street is called by it, and not by the street.
fn only_include(objects: &[Object]) -> Option<&str> {
    let include = objects.first()?.include.as_deref()?;
    objects.iter().all(|object| object.include.as_deref() == Some(include)).then_some(include)
}

/// Returns the motion of a group: at the scene's speed unless it has its own.
fn motion(group: &Table) -> Result<Motion, Located> {
    let Some(beta) = group.coordinate("beta")? else { return Ok(Motion::Scene) };
    let velocity = Velocity::from_beta(beta).map_err(|_| group.problem_at("beta", SceneProblem::NoSpeed))?;
    Ok(Motion::Own(velocity))
}

/// The bodies that a scene has so far.
#[derive(Default)]
struct Room {
    bodies: usize,
    turning: usize,
}

impl Room {
    /// Takes the room for further `objects`, which are at `span`.
    fn take(&mut self, objects: &[Object], span: Range<usize>) -> Result<(), Located> {
        self.bodies += objects.len();
        self.turning += objects.iter().filter(|object| object.body.displacing_spin().is_some()).count();
        let problem = match self {
            Self { bodies, .. } if *bodies > sizes::BODIES => SceneProblem::ManyBodies,
            Self { turning, .. } if *turning > sizes::TURNING_BODIES => SceneProblem::ManyTurning,
            _ => return Ok(()),
        };
        Err(Located { span, problem })
    }
}

/// Returns all objects of a group: the included ones first, then its wheels and its models.
fn objects(group: &Table, changes: Changes) -> Result<Vec<Object>, Located> {
    let (mut objects, mut room) = (Vec::new(), Room::default());
    let includes = group.tables("include", "an include")?;
    let mut add = |span: &Range<usize>, more: Vec<Object>| {
        room.take(&more, span.clone())?;
        objects.extend(more);
        Ok(())
    };
    for (include, label) in includes.iter().zip(labels(&includes)) {
        add(&include.span, included(include, &label, changes)?)?;
    }
    for table in group.tables("wheel", "a wheel")? {
        add(&table.span, wheel(&table, changes)?)?;
    }
    for table in group.tables("model", "a model")? {
        add(&table.span, model(&table, changes)?)?;
    }
    for table in group.tables("object", "an object")? {
        add(&table.span.clone(), repeated(table)?)?;
    }
    Ok(objects)
}

/// Returns the name of the preset in each include, numbered if another has the same.
fn labels(includes: &[Table]) -> Vec<Rc<str>> {
    let preset = |include| Table::string(include, "scene").ok().flatten().unwrap_or_default();
    let presets: Vec<&str> = includes.iter().map(preset).collect();
    let mut counts: HashMap<&str, [usize; 2]> = HashMap::new();
    for preset in &presets {
        counts.entry(preset).or_default()[0] += 1;
    }
    let label = |preset: &str, [count, number]: &mut [usize; 2]| {
        *number += 1;
        if *count == 1 { preset.into() } else { format!("{preset} {number}").into() }
    };
    presets.into_iter().map(|preset| label(preset, counts.entry(preset).or_default())).collect()
}

/// Returns the objects of a preset, moved; they move like the group that includes them, and are distinguished
/// from others of the same name by `label`.
fn included(include: &Table, label: &Rc<str>, changes: Changes) -> Result<Vec<Object>, Located> {
    include.check_keys(&["scene", "offset", "wheels"])?;
    let name = include.needed("scene", Table::string)?;
    let own = include
        .table("wheels", "`wheels` of an include")?
        .map(|wheels| Changes::from_table(&wheels))
        .transpose()?;
    let changes = changes.or(own.unwrap_or_default());
    let read = || {
        let Scene { bodies, names, .. } = changed_preset(name, changes)?;
        Some(bodies.into_iter().zip(names).collect())
    };
    let Some(preset) = include.models.opened.preset(format!("{name} {changes:?}"), read) else {
        return Err(include.problem_at("scene", SceneProblem::UnknownInclude));
    };
    if own.is_some() && !presets::has_wheels(name) {
        return Err(include.problem_at("wheels", |_| SceneProblem::NoWheels(name.to_owned())));
    }
    let offset = include.point("offset")?.unwrap_or_default();
    let moved = |(body, name): &(Body, String)| Object {
        body: body.clone().moved(offset),
        name: Some(name.clone()),
        include: Some(label.clone()),
        span: include.span.clone(),
    };
    Ok(preset.iter().map(moved).collect())
}

/// Returns an object, and its repetitions if it has such a table, a step from each to the next, with numbers
/// in their names.
fn repeated(table: Table) -> Result<Vec<Object>, Located> {
    let (count, step) = (table.count("repeat")?, table.point("step")?);
    let first = object(table)?;
    let Some(count) = count else { return Ok(vec![first]) };
    let nth = |n: usize| Object {
        body: first.body.clone().moved(step.unwrap_or_default().map(|along| n as f64 * along)),
        name: first.name.as_ref().map(|name| format!("{name} {}", n + 1)),
        ..first.clone()
    };
    Ok((0..count).map(nth).collect())
}
