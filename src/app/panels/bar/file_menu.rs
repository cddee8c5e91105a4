//! The menu of all that enters and leaves the window.

use eframe::egui::{Button, Ui};

use crate::app::commands::actions::keys_of;
use crate::app::commands::{Command, FileCommand, WindowCommand};
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::State;
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::state::orders::Copied;
use crate::app::state::overlay::Overlay;
use crate::app::tools::page_link;
use crate::scene::is_model;
use crate::settings::PlotTab;

/// Width of the menu, points.
const WIDTH: f32 = 230.0;

/// An entry: its label, its command, and its tooltip.
type MenuEntry = (&'static str, Command, &'static str);

const OPEN: [MenuEntry; 2] = [
    (
        "Open…",
        Command::File(FileCommand::Choose(Purpose::Open)),
        "Opens a scene, a model, a state, a picture by this program, a lesson, a sequence of your own, or data as CSV.",
    ),
    (
        "Own data…",
        Command::File(FileCommand::Choose(Purpose::OpenData)),
        "Opens measured disparities (CSV) and fits them.",
    ),
];

const SAVE: [MenuEntry; 13] = [
    save("Save picture…", Product::Picture),
    save("Save plots as SVG…", Product::PlotsSvg),
    save("Save plots as CSV…", Product::PlotsCsv),
    save("Save fit…", Product::Fit),
    save("Save film…", Product::Film),
    save("Save film of 10 s…", Product::TenSeconds),
    save("Save state…", Product::State),
    save("Save scene of the model…", Product::Scene),
    save("Report of the lesson…", Product::Report),
    save("Worksheet of the lesson…", Product::Worksheet),
    save("Lab of the lesson…", Product::LabSheet),
    save("Teacher’s page of the lesson…", Product::TeachersPage),
    (
        "Answers of a class…",
        Command::Window(WindowCommand::Toggle(Overlay::Class)),
        "Takes the links with your pupils’ answers, and shows how they have answered.",
    ),
];

fn copy_entries() -> [MenuEntry; 6] {
    [
        ("Copy picture", Command::File(FileCommand::Copy(Copied::Picture)), "Copies the views as they are."),
        (
            "Copy values",
            Command::File(FileCommand::Copy(Copied::Values)),
            "Copies what both eyes see of the selected point at T, for a spreadsheet.",
        ),
        (
            page_link::copying(),
            Command::File(FileCommand::Copy(Copied::Link)),
            "Copies one line, gamow:?…, that holds everything shown. Open…, `gamow --state` and `gamow render \
            --state` take it.",
        ),
        (
            "Copy command",
            Command::File(FileCommand::Copy(Copied::Command)),
            "Copies the `gamow` command that opens this window.",
        ),
        (
            "Copy render command",
            Command::File(FileCommand::Copy(Copied::RenderCommand)),
            "Copies the `gamow render` command that draws this picture.",
        ),
        (
            "Copy curve command",
            Command::File(FileCommand::Copy(Copied::CurveCommand)),
            "Copies the `gamow curve` command that computes the selected point's curves.",
        ),
    ]
}

const fn save(label: &'static str, product: Product) -> MenuEntry {
    (label, Command::File(FileCommand::Choose(Purpose::Save(product))), product.tip())
}

/// Shows the menu's button.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let menu = ui.menu_button("File", |ui| {
        ui.set_min_width(WIDTH);
        for (number, entries) in [&OPEN[..], &SAVE, &copy_entries()].into_iter().enumerate() {
            if number > 0 {
                ui.separator();
            }
            for one in entries {
                entry(ui, state, one, commands);
            }
        }
    });
    menu.response.on_hover_text("Opens, saves and copies.");
}

/// An entry of the menu, with the keys that do the same.
fn entry(ui: &mut Ui, state: &State, (name, command, tip): &MenuEntry, commands: &mut Commands) {
    let button = Button::new(*name).shortcut_text(keys_of(std::slice::from_ref(command)));
    let obstacle = obstacle(state, command);
    let response = ui.add_enabled(obstacle.is_none(), button).on_hover_text(*tip);
    let response = response.on_disabled_hover_text(obstacle.unwrap_or_default());
    response.accessible_name(*name).on_click(commands, command.clone());
}

/// Why something cannot be saved as things are.
fn obstacle(state: &State, command: &Command) -> Option<&'static str> {
    let settings = &state.document.settings;
    let (is_plotted, tab) = (settings.window.plots, settings.plots.plot);
    let Command::File(FileCommand::Choose(Purpose::Save(product))) = command else { return None };
    match product {
        Product::PlotsSvg | Product::PlotsCsv if !is_plotted => Some("The plots are hidden."),
        Product::PlotsSvg if tab == PlotTab::Accuracy => Some("This tab is a table: save it as CSV."),
        Product::Fit if !is_plotted || tab != PlotTab::Fit => Some("Open the Fit tab first."),
        Product::Scene if !state.scene_file().is_some_and(is_model) => Some("Open or drop a model first."),
        Product::Report if state.course().is_none() => Some("No lesson is open."),
        _ if product.sheet().is_some() => match state.course() {
            None => Some("No lesson is open."),
            Some(course) if *product == Product::LabSheet && course.lesson().lab.is_none() => {
                Some("This lesson has no lab.")
            }
            Some(_) => None,
        },
        _ => None,
    }
}
