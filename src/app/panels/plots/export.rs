//! The shown tab of plots as files: a drawing, and a table.

use csv::ByteRecord;
use eframe::egui::Visuals;

use super::axes::{axis_label, column_label, in_unit, time_label};
use super::chart::TimePlot;
use super::drawn::css;
use super::plotted::Plotted;
use super::traces::chart;
use super::{accuracy, fit, light};
use crate::app::state::State;
use crate::app::state::plots::curves::{Curve, Whose};
use crate::app::state::plots::look::quantities;
use crate::estimate::samples::EyeColumns;
use crate::files::csv_out::CsvWriter;
use crate::plot::{self, Line, LineStroke, Panel};
use crate::quantity::Quantity;
use crate::settings::PlotTab;

/// Draws the plots of the shown tab as SVG, beside each other: the same curves with their names over the same
/// axes, in the colours of a light window, and T and T0. The Accuracy tab is a table: see [`csv`].
#[must_use]
pub fn svg(state: &State, plotted: Plotted<'_>) -> String {
    let panels: Vec<Panel> = match state.document.settings.plots.plot {
        PlotTab::Light => vec![light::panel(state)],
        PlotTab::Fit => fit::panels(state, plotted.fitting),
        _ => charts(state, plotted).map(|chart| panel(state, &chart)).collect(),
    };
    plot::svg(&panels)
}

/// Writes the plots of the shown tab as CSV in the units of the plots, which the names of the columns
/// contain: T, and a column for each curve. Where disparities are plotted, the last columns are those that
/// `gamow fit` and *Own data* read. A row stands at every T at which any of the curves is sampled, densely
/// where they bend; every value there is computed, none interpolated. A cell is empty where a curve is not.
/// Of the Light tab it is the spectra, of the Accuracy tab the table, of the Fit tab the samples.
#[must_use]
pub fn csv(state: &State, plotted: Plotted<'_>) -> String {
    match state.document.settings.plots.plot {
        PlotTab::Accuracy => plotted.examination.map_or_else(String::new, accuracy::csv),
        PlotTab::Light => light::csv(state),
        PlotTab::Fit => fit::csv(state, plotted.fitting),
        _ => table(state, &charts(state, plotted).collect::<Vec<_>>()),
    }
}

/// A drawing is higher than any number of ticks takes.
const HEIGHT: f32 = 300.0;

fn charts<'a>(state: &'a State, plotted: Plotted<'a>) -> impl Iterator<Item = TimePlot<'a>> {
    quantities(&state.document.settings.plots)
        .iter()
        .map(move |&quantity| chart(state, plotted.curves, quantity, HEIGHT))
}

fn panel(state: &State, chart: &TimePlot<'_>) -> Panel {
    let visuals = Visuals::light();
    let in_chart = |point: &egui_plot::PlotPoint| [chart.time_unit.shown(point.x), chart.shown(point.y)];
    let lines = chart.traces.iter().map(|trace| Line {
        name: trace.name.clone(),
        colour: css(trace.colour(&visuals)).into(),
        stroke: LineStroke::Line(trace.dash),
        pieces: trace.pieces.iter().map(|piece| piece.iter().map(in_chart).collect()).collect(),
    });
    let labels = [time_label(chart.clock, chart.time_unit), axis_label(chart.quantity, &chart.measures)];
    let point = state.name_of(state.document.points.selected());
    let title = if chart.quantity.is_disparity() { "" } else { &point };
    let shown = |time| chart.time_unit.shown(time);
    let now = (shown(chart.now), chart.clock.symbol.to_owned());
    let cursors =
        ["A", "B"].into_iter().zip(&chart.cursors).map(|(name, time)| (shown(*time), name.to_owned()));
    let seen = chart.equidistant.map(|(time, words)| (shown(time), format!("T₀, {words}")));
    let values = chart.value_range().map(|value| chart.ruler().counted(value));
    Panel {
        ranges: [Some(chart.range.map(shown)), Some(values)],
        marks: seen.into_iter().chain(cursors).chain([now]).collect(),
        is_logarithmic: [false, chart.quantity.row().is_logarithmic],
        ..Panel::new(title, labels, lines.collect())
    }
}

/// The columns that `gamow fit` and *Own data* read, of the selected point as the views show it: their names
/// after T, and the numbers of a row, in the scene's own units and radians.
fn readable(state: &State) -> (Vec<&'static str>, impl Fn(f64) -> Vec<f64>) {
    let seen = state.seen_point(state.document.points.selected());
    let keeps_head = seen.ride.is_straight();
    let columns = if keeps_head { EyeColumns::for_eyes(seen.baseline) } else { EyeColumns::Head };
    let names = columns.names().iter().copied().chain(["dphi", "dtheta"]).collect();
    let numbers = move |time| {
        let angles = [Quantity::DeltaPhi, Quantity::DeltaTheta].map(|quantity| {
            let curve = Curve { quantity, whose: Whose::Both };
            seen.value(seen.model, curve, time).unwrap_or(f64::NAN)
        });
        let eyes = columns.numbers(seen.baseline_at(time));
        [&[time], eyes.as_slice(), &angles].concat()
    };
    (names, numbers)
}

fn table(state: &State, charts: &[TimePlot<'_>]) -> String {
    let traces = charts.iter().flat_map(|chart| &chart.traces);
    let mut times: Vec<f64> = traces.flat_map(|trace| trace.pieces).flatten().map(|point| point.x).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let Some(first) = charts.first() else { return String::new() };
    let mut head = ByteRecord::new();
    let is_readable =
        charts.iter().any(|chart| matches!(chart.quantity, Quantity::DeltaPhi | Quantity::DeltaTheta));
    let readable = is_readable.then(|| readable(state));
    head.push_field(in_unit(first.clock.symbol, first.time_unit).as_bytes());
    for chart in charts {
        for trace in &chart.traces {
            head.push_field(
                format!("{}: {}", column_label(chart.quantity, &chart.measures), trace.name).as_bytes(),
            );
        }
    }
    for name in readable.iter().flat_map(|(names, _)| ["T"].iter().chain(names)) {
        head.push_field(name.as_bytes());
    }
    let mut rows = CsvWriter::new(Vec::new());
    // Into memory: writing does not fail.
    let _ = rows.write(&mut head, &[]);
    for time in times {
        let values = charts.iter().flat_map(|chart| {
            let shown = |plotted| chart.shown(plotted);
            chart.traces.iter().map(move |trace| trace.source.value(time).map_or(f64::NAN, shown))
        });
        let readable = readable.iter().flat_map(|(_, numbers)| numbers(time));
        let numbers: Vec<f64> =
            [first.time_unit.shown(time)].into_iter().chain(values).chain(readable).collect();
        let _ = rows.write(&mut ByteRecord::new(), &numbers);
    }
    rows.into_text()
}
