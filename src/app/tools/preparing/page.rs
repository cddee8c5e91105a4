//! Pipelines that are made between the frames of a page, which has no threads for them.

use eframe::egui::Context;
use relativity_render::{Gpu, NeededPipeline, PipelineMaker};

/// The maker of pipelines in a page, one between two frames.
pub struct Preparing {
    ctx: Context,
    maker: PipelineMaker,
}

impl Preparing {
    /// A maker of pipelines on this device.
    pub fn new(ctx: &Context, gpu: &Gpu) -> Self {
        Self { ctx: ctx.clone(), maker: PipelineMaker::new(gpu) }
    }

    /// Makes the first of the `missing` pipelines; another frame follows.
    pub fn go_on(&self, missing: &[NeededPipeline]) {
        if let Some(next) = missing.first() {
            // What the device refuses it refuses again when a picture is drawn, and then it is reported.
            let _ = self.maker.make(next);
            self.ctx.request_repaint();
        }
    }

    /// Whether a pipeline is being made: not from frame to frame.
    pub const fn is_pending(&self) -> bool {
        false
    }
}
