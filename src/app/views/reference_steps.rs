//! A picture by the reference renderer, drawn in steps: one where there are threads, else bands of rows, between which the window goes on.

use relativity_render::{Appearance, Picture, PreparedScene, View};

use crate::accuracy::REFERENCE_SAMPLES;
use crate::app::worker::{Step, Wanted};
use crate::platform::threads;

/// The drawing of a picture.
pub struct ReferenceSteps {
    /// Scene that is drawn.
    pub scene: PreparedScene,
    /// View of the picture.
    pub view: View,
    /// Appearance of the light.
    pub appearance: Appearance,
    /// Rays per pixel and direction.
    pub samples: u32,
    /// Pixels that were drawn, row by row.
    drawn: Vec<[u8; 4]>,
}

impl ReferenceSteps {
    /// Begins the picture of `view`.
    pub const fn new(scene: PreparedScene, view: View, appearance: Appearance, samples: u32) -> Self {
        Self { scene, view, appearance, samples, drawn: Vec::new() }
    }

    /// Does the next step.
    pub fn step(&mut self, wanted: &Wanted) -> Step<Picture> {
        if threads::ARE_SEVERAL {
            return Step::Last(self.whole(wanted));
        }
        let Self { scene, view, appearance, samples, drawn } = self;
        let size = view.camera.size;
        let row = drawn.len() / (size[0] as usize).max(1);
        let band = scene.picture_band(view, appearance, *samples, row as u32);
        if band.is_empty() {
            return Step::Last(Some(Picture { size, rgba: std::mem::take(drawn) }));
        }
        drawn.extend(band);
        Step::More
    }

    /// Draws all of the picture at once; `None` if it is no longer wanted.
    fn whole(&self, wanted: &Wanted) -> Option<Picture> {
        let Self { scene, view, appearance, samples, .. } = self;
        let picture = || scene.picture_while(view, appearance, *samples, &|| wanted.holds());
        // What is shown without it can wait; what is not there yet cannot.
        if *samples > REFERENCE_SAMPLES { threads::on_half(picture) } else { picture() }
    }
}
