//! The help: what keys and mouse do, from the same table that the keys act by.

use eframe::egui::{Align2, Context, Grid, RichText, Ui, Window};

use super::Asks;
use crate::app::command::Command;
use crate::app::shortcuts::SHORTCUTS;
use crate::app::state::State;

const MOUSE: [(&str, &str); 8] = [
    ("Click in a view", "follow that point"),
    ("Shift-click", "compare one more point"),
    ("Drag in a view", "look around"),
    ("Scroll over a view", "zoom"),
    ("Double-click in a view", "follow the point again"),
    ("Click or drag in a plot", "go to that T"),
    ("Click in the map", "follow that point"),
    ("Drag, scroll, double-click in the map", "move, zoom, fit it"),
];

/// Shows the help, if it is asked for.
pub fn show(ctx: &Context, state: &State, asks: &mut Asks) {
    if !state.session.help {
        return;
    }
    let mut open = true;
    Window::new("Keys and mouse")
        .open(&mut open)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ctx, |ui| {
            let keys = SHORTCUTS.iter().map(|shortcut| (shortcut.keys, shortcut.action));
            table(ui, "keys", keys);
            ui.separator();
            table(ui, "mouse", MOUSE.into_iter());
        });
    if !open {
        asks.push(Command::Close);
    }
}

fn table(ui: &mut Ui, id: &str, rows: impl Iterator<Item = (&'static str, &'static str)>) {
    Grid::new(id).num_columns(2).spacing([24.0, 6.0]).min_col_width(150.0).show(ui, |ui| {
        for (cause, effect) in rows {
            ui.label(RichText::new(cause).strong());
            ui.label(effect);
            ui.end_row();
        }
    });
}
