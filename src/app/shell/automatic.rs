//! The automatic choice of the method that draws the views of a frame.

use eframe::egui::Ui;
use relativity_render::{Geometry, Method};

use crate::accuracy::MethodViews;
use crate::app::shell::App;
use crate::app::views::examination::Examination;
use crate::app::views::eyes::{Chosen, EyePictures};
use crate::app::views::panes::{EyePane, Pane};
use crate::flags::choices::RendererChoice;

impl App {
    /// Chooses what draws the pictures in `panes` in this frame: one method for all views of a geometry.
    pub(in crate::app) fn choose_methods(&mut self, ui: &Ui, panes: &[Pane]) {
        let panes: Vec<_> = panes.iter().flat_map(|pane| self.eye_panes(ui, pane)).collect();
        let is_automatic = self.state.document.settings.quality.renderer == RendererChoice::Auto;
        let state = &mut self.state;
        let mut view =
            |pane: &EyePane| state.of_picture(pane.is_second, |state| state.view(pane.eye, pane.size));
        let views: Vec<_> = panes.iter().filter(|_| is_automatic).map(&mut view).collect();
        let Some(eyes) = &mut self.eyes else { return };
        eyes.begin_frame(is_automatic);
        self.chosen.clear();
        let (goal, scene) = (self.state.document.settings.quality.goal, &self.state.document.prepared);
        let pixels = |size: [u32; 2]| f64::from(size[0]) * f64::from(size[1]);
        let pixels = panes.iter().map(|pane| pixels(pane.size)).sum();
        for view in &views {
            if self.chosen.iter().all(|(geometry, _)| *geometry != view.geometry) {
                let chosen = eyes.choose(goal, MethodViews { scene, view, pixels });
                self.chosen.extend(chosen.map(|chosen| (view.geometry, chosen)));
            }
        }
        if self.chosen.iter().any(|(_, chosen)| chosen.method != chosen.choice.method) {
            // What was tried does not stay on screen.
            ui.ctx().request_repaint();
        }
        let choice = |(geometry, chosen): &(Geometry, Chosen)| (*geometry, chosen.choice);
        self.state.frame_mut().choices = self.chosen.iter().map(choice).collect();
    }

    /// Returns the method that draws views of this `geometry` in this frame, and whether the reference does
    /// so within it.
    pub(in crate::app) fn drawn_by(&self, geometry: Geometry) -> (Method, bool) {
        let chosen = self.chosen.iter().find_map(|(of, chosen)| (*of == geometry).then_some(chosen));
        let set = self.state.document.settings.quality.method();
        match (set, chosen) {
            (Some(method), _) => (method, false),
            (None, Some(chosen)) => (chosen.method, chosen.at_once()),
            (None, None) => (Method::Rays, false),
        }
    }

    /// Whether pictures may get smoother: where the mesh is set, its errors are to be seen, and what is
    /// measured is not to be disturbed.
    pub(in crate::app) fn may_refine(&self) -> bool {
        let quality = self.state.document.settings.quality;
        let is_measuring = self.examination.as_ref().is_some_and(Examination::is_pending);
        self.refines && quality.refine && quality.renderer != RendererChoice::Mesh && !is_measuring
    }

    /// Returns this window without refinement of still views, each drawn in full, so that its pictures do not
    /// depend on how long they have been shown, nor on how fast they are drawn.
    #[must_use]
    pub fn without_refinement(self) -> Self {
        Self { refines: false, eyes: self.eyes.map(EyePictures::in_full), ..self }
    }

    /// Returns this window with rays only where somebody asks for them.
    #[must_use]
    pub fn without_automatic_rays(self) -> Self {
        Self { eyes: self.eyes.map(EyePictures::without_automatic_rays), ..self }
    }

    /// Whether pictures are as smooth as they get.
    #[must_use]
    pub fn is_refined(&self) -> bool {
        self.eyes.as_ref().is_none_or(EyePictures::is_refined)
    }
}
