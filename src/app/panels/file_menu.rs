//! The menu of all that enters and leaves the window.

use eframe::egui::{Button, Ui};

use super::Asks;
use crate::app::actions::{ACTIONS, Action};
use crate::app::chooser::{Product, Purpose};
use crate::app::command::Command;
use crate::app::saving::Copied;
use crate::app::state::State;
use crate::settings::PlotTab;

/// Shows the menu's button.
pub fn show(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let menu = ui.menu_button("File", |ui| {
        ui.set_min_width(230.0);
        let fits = state.settings.window.plots && state.settings.plots.plot == PlotTab::Fit;
        let save = |product| Command::Choose(Purpose::Save(product));
        let mut entry =
            |ui: &mut Ui, is_there, name, tip, command| entry(ui, is_there, name, tip, command, asks);
        entry(
            ui,
            true,
            "Open…",
            "A scene, a state, a picture by this program, or data as CSV.",
            Command::Choose(Purpose::Open),
        );
        entry(ui, true, "Own data…", "Fits measured disparities.", Command::Choose(Purpose::OpenData));
        ui.separator();
        entry(
            ui,
            true,
            "Save picture…",
            "The views as they are, as PNG. It remembers its state.",
            save(Product::Picture),
        );
        entry(
            ui,
            true,
            "Save film…",
            "T runs through its range once, as GIF, PNG or a folder of pictures.",
            save(Product::Film),
        );
        entry(ui, fits, "Save fit…", "What the Fit tab found, as JSON.", save(Product::Fit));
        entry(ui, true, "Save state…", "All that is set, as TOML.", save(Product::State));
        ui.separator();
        entry(ui, true, "Copy picture", "The views as they are.", Command::Copy(Copied::Picture));
        entry(
            ui,
            true,
            "Copy values",
            "What both eyes see of the selected point at T, for a spreadsheet.",
            Command::Copy(Copied::Values),
        );
        entry(
            ui,
            true,
            "Copy command",
            "The `gamow` line that opens a window that shows this.",
            Command::Copy(Copied::Command),
        );
        entry(
            ui,
            true,
            "Copy render command",
            "The `gamow render` line that draws this picture.",
            Command::Copy(Copied::RenderCommand),
        );
        entry(
            ui,
            true,
            "Copy curve command",
            "The `gamow curve` line that gives the numbers of the selected point's curves.",
            Command::Copy(Copied::CurveCommand),
        );
    });
    menu.response.on_hover_text("Open, save and copy.");
}

/// An entry of the menu, with the keys that do the same.
fn entry(ui: &mut Ui, is_there: bool, name: &str, tip: &str, command: Command, asks: &mut Asks) {
    let keys = ACTIONS.iter().find(|action| action.command == command).map(Action::keys_text);
    let button = Button::new(name).shortcut_text(keys.unwrap_or_default());
    let response =
        ui.add_enabled(is_there, button).on_hover_text(tip).on_disabled_hover_text("In the Fit tab.");
    if response.accessible_name(name).clicked() {
        asks.push(command);
    }
}
