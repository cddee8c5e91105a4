//! A picture that takes longer than a frame, by the reference renderer or the packets. The reference draws it
//! in steps: one where there are threads, else bands of rows, between which the window goes on.

use gamow_platform::threads;
use relativity_render::{Appearance, Method, Picture, PreparedScene, Renderers, View};
use serde::{Deserialize, Serialize};

use crate::accuracy::REFERENCE_SAMPLES;
use crate::app::tools::worker::{StepOutcome, Wanted, Work};

/// A picture to draw.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PictureJob {
    /// View of the picture.
    pub view: View,
    /// Appearance of the light.
    pub appearance: Appearance,
    /// Method that draws it: the packets, or else the reference, as which there is none with more rays.
    pub method: Method,
    /// Rays per pixel and direction.
    pub samples: u32,
}

/// The drawing of a picture.
pub struct PictureSteps {
    /// Scene that is drawn.
    scene: PreparedScene,
    drawing: PictureJob,
    /// Pixels that were drawn, row by row.
    drawn: Vec<[u8; 4]>,
}

impl Work for PictureSteps {
    const NAME: &'static str = "picture";
    type Base = PreparedScene;
    type Job = PictureJob;
    type Result = Picture;
    type Tools = ();

    fn begin(scene: PreparedScene, drawing: PictureJob) -> Self {
        Self { scene, drawing, drawn: Vec::new() }
    }

    fn step(&mut self, (): &mut (), wanted: &Wanted) -> StepOutcome<Picture> {
        if threads::ARE_SEVERAL || self.drawing.is_for_packets() {
            return StepOutcome::Last(self.whole(wanted));
        }
        let Self { scene, drawing: PictureJob { view, appearance, samples, .. }, drawn } = self;
        let size = view.camera.size;
        let row = drawn.len() / (size[0] as usize).max(1);
        let band = scene.picture_band(view, appearance, *samples, row as u32);
        if band.is_empty() {
            return StepOutcome::Last(Some(Picture { size, rgba: std::mem::take(drawn) }));
        }
        drawn.extend(band);
        StepOutcome::More
    }
}

impl PictureJob {
    fn is_for_packets(&self) -> bool {
        self.method == Method::Packets && self.samples <= REFERENCE_SAMPLES
    }
}

impl PictureSteps {
    /// Draws all of the picture at once; `None` if it is no longer wanted.
    fn whole(&self, wanted: &Wanted) -> Option<Picture> {
        let Self { scene, drawing: PictureJob { view, appearance, samples, .. }, .. } = self;
        if self.drawing.is_for_packets() {
            let picture = Renderers::default().by_packets_while(scene, view, appearance, &|| wanted.holds());
            return picture.filter(|_| wanted.holds());
        }
        let picture = || scene.picture_while(view, appearance, *samples, &|| wanted.holds());
        // What is shown without it can wait; what is not there yet cannot.
        if *samples > REFERENCE_SAMPLES { threads::on_half(picture) } else { picture() }
    }
}

#[cfg(test)]
mod tests {
    use relativity_core::{Aperture, Speed};
    use relativity_render::{Camera, Gaze, Geometry};

    use super::*;
    use crate::app::tools::worker::sent;
    use crate::scene::{PRESETS, Scene};

    #[test]
    fn what_is_sent_is_drawn_alike() {
        let speed = Speed::from_gamma(1e9).expect("it is one");
        for name in PRESETS {
            let scene = Scene::preset(name).expect("it is a preset").prepared();
            let camera = Camera::new(Aperture::pair(0.1)[1], Gaze::STRAIGHT_AHEAD, 1.2, [24, 18]);
            let view = View { camera, speed, observation_time: 3.1, geometry: Geometry::Seen };
            let drawing =
                PictureJob { view, appearance: Appearance::default(), method: Method::Reference, samples: 1 };
            let there = sent(&drawing);
            assert_eq!(there, drawing);
            let drawn = |scene: &PreparedScene, PictureJob { view, appearance, samples, .. }: PictureJob| {
                scene.picture(&view, &appearance, samples)
            };
            let picture = drawn(&scene, drawing);
            assert!(sent(&picture) == picture && drawn(&sent(&scene), there) == picture, "{name}");
        }
    }
}
