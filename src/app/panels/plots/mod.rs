//! The plots: a strip of tabs, each of them a file or a folder here, and the curves of the followed points over T:
//! disparities, angles, Doppler factor. Clicking or dragging in a plot goes to that T.

mod accuracy;
mod axes;
mod chart;
mod export;
mod fit;
mod split;
mod stereo;
mod trace;

use clap::ValueEnum as _;
use eframe::egui::{self, RichText, ScrollArea, Ui, vec2};
use egui_plot::{LineStyle, PlotBounds, PlotResponse, VLine};
use relativity_core::{Disparity, Model, Sighting};

use self::axes::{Y_AXIS_WIDTH, annotate, axis_label, label, plot_over_time, shown_in, time_at_pointer};
use self::chart::{ONE_CONE, chart, quantities};
pub use self::export::{csv, svg};
use crate::app::command::Command;
use crate::app::curves::{Curves, Quantity};
use crate::app::examination::Examination;
use crate::app::fitting::Fitting;
use crate::app::observer::Eye;
use crate::app::panels::Asks;
use crate::app::state::State;
use crate::app::theme;
use crate::app::widgets::dot;
use crate::app::widgets::icons::{self, Icon};
use crate::figures;
use crate::settings::PlotTab;
use crate::units::Unit;

/// Narrower plots have the followed points in a row of their own, below the tabs.
const NARROWEST_ROW: f32 = 660.0;

/// What there is to plot.
#[derive(Clone, Copy)]
pub struct Plotted<'a> {
    /// Those of each followed point, in order.
    pub curves: &'a [Curves],
    /// The fit of the selected one.
    pub fitting: &'a Fitting,
    /// What the views cost, and how far they are off.
    pub examination: Option<&'a Examination>,
}

/// Shows the plots.
pub fn show(ui: &mut Ui, state: &State, plotted: Plotted<'_>, asks: &mut Asks) {
    let is_narrow = ui.available_width() < NARROWEST_ROW;
    let examination = plotted.examination.filter(|_| state.settings.plots.plot == PlotTab::Accuracy);
    let points = |ui: &mut Ui, asks: &mut Asks| match examination {
        Some(examination) => accuracy::caption(ui, state, examination, asks),
        None => points(ui, state, asks),
    };
    row(ui, "plot tabs", |ui| {
        tabs(ui, state, asks);
        if !is_narrow {
            ui.separator();
            points(ui, asks);
        }
    });
    if is_narrow {
        row(ui, "points", |ui| points(ui, asks));
    }
    match state.settings.plots.plot {
        PlotTab::Fit => fit::show(ui, state, plotted.fitting, asks),
        PlotTab::Accuracy => accuracy::show(ui, state, plotted.examination, asks),
        tab => over_time(ui, state, plotted.curves, quantities(tab), asks),
    }
}

/// Shows the first of the plots of what is chosen, and nothing else; of a tab with a table the first plot of all.
pub fn show_one(ui: &mut Ui, state: &State, curves: &[Curves], asks: &mut Asks) {
    let quantity = quantities(state.settings.plots.plot).first().copied().unwrap_or(Quantity::DeltaPhi);
    over_time(ui, state, curves, &[quantity], asks);
}

/// Plots over T side by side, each below what it is called and what it is now.
fn over_time(ui: &mut Ui, state: &State, curves: &[Curves], quantities: &[Quantity], asks: &mut Asks) {
    // Four distances have more to say than one gain.
    let share = |quantity| if quantity == Quantity::LogDistance { 2.0 } else { 1.0 };
    let all: f32 = quantities.iter().map(|&quantity| share(quantity)).sum();
    let free = ui.available_width();
    let width = |quantity| (free * share(quantity) / all - theme::GAP / 2.0).max(20.0);
    ui.spacing_mut().item_spacing.y = 2.0;
    ui.horizontal_top(|ui| {
        for &quantity in quantities {
            ui.allocate_ui(vec2(width(quantity), 0.0), |ui| {
                ui.set_width(width(quantity));
                title(ui, state, quantity);
            });
        }
    });
    let height = ui.available_height().max(20.0);
    ui.horizontal(|ui| {
        for &quantity in quantities {
            plot(ui, vec2(width(quantity), height), state, curves, quantity, asks);
        }
    });
}

fn title(ui: &mut Ui, state: &State, quantity: Quantity) {
    ui.horizontal(|ui| {
        ui.add_space(Y_AXIS_WIDTH);
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            ui.label(
                RichText::new(axis_label(quantity, shown_in(quantity, state.measures().length))).strong(),
            );
            match quantity {
                Quantity::LogGain | Quantity::LogDistance => stereo::values_now(ui, state, quantity),
                _ => values_now(ui, state, quantity),
            }
            let beside = match state.settings.shown_model() {
                _ if quantity == Quantity::LogDistance => None,
                Model::OneCone => Some((format!("{ONE_CONE}; dotted: two"), ONE_CONE_TIP)),
                Model::Published(_) if quantity != Quantity::LogGain => {
                    Some(("published; dotted: exact".to_owned(), PUBLISHED_TIP))
                }
                Model::Published(_) | Model::Exact => None,
            };
            if let Some((text, tip)) = beside {
                ui.label(RichText::new(text).weak()).on_hover_text(tip);
            }
        });
    });
}

const ONE_CONE_TIP: &str = "Solid: as if both eyes received the same events. Dotted: each through its own light cone, exactly.\n\
    What lies between the two comes from there being two light cones.";

const PUBLISHED_TIP: &str =
    "Solid: what the views show, the paper's model. Dotted: each eye through its own light cone, exactly.";

/// What stands in a row, which may be wider than the plots, but must not widen them.
fn row(ui: &mut Ui, name: &str, contents: impl FnOnce(&mut Ui)) {
    ScrollArea::horizontal().id_salt(name).show(ui, |ui| ui.horizontal(contents));
}

fn tabs(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let mut plots = state.settings.plots;
    for &tab in PlotTab::value_variants() {
        let (name, tip) = match tab {
            PlotTab::Disparity => ("Disparity", "Δφ and Δθ: how differently the eyes see each point"),
            PlotTab::Angles => ("Angles", "φ and θ of the selected point, each eye"),
            PlotTab::Doppler => ("Doppler", "D of the selected point, each eye"),
            PlotTab::Stereo => ("Stereo", "How far off two eyes take the selected point to be, and how deep"),
            PlotTab::Fit => ("Fit", "Speed and distance of the selected point, from noisy Δφ and Δθ alone"),
            PlotTab::Accuracy => ("Accuracy", "What each way to draw the views costs, and how far it is off"),
        };
        ui.selectable_value(&mut plots.plot, tab, name).on_hover_text(tip);
    }
    let tip = "Draws the paper's approximate binocular model too, dashed:\n\
        the right eye is the left one at T − ΔT, both angles measured from the left eye.";
    let with_published = plots.plot == PlotTab::Disparity;
    if !matches!(plots.plot, PlotTab::Fit | PlotTab::Accuracy) {
        let published = egui::Checkbox::new(&mut plots.published, "Published");
        ui.add_enabled(with_published, published).on_hover_text(tip);
    }
    if plots != state.settings.plots {
        asks.push(Command::Plots(plots));
    }
}

/// The followed points: a click selects one, a cross removes it.
fn points(ui: &mut Ui, state: &State, asks: &mut Asks) {
    ui.spacing_mut().item_spacing.x = 3.0;
    let points = &state.session.points;
    let all = points.all();
    for (index, point) in all.iter().enumerate() {
        let colour = theme::point_colour(point.number, ui.visuals());
        dot(ui, colour);
        let chosen = all.len() > 1 && index == points.selected_index();
        let unit = state.measures().length;
        let [x, y, z] = state.settings.rest_place(point.track.rest).map(|value| unit.number(value, 3));
        let tip = format!(
            "At rest at ({x}, {y}, {z}){}.\nClick in a view to move it, shift-click to add one.",
            unit.suffix()
        );
        if ui.selectable_label(chosen, state.name_of(point)).on_hover_text(tip).clicked() {
            asks.push(Command::SelectPoint(index));
        }
        if points.is_removable(index) {
            let name = format!("Remove {}", state.name_of(point));
            if icons::button(ui, Icon::Remove, &name, vec2(18.0, 18.0), false).on_hover_text(&name).clicked()
            {
                asks.push(Command::RemovePoint(index));
            }
        }
        ui.add_space(6.0);
    }
}

/// What the selected point's curves are at T: the disparity, or what each eye sees, in its colour.
fn values_now(ui: &mut Ui, state: &State, quantity: Quantity) {
    let point = state.session.points.selected();
    let suffix = shown_in(quantity, Unit::OWN).suffix();
    let difference = |value: fn(&Disparity) -> f64| {
        figures::fixed_or_none(state.disparity(point).as_ref().map(value), 5) + &suffix
    };
    let of_eye: fn(&Sighting) -> f64 = match quantity {
        Quantity::DeltaPhi => {
            ui.label(difference(|both| both.dphi));
            return;
        }
        Quantity::DeltaTheta => {
            ui.label(difference(|both| both.dtheta));
            return;
        }
        Quantity::Phi => Sighting::phi,
        Quantity::Theta => Sighting::theta,
        _ => |seen| seen.doppler_factor,
    };
    for eye in Eye::BOTH {
        let value = figures::fixed_or_none(state.sighting(point, eye).as_ref().map(of_eye), 5);
        let text = format!("{} {value}{suffix}", eye.name());
        ui.label(RichText::new(text).color(theme::eye_colour(eye, ui.visuals())));
    }
}

fn plot(
    ui: &mut Ui,
    size: egui::Vec2,
    state: &State,
    curves: &[Curves],
    quantity: Quantity,
    asks: &mut Asks,
) {
    let chart = chart(state, curves, quantity);
    let ([from, to], [low, high]) = (chart.range, chart.value_range());
    let bounds = PlotBounds::from_min_max([from, low], [to, high]);
    let visuals = ui.visuals().clone();
    let plot = plot_over_time(ui, ("plot", label(quantity)), chart.time_unit, size);
    let (now, equidistant, traces) = (chart.now, chart.equidistant, &chart.traces);
    let response = chart.ruler(size.y).beside(plot).show(ui, |plot| {
        plot.set_plot_bounds(bounds);
        if let Some((time, _)) = equidistant {
            let colour = theme::equidistance_colour(&visuals);
            plot.vline(
                VLine::new("T₀", time)
                    .color(colour)
                    .width(1.0)
                    .style(LineStyle::dashed_dense())
                    .allow_hover(false),
            );
        }
        plot.vline(VLine::new("T", now).color(theme::now_colour(&visuals)).width(1.0).allow_hover(false));
        for trace in traces {
            trace.draw(plot, &visuals, now);
        }
    });
    annotate(ui, &response, chart.time_unit, equidistant);
    describe(&response, state, quantity);
    if let Some(time) = time_at_pointer(&response) {
        asks.push(Command::Time(time));
    }
}

/// Names the plot for assistive technology: what it shows, of what.
fn describe(response: &PlotResponse<()>, state: &State, quantity: Quantity) {
    let point = state.name_of(state.session.points.selected());
    let name = format!("Plot of {} of {point} against T", label(quantity));
    response
        .response
        .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::GraphicsObject, true, &name));
}
