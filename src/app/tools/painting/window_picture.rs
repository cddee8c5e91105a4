//! A window's picture, kept from frame to frame.

use std::ops::Range;

use eframe::egui::epaint::{ClippedPrimitive, Primitive};
use eframe::egui::{PaintCallbackInfo, Rect, TextureId};
use eframe::egui_wgpu::{CallbackResources, CallbackTrait, RenderState};
use eframe::wgpu;

use super::pipelines::PaintPipelines;

/// The kept picture of a window.
pub struct WindowPicture {
    size: [u32; 2],
    view: wgpu::TextureView,
    scale: wgpu::Buffer,
    of_window: wgpu::BindGroup,
    shown: PictureCallback,
    vertices: Buffer,
    indices: Buffer,
}

/// Shows it in the window.
#[derive(Clone)]
pub struct PictureCallback {
    pipeline: wgpu::RenderPipeline,
    kept: wgpu::BindGroup,
}

/// A buffer that grows.
struct Buffer {
    buffer: Option<wgpu::Buffer>,
    usage: wgpu::BufferUsages,
}

/// Triangles that are painted at once.
struct TriangleRun {
    scissor: [u32; 4],
    texture: TextureId,
    indices: Range<u32>,
}

impl WindowPicture {
    /// Returns a picture of this size, pixels; nothing is painted on it yet.
    pub fn new(render_state: &RenderState, pipelines: &PaintPipelines, size: [u32; 2]) -> Self {
        let RenderState { device, target_format, .. } = render_state;
        let largest = device.limits().max_texture_dimension_2d;
        let [width, height] = size.map(|side| side.min(largest));
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("window"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: *target_format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let scale = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("window"),
            size: 16,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let group = |layout, binding, resource| {
            let entries = &[wgpu::BindGroupEntry { binding, resource }];
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some("window"), layout, entries })
        };
        let of_window = group(&pipelines.of_window, 0, scale.as_entire_binding());
        let kept = group(&pipelines.of_kept, 1, wgpu::BindingResource::TextureView(&view));
        let buffer = |usage| Buffer { buffer: None, usage: usage | wgpu::BufferUsages::COPY_DST };
        Self {
            size,
            view,
            scale,
            of_window,
            shown: PictureCallback { pipeline: pipelines.shown.clone(), kept },
            vertices: buffer(wgpu::BufferUsages::VERTEX),
            indices: buffer(wgpu::BufferUsages::INDEX),
        }
    }

    /// Returns the size of the picture, pixels.
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns what shows the picture.
    pub fn shown(&self) -> PictureCallback {
        self.shown.clone()
    }

    /// Paints `primitives` over what is there.
    pub fn paint(
        &mut self,
        render_state: &RenderState,
        pipelines: &PaintPipelines,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
    ) {
        let RenderState { device, queue, renderer, .. } = render_state;
        let (runs, vertices, indices) = self.runs(primitives, pixels_per_point);
        let [x, y] = self.size.map(|side| 2.0 * pixels_per_point / side as f32);
        queue.write_buffer(&self.scale, 0, bytemuck::bytes_of(&[x, y, 0.0, 0.0]));
        let (Some(vertices), Some(indices)) =
            (self.vertices.write(device, queue, &vertices), self.indices.write(device, queue, &indices))
        else {
            return;
        };
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("window"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.view,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
                depth_slice: None,
            })],
            ..Default::default()
        });
        pass.set_pipeline(&pipelines.triangles);
        pass.set_bind_group(0, &self.of_window, &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        let renderer = renderer.read();
        for TriangleRun { scissor: [x, y, width, height], texture, indices } in runs {
            if let Some(texture) = renderer.texture(&texture) {
                pass.set_bind_group(1, &texture.bind_group, &[]);
                pass.set_scissor_rect(x, y, width, height);
                pass.draw_indexed(indices, 0, 0..1);
            }
        }
        drop(pass);
        queue.submit([encoder.finish()]);
    }

    /// The triangles of all that is to be seen of `primitives`, with the bytes of their vertices and indices.
    fn runs(
        &self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
    ) -> (Vec<TriangleRun>, Vec<u8>, Vec<u8>) {
        let (mut runs, mut vertices, mut indices) = (Vec::new(), Vec::new(), Vec::new());
        let (mut first_vertex, mut first_index) = (0, 0);
        for ClippedPrimitive { clip_rect, primitive } in primitives {
            let Primitive::Mesh(mesh) = primitive else { continue };
            let Some(scissor) = scissor(*clip_rect, pixels_per_point, self.size) else { continue };
            let after = first_index + mesh.indices.len() as u32;
            runs.push(TriangleRun { scissor, texture: mesh.texture_id, indices: first_index..after });
            vertices.extend_from_slice(bytemuck::cast_slice(&mesh.vertices));
            // Not every browser can add the first vertex of a mesh to its indices.
            indices.extend(mesh.indices.iter().flat_map(|index| (first_vertex + index).to_ne_bytes()));
            first_vertex += mesh.vertices.len() as u32;
            first_index = after;
        }
        (runs, vertices, indices)
    }
}

/// The pixels (x, y, width, height) of `area`, as the toolkit's renderer rounds them; `None` if there are
/// none.
fn scissor(area: Rect, pixels_per_point: f32, size: [u32; 2]) -> Option<[u32; 4]> {
    let bounds = |from: f32, to: f32, side: u32| {
        let pixel = |place: f32| ((place * pixels_per_point).round() as u32).min(side);
        (pixel(from), pixel(to).saturating_sub(pixel(from)))
    };
    let (x, width) = bounds(area.min.x, area.max.x, size[0]);
    let (y, height) = bounds(area.min.y, area.max.y, size[1]);
    (width > 0 && height > 0).then_some([x, y, width, height])
}

impl Buffer {
    /// Writes these `bytes` to the beginning of the buffer, and returns it; `None` if there are none.
    fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, bytes: &[u8]) -> Option<&wgpu::Buffer> {
        let size = bytes.len() as u64;
        self.buffer.take_if(|buffer| buffer.size() < size);
        let buffer = self.buffer.get_or_insert_with(|| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("window"),
                size: size.next_power_of_two(),
                usage: self.usage,
                mapped_at_creation: false,
            })
        });
        queue.write_buffer(buffer, 0, bytes);
        (size > 0).then_some(buffer)
    }
}

impl CallbackTrait for PictureCallback {
    fn paint(&self, info: PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, _: &CallbackResources) {
        let [width, height] = info.screen_size_px;
        pass.set_viewport(0.0, 0.0, width as f32, height as f32, 0.0, 1.0);
        pass.set_scissor_rect(0, 0, width, height);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.kept, &[]);
        pass.draw(0..3, 0..1);
    }
}
