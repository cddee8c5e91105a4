//! A picture made by a thread of its own, as it takes longer than a frame.

use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};
use relativity_render::Picture;

use crate::app::worker::{Wanted, Worker};

/// The newest picture, and the one that is being made.
pub struct BackgroundPicture<J> {
    ctx: Context,
    name: &'static str,
    worker: Worker<J, ColorImage>,
    requested: Option<J>,
    texture: Option<TextureHandle>,
}

impl<J: Clone + PartialEq + Send + 'static> BackgroundPicture<J> {
    /// Pictures of what `picture` makes of a job.
    pub fn new(ctx: &Context, name: &'static str, picture: impl Fn(&J) -> Picture + Send + 'static) -> Self {
        let work = move |job: J, _: &Wanted| {
            let Picture { size, rgba } = picture(&job);
            Some(ColorImage::from_rgba_unmultiplied(size.map(|side| side as usize), rgba.as_flattened()))
        };
        Self {
            ctx: ctx.clone(),
            name,
            worker: Worker::new(ctx.clone(), work),
            requested: None,
            texture: None,
        }
    }

    /// Draws the picture of `job` in the background, unless it was requested last.
    pub fn request(&mut self, job: &J) {
        if self.requested.as_ref() != Some(job) {
            self.worker.request(job.clone());
            self.requested = Some(job.clone());
        }
    }

    /// The newest picture, be it outdated or not.
    pub fn newest(&mut self) -> Option<&TextureHandle> {
        if let Some(image) = self.worker.result() {
            match &mut self.texture {
                Some(texture) => texture.set(image, TextureOptions::LINEAR),
                none => *none = Some(self.ctx.load_texture(self.name, image, TextureOptions::LINEAR)),
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
