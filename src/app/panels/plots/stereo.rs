//! The tab "Stereo": how far off two eyes take the selected point to be, beside how far each sees it and where it is
//! measured.

use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, RichText, Sense, Stroke, TextStyle, Ui, Visuals, WidgetInfo, pos2, vec2};
use egui_plot::LineStyle;

use super::trace::Trace;
use crate::app::curves::{Curves, DistanceKind, Quantity, StereoView, stereo_view};
use crate::app::observer::Eye;
use crate::app::state::State;
use crate::app::theme;
use crate::app::widgets::named_text;
use crate::figures;

/// Length of a piece of line in the caption, points.
const SAMPLE: f32 = 16.0;

/// What is drawn of the selected point.
pub(super) fn traces<'a>(ui: &Ui, state: &State, curves: &'a Curves, quantity: Quantity) -> Vec<Trace<'a>> {
    let visuals = ui.visuals();
    if quantity == Quantity::LogGain {
        let colour = theme::stereo_colour(visuals);
        let trace = |exact_beside| {
            move |points: &'a Vec<_>| {
                Trace::of_model("Stereo gain".to_owned(), points, colour, state, exact_beside)
            }
        };
        let [exact, shown] = [curves.exact(quantity), curves.shown(quantity)].map(<[_]>::iter);
        return exact.map(trace(true)).chain(shown.map(trace(false))).collect();
    }
    let trace = |(kind, points): (DistanceKind, &'a Vec<_>)| Trace {
        name: words(kind)[1].to_owned(),
        points,
        colour: colour(kind, visuals),
        style: style(kind),
        wide: kind != DistanceKind::Measured,
        dot: true,
    };
    // Two eyes on top.
    curves
        .shown(quantity)
        .iter()
        .enumerate()
        .map(|(number, points)| trace((DistanceKind::of_curve(number), points)))
        .collect()
}

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

/// The name of a distance, short and long.
const fn words(kind: DistanceKind) -> [&'static str; 2] {
    match kind {
        DistanceKind::Stereo => ["two eyes", "Where two eyes take it to be"],
        DistanceKind::Seen(0) => ["left", "Where the left eye sees it"],
        DistanceKind::Seen(_) => ["right", "Where the right eye sees it"],
        DistanceKind::Measured => ["measured", "Where it is measured now"],
    }
}

fn colour(kind: DistanceKind, visuals: &Visuals) -> Color32 {
    match kind {
        DistanceKind::Stereo => theme::stereo_colour(visuals),
        DistanceKind::Seen(eye) => theme::eye_colour(Eye::BOTH[eye], visuals),
        DistanceKind::Measured => theme::measured_colour(visuals),
    }
}

fn style(kind: DistanceKind) -> LineStyle {
    if matches!(kind, DistanceKind::Seen(_)) { LineStyle::dashed_dense() } else { LineStyle::Solid }
}

/// A piece of the line that stands for `kind`, its name and its `value`: in one piece wherever the row breaks.
fn entry(ui: &mut Ui, kind: DistanceKind, value: &str) {
    let ([name, tip], colour) = (words(kind), colour(kind, ui.visuals()));
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
