//! Render targets: an off-screen texture per eye, and its readback.

use std::sync::OnceLock;

use super::buffers::{frame_buffer, vertex_buffer};
use super::device::Gpu;
use super::error::GpuError;
use super::sampling::Sampling;
use crate::picture::pixels::Picture;

pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Written as linear light; the hardware encodes, and blends and averages in linear light.
pub(crate) const LINEAR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
pub(crate) const ENCODED_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Bits of floats: 32-bit floats cannot be drawn to everywhere.
pub(crate) const MEASURES_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;

/// Returns the colour target of bodies; those thinner than a pixel are blended by the share of it that they
/// cover.
pub(crate) fn linear_target(is_thin: bool) -> wgpu::ColorTargetState {
    wgpu::ColorTargetState {
        format: LINEAR_FORMAT,
        blend: is_thin.then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        write_mask: wgpu::ColorWrites::ALL,
    }
}

/// The target of one eye's picture: sRGB-encoded RGBA8 that can be sampled, copied and read back.
#[derive(Debug)]
pub struct EyeTarget {
    size: [u32; 2],
    picture: wgpu::Texture,
    view: wgpu::TextureView,
    layers: OnceLock<BodyLayers>,
    pub(crate) frames: wgpu::Buffer,
    pub(crate) vertices: wgpu::Buffer,
}

/// The layers that a device draws the bodies on: nine times the memory of the picture. One that was
/// made elsewhere needs none.
#[derive(Debug)]
pub(crate) struct BodyLayers {
    /// The bodies alone, premultiplied by coverage, in linear light.
    pub bodies: wgpu::TextureView,
    /// The samples of the bodies' pixels, where the hardware averages these.
    pub samples: Option<wgpu::TextureView>,
    pub depth: wgpu::TextureView,
}

impl BodyLayers {
    fn new(gpu: &Gpu, size: [u32; 2]) -> Self {
        use wgpu::TextureUsages as Usage;
        let Sampling { of_hardware, across } = gpu.sampling();
        let size = size.map(|side| side * across);
        let layer = |label, samples, format, usage| {
            let texture = texture(gpu, label, size, samples, format, Usage::RENDER_ATTACHMENT | usage);
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        Self {
            bodies: layer("bodies", 1, LINEAR_FORMAT, Usage::TEXTURE_BINDING),
            samples: (of_hardware > 1).then(|| layer("samples", of_hardware, LINEAR_FORMAT, Usage::empty())),
            depth: layer("depth", of_hardware, DEPTH_FORMAT, Usage::empty()),
        }
    }
}

impl EyeTarget {
    /// A picture of `size` pixels (width, height), at least 1x1 and at most what the device allows.
    #[must_use]
    pub fn new(gpu: &Gpu, size: [u32; 2]) -> Self {
        use wgpu::TextureUsages as Usage;
        let limit = gpu.largest_side();
        let size = size.map(|v| v.clamp(1, limit));
        let exchanged = Usage::TEXTURE_BINDING | Usage::COPY_SRC | Usage::COPY_DST;
        let usage = Usage::RENDER_ATTACHMENT | exchanged;
        let picture = texture(gpu, "picture", size, 1, ENCODED_FORMAT, usage);
        Self {
            size,
            view: picture.create_view(&wgpu::TextureViewDescriptor::default()),
            picture,
            layers: OnceLock::new(),
            frames: frame_buffer(gpu, 1),
            vertices: vertex_buffer(gpu, 0),
        }
    }

    /// Width and height, pixels.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the view of the picture, sRGB-encoded.
    #[must_use]
    pub fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    /// Returns the layers that bodies are drawn on, which the first call makes.
    pub(crate) fn layers(&self, gpu: &Gpu) -> &BodyLayers {
        self.layers.get_or_init(|| BodyLayers::new(gpu, self.size))
    }

    /// Shows `picture`, which was made elsewhere and has its size.
    pub fn write(&mut self, gpu: &Gpu, picture: &Picture) {
        self.layers.take();
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(4 * self.size[0]),
            rows_per_image: None,
        };
        let (bytes, size) = (picture.rgba.as_flattened(), self.picture.size());
        gpu.queue.write_texture(self.picture.as_image_copy(), bytes, layout, size);
    }

    /// The picture as RGBA bytes, sRGB-encoded, rows from the top.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn rgba8(&self, gpu: &Gpu) -> Result<Vec<u8>, GpuError> {
        bytes(gpu, &self.picture, self.size, 4)
    }
}

pub(crate) fn texture(
    gpu: &Gpu,
    label: &str,
    [width, height]: [u32; 2],
    sample_count: u32,
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

/// The texture's bytes, without the padding of rows.
pub(crate) fn bytes(
    gpu: &Gpu,
    texture: &wgpu::Texture,
    [width, height]: [u32; 2],
    bytes_per_pixel: u32,
) -> Result<Vec<u8>, GpuError> {
    let row = width * bytes_per_pixel;
    let padded_row = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("readback"),
        size: u64::from(padded_row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(padded_row),
                rows_per_image: None,
            },
        },
        texture.size(),
    );
    gpu.queue.submit([encoder.finish()]);
    let (sender, receiver) = std::sync::mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        // The receiver waits below; if it is gone, nobody wants the answer.
        let _ = sender.send(result);
    });
    gpu.wait()?;
    receiver.recv().map_err(|_| GpuError::Lost)?.map_err(GpuError::Mapping)?;
    let mapped = buffer.get_mapped_range(..).map_err(GpuError::Range)?;
    Ok(mapped.chunks(padded_row as usize).flat_map(|padded| &padded[..row as usize]).copied().collect())
}
