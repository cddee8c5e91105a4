//! The plot of a curve that is predicted, on a page.

use super::plan::CurveAnswer;
use crate::plot::{self, Line, Panel};
use crate::units::{Measures, Unit};

/// Width and height, pixels.
const SIZE: [f64; 2] = [640.0, 300.0];

/// The plot that `curve` is drawn into, over `times` (first and last T, in the scene's unit), which are shown
/// in `unit`; with these lines of T and value.
#[must_use]
pub fn svg(curve: &CurveAnswer, times: [f64; 2], unit: Unit, mut lines: Vec<Line>) -> String {
    for [time, _] in lines.iter_mut().flat_map(|line| &mut line.pieces).flatten() {
        *time = unit.shown(*time);
    }
    let label = curve.quantity.unit(&Measures::OWN).label(curve.quantity.row().symbol);
    let [width, height] = SIZE;
    let panel = Panel {
        ranges: [Some(times.map(|time| unit.shown(time))), Some(curve.range)],
        width,
        height,
        ..Panel::new("", [unit.label("T"), label], lines)
    };
    plot::svg(&[panel])
}
