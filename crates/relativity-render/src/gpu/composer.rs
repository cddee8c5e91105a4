//! Composes two eyes' pictures on the GPU, in one pass.

use super::canvas::{
    attachment, begin_pass, bind_group, bind_group_layout, pipeline_layout, texture_entry, uniform_entry,
};
use super::device::Gpu;
use super::error::GpuError;
use super::target::{self, ENCODED_FORMAT, EyeTarget};
use crate::picture::compose::{ComposeVariant, Composing, Composition};
use crate::shaders::COMPOSE;

/// A composer of pictures on the GPU.
#[derive(Debug)]
pub struct Composer {
    layout: wgpu::BindGroupLayout,
}

/// A composed picture: sRGB-encoded RGBA8 that can be sampled, copied and read back.
#[derive(Debug)]
pub struct Composed {
    size: [u32; 2],
    picture: wgpu::Texture,
    view: wgpu::TextureView,
    composing: wgpu::Buffer,
}

impl Composed {
    /// Returns a picture of `size` pixels (width, height), at least 1x1 and at most what the device allows.
    #[must_use]
    pub fn new(gpu: &Gpu, size: [u32; 2]) -> Self {
        use wgpu::TextureUsages as Usage;
        let size = size.map(|side| side.clamp(1, gpu.largest_texture()));
        let usage = Usage::RENDER_ATTACHMENT | Usage::TEXTURE_BINDING | Usage::COPY_SRC;
        let picture = target::texture(gpu, "composed", size, 1, ENCODED_FORMAT, usage);
        let composing = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("composing"),
            size: size_of::<Composing>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let view = picture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { size, picture, view, composing }
    }

    /// Width and height, pixels.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the view of the picture, sRGB-encoded.
    #[must_use]
    pub const fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    /// The picture as RGBA bytes, sRGB-encoded, rows from the top.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn rgba8(&self, gpu: &Gpu) -> Result<Vec<u8>, GpuError> {
        target::bytes(gpu, &self.picture, self.size, 4)
    }
}

impl Composer {
    /// Returns a composer on `gpu`.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        let device = &gpu.device;
        let layout = bind_group_layout(device, &[uniform_entry(), texture_entry(1), texture_entry(2)]);
        Self { layout }
    }

    fn pipeline(&self, gpu: &Gpu, form: ComposeVariant) -> wgpu::RenderPipeline {
        let constants = form.constants();
        let compilation_options =
            wgpu::PipelineCompilationOptions { constants: &constants, ..Default::default() };
        let module = &gpu.shader("compose", COMPOSE);
        gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("compose"),
            layout: Some(&pipeline_layout(&gpu.device, &[Some(&self.layout)])),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some("whole"),
                compilation_options: compilation_options.clone(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some("compose"),
                compilation_options,
                targets: &[Some(ENCODED_FORMAT.into())],
            }),
            multiview_mask: None,
            cache: None,
        })
    }

    /// Draws into `target` what is made of the first and the second of `pictures`, which have one size.
    pub fn compose(&self, gpu: &Gpu, composition: Composition, pictures: [&EyeTarget; 2], target: &Composed) {
        let form = composition.form();
        let pipeline = gpu.cache.composers.get(form, || self.pipeline(gpu, form));
        gpu.queue.write_buffer(&target.composing, 0, bytemuck::bytes_of(&composition.composing()));
        let [first, second] = pictures.map(|picture| wgpu::BindingResource::TextureView(picture.view()));
        let resources = [target.composing.as_entire_binding(), first, second];
        let entries: Vec<_> = (0..)
            .zip(resources)
            .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
            .collect();
        let group = bind_group(gpu, &self.layout, &entries);
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let picture = attachment(&target.view, wgpu::StoreOp::Store);
            let mut pass = begin_pass(&mut encoder, "compose", &[Some(picture)], None);
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.draw(0..3, 0..1);
        }
        gpu.queue.submit([encoder.finish()]);
    }
}
