//! Why nothing is drawn on a graphics device.

use thiserror::Error;

/// Why nothing can be drawn on a GPU, in one sentence.
#[derive(Debug, Clone, Error)]
pub enum GpuError {
    /// No adapter at all.
    #[error(
        "no graphics adapter was found (neither Vulkan nor OpenGL); on Debian and Ubuntu the package \
         mesa-vulkan-drivers provides a software one"
    )]
    NoAdapter,
    /// No adapter has the name that is asked for.
    #[error(
        "WGPU_ADAPTER_NAME={asked:?} is no part of the name of a graphics adapter; there {}",
        there(present)
    )]
    NoSuchAdapter {
        /// Text that the name should contain.
        asked: String,
        /// The names of those that there are.
        present: Vec<String>,
    },
    /// An adapter that cannot do what the renderers need.
    #[error("the graphics adapter {adapter} refused a device: {reason}")]
    Device {
        /// Name of the adapter.
        adapter: String,
        /// Reason given by the driver.
        reason: wgpu::RequestDeviceError,
    },
    /// A picture larger than the device can draw.
    #[error(
        "{adapter} draws at most {}x{} of these pixels; the reference renderer has no such limit", size[0], size[1]
    )]
    TooLarge {
        /// Description of the device.
        adapter: String,
        /// The part of the picture that it could draw: width and height, pixels.
        size: [u32; 2],
    },
    /// A view that the renderer in question does not draw.
    #[error(transparent)]
    Undrawn(#[from] Undrawn),
    /// The device has no room for what it was given to draw.
    #[error("the graphics device ran out of memory")]
    OutOfMemory,
    /// The device did not accept what it was given to draw.
    #[error("the graphics device refused to draw: {0}")]
    Refused(String),
    /// The device did not finish what it was given to draw.
    #[error("the graphics device was lost before it had finished drawing")]
    Lost,
    /// A picture's memory was not given to be read.
    #[error("the picture could not be read back from the graphics device: {0}")]
    Mapping(wgpu::BufferAsyncError),
    /// A picture's memory was given, but not all of it.
    #[error("the picture could not be read back from the graphics device: {0}")]
    Range(wgpu::MapRangeError),
}

/// Says which adapters are `present`.
fn there(present: &[String]) -> String {
    match present {
        [] => "is none".to_owned(),
        [one] => format!("is {one:?}"),
        several => format!("are {several:?}"),
    }
}

/// Why a view is not drawn, in one sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Undrawn {
    /// Half of the sky, on a GPU.
    #[error("a picture of 180 by 180 degrees is drawn by the reference renderer, not on the graphics device")]
    HalfOfSkyOnGpu,
    /// Half of the sky in the published model.
    #[error(
        "a picture of 180 by 180 degrees is drawn by the reference renderer, which does not know the published model: \
         that is defined point by point"
    )]
    HalfOfSkyPublished,
}
