//! The pipelines that paint triangles, and that show the kept picture.

use eframe::egui::epaint::Vertex;
use eframe::wgpu;

/// The two pipelines, and what they take.
pub struct Pipelines {
    /// Paints the toolkit's triangles.
    pub triangles: wgpu::RenderPipeline,
    /// Shows what is kept.
    pub shown: wgpu::RenderPipeline,
    /// Layout of the bindings of `triangles`, for a window.
    pub of_window: wgpu::BindGroupLayout,
    /// Layout of the bindings of `shown`.
    pub of_kept: wgpu::BindGroupLayout,
}

impl Pipelines {
    /// For windows whose pixels have this format.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let module = device.create_shader_module(wgpu::include_wgsl!("window.wgsl"));
        let layout = |entries: &[wgpu::BindGroupLayoutEntry]| {
            device
                .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("window"), entries })
        };
        let of_window = layout(&[uniform(0, wgpu::ShaderStages::VERTEX, 16)]);
        // As the toolkit's renderer has it: its pictures are taken from there.
        let of_image = layout(&[
            texture(0),
            wgpu::BindGroupLayoutEntry {
                binding: 1,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
                count: None,
            },
            uniform(2, wgpu::ShaderStages::FRAGMENT, 16),
        ]);
        let of_kept = layout(&[texture(1)]);
        let pipeline = |name: &str,
                        layouts: &[Option<&wgpu::BindGroupLayout>],
                        [vertex, fragment]: [&str; 2],
                        buffers: &[Option<wgpu::VertexBufferLayout<'_>>],
                        blend| {
            let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(name),
                bind_group_layouts: layouts,
                immediate_size: 0,
            });
            device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(name),
                layout: Some(&layout),
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: Some(vertex),
                    buffers,
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: None,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: Some(fragment),
                    targets: &[Some(wgpu::ColorTargetState {
                        format,
                        blend,
                        write_mask: wgpu::ColorWrites::ALL,
                    })],
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                }),
                multiview_mask: None,
                cache: None,
            })
        };
        let vertices = wgpu::VertexBufferLayout {
            array_stride: size_of::<Vertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32x2, 2 => Unorm8x4],
        };
        let over = wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING;
        Self {
            triangles: pipeline(
                "triangles",
                &[Some(&of_window), Some(&of_image)],
                ["vertex", "fragment"],
                &[Some(vertices)],
                Some(over),
            ),
            shown: pipeline("shown", &[Some(&of_kept)], ["whole", "show"], &[], None),
            of_window,
            of_kept,
        }
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
