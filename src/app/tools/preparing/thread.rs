//! A thread that makes pipelines, one after the other.

use eframe::egui::Context;
use gamow_platform::clock::Instant;
use relativity_render::{Gpu, NeededPipeline, PipelineMaker};

use crate::app::tools::worker::{Wanted, Worker};

/// The thread, and what it makes.
pub struct Preparing(Worker<NeededPipeline, ()>);

impl Preparing {
    /// A thread without requests; it requests a repaint for each pipeline that it makes.
    pub fn new(ctx: &Context, gpu: &Gpu) -> Self {
        let gpu = gpu.clone();
        let mut maker = None;
        Self(Worker::new(ctx.clone(), move |needed: NeededPipeline, _: &Wanted| {
            let start = Instant::now();
            // What the device refuses it refuses again when a picture is drawn, and then it is reported.
            let made = maker.get_or_insert_with(|| PipelineMaker::new(&gpu)).make(&needed);
            log::trace!("a pipeline took {:.0} ms: {made:?}", start.elapsed_ms());
            Some(())
        }))
    }

    /// Has the first of the `missing` pipelines made, unless another is being made.
    pub fn go_on(&self, missing: &[NeededPipeline]) {
        if let Some(next) = missing.first().filter(|_| !self.is_pending()) {
            self.0.request(*next);
        }
    }

    /// Whether a pipeline is being made.
    pub fn is_pending(&self) -> bool {
        self.0.result();
        self.0.is_pending()
    }
}
