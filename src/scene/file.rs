//! The scene format: what each table of a scene file means.

use relativity_render::{Body, Shape};
use toml::de::DeTable;

use super::Scene;
use super::error::{Located, Problem};
use super::placement::{forward_most_point, moved};
use super::table::{Table, coincide};

/// Red, as in the paper.
const DEFAULT_WAVELENGTH_NM: f64 = 700.0;

/// The scene that a file's text describes.
pub(super) fn scene(text: &str) -> Result<Scene, Located> {
    let document = DeTable::parse(text).map_err(|error| Located::syntax(text, &error))?;
    let top = Table { text, entries: document.get_ref(), span: 0..0, owner: "a scene" };
    top.check_keys(&["name", "tracked", "ground_z", "include", "object"])?;
    let name = top.needed_string("name")?.to_owned();
    let ground_z = top.coordinate("ground_z")?;
    let tracked = top.point("tracked")?;
    let bodies = bodies(&top)?;
    let Some(forward_most) = forward_most_point(&bodies) else {
        return Err(Located { span: top.span, problem: Problem::Empty });
    };
    Ok(Scene { name, bodies, tracked: tracked.unwrap_or(forward_most), ground_z })
}

/// All bodies: the included ones first.
fn bodies(top: &Table) -> Result<Vec<Body>, Located> {
    let mut bodies = Vec::new();
    for include in top.tables("include", "an include")? {
        bodies.extend(included_bodies(&include)?);
    }
    for object in top.tables("object", "an object")? {
        bodies.push(body(object)?);
    }
    Ok(bodies)
}

/// The bodies of a preset, moved.
fn included_bodies(include: &Table) -> Result<Vec<Body>, Located> {
    include.check_keys(&["scene", "offset"])?;
    let name = include.needed_string("scene")?;
    let Some(preset) = Scene::preset(name) else {
        return Err(include.problem_at("scene", Problem::UnknownInclude));
    };
    let offset = include.point("offset")?.unwrap_or_default();
    let moved = |body: Body| Body { shape: moved(body.shape, offset), ..body };
    Ok(preset.bodies.into_iter().map(moved).collect())
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
        _ => return Err(object.problem_at("shape", Problem::UnknownShape)),
    };
    let rest_wavelength_nm = object.size("wavelength_nm")?.unwrap_or(DEFAULT_WAVELENGTH_NM);
    Ok(Body { shape, rest_wavelength_nm })
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
