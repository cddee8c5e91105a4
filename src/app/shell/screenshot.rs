//! Draws the window once, without a display, and saves it.

use std::path::Path;
use std::time::Duration;

use anyhow::Context as _;
use eframe::egui::{Context, Pos2, RawInput, Rect, vec2};
use eframe::egui_wgpu::{RenderState, RendererOptions};
use gamow_platform::threads;
use relativity_render::{EyeTarget, Picture};

use crate::app::shell::App;
use crate::app::state::State;
use crate::app::tools::graphics;
use crate::app::views::offscreen;
use crate::files::png;
use crate::files::whole::write_whole;

/// Frames until the layout has settled: the size of a scroll area is known from the frame before.
const FRAMES: usize = 3;
/// Interval in which the background work is checked.
const WAIT: Duration = Duration::from_millis(5);

/// Saves the window's content in `state`, `size` points of one pixel each, as a PNG file with `texts` on how
/// it was made, keywords first. The file is written whole or not at all.
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
    let gpu = graphics::gpu(&render_state);
    let target = EyeTarget::new(&gpu, size);
    let scopes = gpu.error_scopes();
    let mut settled = 0;
    for frame in 1.. {
        let mut output = ctx.run_ui(input(size, frame), |ui| app.show(ui));
        offscreen::load(&render_state, &mut output);
        if app.is_settled() {
            settled += 1;
        } else {
            settled = 0;
            threads::sleep(WAIT);
        }
        if settled == FRAMES {
            offscreen::paint(&render_state, &ctx, output, target.view(), target.size());
            break;
        }
    }
    let bytes = target.rgba8(&gpu);
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
        // Far enough apart that animations are over, and notes have faded.
        time: Some(5.0 * frame as f64),
        ..RawInput::default()
    }
}
