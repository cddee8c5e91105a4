//! The pipelines of the mesh renderer, one per shape and per set of effects, made when first needed.

use std::collections::HashMap;

use super::{Corner, Instance};
use crate::effects::Effects;
use crate::gpu::Gpu;
use crate::shaders::{MESH_RING, MESH_TUBE};
use crate::target::{DEPTH_FORMAT, MEASURES_FORMAT, SAMPLES, linear_target};
use crate::view::Geometry;

/// What a pipeline draws, with every effect decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Key {
    Picture { is_ring: bool, is_thin: bool, geometry: Geometry, effects: Effects },
    Hits { is_ring: bool, geometry: Geometry },
}

#[derive(Debug)]
pub struct Pipelines {
    tube: wgpu::ShaderModule,
    ring: wgpu::ShaderModule,
    layout: wgpu::PipelineLayout,
    made: HashMap<Key, wgpu::RenderPipeline>,
}

impl Pipelines {
    pub fn new(gpu: &Gpu, layout: wgpu::PipelineLayout) -> Self {
        let [tube, ring] = [MESH_TUBE, MESH_RING].map(|source| gpu.shader("mesh", source));
        Self { tube, ring, layout, made: HashMap::new() }
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
            Key::Picture { is_ring, is_thin, geometry, effects } => {
                let mut constants = constants(geometry).to_vec();
                constants.extend(effects.constants());
                let targets = [Some(linear_target(is_thin))];
                self.build(gpu, is_ring, "picture", &constants, SAMPLES, &targets)
            }
            Key::Hits { is_ring, geometry } => {
                let targets = [Some(MEASURES_FORMAT.into()), Some(MEASURES_FORMAT.into())];
                self.build(gpu, is_ring, "hits", &constants(geometry), 1, &targets)
            }
        }
    }

    fn build(
        &self,
        gpu: &Gpu,
        is_ring: bool,
        entry_point: &str,
        constants: &[(&str, f64)],
        samples: u32,
        targets: &[Option<wgpu::ColorTargetState>],
    ) -> wgpu::RenderPipeline {
        let module = if is_ring { &self.ring } else { &self.tube };
        let compilation_options = wgpu::PipelineCompilationOptions { constants, ..Default::default() };
        let corners = wgpu::VertexBufferLayout {
            array_stride: size_of::<Corner>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x2],
        };
        let instances = wgpu::VertexBufferLayout {
            array_stride: size_of::<Instance>() as u64,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &wgpu::vertex_attr_array![
                2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32
            ],
        };
        gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(entry_point),
            layout: Some(&self.layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some("corner"),
                compilation_options: compilation_options.clone(),
                buffers: &[Some(corners), Some(instances)],
            },
            primitive: wgpu::PrimitiveState { cull_mode: Some(wgpu::Face::Back), ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some(entry_point),
                compilation_options,
                targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// The constants of a view's geometry.
fn constants(geometry: Geometry) -> [(&'static str, f64); 2] {
    [("MAP", geometry.map_number()), ("GEOMETRY", geometry.number())]
}
