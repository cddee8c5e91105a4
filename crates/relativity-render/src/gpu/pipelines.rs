//! The pipelines that draw bodies, made when first needed: one per kind of shape, geometry and set of
//! effects.

use std::collections::HashMap;

use super::device::Gpu;
use super::sampling::Sampling;
use super::target::{DEPTH_FORMAT, MEASURES_FORMAT, linear_target};
use crate::frame::pipeline_key::{AmongOthers, Key, Output};
use crate::geometry::kind::Kind;
use crate::light::tone;
use crate::light::{palette, shade, sky};
use crate::scene::pattern;
use crate::shaders::Source;
use crate::view::effects::{Constant, Effects, number};

/// The technique of a renderer: the part of its pipelines that is its own.
#[derive(Debug, Clone, Copy)]
pub struct Technique {
    /// The shader of a kind of shape.
    pub source: fn(Kind) -> Source,
    /// Entry point of the vertex stage. It names the technique in the key of its pipelines, so no other
    /// technique has the same.
    pub vertex: &'static str,
    /// Layouts of the buffers that the vertex stage reads.
    pub buffers: &'static [Option<wgpu::VertexBufferLayout<'static>>],
    /// Assembly of vertices into triangles.
    pub primitive: wgpu::PrimitiveState,
    /// The constant that no other technique's shaders have, if there is one.
    pub constant: Option<fn(Key) -> Constant>,
}

impl Technique {
    /// Triangles, both sides of them, corner by corner.
    pub const TRIANGLES: wgpu::PrimitiveState = wgpu::PrimitiveState {
        topology: wgpu::PrimitiveTopology::TriangleList,
        strip_index_format: None,
        front_face: wgpu::FrontFace::Ccw,
        cull_mode: None,
        unclipped_depth: false,
        polygon_mode: wgpu::PolygonMode::Fill,
        conservative: false,
    };

    /// Returns how vertices become triangles for bodies of this `kind`: those of models show both sides,
    /// unless their shaders leave one out.
    fn primitive_of(&self, kind: Kind) -> wgpu::PrimitiveState {
        let is_two_sided = kind == Kind::Model;
        wgpu::PrimitiveState {
            cull_mode: self.primitive.cull_mode.filter(|_| !is_two_sided),
            ..self.primitive
        }
    }

    /// Returns all constants of the shaders, whose samples are drawn so.
    pub fn constants(&self, key: Key, sampling: Sampling) -> Vec<Constant> {
        let (effects, is_thin, is_patterned) = match key.output {
            Output::Picture { effects, is_thin, is_patterned } => (effects, is_thin, is_patterned),
            Output::Hits => (Effects::NONE, false, false),
        };
        let alone = AmongOthers { is_reference: true, reference: key.geometry };
        let others = key.among_others.unwrap_or(alone);
        let mut constants = vec![
            ("THIN", number(is_thin)),
            key.turns.constant(),
            ("GEOMETRY", key.geometry.number()),
            ("CONFORMAL", number(key.is_conformal)),
            ("OBLIQUE", number(key.is_oblique)),
            ("HAS_OTHERS", number(key.among_others.is_some())),
            ("IS_REFERENCE", number(others.is_reference)),
            ("REFERENCE_GEOMETRY", others.reference.number()),
        ];
        constants.extend(self.constant.map(|constant| constant(key)));
        constants.extend(effects.constants());
        constants.extend(shade::constants());
        constants.extend(tone::constants());
        constants.extend(palette::constants());
        constants.extend(palette::places());
        constants.extend(sky::constants());
        constants.extend(pattern::constants(is_patterned, key.geometry));
        sampling.among(constants)
    }
}

/// The pipelines that a renderer has needed.
#[derive(Debug)]
pub struct Pipelines {
    technique: Technique,
    layout: wgpu::PipelineLayout,
    needed: HashMap<Key, wgpu::RenderPipeline>,
}

impl Pipelines {
    /// Returns an empty collection.
    pub fn new(technique: Technique, layout: wgpu::PipelineLayout) -> Self {
        Self { technique, layout, needed: HashMap::new() }
    }

    /// Takes the pipeline of `key` from the device's cache, which makes it if it has none.
    pub fn prepare(&mut self, gpu: &Gpu, key: Key) {
        let (technique, layout) = (&self.technique, &self.layout);
        self.needed.entry(key).or_insert_with(|| technique.pipeline(gpu, layout, key));
    }

    /// The pipeline of a prepared `key`.
    pub fn get(&self, key: Key) -> &wgpu::RenderPipeline {
        &self.needed[&key]
    }
}

impl Technique {
    /// Returns the pipeline of `key` from the device's cache, which makes it with this `layout` if it has
    /// none.
    pub fn pipeline(&self, gpu: &Gpu, layout: &wgpu::PipelineLayout, key: Key) -> wgpu::RenderPipeline {
        gpu.cache.bodies.get((self.vertex, key), || self.made(gpu, layout, key))
    }

    fn made(&self, gpu: &Gpu, layout: &wgpu::PipelineLayout, key: Key) -> wgpu::RenderPipeline {
        let (entry_point, sampling, targets) = match key.output {
            Output::Picture { is_thin, .. } => {
                ("picture", gpu.sampling(), vec![Some(linear_target(is_thin))])
            }
            Output::Hits => ("hits", Sampling::MIDDLE, vec![Some(MEASURES_FORMAT.into()); 2]),
        };
        let constants = self.constants(key, sampling);
        let module = &gpu.shader("bodies", (self.source)(key.kind));
        let compilation_options =
            wgpu::PipelineCompilationOptions { constants: &constants, ..Default::default() };
        gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(entry_point),
            layout: Some(layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some(self.vertex),
                compilation_options: compilation_options.clone(),
                buffers: self.buffers,
            },
            primitive: self.primitive_of(key.kind),
            depth_stencil: Some(nearest()),
            multisample: wgpu::MultisampleState { count: sampling.of_hardware, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some(entry_point),
                compilation_options,
                targets: &targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// The nearest is seen, of equally near ones the first: see the shaders' `depth`.
fn nearest() -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(true),
        depth_compare: Some(wgpu::CompareFunction::Greater),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    }
}
