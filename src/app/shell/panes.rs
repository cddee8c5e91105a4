//! The panes of the views: which pictures stand in them, what reads the mouse in them, and what draws them.

use eframe::egui::{Rect, TextureId, Ui, UiBuilder, vec2};

use relativity_render::{Gpu, Method};

use crate::app::panels;
use crate::app::panels::views::Painted;
use crate::app::shell::App;
use crate::app::state::measuring::stopwatch::Stopwatch;
use crate::app::views::corrected::{Corrected, CorrectedKey};
use crate::app::views::examination::{Examination, ExaminedViews};
use crate::app::views::eyes::{EyePictures, Request, ShownPicture};
use crate::app::views::flicker;
use crate::app::views::panes::{EyePane, Pane, PaneContent, on_screen};
use crate::app::views::slide::panorama;
use crate::app::widgets::theme;
use crate::flags::choices::Form;
use crate::settings::{Canvas, PlotTab, Settings};

/// The name of what reads the mouse in `pane`, and draws into it.
const fn pane_id(pane: EyePane) -> &'static str {
    if pane.is_second { "Second picture" } else { pane.eye.name() }
}

impl App {
    /// Returns the places of the eyes' pictures in `pane`, in the order of the layout.
    pub(in crate::app) fn eye_panes(&self, ui: &Ui, pane: &Pane) -> Vec<EyePane> {
        let largest = self.eyes.as_ref().map_or(1, EyePictures::largest_side);
        let scale = ui.pixels_per_point();
        let panes = match pane.content {
            PaneContent::Eye(eye) => vec![EyePane::new(eye, pane.rect, scale, largest)],
            PaneContent::Second => vec![EyePane::second(pane.rect, scale, largest)],
            PaneContent::Both => {
                EyePane::both(&self.state.document.settings.picture, pane.rect, scale, largest).into()
            }
            PaneContent::Corrected => Vec::new(),
        };
        panes.into_iter().map(|eye_pane| eye_pane.of(pane)).collect()
    }

    /// Returns the place of the first picture of an eye in `panes`.
    pub(in crate::app) fn first_eye_pane(&self, ui: &Ui, panes: &[Pane]) -> Option<EyePane> {
        panes.iter().find_map(|pane| self.eye_panes(ui, pane).first().copied())
    }

    /// Notes how large the eyes' pictures are, and how the eyes look: fields of view are fitted to that of
    /// the first.
    pub(in crate::app) fn measure_pictures(&mut self, ui: &Ui, panes: &[Pane]) {
        if let Some(pane) = self.first_eye_pane(ui, panes) {
            self.state.frame_mut().picture = Canvas { size: pane.size, keeps_height: !pane.is_in_window() };
            self.state.note_looks();
        }
    }

    /// Reads the mouse in `pane`.
    pub(in crate::app) fn interact(&mut self, ui: &mut Ui, pane: Pane) {
        for pane in self.eye_panes(ui, &pane).into_iter().filter(EyePane::takes_the_mouse) {
            let name = self.state.name_of_view(pane);
            self.show_panel(ui, pane_id(pane), pane.rect, |ui, state, commands| {
                panels::views::interact(ui, state, pane, &name, commands);
            });
        }
    }

    /// Draws all `panes`, the line that joins the strips of a panorama, and the button that offers one.
    pub(in crate::app) fn paint_all(&mut self, ui: &mut Ui, panes: &[Pane]) {
        let is_left = self.fade.begins(ui.ctx(), &self.state, panes.len());
        if let Some(eyes) = self.eyes.as_mut().filter(|_| is_left) {
            eyes.set_aside();
        }
        for &pane in panes {
            self.paint(ui, pane);
        }
        self.paint_fade(ui, panes);
        let first = panes
            .first()
            .and_then(|pane| self.eye_panes(ui, pane).into_iter().find(EyePane::takes_the_mouse));
        if let Some(pane) = first.filter(|_| self.state.scratch.stopwatch != Stopwatch::Hidden) {
            self.show_panel(ui, "stopwatch", pane.rect, |ui, state, commands| {
                panels::stopwatch::show(ui, state, pane, commands);
            });
        }
        if self.state.document.settings.is_panorama() && !self.state.document.settings.is_comparing() {
            let strips: Vec<_> = panes.iter().flat_map(|pane| self.eye_panes(ui, pane)).collect();
            if let &[upper, lower] = strips.as_slice() {
                panorama::join(ui, &self.state, [upper, lower]);
            }
        }
        let titled = panes.iter().filter(|pane| pane.title.is_in_window()).map(|pane| pane.rect);
        let Some(area) = titled.reduce(Rect::union) else { return };
        let height = theme::text_scale(ui.style()) * theme::TITLE_HEIGHT;
        let strip = Rect::from_min_max(area.min - vec2(0.0, height), area.right_top());
        if panels::panorama::is_offered(&self.state, area) {
            self.show_panel(ui, "panorama", strip, |ui, state, commands| {
                panels::panorama::offer(ui, state, strip, commands);
            });
        }
        self.show_panel(ui, "fusing", strip, |ui, state, commands| {
            panels::fusing::offer(ui, state, strip, commands);
        });
    }

    /// Draws what is left of the last pictures over those in `panes`.
    fn paint_fade(&mut self, ui: &Ui, panes: &[Pane]) {
        let area = panes.iter().map(|pane| pane.rect).reduce(Rect::union).unwrap_or(Rect::NOTHING);
        if self.fade.paint(ui, area)
            && let Some(eyes) = &mut self.eyes
        {
            eyes.forget_set_aside();
        }
    }

    /// Draws the contents of `pane`.
    fn paint(&mut self, ui: &mut Ui, pane: Pane) {
        match (pane.content, self.eye_panes(ui, &pane).as_slice()) {
            (PaneContent::Both, &[first, second]) => self.paint_both(ui, [first, second]),
            (PaneContent::Corrected, _) => self.show_corrected(ui, pane),
            (_, panes) => panes.iter().for_each(|&pane| {
                let title = self.state.title_of(pane);
                // What is drawn in both pictures of one eye has a name of its own in each.
                let within = UiBuilder::new().id_salt(pane_id(pane)).max_rect(pane.rect);
                let second = pane.is_second.then(|| ui.new_child(within));
                self.in_picture(pane, |app| app.paint_eye(second.as_ref().unwrap_or(ui), pane, &title));
            }),
        }
    }

    /// Returns what is `done` with the settings of the picture in `pane`.
    fn in_picture<R>(&mut self, pane: EyePane, done: impl FnOnce(&mut Self) -> R) -> R {
        let kept = self.state.enter(pane.is_second);
        let given = done(self);
        self.state.leave(kept);
        given
    }

    /// Returns the request for the picture in `pane`.
    fn request(&self, ui: &Ui, pane: EyePane) -> Request {
        let state = &self.state;
        let view = state.view(pane.eye, pane.size);
        let (method, at_once) = self.drawn_by(view.geometry);
        Request {
            view,
            appearance: state.appearance(!ui.visuals().dark_mode),
            scene: state.document.prepared.clone(),
            method,
            at_once,
            refine: self.may_refine(),
        }
    }

    /// Returns the error of the picture of `request` in `pane`, where it is shown.
    fn heat_map(&mut self, ui: &Ui, pane: EyePane, request: &Request) -> Option<TextureId> {
        let is_examined = self.state.document.settings.plots.heat_map && !pane.is_second;
        let examination = self.examination.as_mut().filter(|_| is_examined)?;
        let method = self.state.method(&request.view).of_view(&request.view);
        examination.heat_map(ui.ctx(), pane.eye, method).map(Into::into)
    }

    /// Draws `pane` below its `title`: the up-to-date picture, how far it is off, and the markers.
    fn paint_eye(&mut self, ui: &Ui, pane: EyePane, title: &str) {
        let (picture, request) = self.drawn_picture(ui, pane);
        self.note_shown(pane.rect, picture);
        let heat_map = self.heat_map(ui, pane, &request);
        panels::views::paint(ui, &self.state, pane, title, Painted { picture, heat_map });
    }

    /// Returns the up-to-date picture in `pane`, and the request for it.
    fn drawn_picture(&mut self, ui: &Ui, pane: EyePane) -> (Option<ShownPicture>, Request) {
        let request = self.request(ui, pane);
        let picture = self.eyes.as_mut().and_then(|eyes| eyes.picture(ui.ctx(), pane.index(), &request));
        self.note_waiting();
        (picture, request)
    }

    /// Notes that a picture is shown in `rect`, which it will leave.
    fn note_shown(&mut self, rect: Rect, picture: Option<ShownPicture>) {
        if let Some(ShownPicture { texture, .. }) = picture {
            self.fade.note(rect, texture);
        }
    }

    /// Notes whether a picture of this frame waits for what draws it.
    fn note_waiting(&mut self) {
        let is_waiting = self.eyes.as_mut().is_some_and(EyePictures::take_waiting);
        self.state.frame_mut().is_getting_ready |= is_waiting;
    }

    /// Draws the up-to-date picture in `pane` alone.
    pub(in crate::app) fn paint_bare(&mut self, ui: &Ui, pane: EyePane) {
        let (picture, _) = self.drawn_picture(ui, pane);
        panels::views::paint_bare(ui, &self.state, pane, picture);
    }

    /// Draws the picture that both eyes share, and the markers of both, or of the one whose turn it is.
    fn paint_both(&mut self, ui: &Ui, panes: [EyePane; 2]) {
        let Form::Composed(composition) = self.state.document.settings.picture.layout.form() else {
            let pane = panes[flicker::turn(ui.ctx())];
            let request = self.request(ui, pane);
            let picture =
                self.eyes.as_mut().and_then(|eyes| eyes.picture(ui.ctx(), pane.eye.index(), &request));
            self.note_waiting();
            let heat_map = self.heat_map(ui, pane, &request);
            return panels::views::paint_both(ui, &self.state, &[pane], picture, &[heat_map]);
        };
        let composition = on_screen(ui, composition, panes[0].rect);
        let requests = panes.map(|pane| self.request(ui, pane));
        let [first, second] = [0, 1].map(|i: usize| (panes[i].eye.index(), &requests[i]));
        let picture =
            self.eyes.as_mut().and_then(|eyes| eyes.composed(ui.ctx(), composition, [first, second]));
        self.note_waiting();
        self.note_shown(panes[0].rect.union(panes[1].rect), picture);
        let heat_maps = [0, 1].map(|i: usize| {
            if panes[i].takes_the_mouse() { self.heat_map(ui, panes[i], &requests[i]) } else { None }
        });
        panels::views::paint_both(ui, &self.state, &panes, picture, &heat_maps);
    }

    /// Shows the left eye's picture in `pane`, corrected by the fitted speed while there is a fit in view.
    fn show_corrected(&mut self, ui: &Ui, pane: Pane) {
        let Settings { plots, window, .. } = *self.state.document.settings;
        let fit = self.fitting.shown().filter(|_| window.plots && plots.plot == PlotTab::Fit);
        let correction = self.state.correction(fit);
        let size = (pane.rect.size() * ui.pixels_per_point()).round();
        let job = CorrectedKey {
            view: self.state.view_to_correct([size.x, size.y].map(|side| side.max(1.0) as u32)),
            speed: correction.speed,
            appearance: self.state.appearance(!ui.visuals().dark_mode),
        };
        let corrected = self.corrected.get_or_insert_with(|| Corrected::new(ui.ctx()));
        corrected.request(&self.state.document.prepared, &job);
        panels::corrected::show(ui, pane, &correction, corrected.newest());
    }

    /// Gives up the one picture of both eyes unless one of the `panes` shows it.
    pub(in crate::app) fn forget_composed(&mut self, panes: &[Pane]) {
        let is_shown = panes.iter().any(|pane| pane.content == PaneContent::Both);
        if let Some(eyes) = self.eyes.as_mut().filter(|_| !is_shown) {
            eyes.forget_composed();
        }
    }

    /// Examines the pictures in `panes` while their figures are in view.
    pub(in crate::app) fn update_examination(&mut self, ui: &Ui, panes: &[Pane], plots_are_shown: bool) {
        if !plots_are_shown || self.state.document.settings.plots.plot != PlotTab::Accuracy {
            self.examination.iter_mut().for_each(Examination::rest);
            return;
        }
        let state = &self.state;
        let panes = panes.iter().flat_map(|pane| self.eye_panes(ui, pane));
        let exact = panes.filter(|pane| !pane.is_second && !state.sees_as_published(pane.eye));
        let sight = ExaminedViews {
            views: exact.map(|pane| (pane.eye, state.view(pane.eye, pane.size))).collect(),
            appearance: state.appearance(!ui.visuals().dark_mode),
            scene: state.document.prepared.clone(),
        };
        let chosen = sight.views.first().map_or(Method::Rays, |(_, view)| state.method(view));
        let gpu = self.eyes.as_ref().map(|eyes| eyes.gpu().clone()).filter(Gpu::reads_back);
        let examination = self.examination.get_or_insert_with(|| Examination::new(ui.ctx(), gpu));
        examination.update(ui.ctx(), &sight, chosen);
    }
}
