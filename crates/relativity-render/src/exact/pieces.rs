//! Bodies as what the GPU draws: pieces, each a bounding rectangle with the whole body's data.
//!
//! Every piece tests the ray against its whole body, so where the rectangles of one body overlap they
//! agree to the bit, and a strict depth test draws each pixel once.

use bytemuck::{Pod, Zeroable};
use glam::{DVec2, DVec3};

use super::footprint::{Capsule, Footprint, Projection, Rectangle};
use crate::body::{Body, Shape};
use crate::colour::linear_srgb;
use crate::frame::{Extent, Placed, packed};
use crate::view::{Colour, View};

/// How often a piece is halved before its bound is taken as it is.
const MAX_HALVINGS: u32 = 5;
/// Below this radius a piece is faded in pictures instead of drawn thinner, px.
pub const THIN_PX: f64 = 0.75;

/// Where bodies are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bounds {
    /// Where they can appear.
    Tight,
    /// Everywhere: what tight bounds are measured against.
    None,
}

/// Mirror of the shaders' `Instance`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Instance {
    pub place: [f32; 4],
    pub second_axis_index_wavelength: [f32; 4],
    pub place_radius: [f32; 4],
    pub form: [f32; 4],
    pub rest_colour: [f32; 4],
}

/// The pieces of each kind (tubes and balls, rings), solid and thin, in the order of the bodies: where surfaces
/// of two coincide, the first that is drawn stays.
#[derive(Debug, Default)]
pub struct Pieces {
    pub solid: [Vec<Instance>; 2],
    pub thin: [Vec<Instance>; 2],
}

impl Pieces {
    /// The pieces of `bodies` in `view`; those of a radius below `thin_px` pixels are thin.
    pub fn new(
        bodies: &[Body],
        view: &View,
        colour: Colour,
        extent: &Extent,
        bounds: Bounds,
        thin_px: f64,
    ) -> Self {
        let projection = Projection::new(view);
        let origin = view.rest_origin();
        let mut pieces = Self::default();
        let mut rectangles = Vec::new();
        for (index, body) in bodies.iter().enumerate() {
            rectangles.clear();
            if bounds == Bounds::Tight {
                for capsule in bounding_capsules(&body.shape, origin) {
                    add_rectangles(&projection, &capsule, MAX_HALVINGS, &mut rectangles);
                }
            }
            if bounds == Bounds::None || rectangles.contains(&EVERYWHERE) {
                rectangles.clear();
                rectangles.push(EVERYWHERE);
            }
            pieces.add(&instance(index, body, extent, colour), kind(&body.shape), &rectangles, thin_px);
        }
        pieces
    }

    fn add(&mut self, template: &Instance, kind: usize, rectangles: &[Rectangle], thin_px: f64) {
        for rectangle in rectangles {
            let list = if rectangle.radius_px < thin_px { &mut self.thin } else { &mut self.solid };
            list[kind].push(placed(template, rectangle));
        }
    }
}

/// A rectangle over the whole picture.
const EVERYWHERE: Rectangle = Rectangle {
    middle: DVec2::ZERO,
    half_axes: [DVec2::X, DVec2::Y],
    radius_px: f64::INFINITY,
    is_loose: false,
};

fn kind(shape: &Shape) -> usize {
    match shape {
        Shape::Sphere { .. } | Shape::Tube { .. } => 0,
        Shape::Ring { .. } => 1,
    }
}

fn add_rectangles(projection: &Projection, capsule: &Capsule, halvings: u32, out: &mut Vec<Rectangle>) {
    let is_whole = halvings == 0 || capsule.from == capsule.to;
    match projection.footprint(capsule) {
        Some(Footprint::Hidden) => {}
        Some(Footprint::Inside(rectangle)) if is_whole || !rectangle.is_loose => out.push(rectangle),
        None if is_whole => out.push(EVERYWHERE),
        _ => {
            let middle = 0.5 * (capsule.from + capsule.to);
            for half in [Capsule { to: middle, ..*capsule }, Capsule { from: middle, ..*capsule }] {
                add_rectangles(projection, &half, halvings - 1, out);
            }
        }
    }
}

/// Capsules, relative to the camera's event, that contain the shape.
fn bounding_capsules(shape: &Shape, origin: DVec3) -> Vec<Capsule> {
    let relative = |p: [f64; 3]| DVec3::from(p) - origin;
    match *shape {
        Shape::Sphere { center, radius } => {
            vec![Capsule { from: relative(center), to: relative(center), radius }]
        }
        Shape::Tube { from, to, radius } => {
            vec![Capsule { from: relative(from), to: relative(to), radius }]
        }
        Shape::Ring { center, axis, radius, tube_radius } => {
            arcs(relative(center), axis.into(), radius, tube_radius)
        }
    }
}

/// A ring's arcs, each in a capsule along its chord, moved outwards by half the sagitta.
fn arcs(center: DVec3, axis: DVec3, radius: f64, tube_radius: f64) -> Vec<Capsule> {
    // Half the sagitta, radius angle^2/16, adds no more than half the tube's radius.
    let angle = (8.0 * tube_radius / radius).sqrt().clamp(0.2, 0.8);
    let count = (std::f64::consts::TAU / angle).ceil();
    let half_angle = std::f64::consts::PI / count;
    let half_sagitta = 0.5 * radius * (1.0 - half_angle.cos());
    let (u, v) = axis.any_orthonormal_pair();
    let point = |middle: f64, end: f64| {
        let outward = u * middle.cos() + v * middle.sin();
        let along = v * middle.cos() - u * middle.sin();
        center
            + outward * (radius * half_angle.cos() + half_sagitta)
            + along * (end * radius * half_angle.sin())
    };
    (0..count as u32)
        .map(|i| {
            let middle = 2.0 * half_angle * f64::from(i);
            Capsule { from: point(middle, -1.0), to: point(middle, 1.0), radius: tube_radius + half_sagitta }
        })
        .collect()
}

fn instance(index: usize, body: &Body, extent: &Extent, colour: Colour) -> Instance {
    let Placed { place_radius, form } = Placed::new(&body.shape, extent);
    let colour = linear_srgb(body.rest_wavelength_nm, colour);
    Instance {
        place: [0.0; 4],
        second_axis_index_wavelength: [0.0, 0.0, index as f32, body.rest_wavelength_nm as f32],
        place_radius,
        form,
        rest_colour: packed(colour.into(), 0.0),
    }
}

fn placed(template: &Instance, rectangle: &Rectangle) -> Instance {
    let [middle, first, second] =
        [rectangle.middle, rectangle.half_axes[0], rectangle.half_axes[1]].map(DVec2::as_vec2);
    let [_, _, index, wavelength] = template.second_axis_index_wavelength;
    Instance {
        place: [middle.x, middle.y, first.x, first.y],
        second_axis_index_wavelength: [second.x, second.y, index, wavelength],
        ..*template
    }
}
