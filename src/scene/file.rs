//! The scene format: what each table of a scene file means.

use glam::DQuat;
use relativity_render::{Body, Motion, Shape, Velocity};
use toml::de::DeTable;

use super::content::{Scene, SceneGroup};
use super::error::{Located, Problem};
use super::forward_most::forward_most_point;
use super::presets;
use super::table::{Table, coincide};

/// Red, as in the paper.
const DEFAULT_WAVELENGTH_NM: f64 = 700.0;

/// The scene that a file's text describes.
pub(super) fn scene(text: &str) -> Result<Scene, Located> {
    let document = DeTable::parse(text).map_err(|error| Located::syntax(text, &error))?;
    let top = Table { text, entries: document.get_ref(), span: 0..0, owner: "a scene" };
    top.check_keys(&["name", "tracked", "ground_z", "include", "object", "group"])?;
    let name = top.needed_string("name")?.to_owned();
    let ground_z = top.coordinate("ground_z")?;
    let tracked = top.point("tracked")?;
    let (bodies, groups) = groups(&top, &name)?;
    let own = groups.first().map_or(&[][..], |group| &bodies[group.bodies()]);
    let Some(forward_most) = forward_most_point(own) else {
        return Err(Located { span: top.span, problem: Problem::Empty });
    };
    Ok(Scene { name, bodies, groups, tracked: tracked.unwrap_or(forward_most), ground_z })
}

/// The preset of that name.
pub(super) fn preset(name: &str) -> Option<Scene> {
    let text = presets::text(name)?;
    Some(scene(text).unwrap_or_else(|_| unreachable!("tests read every preset")))
}

/// All bodies, and the groups they belong to: the scene's own, which moves at its speed, comes first. A group without
/// bodies is left out.
fn groups(top: &Table, name: &str) -> Result<(Vec<Body>, Vec<SceneGroup>), Located> {
    let mut all = bodies(top)?;
    let mut groups =
        vec![SceneGroup { name: name.to_owned(), motion: Motion::Scene, first: 0, count: all.len() }];
    for table in top.tables("group", "a group")? {
        table.check_keys(&["name", "beta", "include", "object"])?;
        let (name, motion) = (table.needed_string("name")?.to_owned(), motion(&table)?);
        let own = bodies(&table)?;
        groups.push(SceneGroup { name, motion, first: all.len(), count: own.len() });
        all.extend(own);
    }
    groups.retain(|group| group.count > 0);
    Ok((all, groups))
}

/// How a group moves: at the scene's speed unless it has its own.
fn motion(group: &Table) -> Result<Motion, Located> {
    let Some(beta) = group.coordinate("beta")? else { return Ok(Motion::Scene) };
    let velocity = Velocity::from_beta(beta).map_err(|_| group.problem_at("beta", Problem::NoSpeed))?;
    Ok(Motion::Own(velocity))
}

/// All bodies of a group: the included ones first.
fn bodies(group: &Table) -> Result<Vec<Body>, Located> {
    let mut bodies = Vec::new();
    for include in group.tables("include", "an include")? {
        bodies.extend(included_bodies(&include)?);
    }
    for object in group.tables("object", "an object")? {
        bodies.push(body(object)?);
    }
    Ok(bodies)
}

/// The bodies of a preset, moved; they move as the group does that includes them.
fn included_bodies(include: &Table) -> Result<Vec<Body>, Located> {
    include.check_keys(&["scene", "offset"])?;
    let name = include.needed_string("scene")?;
    let Some(preset) = preset(name) else {
        return Err(include.problem_at("scene", Problem::UnknownInclude));
    };
    let offset = include.point("offset")?.unwrap_or_default();
    Ok(preset.bodies.into_iter().map(|body| body.moved(offset)).collect())
}

/// One object.
fn body(mut object: Table) -> Result<Body, Located> {
    let shape = match object.needed_string("shape")? {
        "sphere" => {
            object.owner = "a sphere";
            sphere(&object)?
        }
        "tube" => {
            object.owner = "a tube";
            tube(&object)?
        }
        "ring" => {
            object.owner = "a ring";
            ring(&object)?
        }
        "box" => {
            object.owner = "a box";
            cuboid(&object)?
        }
        "cylinder" => {
            object.owner = "a cylinder";
            cylinder(&object)?
        }
        _ => return Err(object.problem_at("shape", Problem::UnknownShape)),
    };
    let rest_wavelength_nm = object.size("wavelength_nm")?.unwrap_or(DEFAULT_WAVELENGTH_NM);
    Ok(Body::new(shape, rest_wavelength_nm))
}

fn sphere(object: &Table) -> Result<Shape, Located> {
    object.check_keys(&["shape", "center", "radius", "wavelength_nm"])?;
    Ok(Shape::Sphere { center: object.needed_point("center")?, radius: object.needed_size("radius")? })
}

fn tube(object: &Table) -> Result<Shape, Located> {
    object.check_keys(&["shape", "from", "to", "radius", "wavelength_nm"])?;
    let from = object.needed_point("from")?;
    let to = object.needed_point("to")?;
    if coincide(from, to) {
        return Err(object.problem_at("to", Problem::NoLength));
    }
    Ok(Shape::Tube { from, to, radius: object.needed_size("radius")? })
}

fn ring(object: &Table) -> Result<Shape, Located> {
    object.check_keys(&["shape", "center", "axis", "radius", "tube_radius", "wavelength_nm"])?;
    let center = object.needed_point("center")?;
    let axis = object.needed_direction("axis")?;
    let radius = object.needed_size("radius")?;
    let tube_radius = object.needed_size("tube_radius")?;
    if tube_radius >= radius {
        let radius = object.quoted_value("radius");
        return Err(object.problem_at("tube_radius", |tube_radius| Problem::NoHole { tube_radius, radius }));
    }
    Ok(Shape::Ring { center, axis, radius, tube_radius })
}

fn cuboid(object: &Table) -> Result<Shape, Located> {
    object.check_keys(&["shape", "center", "size", "axis", "angle", "wavelength_nm"])?;
    let center = object.needed_point("center")?;
    let half = object.needed_sizes("size")?.map(|size| 0.5 * size);
    let axis = object.direction("axis")?;
    let turn = match object.coordinate("angle")? {
        Some(angle) => {
            let axis = axis.unwrap_or([0.0, 0.0, 1.0]);
            DQuat::from_axis_angle(axis.into(), angle.to_radians())
        }
        None if axis.is_some() => return Err(object.problem_at("axis", Problem::NoAngle)),
        None => DQuat::IDENTITY,
    };
    Ok(Shape::Box { center, half, turn: turn.to_array() })
}

fn cylinder(object: &Table) -> Result<Shape, Located> {
    object.check_keys(&["shape", "from", "to", "radius", "wavelength_nm"])?;
    let from = object.needed_point("from")?;
    let to = object.needed_point("to")?;
    if coincide(from, to) {
        return Err(object.problem_at("to", Problem::NoHeight));
    }
    Ok(Shape::Cylinder { from, to, radius: object.needed_size("radius")? })
}
