//! Axes: lines at round numbers, the numbers at the edges, and what they are of.

use eframe::egui::{Align2, Painter, Pos2, Stroke, Ui, pos2, vec2};

use super::canvas;
use super::labels::MapLabels;
use crate::app::widgets::theme;
use crate::map::Chart;
use crate::plot::{Axis, Tick};
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

/// Draws those of `chart`: the first along the lower edge, the second along the left one. No label will cover
/// them.
pub fn paint(
    ui: &Ui,
    painter: &Painter,
    chart: &Chart,
    [across, up]: [AxisQuantity<'_>; 2],
    labels: &mut MapLabels,
) {
    let room = canvas::rect(chart);
    let line = Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.16));
    let zero = Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.4));
    let mut write = |axis: AxisQuantity<'_>, place: Pos2, align: Align2, text: &str| {
        if axis.is_written {
            labels.write_at((place, align), text, ui.visuals().weak_text_color());
        }
    };
    // Larger numbers need more room.
    let spacing = SPACING * f64::from(theme::text_scale(ui.style())) / chart.scale;
    let [xs, ys] = chart.range();
    let axis_of = |AxisQuantity { unit, .. }: AxisQuantity<'_>, range: [f64; 2]| {
        Axis::spaced(range.map(|value| unit.shown(value)), unit.shown(spacing))
    };
    let name = |quantity: AxisQuantity<'_>, axis: &Axis| axis.label(&quantity.unit.label(quantity.symbol));
    let [along, upwards] = [axis_of(across, xs), axis_of(up, ys)];
    write(across, room.max - vec2(4.0, 2.0), Align2::RIGHT_BOTTOM, &name(across, &along));
    write(up, room.min + vec2(4.0, 2.0), Align2::LEFT_TOP, &name(up, &upwards));
    let [centre_x, centre_y] = chart.centre;
    for Tick { place, text } in along.ticks {
        let x = canvas::place(chart, [across.unit.in_scene(place), centre_y]).x;
        painter.vline(x, room.y_range(), if place == 0.0 { zero } else { line });
        write(across, pos2(x, room.max.y - 2.0), Align2::CENTER_BOTTOM, &text);
    }
    for Tick { place, text } in upwards.ticks {
        let y = canvas::place(chart, [centre_x, up.unit.in_scene(place)]).y;
        painter.hline(room.x_range(), y, if place == 0.0 { zero } else { line });
        write(up, pos2(room.min.x + 4.0, y), Align2::LEFT_CENTER, &text);
    }
}
