//! The plots: a strip of tabs, each of them a file or a folder here, and the curves of the followed points
//! over T: disparities, angles, Doppler factor. The Light tab shows spectra instead. Clicking or dragging in
//! a plot goes to that T.

mod accuracy;
mod axes;
mod chart;
mod drawn;
mod export;
mod fit;
mod gestures;
mod legend;
mod light;
mod pins;
mod plotted;
mod pointed;
mod points;
mod sketch;
mod split;
mod title;
mod traces;

use clap::ValueEnum as _;
use eframe::egui::{self, Align, ComboBox, Rect, Ui, vec2};
use egui_plot::{LineStyle, PlotBounds, PlotResponse, PlotUi, VLine};

use self::axes::{annotate, label_places, plot_over_time};
use self::chart::TimePlot;
pub use self::export::{csv, svg};
pub use self::plotted::Plotted;
use self::traces::chart;
use crate::app::commands::SettingsCommand;
use crate::app::panels::{Commands, OnClick as _, on_change};
use crate::app::state::State;
use crate::app::state::plots::curves::QuantityCurves;
use crate::app::state::plots::look::quantities;
use crate::app::tools::awake;
use crate::app::widgets::theme;
use crate::app::widgets::{explained_lazily, strip_button};
use crate::quantity::Quantity;
use crate::settings::{Coordinates, PlotSettings, PlotTab, about, meaning};

/// Height of a plot's title and of the numbers along T, points.
const ABOVE_AND_BELOW: f32 = 60.0;
/// Room that the button which fits a speed takes beside a title, points.
const FIT_WIDTH: f32 = 100.0;

/// Shows the plots with their tabs.
pub fn show(ui: &mut Ui, state: &State, plotted: Plotted<'_>, commands: &mut Commands) {
    if let Some(sketched) = state.sketched() {
        if state.shows_sketch() {
            return sketch::show(ui, state, sketched, commands);
        }
        ui.horizontal(|ui| sketch::switch(ui, state, commands));
    }
    if state.document.settings.window.simple && !quantities(&state.document.settings.plots).is_empty() {
        let strip = ui.max_rect().with_max_y(ui.max_rect().min.y + theme::TITLE_HEIGHT);
        let offers_fit = state.session.lesson.is_none();
        let taken = if offers_fit { theme::text_scale(ui.style()) * FIT_WIDTH } else { 0.0 };
        over_time(ui, state, plotted.curves, taken, commands);
        if offers_fit {
            offer_fit(ui, state, strip, commands);
        }
        return;
    }
    let examination = plotted.examination.filter(|_| state.document.settings.plots.plot == PlotTab::Accuracy);
    ui.horizontal_wrapped(|ui| {
        tabs(ui, state, commands);
        ui.separator();
        match examination {
            Some(examination) => accuracy::caption(ui, state, examination, commands),
            None => points::show(ui, state, commands),
        }
    });
    match state.document.settings.plots.plot {
        PlotTab::Light => light::show(ui, state),
        PlotTab::Fit => fit::show(ui, state, plotted.fitting, commands),
        PlotTab::Accuracy => accuracy::show(ui, state, plotted.examination, commands),
        _ => over_time(ui, state, plotted.curves, 0.0, commands),
    }
}

/// Shows, before an audience, the first of the plots of what is chosen and nothing else; of the Fit tab the
/// readings with their residuals and the table. A curve that a lesson has drawn goes before.
pub fn show_one(ui: &mut Ui, state: &State, plotted: Plotted<'_>, commands: &mut Commands) {
    if let Some(sketched) = state.sketched() {
        return sketch::show(ui, state, sketched, commands);
    }
    match state.document.settings.plots.plot {
        PlotTab::Light => light::show(ui, state),
        PlotTab::Fit => fit::show_presented(ui, state, plotted.fitting, commands),
        _ => over_time(ui, state, plotted.curves, 0.0, commands),
    }
}

/// Shows at the right of the title strip `strip` the button that fits a speed to the plotted curve.
fn offer_fit(ui: &mut Ui, state: &State, strip: Rect, commands: &mut Commands) {
    let tip = "Takes noisy readings of this curve, and finds speed and distance from them.";
    let plots = PlotSettings { plot: PlotTab::Fit, ..state.document.settings.plots };
    strip_button(ui, strip, Align::Max, "Fit a speed")
        .on_hover_text(tip)
        .on_click(commands, SettingsCommand::Plots(plots));
}

/// Plots over T side by side, each below what it is called and what it is now. At the right end of the titles
/// this width is `taken`.
fn over_time(ui: &mut Ui, state: &State, curves: &[QuantityCurves], taken: f32, commands: &mut Commands) {
    let high = ui.available_height() - ABOVE_AND_BELOW;
    let charts: Vec<TimePlot<'_>> =
        state.plotted_quantities().iter().map(|&quantity| chart(state, curves, quantity, high)).collect();
    // Four distances have more to say than one gain.
    let share = |chart: &TimePlot<'_>| if chart.quantity == Quantity::Distance { 2.0 } else { 1.0 };
    let all: f32 = charts.iter().map(share).sum();
    let free = ui.available_width();
    let width = |chart| (free * share(chart) / all - theme::GAP / 2.0).max(20.0);
    ui.spacing_mut().item_spacing.y = 2.0;
    ui.horizontal_top(|ui| {
        for chart in &charts {
            let width = (width(chart) - taken).max(20.0);
            ui.allocate_ui(vec2(width, 0.0), |ui| {
                ui.set_width(width);
                title::show(ui, state, chart);
            });
        }
    });
    let height = ui.available_height().max(20.0);
    ui.horizontal(|ui| {
        for chart in &charts {
            plot(ui, vec2(width(chart), height), state, chart, commands);
        }
    });
}

fn tabs(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut plots = state.document.settings.plots;
    for &tab in PlotTab::value_variants() {
        let name = match tab {
            PlotTab::Disparity => "Disparity",
            PlotTab::Angles => "Angles",
            PlotTab::Doppler => "Doppler",
            PlotTab::Stereo => "Stereo",
            PlotTab::Light => "Light",
            PlotTab::Fit => "Fit",
            PlotTab::Accuracy => "Accuracy",
        };
        explained_lazily(ui.selectable_value(&mut plots.plot, tab, name), || meaning(&tab));
    }
    let with_published = plots.plot == PlotTab::Disparity;
    if !matches!(plots.plot, PlotTab::Light | PlotTab::Fit | PlotTab::Accuracy) {
        let published = egui::Checkbox::new(&mut plots.published, "Published");
        ui.add_enabled(with_published, published).on_hover_text(about("published"));
    }
    if plots.plot == PlotTab::Disparity {
        coordinates(ui, &mut plots.coordinates);
    }
    on_change(commands, &state.document.settings.plots, plots, SettingsCommand::Plots);
}

/// Chooses the coordinates of the disparities.
fn coordinates(ui: &mut Ui, chosen: &mut Coordinates) {
    let name = |coordinates| match coordinates {
        Coordinates::Angles => "Angles",
        Coordinates::Conformal => "u and v (conformal)",
    };
    let shown = ComboBox::from_id_salt("coordinates").selected_text(name(*chosen)).show_ui(ui, |ui| {
        for &coordinates in Coordinates::value_variants() {
            let button = ui.selectable_value(chosen, coordinates, name(coordinates));
            explained_lazily(button, || meaning(&coordinates));
        }
    });
    shown.response.on_hover_text(about("coordinates")).accessible_name("Coordinates of the disparities");
}

fn plot(ui: &mut Ui, size: egui::Vec2, state: &State, chart: &TimePlot<'_>, commands: &mut Commands) {
    let quantity = chart.quantity;
    let ([from, to], [low, high]) = (chart.range, chart.value_range());
    let plot = plot_over_time(ui, ("plot", quantity.row().id), chart.time_unit, size);
    let visuals = ui.visuals().clone();
    // T0 is marked for who points at the plot.
    let is_pointed = ui.rect_contains_pointer(Rect::from_min_size(ui.cursor().min, size));
    let equidistant = chart.equidistant.filter(|_| is_pointed);
    let response = chart.ruler().beside(plot).show(ui, |plot| {
        plot.set_plot_bounds(PlotBounds::from_min_max([from, low], [to, high]));
        lines(plot, chart, equidistant, &visuals);
        for trace in &chart.traces {
            trace.draw(plot, &visuals, chart.now);
        }
    });
    let mut labels = label_places(&response, chart.now);
    for trace in &chart.traces {
        trace.keep_clear(&mut labels, &response, chart.now);
    }
    annotate(ui, &response, (chart.clock, chart.time_unit), equidistant, &mut labels);
    axes::name_cursors(ui, &response, &chart.cursors, &mut labels);
    legend::show(ui, &response, chart, &mut labels);
    describe(&response, state, quantity);
    // Before an audience a pointer that rests may belong to what was shown before.
    if !state.session.stage.is_presented() || awake::is_moved(ui.ctx()) {
        pointed::show(ui, &response, chart);
    }
    gestures::read(ui, state, &response, chart, commands);
}

/// Draws the times that are marked: T, the cursors, and T0 where it is `equidistant`.
fn lines(
    plot: &mut PlotUi<'_>,
    chart: &TimePlot<'_>,
    equidistant: Option<(f64, &str)>,
    visuals: &egui::Visuals,
) {
    let line = |name: &str, time: f64| VLine::new(name, time).width(1.0).allow_hover(false);
    if let Some((time, _)) = equidistant {
        let colour = theme::equidistance_colour(visuals);
        plot.vline(line("T₀", time).color(colour).style(LineStyle::dashed_dense()));
    }
    for (name, &time) in ["A", "B"].into_iter().zip(&chart.cursors) {
        plot.vline(line(name, time).color(visuals.text_color()).style(LineStyle::dotted_loose()));
    }
    plot.vline(line("T", chart.now).color(theme::now_colour(visuals)));
}

/// Names the plot for assistive technology: what it shows, of what.
fn describe(response: &PlotResponse<()>, state: &State, quantity: Quantity) {
    let point = state.name_of(state.document.points.selected());
    let name = format!("Plot of {} of {point} against T", quantity.row().symbol);
    response
        .response
        .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::GraphicsObject, true, &name));
}
