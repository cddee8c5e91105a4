//! The bodies of a view as they are drawn: how finely each is divided, and in which order.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use relativity_core::threads::prelude::*;

use super::division::division;
use super::template::Division;
use crate::footprint::Projection;
use crate::group_view::GroupView;
use crate::prepared_body::{Joint, PreparedBody, packed};
use crate::scene::PreparedScene;
use crate::view::{Colour, Geometry};

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
    /// The number of its group.
    pub group: usize,
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
    /// Replaces all by the bodies of `scene` that can be seen where `views` show its groups, divided to keep `bound_px`
    /// in the views `divided_for`. Thin ones are drawn wider if `are_widened`.
    pub fn refill(
        &mut self,
        scene: &PreparedScene,
        views: &[GroupView],
        divided_for: &[GroupView],
        colour: Colour,
        bound_px: f64,
        are_widened: bool,
    ) {
        let projections: Vec<_> = views.iter().map(Projection::new).collect();
        let is_seen = |body: &PreparedBody| {
            let view = &views[body.group];
            let middle = view.reflected_from_camera(body.solid.center());
            // The published positions are not the view's.
            view.geometry == Geometry::Published
                || !projections[body.group].hides(middle, body.solid.bounding_radius())
        };
        let part = |body: &PreparedBody| {
            let (instance, view) = (Instance::new(body, colour), &divided_for[body.group]);
            Part {
                division: division(&body.surface, view, bound_px),
                instance: if are_widened { instance.widened(body, view) } else { instance },
                group: body.group,
                joint: body.joint,
            }
        };
        scene
            .bodies()
            .par_iter()
            .map(|body| is_seen(body).then(|| part(body)))
            .collect_into_vec(&mut self.found);
        self.sorted.clear();
        self.sorted.extend(self.found.iter().flatten());
        self.sorted.sort_unstable_by_key(Part::rank);
    }

    /// Those that are drawn by one draw, in order.
    pub fn runs(&self) -> impl Iterator<Item = &[Part]> {
        let trait_of = |part: &Part| (part.group, part.division, part.is_thin());
        self.sorted.chunk_by(move |a, b| trait_of(a) == trait_of(b))
    }
}

impl Part {
    /// Whether it is thinner than a pixel, and faded for that.
    pub fn is_thin(&self) -> bool {
        self.instance.cover < 1.0
    }

    /// Its place in the order: faded ones last; group by group; in the bodies' order where surfaces may coincide, so that the first of
    /// them stays, and else those of one division together, which saves a draw for each.
    fn rank(&self) -> (bool, usize, Option<Division>, u32) {
        let is_thin = self.is_thin();
        let is_joined = if is_thin { self.joint.widened } else { self.joint.as_it_is };
        let [_, _, _, index] = self.instance.across_index;
        (is_thin, self.group, (!is_joined).then_some(self.division), index as u32)
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

    fn new(body: &PreparedBody, colour: Colour) -> Self {
        let [red, green, blue] = body.rest_colour(colour);
        Self {
            place_radius: body.place_radius,
            form: body.form,
            across_index: packed(body.surface.across(), f64::from(body.index)),
            colour_wavelength: [red, green, blue, body.rest_wavelength_nm as f32],
            cover: 1.0,
        }
    }

    /// Drawn at least a pixel wide: thinner, it is faded instead of broken up.
    fn widened(self, body: &PreparedBody, view: &GroupView) -> Self {
        let distance = view.apparent_position(body.solid.center()).map_or(f64::INFINITY, DVec3::length);
        let [x, y, z, radius] = self.place_radius;
        let half_pixel = (0.5 * distance / view.camera.focal_length_px()) as f32;
        if radius >= half_pixel {
            return self;
        }
        Self { place_radius: [x, y, z, half_pixel], cover: radius / half_pixel, ..self }
    }
}
