//! Graphics devices of the windows: most share one, and what is made on it.

use std::sync::{Arc, OnceLock};

use eframe::egui::mutex::RwLock;
use eframe::egui_wgpu::{RenderState, Renderer, RendererOptions, WgpuConfiguration, WgpuError, WgpuSetup};
use egui_kittest::wgpu::{WgpuTestRenderer, default_wgpu_setup};
use gamow::app::tools::graphics;
use relativity_render::instance_flags;

/// Made alone, before the first test, and kept: drivers set up for the process what two devices that begin at
/// once would race for.
static SHARED: OnceLock<RenderState> = OnceLock::new();

/// Makes the device that windows share.
///
/// # Errors
/// There is none.
pub fn share() -> Result<(), WgpuError> {
    let made = own()?;
    SHARED.get_or_init(|| made);
    Ok(())
}

/// Returns a renderer of a window on the shared device. Errors outside any scope, and a loss, are reported to
/// the window that was opened last: a test of them takes a device of its own.
pub fn renderer() -> WgpuTestRenderer {
    let shared = SHARED.get().expect("there is a device");
    let mut renderer = Renderer::new(&shared.device, shared.target_format, RendererOptions::PREDICTABLE);
    renderer.callback_resources.insert(graphics::gpu(shared));
    let renderer = Arc::new(RwLock::new(renderer));
    WgpuTestRenderer::from_render_state(RenderState {
        adapter: shared.adapter.clone(),
        // Left empty: two threads cannot drop OpenGL's adapters of one instance at the same time.
        available_adapters: Vec::new(),
        instance: shared.instance.clone(),
        device: shared.device.clone(),
        queue: shared.queue.clone(),
        target_format: shared.target_format,
        renderer,
    })
}

/// Returns a device of its own for a window without a display, with the instance and the adapters that the
/// toolkit finds.
///
/// # Errors
/// There is none.
pub fn own() -> Result<RenderState, WgpuError> {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.instance_descriptor.flags = instance_flags();
    }
    pollster::block_on(async {
        let instance = setup.new_instance().await;
        let configuration = WgpuConfiguration { wgpu_setup: setup, ..WgpuConfiguration::default() };
        RenderState::create(&configuration, &instance, None, RendererOptions::PREDICTABLE).await
    })
}
