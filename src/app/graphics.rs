//! Which graphics device the window asks for: Vulkan, Metal or Direct3D, else OpenGL, with what it has.

use std::sync::Arc;

use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use eframe::wgpu;

/// The configuration of the window's device, and of a screenshot's. `WGPU_BACKEND` chooses a backend.
#[must_use]
pub fn configuration() -> WgpuConfiguration {
    let mut setup = WgpuSetupCreateNew::without_display_handle();
    setup.device_descriptor = Arc::new(|adapter| wgpu::DeviceDescriptor {
        label: Some("gamow"),
        // No more than the adapter has: a fixed demand would rule out older OpenGL.
        required_limits: adapter.limits(),
        ..Default::default()
    });
    WgpuConfiguration { wgpu_setup: WgpuSetup::CreateNew(setup), ..WgpuConfiguration::default() }
}
