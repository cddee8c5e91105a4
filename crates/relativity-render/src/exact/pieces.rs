//! Bodies as what the GPU draws: pieces, each a bounding rectangle with the whole body's data.
//!
//! Every piece tests the ray against its whole body, so where the rectangles of one body overlap they
//! agree to the bit, and a strict depth test draws each pixel once.

use std::collections::BTreeMap;

use bytemuck::{Pod, Zeroable};
use glam::{DVec2, DVec3};

use crate::capsule::Capsule;
use crate::footprint::{Footprint, Projection, Rectangle};
use crate::kind::Kind;
use crate::placed::{PlacedBodies, PlacedBody};
use crate::view::{Colour, View};

/// How often a piece is halved before its bound is taken as it is: 32 rectangles follow the most bent of tubes, and
/// a looser bound only costs time.
const MAX_HALVINGS: u32 = 5;
/// Below this radius a piece may be faded in pictures instead of drawn thinner, px. The shader fades what it finds
/// thinner than half a pixel; the rest is room.
pub const THIN_PX: f64 = 0.75;

/// Where bodies are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bounds {
    /// Where they can appear.
    Tight,
    /// Everywhere: what tight bounds are measured against.
    None,
}

/// Mirror of the shaders' `Piece`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Piece {
    pub place: [f32; 4],
    pub second_axis_index_wavelength: [f32; 4],
    pub place_radius: [f32; 4],
    pub form: [f32; 4],
    pub rest_colour: [f32; 4],
}

/// The pieces of a view, solid before thin and kind by kind, else in the order of the bodies: where surfaces of two
/// coincide, the first that is drawn stays. Kept from view to view, for its memory.
#[derive(Debug, Default)]
pub struct Pieces {
    lists: BTreeMap<(bool, Kind), Vec<Piece>>,
    rectangles: Vec<Rectangle>,
}

impl Pieces {
    /// Replaces all by the pieces of `scene` in `view`; those of a radius below `thin_px` pixels are thin.
    pub fn refill(
        &mut self,
        scene: &PlacedBodies,
        view: &View,
        colour: Colour,
        bounds: Bounds,
        thin_px: f64,
    ) {
        let projection = Projection::new(view);
        let origin = view.rest_origin();
        self.lists.values_mut().for_each(Vec::clear);
        for body in &scene.bodies {
            match bounds {
                Bounds::Tight => self.bound(&projection, origin, scene.capsules(body)),
                Bounds::None => self.bound_nowhere(),
            }
            let template = Piece::new(body, colour);
            for rectangle in &self.rectangles {
                let is_thin = rectangle.radius_px < thin_px;
                self.lists.entry((is_thin, body.kind)).or_default().push(template.placed(rectangle));
            }
        }
    }

    /// Whether they are thin, their kind, and the pieces.
    pub fn lists(&self) -> impl Iterator<Item = (bool, Kind, &[Piece])> {
        let filled = self.lists.iter().filter(|(_, list)| !list.is_empty());
        filled.map(|(&(is_thin, kind), list)| (is_thin, kind, list.as_slice()))
    }

    fn bound(&mut self, projection: &Projection, origin: DVec3, capsules: &[Capsule]) {
        self.rectangles.clear();
        for capsule in capsules {
            add_rectangles(projection, &capsule.relative_to(origin), MAX_HALVINGS, &mut self.rectangles);
        }
        if self.rectangles.contains(&EVERYWHERE) {
            self.bound_nowhere();
        }
    }

    fn bound_nowhere(&mut self) {
        self.rectangles.clear();
        self.rectangles.push(EVERYWHERE);
    }
}

/// A rectangle over the whole picture.
const EVERYWHERE: Rectangle = Rectangle {
    middle: DVec2::ZERO,
    half_axes: [DVec2::X, DVec2::Y],
    radius_px: f64::INFINITY,
    is_loose: false,
};

fn add_rectangles(projection: &Projection, capsule: &Capsule, halvings: u32, out: &mut Vec<Rectangle>) {
    let is_whole = halvings == 0 || capsule.from == capsule.to;
    match projection.footprint(capsule) {
        Some(Footprint::Hidden) => {}
        Some(Footprint::Inside(rectangle)) if is_whole || !rectangle.is_loose => out.push(rectangle),
        None if is_whole => out.push(EVERYWHERE),
        Some(Footprint::Inside(_)) | None => {
            for half in capsule.halves() {
                add_rectangles(projection, &half, halvings - 1, out);
            }
        }
    }
}

impl Piece {
    /// How the vertex stage reads it.
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![
            0 => Float32x4, 1 => Float32x4, 2 => Float32x4, 3 => Float32x4, 4 => Float32x4
        ],
    };

    /// Of `body`, without a rectangle.
    fn new(body: &PlacedBody, colour: Colour) -> Self {
        let [red, green, blue] = body.rest_colour(colour);
        Self {
            place: [0.0; 4],
            second_axis_index_wavelength: [0.0, 0.0, body.index, body.rest_wavelength_nm],
            place_radius: body.place_radius,
            form: body.form,
            rest_colour: [red, green, blue, 0.0],
        }
    }

    fn placed(&self, rectangle: &Rectangle) -> Self {
        let [middle, first, second] =
            [rectangle.middle, rectangle.half_axes[0], rectangle.half_axes[1]].map(DVec2::as_vec2);
        let [_, _, index, wavelength] = self.second_axis_index_wavelength;
        Self {
            place: [middle.x, middle.y, first.x, first.y],
            second_axis_index_wavelength: [second.x, second.y, index, wavelength],
            ..*self
        }
    }
}
