//! Cost against error as an SVG drawing: one mark per method, from the 99 % of its worst view to the median there.

use super::report::AccuracyReport;
use crate::accuracy::{RESOLUTION_PX, Spread};
use crate::plot::{COLOURS, Line, LineStroke, Panel, svg};

/// Error at which methods without error are drawn among formulas, arcseconds.
const LEAST_ARCSECONDS: f64 = 1e-10;
/// Costs below the clock's resolution are drawn here.
const LEAST_COST: f64 = 1e-3;

/// The drawing of `report`.
#[must_use]
pub fn drawing(report: &AccuracyReport) -> String {
    svg(&[pictures(report), points(report)])
}

fn pictures(report: &AccuracyReport) -> Panel {
    let setting = &report.setting;
    let [width, height] = setting.size_px;
    let device = setting.device.as_deref().unwrap_or("no graphics adapter");
    let marks = report.renderers.iter().zip(COLOURS).map(|(renderer, colour)| {
        mark(&renderer.method, colour, renderer.frame_ms, renderer.worst_view.outlines_px, RESOLUTION_PX)
    });
    let title = format!("Pictures, {width}x{height}: {device}");
    logarithmic(title, ["ms per eye", "displacement of outlines, pixels"], marks.collect())
}

fn points(report: &AccuracyReport) -> Panel {
    let formulas = report.formulas.iter().map(|formula| {
        let error = formula.line_of_sight_arcseconds.filter(|_| !formula.is_reference);
        (formula.formula.as_str(), formula.point_ns, error)
    });
    let published = &report.published;
    let sights = published.views.iter().filter_map(|row| row.line_of_sight_arcseconds);
    let published = ("published model", published.published_ns, sights.reduce(Spread::worse));
    let marks = formulas
        .chain([published])
        .zip(COLOURS)
        .map(|((name, cost, error), colour)| mark(name, colour, cost, error, LEAST_ARCSECONDS));
    let labels = ["ns per point", "error of the line of sight, arcseconds"];
    logarithmic("Points, one thread".to_owned(), labels, marks.collect())
}

fn logarithmic(title: String, labels: [&'static str; 2], lines: Vec<Line>) -> Panel {
    Panel { logarithmic: [true; 2], width: 520.0, ..Panel::new(title, labels, lines) }
}

/// Returns a mark. Errors below `least` are drawn there, with a remark.
fn mark(name: &str, colour: &'static str, cost: f64, error: Option<Spread>, least: f64) -> Line {
    let cost = cost.max(LEAST_COST);
    let note = match error {
        None => " (truth)",
        Some(spread) if spread.p99 <= least => " (not resolved)",
        Some(_) => "",
    };
    let ends = error.map_or([0.0; 2], |spread| [spread.p99, spread.median]);
    let points = ends.map(|error| [cost, error.max(least)]).to_vec();
    Line::solid(format!("{name}{note}"), colour, points).with(LineStroke::Mark)
}
