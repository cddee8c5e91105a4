//! The graphics device of the window: Vulkan, Metal or Direct3D, else OpenGL, with the features it has.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use eframe::egui_wgpu::{
    NativeAdapterSelectorMethod, RenderState, SurfaceErrorAction, WgpuConfiguration, WgpuSetup,
    WgpuSetupCreateNew,
};
use eframe::wgpu::{self, CurrentSurfaceTexture};
use gamow_platform::clock::Instant;
use relativity_render::{Gpu, adapter_name, instance_flags, named_adapter};

/// Least time between two configurations of a surface that cannot be drawn on.
const BETWEEN_ATTEMPTS: Duration = Duration::from_millis(250);

/// The configuration of the window's device, and of a screenshot's. `WGPU_BACKEND` chooses a backend,
/// `WGPU_ADAPTER_NAME` an adapter.
#[must_use]
pub fn configuration() -> WgpuConfiguration {
    let mut setup = WgpuSetupCreateNew::without_display_handle();
    setup.instance_descriptor.flags = instance_flags();
    setup.native_adapter_selector = adapter_name().map(|name| -> NativeAdapterSelectorMethod {
        Arc::new(move |adapters, surface| {
            named_adapter(&name, adapters, surface).map_err(|error| error.to_string())
        })
    });
    setup.device_descriptor = Arc::new(|adapter| wgpu::DeviceDescriptor {
        label: Some("gamow"),
        // No more than the adapter has: a fixed demand would rule out older OpenGL.
        required_limits: adapter.limits(),
        // Windows of many sizes in turn would keep large blocks of memory alive, each for a few textures.
        memory_hints: wgpu::MemoryHints::MemoryUsage,
        ..Default::default()
    });
    let default = WgpuConfiguration::default().on_surface_status;
    let last = Mutex::new(None);
    WgpuConfiguration {
        wgpu_setup: WgpuSetup::CreateNew(setup),
        on_surface_status: Arc::new(move |status| match status {
            CurrentSurfaceTexture::Validation => {
                let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
                let is_due = is_due(last.as_ref().map(Instant::elapsed));
                if is_due {
                    *last = Some(Instant::now());
                    SurfaceErrorAction::Reconfigure
                } else {
                    SurfaceErrorAction::SkipFrame
                }
            }
            other => default(other),
        }),
        ..WgpuConfiguration::default()
    }
}

/// Returns the device of a window, the same for all who ask: what one of them has made on it serves the
/// others.
#[must_use]
pub fn gpu(render_state: &RenderState) -> Gpu {
    let RenderState { adapter, device, queue, renderer, .. } = render_state;
    let kept = &mut renderer.write().callback_resources;
    kept.entry::<Gpu>().or_insert_with(|| Gpu::from_device(adapter, device.clone(), queue.clone())).clone()
}

/// Whether a surface that was refused is configured again, so long `since` that was tried: its size was that
/// of a window that has another by now, or is larger than the device can draw.
fn is_due(since: Option<Duration>) -> bool {
    since.is_none_or(|since| since >= BETWEEN_ATTEMPTS)
}
