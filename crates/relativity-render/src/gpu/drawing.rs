//! The interface of the GPU renderers: the request for a drawing, and the batches of instances that answer
//! it.
//!
//! A renderer says which bodies can be seen and as what they are drawn ([`Drawing::load`],
//! [`Drawing::record`]); the canvas makes a picture or a measurement of that.

use std::ops::Range;

use super::buffers::fill_vertex_buffer;
use super::device::Gpu;
use super::models::Models;
use super::pipelines::Pipelines;
use crate::frame::pipeline_key::{Key, Output};
use crate::geometry::kind::Kind;
use crate::light::screen_light::Light;
use crate::scene::prepared_body::PreparedBody;
use crate::scene::prepared_scene::PreparedScene;
use crate::scene::wheel::packed::{TurningStart, Turns};
use crate::view::Appearance;
use crate::view::group_view::GroupView;

/// A request for a drawing.
#[derive(Debug, Clone, Copy)]
pub struct Shot<'a> {
    /// Scene with the bodies to draw.
    pub scene: &'a PreparedScene,
    /// The scene's models on the device.
    pub models: &'a Models,
    /// Views of the scene's groups, one each.
    pub views: &'a [GroupView],
    /// The looks of a picture; `None` asks for what the centre of each pixel shows, in numbers.
    pub appearance: Option<&'a Appearance>,
}

/// A way to draw bodies.
pub trait Drawing {
    /// Decides what is drawn for `shot`, puts it into the vertex buffer, and makes the pipelines that it
    /// needs.
    fn load(&mut self, gpu: &Gpu, vertices: &mut wgpu::Buffer, shot: &Shot<'_>);

    /// Draws what was loaded, with a bind group for the frame of each group.
    fn record(&self, pass: &mut wgpu::RenderPass<'_>, vertices: &wgpu::Buffer, frames: &[wgpu::BindGroup]) {
        for are_thin in [false, true] {
            self.record_bodies(pass, vertices, frames, are_thin);
        }
    }

    /// Draws, of what was loaded, the bodies that are thinner than a pixel, or all others.
    fn record_bodies(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        vertices: &wgpu::Buffer,
        frames: &[wgpu::BindGroup],
        are_thin: bool,
    );
}

/// Instances `I`, in the order they are drawn in: neighbours that one draw serves make a batch. Kept from
/// shot to shot, for its memory.
#[derive(Debug)]
pub struct Batches<I, T> {
    pipelines: Pipelines,
    instances: Vec<I>,
    in_order: Vec<InstanceBatch<T>>,
}

/// Instances that one draw serves.
#[derive(Debug)]
pub struct InstanceBatch<T> {
    group: usize,
    key: Key,
    /// Template that each instance is a copy of.
    pub template: T,
    /// Range of the instances in the vertex buffer.
    pub instances: Range<u32>,
}

/// The properties that the instances of a batch share. Its order is that in which rays draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Trait<T> {
    /// Whether they are thinner than a pixel, and faded for that.
    pub is_thin: bool,
    /// The number of their group.
    pub group: usize,
    /// The kind of their shapes.
    pub kind: Kind,
    /// Whether any of them carries a pattern.
    pub is_patterned: bool,
    /// Turning of the instances.
    pub turns: Turns,
    /// Template that each instance is a copy of.
    pub template: T,
}

impl Shot<'_> {
    /// `body` as its group's view shows it, for the shaders.
    pub fn shown(&self, body: &PreparedBody) -> TurningStart {
        self.views[body.group].shown(body, self.scene.groups()[body.group].extent.middle)
    }

    /// Returns the pattern of `body` for the shaders; of a model the row that it begins with, and 1 if it is
    /// seen from both sides.
    pub fn pattern(&self, body: &PreparedBody) -> [f32; 3] {
        let Some(triangles) = &body.triangles else { return body.pattern() };
        [self.models.row(triangles) as f32, f32::from(u8::from(triangles.is_two_sided)), 0.0]
    }

    /// The light of `body` for the shaders; numbers have none.
    pub fn light(&self, body: &PreparedBody) -> [f32; 4] {
        self.appearance.map_or([0.0; 4], |appearance| {
            let view = &self.views[body.group];
            let effects = view.effects(view.turns(body), appearance);
            Light::new(body.emission, appearance).packed(appearance, effects)
        })
    }
}

impl<I: bytemuck::NoUninit, T> Batches<I, T> {
    /// None yet, to be drawn by these pipelines.
    pub const fn new(pipelines: Pipelines) -> Self {
        Self { pipelines, instances: Vec::new(), in_order: Vec::new() }
    }

    /// Replaces all by `runs`: what makes the pipelines that they need, and fills the vertex buffer with
    /// them.
    pub fn refill<'a>(
        &mut self,
        gpu: &Gpu,
        vertices: &mut wgpu::Buffer,
        shot: &Shot<'_>,
        runs: impl Iterator<Item = (Trait<T>, impl Iterator<Item = &'a I>)>,
    ) where
        I: 'a,
    {
        self.instances.clear();
        self.in_order.clear();
        for (shared, run) in runs {
            let start = self.instances.len() as u32;
            self.instances.extend(run);
            let key = self.prepared(gpu, shot, &shared);
            let Trait { group, template, .. } = shared;
            let instances = start..self.instances.len() as u32;
            self.in_order.push(InstanceBatch { group, key, template, instances });
        }
        fill_vertex_buffer(gpu, vertices, &self.instances);
    }

    /// Replaces all by these ranges of a buffer that is filled already, and makes the pipelines that they
    /// need.
    pub fn refer<'a>(
        &mut self,
        gpu: &Gpu,
        shot: &Shot<'_>,
        ranges: impl Iterator<Item = (Trait<T>, &'a [Range<u32>])>,
    ) where
        T: Copy,
    {
        self.in_order.clear();
        for (shared, ranges) in ranges {
            let key = self.prepared(gpu, shot, &shared);
            let Trait { group, template, .. } = shared;
            let batch = |range: &Range<u32>| InstanceBatch { group, key, template, instances: range.clone() };
            self.in_order.extend(ranges.iter().map(batch));
        }
    }

    /// Makes the pipeline of instances that share this, and returns its key.
    fn prepared(&mut self, gpu: &Gpu, shot: &Shot<'_>, shared: &Trait<T>) -> Key {
        let &Trait { group, kind, is_thin, is_patterned, turns, .. } = shared;
        let output = Output::new(&shot.views[group], turns, shot.appearance, is_thin, is_patterned);
        let key = Key::new(kind, turns, shot.views, group, output);
        self.pipelines.prepare(gpu, key);
        key
    }

    /// The batches, in order.
    pub fn iter(&self) -> impl Iterator<Item = &InstanceBatch<T>> {
        self.in_order.iter()
    }

    /// The batches of bodies that are thinner than a pixel, or of all others, in order.
    pub fn of_bodies(&self, are_thin: bool) -> impl Iterator<Item = &InstanceBatch<T>> {
        self.iter().filter(move |batch| batch.key.output.is_thin() == are_thin)
    }

    /// Sets the pipeline and the frame of `batch`.
    pub fn begin(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        frames: &[wgpu::BindGroup],
        batch: &InstanceBatch<T>,
    ) {
        pass.set_bind_group(0, &frames[batch.group], &[]);
        pass.set_pipeline(self.pipelines.get(batch.key));
    }
}
