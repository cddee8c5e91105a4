//! The button that changes to the panorama and back.

use eframe::egui::{Align, Rect, Ui};

use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, SettingsCommand, Switch};
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::State;
use crate::app::widgets::strip_button;
use crate::app::widgets::theme;
use crate::flags::choices::{Form, ProjectionChoice};

/// A views' area at least this many times as wide as high offers the panorama.
const WIDE: f32 = 2.0;

/// From the left end of a title to beyond the longest name of an eye, points.
const AFTER_NAME: f32 = 100.0;

/// Whether a views' area of this shape has the button that changes to the panorama and back.
pub fn is_offered(state: &State, area: Rect) -> bool {
    let settings = &state.document.settings;
    let is_wide = area.width() >= WIDE * area.height();
    let can_be = settings.projection() == ProjectionChoice::Mercator
        && matches!(settings.picture.layout.form(), Form::Beside | Form::Above);
    // Two pictures of one eye have a title that needs the room.
    let can_be = can_be && !settings.is_comparing();
    let is_presented = state.session.stage.is_presented();
    can_be && (settings.is_panorama() || is_presented || is_wide && !settings.window.simple)
}

/// Shows the button in the title strip `strip`, after the name of the left eye.
pub fn offer(ui: &mut Ui, state: &State, strip: Rect, commands: &mut Commands) {
    let is_panorama = state.document.settings.is_panorama();
    let (name, tip) = if is_panorama {
        ("Two views", "Leaves the panorama.")
    } else {
        (
            "Panorama",
            "Shows the whole passage at once, the left eye's strip above the right eye's. The columns of a point differ by its \
             disparity.",
        )
    };
    let after_name = strip.with_min_x(strip.min.x + theme::text_scale(ui.style()) * AFTER_NAME);
    strip_button(ui, after_name, Align::Min, name)
        .on_hover_text(with_keys(tip, &[Command::Settings(SettingsCommand::Switch(Switch::Panorama))]))
        .on_click(commands, SettingsCommand::Switch(Switch::Panorama));
}
