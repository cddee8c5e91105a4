//! Buffers on the device: what a picture's shaders read.

use super::device::Gpu;
use crate::frame::uniform::FrameUniform;

/// A buffer for this many groups' frames of one eye: two eyes must not share one, since both are written
/// before either draws.
pub fn frame_buffer(gpu: &Gpu, count: usize) -> wgpu::Buffer {
    buffer(gpu, "frames", frame_stride(gpu) * count as u64, wgpu::BufferUsages::UNIFORM)
}

/// Writes `frames` into the buffer, and replaces the buffer if it is too small.
pub fn fill_frame_buffer(gpu: &Gpu, buffer: &mut wgpu::Buffer, frames: &[FrameUniform]) {
    let stride = frame_stride(gpu);
    if stride * frames.len() as u64 > buffer.size() {
        *buffer = frame_buffer(gpu, frames.len());
    }
    for (number, frame) in (0..).zip(frames) {
        gpu.queue.write_buffer(buffer, number * stride, bytemuck::bytes_of(frame));
    }
}

/// The frames in a buffer: one binding each.
pub fn frame_bindings<'a>(
    gpu: &Gpu,
    buffer: &'a wgpu::Buffer,
    count: usize,
) -> impl Iterator<Item = wgpu::BufferBinding<'a>> + use<'a> {
    let stride = frame_stride(gpu);
    let size = std::num::NonZeroU64::new(size_of::<FrameUniform>() as u64);
    (0..count as u64).map(move |number| wgpu::BufferBinding { buffer, offset: number * stride, size })
}

/// From one frame to the next, bytes.
fn frame_stride(gpu: &Gpu) -> u64 {
    let alignment = gpu.device.limits().min_uniform_buffer_offset_alignment;
    (size_of::<FrameUniform>() as u64).next_multiple_of(alignment.into())
}

/// A vertex buffer of `size` bytes.
pub fn vertex_buffer(gpu: &Gpu, size: u64) -> wgpu::Buffer {
    buffer(gpu, "vertices", size, wgpu::BufferUsages::VERTEX)
}

/// Writes `data` into the vertex buffer, and replaces the buffer by a larger one if it is too small.
pub fn fill_vertex_buffer<T: bytemuck::NoUninit>(gpu: &Gpu, buffer: &mut wgpu::Buffer, data: &[T]) {
    let bytes = bytemuck::cast_slice(data);
    if bytes.len() as u64 > buffer.size() {
        *buffer = vertex_buffer(gpu, bytes.len().next_power_of_two() as u64);
    }
    gpu.queue.write_buffer(buffer, 0, bytes);
}

/// A buffer that holds `data` for good.
pub fn filled<T: bytemuck::NoUninit>(
    gpu: &Gpu,
    label: &str,
    usage: wgpu::BufferUsages,
    data: &[T],
) -> wgpu::Buffer {
    let bytes = bytemuck::cast_slice(data);
    let buffer = buffer(gpu, label, bytes.len() as u64, usage);
    gpu.queue.write_buffer(&buffer, 0, bytes);
    buffer
}

fn buffer(gpu: &Gpu, label: &str, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
