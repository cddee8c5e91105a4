//! Play, pause, step and scrub through the observation time.

use eframe::egui::{
    self, Align, Align2, Checkbox, DragValue, Layout, RichText, Slider, SliderClamping, Stroke, TextStyle, Ui,
};

use super::Asks;
use crate::app::command::Command;
use crate::app::state::State;
use crate::app::theme;
use crate::app::widgets;
use crate::app::widgets::icons::{self, Icon};
use crate::figures;
use crate::flags::{MAX_TIME, TimeRange};
use crate::settings::RATE;

const TIME_TIP: &str = "Observation time T: when the light is received.   Keys: ← →, Home, End";

/// Shows the timeline.
pub fn show(ui: &mut Ui, state: &State, asks: &mut Asks) {
    ui.spacing_mut().item_spacing.y = 3.0;
    ui.horizontal(|ui| {
        transport(ui, state, asks);
        ui.separator();
        time(ui, state, asks);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| playback(ui, state, asks));
    });
    scrubber(ui, state, asks);
}

fn transport(ui: &mut Ui, state: &State, asks: &mut Asks) {
    ui.spacing_mut().item_spacing.x = 4.0;
    let buttons = [
        (Icon::Start, "To the start", "Key: Home", 28.0, Command::TimeInRange(0.0)),
        (Icon::Back, "Step back", "Key: ←", 28.0, Command::Step(-1)),
        if state.session.playing {
            (Icon::Pause, "Pause", "Key: space", 46.0, Command::TogglePlaying)
        } else {
            (Icon::Play, "Play", "Key: space", 46.0, Command::TogglePlaying)
        },
        (Icon::Forward, "Step forwards", "Key: →", 28.0, Command::Step(1)),
        (Icon::End, "To the end", "Key: End", 28.0, Command::TimeInRange(1.0)),
    ];
    for (icon, name, key, width, command) in buttons {
        let pressed = icon == Icon::Pause;
        let response = icons::button(ui, icon, name, egui::vec2(width, 26.0), pressed);
        if response.on_hover_text(format!("{name}\n{key}")).clicked() {
            asks.push(command);
        }
    }
}

fn time(ui: &mut Ui, state: &State, asks: &mut Asks) {
    ui.label("T").on_hover_text(TIME_TIP);
    let mut time = state.session.time;
    let [from, to] = state.time_range();
    let number = DragValue::new(&mut time)
        .range(-MAX_TIME..=MAX_TIME)
        .speed((to - from) / 1000.0)
        .min_decimals(3)
        // While it runs, digits that nobody can read would only flicker.
        .max_decimals(if state.session.playing { 3 } else { 6 })
        .update_while_editing(false);
    let response = ui.add_sized([76.0, ui.spacing().interact_size.y], number);
    if response.on_hover_text(TIME_TIP).accessible_name("T, typed").changed() {
        asks.push(Command::Time(time));
    }
    let equidistant = state.equidistance_time(state.session.points.selected());
    let text = format!("T₀ {}", figures::fixed_or_none(equidistant, 3));
    let button = egui::Button::new(RichText::new(text).weak()).frame(false);
    let tip = "T₀ = √((d/2)² + y² + z²) − x₀/β: when both eyes see the selected point at the same distance. \
        Click to go there. A scene at rest has none.";
    let response =
        ui.add_enabled(equidistant.is_some(), button).on_hover_text(tip).on_disabled_hover_text(tip);
    if let (true, Some(time)) = (response.accessible_name("Go to T₀").clicked(), equidistant) {
        asks.push(Command::Time(time));
    }
}

/// Rate, looping and range, from the right.
fn playback(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let before = state.settings.playback;
    let mut playback = before;
    let [mut from, mut to] = state.time_range();
    let mut fitted = playback.range.0.is_none();
    let tip = "Fits the range to the selected point: approaching, abreast, receding.";
    if ui.add(Checkbox::new(&mut fitted, "fit")).on_hover_text(tip).accessible_name("Fit range").changed() {
        playback.range = TimeRange((!fitted).then_some([from, to]));
    }
    let shown = [from, to];
    let end = |value| widgets::end_of_range(value, shown, 2);
    let last = ui.add(end(&mut to)).on_hover_text("Last T").accessible_name("Last T").changed();
    ui.label("to");
    let first = ui.add(end(&mut from)).on_hover_text("First T").accessible_name("First T").changed();
    if first || last {
        playback.range = TimeRange(Some([from.min(to), to.max(from)]));
    }
    ui.label("from");
    ui.separator();
    let repeat = icons::button(ui, Icon::Loop, "Loop", egui::vec2(28.0, 24.0), playback.looping);
    if repeat.on_hover_text("Start again at the end").clicked() {
        playback.looping = !playback.looping;
    }
    let rate = DragValue::new(&mut playback.rate).range(RATE).speed(0.01).max_decimals(3).suffix(" / s");
    ui.add(rate).on_hover_text("Units of T per second of your clock").accessible_name("Playback rate");
    if playback != before {
        asks.push(Command::Playback(playback));
    }
}

fn scrubber(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let [from, to] = state.time_range();
    let mut time = state.session.time;
    ui.spacing_mut().slider_width = ui.available_width();
    // T may lie outside the range; only a drag brings it inside.
    let slider = Slider::new(&mut time, from..=to).show_value(false).clamping(SliderClamping::Never);
    let response = ui.add(slider).on_hover_text(TIME_TIP).accessible_name("Observation time T");
    if response.changed() {
        asks.push(Command::Time(time));
    }
    if let Some(equidistant) = state.equidistance_time(state.session.points.selected()) {
        mark_equidistance(ui, response.rect, (equidistant - from) / (to - from));
    }
}

/// A tick where the slider has T0.
fn mark_equidistance(ui: &Ui, slider: egui::Rect, fraction: f64) {
    if !(0.0..=1.0).contains(&fraction) {
        return;
    }
    let x = widgets::handle_x(slider, fraction);
    let colour = theme::equidistance_colour(ui.visuals());
    let painter = ui.painter();
    painter.vline(x, slider.shrink2(egui::vec2(0.0, 2.0)).y_range(), Stroke::new(1.5, colour));
    let font = TextStyle::Small.resolve(ui.style());
    painter.text(egui::pos2(x + 3.0, slider.max.y + 1.0), Align2::LEFT_BOTTOM, "T₀", font, colour);
}
