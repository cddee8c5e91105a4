//! The legend of a plot: names beside a piece of each line, where they cover least of the curves. With
//! cursors set it says what the curves are there.

use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Color32, Galley, Id, Painter, Pos2, Rect, Sense, Stroke, TextStyle, Ui, Vec2, Visuals, WidgetInfo, pos2,
    vec2,
};
use egui_plot::PlotResponse;

use super::chart::{TimePlot, Trace};
use crate::app::state::plots::curves::PUBLISHED;
use crate::plot::{Area, Dash, LabelPlaces};

/// Length of a piece of line, and what is between it and its name; points.
pub(super) const SAMPLE: f32 = 18.0;
pub(super) const SPACE: f32 = 4.0;
/// Room around the names, and between columns of them; points.
const PADDING: f32 = 4.0;
/// A legend lower than this part of the plot is low enough.
const LOW: f32 = 0.45;
/// Opacity of its background.
const OPACITY: f32 = 0.8;

/// A line of the legend.
pub(super) struct LegendEntry {
    /// Line that the row names, and that line's width; `None` for a row about the cursors.
    line: Option<(Dash, f32)>,
    text: String,
    colour: Color32,
}

impl LegendEntry {
    /// The name of a line.
    pub fn of_line(dash: Dash, width: f32, name: &str, colour: Color32) -> Self {
        Self { line: Some((dash, width)), text: name.to_owned(), colour }
    }
}

/// The amount of detail in the legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Detail {
    Full,
    /// Points without what they are on.
    Short,
    /// Values at the cursors below each other.
    Stacked,
    /// Values of the selected point alone, and only names of the others.
    Selected,
}

/// Returns the rows in the legend of `chart`: none for a single curve, and for curves that the title names.
fn rows(ui: &Ui, chart: &TimePlot<'_>, detail: Detail) -> Vec<LegendEntry> {
    let visuals = ui.visuals();
    let plain = |text: &str| LegendEntry { line: None, text: text.to_owned(), colour: visuals.text_color() };
    let Some(cursors) = chart.cursors_text() else { return names(chart, detail, visuals) };
    let read = chart.traces.iter().flat_map(|trace| {
        let is_read =
            detail != Detail::Selected || (trace.wide && !trace.pale && trace.source.model != PUBLISHED);
        let text = chart.at_cursors(trace).unwrap_or_default();
        let colour = trace.colour(visuals);
        let name = named(&trace.name, detail);
        let head = |text: String| LegendEntry { line: Some(line(trace)), text, colour };
        match detail {
            Detail::Full | Detail::Short => vec![head(format!("{name}  {text}"))],
            Detail::Selected if !is_read => vec![head(name)],
            Detail::Stacked | Detail::Selected => {
                let parts = text.split(", ").map(|part| LegendEntry { colour, ..plain(part) });
                [head(name)].into_iter().chain(parts).collect()
            }
        }
    });
    let heads: Vec<LegendEntry> = match detail {
        Detail::Full | Detail::Short => vec![plain(&cursors)],
        Detail::Stacked => cursors.split(", ").map(plain).collect(),
        Detail::Selected => cursors.split(", ").last().map(plain).into_iter().collect(),
    };
    heads.into_iter().chain(read).collect()
}

/// The names of the curves that the title does not name: one point needs none.
fn names(chart: &TimePlot<'_>, detail: Detail, visuals: &Visuals) -> Vec<LegendEntry> {
    let is_published = |trace: &&Trace<'_>| trace.source.model == PUBLISHED;
    let is_of_points = chart.quantity.is_disparity();
    let several = is_of_points && chart.traces.iter().filter(|trace| !is_published(trace)).count() > 1;
    let named = chart.traces.iter().filter(|trace| trace.pale || (several && !is_published(trace)));
    let row = |trace: &Trace<'_>| LegendEntry {
        line: Some(line(trace)),
        text: self::named(&trace.name, detail),
        colour: trace.colour(visuals),
    };
    let published = chart.traces.iter().filter(|_| several).find(is_published).map(|trace| LegendEntry {
        line: Some(line(trace)),
        text: "published".to_owned(),
        colour: visuals.text_color(),
    });
    named.map(row).chain(published).collect()
}

/// Returns the dashes and the width of a line.
const fn line(trace: &Trace<'_>) -> (Dash, f32) {
    (trace.dash, trace.width())
}

/// A name, in short without what is in brackets.
fn named(name: &str, detail: Detail) -> String {
    let short = name.split_once(" (").and_then(|(first, rest)| Some((first, rest.split_once(')')?.1)));
    match short.filter(|_| detail != Detail::Full) {
        Some((first, rest)) => format!("{first}{rest}"),
        None => name.to_owned(),
    }
}

/// A block of rows in columns.
struct LegendBlock {
    rows: Vec<(LegendEntry, Arc<Galley>)>,
    columns: usize,
    cell: Vec2,
}

impl LegendBlock {
    fn new(ui: &Ui, rows: Vec<LegendEntry>, columns: usize) -> Self {
        let font = TextStyle::Small.resolve(ui.style());
        let laid = |row: LegendEntry| {
            let galley = ui.painter().layout_no_wrap(row.text.clone(), font.clone(), row.colour);
            (row, galley)
        };
        let rows: Vec<_> = rows.into_iter().map(laid).collect();
        let width = rows.iter().map(|(_, galley)| galley.size().x).fold(0.0, f32::max);
        let height = rows.iter().map(|(_, galley)| galley.size().y).fold(0.0, f32::max);
        Self { rows, columns, cell: vec2(SAMPLE + SPACE + width, height) }
    }

    fn size(&self) -> Vec2 {
        let columns = self.columns as f32;
        let lines = self.rows.len().div_ceil(self.columns) as f32;
        vec2(columns * self.cell.x + (columns - 1.0) * 2.0 * PADDING, lines * self.cell.y)
            + Vec2::splat(2.0 * PADDING)
    }

    fn paint(&self, painter: &Painter, area: Rect, background: Color32) {
        painter.rect_filled(area, 3.0, background);
        for (index, (row, galley)) in self.rows.iter().enumerate() {
            let (line, column) = ((index / self.columns) as f32, (index % self.columns) as f32);
            let place = area.min
                + Vec2::splat(PADDING)
                + vec2(column * (self.cell.x + 2.0 * PADDING), line * self.cell.y);
            let indent = if let Some((dash, width)) = row.line {
                let middle = place.y + 0.5 * self.cell.y;
                sample(painter, pos2(place.x, middle), SAMPLE, dash, Stroke::new(width, row.colour));
                SAMPLE + SPACE
            } else {
                0.0
            };
            painter.galley(place + vec2(indent, 0.0), Arc::clone(galley), row.colour);
        }
    }
}

/// Draws a piece of a line so long.
pub(super) fn sample(painter: &Painter, from: Pos2, length: f32, dash: Dash, stroke: Stroke) {
    let to = from + vec2(length, 0.0);
    match dash {
        Dash::Solid => {
            painter.line_segment([from, to], stroke);
        }
        Dash::Dashed(piece) => {
            // At least two dashes, whatever their length.
            let piece = f32::from(piece).min(0.4 * length);
            painter.extend(eframe::egui::Shape::dashed_line(&[from, to], stroke, piece, 0.5 * piece));
        }
        Dash::Dotted => {
            painter.extend(eframe::egui::Shape::dotted_line(
                &[from, to],
                stroke.color,
                4.0,
                stroke.width / 2.0,
            ));
        }
    }
}

/// Draws the legend of `chart` where it covers least.
pub(super) fn show(ui: &Ui, response: &PlotResponse<()>, chart: &TimePlot<'_>, labels: &mut LabelPlaces) {
    let Some(block) = block(ui, chart, response.transform.frame().size()) else { return };
    put(ui, response, chart.quantity.row().symbol, &block, labels);
}

/// Draws a legend of these `rows`, the names of the lines in the plot of `what`.
pub(super) fn show_rows(
    ui: &Ui,
    response: &PlotResponse<()>,
    what: &str,
    rows: Vec<LegendEntry>,
    labels: &mut LabelPlaces,
) {
    if !rows.is_empty() {
        put(ui, response, what, &LegendBlock::new(ui, rows, 1), labels);
    }
}

fn put(ui: &Ui, response: &PlotResponse<()>, what: &str, block: &LegendBlock, labels: &mut LabelPlaces) {
    let frame = *response.transform.frame();
    let places = Area::from(frame.shrink(3.0)).along_edges(block.size());
    let Some(place) = labels.take(places).map(Rect::from) else { return };
    let painter = ui.painter().with_clip_rect(frame);
    block.paint(&painter, place, ui.visuals().panel_fill.gamma_multiply(OPACITY));
    let words: Vec<&str> = block.rows.iter().map(|(row, _)| row.text.as_str()).collect();
    let name = format!("Legend of {what}: {}", words.join("; "));
    let id = Id::unique(("legend", ui.layer_id(), what));
    let shown = ui.interact(place, id, Sense::empty());
    shown.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
}

/// The first that is low enough, from the most telling to the shortest, else the lowest that fits at all.
fn block(ui: &Ui, chart: &TimePlot<'_>, room: Vec2) -> Option<LegendBlock> {
    let ways = [
        (Detail::Full, 1),
        (Detail::Full, 2),
        (Detail::Short, 1),
        (Detail::Short, 2),
        (Detail::Short, 3),
        (Detail::Stacked, 1),
        (Detail::Stacked, 2),
        (Detail::Selected, 1),
        (Detail::Selected, 2),
    ];
    let blocks = || {
        let blocks =
            ways.into_iter().map(|(detail, columns)| LegendBlock::new(ui, rows(ui, chart, detail), columns));
        blocks.filter(|block| !block.rows.is_empty() && block.size().x < room.x && block.size().y < room.y)
    };
    let lowest = || blocks().min_by(|a, b| a.size().y.total_cmp(&b.size().y));
    blocks().find(|block| block.size().y < LOW * room.y).or_else(lowest)
}
