//! The Fit tab: a noisy measurement of the selected point, and the speed and place that fit it best.

use eframe::egui::{self, DragValue, Grid, RichText, Ui, vec2};
use egui_plot::{FilledArea, HLine, Line, Plot, PlotBounds, PlotUi, Points};
use relativity_core::fit::{Curves, FitModel, Parameter};

use super::Asks;
use super::widgets::{choice, named_text, row};
use crate::app::command::Command;
use crate::app::fitting::{Fitted, Outcome};
use crate::app::settings::Fitting;
use crate::app::state::State;
use crate::app::{figures, theme};

/// Room for the numbers beside a plot.
const Y_AXIS_WIDTH: f32 = 48.0;
/// Width of the options and the table.
const TABLE_WIDTH: f32 = 300.0;

/// Shows the tab; `outcome` is the newest fit, if there is one yet.
pub fn show(ui: &mut Ui, state: &State, outcome: Option<&Outcome>, asks: &mut Asks) {
    let free = ui.available_size();
    let width = ((free.x - TABLE_WIDTH) / 2.0 - theme::GAP).max(20.0);
    ui.horizontal(|ui| {
        for (curve, name) in ["Δφ", "Δθ"].into_iter().enumerate() {
            ui.allocate_ui(vec2(width, free.y), |ui| {
                ui.vertical(|ui| plot(ui, state, outcome, curve, name));
            });
        }
        ui.allocate_ui(vec2(TABLE_WIDTH, free.y), |ui| {
            let scroll = egui::ScrollArea::vertical().auto_shrink(false);
            scroll.show(ui, |ui| ui.vertical(|ui| side(ui, state, outcome, asks)));
        });
    });
}

/// Options, and what came of them.
fn side(ui: &mut Ui, state: &State, outcome: Option<&Outcome>, asks: &mut Asks) {
    ui.spacing_mut().item_spacing.y = 4.0;
    options(ui, state.settings.fitting, asks);
    ui.separator();
    match outcome.map(|outcome| &outcome.result) {
        Some(Ok(fitted)) => table(ui, state, fitted),
        Some(Err(error)) => {
            ui.colored_label(ui.visuals().error_fg_color, error.to_string());
        }
        None if state.speed().beta() == 0.0 => {
            ui.label("The disparities of a scene at rest do not change: there is nothing to fit.");
        }
        None => {
            ui.label("…");
        }
    }
}

fn options(ui: &mut Ui, before: Fitting, asks: &mut Asks) {
    let mut fitting = before;
    row(
        ui,
        "Samples",
        "How often, over the range of T, the disparity is measured, and how noisy it is.",
        |ui| {
            let samples = DragValue::new(&mut fitting.samples).range(8..=2000).speed(1.0);
            ui.add(samples).on_hover_text("Number of samples").accessible_name("Samples");
            ui.label("noise");
            let mut percent = 100.0 * fitting.noise;
            let noise =
                DragValue::new(&mut percent).range(0.0..=20.0).speed(0.02).max_decimals(2).suffix(" %");
            let tip = "Standard deviation of the noise, in parts of each curve's range";
            if ui.add(noise).on_hover_text(tip).accessible_name("Noise").changed() {
                fitting.noise = percent / 100.0;
            }
        },
    );
    row(ui, "Fit to", "Which curves are fitted.", |ui| choice(ui, &mut fitting.curves, &CURVES));
    row(ui, "Model", "Which binocular model is fitted. What is measured is exact.", |ui| {
        choice(ui, &mut fitting.model, &MODELS);
    });
    ui.horizontal(|ui| {
        ui.checkbox(&mut fitting.passage, "x₀ unknown").on_hover_text("Fits when the point passes, too.");
        ui.checkbox(&mut fitting.residuals, "Residuals").on_hover_text("Plots what the fit leaves over.");
    });
    if fitting != before {
        asks.push(Command::Fitting(fitting));
    }
}

const CURVES: [(Curves, &str, &str); 3] = [
    (Curves::Azimuth, "Δφ only", "The azimuthal fit"),
    (Curves::Polar, "Δθ only", "The polar fit"),
    (Curves::Both, "Both", "Both curves at once"),
];

const MODELS: [(FitModel, &str, &str); 2] = [
    (FitModel::Exact, "Exact", "Each eye solves its own light cone."),
    (FitModel::Published, "As published", "The paper's model. It leaves out parallax, which biases the fit."),
];

/// Value, uncertainty and truth of each fitted parameter.
fn table(ui: &mut Ui, state: &State, fitted: &Fitted) {
    let source = state.selected_source();
    let truth = [state.speed().beta(), source.y, source.z, source.x0];
    let tip = "Standard error by 1000 bootstrap replicates; by linearisation until they are there.";
    Grid::new("fit").num_columns(4).spacing([14.0, 3.0]).min_row_height(18.0).show(ui, |ui| {
        for heading in ["", "fitted", "±", "true"] {
            ui.label(RichText::new(heading).weak()).on_hover_text(tip);
        }
        ui.end_row();
        for parameter in fitted.parameters {
            let index = *parameter as usize;
            let symbol = symbol(*parameter);
            let value = figures::fixed(fitted.values[index], 5);
            ui.label(RichText::new(symbol).weak());
            named_text(ui, RichText::new(&value).strong(), format!("Fitted {symbol}: {value}"));
            ui.label(figures::fixed(fitted.errors[index], 5)).on_hover_text(tip);
            ui.label(figures::fixed(truth[index], 5));
            ui.end_row();
        }
    });
    let name = if fitted.bootstrapped { "bootstrapped" } else { "linearised" };
    ui.label(RichText::new(format!("rms {} rad, {name}", figures::fixed(fitted.rms, 6))).weak());
}

fn symbol(parameter: Parameter) -> &'static str {
    match parameter {
        Parameter::Beta => "β",
        Parameter::Y => "y",
        Parameter::Z => "z",
        Parameter::X0 => "x₀",
    }
}

fn plot(ui: &mut Ui, state: &State, outcome: Option<&Outcome>, curve: usize, name: &'static str) {
    let residuals = state.settings.fitting.residuals;
    let fitted = outcome.and_then(|outcome| outcome.result.as_ref().ok());
    let data: Vec<[f64; 2]> = outcome.map_or_else(Vec::new, |outcome| data(outcome, curve, residuals));
    let colour = theme::point_colour(state.session.points.selected().number, ui.visuals());
    let dots = ui.visuals().weak_text_color();
    ui.horizontal(|ui| {
        ui.add_space(Y_AXIS_WIDTH);
        let title = if residuals { format!("{name}, measured − fitted") } else { name.to_owned() };
        ui.label(RichText::new(title).strong());
    });
    let grid = ui.visuals().weak_text_color().gamma_multiply(0.25);
    let bounds = bounds(&data, state.time_range());
    let response = Plot::new(("fit", curve))
        .allow_zoom(false)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_axis_zoom_drag(false)
        .y_axis_min_width(Y_AXIS_WIDTH)
        .grid_color(grid)
        .show(ui, |plot| {
            plot.set_plot_bounds(bounds);
            plot.points(Points::new("measured", data).radius(1.5).color(dots));
            match fitted {
                Some(_) if residuals => plot.hline(HLine::new("fit", 0.0).color(colour)),
                Some(fitted) => draw_fit(plot, fitted, curve, colour),
                None => {}
            }
        });
    let name = format!("Plot of measured and fitted {name}");
    response
        .response
        .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::GraphicsObject, true, &name));
}

fn draw_fit<'a>(plot: &mut PlotUi<'a>, fitted: &'a Fitted, curve: usize, colour: egui::Color32) {
    let band = &fitted.band[curve];
    if !band.is_empty() {
        let column = |i: usize| band.iter().map(|row| row[i]).collect::<Vec<f64>>();
        let area = FilledArea::new("95 %", &column(0), &column(1), &column(2));
        plot.add(area.fill_color(colour.gamma_multiply(0.35)));
    }
    plot.line(Line::new("fit", fitted.curves[curve].as_slice()).allow_band(false).color(colour).width(2.0));
}

fn data(outcome: &Outcome, curve: usize, residuals: bool) -> Vec<[f64; 2]> {
    let value = |sample| match (&outcome.result, residuals) {
        (Ok(fitted), true) => fitted.residual(sample, curve),
        (_, true) => None,
        (_, false) => [sample.dphi, sample.dtheta][curve].map(|reading| reading.value),
    };
    outcome.samples.iter().filter_map(|sample| Some([sample.time, value(sample)?])).collect()
}

fn bounds(data: &[[f64; 2]], [from, to]: [f64; 2]) -> PlotBounds {
    let values = || data.iter().map(|point| point[1]);
    let lowest = values().fold(f64::INFINITY, f64::min);
    let highest = values().fold(f64::NEG_INFINITY, f64::max);
    let (lowest, highest) = if lowest <= highest { (lowest, highest) } else { (0.0, 0.0) };
    let margin = (0.08 * (highest - lowest)).max(1e-9);
    PlotBounds::from_min_max([from, lowest - margin], [to.max(from + 1e-9), highest + margin])
}
