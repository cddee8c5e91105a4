//! Paints the window on a texture instead of a display, as the toolkit does on one: for a screenshot, and to
//! be timed.

use eframe::egui::{Context, FullOutput};
use eframe::egui_wgpu::{RenderState, ScreenDescriptor};
use eframe::wgpu;

/// Loads the fonts and images that are new in `output`, which is rid of them.
pub fn load(render_state: &RenderState, output: &mut FullOutput) {
    let RenderState { device, queue, renderer, .. } = render_state;
    for (id, deltas) in &output.textures_delta.set {
        for delta in deltas {
            renderer.write().update_texture(device, queue, *id, delta);
        }
    }
    output.textures_delta.clear();
}

/// Paints `output` of `ctx`, whose fonts and images are loaded, on all of a `target` of this `size` (pixels).
pub fn paint(
    render_state: &RenderState,
    ctx: &Context,
    output: FullOutput,
    target: &wgpu::TextureView,
    size: [u32; 2],
) {
    let RenderState { device, queue, renderer, .. } = render_state;
    let screen = ScreenDescriptor { size_in_pixels: size, pixels_per_point: output.pixels_per_point };
    let triangles = ctx.tessellate(output.shapes, output.pixels_per_point);
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let callbacks = renderer.write().update_buffers(device, queue, &mut encoder, &triangles, &screen);
    let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("window on a texture"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: target,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                store: wgpu::StoreOp::Store,
            },
            depth_slice: None,
        })],
        ..Default::default()
    });
    renderer.read().render(&mut pass.forget_lifetime(), &triangles, &screen);
    queue.submit(callbacks.into_iter().chain([encoder.finish()]));
}
