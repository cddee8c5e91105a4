//! The Accuracy tab: what each way to draw the present views costs, and how far it is off. Clicking one in
//! the table or in the plot chooses it.

mod conclusion;
mod frontier;
mod table;

pub use table::csv;

use eframe::egui::{Checkbox, Label, Rect, RichText, ScrollArea, Sense, Ui, pos2, vec2};
use gamow_platform::threads;

use super::split::{part, table_and_plots};
use crate::app::commands::SettingsCommand;
use crate::app::panels::{Commands, on_change};
use crate::app::state::State;
use crate::app::views::examination::Examination;
use crate::app::views::heat_map;
use crate::app::widgets::explained_lazily;
use crate::flags::choices::RendererChoice;
use crate::number_text;
use crate::settings::{QualitySettings, about, meaning};

/// The remark below figures that are complete.
const MEASURED: &str = if threads::ARE_SEVERAL {
    "Measured in the present views."
} else {
    "Measured in the present views; the GPU's methods only in the desktop program."
};

/// Width of the table.
const TABLE_WIDTH: f32 = 470.0;
const LEAST_PLOT: f32 = 150.0;

/// Shows the Accuracy tab.
pub fn show(ui: &mut Ui, state: &State, examination: Option<&Examination>, commands: &mut Commands) {
    let Some(examination) = examination else { return };
    if examination.is_blind() {
        ui.label("There is nothing to measure: the views are hidden.");
        return;
    }
    if let Some(sentence) = conclusion::sentence(examination) {
        ui.label(sentence);
    }
    let before = state.document.settings.quality;
    let mut quality = before;
    automatic(ui, state, &mut quality);
    let chosen = examination.chosen;
    let (table, plot) = table_and_plots(ui.available_rect_before_wrap(), TABLE_WIDTH, LEAST_PLOT);
    part(ui, "figures", table, |ui| {
        let area = ScrollArea::both().auto_shrink(false);
        area.show(ui, |ui| table::show(ui, examination, chosen, &mut quality));
    });
    if let Some(plot) = plot {
        part(ui, "frontier", plot, |ui| frontier::show(ui, plot.size(), examination, chosen, &mut quality));
    }
    on_change(commands, &before, quality, SettingsCommand::Quality);
}

/// Whether the choice is automatic, and what was chosen.
fn automatic(ui: &mut Ui, state: &State, quality: &mut QualitySettings) {
    let is_automatic = quality.renderer == RendererChoice::Auto;
    let chosen = state.frame.choices.first().filter(|_| is_automatic);
    let text = chosen.map_or_else(|| "automatic".to_owned(), |(_, choice)| format!("automatic: {choice}"));
    let tip = || format!("{} Its line is in the plot.", meaning(&RendererChoice::Auto));
    if explained_lazily(ui.selectable_label(is_automatic, text), tip).clicked() {
        quality.renderer = RendererChoice::Auto;
    }
}

/// The heat map's switch and scale, and what the figures are.
pub fn caption(ui: &mut Ui, state: &State, examination: &Examination, commands: &mut Commands) {
    let mut plots = state.document.settings.plots;
    if ui.add(Checkbox::new(&mut plots.heat_map, "Heat map")).on_hover_text(about("heat-map")).changed() {
        commands.push(SettingsCommand::Plots(plots).into());
    }
    if plots.heat_map {
        scale(ui);
    }
    let is_pending = examination.is_pending();
    let text = if is_pending { "Measuring while nothing moves …" } else { MEASURED };
    ui.add(Label::new(RichText::new(text).weak().small()).extend());
}

/// The colours of the heat map.
fn scale(ui: &mut Ui) {
    let (first, last) = heat_map::DECADES.into_inner();
    let text = |exponent: f64| RichText::new(format!("{} px", number_text::power_of_ten(exponent))).small();
    ui.label(text(first));
    let (rect, _) = ui.allocate_exact_size(vec2(90.0, 10.0), Sense::hover());
    let width = rect.width() as usize;
    for i in 0..width {
        let fraction = (i as f64 + 0.5) / width as f64;
        let left = rect.min.x + i as f32;
        let line = Rect::from_min_max(pos2(left, rect.min.y), pos2(left + 1.0, rect.max.y));
        ui.painter().rect_filled(line, 0.0, heat_map::colour(first + fraction * (last - first)));
    }
    ui.label(text(last));
    let (square, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
    ui.painter().rect_filled(square, 1.0, heat_map::WRONG_BODY);
    ui.label(RichText::new("other body").small());
}
