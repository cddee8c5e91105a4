//! The graphics device, made once and shared by everything that draws.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::answers::PendingReadbacks;
use super::device_cache::DeviceCache;
use super::device_errors::ErrorScopes;
use super::error::GpuError;
use super::sampling::Sampling;
use crate::shaders::Source;

/// Returns the part of an adapter's name that the environment asks for, in lower case; `None` if it asks for
/// none.
#[must_use]
#[expect(clippy::disallowed_methods, reason = "wgpu has this variable and reads its others by itself")]
pub fn adapter_name() -> Option<String> {
    std::env::var("WGPU_ADAPTER_NAME").ok().map(|name| name.to_lowercase()).filter(|name| !name.is_empty())
}

/// Returns the flags of an instance: those of the build, then those of the environment. Debug names and line
/// numbers of shaders, which take a tenth of the time in which pipelines are made, are off unless
/// `WGPU_DEBUG` turns them on.
#[must_use]
pub fn instance_flags() -> wgpu::InstanceFlags {
    wgpu::InstanceFlags::from_build_config().difference(wgpu::InstanceFlags::DEBUG).with_env()
}

/// The first of `adapters` whose name contains `name`, which is in lower case, and which can show what is on
/// `surface`, if there is one.
///
/// # Errors
///
/// There is none.
pub fn named_adapter(
    name: &str,
    adapters: &[wgpu::Adapter],
    surface: Option<&wgpu::Surface<'_>>,
) -> Result<wgpu::Adapter, GpuError> {
    let shows =
        |adapter: &&wgpu::Adapter| surface.is_none_or(|surface| adapter.is_surface_supported(surface));
    let present = adapters.iter().filter(shows);
    let chosen = present.clone().find(|adapter| adapter.get_info().name.to_lowercase().contains(name));
    chosen.cloned().ok_or_else(|| {
        // One is there once for each library that reaches it.
        let names: BTreeSet<String> = present.map(|adapter| adapter.get_info().name).collect();
        GpuError::NoSuchAdapter { asked: name.to_owned(), present: names.into_iter().collect() }
    })
}

/// A graphics device and its queue; clones share what is made on it.
#[derive(Debug, Clone)]
pub struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
    answers: PendingReadbacks,
    pub(crate) cache: Arc<DeviceCache>,
}

impl Gpu {
    /// A device without a window. `WGPU_BACKEND` and `WGPU_ADAPTER_NAME` choose among several.
    ///
    /// # Errors
    ///
    /// No adapter, or one that gives no device.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn headless() -> Result<Self, GpuError> {
        pollster::block_on(Self::headless_device())
    }

    /// A device without a window: in a browser there is none, as nothing can wait for it.
    ///
    /// # Errors
    ///
    /// Always.
    #[cfg(target_arch = "wasm32")]
    pub const fn headless() -> Result<Self, GpuError> {
        Err(GpuError::NoAdapter)
    }

    #[cfg(not(target_arch = "wasm32"))]
    async fn headless_device() -> Result<Self, GpuError> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            flags: instance_flags(),
            ..wgpu::InstanceDescriptor::new_without_display_handle_from_env()
        });
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = match adapter_name() {
            None => instance.request_adapter(&options).await.map_err(|_| GpuError::NoAdapter)?,
            Some(name) => {
                let backends = wgpu::Backends::from_env().unwrap_or(wgpu::Backends::all());
                named_adapter(&name, &instance.enumerate_adapters(backends).await, None)?
            }
        };
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                label: Some("gamow"),
                required_limits: adapter.limits(),
                ..Default::default()
            })
            .await
            .map_err(|reason| GpuError::Device { adapter: adapter.get_info().name, reason })?;
        Ok(Self::from_device(&adapter, device, queue))
    }

    /// Shares the device of a window.
    #[must_use]
    pub fn from_device(adapter: &wgpu::Adapter, device: wgpu::Device, queue: wgpu::Queue) -> Self {
        let (info, answers, cache) = (adapter.get_info(), PendingReadbacks::default(), Arc::default());
        Self { device, queue, info, answers, cache }
    }

    /// Largest width and height of a picture, pixels.
    #[must_use]
    pub fn largest_side(&self) -> u32 {
        self.largest_texture() / self.sampling().across
    }

    /// Largest width and height of a texture, texels.
    pub(crate) fn largest_texture(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }

    /// Returns a description of the device, e.g. "llvmpipe (Vulkan)".
    #[must_use]
    pub fn description(&self) -> String {
        format!("{} ({:?})", self.info.name, self.info.backend)
    }

    /// Returns whether the device is software: then the CPU does all the drawing.
    #[must_use]
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// Returns whether what was drawn can be read back at once; in a browser nothing can be waited for.
    #[must_use]
    pub const fn reads_back(&self) -> bool {
        cfg!(not(target_arch = "wasm32"))
    }

    /// Opens scopes that catch the device's errors in this thread's calls. Errors outside any scope go to
    /// [`DeviceErrors`](crate::DeviceErrors), or end the program.
    #[must_use]
    pub fn error_scopes(&self) -> ErrorScopes {
        ErrorScopes::open(&self.device, self.answers.clone())
    }

    /// Calls `then` when everything drawn so far is finished: before the next [`Self::wait`] returns, or in a
    /// browser later.
    pub fn when_finished(&self, then: impl FnOnce() + Send + 'static) {
        self.queue.on_submitted_work_done(then);
    }

    /// Waits until everything drawn so far is finished; for timing. In a browser nothing can be waited for.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn wait(&self) -> Result<(), GpuError> {
        let how = if self.reads_back() { wgpu::PollType::wait_indefinitely() } else { wgpu::PollType::Poll };
        // Nothing else can go wrong without a limit on the time.
        self.device.poll(how).map(|_| ()).map_err(|_| GpuError::Lost)
    }

    /// Returns how the samples of a picture are drawn: by OpenGL, shaders of wgpu cannot choose those they
    /// cover.
    pub(crate) fn sampling(&self) -> Sampling {
        if self.info.backend == wgpu::Backend::Gl { Sampling::AS_PIXELS } else { Sampling::CHOSEN }
    }

    pub(crate) fn shader(&self, label: &str, source: Source) -> wgpu::ShaderModule {
        self.cache.shaders.get(source, || {
            self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source: wgpu::ShaderSource::Wgsl(source.concat().into()),
            })
        })
    }
}
