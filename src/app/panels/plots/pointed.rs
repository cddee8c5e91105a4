//! Values of a plot's curves at the pointer, and at the cursors.

use eframe::egui::{RichText, Tooltip, Ui};
use egui_plot::PlotResponse;
use relativity_core::math;

use super::chart::{TimePlot, Trace};
use crate::number_text;
use crate::units::Unit;

/// About how many pixels there are to an axis, where none is given.
const PIXELS: f64 = 500.0;
/// Greatest number of digits of a number.
const MOST_DIGITS: f64 = 12.0;

/// Distance from a line up to which the pointer counts as near, points.
const NEAR: f32 = 6.0;

/// Writes as many digits of `value` as distinguish it from the next one that far off.
fn resolved(value: f64, resolution: f64) -> String {
    let decimals = (-math::log10(resolution)).ceil().clamp(0.0, MOST_DIGITS);
    number_text::fixed(value, if decimals.is_finite() { decimals as u8 } else { 3 })
}

impl TimePlot<'_> {
    /// Writes a T with its unit, as precisely as the plot shows it.
    pub fn time_text(&self, time: f64) -> String {
        let [from, to] = self.range;
        let resolution = self.time_unit.shown(to - from) / PIXELS;
        resolved(self.time_unit.shown(time), resolution) + &self.time_unit.suffix()
    }

    /// A value, given as plotted, with its unit.
    pub fn value_text(&self, plotted: f64) -> String {
        let [low, high] = self.value_range();
        let resolution = (high - low) / PIXELS;
        let resolution = if self.quantity.row().is_logarithmic {
            // So far off is so much of the number.
            self.shown(plotted) * (math::powf(10.0, resolution) - 1.0)
        } else {
            self.unit.shown(resolution)
        };
        resolved(self.shown(plotted), resolution) + &self.unit.suffix()
    }

    /// Writes the places of the cursors, and their distance; `None` without any.
    pub fn cursors_text(&self) -> Option<String> {
        match self.cursors.as_slice() {
            [] => None,
            [a] => Some(format!("A: {} = {}", self.clock.symbol, self.time_text(*a))),
            [a, b, ..] => Some(format!(
                "A: {symbol} = {}, B: {symbol} = {}, Δ{symbol} = {}",
                self.time_text(*a),
                self.time_text(*b),
                self.time_text(b - a),
                symbol = self.clock.symbol
            )),
        }
    }

    /// Writes the value of a curve at the cursor, or its change from one to the other and its slope; `None`
    /// without any.
    pub fn at_cursors(&self, trace: &Trace<'_>) -> Option<String> {
        let value = |time: f64| trace.source.value(time);
        let [a, rest @ ..] = self.cursors.as_slice() else { return None };
        let Some(b) = rest.first() else {
            return Some(
                value(*a).map_or_else(|| number_text::NONE.to_owned(), |value| self.value_text(value)),
            );
        };
        let Some(values) = value(*a).zip(value(*b)) else { return Some(number_text::NONE.to_owned()) };
        let difference = self.shown(values.1) - self.shown(values.0);
        let time = self.time_unit.shown(b - a);
        let slope = if time == 0.0 { number_text::NONE.to_owned() } else { significant(difference / time) };
        let per = |unit: Unit| if unit.name.is_empty() { "unit" } else { unit.name };
        let unit = self.unit.suffix();
        let difference = significant(difference);
        Some(format!("Δ = {difference}{unit}, slope = {slope}{unit}/{}", per(self.time_unit)))
    }
}

fn significant(value: f64) -> String {
    number_text::with_minus(&number_text::significant(value, 3))
}

/// Says beside the pointer which T it is at, and what each curve is there.
pub(super) fn show(ui: &Ui, response: &PlotResponse<()>, chart: &TimePlot<'_>) {
    let mouse = &response.response;
    let Some(pointer) = mouse.hover_pos().filter(|_| mouse.contains_pointer()) else { return };
    // It would cover what is dragged.
    if ui.input(|input| input.pointer.any_down()) || !response.transform.frame().contains(pointer) {
        return;
    }
    let time = response.transform.value_from_position(pointer).x;
    let is_near = |time: f64| (response.transform.position_from_point_x(time) - pointer.x).abs() < NEAR;
    let id = mouse.id.with("pointed");
    let tooltip = Tooltip::always_open(ui.ctx().clone(), mouse.layer_id, id, pointer).gap(14.0);
    tooltip.show(|ui| {
        ui.spacing_mut().item_spacing.y = 1.0;
        ui.label(RichText::new(format!("{} = {}", chart.clock.symbol, chart.time_text(time))).small());
        if let Some((time, words)) = chart.equidistant.filter(|(time, _)| is_near(*time)) {
            let text = format!("T₀ = {}, {words}: equally far from both eyes", chart.time_text(time));
            ui.label(RichText::new(text).small().strong());
        }
        // As they stand in the legend, which has those on top last.
        for trace in &chart.traces {
            let value = trace.source.value(time);
            let value = value.map_or_else(|| number_text::NONE.to_owned(), |value| chart.value_text(value));
            let text = format!("{}: {} = {value}", trace.name, chart.quantity.row().symbol);
            ui.label(RichText::new(text).small().color(trace.colour(ui.visuals())));
        }
    });
}
