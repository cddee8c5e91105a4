//! The canvas of every GPU renderer: the frame's uniforms, the colour tables, and the last pass.
//!
//! Bodies are drawn with four samples per pixel over nothing, in linear light; the last pass puts them over
//! sky and ground and applies the sRGB curve.

use std::sync::OnceLock;

use super::buffers::{fill_frame_buffer, frame_bindings, frame_buffer, vertex_buffer};
use super::device::Gpu;
use super::drawing::{Drawing, Shot};
use super::error::GpuError;
use super::models::Models;
use super::pipelines::Technique;
use super::target::{self, DEPTH_FORMAT, ENCODED_FORMAT, EyeTarget, MEASURES_FORMAT};
use crate::frame::hit_numbers::HitNumbers;
use crate::frame::pipeline_key::Key;
use crate::frame::uniform::FrameUniform;
use crate::light::{palette, sky};
use crate::picture::hit::HitImage;
use crate::scene::prepared_scene::PreparedScene;
use crate::shaders::BACKDROP;
use crate::street::backdrop::{LastPass, TILES};
use crate::view::effects::Constant;
use crate::view::{Appearance, Colour, View};

#[derive(Debug)]
pub struct Canvas {
    frame_layout: wgpu::BindGroupLayout,
    layer_layout: wgpu::BindGroupLayout,
    /// The tables of colours.
    tables: wgpu::TextureView,
    /// The street's daylight as what moves reflects it, once a picture has shown that.
    sky: OnceLock<wgpu::TextureView>,
    /// The models of the scene drawn last.
    models: Models,
}

impl Canvas {
    pub fn new(gpu: &Gpu) -> Self {
        let device = &gpu.device;
        let entries = [uniform_entry(), texture_entry(1), models_entry(2), texture_entry(3)];
        let frame_layout = bind_group_layout(device, &entries);
        let layer_layout = bind_group_layout(device, &[texture_entry(0)]);
        let tables = numbers(gpu, [palette::ENTRIES, palette::ROWS], &palette::tables());
        let models = Models::new(gpu);
        Self { frame_layout, layer_layout, tables, sky: OnceLock::new(), models }
    }

    /// Takes the models of `scene` onto the device, unless they are there; whether it can hold them.
    pub fn load_models(&mut self, gpu: &Gpu, scene: &PreparedScene) -> bool {
        self.models.load(gpu, scene)
    }

    /// Returns the pipeline that draws a part of the last pass.
    pub fn last_pass(&self, gpu: &Gpu, pass: LastPass) -> wgpu::RenderPipeline {
        gpu.cache.last_passes.get(pass, || {
            let module = gpu.shader("backdrop", BACKDROP);
            let layout = pipeline_layout(&gpu.device, &[Some(&self.frame_layout), Some(&self.layer_layout)]);
            let constants = gpu.sampling().among(pass.constants());
            last_pass_on(&gpu.device, &module, &layout, &constants)
        })
    }

    /// The layout of pipelines that draw bodies.
    pub fn body_layout(&self, gpu: &Gpu) -> wgpu::PipelineLayout {
        pipeline_layout(&gpu.device, &[Some(&self.frame_layout)])
    }

    /// Draws `scene` into `target`, whose size overrides the camera's, its bodies as `drawing` does.
    pub fn paint(
        &self,
        gpu: &Gpu,
        drawing: &mut dyn Drawing,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
        target: &mut EyeTarget,
    ) {
        let views = scene.group_views(&view.with_size(target.size()));
        let models = &self.models;
        let shot = Shot { scene, models, views: &views, appearance: Some(appearance) };
        drawing.load(gpu, &mut target.vertices, &shot);
        let frames = FrameUniform::of_groups(scene, &views, appearance);
        fill_frame_buffer(gpu, &mut target.frames, &frames);
        let last_passes: Vec<_> =
            last_passes(&frames[0]).map(|pass| (self.last_pass(gpu, pass), TILES[0] * TILES[1])).collect();
        let frames = self.frame_bind_groups(gpu, &target.frames, frames.len(), appearance.colour);
        self.draw(gpu, target, &frames[0], &last_passes, |pass| {
            drawing.record(pass, &target.vertices, &frames);
        });
    }

    /// Draws `bodies` into `target`, and over them each of the `last_passes`, given with its number of tiles,
    /// with the bindings of this `frame`.
    fn draw(
        &self,
        gpu: &Gpu,
        target: &EyeTarget,
        frame: &wgpu::BindGroup,
        last_passes: &[(wgpu::RenderPipeline, u32)],
        bodies: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let layers = target.layers(gpu);
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let layer = match &layers.samples {
                Some(samples) => wgpu::RenderPassColorAttachment {
                    resolve_target: Some(&layers.bodies),
                    ..attachment(samples, wgpu::StoreOp::Discard)
                },
                None => attachment(&layers.bodies, wgpu::StoreOp::Store),
            };
            let mut pass = begin_pass(&mut encoder, "bodies", &[Some(layer)], Some(&layers.depth));
            bodies(&mut pass);
        }
        {
            let picture = attachment(target.view(), wgpu::StoreOp::Store);
            let mut pass = begin_pass(&mut encoder, "last", &[Some(picture)], None);
            pass.set_bind_group(0, frame, &[]);
            pass.set_bind_group(1, &self.layer_bind_group(gpu, &layers.bodies), &[]);
            for (last_pass, tiles) in last_passes {
                pass.set_pipeline(last_pass);
                pass.draw(0..4, 0..*tiles);
            }
        }
        gpu.queue.submit([encoder.finish()]);
    }

    /// Makes the pipeline of `key`, and draws a triangle without an area with it into `target`, whose buffer
    /// of vertices holds the corners of one.
    pub fn try_bodies(&self, gpu: &Gpu, target: &EyeTarget, technique: &Technique, key: Key) {
        let pipeline = technique.pipeline(gpu, &self.body_layout(gpu), key);
        let frame = &self.frame_bind_groups(gpu, &target.frames, 1, Colour::White)[0];
        self.draw(gpu, target, frame, &[], |pass| {
            pass.set_bind_group(0, frame, &[]);
            pass.set_pipeline(&pipeline);
            for slot in 0..technique.buffers.len() {
                pass.set_vertex_buffer(slot as u32, target.vertices.slice(..));
            }
            pass.draw(0..3, 0..1);
        });
    }

    /// Makes the pipeline of a last pass, and draws one tile of `target` with it.
    pub fn try_last_pass(&self, gpu: &Gpu, target: &EyeTarget, pass: LastPass) {
        let frame = &self.frame_bind_groups(gpu, &target.frames, 1, Colour::White)[0];
        self.draw(gpu, target, frame, &[(self.last_pass(gpu, pass), 1)], |_| ());
    }

    /// Returns the hits at the centre of every pixel of `view` of `scene`, its bodies drawn as `drawing`
    /// does; without anti-aliasing.
    pub fn hits(
        &self,
        gpu: &Gpu,
        drawing: &mut dyn Drawing,
        scene: &PreparedScene,
        view: &View,
    ) -> Result<HitImage, GpuError> {
        let views = scene.group_views(view);
        let mut vertices = vertex_buffer(gpu, 0);
        let models = &self.models;
        let shot = Shot { scene, models, views: &views, appearance: None };
        drawing.load(gpu, &mut vertices, &shot);
        let frames = FrameUniform::of_groups(scene, &views, &Appearance::default());
        let measures = self.measure(gpu, view.camera.size, &frames, |pass, frames| {
            drawing.record(pass, &vertices, frames);
        })?;
        Ok(measures.hit_image(scene, view))
    }

    fn measure(
        &self,
        gpu: &Gpu,
        size: [u32; 2],
        frames: &[FrameUniform],
        bodies: impl FnOnce(&mut wgpu::RenderPass<'_>, &[wgpu::BindGroup]),
    ) -> Result<HitNumbers, GpuError> {
        let mut buffer = frame_buffer(gpu, frames.len());
        fill_frame_buffer(gpu, &mut buffer, frames);
        let frames = self.frame_bind_groups(gpu, &buffer, frames.len(), Colour::White);
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let [measures, places, depth] =
            [("measures", MEASURES_FORMAT), ("places", MEASURES_FORMAT), ("depth", DEPTH_FORMAT)]
                .map(|(label, format)| target::texture(gpu, label, size, 1, format, usage));
        let [measures_view, places_view, depth_view] = [&measures, &places, &depth]
            .map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()));
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let attachments =
                [&measures_view, &places_view].map(|view| Some(attachment(view, wgpu::StoreOp::Store)));
            let mut pass = begin_pass(&mut encoder, "hits", &attachments, Some(&depth_view));
            bodies(&mut pass, &frames);
        }
        gpu.queue.submit([encoder.finish()]);
        let numbers = |texture| -> Result<Vec<[f32; 4]>, GpuError> {
            let bytes = target::bytes(gpu, texture, size, 16)?;
            Ok(bytes.chunks_exact(16).map(bytemuck::pod_read_unaligned).collect())
        };
        Ok(HitNumbers { measures: numbers(&measures)?, places: numbers(&places)? })
    }

    /// Returns what the shaders read, for each of these frames of pictures by such colours.
    fn frame_bind_groups(
        &self,
        gpu: &Gpu,
        frames: &wgpu::Buffer,
        count: usize,
        colour: Colour,
    ) -> Vec<wgpu::BindGroup> {
        let size = [sky::WIDTH, sky::SPEEDS * sky::TURNS].map(|side| side as u32);
        let sky = match colour {
            Colour::StreetDaylight => self.sky.get_or_init(|| numbers(gpu, size, &sky::table())),
            // No other reads it.
            _ => &self.tables,
        };
        let [tables, models, sky] =
            [&self.tables, self.models.view(), sky].map(wgpu::BindingResource::TextureView);
        let group = |frame| {
            let entries = [
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::Buffer(frame) },
                wgpu::BindGroupEntry { binding: 1, resource: tables.clone() },
                wgpu::BindGroupEntry { binding: 2, resource: models.clone() },
                wgpu::BindGroupEntry { binding: 3, resource: sky.clone() },
            ];
            bind_group(gpu, &self.frame_layout, &entries)
        };
        frame_bindings(gpu, frames, count).map(group).collect()
    }

    fn layer_bind_group(&self, gpu: &Gpu, layer: &wgpu::TextureView) -> wgpu::BindGroup {
        let resource = wgpu::BindingResource::TextureView(layer);
        bind_group(gpu, &self.layer_layout, &[wgpu::BindGroupEntry { binding: 0, resource }])
    }
}

/// Returns the parts of the last pass of pictures like that of `frame`.
pub fn last_passes(frame: &FrameUniform) -> impl Iterator<Item = LastPass> {
    let (street, is_conformal, is_oblique) =
        (frame.street(), frame.is_conformal(), frame.is_street_oblique());
    frame.floor().parts().iter().map(move |&part| LastPass { part, street, is_conformal, is_oblique })
}

pub fn begin_pass<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    color_attachments: &[Option<wgpu::RenderPassColorAttachment<'_>>],
    depth: Option<&wgpu::TextureView>,
) -> wgpu::RenderPass<'a> {
    let depth_ops = Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard });
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments,
        depth_stencil_attachment: depth.map(|view| wgpu::RenderPassDepthStencilAttachment {
            view,
            depth_ops,
            stencil_ops: None,
        }),
        ..Default::default()
    })
}

pub fn attachment(view: &wgpu::TextureView, store: wgpu::StoreOp) -> wgpu::RenderPassColorAttachment<'_> {
    wgpu::RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target: None,
        ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT), store },
    }
}

fn last_pass_on(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layout: &wgpu::PipelineLayout,
    constants: &[Constant],
) -> wgpu::RenderPipeline {
    let compilation_options = wgpu::PipelineCompilationOptions { constants, ..Default::default() };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("last pass"),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("tile"),
            compilation_options: compilation_options.clone(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            ..wgpu::PrimitiveState::default()
        },
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some("composite"),
            compilation_options,
            targets: &[Some(ENCODED_FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// A texture of `numbers`.
fn numbers(gpu: &Gpu, size: [u32; 2], numbers: &[[f32; 4]]) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let texture = target::texture(gpu, "numbers", size, 1, wgpu::TextureFormat::Rgba32Float, usage);
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(size[0] * 16), rows_per_image: None };
    gpu.queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(numbers), layout, texture.size());
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

pub fn bind_group(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    entries: &[wgpu::BindGroupEntry<'_>],
) -> wgpu::BindGroup {
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries })
}

pub fn bind_group_layout(
    device: &wgpu::Device,
    entries: &[wgpu::BindGroupLayoutEntry],
) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries })
}

pub fn pipeline_layout(
    device: &wgpu::Device,
    bind_group_layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::PipelineLayout {
    device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts,
        immediate_size: 0,
    })
}

pub fn uniform_entry() -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding: 0,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

pub fn texture_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    sampled_entry(binding, wgpu::TextureSampleType::Float { filterable: false })
}

fn models_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    sampled_entry(binding, wgpu::TextureSampleType::Uint)
}

fn sampled_entry(binding: u32, sample_type: wgpu::TextureSampleType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}
