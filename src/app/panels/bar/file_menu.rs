//! The menu of all that enters and leaves the window.

use eframe::egui::{Button, Ui};

use crate::app::actions::{ACTIONS, Action};
use crate::app::command::Command;
use crate::app::file_dialog::purpose::{Product, Purpose};
use crate::app::orders::Copied;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::settings::PlotTab;

/// Width of the menu, points.
const WIDTH: f32 = 230.0;

/// An entry: its label, its command, and its tooltip.
type Entry = (&'static str, Command, &'static str);

const OPEN: [Entry; 2] = [
    ("Open…", Command::Choose(Purpose::Open), "A scene, a state, a picture by this program, or data as CSV."),
    ("Own data…", Command::Choose(Purpose::OpenData), "Fits measured disparities, as CSV."),
];

const SAVE: [Entry; 10] = [
    ("Save picture…", save(Product::Picture), "The views as they are, as PNG. It remembers its state."),
    ("Save plots as SVG…", save(Product::PlotsSvg), "What the shown tab plots, as a drawing."),
    ("Save plots as CSV…", save(Product::PlotsCsv), "What the shown tab plots, as a table."),
    ("Save fit…", save(Product::Fit), "What the Fit tab found, as JSON."),
    (
        "Save film…",
        save(Product::Film),
        "T runs through its range once: a GIF, an animated PNG, or a folder of pictures.",
    ),
    ("Save state…", save(Product::State), "All that is set, as TOML."),
    (
        "Report of the lesson…",
        save(Product::Report),
        "What was predicted and seen in each step, as a page to keep or to print.",
    ),
    (
        "Worksheet of the lesson…",
        save(Product::Worksheet),
        "The questions with room for answers, as a page to print.",
    ),
    (
        "Lab of the lesson…",
        save(Product::LabSheet),
        "What is measured by hand, with its data, as a page to print.",
    ),
    (
        "Teacher’s page of the lesson…",
        save(Product::TeachersPage),
        "Aim, minutes, what to say, and the answers, as a page to print.",
    ),
];

const COPY: [Entry; 6] = [
    ("Copy picture", Command::Copy(Copied::Picture), "The views as they are."),
    (
        "Copy values",
        Command::Copy(Copied::Values),
        "What both eyes see of the selected point at T, for a spreadsheet.",
    ),
    (
        "Copy link",
        Command::Copy(Copied::Link),
        "One line, gamow:?…, that says all that is shown: Open…, `gamow --state` and `gamow render --state` take it.",
    ),
    ("Copy command", Command::Copy(Copied::Command), "The `gamow` line that opens a window that shows this."),
    (
        "Copy render command",
        Command::Copy(Copied::RenderCommand),
        "The `gamow render` line that draws this picture.",
    ),
    (
        "Copy curve command",
        Command::Copy(Copied::CurveCommand),
        "The `gamow curve` line that gives the numbers of the selected point's curves.",
    ),
];

const fn save(product: Product) -> Command {
    Command::Choose(Purpose::Save(product))
}

/// Shows the menu's button.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let menu = ui.menu_button("File", |ui| {
        ui.set_min_width(WIDTH);
        for (number, entries) in [&OPEN[..], &SAVE, &COPY].into_iter().enumerate() {
            if number > 0 {
                ui.separator();
            }
            for one in entries {
                entry(ui, state, one, commands);
            }
        }
    });
    menu.response.on_hover_text("Open, save and copy.");
}

/// An entry of the menu, with the keys that do the same.
fn entry(ui: &mut Ui, state: &State, (name, command, tip): &Entry, commands: &mut Commands) {
    let keys = ACTIONS.iter().find(|action| action.command == *command).map(Action::keys_text);
    let button = Button::new(*name).shortcut_text(keys.unwrap_or_default());
    let obstacle = obstacle(state, command);
    let response = ui.add_enabled(obstacle.is_none(), button).on_hover_text(*tip);
    let response = response.on_disabled_hover_text(obstacle.unwrap_or_default());
    if response.accessible_name(*name).clicked() {
        commands.push(command.clone());
    }
}

/// Why something cannot be saved as things are.
fn obstacle(state: &State, command: &Command) -> Option<&'static str> {
    let settings = &state.document.settings;
    let (is_plotted, tab) = (settings.window.plots, settings.plots.plot);
    let Command::Choose(Purpose::Save(product)) = command else { return None };
    match product {
        Product::PlotsSvg | Product::PlotsCsv if !is_plotted => Some("The plots are hidden."),
        Product::PlotsSvg if tab == PlotTab::Accuracy => Some("This tab is a table: save it as CSV."),
        Product::Fit if !is_plotted || tab != PlotTab::Fit => Some("It is made in the Fit tab."),
        Product::Report if state.course().is_none() => Some("No lesson is gone through."),
        _ if product.sheet().is_some() => match state.course() {
            None => Some("No lesson is gone through."),
            Some(course) if *product == Product::LabSheet && course.lesson().lab.is_none() => {
                Some("This lesson has no lab.")
            }
            Some(_) => None,
        },
        _ => None,
    }
}
