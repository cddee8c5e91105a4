//! The pipelines of the exact renderer, one per shape and per set of effects, made when first needed.

use std::collections::HashMap;

use super::pieces::Instance;
use crate::effects::{Effects, number};
use crate::gpu::Gpu;
use crate::shaders::{RING, TUBE};
use crate::target::{DEPTH_FORMAT, MEASURES_FORMAT, SAMPLES, linear_target};
use crate::view::Geometry;

/// What a pipeline draws, with every effect decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Key {
    Picture { shape: usize, thin: bool, geometry: Geometry, effects: Effects },
    Hits { shape: usize, geometry: Geometry },
}

#[derive(Debug)]
pub struct Pipelines {
    shapes: [wgpu::ShaderModule; 2],
    layout: wgpu::PipelineLayout,
    made: HashMap<Key, wgpu::RenderPipeline>,
}

impl Pipelines {
    pub fn new(gpu: &Gpu, layout: wgpu::PipelineLayout) -> Self {
        Self { shapes: [TUBE, RING].map(|source| gpu.shader("shape", source)), layout, made: HashMap::new() }
    }

    /// Makes the pipeline of `key` unless it exists.
    pub fn prepare(&mut self, gpu: &Gpu, key: Key) {
        if !self.made.contains_key(&key) {
            let pipeline = self.pipeline(gpu, key);
            self.made.insert(key, pipeline);
        }
    }

    /// The pipeline of a prepared `key`.
    pub fn get(&self, key: Key) -> &wgpu::RenderPipeline {
        &self.made[&key]
    }

    fn pipeline(&self, gpu: &Gpu, key: Key) -> wgpu::RenderPipeline {
        match key {
            Key::Picture { shape, thin, geometry, effects } => {
                let mut constants = vec![("THIN", number(thin)), ("GEOMETRY", geometry.number())];
                constants.extend(effects.constants());
                self.build(
                    gpu,
                    &Recipe {
                        module: &self.shapes[shape],
                        entry_point: if gpu.has_sample_masks() { "picture" } else { "picture_sample" },
                        constants: &constants,
                        samples: SAMPLES,
                        targets: &[Some(linear_target(thin))],
                    },
                )
            }
            Key::Hits { shape, geometry } => self.build(
                gpu,
                &Recipe {
                    module: &self.shapes[shape],
                    entry_point: "hits",
                    constants: &[("GEOMETRY", geometry.number())],
                    samples: 1,
                    targets: &[Some(MEASURES_FORMAT.into()), Some(MEASURES_FORMAT.into())],
                },
            ),
        }
    }

    fn build(&self, gpu: &Gpu, recipe: &Recipe) -> wgpu::RenderPipeline {
        let instances = wgpu::VertexBufferLayout {
            array_stride: size_of::<Instance>() as u64,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &wgpu::vertex_attr_array![
                0 => Float32x4, 1 => Float32x4, 2 => Float32x4, 3 => Float32x4, 4 => Float32x4
            ],
        };
        let compilation_options =
            wgpu::PipelineCompilationOptions { constants: recipe.constants, ..Default::default() };
        gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(recipe.entry_point),
            layout: Some(&self.layout),
            vertex: wgpu::VertexState {
                module: recipe.module,
                entry_point: Some("rectangle"),
                compilation_options: compilation_options.clone(),
                buffers: &[Some(instances)],
            },
            primitive: wgpu::PrimitiveState {
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                ..Default::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: recipe.samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: recipe.module,
                entry_point: Some(recipe.entry_point),
                compilation_options,
                targets: recipe.targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

struct Recipe<'a> {
    module: &'a wgpu::ShaderModule,
    entry_point: &'static str,
    constants: &'a [(&'a str, f64)],
    samples: u32,
    targets: &'a [Option<wgpu::ColorTargetState>],
}
