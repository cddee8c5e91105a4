//! The slide, drawn into conformal views: motion moves the resting picture back by the rapidity.
//!
//! A ruler along the lower edge is marked in rapidity, the spectrum above it stands still while what moves passes through, and
//! an outline shows where a resting body would be seen.

mod resting;
mod ruler;
mod spectrum;

use eframe::egui::{Painter, Ui, Vec2};
use relativity_render::mercator::Mercator;
use relativity_render::{Geometry, Velocity, View};

use super::panes::EyePane;
use super::state::State;

pub use ruler::HEIGHT;

/// A view in which motion is a slide.
#[derive(Debug, Clone, Copy)]
pub struct Slide {
    view: View,
    mercator: Mercator,
    /// 1 where columns to the right are ahead along +x, -1 where they are behind the head.
    ahead: f64,
}

impl Slide {
    /// That of `view`; `None` where it is not conformal, or the head is tilted: columns are not told by the motion then.
    #[must_use]
    pub fn new(state: &State, view: View) -> Option<Self> {
        let mercator = view.camera.mercator().filter(|_| state.settings.baseline().is_along_motion())?;
        let shows_motion = matches!(view.geometry, Geometry::Seen | Geometry::Rest);
        let ahead = mercator.axes.right.x.signum();
        shows_motion.then_some(Self { view, mercator, ahead })
    }

    /// How far to the right `velocity` slides the picture that would be seen at rest: the rapidity, against the motion.
    fn shift(&self, velocity: &Velocity) -> f64 {
        match self.view.geometry {
            Geometry::Seen => -self.ahead * velocity.speed.rapidity().copysign(velocity.beta()),
            _ => 0.0,
        }
    }
}

/// Whether the ruler stands in `pane`.
#[must_use]
pub fn has_ruler(state: &State, pane: EyePane) -> bool {
    state.settings.window.ruler
        && pane.rect.height() >= ruler::LEAST_VIEW
        && Slide::new(state, state.view(pane.eye, pane.size)).is_some()
}

/// Draws into `pane` what is switched on.
pub fn paint(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    let Some(slide) = Slide::new(state, state.view(pane.eye, pane.size)) else { return };
    if state.settings.window.resting {
        resting::paint(painter, state, pane, &slide);
    }
    if has_ruler(state, pane) {
        ruler::paint(ui, painter, state, pane, &slide);
    }
}

/// Points per pixel of the picture in `pane`.
fn points_per_px(pane: EyePane) -> Vec2 {
    let [width, height] = pane.size;
    pane.rect.size() / Vec2::new(width as f32, height as f32)
}
