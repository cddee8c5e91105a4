//! The window as the screen of a stereoscope, such as a phone in a viewer with two lenses: each eye's picture in its half, the middles as far apart as
//! the lenses, and both turned with the head as far as the device tells how it is turned.

mod card;
mod lenses;
mod menu;
pub mod orientation;

use eframe::egui::{Color32, Id, Rect, Sense, Ui};
use relativity_render::Gaze;

use self::card::{Card, Match};
use self::menu::{Choice, Known};
use self::orientation::Orientation;
use super::command::Command;
use super::panels::Commands;
use super::state::shared::Shared;
use super::views::panes::{Content, Pane};
use super::{App, views};
use crate::eye::Eye;
use crate::flags::{SCREEN_CM, ScreenWidth};
use crate::settings::{Head, Screen};

/// Steepest gaze by dragging, radians.
const STEEPEST: f64 = 1.4;

/// A stereoscope while it is shown.
#[derive(Debug)]
pub struct Stereoscope {
    page: Page,
    /// Gaze that is straight before the viewer: towards what the views showed.
    ahead: Gaze,
    /// Orientation of the device, where it tells that.
    device: Option<Orientation>,
    /// Angle from the device's axes to those of the scene, to the left, radians; unset until the device is held towards what is ahead.
    heading: Option<f64>,
}

/// The page of a stereoscope.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Page {
    Pictures,
    Menu,
    Card(Card),
}

/// The pictures of a stereoscope on the screen.
struct Pictures {
    rects: [Rect; 2],
    /// Field of view of each, degrees.
    fov: f64,
}

impl Stereoscope {
    /// The stereoscope that is entered with the views' `gaze`.
    const fn new(gaze: Gaze) -> Self {
        Self { page: Page::Menu, ahead: gaze, device: None, heading: None }
    }

    /// Returns the head before the screen, in the scene's axes.
    fn head(&mut self) -> Head {
        let Some(device) = self.device else { return Head::level(self.ahead) };
        let head = device.head();
        let heading = *self.heading.get_or_insert_with(|| self.ahead.azimuth - head.gaze().azimuth);
        head.turned(heading)
    }

    /// Has the device, as it is held, look as far aside as `gaze` does.
    const fn look_along(&mut self, gaze: Gaze) {
        (self.ahead, self.heading) = (gaze, None);
    }

    /// Turns the head to the left and up, by angles in radians: up only where the device does not tell how it is turned.
    fn turn(&mut self, [left, up]: [f64; 2]) {
        if let Some(heading) = &mut self.heading {
            *heading += left;
        } else {
            let Gaze { azimuth, elevation } = self.ahead;
            self.ahead =
                Gaze { azimuth: azimuth + left, elevation: (elevation + up).clamp(-STEEPEST, STEEPEST) };
        }
    }
}

impl App {
    /// Takes the orientation that the device tells: alpha, beta, gamma and the turn of what is shown, degrees. Without a stereoscope it changes nothing.
    pub fn turn_device(&mut self, angles: [f64; 4]) {
        if let Some(stereoscope) = &mut self.stereoscope {
            stereoscope.device = Orientation::from_degrees(angles).or(stereoscope.device);
        }
    }

    /// Shows the stereoscope in all of `area`.
    pub(super) fn show_stereoscope(&mut self, ui: &mut Ui, area: Rect) {
        self.fitting.rest();
        self.update_examination(ui, &[], false);
        self.corrected = None;
        ui.painter().rect_filled(area, 0.0, Color32::BLACK);
        let entered = self.stereoscope.take();
        let mut stereoscope = entered.unwrap_or_else(|| Stereoscope::new(self.state.gaze()));
        match stereoscope.page {
            Page::Card(mut card) => {
                let answer = card.show(ui, area);
                stereoscope.page = if answer == Match::Open { Page::Card(card) } else { Page::Menu };
                if let Match::Found(points_per_mm) = answer {
                    self.measure_screen(ui, points_per_mm);
                }
            }
            Page::Pictures | Page::Menu => self.show_pictures(ui, area, &mut stereoscope),
        }
        self.stereoscope = Some(stereoscope);
        self.message(ui.ctx(), area, area);
    }

    /// Returns the size of a millimetre on the screen, points.
    fn points_per_mm(&self, ui: &Ui) -> f64 {
        0.1 / (self.state.frame.cm_per_pixel * f64::from(ui.pixels_per_point()))
    }

    /// Sets the width of the screen from the size of a millimetre on it, points.
    fn measure_screen(&mut self, ui: &Ui, points_per_mm: f64) {
        let Some(points) = ui.input(|input| input.viewport().monitor_size) else { return };
        let cm = (0.1 * f64::from(points.x) / points_per_mm).clamp(*SCREEN_CM.start(), *SCREEN_CM.end());
        let screen = Screen { screen_width: ScreenWidth(Some(cm)), ..self.state.document.settings.screen };
        self.apply(ui.ctx(), vec![Command::Screen(screen)]);
    }

    /// Shows the pictures, and the menu or its button over them.
    fn show_pictures(&mut self, ui: &mut Ui, area: Rect, stereoscope: &mut Stereoscope) {
        let screen = self.state.document.settings.screen;
        let points_per_mm = self.points_per_mm(ui);
        let rects = lenses::pictures(area, (points_per_mm * screen.picture_distance) as f32);
        let width_mm = f64::from(rects[0].width()) / points_per_mm;
        let pictures = Pictures { rects, fov: lenses::field_of_view(width_mm, screen.lens_to_screen) };
        self.touch(ui, area, &pictures, stereoscope);
        self.paint_pictures(ui, &pictures, &stereoscope.head());
        let mut commands = Commands::new();
        let choice = if stereoscope.page == Page::Menu {
            let known = Known {
                is_turned: stereoscope.device.is_some(),
                takes_card: ui.input(|input| input.viewport().monitor_size).is_some(),
                is_measured: screen.screen_width.0.is_some(),
            };
            menu::show(ui.ctx(), screen, known, &mut commands)
        } else {
            menu::button(ui.ctx())
        };
        stereoscope.page = match choice {
            Choice::Pictures => Page::Pictures,
            Choice::Menu => Page::Menu,
            Choice::Card => Page::Card(Card::new(points_per_mm)),
        };
        self.apply(ui.ctx(), commands);
    }

    /// Reads a finger on the pictures: a tap plays or pauses, a drag turns the head.
    fn touch(&mut self, ui: &Ui, area: Rect, pictures: &Pictures, stereoscope: &mut Stereoscope) {
        let response = ui.interact(area, Id::unique("stereoscope"), Sense::click_and_drag());
        if response.clicked() {
            if !self.state.scratch.playing && stereoscope.device.is_some() {
                stereoscope.look_along(self.state.gaze());
            }
            self.apply(ui.ctx(), vec![Command::TogglePlaying]);
        }
        if response.dragged() {
            let per_point = lenses::radians_per_point(pictures.rects[0].width(), pictures.fov);
            let moved = response.drag_delta();
            stereoscope.turn([moved.x, moved.y].map(|points| per_point * f64::from(points)));
        }
    }

    /// Draws both pictures as this `head` sees them. What the document shows stays as it is.
    fn paint_pictures(&mut self, ui: &mut Ui, pictures: &Pictures, head: &Head) {
        let settings = self.state.document.settings.before_head(head, pictures.fov);
        let own = std::mem::replace(&mut self.state.document.settings, Shared::from(settings));
        let panes =
            Eye::BOTH.map(|eye| Pane { content: Content::Eye(eye), rect: pictures.rects[eye.index()] });
        self.measure_pictures(ui, &panes);
        self.choose_methods(ui, &panes);
        let eyes: Vec<_> = panes.iter().flat_map(|pane| self.eye_panes(ui, pane)).collect();
        for pane in eyes {
            self.paint_bare(ui, pane);
        }
        self.forget_composed(&panes);
        self.state.document.settings = own;
        views::halo::paint(ui.ctx());
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    fn azimuth(stereoscope: &mut Stereoscope) -> f64 {
        stereoscope.head().gaze().azimuth
    }

    #[test]
    fn what_is_ahead_is_where_the_device_was_held_first_or_at_a_tap() {
        let upright = |alpha| Orientation::from_degrees([alpha, 90.0, 0.0, 0.0]);
        let mut stereoscope = Stereoscope::new(Gaze { azimuth: 1.2, elevation: 0.3 });
        assert!((azimuth(&mut stereoscope) - 1.2).abs() < 1e-12);
        stereoscope.device = upright(200.0);
        let head = stereoscope.head().gaze();
        assert!((head.azimuth - 1.2).abs() < 1e-12 && head.elevation.abs() < 1e-12);
        // To the left by a right angle.
        stereoscope.device = upright(290.0);
        assert!((azimuth(&mut stereoscope) - 1.2 - FRAC_PI_2).abs() < 1e-12);
        stereoscope.look_along(Gaze { azimuth: 0.5, elevation: 0.1 });
        assert!((azimuth(&mut stereoscope) - 0.5).abs() < 1e-12);
        stereoscope.turn([0.25, 1.0]);
        let head = stereoscope.head().gaze();
        assert!((head.azimuth - 0.75).abs() < 1e-12 && head.elevation.abs() < 1e-12);
    }

    #[test]
    fn a_finger_turns_the_head_where_the_device_does_not_tell() {
        let mut stereoscope = Stereoscope::new(Gaze::STRAIGHT_AHEAD);
        stereoscope.turn([0.2, 9.0]);
        let head = stereoscope.head().gaze();
        assert!((head.azimuth - FRAC_PI_2 - 0.2).abs() < 1e-12 && (head.elevation - STEEPEST).abs() < 1e-12);
    }
}
