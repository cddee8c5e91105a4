//! The pipelines that paint triangles, and that show the kept picture.

use eframe::egui::epaint::Vertex;
use eframe::wgpu;

/// The two pipelines, and what they take.
pub struct PaintPipelines {
    /// Paints the toolkit's triangles.
    pub triangles: wgpu::RenderPipeline,
    /// Shows what is kept.
    pub shown: wgpu::RenderPipeline,
    /// Layout of the bindings of `triangles`, for a window.
    pub of_window: wgpu::BindGroupLayout,
    /// Layout of the bindings of `shown`.
    pub of_kept: wgpu::BindGroupLayout,
}

impl PaintPipelines {
    /// For windows whose pixels have this format.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let module = device.create_shader_module(wgpu::include_wgsl!("window.wgsl"));
        let of_window = bindings(device, &[uniform(0, wgpu::ShaderStages::VERTEX, 16)]);
        // As the toolkit's renderer has it: its pictures are taken from there.
        let of_image =
            bindings(device, &[texture(0), sampler(1), uniform(2, wgpu::ShaderStages::FRAGMENT, 16)]);
        let of_kept = bindings(device, &[texture(1)]);
        let vertices = wgpu::VertexBufferLayout {
            array_stride: size_of::<Vertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32x2, 2 => Unorm8x4],
        };
        let triangles = PlannedPipeline {
            name: "triangles",
            layouts: &[Some(&of_window), Some(&of_image)],
            entries: ["vertex", "fragment"],
            buffers: &[Some(vertices)],
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        };
        let shown = PlannedPipeline {
            name: "shown",
            layouts: &[Some(&of_kept)],
            entries: ["whole", "show"],
            buffers: &[],
            blend: None,
        };
        Self {
            triangles: triangles.pipeline(device, &module, format),
            shown: shown.pipeline(device, &module, format),
            of_window,
            of_kept,
        }
    }
}

/// A pipeline of the window, before a device has made it.
struct PlannedPipeline<'a> {
    name: &'a str,
    layouts: &'a [Option<&'a wgpu::BindGroupLayout>],
    /// Entry points of the vertices and of the fragments.
    entries: [&'a str; 2],
    buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    blend: Option<wgpu::BlendState>,
}

impl PlannedPipeline<'_> {
    /// Returns its pipeline, for windows whose pixels have this format.
    fn pipeline(
        &self,
        device: &wgpu::Device,
        module: &wgpu::ShaderModule,
        format: wgpu::TextureFormat,
    ) -> wgpu::RenderPipeline {
        let [vertex, fragment] = self.entries;
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.name),
            bind_group_layouts: self.layouts,
            immediate_size: 0,
        });
        let target = wgpu::ColorTargetState { format, blend: self.blend, write_mask: wgpu::ColorWrites::ALL };
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.name),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some(vertex),
                buffers: self.buffers,
                compilation_options: wgpu::PipelineCompilationOptions::default(),
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some(fragment),
                targets: &[Some(target)],
                compilation_options: wgpu::PipelineCompilationOptions::default(),
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

fn bindings(device: &wgpu::Device, entries: &[wgpu::BindGroupLayoutEntry]) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("window"), entries })
}

fn sampler(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        count: None,
    }
}

fn uniform(binding: u32, visibility: wgpu::ShaderStages, size: u64) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: std::num::NonZeroU64::new(size),
        },
        count: None,
    }
}

fn texture(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}
