//! The mesh renderer: triangles whose corners go through the apparent position.
//!
//! Each body is an instance of a grid over its unit shape, divided as finely as the bound asks for
//! (`division`). Corners lie exactly where the light cone says; between them pictures are off by no more
//! than the bound. Unlike the exact renderer it can draw any map of points, and so the published
//! binocular model, which is defined point by point and has no lines of sight.
//!
//! Which of two bodies is nearer is decided by the pixel's ray where there is one, as in the exact renderer:
//! bodies that nearly touch are nearer to each other than triangles are to their surfaces.

mod division;
mod map;
mod order;
mod pipelines;
mod template;

use std::collections::HashMap;
use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use rayon::prelude::*;

use crate::body::{Body, Shape};
use crate::canvas::{self, Canvas};
use crate::colour::linear_srgb;
use crate::effects::Effects;
use crate::exact::Projection;
use crate::frame::{Extent, Frame, Placed, packed};
use crate::gpu::{Gpu, GpuError};
use crate::intersect::Solid;
use crate::reference::HitImage;
use crate::target::EyeTarget;
use crate::view::{Appearance, Colour, Geometry, View};
use map::Map;
use pipelines::{Key, Pipelines};

pub(crate) use template::Corner;
use template::Division;

/// Draws triangles that keep a bound on the picture.
#[derive(Debug)]
pub struct MeshRenderer {
    canvas: Canvas,
    pipelines: Pipelines,
    templates: HashMap<Division, Loaded>,
    /// How far any point may be drawn from where it is seen, pixels, above 0.
    pub bound_px: f64,
}

/// A template on the device.
#[derive(Debug)]
struct Loaded {
    corners: wgpu::Buffer,
    triangles: wgpu::Buffer,
    count: u32,
}

/// Mirror of the shaders' `Solid`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Instance {
    pub place_radius: [f32; 4],
    pub form: [f32; 4],
    pub across_index: [f32; 4],
    pub colour_wavelength: [f32; 4],
    pub cover: f32,
}

/// A body as it is drawn.
struct Part {
    division: Division,
    instance: Instance,
}

/// Neighbouring parts of one division.
struct Draw {
    division: Division,
    key: Key,
    instances: Range<u32>,
}

impl Part {
    /// Whether it is thinner than a pixel, and faded for that.
    fn is_thin(&self) -> bool {
        self.instance.cover < 1.0
    }

    fn is_ring(&self) -> bool {
        matches!(self.division, Division::Ring { .. })
    }

    fn is_drawn_with(&self, other: &Self) -> bool {
        self.division == other.division && self.is_thin() == other.is_thin()
    }
}

impl MeshRenderer {
    /// The bound unless another is chosen, pixels.
    pub const DEFAULT_BOUND_PX: f64 = 0.5;

    /// A renderer on `gpu` with the default bound.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        let canvas = Canvas::new(gpu);
        let pipelines = Pipelines::new(gpu, canvas.body_layout(gpu));
        Self { canvas, pipelines, templates: HashMap::new(), bound_px: Self::DEFAULT_BOUND_PX }
    }

    /// Draws `bodies` into `target`, whose size overrides the camera's.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        bodies: &[Body],
        view: &View,
        appearance: &Appearance,
        target: &mut EyeTarget,
    ) {
        let view = &view.with_size(target.size());
        let extent = Extent::new(bodies, view.rest_origin());
        let geometry = view.geometry;
        let effects = Effects::new(geometry.has_doppler_effect(), appearance);
        let key = |is_ring, is_thin| Key::Picture { is_ring, is_thin, geometry, effects };
        let map = Map::new(view);
        let parts = self.parts(bodies, view, &map, |index, body| {
            widened(instance(index, body, appearance.colour, &extent), body, &map)
        });
        let draws = self.load(gpu, &parts, &mut target.vertices, key);
        let frame = Frame::new(view, appearance, &extent);
        self.canvas.paint(gpu, target, &frame, appearance, |pass| {
            self.record(pass, &target.vertices, &draws);
        });
    }

    /// What the centre of every pixel of `view`'s camera shows, without anti-aliasing.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn hits(&mut self, gpu: &Gpu, bodies: &[Body], view: &View) -> Result<HitImage, GpuError> {
        self.hits_in_part(gpu, bodies, view, view)
    }

    /// What `part`, a magnified view of a small part of `whole`, shows of the triangles that `whole` is drawn with.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn hits_in_part(
        &mut self,
        gpu: &Gpu,
        bodies: &[Body],
        whole: &View,
        part: &View,
    ) -> Result<HitImage, GpuError> {
        let extent = Extent::new(bodies, part.rest_origin());
        let map = Map::new(whole);
        let parts =
            self.parts(bodies, part, &map, |index, body| instance(index, body, Colour::Visible, &extent));
        let mut vertices = canvas::vertex_buffer(gpu, 0);
        let geometry = part.geometry;
        let draws = self.load(gpu, &parts, &mut vertices, |is_ring, _| Key::Hits { is_ring, geometry });
        let frame = Frame::new(part, &Appearance::default(), &extent);
        let measures = self.canvas.measure(gpu, part.camera.size, &frame, |pass| {
            self.record(pass, &vertices, &draws);
        })?;
        Ok(measures.hit_image(&crate::scene::PreparedScene::moving(bodies), part))
    }

    /// The bodies that can be seen in `view`, divided for `map`, in the order they are drawn in.
    fn parts(
        &self,
        bodies: &[Body],
        view: &View,
        map: &Map,
        instance: impl Fn(usize, &Body) -> Instance + Sync,
    ) -> Vec<Part> {
        let projection = Projection::new(view);
        let is_seen = |body: &Body| {
            let solid = Solid::new(&body.shape);
            // The published positions are not the view's.
            map.geometry == Geometry::Published
                || !projection.hides(solid.center() - view.rest_origin(), solid.bounding_radius())
        };
        let visible = bodies.par_iter().enumerate().filter(|(_, body)| is_seen(body));
        let part = |(index, body)| Part {
            division: division::division(body, map, self.bound_px),
            instance: instance(index, body),
        };
        let mut parts: Vec<_> = visible.map(part).collect();
        order::sort(&mut parts);
        parts
    }

    fn load(
        &mut self,
        gpu: &Gpu,
        parts: &[Part],
        vertices: &mut wgpu::Buffer,
        key: impl Fn(bool, bool) -> Key,
    ) -> Vec<Draw> {
        let mut instances = Vec::new();
        let mut draws = Vec::new();
        for run in parts.chunk_by(Part::is_drawn_with) {
            let start = instances.len() as u32;
            instances.extend(run.iter().map(|part| part.instance));
            let division = run[0].division;
            let key = key(run[0].is_ring(), run[0].is_thin());
            self.pipelines.prepare(gpu, key);
            self.templates.entry(division).or_insert_with(|| Loaded::new(gpu, division));
            draws.push(Draw { division, key, instances: start..instances.len() as u32 });
        }
        canvas::fill_vertex_buffer(gpu, vertices, &instances);
        draws
    }

    fn record(&self, pass: &mut wgpu::RenderPass<'_>, instances: &wgpu::Buffer, draws: &[Draw]) {
        for draw in draws {
            let template = &self.templates[&draw.division];
            pass.set_pipeline(self.pipelines.get(draw.key));
            pass.set_vertex_buffer(0, template.corners.slice(..));
            pass.set_vertex_buffer(1, instances.slice(..));
            pass.set_index_buffer(template.triangles.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..template.count, 0, draw.instances.clone());
        }
    }
}

impl Loaded {
    fn new(gpu: &Gpu, division: Division) -> Self {
        let template = division.template();
        let buffer = |bytes: &[u8], usage| {
            let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("template"),
                size: bytes.len() as u64,
                usage: usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            gpu.queue.write_buffer(&buffer, 0, bytes);
            buffer
        };
        Self {
            corners: buffer(bytemuck::cast_slice(&template.corners), wgpu::BufferUsages::VERTEX),
            triangles: buffer(bytemuck::cast_slice(&template.triangles), wgpu::BufferUsages::INDEX),
            count: template.triangles.len() as u32,
        }
    }
}

/// Drawn at least a pixel wide: thinner, it is faded instead of broken up.
fn widened(instance: Instance, body: &Body, map: &Map) -> Instance {
    let distance = map.apparent(Solid::new(&body.shape).center()).length();
    let [x, y, z, radius] = instance.place_radius;
    let half_pixel = (0.5 * distance / map.focal_length_px) as f32;
    if radius >= half_pixel {
        return instance;
    }
    Instance { place_radius: [x, y, z, half_pixel], cover: radius / half_pixel, ..instance }
}

fn instance(index: usize, body: &Body, colour: Colour, extent: &Extent) -> Instance {
    let Placed { place_radius, form } = Placed::new(&body.shape, extent);
    let axis = match body.shape {
        Shape::Sphere { .. } => DVec3::X,
        Shape::Tube { from, to, .. } => {
            (DVec3::from(to) - DVec3::from(from)).try_normalize().unwrap_or(DVec3::X)
        }
        Shape::Ring { axis, .. } => axis.into(),
    };
    let (across, _) = division::basis(axis);
    let colour = linear_srgb(body.rest_wavelength_nm, colour);
    Instance {
        place_radius,
        form,
        across_index: packed(across, index as f64),
        colour_wavelength: packed(colour.into(), body.rest_wavelength_nm),
        cover: 1.0,
    }
}
