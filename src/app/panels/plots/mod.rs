//! The plots: a strip of tabs, each of them a file or a folder here, and the curves of the followed points over T:
//! disparities, angles, Doppler factor. Clicking or dragging in a plot goes to that T.

mod accuracy;
mod axes;
mod fit;
mod split;
mod stereo;
mod trace;

use std::ops::RangeInclusive;

use clap::ValueEnum as _;
use eframe::egui::{self, Color32, RichText, TextStyle, Ui, vec2};
use egui_plot::{HoverPosition, LineStyle, PlotPoint, PlotResponse, VLine};
use relativity_core::math;
use relativity_core::{Disparity, Model, Sighting};

use self::axes::{
    Y_AXIS_WIDTH, annotate, bounds, grid, heading, label, plot_over_time, shift, shown_in, tick,
    time_at_pointer,
};
use self::trace::{ONE_CONE, Trace};
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
    let examination = plotted.examination.filter(|_| state.settings.plots.plot == PlotTab::Accuracy);
    ui.horizontal_wrapped(|ui| {
        tabs(ui, state, asks);
        ui.separator();
        match examination {
            Some(examination) => accuracy::caption(ui, state, examination, asks),
            None => points(ui, state, asks),
        }
    });
    let quantities: &[Quantity] = match state.settings.plots.plot {
        PlotTab::Disparity => &[Quantity::DeltaPhi, Quantity::DeltaTheta],
        PlotTab::Angles => &[Quantity::Phi, Quantity::Theta],
        PlotTab::Doppler => &[Quantity::LogDoppler],
        PlotTab::Stereo => &[Quantity::LogGain, Quantity::LogDistance],
        PlotTab::Fit => return fit::show(ui, state, plotted.fitting, asks),
        PlotTab::Accuracy => return accuracy::show(ui, state, plotted.examination, asks),
    };
    over_time(ui, state, plotted.curves, quantities, asks);
}

/// Shows the first of the plots of what is chosen, and nothing else; of a tab with a table the first plot of all.
pub fn show_one(ui: &mut Ui, state: &State, curves: &[Curves], asks: &mut Asks) {
    let quantity = match state.settings.plots.plot {
        PlotTab::Disparity | PlotTab::Fit | PlotTab::Accuracy => Quantity::DeltaPhi,
        PlotTab::Angles => Quantity::Phi,
        PlotTab::Doppler => Quantity::LogDoppler,
        PlotTab::Stereo => Quantity::LogGain,
    };
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
            ui.label(RichText::new(heading(quantity, state.measures().length)).strong());
            match quantity {
                Quantity::LogGain | Quantity::LogDistance => stereo::values_now(ui, state, quantity),
                _ => values_now(ui, state, quantity),
            }
            if quantity != Quantity::LogDistance && state.settings.model() == Model::OneCone {
                let tip = "Solid: as if both eyes received the same events. Dotted: each through its own light cone, exactly.\n\
                    What lies between the two comes from there being two light cones.";
                ui.label(RichText::new(format!("{ONE_CONE}; dotted: two")).weak()).on_hover_text(tip);
            }
        });
    });
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
        let name = state.name_of(point);
        if ui.available_size_before_wrap().x < entry_width(ui, &name) {
            ui.end_row();
        }
        // As high a row as that of the tabs.
        ui.allocate_space(vec2(0.0, ui.spacing().interact_size.y));
        dot(ui, colour);
        let chosen = all.len() > 1 && index == points.selected_index();
        let unit = state.measures().length;
        let [x, y, z] = state.settings.rest_place(point.track.rest).map(|value| unit.number(value, 3));
        let tip = format!(
            "At rest at ({x}, {y}, {z}){}.\nClick in a view to move it, shift-click to add one.",
            unit.suffix()
        );
        if ui.selectable_label(chosen, &name).on_hover_text(tip).clicked() {
            asks.push(Command::SelectPoint(index));
        }
        if all.len() > 1 {
            let name = format!("Remove {name}");
            if icons::button(ui, Icon::Remove, &name, vec2(18.0, 18.0), false).on_hover_text(&name).clicked()
            {
                asks.push(Command::RemovePoint(index));
            }
        }
        ui.add_space(6.0);
    }
}

/// Room for a point of this `name` in the list of them, with its dot and its cross.
fn entry_width(ui: &Ui, name: &str) -> f32 {
    const AROUND: f32 = 50.0;
    let font = TextStyle::Button.resolve(ui.style());
    AROUND + ui.painter().layout_no_wrap(name.to_owned(), font, Color32::WHITE).size().x
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
    let traces = traces(ui, state, curves, quantity);
    let values = traces.iter().flat_map(|trace| trace.points).map(|point| point.y);
    let bounds = bounds(values, state.time_range());
    let equidistant = state.equidistance_time(state.session.points.selected());
    let visuals = ui.visuals().clone();
    let now = state.session.time;
    let (unit, shown) = (state.measures().time, shown_in(quantity, state.measures().length));
    let shift = shift(quantity, shown);
    let response = plot_over_time(ui, ("plot", label(quantity)), unit, size)
        .y_grid_spacer(move |input| grid(quantity, shift, size.y, input))
        .y_axis_formatter(move |mark, _: &RangeInclusive<f64>| {
            tick(quantity, mark.value + shift, mark.step_size)
        })
        .label_formatter(move |hover| hover_text(quantity, [unit, shown], hover))
        .show(ui, |plot| {
            plot.set_plot_bounds(bounds);
            if let Some(time) = equidistant {
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
                trace.draw(plot, now);
            }
        });
    annotate(ui, &response, unit, equidistant);
    describe(&response, state, quantity);
    if let Some(time) = time_at_pointer(&response) {
        asks.push(Command::Time(time));
    }
}

/// What is drawn of `quantity`: of every point for a disparity, of each eye of the selected one else.
fn traces<'a>(ui: &Ui, state: &State, curves: &'a [Curves], quantity: Quantity) -> Vec<Trace<'a>> {
    let selected = state.session.points.selected_index();
    if matches!(quantity, Quantity::LogGain | Quantity::LogDistance) {
        let Some(curves) = curves.get(selected) else { return Vec::new() };
        return stereo::traces(ui, state, curves, quantity);
    }
    if !matches!(quantity, Quantity::DeltaPhi | Quantity::DeltaTheta) {
        let Some(curves) = curves.get(selected) else { return Vec::new() };
        let of_eyes = |curves: &'a [Vec<PlotPoint>], exact_beside| {
            Eye::BOTH.into_iter().zip(curves).map(move |(eye, points)| {
                let colour = theme::eye_colour(eye, ui.visuals());
                Trace::of_model(eye.name().to_owned(), points, colour, state, exact_beside)
            })
        };
        return of_eyes(curves.exact(quantity), true).chain(of_eyes(curves.shown(quantity), false)).collect();
    }
    let mut traces = Vec::new();
    for (index, (point, curves)) in state.session.points.all().iter().zip(curves).enumerate() {
        let colour = theme::point_colour(point.number, ui.visuals());
        let wide = index == selected;
        let published = curves.published(quantity);
        let name = || state.name_of(point);
        traces.push(Trace {
            name: format!("{}, published", name()),
            points: published,
            colour,
            style: LineStyle::dashed_dense(),
            wide,
            dot: false,
        });
        let exact = curves.exact(quantity).iter().map(|points| (points, true));
        for (points, exact_beside) in exact.chain(curves.shown(quantity).iter().map(|points| (points, false)))
        {
            let trace = Trace::of_model(name(), points, colour, state, exact_beside);
            traces.push(Trace { wide: trace.wide && wide, ..trace });
        }
    }
    traces
}

fn hover_text(quantity: Quantity, [time, shown]: [Unit; 2], hover: &HoverPosition<'_>) -> Option<String> {
    let HoverPosition::NearDataPoint { plot_name, position, .. } = hover else { return None };
    let value = match quantity {
        Quantity::LogDistance => shown.text(math::powf(10.0, position.y), 3),
        _ if quantity.is_logarithm() => figures::fixed(math::powf(10.0, position.y), 4),
        _ => shown.text(position.y, 5),
    };
    Some(format!("{plot_name}\nT = {}\n{} = {value}", time.text(position.x, 3), label(quantity)))
}

/// Names the plot for assistive technology: what it shows, of what.
fn describe(response: &PlotResponse<()>, state: &State, quantity: Quantity) {
    let point = state.name_of(state.session.points.selected());
    let name = format!("Plot of {} of {point} against T", label(quantity));
    response
        .response
        .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::GraphicsObject, true, &name));
}
