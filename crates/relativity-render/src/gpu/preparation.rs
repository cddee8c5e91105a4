//! Pipelines before a picture needs them: which it will need, and what makes them, in another thread if there
//! is one.
//!
//! A driver puts off most of the making until a pipeline first draws (a software one four fifths of it), so
//! each draws once, next to nothing.

use super::buffers::fill_vertex_buffer;
use super::canvas::{Canvas, last_passes};
use super::device::Gpu;
use super::drawing::Trait;
use super::error::GpuError;
use super::pipelines::Technique;
use super::target::EyeTarget;
use crate::frame::pipeline_key::{Key, Output};
use crate::frame::uniform::FrameUniform;
use crate::geometry::kind::Kind;
use crate::scene::prepared_scene::PreparedScene;
use crate::street::backdrop::LastPass;
use crate::view::group_view::GroupView;
use crate::view::{Appearance, View};

/// Side of the picture in which pipelines draw once, pixels.
const SIDE: u32 = 16;
/// Numbers that three corners or instances of any technique have room in.
const CORNERS: usize = 256;

/// A pipeline that a picture needs.
#[derive(Debug, Clone, Copy)]
pub struct NeededPipeline(Part);

#[derive(Debug, Clone, Copy)]
enum Part {
    Bodies(Technique, Key),
    Backdrop(LastPass),
}

/// Makes pipelines that are needed soon.
#[derive(Debug)]
pub struct PipelineMaker {
    gpu: Gpu,
    canvas: Canvas,
    target: EyeTarget,
}

/// Returns the pipelines that pictures need of `scene`, as `view` and `appearance` show it, and that are not
/// made: for all its bodies, wherever they are and however thin they look. `technique` is that of each group.
pub fn missing(
    gpu: &Gpu,
    technique: impl Fn(&GroupView) -> Technique,
    scene: &PreparedScene,
    view: &View,
    appearance: &Appearance,
) -> Vec<NeededPipeline> {
    let views = scene.group_views(view);
    let mut drawn: Vec<Trait<()>> = Vec::new();
    for body in scene.bodies() {
        let turns = views[body.group].turns(body);
        // A model is drawn as it is, however thin.
        let thin = [false, true].into_iter().filter(|is_thin| !is_thin || body.kind != Kind::Model);
        for is_thin in thin {
            let (group, kind, is_patterned) = (body.group, body.kind, body.is_patterned);
            let found = Trait { group, kind, template: (), is_thin, is_patterned, turns };
            if !drawn.contains(&found) {
                drawn.push(found);
            }
        }
    }
    let of_bodies = drawn.into_iter().map(|Trait { group, kind, is_thin, is_patterned, turns, .. }| {
        let output = Output::new(&views[group], turns, Some(appearance), is_thin, is_patterned);
        Part::Bodies(technique(&views[group]), Key::new(kind, turns, &views, group, output))
    });
    let frames = FrameUniform::of_groups(scene, &views, appearance);
    let all = of_bodies.chain(last_passes(&frames[0]).map(Part::Backdrop));
    all.filter(|part| !part.is_made(gpu)).map(NeededPipeline).collect()
}

impl Part {
    fn is_made(&self, gpu: &Gpu) -> bool {
        match self {
            Self::Bodies(technique, key) => gpu.cache.bodies.has(&(technique.vertex, *key)),
            Self::Backdrop(pass) => gpu.cache.last_passes.has(pass),
        }
    }
}

impl PipelineMaker {
    /// A maker on `gpu`.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        let mut target = EyeTarget::new(gpu, [SIDE; 2]);
        // Corners in one place, and rectangles whose sides have one direction: they cover nothing.
        fill_vertex_buffer(gpu, &mut target.vertices, &[1.0_f32; CORNERS]);
        Self { canvas: Canvas::new(gpu), target, gpu: gpu.clone() }
    }

    /// Makes a pipeline for all that draw on the device, and has it draw once.
    ///
    /// # Errors
    ///
    /// The device refuses it, or was lost.
    pub fn make(&self, NeededPipeline(part): &NeededPipeline) -> Result<(), GpuError> {
        let Self { gpu, canvas, target } = self;
        let scopes = gpu.error_scopes();
        match part {
            Part::Bodies(technique, key) => canvas.try_bodies(gpu, target, technique, *key),
            Part::Backdrop(pass) => canvas.try_last_pass(gpu, target, *pass),
        }
        let finished = gpu.wait();
        scopes.close().and(finished)
    }
}
