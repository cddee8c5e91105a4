//! Axes: lines at round numbers, the numbers at the edges, and what they are of.

use eframe::egui::{Align2, Painter, Pos2, Stroke, TextStyle, Ui, pos2, vec2};

use super::canvas;
use super::labels::LabelPlaces;
use crate::app::widgets::theme;
use crate::map::{Chart, ticks};
use crate::number_text;
use crate::units::Unit;

/// Least distance between two lines, points.
const SPACING: f64 = 42.0;

/// The quantity along an axis.
#[derive(Debug, Clone, Copy)]
pub struct AxisQuantity<'a> {
    /// Symbol of the quantity.
    pub symbol: &'a str,
    /// Unit of the quantity.
    pub unit: Unit,
    /// Whether symbol and numbers are written; else there are lines alone.
    pub is_written: bool,
}

/// Draws those of `chart`: the first along the lower edge, the second along the left one. No label will cover them.
pub fn paint(
    ui: &Ui,
    painter: &Painter,
    chart: &Chart,
    [across, up]: [AxisQuantity<'_>; 2],
    labels: &mut LabelPlaces,
) {
    let room = canvas::rect(chart);
    let line = Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.16));
    let zero = Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.4));
    let name = |axis: AxisQuantity<'_>| axis.unit.label(axis.symbol);
    let mut write = |axis: AxisQuantity<'_>, place: Pos2, align: Align2, text: &str| {
        if axis.is_written {
            write(ui, painter, place, align, text, labels);
        }
    };
    write(across, room.max - vec2(4.0, 2.0), Align2::RIGHT_BOTTOM, &name(across));
    write(up, room.min + vec2(4.0, 2.0), Align2::LEFT_TOP, &name(up));
    let [xs, ys] = chart.range();
    let [center_x, center_y] = chart.center;
    // Larger numbers need more room.
    let scale = chart.scale / f64::from(theme::text_scale(ui.style()));
    for (value, text) in numbers(xs, across.unit, scale) {
        let x = canvas::place(chart, [value, center_y]).x;
        painter.vline(x, room.y_range(), if value == 0.0 { zero } else { line });
        write(across, pos2(x, room.max.y - 2.0), Align2::CENTER_BOTTOM, &text);
    }
    for (value, text) in numbers(ys, up.unit, scale) {
        let y = canvas::place(chart, [center_x, value]).y;
        painter.hline(room.x_range(), y, if value == 0.0 { zero } else { line });
        write(up, pos2(room.min.x + 4.0, y), Align2::LEFT_CENTER, &text);
    }
}

/// Round numbers of the `unit` in a range of the world, and how they are written.
fn numbers(range: [f64; 2], unit: Unit, scale: f64) -> Vec<(f64, String)> {
    let (shown, decimals) = ticks(range.map(|value| unit.shown(value)), unit.shown(SPACING / scale));
    shown
        .into_iter()
        .map(|shown| (unit.in_scene(shown), number_text::fixed(shown, decimals).replace(".00e", "e")))
        .collect()
}

fn write(ui: &Ui, painter: &Painter, place: Pos2, align: Align2, text: &str, labels: &mut LabelPlaces) {
    let colour = ui.visuals().weak_text_color();
    let galley = painter.layout_no_wrap(text.to_owned(), TextStyle::Small.resolve(ui.style()), colour);
    let rect = align.anchor_size(place, galley.size());
    if labels.is_free(rect) {
        painter.galley(rect.min, galley, colour);
        labels.keep_free(rect);
    }
}
