//! The graphics device of the windows: one for all tests but those that break theirs, or count what is on it.

use std::sync::{Mutex, PoisonError};

use eframe::egui_wgpu::{
    RenderState, RendererOptions, WgpuConfiguration, WgpuError, WgpuSetup, WgpuSetupExisting,
};
use egui_kittest::wgpu::{WgpuTestRenderer, default_wgpu_setup};
use relativity_render::Gpu;

/// The device that tests share, from before the first of them until after the last.
static SHARED: Mutex<Option<WgpuSetupExisting>> = Mutex::new(None);

/// A device of a test's own.
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

/// Runs the tests with a shared device, which is there before they begin and has ended when they have: drivers set up for the
/// process what two devices that begin at once would race for. Tells them whether there is one.
pub fn shared_by<T>(tests: impl FnOnce(bool) -> T) -> T {
    let set = |setup| *SHARED.lock().unwrap_or_else(PoisonError::into_inner) = setup;
    let made = own().ok().map(|RenderState { instance, adapter, device, queue, .. }| WgpuSetupExisting {
        instance,
        adapter,
        device,
        queue,
    });
    let is_there = made.is_some();
    set(made);
    let outcome = tests(is_there);
    set(None);
    outcome
}

fn shared() -> WgpuSetupExisting {
    SHARED.lock().unwrap_or_else(PoisonError::into_inner).clone().expect("a graphics adapter")
}

/// A renderer of a window on the shared device.
pub fn renderer() -> WgpuTestRenderer {
    WgpuTestRenderer::from_setup(WgpuSetup::Existing(shared()))
}

/// The shared device, for renderers without a window.
pub fn gpu() -> Gpu {
    let WgpuSetupExisting { adapter, device, queue, .. } = shared();
    Gpu::from_device(&adapter, device, queue)
}
