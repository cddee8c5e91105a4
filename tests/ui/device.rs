//! Graphics devices of the windows: each has one of its own, on an instance of its own, since OpenGL's adapters of one instance cannot be
//! let go by two threads at once.

use eframe::egui_wgpu::{RenderState, RendererOptions, WgpuConfiguration, WgpuError};
use egui_kittest::wgpu::default_wgpu_setup;

/// Returns a device for a window without a display, with the instance and the adapters that the toolkit finds.
///
/// # Errors
/// There is none.
pub fn own() -> Result<RenderState, WgpuError> {
    let setup = default_wgpu_setup();
    pollster::block_on(async {
        let instance = setup.new_instance().await;
        let configuration = WgpuConfiguration { wgpu_setup: setup, ..WgpuConfiguration::default() };
        RenderState::create(&configuration, &instance, None, RendererOptions::PREDICTABLE).await
    })
}
