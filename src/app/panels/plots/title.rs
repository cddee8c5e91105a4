//! The title of a plot: its quantity and unit, and the values of its curves at T.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Label, Layout, RichText, Sense, Stroke, TextStyle, Ui, WidgetInfo, pos2, vec2};
use relativity_core::Model;

use super::axes::{Y_AXIS_WIDTH, axis_label};
use super::chart::{TimePlot, Trace};
use super::legend::{SAMPLE, SPACE, sample};
use super::traces::{ONE_CONE, whose_words};
use crate::app::state::State;
use crate::app::state::plots::curves::{PUBLISHED, Whose};
use crate::app::widgets::named_text;
use crate::number_text;
use crate::quantity::Quantity;

/// Shows the title above a plot.
pub(super) fn show(ui: &mut Ui, state: &State, chart: &TimePlot<'_>) {
    let room = vec2((ui.available_width() - Y_AXIS_WIDTH).max(1.0), TextStyle::Body.resolve(ui.style()).size);
    ui.horizontal(|ui| {
        ui.add_space(Y_AXIS_WIDTH);
        ui.allocate_ui_with_layout(room, Layout::left_to_right(Align::Min).with_main_wrap(true), |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let axis = chart.ruler().axis(chart.value_range());
            let heading = axis.label(&axis_label(chart.quantity, &chart.measures));
            ui.label(RichText::new(heading).strong()).on_hover_text(chart.quantity.row().about);
            values_now(ui, state, chart, axis.exponent);
            let beside = match state.document.settings.shown_model() {
                _ if chart.quantity == Quantity::Distance => None,
                Model::OneCone => Some((format!("{ONE_CONE}; dotted: two"), ONE_CONE_TIP)),
                Model::Published(_) if chart.quantity != Quantity::StereoGain => {
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

const ONE_CONE_TIP: &str = "Solid: as if both eyes received the same events. Dotted: each through its own \
    light cone, exactly.\nThe difference is due to there being two light cones.";

const PUBLISHED_TIP: &str =
    "Solid: what the views show, the paper's model. Dotted: each eye through its own light cone, exactly.";

/// Shows the values of the selected point's curves at T, each in its colour.
fn values_now(ui: &mut Ui, state: &State, chart: &TimePlot<'_>, exponent: i32) {
    let number = state.document.points.selected().number;
    let own = |trace: &&Trace<'_>| !trace.pale && trace.is_of(number) && trace.dot;
    let row = chart.quantity.row();
    let mut traces: Vec<&Trace<'_>> = chart.traces.iter().filter(own).collect();
    let order = |trace: &Trace<'_>| {
        Whose::of(chart.quantity).iter().position(|&whose| whose == trace.source.curve.whose)
    };
    // Of a disparity each has the point's value, by another model.
    if !chart.quantity.is_disparity() {
        traces.sort_by_key(|trace| order(trace));
    }
    let is_one_of_several = traces.len() > 1;
    for trace in traces {
        let plotted = trace.source.value(chart.now);
        let written = if row.is_logarithmic { number_text::fixed } else { number_text::rounded };
        let shown = |value| written(chart.shown(value), chart.unit.decimals(row.decimals));
        let value = plotted.map_or_else(|| number_text::NONE.to_owned(), shown);
        // The heading has the unit, unless that has a factor.
        let suffix =
            if exponent == 0 && chart.quantity != Quantity::DeltaPhi { "" } else { &chart.unit.suffix() };
        let symbol = row.symbol;
        match trace.source.curve.whose {
            _ if chart.quantity.is_disparity() && trace.source.model == PUBLISHED => {
                let text = format!("published {value}{suffix}");
                let tip = "The same by the paper's approximate binocular model, drawn dashed.";
                entry(ui, trace, &text, &format!("Published {symbol} at T: {value}{suffix}"), tip);
            }
            _ if chart.quantity.is_disparity() && is_one_of_several => {
                let text = format!("{value}{suffix}");
                let tip =
                    "As two eyes see it, each by its own light cone, or by the one that the views show.";
                entry(ui, trace, &text, &format!("Exact {symbol} at T: {value}{suffix}"), tip);
            }
            _ if chart.quantity.is_disparity() => {
                ui.add(Label::new(format!("{value}{}", chart.unit.suffix())).extend());
            }
            whose if chart.quantity == Quantity::Distance => {
                let [name, tip] = whose_words(whose);
                entry(ui, trace, &format!("{name} {value}"), &format!("{tip}: {value}"), tip);
            }
            Whose::Eye(eye) => {
                let name = eye.name();
                let text = format!("{} {value}{suffix}", whose_words(Whose::Eye(eye))[0]);
                entry(
                    ui,
                    trace,
                    &text,
                    &format!("{symbol} of the {} at T: {value}", name.to_lowercase()),
                    name,
                );
            }
            Whose::Both | Whose::Resting | Whose::Measured => {
                let text = RichText::new(&value).color(trace.colour(ui.visuals()));
                named_text(ui, text, format!("{} at T: {value}", row.name));
            }
        }
    }
}

/// A piece of the line of `trace` and `text`, in one piece wherever the row breaks; `name` is for assistive
/// technology.
fn entry(ui: &mut Ui, trace: &Trace<'_>, text: &str, name: &str, tip: &str) {
    let colour = trace.colour(ui.visuals());
    let font = TextStyle::Body.resolve(ui.style());
    let galley = ui.painter().layout_no_wrap(text.to_owned(), font, colour);
    let (rect, response) = ui.allocate_exact_size(galley.size() + vec2(SAMPLE + SPACE, 0.0), Sense::hover());
    ui.painter().galley(pos2(rect.max.x - galley.size().x, rect.min.y), galley, colour);
    let stroke = Stroke::new(trace.width(), colour);
    sample(ui.painter(), rect.left_center(), SAMPLE, trace.dash, stroke);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name));
    response.on_hover_text(tip);
}
