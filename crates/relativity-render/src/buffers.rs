//! Buffers on the device: what a picture's shaders read.

use crate::frame::Frame;
use crate::gpu::Gpu;

/// A buffer for one eye's frame: two eyes must not share one, since both are written before either draws.
pub fn frame_buffer(gpu: &Gpu) -> wgpu::Buffer {
    buffer(gpu, "frame", size_of::<Frame>() as u64, wgpu::BufferUsages::UNIFORM)
}

/// A vertex buffer of `size` bytes.
pub fn vertex_buffer(gpu: &Gpu, size: u64) -> wgpu::Buffer {
    buffer(gpu, "vertices", size, wgpu::BufferUsages::VERTEX)
}

/// Puts `data` into the vertex buffer, which is made anew (and larger) if it is too small.
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
