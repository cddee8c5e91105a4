//! The row above the plots: the followed points, and what can be kept and marked in the plots.

use eframe::egui::{Color32, TextStyle, Ui, vec2};

use crate::app::commands::PointsCommand;
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::State;
use crate::app::state::plots::look::{self, PlotCommand};
use crate::app::widgets::dot;
use crate::app::widgets::icons::{self, Icon};
use crate::app::widgets::theme;

/// The followed points: a click selects one, a cross removes it.
pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ui.spacing_mut().item_spacing.x = 3.0;
    let points = &state.document.points;
    let all = points.all();
    for (index, point) in all.iter().enumerate() {
        let colour = theme::point_colour(point.number, ui.visuals());
        let name = state.name_of(point);
        if ui.available_size_before_wrap().x < entry_width(ui, &name) {
            ui.end_row();
        }
        // As high a row as that of the tabs.
        ui.allocate_space(vec2(0.0, ui.spacing().interact_size.y));
        dot(ui, colour);
        let chosen = all.len() > 1 && index == points.selected_index();
        let unit = state.measures().length;
        let [x, y, z] =
            state.document.settings.rest_place(point.track.rest).map(|value| unit.number(value, 3));
        let place = format!("({x}, {y}, {z}){}", unit.suffix());
        let is = match state.on_wheel(&point.track, 0.0) {
            None => format!("At rest at {place}."),
            Some(wheel) => format!("Turns with its wheel, {}. At {place} when τ = 0.", wheel.share_text()),
        };
        let tip = format!("{is}\nClick in a view to move it, shift-click to add one.");
        ui.selectable_label(chosen, &name)
            .on_hover_text(tip)
            .on_click(commands, PointsCommand::Select(index));
        if points.is_removable(index) {
            let name = format!("Remove {name}");
            icons::button(ui, Icon::Remove, &name, vec2(18.0, 18.0))
                .on_hover_text(&name)
                .on_click(commands, PointsCommand::Remove(index));
        }
        ui.add_space(6.0);
    }
    if !look::quantities(&state.document.settings.plots).is_empty() {
        buttons(ui, state, commands);
    }
}

/// Room for a point of this `name` in the list of them, with its dot and its cross.
fn entry_width(ui: &Ui, name: &str) -> f32 {
    const AROUND: f32 = 50.0;
    let font = TextStyle::Button.resolve(ui.style());
    AROUND + ui.painter().layout_no_wrap(name.to_owned(), font, Color32::WHITE).size().x
}

/// Shows the buttons that pin and mark something in the plots.
fn buttons(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let plotting = &state.scratch.plotting;
    let mut button = |ui: &mut Ui, name: &str, tip: &str, command: PlotCommand| {
        ui.small_button(name).on_hover_text(tip).on_click(commands, command);
    };
    let tip = "Keeps the present curves of the selected point, to compare speeds, for example. (K)";
    button(ui, "Pin", tip, PlotCommand::Pin);
    if !plotting.pins.is_empty() {
        button(ui, "Unpin all", "Removes all pinned curves. (Shift+K)", PlotCommand::Unpin);
    }
    let (name, tip) = match plotting.cursors.as_slice() {
        [] => ("Cursor A", "Marks T, to read the curves there: so does a shift-click in a plot. (C)"),
        [_] => ("Cursor B", "Marks T, to see how much the curves change from cursor A, and how steeply. (C)"),
        _ => ("No cursors", "Removes both cursors. (C)"),
    };
    button(ui, name, tip, PlotCommand::Cursor(None));
    if !plotting.zooms.is_empty() {
        let tip = "Shows the whole of every plot again: so does a double click in one. Scroll in a plot to see a part of it, \
            drag it with the right button to see another.";
        button(ui, "Whole plots", tip, PlotCommand::Whole);
    }
}
