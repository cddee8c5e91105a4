//! The graphics device, made once and shared by everything that draws.

use thiserror::Error;

/// Why nothing can be drawn on a GPU, in one sentence.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum GpuError {
    /// No adapter at all.
    #[error(
        "no graphics adapter was found (neither Vulkan nor OpenGL); on Debian and Ubuntu the package \
         mesa-vulkan-drivers provides a software one"
    )]
    NoAdapter,
    /// An adapter that cannot do what the renderers need.
    #[error("the graphics adapter {adapter} refused a device: {reason}")]
    Device {
        /// Name of the adapter.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// A picture could not be read back.
    #[error("the picture could not be read back from the graphics device: {0}")]
    Readback(String),
}

/// A graphics device and its queue.
#[derive(Debug, Clone)]
pub struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
}

impl Gpu {
    /// A device without a window. `WGPU_BACKEND` and `WGPU_ADAPTER_NAME` choose among several.
    ///
    /// # Errors
    ///
    /// No adapter, or one that gives no device.
    pub fn headless() -> Result<Self, GpuError> {
        pollster::block_on(Self::headless_device())
    }

    async fn headless_device() -> Result<Self, GpuError> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = match wgpu::util::initialize_adapter_from_env(&instance, None).await {
            Err(_) => instance.request_adapter(&options).await.map_err(|_| GpuError::NoAdapter)?,
            Ok(chosen) => chosen,
        };
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                label: Some("gamow"),
                required_limits: adapter.limits(),
                ..Default::default()
            })
            .await
            .map_err(|error| GpuError::Device {
                adapter: adapter.get_info().name,
                reason: error.to_string(),
            })?;
        Ok(Self::from_device(&adapter, device, queue))
    }

    /// Shares the device of a window.
    #[must_use]
    pub fn from_device(adapter: &wgpu::Adapter, device: wgpu::Device, queue: wgpu::Queue) -> Self {
        Self { device, queue, info: adapter.get_info() }
    }

    /// What the device is, e.g. "llvmpipe (Vulkan)".
    #[must_use]
    pub fn description(&self) -> String {
        format!("{} ({:?})", self.info.name, self.info.backend)
    }

    /// Whether the device is a program that runs on the CPU.
    #[must_use]
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// Waits until everything drawn so far is finished; for timing.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn wait(&self) -> Result<(), GpuError> {
        let polled = self.device.poll(wgpu::PollType::wait_indefinitely());
        polled.map(|_| ()).map_err(|error| GpuError::Readback(error.to_string()))
    }

    /// Whether shaders can choose the samples they cover.
    pub(crate) fn has_sample_masks(&self) -> bool {
        self.info.backend != wgpu::Backend::Gl
    }

    pub(crate) fn shader(&self, label: &str, source: &'static str) -> wgpu::ShaderModule {
        self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(label),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        })
    }
}
