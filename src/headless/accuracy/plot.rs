//! Cost against error as an SVG drawing: one mark per method, labelled, on logarithmic axes.

use std::io::Write;

use super::report::Report;
use crate::accuracy::{RESOLUTION_PX, Spread};

/// Colours that colour-blind eyes tell apart (M. Okabe and K. Ito, *Color universal design*, 2008).
const COLOURS: [&str; 7] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"];
const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 460.0;
/// Height of the axes' upper and lower ends.
const TOP: f64 = 60.0;
const BOTTOM: f64 = 380.0;
const PANEL_WIDTH: f64 = 370.0;

/// A method in a panel.
struct Mark {
    label: String,
    cost: f64,
    /// Median and 99 %; `None` where there is no error to speak of.
    error: Option<[f64; 2]>,
}

/// One pair of axes.
struct Panel {
    title: &'static str,
    cost: &'static str,
    error: &'static str,
    left: f64,
    /// Errors below this lie on the axis.
    floor: f64,
    marks: Vec<Mark>,
}

/// Draws `report`.
///
/// # Errors
///
/// Those of `out`.
pub fn write(report: &Report, out: &mut dyn Write) -> anyhow::Result<()> {
    writeln!(
        out,
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12" fill="#222">"##
    )?;
    writeln!(out, r##"<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>"##)?;
    for panel in [pictures(report), points(report)] {
        panel.write(out)?;
    }
    let device = report.setting.device.as_deref().unwrap_or("no graphics adapter");
    let [width, height] = report.setting.size_px;
    let caption = format!(
        "{}, {width}x{height} per eye, {device}, {} CPU threads. Dot: 99 % of the worst view; line: down to its median. Triangle: below what is resolved, or the truth itself.",
        report.setting.scene, report.setting.threads
    );
    writeln!(out, r##"<text x="70" y="{}" fill="#666">{}</text>"##, HEIGHT - 14.0, escaped(&caption))?;
    Ok(writeln!(out, "</svg>")?)
}

fn pictures(report: &Report) -> Panel {
    let marks = report.renderers.iter().map(|renderer| Mark {
        label: renderer.method.clone(),
        cost: renderer.frame_ms,
        error: renderer.worst_view.silhouettes_px.map(ends),
    });
    Panel {
        title: "Pictures",
        cost: "ms per eye",
        error: "displacement of silhouettes, pixels",
        left: 70.0,
        floor: RESOLUTION_PX,
        marks: marks.collect(),
    }
}

fn points(report: &Report) -> Panel {
    let formulas = report.formulas.iter().map(|formula| Mark {
        label: formula.formula.clone(),
        cost: formula.point_ns,
        error: formula.line_of_sight_arcseconds.filter(|_| !formula.is_reference).map(ends),
    });
    let published = &report.published;
    let sights = published.views.iter().map(|row| row.line_of_sight_arcseconds);
    let published = Mark {
        label: "published model".to_owned(),
        cost: published.published_ns,
        error: sights.fold(None, super::report::larger).map(ends),
    };
    Panel {
        title: "Points",
        cost: "ns per point, one thread",
        error: "error of the line of sight, arcseconds",
        left: 550.0,
        floor: 1e-10,
        marks: formulas.chain([published]).collect(),
    }
}

fn ends(spread: Spread) -> [f64; 2] {
    [spread.median, spread.p99]
}

impl Panel {
    fn write(&self, out: &mut dyn Write) -> anyhow::Result<()> {
        let costs =
            Axis::around(self.marks.iter().map(|mark| mark.cost), [self.left, self.left + PANEL_WIDTH]);
        let errors = self.marks.iter().filter_map(|mark| Some(mark.error?[1])).chain([self.floor]);
        let errors = Axis::around(errors, [BOTTOM, TOP]);
        writeln!(
            out,
            r##"<text x="{}" y="32" font-size="16" font-weight="bold">{}</text>"##,
            self.left, self.title
        )?;
        self.write_axes(&costs, &errors, out)?;
        for (mark, colour) in self.marks.iter().zip(COLOURS.iter().cycle()) {
            self.write_mark(mark, colour, &costs, &errors, out)?;
        }
        Ok(())
    }

    fn write_axes(&self, costs: &Axis, errors: &Axis, out: &mut dyn Write) -> anyhow::Result<()> {
        let (left, right) = (self.left, self.left + PANEL_WIDTH);
        for decade in errors.decades() {
            let y = errors.place(10_f64.powi(decade));
            writeln!(out, r##"<path d="M{left} {y:.1}H{right}" stroke="#ddd"/>"##)?;
            if (decade - errors.low) % errors.label_step() == 0 {
                writeln!(
                    out,
                    r##"<text x="{:.1}" y="{:.1}" text-anchor="end">{}</text>"##,
                    left - 6.0,
                    y + 4.0,
                    power_of_ten(decade)
                )?;
            }
        }
        for decade in costs.decades() {
            let x = costs.place(10_f64.powi(decade));
            writeln!(out, r##"<path d="M{x:.1} {TOP}V{BOTTOM}" stroke="#ddd"/>"##)?;
            writeln!(
                out,
                r##"<text x="{x:.1}" y="{:.1}" text-anchor="middle">{}</text>"##,
                BOTTOM + 18.0,
                power_of_ten(decade)
            )?;
        }
        writeln!(out, r##"<path d="M{left} {TOP}V{BOTTOM}H{right}" stroke="#444" fill="none"/>"##)?;
        writeln!(
            out,
            r##"<text x="{}" y="{}" text-anchor="middle">{}</text>"##,
            left + PANEL_WIDTH / 2.0,
            BOTTOM + 38.0,
            self.cost
        )?;
        Ok(writeln!(out, r##"<text x="{left}" y="50" fill="#444">{}</text>"##, self.error)?)
    }

    fn write_mark(
        &self,
        mark: &Mark,
        colour: &str,
        costs: &Axis,
        errors: &Axis,
        out: &mut dyn Write,
    ) -> anyhow::Result<()> {
        let x = costs.place(mark.cost);
        let [median, p99] = mark.error.unwrap_or_default().map(|error| errors.place(error.max(self.floor)));
        if mark.error.is_some_and(|[_, p99]| p99 > self.floor) {
            writeln!(
                out,
                r##"<path d="M{x:.1} {p99:.1}V{median:.1}" stroke="{colour}" stroke-width="2"/>"##
            )?;
            writeln!(out, r##"<circle cx="{x:.1}" cy="{p99:.1}" r="5" fill="{colour}"/>"##)?;
        } else {
            writeln!(out, r##"<path d="M{x:.1} {p99:.1}l-6 -10h12z" fill="{colour}"/>"##)?;
        }
        // Away from the panel's nearer edge.
        let on_the_left = x < self.left + 0.6 * PANEL_WIDTH;
        let (anchor, x) = if on_the_left { ("start", x + 9.0) } else { ("end", x - 9.0) };
        Ok(writeln!(
            out,
            r##"<text x="{x:.1}" y="{:.1}" text-anchor="{anchor}" stroke="#fff" stroke-width="3" paint-order="stroke">{}</text>"##,
            p99 - 4.0,
            escaped(&mark.label)
        )?)
    }
}

/// A logarithmic axis of whole decades.
struct Axis {
    low: i32,
    high: i32,
    ends: [f64; 2],
}

impl Axis {
    fn around(values: impl Iterator<Item = f64>, ends: [f64; 2]) -> Self {
        let decades: Vec<_> = values.filter(|value| *value > 0.0).map(f64::log10).collect();
        let low = decades.iter().copied().fold(f64::INFINITY, f64::min);
        let high = decades.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if !(low.is_finite() && high.is_finite()) {
            return Self { low: 0, high: 1, ends };
        }
        let low = low.floor() as i32;
        Self { low, high: (high.ceil() as i32).max(low + 1), ends }
    }

    fn place(&self, value: f64) -> f64 {
        let span = f64::from(self.high - self.low);
        // A cost too small for the clock counts as the least shown.
        let along = ((value.log10() - f64::from(self.low)) / span).clamp(0.0, 1.0);
        self.ends[0] + along * (self.ends[1] - self.ends[0])
    }

    fn decades(&self) -> impl Iterator<Item = i32> {
        self.low..=self.high
    }

    /// Every so many decades there is room for a number.
    fn label_step(&self) -> i32 {
        1 + (self.high - self.low) / 8
    }
}

fn power_of_ten(decade: i32) -> String {
    match decade {
        -2..=3 => 10_f64.powi(decade).to_string(),
        _ => format!(r#"10<tspan dy="-5" font-size="9">{decade}</tspan>"#),
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
