//! The exact renderer: a ray test per pixel, in the rest frame, on the GPU.
//!
//! Each piece of a body is drawn as a rectangle that surely contains its image (`footprint`); the
//! fragment stage boosts the pixel's line of sight into the rest frame, where rays are straight, and
//! tests it against the body.

mod footprint;
mod pieces;
mod pipelines;

use glam::DVec3;

use crate::body::Body;
use crate::camera::LinesOfSight;
use crate::frame::Frame;
use crate::gpu::{Gpu, GpuError};
use crate::intersect::Solid;
use crate::palette;
use crate::reference::{Hit, HitImage};
use crate::target::{self, DEPTH_FORMAT, EyeTarget, MEASURES_FORMAT};
use crate::view::{Appearance, Colour, Shading, View};
use pieces::{Instance, Pieces};
use pipelines::{Effects, Key, Pipelines};

/// Draws exactly what an aperture sees.
#[derive(Debug)]
pub struct ExactRenderer {
    pipelines: Pipelines,
    tables: [wgpu::TextureView; 2],
}

impl ExactRenderer {
    /// A renderer on `gpu`; pipelines are made when first needed.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            pipelines: Pipelines::new(gpu),
            tables: [Colour::Visible, Colour::False].map(|colour| colour_table(gpu, colour)),
        }
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
        let mut view = *view;
        view.camera.size = target.size();
        let pieces = Pieces::new(bodies, &view, appearance);
        let draws = target.instances.load(gpu, &pieces);
        let effects = Effects::new(view.geometry, appearance);
        let backdrop = Key::Backdrop {
            sky: appearance.sky,
            ground: appearance.ground_z.is_some(),
            light: appearance.light,
        };
        let keys: Vec<_> =
            draws.iter().map(|draw| Key::Picture { shape: draw.shape, thin: draw.thin, effects }).collect();
        self.pipelines.prepare(gpu, backdrop);
        for key in &keys {
            self.pipelines.prepare(gpu, *key);
        }
        let frame = Frame::new(&view, appearance);
        gpu.queue.write_buffer(&target.instances.frame, 0, bytemuck::bytes_of(&frame));
        let bind_group = self.bind_group(gpu, &target.instances.frame, appearance.colour);

        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("picture"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &target.samples,
                    depth_slice: None,
                    resolve_target: Some(&target.resolved),
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                        store: wgpu::StoreOp::Discard,
                    },
                })],
                depth_stencil_attachment: Some(depth_attachment(&target.depth)),
                ..Default::default()
            });
            pass.set_bind_group(0, &bind_group, &[]);
            if let Some(pipeline) = self.pipelines.get(backdrop) {
                pass.set_pipeline(pipeline);
                pass.draw(0..3, 0..1);
            }
            target.instances.record(&mut pass, &draws, |i| self.pipelines.get(keys[i]));
        }
        gpu.queue.submit([encoder.finish()]);
    }

    /// What the centre of every pixel of `view`'s camera shows.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn hits(&mut self, gpu: &Gpu, bodies: &[Body], view: &View) -> Result<HitImage, GpuError> {
        let appearance = Appearance {
            colour: Colour::Visible,
            doppler_shift: false,
            intensity_exponent: None,
            exposure_ev: 0.0,
            shading: Shading::Emission,
            ground_z: None,
            sky: false,
            light: false,
        };
        let size = view.camera.size;
        let pieces = Pieces::new(bodies, view, &appearance);
        let mut instances = InstanceBuffers::new(gpu);
        let draws = instances.load(gpu, &pieces);
        let keys: Vec<_> =
            draws.iter().map(|draw| Key::Hits { shape: draw.shape, geometry: view.geometry }).collect();
        for key in &keys {
            self.pipelines.prepare(gpu, *key);
        }
        gpu.queue.write_buffer(&instances.frame, 0, bytemuck::bytes_of(&Frame::new(view, &appearance)));
        let bind_group = self.bind_group(gpu, &instances.frame, Colour::Visible);
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let [measures, places] = ["measures", "places"]
            .map(|label| target::texture(gpu, label, size, 1, MEASURES_FORMAT, usage, &[]));
        let depth =
            target::texture(gpu, "depth", size, 1, DEPTH_FORMAT, wgpu::TextureUsages::RENDER_ATTACHMENT, &[]);
        let whole = wgpu::TextureViewDescriptor::default();
        let [measures_view, places_view, depth_view] =
            [&measures, &places, &depth].map(|texture| texture.create_view(&whole));

        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let cleared = |view| {
                Some(wgpu::RenderPassColorAttachment {
                    view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                        store: wgpu::StoreOp::Store,
                    },
                })
            };
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("hits"),
                color_attachments: &[cleared(&measures_view), cleared(&places_view)],
                depth_stencil_attachment: Some(depth_attachment(&depth_view)),
                ..Default::default()
            });
            pass.set_bind_group(0, &bind_group, &[]);
            instances.record(&mut pass, &draws, |i| self.pipelines.get(keys[i]));
        }
        gpu.queue.submit([encoder.finish()]);
        let measures = target::bytes(gpu, &measures, size, 16)?;
        let places = target::bytes(gpu, &places, size, 16)?;
        Ok(HitImage { size, hits: decoded_hits(bodies, view, &measures, &places) })
    }

    fn bind_group(&self, gpu: &Gpu, frame: &wgpu::Buffer, colour: Colour) -> wgpu::BindGroup {
        let table = &self.tables[usize::from(colour == Colour::False)];
        gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("frame"),
            layout: &self.pipelines.bind_group_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(table) },
            ],
        })
    }
}

fn depth_attachment(view: &wgpu::TextureView) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard }),
        stencil_ops: None,
    }
}

/// Hits from what the shader wrote; what the shader has not written follows from it in f64.
fn decoded_hits(bodies: &[Body], view: &View, measures: &[u8], places: &[u8]) -> Vec<Option<Hit>> {
    let numbers = |bytes: &[u8]| -> Vec<[f32; 4]> {
        bytes.chunks_exact(16).map(bytemuck::pod_read_unaligned).collect()
    };
    let solids: Vec<_> = bodies.iter().map(|body| Solid::new(&body.shape)).collect();
    let lines_of_sight = LinesOfSight::new(&view.camera);
    let width = view.camera.size[0] as usize;
    let decoded = |(i, ([index, distance, doppler, is_hit], place)): (usize, ([f32; 4], [f32; 4]))| {
        if is_hit != 1.0 {
            return None;
        }
        let body = index as usize;
        let [x, y, z, _] = place.map(f64::from);
        let rest_position = solids[body].center() + DVec3::new(x, y, z);
        let distance = f64::from(distance);
        let pixel = [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5];
        Some(Hit {
            body,
            rest_position,
            rest_normal: solids[body].normal(rest_position),
            distance,
            emission_time: view.emission_time(lines_of_sight.through(pixel), distance),
            doppler_factor: f64::from(doppler),
        })
    };
    numbers(measures).into_iter().zip(numbers(places)).enumerate().map(decoded).collect()
}

fn colour_table(gpu: &Gpu, colour: Colour) -> wgpu::TextureView {
    let size = [palette::ENTRIES, 1];
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let texture = target::texture(gpu, "colour table", size, 1, MEASURES_FORMAT, usage, &[]);
    gpu.queue.write_texture(
        texture.as_image_copy(),
        bytemuck::cast_slice(&palette::table(colour)),
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(palette::ENTRIES * 16),
            rows_per_image: None,
        },
        texture.size(),
    );
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// What one eye's pass reads: its own frame and instances, so that two eyes do not overwrite each other.
#[derive(Debug)]
pub(crate) struct InstanceBuffers {
    frame: wgpu::Buffer,
    instances: wgpu::Buffer,
}

/// A range of instances drawn by one pipeline.
#[derive(Debug, Clone)]
struct Draw {
    shape: usize,
    thin: bool,
    instances: std::ops::Range<u32>,
}

impl InstanceBuffers {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let frame = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("frame"),
            size: size_of::<Frame>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { frame, instances: instance_buffer(gpu, 256) }
    }

    fn load(&mut self, gpu: &Gpu, pieces: &Pieces) -> Vec<Draw> {
        let mut all = Vec::new();
        let mut draws = Vec::new();
        for (thin, lists) in [(false, &pieces.solid), (true, &pieces.thin)] {
            for (shape, list) in lists.iter().enumerate().filter(|(_, list)| !list.is_empty()) {
                let start = all.len() as u32;
                all.extend_from_slice(list);
                draws.push(Draw { shape, thin, instances: start..all.len() as u32 });
            }
        }
        if size_of_val(all.as_slice()) as u64 > self.instances.size() {
            self.instances = instance_buffer(gpu, all.len().next_power_of_two());
        }
        gpu.queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&all));
        draws
    }

    fn record<'a>(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        draws: &[Draw],
        pipeline: impl Fn(usize) -> Option<&'a wgpu::RenderPipeline>,
    ) {
        pass.set_vertex_buffer(0, self.instances.slice(..));
        for (i, draw) in draws.iter().enumerate() {
            if let Some(pipeline) = pipeline(i) {
                pass.set_pipeline(pipeline);
                pass.draw(0..4, draw.instances.clone());
            }
        }
    }
}

fn instance_buffer(gpu: &Gpu, count: usize) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("instances"),
        size: (count * size_of::<Instance>()) as u64,
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
