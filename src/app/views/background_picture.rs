//! A picture made in the background, as it takes longer than a frame.

use eframe::egui::{Context, TextureHandle, TextureOptions};
use relativity_render::Picture;

use crate::app::tools::image;
use crate::app::tools::worker::{BackgroundWork, Work};

/// The newest picture, and the one that is being made.
pub struct BackgroundPicture<W: Work> {
    ctx: Context,
    worker: BackgroundWork<W, ()>,
    requested: Option<(W::Base, W::Job)>,
    texture: Option<TextureHandle>,
}

impl<W: Work<Result = Picture, Job: Clone + PartialEq, Tools: Send>> BackgroundPicture<W> {
    /// Nothing is made yet.
    pub fn new(ctx: &Context) -> Self {
        let worker = BackgroundWork::new(ctx, W::Tools::default());
        Self { ctx: ctx.clone(), worker, requested: None, texture: None }
    }

    /// Makes the picture in the background, unless it was requested last.
    pub fn request(&mut self, base: &W::Base, job: &W::Job) {
        if !self.requested.as_ref().is_some_and(|(same, requested)| same == base && requested == job) {
            self.worker.request((), base.clone(), job.clone());
            self.requested = Some((base.clone(), job.clone()));
        }
    }

    /// The newest picture, be it outdated or not.
    pub fn newest(&mut self) -> Option<&TextureHandle> {
        if let Some(((), Picture { size, rgba })) = self.worker.result() {
            let image = image::of_pixels(size, &rgba);
            match &mut self.texture {
                Some(texture) => texture.set(image, TextureOptions::LINEAR),
                none => *none = Some(self.ctx.load_texture(W::NAME, image, TextureOptions::LINEAR)),
            }
        }
        self.texture.as_ref()
    }

    /// Returns whether the newest picture is the requested one.
    #[must_use]
    pub fn is_up_to_date(&self) -> bool {
        self.texture.is_some() && !self.worker.is_pending()
    }
}
