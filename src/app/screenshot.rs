//! Draws the window once, without a display, and saves it.

use std::path::Path;
use std::time::Duration;

use anyhow::Context as _;
use eframe::egui::{Context, FullOutput, Pos2, RawInput, Rect, vec2};
use eframe::egui_wgpu::{RenderState, RendererOptions, ScreenDescriptor};
use eframe::wgpu;
use relativity_render::{EyeTarget, Gpu, Picture};

use super::state::State;
use super::{App, graphics};
use crate::files::png;
use crate::files::whole::write_whole;
use crate::platform::threads;

/// Frames until the layout has settled: the size of a scroll area is known from the frame before.
const FRAMES: usize = 3;
/// How often it is asked whether the work in the background is done.
const WAIT: Duration = Duration::from_millis(5);

/// Saves the window's content in `state`, `size` points of one pixel each, as a PNG file with `texts` that tell
/// how it was made, keywords first. The file is written whole or not at all.
///
/// # Errors
/// No graphics adapter, or the file system's.
pub fn save(state: State, size: [u32; 2], texts: &[(&str, &str)], path: &Path) -> anyhow::Result<()> {
    let picture = picture(state, size)?;
    write_whole(path, |file| png::write(&picture, texts, file))
}

fn picture(state: State, size: [u32; 2]) -> anyhow::Result<Picture> {
    let render_state = render_state().context("the window cannot be drawn")?;
    let ctx = Context::default();
    let mut app = App::new(&ctx, Some(&render_state), state).without_refinement();
    let painter = Painter::new(&render_state, size);
    let scopes = painter.gpu.error_scopes();
    let mut settled = 0;
    for frame in 1.. {
        let mut output = ctx.run_ui(input(size, frame), |ui| app.show(ui));
        painter.load(&mut output);
        if app.is_settled() {
            settled += 1;
        } else {
            settled = 0;
            threads::sleep(WAIT);
        }
        if settled == FRAMES {
            painter.paint(&ctx, output);
            break;
        }
    }
    let bytes = painter.target.rgba8(&painter.gpu);
    scopes.close()?;
    let rgba = bytes?.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect();
    Ok(Picture { size, rgba })
}

fn render_state() -> anyhow::Result<RenderState> {
    let config = graphics::configuration();
    pollster::block_on(async {
        let instance = config.wgpu_setup.new_instance().await;
        Ok(RenderState::create(&config, &instance, None, RendererOptions::PREDICTABLE).await?)
    })
}

fn input([width, height]: [u32; 2], frame: usize) -> RawInput {
    RawInput {
        screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(width as f32, height as f32))),
        // Far enough apart that animations are over.
        time: Some(frame as f64),
        ..RawInput::default()
    }
}

/// egui's renderer, with a picture to paint on.
struct Painter<'a> {
    render_state: &'a RenderState,
    gpu: Gpu,
    target: EyeTarget,
}

impl<'a> Painter<'a> {
    fn new(render_state: &'a RenderState, size: [u32; 2]) -> Self {
        let RenderState { adapter, device, queue, .. } = render_state;
        let gpu = Gpu::from_device(adapter, device.clone(), queue.clone());
        let target = EyeTarget::new(&gpu, size);
        Self { render_state, gpu, target }
    }

    /// Loads the fonts and images that are new in `output`.
    fn load(&self, output: &mut FullOutput) {
        let RenderState { device, queue, renderer, .. } = self.render_state;
        for (id, deltas) in &output.textures_delta.set {
            for delta in deltas {
                renderer.write().update_texture(device, queue, *id, delta);
            }
        }
        output.textures_delta.clear();
    }

    fn paint(&self, ctx: &Context, output: FullOutput) {
        let RenderState { device, queue, renderer, .. } = self.render_state;
        let screen = ScreenDescriptor {
            size_in_pixels: self.target.size(),
            pixels_per_point: output.pixels_per_point,
        };
        let shapes = ctx.tessellate(output.shapes, output.pixels_per_point);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let callbacks = renderer.write().update_buffers(device, queue, &mut encoder, &shapes, &screen);
        {
            let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("screenshot"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: self.target.view(),
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                        store: wgpu::StoreOp::Store,
                    },
                    depth_slice: None,
                })],
                ..Default::default()
            });
            renderer.read().render(&mut pass.forget_lifetime(), &shapes, &screen);
        }
        queue.submit(callbacks.into_iter().chain([encoder.finish()]));
    }
}
