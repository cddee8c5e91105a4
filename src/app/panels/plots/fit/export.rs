//! The Fit tab as files: the samples, what fits them, and what is left over.

use csv::ByteRecord;

use crate::app::panels::plots::axes::{axis_label, time_label};
use crate::app::state::State;
use crate::app::state::fitting::{FitOutcome, Fitting};
use crate::estimate::samples::{EyeColumns, Samples};
use crate::files::csv_out::CsvWriter;
use crate::plot::{BLACK, BLUE, Dash, Line, LineStroke, Panel};
use crate::quantity::Quantity;

/// The columns of each curve.
const COLUMNS: [[&str; 3]; 2] =
    [["dphi", "dphi_fit", "dphi_residual"], ["dtheta", "dtheta_fit", "dtheta_residual"]];

/// A row for each sample, in the scene's own units, so that `gamow fit` reads it again: T, the eyes if they
/// are simulated ones, and of both curves the reading, the fit, and what is left over, in radians.
pub fn csv(state: &State, fitting: &Fitting) -> String {
    let Some(outcome) = fitting.shown() else { return String::new() };
    let baseline = state.document.settings.baseline();
    let columns = EyeColumns::for_eyes(baseline);
    let (names, eyes) = match outcome.key.samples {
        Samples::Simulated(_) => (columns.names(), columns.numbers(baseline)),
        Samples::Measured(..) => (&[] as &[_], Vec::new()),
    };
    let mut rows = CsvWriter::new(Vec::new());
    let names = ["T"].iter().chain(names).chain(COLUMNS.as_flattened());
    // Into memory: writing does not fail.
    let _ = rows.write(&mut names.copied().collect(), &[]);
    for (number, sample) in outcome.samples.iter().enumerate() {
        let fitted = outcome.fitted.as_ref().ok().and_then(|fitted| fitted.at_samples[number]);
        let of_curve = |curve: usize| {
            let reading = sample.readings()[curve].map_or(f64::NAN, |reading| reading.value);
            let fitted = fitted.map_or(f64::NAN, |angles| angles[curve]);
            [reading, fitted, reading - fitted]
        };
        let curves = [of_curve(0), of_curve(1)];
        let numbers = [&[sample.time], eyes.as_slice(), curves.as_flattened()].concat();
        let _ = rows.write(&mut ByteRecord::new(), &numbers);
    }
    rows.into_text()
}

/// A panel for each fitted curve, and one for what its fit leaves over.
pub fn panels(state: &State, fitting: &Fitting) -> Vec<Panel> {
    let Some(outcome) = fitting.shown() else { return Vec::new() };
    [Quantity::DeltaPhi, Quantity::DeltaTheta]
        .into_iter()
        .enumerate()
        .flat_map(|(curve, quantity)| of_curve(state, outcome, curve, quantity))
        .collect()
}

fn of_curve(state: &State, outcome: &FitOutcome, curve: usize, quantity: Quantity) -> Vec<Panel> {
    if outcome.data[curve].is_empty() {
        return Vec::new();
    }
    let unit = state.measures().time;
    let place = |point: &egui_plot::PlotPoint| [unit.shown(point.x), point.y];
    let dots = |name: &str, points: &[egui_plot::PlotPoint]| Line {
        stroke: LineStroke::Dots,
        ..Line::solid(name, GREY, points.iter().map(place).collect())
    };
    let label = axis_label(quantity, &state.measures());
    let panel = |what: &str, lines| {
        Panel::new("", [time_label(state.clock(), unit), format!("{label}{what}")], lines)
    };
    let mut lines = vec![dots("samples", &outcome.data[curve])];
    let Some(fitted) = outcome.fitted.as_ref().ok().and_then(|fitted| fitted.curves[curve].as_ref()) else {
        return vec![panel("", lines)];
    };
    lines.push(Line::solid("fit", BLUE, fitted.line.iter().map(place).collect()));
    if !fitted.band.is_empty() {
        let edge = |end: usize| {
            let points = fitted.line.iter().zip(&fitted.band);
            points.map(|(point, band)| [unit.shown(point.x), point.y + band[end]]).collect()
        };
        let band = Line::in_pieces("95 % band", BLUE, vec![edge(0), edge(1)]);
        lines.push(Line { stroke: LineStroke::Line(Dash::Dotted), ..band });
    }
    let ends = outcome.range.map(|time| [unit.shown(time), 0.0]).to_vec();
    let left = vec![dots("sample − fit", &fitted.residuals), Line::solid("0", BLACK, ends)];
    vec![panel("", lines), panel(", sample − fit", left)]
}

const GREY: &str = "#888888";
