//! An object of a scene file: its shape, its light and its pattern.

use std::ops::Range;
use std::rc::Rc;

use relativity_render::{Body, Pattern, Shape};

use super::error::{Located, SceneProblem};
use super::light;
use super::table::{Table, coincide};

/// Default degrees from line to line of a graticule, and default length from line to line of other patterns.
const DEFAULT_DEGREES: f64 = 15.0;
const DEFAULT_SPACING: f64 = 0.25;
/// The keys of an object of any shape, beside its shape and its light.
const OF_EVERY_OBJECT: [&str; 5] = ["name", "pattern", "spacing", "repeat", "step"];

/// Reads the shape of an object.
type ShapeReader = fn(&Table) -> Result<Shape, Located>;

/// The shapes: the name of each, the same with its article, and its reader.
const SHAPES: [(&str, &str, ShapeReader); 5] = [
    ("sphere", "a sphere", sphere),
    ("tube", "a tube", tube),
    ("ring", "a ring", ring),
    ("box", "a box", cuboid),
    ("cylinder", "a cylinder", cylinder),
];

/// A body, and what its file calls it.
#[derive(Clone)]
pub(super) struct Object {
    pub body: Body,
    pub name: Option<String>,
    /// The preset that it was included with, numbered if its group includes that several times.
    pub include: Option<Rc<str>>,
    /// The place of the object's table in the file.
    pub span: Range<usize>,
}

impl Object {
    /// Returns the name of the object as the body of this number.
    pub fn name_as(&self, number: usize) -> String {
        let shape = self.body.shape.name();
        self.name.clone().unwrap_or_else(|| format!("{shape} {number}"))
    }
}

/// Parses an object.
pub(super) fn object(mut object: Table) -> Result<Object, Located> {
    let asked = object.needed("shape", Table::string)?;
    let Some(&(_, owner, read)) = SHAPES.iter().find(|(name, ..)| *name == asked) else {
        return Err(
            object.problem_at("shape", |shape| SceneProblem::UnknownShape { shape, known: known_shapes() })
        );
    };
    object.owner = owner;
    let shape = read(&object)?;
    let name = object.string("name")?.map(str::to_owned);
    let (emission, brightness) = (light::emission(&object)?, light::brightness(&object)?);
    let body =
        Body { shape, emission, brightness, pattern: pattern(&object, &shape)?, spin: None, triangles: None };
    Ok(Object { body, name, include: None, span: object.span })
}

/// The names of the shapes, as an error lists them.
fn known_shapes() -> String {
    let names = SHAPES.map(|(name, ..)| format!("\"{name}\""));
    let [first @ .., last] = &names;
    format!("{} or {last}", first.join(", "))
}

/// Refuses keys other than those of every object and the `known` ones of its shape.
fn check_keys(object: &Table, known: &[&str]) -> Result<(), Located> {
    object.check_keys(&[&["shape"], known, &light::KEYS, &OF_EVERY_OBJECT].concat())
}

/// The pattern of an object of this `shape`: none unless it names one.
fn pattern(object: &Table, shape: &Shape) -> Result<Pattern, Located> {
    let is_box = matches!(shape, Shape::Box { .. });
    let spacing = object.size("spacing")?;
    let step = || spacing.unwrap_or(DEFAULT_SPACING);
    Ok(match object.string("pattern")? {
        None if spacing.is_some() => {
            return Err(object.wrong("spacing", "left out where there is no `pattern`"));
        }
        None => Pattern::Plain,
        Some("faces") if !is_box => return Err(object.wrong("pattern", "on a box: only that has faces")),
        Some("faces") if spacing.is_some() => {
            return Err(object.wrong("spacing", "left out where pattern = \"faces\", which has none"));
        }
        Some("faces") => Pattern::Faces,
        Some("graticule") if is_box => {
            return Err(
                object.wrong("pattern", "\"faces\", \"chequer\" or \"stripes\" on a box, which is not round")
            );
        }
        Some("graticule") => {
            let step_degrees = spacing.unwrap_or(DEFAULT_DEGREES);
            if 90.0 % step_degrees != 0.0 {
                return Err(object
                    .wrong("spacing", "a divisor of 90: degrees from line to line, such as 10, 15 or 30"));
            }
            Pattern::Graticule { step_degrees }
        }
        Some("chequer") => Pattern::Chequer { step: step() },
        Some("stripes") => Pattern::Stripes { step: step() },
        Some(_) => {
            return Err(object.wrong("pattern", "\"faces\", \"graticule\", \"chequer\" or \"stripes\""));
        }
    })
}

fn sphere(object: &Table) -> Result<Shape, Located> {
    check_keys(object, &["centre", "radius"])?;
    Ok(Shape::Sphere {
        centre: object.needed("centre", Table::point)?,
        radius: object.needed("radius", Table::size)?,
    })
}

fn tube(object: &Table) -> Result<Shape, Located> {
    let (from, to, radius) = ends_and_radius(object, SceneProblem::NoLength)?;
    Ok(Shape::Tube { from, to, radius })
}

fn ring(object: &Table) -> Result<Shape, Located> {
    check_keys(object, &["centre", "axis", "radius", "tube_radius"])?;
    let centre = object.needed("centre", Table::point)?;
    let axis = object.needed("axis", Table::direction)?;
    let radius = object.needed("radius", Table::size)?;
    let tube_radius = object.needed("tube_radius", Table::size)?;
    if tube_radius >= radius {
        let radius = object.quoted_value("radius");
        return Err(
            object.problem_at("tube_radius", |tube_radius| SceneProblem::NoHole { tube_radius, radius })
        );
    }
    Ok(Shape::Ring { centre, axis, radius, tube_radius })
}

fn cuboid(object: &Table) -> Result<Shape, Located> {
    check_keys(object, &["centre", "size", "axis", "angle"])?;
    let centre = object.needed("centre", Table::point)?;
    let half = object.needed_sizes("size")?.map(|size| 0.5 * size);
    let turn = object.turn("the box")?;
    Ok(Shape::Box { centre, half, turn: turn.to_array() })
}

fn cylinder(object: &Table) -> Result<Shape, Located> {
    let (from, to, radius) = ends_and_radius(object, SceneProblem::NoHeight)?;
    Ok(Shape::Cylinder { from, to, radius })
}

/// The ends of an axis and a radius; `no_axis` is what is wrong with ends in one place.
fn ends_and_radius(
    object: &Table,
    no_axis: fn(String) -> SceneProblem,
) -> Result<([f64; 3], [f64; 3], f64), Located> {
    check_keys(object, &["from", "to", "radius"])?;
    let from = object.needed("from", Table::point)?;
    let to = object.needed("to", Table::point)?;
    if coincide(from, to) {
        return Err(object.problem_at("to", no_axis));
    }
    Ok((from, to, object.needed("radius", Table::size)?))
}
