//! Pictures by the reference renderer, or by the packets where no frame has the time for them, which are made
//! in the background while nothing changes: step by step with more rays a pixel.

use eframe::egui::Context;
use relativity_render::Picture;

use super::pace::pixels;
use super::request::Request;
use crate::accuracy::REFERENCE_SAMPLES;
use crate::app::tools::debounce::Debounce;
use crate::app::tools::worker::BackgroundWork;
use crate::app::views::picture_steps::{PictureJob, PictureSteps};

/// Rays per pixel and direction of the steps in which pictures get smoother: the first has as many as any
/// other picture.
const STEPS: [u32; 3] = [REFERENCE_SAMPLES, 4, 8];
/// Greatest number of rays of a step that only makes a picture smoother: about a minute of a processor.
const MOST_RAYS: f64 = 5e7;

/// A picture, and how many rays per pixel and direction it is made of.
#[derive(Debug)]
pub struct FinishedPicture {
    /// Request that the picture fulfils.
    pub of: Request,
    /// Rays per pixel and direction.
    pub samples: u32,
    /// Picture that was drawn.
    pub picture: Picture,
}

/// The background drawing of one eye.
pub struct Background {
    worker: BackgroundWork<PictureSteps, (Request, u32)>,
    stillness: Debounce<Request>,
    requested: Option<(Request, u32)>,
    /// Newest picture.
    done: Option<FinishedPicture>,
    /// Whether what is to be shown is not yet made.
    pub is_awaited: bool,
    /// Whether what is shown is to get smoother.
    pub is_refining: bool,
}

impl Background {
    /// Returns a background without a picture yet.
    pub fn new(ctx: &Context) -> Self {
        Self {
            worker: BackgroundWork::new(ctx, ()),
            stillness: Debounce::default(),
            requested: None,
            done: None,
            is_awaited: false,
            is_refining: false,
        }
    }

    /// Returns the picture for `request`, once it is drawn. Drawing begins when the request no longer
    /// changes, and then the picture gets smoother if it may.
    pub fn picture(&mut self, ctx: &Context, request: &Request) -> Option<&FinishedPicture> {
        let is_still = self.stillness.is_still(ctx, request);
        self.update(request, REFERENCE_SAMPLES, is_still);
        self.done.as_ref().filter(|_| !self.is_awaited)
    }

    /// A smoother picture than the one of `request` that another method has drawn, if it may be and once
    /// there is one.
    pub fn smoother(&mut self, ctx: &Context, request: &Request) -> Option<&FinishedPicture> {
        let is_still = self.stillness.is_still(ctx, request);
        self.update(request, STEPS[1], is_still);
        let is_made = !std::mem::take(&mut self.is_awaited);
        self.is_refining |= !is_made;
        self.done.as_ref().filter(|made| is_made && made.samples > REFERENCE_SAMPLES)
    }

    /// Returns the newest picture of this size, even if it was requested before: a late one is better than
    /// none.
    pub fn newest(&mut self, request: &Request) -> Option<&FinishedPicture> {
        self.update(request, REFERENCE_SAMPLES, true);
        self.done.as_ref().filter(|made| made.picture.size == request.view.camera.size)
    }

    /// Receives what is done, and begins the next step, the `first` before all, if it `may_begin`.
    fn update(&mut self, request: &Request, first: u32, may_begin: bool) {
        if let Some(((of, samples), picture)) = self.worker.result() {
            self.done = Some(FinishedPicture { of, samples, picture });
        }
        let made = self.done.as_ref().filter(|made| made.of == *request).map_or(0, |made| made.samples);
        self.is_awaited = made < first;
        let next =
            next_step(made, first, request.view.camera.size).filter(|step| *step == first || request.refine);
        self.is_refining = !self.is_awaited && next.is_some();
        self.requested.take_if(|(of, samples)| {
            let is_outdated = of != request && *samples > REFERENCE_SAMPLES;
            if is_outdated {
                self.worker.stop();
            }
            is_outdated
        });
        let Some(samples) = next.filter(|_| may_begin) else { return };
        let is_requested = |(of, step): &(Request, u32)| of == request && *step == samples;
        if !self.requested.as_ref().is_some_and(is_requested) {
            let Request { view, appearance, method, .. } = *request;
            let drawing = PictureJob { view, appearance, method, samples };
            self.worker.request((request.clone(), samples), request.scene.clone(), drawing);
            self.requested = Some((request.clone(), samples));
        }
    }

    /// Gives up what is being made.
    pub fn stop(&mut self) {
        if self.requested.take().is_some() {
            self.worker.stop();
        }
        (self.is_awaited, self.is_refining) = (false, false);
    }
}

/// Returns the step after the one that is `made`, the `first` or a later one; none where the pixels of a
/// picture of this `size` are so fine that the step would take long to change little.
fn next_step(made: u32, first: u32, size: [u32; 2]) -> Option<u32> {
    let has_time = |step: u32| pixels(size) * f64::from(step * step) <= MOST_RAYS;
    STEPS.into_iter().find(|&step| step > made && step >= first && (step == first || has_time(step)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_gets_smoother_as_long_as_its_pixels_are_few() {
        let steps = |first, size| {
            std::iter::successors(next_step(0, first, size), |&made| next_step(made, first, size))
                .collect::<Vec<_>>()
        };
        assert_eq!(steps(REFERENCE_SAMPLES, [600, 760]), STEPS);
        assert_eq!(steps(4, [600, 760]), [4, 8]);
        assert_eq!(steps(REFERENCE_SAMPLES, [1500, 2000]), [REFERENCE_SAMPLES, 4]);
        assert_eq!(steps(4, [3000, 2000]), [4]);
    }
}
