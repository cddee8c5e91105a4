//! The tab "Stereo": how far off two eyes take the selected point to be, beside how far each sees it and where it is
//! measured.

use eframe::egui::accesskit::Role;
use eframe::egui::{RichText, Sense, Stroke, TextStyle, Ui, WidgetInfo, pos2, vec2};

use super::chart::{distance_look, distance_words};
use crate::app::curves::{DistanceKind, Quantity, StereoView, stereo_view};
use crate::app::state::State;
use crate::app::theme;
use crate::app::widgets::named_text;
use crate::figures;

/// Length of a piece of line in the caption, points.
const SAMPLE: f32 = 16.0;

/// What the curves are at T, each with how its line looks.
pub(super) fn values_now(ui: &mut Ui, state: &State, quantity: Quantity) {
    let key = state.curve_key(state.session.points.selected());
    let view = stereo_view(&key, key.model, state.session.time);
    if quantity == Quantity::LogGain {
        let gain = figures::fixed_or_none(view.and_then(|StereoView { gain, .. }| gain), 4);
        let text = RichText::new(&gain).color(theme::stereo_colour(ui.visuals()));
        named_text(ui, text, format!("Stereo gain at T: {gain}"));
        return;
    }
    let unit = state.measures().length;
    for (index, kind) in DistanceKind::ALL.into_iter().enumerate() {
        let value = unit.number(view.and_then(|view| view.distances[index]).unwrap_or(f64::NAN), 2);
        entry(ui, kind, &value);
    }
}

/// A piece of the line that stands for `kind`, its name and its `value`: in one piece wherever the row breaks.
fn entry(ui: &mut Ui, kind: DistanceKind, value: &str) {
    let ([name, tip], (hue, ..)) = (distance_words(kind), distance_look(kind));
    let colour = hue.colour(ui.visuals());
    let font = TextStyle::Body.resolve(ui.style());
    let galley = ui.painter().layout_no_wrap(format!("{name} {value}"), font, colour);
    let (rect, response) = ui.allocate_exact_size(galley.size() + vec2(SAMPLE + 4.0, 0.0), Sense::hover());
    ui.painter().galley(pos2(rect.max.x - galley.size().x, rect.min.y), galley, colour);
    let stroke = Stroke::new(if kind == DistanceKind::Measured { 1.2 } else { 2.0 }, colour);
    let pieces: &[[f32; 2]] =
        if matches!(kind, DistanceKind::Seen(_)) { &[[0.0, 0.4], [0.6, 1.0]] } else { &[[0.0, 1.0]] };
    for piece in pieces {
        let ends = piece.map(|share| pos2(rect.min.x + share * SAMPLE, rect.center().y));
        ui.painter().line_segment(ends, stroke);
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, format!("{tip}: {value}")));
    response.on_hover_text(tip);
}
