//! The end of a page's start page: the program of a desktop, its source and its documentation.

use eframe::egui::{Hyperlink, RichText, Ui};
use gamow_platform::web::page;

/// Introduction to the program of a desktop.
pub const INTRODUCTION: &str =
    "Gamow is also a program for the desktop, with commands. From its source, with Rust:";
/// The commands that open the program's window and run its tests.
const COMMANDS: &str = "cargo run --release\ncargo test --workspace";

/// Shows the commands, and links where the page knows them.
pub fn show(ui: &mut Ui) {
    ui.label(RichText::new(COMMANDS).monospace());
    let Some(source) = page::source() else { return };
    let links =
        [("Source and downloads", source.clone()), ("Documentation", format!("{source}/tree/HEAD/docs"))];
    ui.horizontal_wrapped(|ui| {
        for (label, address) in links {
            ui.add(Hyperlink::from_label_and_url(label, address).open_in_new_tab(true));
        }
    });
}
