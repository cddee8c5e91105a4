//! WebGPU, and WebGL 2 in its place: where WebGPU gives no device, loses it or shows nothing, the page is
//! loaded again and drawn by WebGL 2, for as long as its tab is open.

use std::cell::Cell;
use std::rc::Rc;

use eframe::CreationContext;
use eframe::egui::Context;
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup};
use eframe::wgpu::{Backend, Backends};
use gamow_platform::web::{page, tasks};

use crate::app::state::notice::Notice;
use crate::app::tools::graphics;

/// Frames in which a first picture may be late.
const LATE_FRAMES: u32 = 20;

/// The configuration of the page's device: without WebGPU where that has failed in this tab.
pub fn configuration() -> WgpuConfiguration {
    let mut configuration = graphics::configuration();
    if let (Some(_), WgpuSetup::CreateNew(setup)) = (page::webgpu_failure(), &mut configuration.wgpu_setup) {
        setup.instance_descriptor.backends = Backends::GL;
    }
    configuration
}

/// Returns the message that WebGPU has failed in this tab, if it has.
pub fn failure() -> Option<Notice> {
    let reason = page::webgpu_failure()?;
    Some(Notice::error(format!(
        "WebGPU has failed ({reason}). WebGL 2 draws the window until this tab is closed."
    )))
}

/// Whether the window is drawn by WebGPU.
pub fn is_used(cc: &CreationContext<'_>) -> bool {
    cc.wgpu_render_state
        .as_ref()
        .is_some_and(|state| state.adapter.get_info().backend == Backend::BrowserWebGpu)
}

/// The wait for the window's first picture, until which the page keeps its words.
#[derive(Default)]
pub struct FirstPicture {
    has_come: Rc<Cell<bool>>,
    frames: u32,
}

impl FirstPicture {
    /// Looks at the canvas once this frame is painted. Returns whether the picture is later than any should
    /// be.
    pub fn look(&mut self, ctx: &Context) -> bool {
        if self.has_come.get() {
            return false;
        }
        self.frames += 1;
        let has_come = Rc::clone(&self.has_come);
        tasks::spawn(async move {
            if page::has_picture() && !has_come.replace(true) {
                page::show_window();
            }
        });
        ctx.request_repaint();
        self.frames == LATE_FRAMES
    }
}
