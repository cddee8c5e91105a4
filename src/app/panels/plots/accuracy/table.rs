//! The Accuracy tab's table: a row for each way to draw the present views.

use csv::ByteRecord;
use eframe::egui::{Grid, RichText, Ui};
use relativity_render::Method;

use crate::accuracy::{RESOLUTION_PX, Spread, method_name};
use crate::app::views::examination::{Examination, ExaminedMethod};
use crate::app::widgets::named_text;
use crate::files::csv_out::CsvWriter;
use crate::number_text;
use crate::settings::QualitySettings;

const HEADS: [(&str, &str); 6] = [
    ("", "Click a renderer to choose it."),
    ("ms", "Time to draw both eyes' pictures on this machine, milliseconds."),
    (
        "outlines / px",
        "How far outlines are drawn from where the reference has them: 99 % of the places are better.",
    ),
    (
        "direction / ″",
        "Between where a point is drawn and where it is seen, arcseconds: 99 % of the pixels are better.",
    ),
    ("D", "Relative error of the Doppler factor: 99 % of the pixels are better."),
    ("other body", "Share of the covered pixels that show another body than the reference does."),
];

/// Shows it; clicking a renderer chooses it.
pub fn show(ui: &mut Ui, examination: &Examination, chosen: Method, quality: &mut QualitySettings) {
    Grid::new("accuracy").num_columns(HEADS.len()).spacing([14.0, 2.0]).show(ui, |ui| {
        for (head, tip) in HEADS {
            ui.label(RichText::new(head).weak()).on_hover_text(tip);
        }
        ui.end_row();
        for row in examination.rows() {
            table_row(ui, &row, examination.better_than(&row), chosen, quality);
            ui.end_row();
        }
    });
}

fn table_row(
    ui: &mut Ui,
    row: &ExaminedMethod<'_>,
    better: Option<Method>,
    chosen: Method,
    quality: &mut QualitySettings,
) {
    let name = row.name();
    let is_chosen = chosen == row.method;
    let text = RichText::new(name);
    let text = if better.is_some() && !is_chosen { text.weak() } else { text };
    let label = ui.selectable_label(is_chosen, text);
    let lost = better.map_or_else(String::new, |better| {
        format!(" It costs more than {} and is less accurate.", method_name(better))
    });
    if label.on_hover_text(format!("Draws the views by {name}.{lost}")).clicked() {
        *quality = quality.with_method(row.method);
    }
    let figures = match row.figures {
        None => return drop(ui.label(RichText::new("…").weak())),
        Some(Err(problem)) => return drop(ui.label(problem)),
        Some(Ok(figures)) => figures,
    };
    let spreads = [
        (figures.outlines_px, RESOLUTION_PX),
        (figures.line_of_sight_arcseconds, 0.0),
        (figures.doppler, 0.0),
    ];
    let [outlines, directions, dopplers] = spreads.map(|(spread, resolution)| cell(spread, resolution));
    let [ms, wrong] = [(figures.frame_ms, 1), (100.0 * figures.wrong_share, 2)]
        .map(|(value, decimals)| number_text::fixed(value, decimals));
    let cells = [(ms, String::new()), outlines, directions, dopplers, (format!("{wrong} %"), String::new())];
    for ((text, tip), (head, _)) in cells.into_iter().zip(&HEADS[1..]) {
        let shown = RichText::new(&text);
        let shown = if row.is_current && better.is_none() { shown } else { shown.weak() };
        let label = named_text(ui, shown, format!("{name}, {head}: {text}"));
        if !tip.is_empty() {
            label.on_hover_text(tip);
        }
    }
}

/// Writes a spread's 99 %, and the rest of it. Nothing below the `resolution` was distinguished.
fn cell(spread: Option<Spread>, resolution: f64) -> (String, String) {
    let Some(Spread { median, p99, worst, count }) = spread else {
        return (number_text::NONE.to_owned(), String::new());
    };
    let [median, p99, worst] = [median, p99, worst].map(|error| {
        if error <= resolution && resolution > 0.0 {
            format!("< {}", small(resolution))
        } else {
            small(error)
        }
    });
    (p99.clone(), format!("median {median}, 99 % {p99}, worst {worst}, of {count}; the worse eye of the two"))
}

/// Two digits of an error.
fn small(error: f64) -> String {
    number_text::with_minus(&number_text::significant(error, 2))
}

/// The table as CSV: errors in full, and whether they were measured in the present views.
pub fn csv(examination: &Examination) -> String {
    let mut rows = CsvWriter::new(Vec::new());
    let heads = ["renderer", "time / ms", "outlines (99 %) / px", "direction (99 %) / arcseconds"];
    let heads =
        heads.into_iter().chain(["Doppler factor (99 %), relative", "other body, share", "is current"]);
    // Into memory: writing does not fail.
    let _ = rows.write(&mut heads.collect(), &[]);
    for row in examination.rows() {
        let Some(Ok(figures)) = row.figures else { continue };
        let p99 = |spread: Option<Spread>| spread.map_or(f64::NAN, |spread| spread.p99);
        let mut field = ByteRecord::from(vec![row.name()]);
        let errors = [figures.outlines_px, figures.line_of_sight_arcseconds, figures.doppler].map(p99);
        let [outlines, directions, dopplers] = errors;
        let current = if row.is_current { 1.0 } else { 0.0 };
        let numbers = [figures.frame_ms, outlines, directions, dopplers, figures.wrong_share, current];
        let _ = rows.write(&mut field, &numbers);
    }
    rows.into_text()
}
