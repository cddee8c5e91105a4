//! The Fit tab: which samples are taken of the selected point, what is fitted to them, and what comes out.

mod export;
mod plots;
mod table;

use eframe::egui::{self, ComboBox, DragValue, RichText, ScrollArea, Sense, TextStyle, Ui};
use relativity_core::{Curves, Model, PublishedVariant};

pub(super) use self::export::{csv, panels};
use super::split::{part, table_and_plots};
use crate::app::commands::{FileCommand, SettingsCommand};
use crate::app::panels::{Commands, OnClick as _, on_change};
use crate::app::state::State;
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::state::fitting::Fitting;
use crate::app::widgets::theme;
use crate::app::widgets::{end_of_range, explained_lazily, fitted, number};
use crate::flags::TimeRange;
use crate::settings::{DataFrom, FIT_SAMPLES, FitSettings, MAX_SEED, NOISE_PERCENT, about, meaning};
use crate::units::Unit;

/// Width of the table, and least width of the plots.
const TABLE_WIDTH: f32 = 356.0;
const LEAST_PLOTS: f32 = 150.0;
/// Width that a unit adds to the table.
const UNIT_WIDTH: f32 = 26.0;
/// Width from which on the choice of the model and the samples stand in one row.
const WIDE: f32 = 676.0;

/// Shows the tab: the model and the samples above the plots and the table. Where a lesson, whose text has
/// the numbers, leaves the plots no room beside the table, they stand alone.
pub fn show(ui: &mut Ui, state: &State, fitting: &Fitting, commands: &mut Commands) {
    if state.session.lesson.is_some() && ui.available_width() < TABLE_WIDTH + LEAST_PLOTS {
        plots::show(ui, state, fitting, commands);
        return;
    }
    let mut setup = state.document.settings.fit;
    let is_wide = ui.available_width() >= WIDE;
    row(ui, |ui| {
        model(ui, state, &mut setup);
        if is_wide {
            samples(ui, state, &mut setup);
        }
    });
    if !is_wide {
        row(ui, |ui| samples(ui, state, &mut setup));
    }
    let unit_width = if state.measures().length == Unit::OWN { 0.0 } else { UNIT_WIDTH };
    let (table, plots) =
        table_and_plots(ui.available_rect_before_wrap(), TABLE_WIDTH + unit_width, LEAST_PLOTS);
    part(ui, "fit range and table", table, |ui| {
        row(ui, |ui| data(ui, state, &mut setup, commands));
        row(ui, |ui| match &state.session.data {
            Some(file) => named_file(ui, &file.name),
            None => range(ui, state, &mut setup),
        });
        let area = ScrollArea::vertical().id_salt("fit table").auto_shrink(false);
        area.show(ui, |ui| table::show(ui, fitting, state.measures().length));
    });
    if let Some(plots) = plots {
        part(ui, "fit plots", plots, |ui| plots::show(ui, state, fitting, commands));
    }
    on_change(commands, &state.document.settings.fit, setup, SettingsCommand::Fit);
}

/// Part of the width that the readings take before an audience, and of the height beside them the table.
const READINGS_SHARE: f32 = 0.5;
const PRESENTED_TABLE_SHARE: f32 = 0.48;
/// Sizes of the table before an audience, as parts of most large writing: as large as fits.
const PRESENTED_SIZES: [f32; 2] = [0.9, 0.5];
/// Width of the table before an audience, in heights of its largest writing.
const TABLE_IN_LETTERS: f32 = 13.5;

/// Shows the tab to an audience: the readings on the left, and beside them the table above the residuals.
/// Nothing is chosen.
pub fn show_presented(ui: &mut Ui, state: &State, fitting: &Fitting, commands: &mut Commands) {
    let area = ui.available_rect_before_wrap();
    let middle = area.min.x + READINGS_SHARE * area.width();
    let right = area.with_min_x(middle + theme::GAP);
    let table = right.with_max_y(right.min.y + PRESENTED_TABLE_SHARE * right.height());
    let residuals = right.with_min_y(table.max.y);
    part(ui, "fit table", table, |ui| {
        let size = TextStyle::Body.resolve(ui.style()).size.min(table.width() / TABLE_IN_LETTERS);
        let key = fitting.shown().is_some();
        let _ = fitted::show(ui, key, PRESENTED_SIZES.map(|part| part * size), |ui| {
            table::show_presented(ui, fitting, state.measures().length);
        });
    });
    part(ui, "fit readings", area.with_max_x(middle), |ui| {
        plots::show_first(ui, state, fitting, plots::Half::Readings, commands);
    });
    part(ui, "fit residuals", residuals, |ui| {
        plots::show_first(ui, state, fitting, plots::Half::Residuals, commands);
    });
}

fn row(ui: &mut Ui, widgets: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        widgets(ui);
    });
}

/// Shows the source of the samples, and the file that the fit is saved to.
fn data(ui: &mut Ui, state: &State, setup: &mut FitSettings, commands: &mut Commands) {
    ui.label(RichText::new("data").weak());
    if state.session.data.is_some() {
        ui.button("Simulated")
            .on_hover_text("Simulates samples of the selected point again.")
            .on_click(commands, FileCommand::Simulate);
    } else {
        let shown = DATA_FROM.iter().find(|(from, _)| *from == setup.data_from);
        ComboBox::from_id_salt("data from")
            .selected_text(shown.map_or("", |(_, name)| name))
            .width(112.0)
            .show_ui(ui, |ui| {
                for (from, name) in DATA_FROM {
                    let button = ui.selectable_value(&mut setup.data_from, from, name);
                    explained_lazily(button, || meaning(&from));
                }
            })
            .response
            .on_hover_text(about("data-from"))
            .accessible_name("Data from");
    }
    let tip = "Fits measured disparities: a CSV file with the columns T, dphi or dtheta or both, optionally sigma_dphi, sigma_dtheta and d.\n\
        Such a file can be dropped onto the window, too.";
    ui.button("Own data…").on_hover_text(tip).on_click(commands, FileCommand::Choose(Purpose::OpenData));
    let tip = "Saves the numbers, with their uncertainties, as `gamow fit --json` does.";
    ui.button("Save…")
        .on_hover_text(tip)
        .on_click(commands, FileCommand::Choose(Purpose::Save(Product::Fit)));
}

/// The file that the samples are from.
fn named_file(ui: &mut Ui, name: &str) {
    ui.label(RichText::new("measured, in").weak());
    let label = egui::Label::new(RichText::new(name).strong()).truncate().sense(Sense::hover());
    ui.add(label).accessible_name(format!("Data from {name}"));
}

const DATA_FROM: [(DataFrom, &str); 4] = [
    (DataFrom::Views, "as the views show"),
    (DataFrom::Exact, "from exact"),
    (DataFrom::OneCone, "from one cone"),
    (DataFrom::Published, "from published"),
];

fn model(ui: &mut Ui, state: &State, setup: &mut FitSettings) {
    let fitted = [(Curves::Azimuth, "Δφ"), (Curves::Polar, "Δθ"), (Curves::Both, "both")];
    ui.label(RichText::new("Fit").weak());
    for (curves, text) in fitted {
        let button = ui.selectable_value(&mut setup.curves, curves, text);
        explained_lazily(button, || meaning(&curves)).accessible_name(format!("Fit {text}"));
    }
    ui.label(RichText::new("by").weak());
    for (model, name) in MODELS {
        let tip = || format!("{}\n{}", meaning(&model), data_remark(state, model));
        explained_lazily(ui.selectable_value(&mut setup.model, model, name), tip);
    }
    ui.checkbox(&mut setup.fit_x0, "x₀").on_hover_text(about("fit-x0")).accessible_name("Fit x₀");
    ui.add_space(8.0);
}

const MODELS: [(Model, &str); 3] = [
    (Model::Exact, "exact"),
    (Model::OneCone, "one cone"),
    (Model::Published(PublishedVariant::AppendixA), "published"),
];

/// Describes the samples of the Fit tab, as seen from a `model` that is to fit them.
fn data_remark(state: &State, model: Model) -> &'static str {
    if state.session.data.is_some() {
        return "";
    }
    let settings = &state.document.settings;
    match settings.fit.data_from.model().unwrap_or_else(|| settings.model()) {
        made if made == model => "The data were made by this model.",
        Model::OneCone => "The data are those of one light cone for both eyes, so its fit is biased.",
        Model::Published(_) => "The data are those of the published model, so its fit is biased.",
        Model::Exact => "The data stay what the eyes see, so its fit is biased.",
    }
}

fn samples(ui: &mut Ui, state: &State, setup: &mut FitSettings) {
    if state.session.data.is_none() {
        simulated(ui, setup);
    }
    let seed = number(&mut setup.seed).range(0..=MAX_SEED).speed(0.1).update_while_editing(false);
    named(ui, "seed", "Seed", about("seed"), seed);
}

fn simulated(ui: &mut Ui, setup: &mut FitSettings) {
    let count = number(&mut setup.fit_samples).range(FIT_SAMPLES).speed(2.0);
    named(ui, "samples", "Number of samples", about("fit-samples"), count);
    let noise = number(&mut setup.noise_percent)
        .range(NOISE_PERCENT)
        .speed(0.02)
        .max_decimals(3)
        .update_while_editing(false)
        .suffix(" %");
    named(ui, "noise", "Noise", about("noise-percent"), noise);
}

fn range(ui: &mut Ui, state: &State, setup: &mut FitSettings) {
    let plotted = state.time_range();
    let [mut from, mut to] = setup.fit_range.0.unwrap_or(plotted);
    let unit = state.measures().time;
    let field = |value| end_of_range(value, unit, plotted, 3);
    let tip = about("fit-range");
    ui.label(RichText::new(state.clock().symbol).weak());
    let first = ui.add(field(&mut from)).on_hover_text(tip).accessible_name("Samples from T");
    ui.label(RichText::new("to").weak());
    let last = ui.add(field(&mut to)).on_hover_text(tip).accessible_name("Samples to T");
    if (first.changed() || last.changed()) && from < to {
        setup.fit_range = TimeRange(Some([from, to]));
    }
    let reset = egui::Button::new("as plotted").selected(setup.fit_range.0.is_none());
    if ui.add(reset).on_hover_text(tip).clicked() {
        setup.fit_range = TimeRange(None);
    }
}

fn named(ui: &mut Ui, text: &str, name: &str, tip: &str, widget: DragValue<'_>) {
    ui.label(RichText::new(text).weak()).on_hover_text(tip);
    ui.add(widget).on_hover_text(tip).accessible_name(name);
    ui.add_space(4.0);
}
