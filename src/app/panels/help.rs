//! The help: what keys and mouse do, from the same table that the keys act by, and what the times are called.

use eframe::egui::{Align2, Context, Grid, RichText, Ui, Window};

use super::Asks;
use crate::app::actions::ACTIONS;
use crate::app::command::Command;
use crate::app::state::State;
use crate::caption::times::TIMES;

/// Narrower windows than this have one column of it, which scrolls.
const NARROWEST_IN_COLUMNS: f32 = 960.0;

/// Room for all of it in two columns, points.
const HEIGHT: f32 = 440.0;

const MOUSE: [(&str, &str); 12] = [
    ("Rest on something in a view", "what it is, where and when"),
    ("Click in a view", "follow that point"),
    ("Shift-click", "compare one more point"),
    ("Drag in a view", "look around"),
    ("Scroll over a view", "zoom"),
    ("Double-click in a view", "follow the point again"),
    ("Click or drag in a plot, on a worldline", "go to that T"),
    ("Scroll, right-drag, double-click in a plot", "zoom, move, all of it"),
    ("Shift-click in a plot", "a cursor: two tell the difference"),
    ("Rest in a plot", "what the curves are there"),
    ("Click in the map", "follow that point"),
    ("Drag, scroll, double-click in the map", "move, zoom, fit it"),
];

/// The two times that the scrubber marks.
const ABREAST: [(&str, &str); 2] = [
    ("presently abreast", "measured beside the eyes now"),
    ("seen abreast", "seen beside the eyes, with D = 1/γ"),
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
        .vscroll(true)
        .default_height(HEIGHT)
        .show(ctx, |ui| {
            if ctx.content_rect().width() >= NARROWEST_IN_COLUMNS {
                ui.horizontal_top(|ui| {
                    ui.vertical(keys);
                    ui.separator();
                    ui.vertical(mouse_and_times);
                });
            } else {
                keys(ui);
                ui.separator();
                mouse_and_times(ui);
            }
        });
    if !open {
        asks.push(Command::Close);
    }
}

fn keys(ui: &mut Ui) {
    table(ui, "keys", ACTIONS.iter().map(|action| (action.keys_text(), action.name)));
}

fn mouse_and_times(ui: &mut Ui) {
    table(ui, "mouse", MOUSE.into_iter());
    ui.separator();
    table(ui, "times", TIMES.iter().map(|time| (time.name, time.short)).chain(ABREAST));
}

fn table(ui: &mut Ui, id: &str, rows: impl Iterator<Item = (impl Into<String>, &'static str)>) {
    Grid::new(id).num_columns(2).spacing([24.0, 6.0]).min_col_width(150.0).show(ui, |ui| {
        for (cause, effect) in rows {
            ui.label(RichText::new(cause).strong());
            ui.label(effect);
            ui.end_row();
        }
    });
}
