//! A view in which motion is a slide: a conformal one, of a head held along the motion.

use eframe::egui::Vec2;
use relativity_render::camera::mercator::Mercator;
use relativity_render::{Geometry, Velocity, View};

use crate::app::state::State;
use crate::app::views::panes::EyePane;

/// A view in which motion is a slide.
#[derive(Debug, Clone, Copy)]
pub struct SlidingView {
    /// The view with the camera at its eye.
    pub view: View,
    /// The map of the sky that the picture is.
    pub mercator: Mercator,
    /// 1 where columns to the right are ahead along +x, -1 where they are behind the head.
    pub ahead: f64,
}

impl SlidingView {
    /// Returns `None` where `view` is not conformal, the head is tilted, or the eyes ride another way than
    /// along the street: motion is no slide along the rows then.
    #[must_use]
    pub fn new(state: &State, view: &View) -> Option<Self> {
        let settings = &state.document.settings;
        let slides = settings.baseline().is_along_motion() && !settings.ride.leaves_street();
        let mercator = view.camera.mercator().filter(|_| slides)?;
        let shows_motion = matches!(view.geometry, Geometry::Seen | Geometry::Rest);
        let ahead = mercator.axes.right.x.signum();
        shows_motion.then_some(Self { view: *view, mercator, ahead })
    }

    /// Returns by how much u `velocity` slides the resting picture to the right: the rapidity, against the
    /// motion.
    pub fn shift(&self, velocity: &Velocity) -> f64 {
        match self.view.geometry {
            Geometry::Seen => -self.ahead * velocity.rapidity(),
            _ => 0.0,
        }
    }
}

/// Points per pixel of the picture in `pane`.
pub fn points_per_px(pane: EyePane) -> Vec2 {
    let [width, height] = pane.size;
    pane.rect.size() / Vec2::new(width as f32, height as f32)
}
