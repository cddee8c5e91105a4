//! The controls of what is measured with in the views themselves: a ruler, a stopwatch, and a clock to
//! compare others with.

use eframe::egui::{Checkbox, Ui};

use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, SettingsCommand};
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::State;
use crate::app::state::measuring::angle_ruler::{AngleRuler, RulerCommand};
use crate::app::state::measuring::stopwatch::{Stopwatch, StopwatchCommand, TIP};
use crate::app::widgets::row;
use crate::settings::about;

const RULER: &str = "Lays a ruler by the next drag in a view. It shows the angle between the lines of \
    sight to its ends, and stays until you remove it.";

/// Shows the row of measuring tools.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    row(ui, "Measure", "Chooses what to measure with in the views.", |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let is_on = state.scratch.angle_ruler != AngleRuler::Off;
        ui.selectable_label(is_on, "Angle")
            .on_hover_text(with_keys(RULER, &[Command::Ruler(RulerCommand::Toggle)]))
            .on_click(commands, RulerCommand::Toggle);
        let is_on = state.scratch.stopwatch != Stopwatch::Hidden;
        let keys = [StopwatchCommand::Press, StopwatchCommand::Toggle].map(Command::Stopwatch);
        ui.selectable_label(is_on, "Stopwatch")
            .on_hover_text(with_keys(TIP, &keys))
            .on_click(commands, StopwatchCommand::Toggle);
        let mut window = state.document.settings.window;
        let clock = Checkbox::new(&mut window.resting_clock, "clock");
        let reason = "Needs the clocks, which are off.";
        let response = ui
            .add_enabled(window.dials, clock)
            .on_hover_text(about("resting-clock"))
            .on_disabled_hover_text(reason);
        if response.accessible_name("clock beside you").changed() {
            commands.push(SettingsCommand::Window(window).into());
        }
    });
}
