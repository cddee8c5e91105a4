//! The screen: how comfortably two eyes fuse what is on it, and how large and how far away it is.

use eframe::egui::{Button, Ui};

use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, SettingsCommand, WindowCommand};
use crate::app::panels::{Commands, OnClick as _, on_change, stereoscope_button};
use crate::app::state::State;
use crate::app::widgets::theme;
use crate::app::widgets::{STEREOSCOPE_TIP, dot, named_text, number, row};
use crate::flags::{SCREEN_CM, ScreenWidth};
use crate::number_text;
use crate::settings::{MotionSettings, VIEWING_CM, about};

/// Shows the controls of the screen.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    meter(ui, state);
    narrow(ui, state, commands);
    place(ui, state, commands);
}

const TIP: &str = "Disparities of all bodies in both views, as angles from where you sit: from the least \
    to the greatest across, and the greatest up or down.\nUp to 1° across is comfortable; few people can \
    fuse more than 2°, or 20′ up or down.";

/// Note in place of the gauge where two pictures of one eye are compared.
const NO_PAIR: &str =
    "Both views are the left eye's, side by side to be compared: they are not a pair to fuse.";

/// Computed only while it is in sight.
fn meter(ui: &mut Ui, state: &State) {
    row(ui, "Fusing", TIP, |ui| {
        if state.document.settings.is_comparing() {
            named_text(ui, "two pictures of one eye", "Fusing: two pictures of one eye")
                .on_hover_text(NO_PAIR);
            return;
        }
        let is_hidden =
            !state.document.settings.window.views || !ui.is_rect_visible(ui.available_rect_before_wrap());
        let comfort = if is_hidden { None } else { state.comfort(state.document.settings.motion.d) };
        let Some(comfort) = comfort else {
            named_text(ui, number_text::NONE, "Fusing: nothing to fuse").on_hover_text(TIP);
            return;
        };
        dot(ui, theme::verdict_colour(comfort.verdict(), ui.visuals()));
        let text = comfort.words();
        named_text(ui, &text, format!("Fusing: {text}")).on_hover_text(TIP);
    });
}

fn narrow(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let tip = "Brings the eyes together until the range across is at most 1°, at the present T. It changes \
        what is measured: all disparities shrink with d.";
    let motion = state.document.settings.motion;
    let narrowed = state.scratch.narrowed.filter(|[_, d]| *d == motion.d);
    row(ui, "", "", |ui| {
        let is_pair = !state.document.settings.is_comparing();
        let button = ui.add_enabled(is_pair, Button::new("Comfortable"));
        button.on_hover_text(tip).on_disabled_hover_text(NO_PAIR).on_click(commands, SettingsCommand::Narrow);
        if let Some([wide, _]) = narrowed {
            ui.button("As before")
                .on_hover_text("Restores the eye separation.")
                .on_click(commands, SettingsCommand::Motion(MotionSettings { d: wide, ..motion }));
        }
    });
    if let Some([wide, d]) = narrowed {
        let unit = state.measures().length;
        let [wide, d] =
            [wide, d].map(|d| number_text::trimmed(unit.shown(d), unit.decimals(4)) + &unit.suffix());
        ui.label(format!("d narrowed from {wide} to {d}: measured disparities shrink with it."));
    }
}

fn place(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut screen = state.document.settings.screen;
    let tip = about("screen-width");
    row(ui, "Screen", tip, |ui| {
        let mut is_auto = screen.screen_width.0.is_none();
        let mut width = screen.screen_width.0.unwrap_or(USUAL_WIDTH_CM);
        let field = number(&mut width).range(SCREEN_CM).speed(1.0).max_decimals(1).suffix(" cm wide");
        let changed = ui.add_enabled(!is_auto, field).on_hover_text(tip).accessible_name("Screen width");
        if ui.checkbox(&mut is_auto, "auto").on_hover_text(tip).changed() || changed.changed() {
            screen.screen_width = ScreenWidth(Some(width).filter(|_| !is_auto));
        }
    });
    row(ui, "", "", |ui| {
        let field = number(&mut screen.viewing_distance).range(VIEWING_CM).speed(1.0).max_decimals(1);
        ui.add(field.suffix(" cm away"))
            .on_hover_text(about("viewing-distance"))
            .accessible_name("Viewing distance");
    });
    row(ui, "Audience", "Shows the views to an audience.", |ui| {
        let tip = "Fills the screen with the views, one plot and words, all large. Esc leaves.";
        let tip = with_keys(tip, &[Command::Window(WindowCommand::TogglePresenting)]);
        ui.button("Present").on_hover_text(tip).on_click(commands, WindowCommand::TogglePresenting);
        let mut is_open = state.session.stage.projector;
        let tip = with_keys(PROJECTOR_TIP, &[Command::Window(WindowCommand::ToggleProjector)]);
        ui.checkbox(&mut is_open, "second window").on_hover_text(tip);
        on_change(commands, &state.session.stage.projector, is_open, |_| WindowCommand::ToggleProjector);
    });
    row(ui, "Lenses", STEREOSCOPE_TIP, |ui| stereoscope_button(ui, commands));
    on_change(commands, &state.document.settings.screen, screen, SettingsCommand::Screen);
}

const PROJECTOR_TIP: &str = "Shows the views, and a lesson's words, in a window for a projector, on the other screen if there is one, while the controls stay here. Keys and mouse \
    work there, too.";

/// Width of a screen on a desk, cm: what is changed first where none is set.
const USUAL_WIDTH_CM: f64 = 53.0;
