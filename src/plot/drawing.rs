//! Panels as SVG: axes, linear or logarithmic, ticks, lines, and a legend above them.

use std::fmt::Write as _;

use super::axis::{Axis, Tick, at_least, ticks_along};
use super::panel::{Dash, Line, LineStroke, Panel};
use crate::markup::escaped;

const MARGIN: Margin = Margin { left: 72.0, right: 16.0, top: 44.0, bottom: 52.0 };
/// Room for a row of the legend.
const LEGEND_ROW: f64 = 17.0;

struct Margin {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
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
        PanelAxes::new(panel, left).draw(&mut svg);
        left += panel.width;
    }
    svg.push_str("</svg>\n");
    svg
}

/// Rows of panels below each other.
#[cfg(feature = "desktop")]
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

/// The axes of a panel, which place its coordinates in the picture.
struct PanelAxes<'a> {
    panel: &'a Panel,
    /// Left, right, top and bottom of the box, pixels.
    frame: [f64; 4],
    both: [Axis; 2],
}

/// Least distance of ticks from each other, along and across, pixels.
const TICK_SPACING: [f64; 2] = [75.0, 45.0];
/// Room beyond what the lines need along an axis and across, as a part of that.
const ROOM: [f64; 2] = [0.0, 0.06];

impl<'a> PanelAxes<'a> {
    fn new(panel: &'a Panel, left: f64) -> Self {
        let legend = LEGEND_ROW * panel.lines.len() as f64;
        let frame = [
            left + MARGIN.left,
            left + panel.width - MARGIN.right,
            MARGIN.top + legend,
            panel.height - MARGIN.bottom,
        ];
        let size = [frame[1] - frame[0], frame[3] - frame[2]];
        let room = if panel.equal_scales { [0.02, ROOM[1]] } else { ROOM };
        let needed = [0, 1].map(|axis| panel.needed(axis, room[axis]));
        let per_pixel = [0, 1].map(|axis| (needed[axis][1] - needed[axis][0]) / size[axis]);
        let both = [0, 1].map(|axis| {
            let wanted = ticks_along(size[axis], TICK_SPACING[axis]);
            if panel.equal_scales {
                let coarsest = per_pixel[0].max(per_pixel[1]);
                return Axis::within(false, at_least(needed[axis], coarsest * size[axis]), wanted);
            }
            match panel.ranges[axis] {
                Some(range) => Axis::within(panel.is_logarithmic[axis], range, wanted),
                None => Axis::fitted(panel.is_logarithmic[axis], needed[axis], wanted),
            }
        });
        Self { panel, frame, both }
    }

    fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let [left, right, top, bottom] = self.frame;
        let [x, y] = [0, 1].map(|axis| {
            let [low, high] = self.both[axis].range;
            (self.panel.along(axis, point[axis]) - low) / (high - low)
        });
        [left + x * (right - left), bottom - y * (bottom - top)]
    }

    fn draw(&self, svg: &mut String) {
        self.draw_axes(svg);
        let [left, right, top, bottom] = self.frame;
        // A range that was asked for may leave out a part of the lines.
        let is_clipped = self.panel.ranges.iter().any(Option::is_some);
        if is_clipped {
            let (width, height) = (right - left, bottom - top);
            // On a page with several plots, the same name is that of the same box.
            let id = format!("frame{left:.0}-{top:.0}-{width:.0}-{height:.0}");
            let _ = writeln!(
                svg,
                "<clipPath id=\"{id}\"><rect x=\"{left}\" y=\"{top}\" width=\"{width:.1}\" height=\"{height:.1}\"/></clipPath>\n\
                 <g clip-path=\"url(#{id})\">"
            );
        }
        for line in &self.panel.lines {
            for piece in &line.pieces {
                let places: Vec<_> = piece.iter().map(|&point| self.place(point)).collect();
                draw_piece(line, &places, svg);
            }
        }
        if is_clipped {
            svg.push_str("</g>\n");
        }
        for (row, line) in self.panel.lines.iter().enumerate() {
            let y = MARGIN.top + LEGEND_ROW * (row as f64 + 0.4);
            let (end, text) = (left + 30.0, left + 36.0);
            let sample = [[left, y - 4.0], [end, y - 4.0]];
            draw_piece(line, &sample, svg);
            let _ = writeln!(svg, "<text x=\"{text}\" y=\"{y:.1}\">{}</text>", escaped(&line.name));
        }
    }

    fn draw_axes(&self, svg: &mut String) {
        let [left, right, top, bottom] = self.frame;
        let label = |axis: usize| escaped(&self.both[axis].label(&self.panel.labels[axis]));
        let (x_label, y_label) = (label(0), label(1));
        let (middle, title) = (0.5 * (left + right), escaped(&self.panel.title));
        let (below, centre, beside) = (bottom + 40.0, 0.5 * (top + bottom), left - 56.0);
        let _ = writeln!(
            svg,
            "<text x=\"{middle}\" y=\"24\" text-anchor=\"middle\" font-size=\"15\">{title}</text>\n\
             <text x=\"{middle}\" y=\"{below}\" text-anchor=\"middle\">{x_label}</text>\n\
             <text transform=\"translate({beside} {centre}) rotate(-90)\" text-anchor=\"middle\">{y_label}</text>"
        );
        let [x_axis, y_axis] = &self.both;
        let along = |place: f64, axis: &Axis, from: f64, to: f64| {
            from + (place - axis.range[0]) / (axis.range[1] - axis.range[0]) * (to - from)
        };
        for Tick { place, text } in &x_axis.ticks {
            let (x, y) = (along(*place, x_axis, left, right), bottom + 17.0);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {top}V{bottom}\" stroke=\"#e3e3e3\"/><text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{text}</text>"
            );
        }
        for Tick { place, text } in &y_axis.ticks {
            let y = along(*place, y_axis, bottom, top);
            let (x, base) = (left - 6.0, y + 4.5);
            let _ = writeln!(
                svg,
                "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#e3e3e3\"/><text x=\"{x}\" y=\"{base:.1}\" text-anchor=\"end\">{text}</text>"
            );
        }
        for (row, (value, name)) in self.panel.marks.iter().enumerate() {
            let [x, _] = self.place([*value, 1.0]);
            if (left..=right).contains(&x) {
                self.draw_mark(x, name, row, svg);
            }
        }
        let (width, height) = (right - left, bottom - top);
        let _ = writeln!(
            svg,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"none\" stroke=\"#444\"/>"
        );
    }

    /// A dotted line at `x` with its `name` beside it, one above the other where there are several, on the
    /// side that has room.
    fn draw_mark(&self, x: f64, name: &str, row: usize, svg: &mut String) {
        let [left, right, top, bottom] = self.frame;
        let (text, anchor) = if 2.0 * x < left + right { (x + 4.0, "start") } else { (x - 4.0, "end") };
        let (y, name) = (bottom - 6.0 - LEGEND_ROW * row as f64, escaped(name));
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.1} {top}V{bottom}\" stroke=\"#777\" stroke-dasharray=\"2 3\"/><text x=\"{text:.1}\" y=\"{y}\" fill=\"#555\" text-anchor=\"{anchor}\">{name}</text>"
        );
    }
}

fn draw_piece(line: &Line, places: &[[f64; 2]], svg: &mut String) {
    let colour = &line.colour;
    if line.stroke == LineStroke::Dots {
        for [x, y] in places {
            let _ = writeln!(svg, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"1.5\" fill=\"{colour}\"/>");
        }
        return;
    }
    let dashes = match line.stroke {
        LineStroke::Line(Dash::Dashed(length)) => {
            format!(" stroke-dasharray=\"{length} {:.1}\"", 0.6 * f64::from(length))
        }
        LineStroke::Line(Dash::Dotted) => " stroke-dasharray=\"1.6 3\"".to_owned(),
        LineStroke::Line(Dash::Solid) | LineStroke::Dots => String::new(),
    };
    let _ = write!(svg, "<polyline fill=\"none\" stroke-width=\"1.6\" stroke=\"{colour}\"{dashes} points=\"");
    for [x, y] in places {
        let _ = write!(svg, "{x:.2},{y:.2} ");
    }
    svg.push_str("\"/>\n");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::panel::BLUE;

    #[test]
    fn points_inside_the_axes_are_drawn_inside_the_picture() {
        let points = vec![[-3.0, 1e-3], [7.0, 2e-3]];
        let panel = Panel {
            width: 500.0,
            ..Panel::new("a < b", ["T", "angle"], vec![Line::solid("line", BLUE, points)])
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
