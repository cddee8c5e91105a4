//! A picture by the reference renderer, drawn in steps: one where there are threads, else bands of rows,
//! between which the window goes on.

use gamow_platform::threads;
use relativity_render::{Appearance, Picture, PreparedScene, View};
use serde::{Deserialize, Serialize};

use crate::accuracy::REFERENCE_SAMPLES;
use crate::app::tools::worker::{StepOutcome, Wanted, Work};

/// A picture to draw.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ReferencePicture {
    /// View of the picture.
    pub view: View,
    /// Appearance of the light.
    pub appearance: Appearance,
    /// Rays per pixel and direction.
    pub samples: u32,
}

/// The drawing of a picture.
pub struct ReferenceSteps {
    /// Scene that is drawn.
    scene: PreparedScene,
    drawing: ReferencePicture,
    /// Pixels that were drawn, row by row.
    drawn: Vec<[u8; 4]>,
}

impl Work for ReferenceSteps {
    const NAME: &'static str = "reference";
    type Base = PreparedScene;
    type Job = ReferencePicture;
    type Result = Picture;
    type Tools = ();

    fn begin(scene: PreparedScene, drawing: ReferencePicture) -> Self {
        Self { scene, drawing, drawn: Vec::new() }
    }

    fn step(&mut self, (): &mut (), wanted: &Wanted) -> StepOutcome<Picture> {
        if threads::ARE_SEVERAL {
            return StepOutcome::Last(self.whole(wanted));
        }
        let Self { scene, drawing: ReferencePicture { view, appearance, samples }, drawn } = self;
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

impl ReferenceSteps {
    /// Draws all of the picture at once; `None` if it is no longer wanted.
    fn whole(&self, wanted: &Wanted) -> Option<Picture> {
        let Self { scene, drawing: ReferencePicture { view, appearance, samples }, .. } = self;
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
            let drawing = ReferencePicture { view, appearance: Appearance::default(), samples: 1 };
            let there = sent(&drawing);
            assert_eq!(there, drawing);
            let drawn =
                |scene: &PreparedScene, ReferencePicture { view, appearance, samples }: ReferencePicture| {
                    scene.picture(&view, &appearance, samples)
                };
            let picture = drawn(&scene, drawing);
            assert!(sent(&picture) == picture && drawn(&sent(&scene), there) == picture, "{name}");
        }
    }
}
