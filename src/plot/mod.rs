//! Line plots as SVG: panels side by side, each with axes, linear or logarithmic, ticks and a legend.
//!
//! Colours are those of M. Okabe and K. Ito, *Color universal design* (2008), which colour-blind eyes tell
//! apart; lines differ by dashes too.

mod labels;
mod scale;

use std::fmt::Write as _;

use relativity_core::math;

use self::labels::{Label, Labels};
pub use self::scale::round_step;
use self::scale::{decades, linear_ticks, powers_of_ten, span, widened};

/// Black.
pub const BLACK: &str = "#000000";
/// Blue: the left eye.
pub const BLUE: &str = "#0072B2";
/// Vermilion: the right eye.
pub const VERMILION: &str = "#D55E00";
/// As many more as there may be marks in a panel.
pub const COLOURS: [&str; 7] = [BLUE, VERMILION, "#009E73", "#CC79A7", "#E69F00", "#56B4E9", BLACK];

/// Height of a panel unless it has another, pixels.
const HEIGHT: f64 = 380.0;
const MARGIN: Margin = Margin { left: 72.0, right: 16.0, top: 44.0, bottom: 52.0 };
/// Room for a row of the legend.
const LEGEND_ROW: f64 = 17.0;

struct Margin {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// Whole.
    Solid,
    /// Dashed.
    Dashed,
    /// Dots at the points instead of a line.
    Dots,
    /// A disc at the first point with a line to the last. Its name stands beside it, not in the legend.
    Mark,
}

/// A line through points; several pieces share one entry of the legend.
#[derive(Debug, Clone)]
pub struct Line {
    /// Entry in the legend.
    pub name: String,
    /// CSS colour.
    pub colour: &'static str,
    /// How it is drawn.
    pub stroke: Stroke,
    /// The pieces.
    pub pieces: Vec<Vec<[f64; 2]>>,
}

impl Line {
    /// A solid line in one piece.
    pub fn solid(name: impl Into<String>, colour: &'static str, points: Vec<[f64; 2]>) -> Self {
        Self::in_pieces(name, colour, vec![points])
    }

    /// A solid line in these pieces.
    pub fn in_pieces(name: impl Into<String>, colour: &'static str, pieces: Vec<Vec<[f64; 2]>>) -> Self {
        Self { name: name.into(), colour, stroke: Stroke::Solid, pieces }
    }

    /// The same line, drawn with `stroke`.
    #[must_use]
    pub fn with(self, stroke: Stroke) -> Self {
        Self { stroke, ..self }
    }
}

/// A pair of axes with lines.
#[derive(Debug, Clone)]
pub struct Panel {
    /// Above the axes.
    pub title: String,
    /// Below and beside them.
    pub labels: [&'static str; 2],
    /// The lines.
    pub lines: Vec<Line>,
    /// What the horizontal axis shows at least, besides the lines; in order that panels can be compared.
    pub at_least: Option<[f64; 2]>,
    /// A value on the horizontal axis to mark, and its name.
    pub mark: Option<(f64, &'static str)>,
    /// Whether a unit is as long on both axes.
    pub equal_scales: bool,
    /// Whether both axes are logarithmic; then all coordinates are above 0, and `equal_scales` has no say.
    pub logarithmic: bool,
    /// Width, pixels.
    pub width: f64,
    /// Height, pixels.
    pub height: f64,
}

impl Panel {
    /// Linear axes with scales of their own, 480 by 380 pixels.
    pub fn new(title: impl Into<String>, labels: [&'static str; 2], lines: Vec<Line>) -> Self {
        let title = title.into();
        let (width, height) = (480.0, HEIGHT);
        Self {
            title,
            labels,
            lines,
            at_least: None,
            mark: None,
            equal_scales: false,
            logarithmic: false,
            width,
            height,
        }
    }

    /// The lines that are named in the legend.
    fn legend(&self) -> impl Iterator<Item = &Line> {
        self.lines.iter().filter(|line| line.stroke != Stroke::Mark)
    }
}

/// The panels beside each other.
#[must_use]
pub fn svg(panels: &[Panel]) -> String {
    let width: f64 = panels.iter().map(|panel| panel.width).sum();
    let height = row_height(panels);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    let mut left = 0.0;
    for panel in panels {
        Axes::new(panel, left).draw(&mut svg);
        left += panel.width;
    }
    svg.push_str("</svg>\n");
    svg
}

/// Rows of panels below each other.
#[must_use]
pub fn svg_of_rows(rows: &[Vec<Panel>]) -> String {
    let width = |row: &Vec<Panel>| row.iter().map(|panel| panel.width).sum();
    let width: f64 = rows.iter().map(width).fold(0.0, f64::max);
    let height: f64 = rows.iter().map(|row| row_height(row)).sum();
    let mut all = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">\n"
    );
    let mut top = 0.0;
    for row in rows {
        all.push_str(&svg(row).replacen("<svg ", &format!("<svg y=\"{top}\" "), 1));
        top += row_height(row);
    }
    all.push_str("</svg>\n");
    all
}

fn row_height(panels: &[Panel]) -> f64 {
    panels.iter().map(|panel| panel.height).fold(0.0, f64::max)
}

/// Where a panel's coordinates lie in the picture.
struct Axes<'a> {
    panel: &'a Panel,
    /// Left, right, top and bottom of the box, pixels.
    frame: [f64; 4],
    x: [f64; 2],
    y: [f64; 2],
}

impl<'a> Axes<'a> {
    fn new(panel: &'a Panel, left: f64) -> Self {
        let legend = LEGEND_ROW * panel.legend().count() as f64;
        let frame = [
            left + MARGIN.left,
            left + panel.width - MARGIN.right,
            MARGIN.top + legend,
            panel.height - MARGIN.bottom,
        ];
        let points = || panel.lines.iter().flat_map(|line| &line.pieces).flatten();
        let [mut x, mut y] = [
            span(
                points().map(|point| point[0]).chain(panel.at_least.into_iter().flatten()),
                if panel.equal_scales { 0.02 } else { 0.0 },
            ),
            span(points().map(|point| point[1]), 0.06),
        ];
        if panel.logarithmic {
            [x, y] = [0, 1].map(|axis| decades(points().map(|point| point[axis])));
        } else if panel.equal_scales {
            let (width, height) = (frame[1] - frame[0], frame[3] - frame[2]);
            let per_pixel = ((x[1] - x[0]) / width).max((y[1] - y[0]) / height);
            x = widened(x, per_pixel * width);
            y = widened(y, per_pixel * height);
        }
        Self { panel, frame, x, y }
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [left, right, top, bottom] = self.frame;
        let scaled = |value: f64| if self.panel.logarithmic { math::log10(value) } else { value };
        let along = |value: f64, [low, high]: [f64; 2]| (scaled(value) - low) / (high - low);
        [left + along(x, self.x) * (right - left), bottom - along(y, self.y) * (bottom - top)]
    }

    fn draw(&self, svg: &mut String) {
        self.draw_axes(svg);
        let mut labels = Labels::new(self.frame);
        for line in &self.panel.lines {
            self.draw_line(line, &mut labels, svg);
        }
        let left = self.frame[0];
        for (row, line) in self.panel.legend().enumerate() {
            let y = MARGIN.top + LEGEND_ROW * (row as f64 + 0.4);
            let (end, text) = (left + 30.0, left + 36.0);
            let sample = [[left, y - 4.0], [end, y - 4.0]];
            draw_piece(line, &sample, svg);
            let _ = writeln!(svg, "<text x=\"{text}\" y=\"{y:.1}\">{}</text>", escaped(&line.name));
        }
    }

    fn draw_line(&self, line: &Line, labels: &mut Labels, svg: &mut String) {
        for piece in &line.pieces {
            let places: Vec<_> = piece.iter().map(|&point| self.place(point)).collect();
            draw_piece(line, &places, svg);
            if line.stroke == Stroke::Mark {
                let Label { anchor, x, y } = labels.place(places[0], &line.name);
                let name = escaped(&line.name);
                let _ =
                    writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{name}</text>");
            }
        }
    }

    /// Values to mark on an axis over `range`, and how they are written.
    fn ticks(&self, range: [f64; 2]) -> Vec<(f64, String)> {
        if self.panel.logarithmic { powers_of_ten(range) } else { linear_ticks(range) }
    }

    fn draw_axes(&self, svg: &mut String) {
        let [left, right, top, bottom] = self.frame;
        let [x_label, y_label] = self.panel.labels;
        let (middle, title) = (0.5 * (left + right), escaped(&self.panel.title));
        let (below, centre, beside) = (bottom + 40.0, 0.5 * (top + bottom), left - 56.0);
        let _ = writeln!(
            svg,
            "<text x=\"{middle}\" y=\"24\" text-anchor=\"middle\" font-size=\"15\">{title}</text>\n\
             <text x=\"{middle}\" y=\"{below}\" text-anchor=\"middle\">{x_label}</text>\n\
             <text transform=\"translate({beside} {centre}) rotate(-90)\" text-anchor=\"middle\">{y_label}</text>"
        );
        for (value, label) in self.ticks(self.x) {
            let [x, _] = self.place([value, 0.0]);
            let y = bottom + 17.0;
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {top}V{bottom}\" stroke=\"#e3e3e3\"/><text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{label}</text>"
            );
        }
        for (value, label) in self.ticks(self.y) {
            let [_, y] = self.place([0.0, value]);
            let (x, base) = (left - 6.0, y + 4.5);
            let _ = writeln!(
                svg,
                "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#e3e3e3\"/><text x=\"{x}\" y=\"{base:.1}\" text-anchor=\"end\">{label}</text>"
            );
        }
        if let Some((value, name)) = self.panel.mark {
            let [x, _] = self.place([value, 0.0]);
            let (text, y) = (x + 4.0, bottom - 6.0);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {top}V{bottom}\" stroke=\"#777\" stroke-dasharray=\"2 3\"/><text x=\"{text:.1}\" y=\"{y}\" fill=\"#555\">{name}</text>"
            );
        }
        let (width, height) = (right - left, bottom - top);
        let _ = writeln!(
            svg,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"none\" stroke=\"#444\"/>"
        );
    }
}

fn draw_piece(line: &Line, places: &[[f64; 2]], svg: &mut String) {
    let colour = line.colour;
    if line.stroke == Stroke::Dots {
        for [x, y] in places {
            let _ = writeln!(svg, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"1.5\" fill=\"{colour}\"/>");
        }
        return;
    }
    if let (Stroke::Mark, [[x, y], ..]) = (line.stroke, places) {
        let _ = writeln!(svg, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"5\" fill=\"{colour}\"/>");
    }
    let dashes = if line.stroke == Stroke::Dashed { " stroke-dasharray=\"7 4\"" } else { "" };
    let _ = write!(svg, "<polyline fill=\"none\" stroke-width=\"1.6\" stroke=\"{colour}\"{dashes} points=\"");
    for [x, y] in places {
        let _ = write!(svg, "{x:.2},{y:.2} ");
    }
    svg.push_str("\"/>\n");
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_inside_the_axes_are_drawn_inside_the_picture() {
        let points = vec![[-3.0, 1e-3], [7.0, 2e-3]];
        let panel = Panel {
            title: "a < b".to_owned(),
            labels: ["T", "angle"],
            lines: vec![Line::solid("line", BLUE, points)],
            at_least: None,
            mark: None,
            equal_scales: false,
            logarithmic: false,
            width: 500.0,
            height: 300.0,
        };
        let svg = svg(&[panel]);
        let line = svg.rsplit("points=\"").nth(1).expect("the line comes before its entry in the legend");
        let numbers: Vec<f64> =
            line.split(['"', ' ', ',']).take(4).map(|number| number.parse().expect("a number")).collect();
        assert_eq!(numbers[0], MARGIN.left);
        assert_eq!(numbers[2], 500.0 - MARGIN.right);
        assert!(numbers[1] > numbers[3], "larger values are higher up");
        assert!(svg.contains("a &lt; b"));
    }
}
