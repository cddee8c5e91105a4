//! The bodies of a view as they are drawn: how finely each is divided, and in which order.

use bytemuck::{Pod, Zeroable};
use relativity_core::threads::prelude::*;

use super::division::division;
use super::map::Map;
use super::template::Division;
use crate::footprint::Projection;
use crate::placed::{Joint, PlacedBodies, PlacedBody, packed};
use crate::view::{Colour, Geometry, View};

/// Mirror of the shaders' `Instance`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Instance {
    pub place_radius: [f32; 4],
    pub form: [f32; 4],
    pub across_index: [f32; 4],
    pub colour_wavelength: [f32; 4],
    pub cover: f32,
}

/// A body as it is drawn.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    pub division: Division,
    pub instance: Instance,
    joint: Joint,
}

/// The parts of a view. Kept from view to view, for their memory.
#[derive(Debug, Default)]
pub struct Parts {
    /// One for each body, `None` for those out of sight.
    found: Vec<Option<Part>>,
    /// In the order they are drawn in.
    sorted: Vec<Part>,
}

impl Parts {
    /// Replaces all by the bodies of `scene` that can be seen in `view`, divided to keep `bound_px` under `map`. Thin
    /// ones are drawn wider if `are_widened`.
    pub fn refill(
        &mut self,
        scene: &PlacedBodies,
        view: &View,
        colour: Colour,
        map: &Map,
        bound_px: f64,
        are_widened: bool,
    ) {
        let projection = Projection::new(view);
        let origin = view.rest_origin();
        let is_seen = |body: &PlacedBody| {
            // The published positions are not the view's.
            map.geometry == Geometry::Published
                || !projection.hides(body.solid.center() - origin, body.solid.bounding_radius())
        };
        let part = |body: &PlacedBody| {
            let instance = Instance::new(body, colour);
            Part {
                division: division(&body.surface, map, bound_px),
                instance: if are_widened { instance.widened(body, map) } else { instance },
                joint: body.joint,
            }
        };
        scene
            .bodies
            .par_iter()
            .map(|body| is_seen(body).then(|| part(body)))
            .collect_into_vec(&mut self.found);
        self.sorted.clear();
        self.sorted.extend(self.found.iter().flatten());
        self.sorted.sort_unstable_by_key(Part::rank);
    }

    /// Those that are drawn by one draw, in order.
    pub fn runs(&self) -> impl Iterator<Item = &[Part]> {
        self.sorted.chunk_by(|a, b| a.division == b.division && a.is_thin() == b.is_thin())
    }
}

impl Part {
    /// Whether it is thinner than a pixel, and faded for that.
    pub fn is_thin(&self) -> bool {
        self.instance.cover < 1.0
    }

    /// Its place in the order: faded ones last; in the bodies' order where surfaces may coincide, so that the first of
    /// them stays, and else those of one division together, which saves a draw for each.
    fn rank(&self) -> (bool, Option<Division>, u32) {
        let is_thin = self.is_thin();
        let is_joined = if is_thin { self.joint.widened } else { self.joint.as_it_is };
        let [_, _, _, index] = self.instance.across_index;
        (is_thin, (!is_joined).then_some(self.division), index as u32)
    }
}

impl Instance {
    /// How the vertex stage reads it.
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![
            2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32
        ],
    };

    fn new(body: &PlacedBody, colour: Colour) -> Self {
        let [red, green, blue] = body.rest_colour(colour);
        Self {
            place_radius: body.place_radius,
            form: body.form,
            across_index: packed(body.surface.across(), f64::from(body.index)),
            colour_wavelength: [red, green, blue, body.rest_wavelength_nm],
            cover: 1.0,
        }
    }

    /// Drawn at least a pixel wide: thinner, it is faded instead of broken up.
    fn widened(self, body: &PlacedBody, map: &Map) -> Self {
        let distance = map.apparent(body.solid.center()).length();
        let [x, y, z, radius] = self.place_radius;
        let half_pixel = (0.5 * distance / map.focal_length_px) as f32;
        if radius >= half_pixel {
            return self;
        }
        Self { place_radius: [x, y, z, half_pixel], cover: radius / half_pixel, ..self }
    }
}
